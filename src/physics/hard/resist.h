/* SPDX-License-Identifier: BSD-3-Clause */
/* Resistance of a contact to rolling and to twisting, in a visit of its row (row.h). With the radius R of the contact and the
 * spin w of the second body relative to the first, the impulses roll (in the tangent plane) and twist give the second body
 * the moment R (roll + twist n) and the first one the opposite:
 *
 *   rolling   roll = hold - R w_t / soft, cut to |roll| <= roll_friction p
 *   twisting  twist = hold - R w_n / soft, cut to |twist| <= twist_friction p
 *
 * p is the impulse that presses the surfaces, soft = 1 / (stiffness x dt x duration); soft = 0 is a rigid row. Of spheres rolling and
 * sliding share the spins, twisting is alone. Geometry and mechanics alone: no lists, no threads, no ranks. */
#ifndef SCREE_HARD_RESIST_H
#define SCREE_HARD_RESIST_H

#include "physics/hard/arm.h"

/* Impulses (or forces) of rolling and twisting. */
struct hard_couple {
    double roll[3], twist;
};

struct hard_resist {
    double radius; /* effective radius of the surfaces */
    double roll_friction, twist_friction;
    double roll_soft, twist_soft; /* velocity over impulse; roll_soft < 0: that of the tangential row */
    struct hard_couple now, hold; /* of this step; at rest */
};

/* The moment of a couple on the second body. */
static inline void hard_resist_moment(const struct hard_resist *resist, const double normal[3],
                                      const struct hard_couple *couple, double moment[3]) {
    for (int d = 0; d < 3; d++)
        moment[d] = resist->radius * (couple->roll[d] + couple->twist * normal[d]);
}

/* Gives the second body a moment, and the first one the opposite. `arm`: NULL of spheres. */
static inline void hard_resist_apply(const struct hard_arm *arm, struct hard_body *a, struct hard_body *b,
                                     const double moment[3]) {
    double spin[2][3];
    for (int e = 0; e < 2; e++)
        hard_turned(arm ? arm->turn[e] : NULL, moment, spin[e]);
    for (int d = 0; d < 3; d++) {
        a->w[d] -= a->swing * spin[0][d];
        b->w[d] += b->swing * spin[1][d];
    }
}

/* Softness of the rows of a visit; 0: rigid. */
struct hard_softness {
    double slide, roll, twist;
};

#endif
