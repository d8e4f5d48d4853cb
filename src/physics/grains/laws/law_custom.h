/* SPDX-License-Identifier: BSD-3-Clause */
/* The place of a law of the user's in the table (law_user.h gives its springs): where no file is loaded, the linear spring. */
#ifndef SCREE_LAWS_LAW_CUSTOM_H
#define SCREE_LAWS_LAW_CUSTOM_H

#include "physics/grains/laws/law_spring.h"

LAW_INLINE struct law_springs law_custom_springs(const struct law_coefficients *c, double radius,
                                                 double overlap) {
    return law_spring_springs(c, radius, overlap);
}

static const struct law_form law_custom = {.radius = true,
                                           .damper = 2.0,
                                           .tangent = 1.0,
                                           .impact = law_spring_impact,
                                           .duration = law_spring_duration};

#endif
