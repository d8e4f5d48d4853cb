/* SPDX-License-Identifier: BSD-3-Clause */
/* A damper over sqrt(m* k) by the fit of Tsuji, Tanaka and Ishida (Powder Technol. 71 (1992) 239) for Hertz; the polynomial is
 * LAMMPS's. */
#ifndef SCREE_LAWS_DAMPING_TSUJI_H
#define SCREE_LAWS_DAMPING_TSUJI_H

#include "physics/grains/laws/law_part.h"
#define DAMPING_TSUJI_KEYS(KEY)
struct damping_tsuji_given {
    double none;
};

static inline double damping_tsuji_normal(const struct damping_tsuji_given *given,
                                          const struct law_damped *in) {
    (void)given;
    double e = in->restitution;
    return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

static inline double damping_tsuji_tangential(const struct law_damped *in, double c_n) {
    return in->tangential * c_n * sqrt(in->ratio);
}

static const struct law_damping_form damping_tsuji_form = {.base = LAW_BASE_ROOT, .restitution = true};

#endif
