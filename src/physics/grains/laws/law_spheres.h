/* SPDX-License-Identifier: BSD-3-Clause */
/* Elastic spheres, the springs of every law whose small contacts are elastic: k_n is 4/3 E*, k_t 8 G*, the contact radius
 * is sqrt(R* overlap). Sources: docs/physics.md. */
#ifndef SCREE_LAWS_LAW_SPHERES_H
#define SCREE_LAWS_LAW_SPHERES_H

#include "physics/grains/laws/law_form.h"

LAW_INLINE struct law_springs law_spheres_springs(const struct law_coefficients *c, double radius,
                                                  double overlap) {
    double contact = sqrt(radius * overlap);
    double stiffness = c->k_n * contact, force = stiffness * overlap;
    return (struct law_springs){.force = force,
                                .stiffness = stiffness,
                                .tangent = 1.5 * c->k_n * contact,
                                .tangential = c->k_t * contact,
                                .contact = contact,
                                .energy = 0.4 * force * overlap};
}

static inline void law_spheres_moduli(const struct law_material *a, const struct law_material *b,
                                      struct law_coefficients *c) {
    c->k_n =
        4.0 / 3.0 *
        (1.0 / ((1.0 - a->poisson * a->poisson) / a->young + (1.0 - b->poisson * b->poisson) / b->young));
    c->k_t = 8.0 * (1.0 / ((2.0 - a->poisson) * 2.0 * (1.0 + a->poisson) / a->young +
                           (2.0 - b->poisson) * 2.0 * (1.0 + b->poisson) / b->young));
}

static inline double law_spheres_impact(const struct law_coefficients *c, double mass, double radius,
                                        double speed) {
    return pow(1.25 * mass * speed * speed / (c->k_n * sqrt(radius)), 0.4);
}

/* 2.94328 overlap / speed; conservation of energy gives the speed for the overlap. */
static inline double law_spheres_duration(const struct law_coefficients *c, double mass, double radius,
                                          double overlap) {
    return 2.94328 * overlap / sqrt(0.8 * c->k_n * sqrt(radius) * pow(overlap, 2.5) / mass);
}

#endif
