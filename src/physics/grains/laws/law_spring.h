/* SPDX-License-Identifier: BSD-3-Clause */
/* The linear spring F = k_n d of every law that loads along one. */
#ifndef SCREE_LAWS_LAW_SPRING_H
#define SCREE_LAWS_LAW_SPRING_H

#include "physics/grains/laws/law_form.h"

LAW_INLINE struct law_springs law_spring_springs(const struct law_coefficients *c, double radius,
                                                 double overlap) {
    (void)radius;
    double force = c->k_n * overlap;
    return (struct law_springs){.force = force,
                                .stiffness = c->k_n,
                                .tangent = c->k_n,
                                .tangential = c->k_t,
                                .contact = 1.0,
                                .energy = 0.5 * force * overlap};
}

static inline double law_spring_impact(const struct law_coefficients *c, double mass, double radius,
                                       double speed) {
    (void)radius;
    return speed * sqrt(mass / c->k_n);
}

static inline double law_spring_duration(const struct law_coefficients *c, double mass, double radius,
                                         double overlap) {
    (void)radius;
    (void)overlap;
    return M_PI * sqrt(mass / c->k_n);
}

#endif
