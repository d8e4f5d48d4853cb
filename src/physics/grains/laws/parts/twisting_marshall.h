/* SPDX-License-Identifier: BSD-3-Clause */
/* Twisting resistance from the tangential spring and the contact radius (Marshall, J. Comput. Phys. 228 (2009) 1541; twisting marshall
 * of LAMMPS). */
#ifndef SCREE_LAWS_TWISTING_MARSHALL_H
#define SCREE_LAWS_TWISTING_MARSHALL_H

#include "physics/grains/laws/law_part.h"
#define TWISTING_MARSHALL_KEYS(KEY)
struct twisting_marshall_given {
    double none;
};

LAW_INLINE struct law_resistance twisting_marshall_resist(const struct twisting_marshall_given *given,
                                                          const struct law_touch *touch) {
    (void)given;
    double a = touch->grip->a;
    return (struct law_resistance){.stiffness = 0.5 * touch->grip->tangential * a * a,
                                   .damping = 0.5 * touch->c->c_t * touch->base * a * a,
                                   .limit = 2.0 / 3.0 * a * touch->c->friction};
}

static inline struct law_solved twisting_marshall_solved(const struct twisting_marshall_given *given) {
    (void)given;
    return (struct law_solved){.row = LAW_SOLVED_NONE};
}

#endif
