/* SPDX-License-Identifier: BSD-3-Clause */
/* Luding: hysteretic linear springs for plastic, adhesive grains (Granular Matter 10 (2008) 235). Loading along
 * k_n d, unloading and reloading along a steeper branch k_2 (d - d_0) with d_0 = (1 - k_n/k_2) d_max, down to the
 * adhesive branch -k_c d. The contact remembers the largest overlap d_max, which shrinks on the adhesive
 * branch. With a plasticity depth phi the slope grows from k_n to k_2 as d_max grows to k_2/(k_2 - k_n) phi 2 R*.
 * law_luding_springs is the loading branch; law_luding_unload all of the law, for the general loop. */
#ifndef SCREE_CONTACT_LAW_LUDING_H
#define SCREE_CONTACT_LAW_LUDING_H

#include "contact/law_spring.h"

LAW_INLINE struct law_springs law_luding_springs(const struct law_coefficients *c, double radius,
                                                 double overlap) {
    return law_spring_springs(c, radius, overlap);
}

/* The slope of the unloading branch for a largest overlap. */
static inline double law_luding_slope(const struct law_coefficients *c, const struct law_extra *extra,
                                      double radius, double largest) {
    double full = extra->k_2 / (extra->k_2 - c->k_n) * extra->plasticity_depth * 2.0 * radius;
    return largest < full ? c->k_n + (extra->k_2 - c->k_n) * largest / full : extra->k_2;
}

static inline struct law_springs law_luding_unload(const struct law_coefficients *c,
                                                   const struct law_extra *extra, double radius,
                                                   double overlap, double past[LAW_PAST_MAX]) {
    double most = fmax(past[0], overlap), slope = law_luding_slope(c, extra, radius, most);
    double force = fmin(c->k_n * overlap, slope * overlap - (slope - c->k_n) * most);
    double pull = -extra->k_c * overlap;
    if (force < pull) {
        force = pull;
        if (slope > c->k_n)
            most = (slope + extra->k_c) / (slope - c->k_n) * overlap;
    }
    past[0] = most;
    return (struct law_springs){.force = force,
                                .stiffness = c->k_n,
                                .tangent = extra->k_2,
                                .tangential = c->k_t,
                                .contact = 1.0,
                                .energy = 0.5 * force * force / slope};
}

/* A quarter of a period along k_n and one along k_2, which is at least as steep: at most half a period. */
static const struct law_form law_luding = {.damper = 2.0,
                                           .tangent = 1.0,
                                           .unload = law_luding_unload,
                                           .remembers = 1,
                                           .impact = law_spring_impact,
                                           .duration = law_spring_duration};

#endif
