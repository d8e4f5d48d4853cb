/* SPDX-License-Identifier: BSD-3-Clause */
/* Thornton: elastic, perfectly plastic spheres (J. Appl. Mech. 64 (1997) 383; Thornton and Ning, Powder Technol. 99
 * (1998) 154, without their surface energy). Elastic as Hertz until the pressure in the middle reaches the yield pressure p,
 * at a_y = pi R* p / (2 E*); from there on along the straight line of slope pi R* p; unloading and reloading as
 * Hertz with the flattened radius R_p around the overlap d_p that is left:
 *
 *   F = 4/3 E* sqrt(R_p) (d - d_p)^(3/2),  R_p = 4 E* / (3 F_m) ((2 F_m + F_y) / (2 pi p))^(3/2)
 *
 * with F_m the force at the largest overlap, F_y that at yield. law_thornton_springs is the elastic branch;
 * law_thornton_unload all of the law, for the general loop. The coefficient k_n is 4/3 E*. */
#ifndef SCREE_CONTACT_LAW_THORNTON_H
#define SCREE_CONTACT_LAW_THORNTON_H

#include "contact/law_spheres.h"

LAW_INLINE struct law_springs law_thornton_springs(const struct law_coefficients *c, double radius,
                                                   double overlap) {
    return law_spheres_springs(c, radius, overlap);
}

static inline struct law_springs law_thornton_unload(const struct law_coefficients *c,
                                                     const struct law_extra *extra, double radius,
                                                     double overlap, double *largest) {
    double p = extra->yield_pressure, yield = M_PI * radius * p / (1.5 * c->k_n); /* a_y */
    double most = fmax(*largest, overlap), overlap_yield = yield * yield / radius;
    struct law_springs springs = law_thornton_springs(c, radius, overlap);
    *largest = most;
    if (most <= overlap_yield)
        return springs;
    double force_yield = c->k_n * yield * overlap_yield;
    double force_most = force_yield + M_PI * radius * p * (most - overlap_yield);
    double flat = c->k_n / force_most * pow((2.0 * force_most + force_yield) / (2.0 * M_PI * p), 1.5);
    double left = most - pow(force_most / (c->k_n * sqrt(flat)), 2.0 / 3.0),
           depth = fmax(overlap - left, 0.0);
    double contact = sqrt(flat * depth);
    springs.force = c->k_n * contact * depth;
    springs.tangent = 1.5 * c->k_n * contact;
    springs.energy = 0.4 * springs.force * depth;
    springs.tangential = c->k_t * contact;
    return springs;
}

static const struct law_form law_thornton = {.radius = true,
                                             .damper = 2.23606797749978969641, /* sqrt(5) */
                                             .tangent = 1.5,
                                             .moduli = law_spheres_moduli,
                                             .unload = law_thornton_unload,
                                             .impact = law_spheres_impact,
                                             .duration = law_spheres_duration};

#endif
