/* SPDX-License-Identifier: BSD-3-Clause */
/* Rigid grains: no springs at all. A solver finds the forces that keep grains apart (src/physics/hard); the law of a contact is
 * its restitution and its friction. */
#ifndef SCREE_LAWS_LAW_RIGID_H
#define SCREE_LAWS_LAW_RIGID_H

#include "physics/grains/laws/law_form.h"

LAW_INLINE struct law_springs law_rigid_springs(const struct law_coefficients *c, double radius,
                                                double overlap) {
    (void)c, (void)radius, (void)overlap;
    return (struct law_springs){0};
}

static inline double law_rigid_nothing(const struct law_coefficients *c, double mass, double radius,
                                       double speed) {
    (void)c, (void)mass, (void)radius, (void)speed;
    return 0.0;
}

static const struct law_form law_rigid = {
    .tangent = 1.0, .impact = law_rigid_nothing, .duration = law_rigid_nothing};

#endif
