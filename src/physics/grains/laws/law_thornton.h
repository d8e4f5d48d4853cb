/* SPDX-License-Identifier: BSD-3-Clause */
/* Thornton: elastic, perfectly plastic spheres (J. Appl. Mech. 64 (1997) 383), and with the cohesion jkr the adhesive ones of
 * Thornton and Ning (Powder Technol. 99 (1998) 154). Elastic as Hertz or JKR until the pressure in the middle of the
 * contact reaches the yield pressure p, at the contact radius a_y; from there on the pressure in the middle stays p; unloading
 * and reloading as Hertz or JKR with the flattened radius R_p around the overlap d_p that is left. With s of
 * physics/grains/laws/parts/cohesion_jkr.h, 0 without surface energy, and the contact radius a as parameter,
 *
 *   yield     p = E* / pi (2 a_y/R* - s/sqrt(a_y))
 *   loading   F = F_y + pi p (a^2 - a_y^2) - 2 E* s a_y (sqrt(a) - sqrt(a_y)),  d = a^2/R* - s sqrt(a)
 *   flattened R_p = 4/3 E* a_m^3 / (F_m + 2 E* s a_m^(3/2)),  d_p = d_m - a_m^2/R_p + s sqrt(a_m)
 *
 * with a_m, F_m at the largest overlap d_m. (The loading branch is the integral of their slope dF/dd.)
 * law_thornton_springs is the elastic branch; law_thornton_unload all of the law without surface energy, for the
 * general loop. The coefficient k_n is 4/3 E*. */
#ifndef SCREE_LAWS_LAW_THORNTON_H
#define SCREE_LAWS_LAW_THORNTON_H

#include "physics/grains/laws/law_parts.h"
#include "physics/grains/laws/law_spheres.h"

LAW_INLINE struct law_springs law_thornton_springs(const struct law_coefficients *c, double radius,
                                                   double overlap) {
    return law_spheres_springs(c, radius, overlap);
}

/* sqrt(a_y): the positive root of x^3 - h^2 x - q, h^2 = pi p R* / (2 E*), q = R* s / 2, by Newton's iteration from a
 * bound above the root. */
LAW_INLINE double law_thornton_yield(double modulus, double s, double pressure, double radius) {
    double square = 0.5 * M_PI * pressure * radius / modulus, q = 0.5 * s * radius;
    if (q == 0.0)
        return sqrt(square);
    double x = sqrt(square) + law_cbrt(q);
    for (int k = 0; k < 7; k++)
        x -= (x * (x * x - square) - q) / (3.0 * x * x - square);
    return x;
}

/* The spheres after the largest overlap `most` >= 0. */
LAW_INLINE struct law_flat law_thornton_flat(double modulus, double gamma, double pressure, double radius,
                                             double most) {
    double s = 2.0 * sqrt(M_PI * gamma / modulus), root_y = law_thornton_yield(modulus, s, pressure, radius);
    double a = law_jkr_radius(modulus, gamma, radius, most), a_y = root_y * root_y, root = sqrt(a);
    double force_y = modulus * a_y * (4.0 / 3.0 * a_y * a_y / radius - 2.0 * s * root_y);
    double force =
        force_y + M_PI * pressure * (a - a_y) * (a + a_y) - 2.0 * modulus * s * a_y * (root - root_y);
    double flat = 4.0 / 3.0 * modulus * a * a * a / (force + 2.0 * modulus * s * a * root);
    bool flows = a > a_y;
    return (struct law_flat){flows ? flat : radius, flows ? most - a * a / flat + s * root : 0.0};
}

static inline struct law_flat law_thornton_sticky(const struct law_coefficients *c,
                                                  const struct law_extra *extra, double radius, double most) {
    return law_thornton_flat(0.75 * c->k_n, extra->cohesion_jkr.surface_energy, extra->yield_pressure, radius,
                             most);
}

static inline struct law_springs law_thornton_unload(const struct law_coefficients *c,
                                                     const struct law_extra *extra, double radius,
                                                     double overlap, double past[LAW_PAST_MAX]) {
    double most = law_most(past[0], overlap);
    struct law_flat flat = law_thornton_flat(0.75 * c->k_n, 0.0, extra->yield_pressure, radius, most);
    double depth = law_most(overlap - flat.left, 0.0);
    struct law_springs springs = law_thornton_springs(c, flat.radius, depth);
    springs.stiffness = c->k_n * sqrt(radius * overlap);
    springs.contact = sqrt(radius * overlap);
    past[0] = most;
    return springs;
}

static const struct law_form law_thornton = {
    .radius = true,
    .damper = 2.23606797749978969641, /* sqrt(5) */
    .tangent = 1.5,
    .moduli = law_spheres_moduli,
    .unload = law_thornton_unload,
    .remembers = 1,
    .flatten = law_thornton_sticky,
    .impact = law_spheres_impact,
    .duration = law_spheres_duration,
    .step_error = {0.00034, 0.00077, 0.0012, 0.0028, 0.0045, 0.0067, 0.024}};

#endif
