/* SPDX-License-Identifier: BSD-3-Clause */
/* Luding: hysteretic linear springs for plastic, adhesive grains (Granular Matter 10 (2008) 235). Loading along
 * k_n d, unloading and reloading along a steeper branch k_2 (d - d_0) with d_0 = (1 - k_n/k_2) d_max, down to the
 * adhesive branch -k_c d. The contact remembers the largest overlap d_max, which shrinks on the adhesive
 * branch. With a plasticity depth phi the slope grows from k_n to k_2 as d_max grows to k_2/(k_2 - k_n) phi 2 R*.
 * law_luding_springs is the loading branch; law_luding_unload all of the law, for the general loop. */
#ifndef SCREE_LAWS_LAW_LUDING_H
#define SCREE_LAWS_LAW_LUDING_H

#include "physics/grains/laws/law_parts.h"
#include "physics/grains/laws/law_spring.h"

/* The members of struct law_extra that the branches take. */
#define LAW_LUDING_NUMBERS(NUMBER) NUMBER(k_2) NUMBER(k_c) NUMBER(plasticity_depth)

LAW_INLINE struct law_springs law_luding_springs(const struct law_coefficients *c, double radius,
                                                 double overlap) {
    return law_spring_springs(c, radius, overlap);
}

/* The slope of the unloading branch for a largest overlap. */
LAW_INLINE double law_luding_slope(const struct law_coefficients *c, const struct law_extra *extra,
                                   double radius, double largest) {
    double full = extra->k_2 / (extra->k_2 - c->k_n) * extra->plasticity_depth * 2.0 * radius;
    double slope = c->k_n + (extra->k_2 - c->k_n) * largest / law_most(full, 1e-300);
    return largest < full ? slope : extra->k_2;
}

/* Without branches: a loop over contacts vectorises (force_grip.h). */
LAW_INLINE struct law_springs law_luding_branch(const struct law_coefficients *c,
                                                const struct law_extra *extra, double radius, double overlap,
                                                double *past) {
    double most = law_most(*past, overlap), slope = law_luding_slope(c, extra, radius, most);
    double load = c->k_n * overlap, unload = slope * overlap - (slope - c->k_n) * most;
    double elastic = unload < load ? unload : load, pull = -extra->k_c * overlap;
    bool adheres = elastic < pull;
    double force = adheres ? pull : elastic;
    double back = (slope + extra->k_c) / law_most(slope - c->k_n, 1e-300) * overlap;
    *past = adheres && slope > c->k_n ? back : most;
    return (struct law_springs){.force = force,
                                .stiffness = c->k_n,
                                .tangent = extra->k_2,
                                .tangential = c->k_t,
                                .contact = 1.0,
                                .energy = 0.5 * force * force / slope};
}

static inline struct law_springs law_luding_unload(const struct law_coefficients *c,
                                                   const struct law_extra *extra, double radius,
                                                   double overlap, double past[LAW_PAST_MAX]) {
    return law_luding_branch(c, extra, radius, overlap, past);
}

/* A quarter of a period along k_n and one along k_2, which is at least as steep: at most half a period. */
static const struct law_form law_luding = {.damper = 2.0,
                                           .tangent = 1.0,
                                           .unload = law_luding_unload,
                                           .remembers = 1,
                                           .impact = law_spring_impact,
                                           .duration = law_spring_duration,
                                           .step_error = {0.0011, 0.0022, 0.0038, 0.01, 0.015, 0.023, 0.059}};

#endif
