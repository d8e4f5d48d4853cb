/* SPDX-License-Identifier: BSD-3-Clause */
/* JKR: elastic spheres with surface energy (Johnson, Kendall and Roberts, Proc. R. Soc. A 324 (1971) 301). With
 * the work of adhesion W = 2 gamma and s = sqrt(2 pi W / E*) the contact radius a parametrises all:
 *
 *   overlap  d = a^2/R* - s sqrt(a)       force F = 4/3 E* a^3/R* - 2 E* s a^(3/2)
 *   energy   U = E* (8/15 a^5/R*^2 - 4/3 s a^(7/2)/R* + 1/2 s^2 a^2),  dU/dd = F,  U(a = 0) = 0
 *
 * The largest pull is 3/2 pi W R*, at a^3 = 9/16 s^2 R*^2; the pull-off distance, dd/da = 0, lies at
 * a^3 = s^2 R*^2 / 16, where the force is 5/9 of that. */
#ifndef SCREE_LAWS_LAW_JKR_H
#define SCREE_LAWS_LAW_JKR_H

#include "physics/grains/laws/law_parts.h"
#include "physics/grains/laws/law_root.h"

/* One state of a contact: contact radius, force (positive: repulsion), dF/dd, energy. */
struct law_jkr {
    double a, force, tangent, energy;
};

/* E* of the coefficients of a law with moduli. */
LAW_INLINE double law_modulus(const struct law_coefficients *c) {
    return 0.75 * c->k_n;
}

/* The s of the formulas, length^(1/2). `modulus` is E*, more than 0. */
LAW_INLINE double law_jkr_length(double modulus, double gamma) {
    return 2.0 * sqrt(M_PI * gamma / modulus);
}

/* The square root x of the largest contact radius at an overlap: x^4 - S x - R* d = 0, S = s R*. Ferrari: the quartic has the factor
 * x^2 - p x - ... where p^2 solves y^3 + 3 q y = S^2, q = 4/3 R* d. Cardano: p = S / sqrt(A^2 + q + B^2), A^3 = S^2/2 + sqrt(S^4/4 + q^3),
 * A B = q; this form loses no digits at large overlaps. With s = 0 that of Hertz, for overlaps >= 0. One cube root, three square
 * roots and one division. */
LAW_INLINE double law_jkr_root(double s, double radius, double overlap) {
    double sum = s * radius, square = sum * sum, q = 4.0 / 3.0 * (radius * overlap);
    double cube = 0.5 * square + sqrt(law_most(0.25 * (square * square) + q * q * q, 0.0));
    double inverse = law_cbrt_inverse(cube), a = cube * (inverse * inverse), b = q * inverse;
    double width = sqrt(law_most(a * a + q + b * b, 0.0)), p = sum / law_most(width, 1e-150);
    return 0.5 * (p + sqrt(law_most(2.0 * width - p * p, 0.0)));
}

/* The largest contact radius at an overlap. */
LAW_INLINE double law_jkr_radius(double modulus, double gamma, double radius, double overlap) {
    double root = law_jkr_root(law_jkr_length(modulus, gamma), radius, overlap);
    return root * root;
}

/* The state at contact radius a = root^2. */
LAW_INLINE struct law_jkr law_jkr_state(double modulus, double s, double radius, double root) {
    double a = root * root, cube = a * a * a / radius;
    double rise = 4.0 * a * a / radius - 3.0 * s * root,
           way = 2.0 * a / radius - 0.5 * s / law_most(root, 1e-150);
    return (struct law_jkr){.a = a,
                            .force = modulus * (4.0 / 3.0 * cube - 2.0 * s * a * root),
                            .tangent = modulus * rise / way,
                            .energy = modulus * (8.0 / 15.0 * cube * a * a / radius -
                                                 4.0 / 3.0 * s * cube * root + 0.5 * s * s * a * a)};
}

LAW_INLINE struct law_jkr law_jkr_at(double modulus, double gamma, double radius, double a) {
    return law_jkr_state(modulus, law_jkr_length(modulus, gamma), radius, sqrt(a));
}

/* The contact radius at the end of a contact that is pulled apart. */
LAW_INLINE double law_jkr_end_radius(double modulus, double gamma, double radius, enum law_jkr_end end) {
    double cube = 0.25 * M_PI * gamma * radius * radius / modulus;
    return law_cbrt(end == LAW_JKR_END_FORCE ? 9.0 * cube : cube);
}

/* The gap at the end of a contact that is pulled apart, as a cube and as a length. */
LAW_INLINE double law_jkr_end_cube(double s, double radius, enum law_jkr_end end) {
    double square = s * s;
    return (end == LAW_JKR_END_FORCE ? 3.0 : 27.0) / 256.0 * (square * square) * radius;
}

LAW_INLINE double law_jkr_end_gap(double s, double radius, enum law_jkr_end end) {
    return law_cbrt(law_jkr_end_cube(s, radius, end));
}

/* True where a contact that is pulled apart still holds: -overlap < law_jkr_end_gap, without a root. */
LAW_INLINE bool law_jkr_holds(double s, double radius, double overlap, enum law_jkr_end end) {
    return -overlap * overlap * overlap < law_jkr_end_cube(s, radius, end);
}

#endif
