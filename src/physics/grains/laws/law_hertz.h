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
#ifndef SCREE_LAWS_LAW_HERTZ_H
#define SCREE_LAWS_LAW_HERTZ_H

#include "physics/grains/laws/law_spheres.h"

LAW_INLINE struct law_springs law_hertz_springs(const struct law_coefficients *c, double radius,
                                                double overlap) {
    return law_spheres_springs(c, radius, overlap);
}

static const struct law_form law_hertz = {
    .radius = true,
    .damper = 2.23606797749978969641, /* sqrt(5) */
    .tangent = 1.5,
    .moduli = law_spheres_moduli,
    .impact = law_spheres_impact,
    .duration = law_spheres_duration,
    .step_error = {0.00061, 0.0014, 0.0021, 0.005, 0.0075, 0.011, 0.015}};

#endif
