/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws of drag: the force on a grain over its superficial slip velocity w = U - porosity v, with Re = density d |w| /
 * viscosity and e the porosity (drag.h; all in form B, F = F_A / e, which is Delta p V / ((1 - e) L) of a bed):
 *
 *   stokes            K = 3 pi mu d
 *   schiller_naumann  K = 3 pi mu d (1 + 0.15 Re^0.687) up to Re = 1000, beyond with C = 0.44
 *                     (Schiller, Naumann, Z. VDI 77 (1935) 318)
 *   di_felice         K = pi/8 density d^2 C |w| e^-(x+1),  C = (0.63 + 4.8 / sqrt(Re))^2 (Dallavalle 1948),
 *                     x = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2 / 2)   (Di Felice, Int. J. Multiphase Flow 20 (1994) 153)
 *   gidaspow          up to e = 0.8: V (150 mu (1 - e) / (e^3 d^2) + 1.75 density |w| / (e^3 d))   (Ergun, Chem. Eng. Prog.
 *                     48 (1952) 89); beyond: that of schiller_naumann times e^-4.65 (Wen, Yu, Chem. Eng. Prog. Symp. Ser.
 *                     62 (1966) 100), as Gidaspow (Multiphase Flow and Fluidization, 1994) joins the two */
#ifndef SCREE_DRAG_DRAG_LAW_H
#define SCREE_DRAG_DRAG_LAW_H

#include <stdbool.h>

/* A grain in its fluid. */
struct drag_case {
    double density, viscosity; /* of the fluid */
    double diameter, speed;    /* speed: superficial slip */
    double porosity;           /* 0 ... 1; 1 where the law has none */
};

struct drag_law {
    const char *name, *summary;
    bool porous; /* the law has a porosity */
    /* K: force over slip, mass/time. Any thread. */
    double (*factor)(const struct drag_case *at);
};

/* The law of a number of enum drag_law_name (drag.h). */
const struct drag_law *drag_law_get(int law);

#endif
