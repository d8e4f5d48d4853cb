/* SPDX-License-Identifier: BSD-3-Clause */
/* Hooke: a linear spring, F = k_n d. The dashpot of a linear spring gives any impact the same restitution and
 * the same duration. */
#ifndef SCREE_LAWS_LAW_HOOKE_H
#define SCREE_LAWS_LAW_HOOKE_H

#include "physics/grains/laws/law_spring.h"

LAW_INLINE struct law_springs law_hooke_springs(const struct law_coefficients *c, double radius,
                                                double overlap) {
    return law_spring_springs(c, radius, overlap);
}

static const struct law_form law_hooke = {.linear = true,
                                          .damper = 2.0,
                                          .tangent = 1.0,
                                          .impact = law_spring_impact,
                                          .duration = law_spring_duration,
                                          .step_error = {0.0023, 0.0048, 0.0073, 0.014, 0.022, 0.035, 0.063}};

#endif
