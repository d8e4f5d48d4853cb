/* SPDX-License-Identifier: BSD-3-Clause */
/* Hertz and Mindlin: elastic spheres. With the effective moduli E* and G* of the two materials and the
 * contact radius a = sqrt(R* d),
 *
 *   F = 4/3 E* a d                k_t = 8 G* a (Mindlin)
 *   1/E* = sum (1 - nu^2) / E     1/G* = sum (2 - nu) / G,  G = E / (2 (1 + nu))
 *
 * The damper c = alpha sqrt(m* F / d), alpha = sqrt(5) zeta, gives any impact the same restitution, as
 * d^(5/4) turns the damped contact into a linear spring-dashpot (Antypov and Elliott, EPL 94 (2011) 50004).
 * With given coefficients the springs are k_n a and k_t a, and the dampers gamma m* a: LAMMPS's
 * gran/hertz/history. */
#ifndef SCREE_CONTACT_LAW_HERTZ_H
#define SCREE_CONTACT_LAW_HERTZ_H

#include "contact/law_form.h"

LAW_INLINE struct law_springs law_hertz_springs(const struct law_coefficients *c, double radius,
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

static inline void law_hertz_moduli(const struct law_material *a, const struct law_material *b,
                                    struct law_coefficients *c) {
    c->k_n =
        4.0 / 3.0 *
        (1.0 / ((1.0 - a->poisson * a->poisson) / a->young + (1.0 - b->poisson * b->poisson) / b->young));
    c->k_t = 8.0 * (1.0 / ((2.0 - a->poisson) * 2.0 * (1.0 + a->poisson) / a->young +
                           (2.0 - b->poisson) * 2.0 * (1.0 + b->poisson) / b->young));
}

static inline double law_hertz_impact(const struct law_coefficients *c, double mass, double radius,
                                      double speed) {
    return pow(1.25 * mass * speed * speed / (c->k_n * sqrt(radius)), 0.4);
}

/* 2.94328 overlap / speed; conservation of energy gives the speed for the overlap. */
static inline double law_hertz_duration(const struct law_coefficients *c, double mass, double radius,
                                        double overlap) {
    return 2.94328 * overlap / sqrt(0.8 * c->k_n * sqrt(radius) * pow(overlap, 2.5) / mass);
}

static const struct law_form law_hertz = {.radius = true,
                                          .damper = 2.23606797749978969641, /* sqrt(5) */
                                          .tangent = 1.5,
                                          .moduli = law_hertz_moduli,
                                          .impact = law_hertz_impact,
                                          .duration = law_hertz_duration};

#endif
