/* SPDX-License-Identifier: BSD-3-Clause */
/* JKR: elastic spheres with surface energy (Johnson, Kendall and Roberts, Proc. R. Soc. A 324 (1971) 301). With
 * the work of adhesion W = 2 gamma and s = sqrt(2 pi W / E*) the contact radius a parametrises all:
 *
 *   overlap  d = a^2/R* - s sqrt(a)       force F = 4/3 E* a^3/R* - 2 E* s a^(3/2)
 *   energy   U = E* (8/15 a^5/R*^2 - 4/3 s a^(7/2)/R* + 1/2 s^2 a^2),  dU/dd = F,  U(a = 0) = 0
 *
 * The largest pull is 3/2 pi W R*, at a^3 = 9/16 s^2 R*^2; the pull-off distance, dd/da = 0, lies at
 * a^3 = s^2 R*^2 / 16, where the force is 5/9 of that. */
#ifndef SCREE_LAWS_COHESION_JKR_H
#define SCREE_LAWS_COHESION_JKR_H

#include "physics/grains/laws/law_part.h"
#include "physics/grains/laws/law_root.h"

#define COHESION_JKR_KEYS(KEY)                                                                               \
    KEY(jkr, surface_energy, "[0, inf)", .unit = "J/m2", .required = true, .example = "0.05 J/m2",           \
        .help = "surface energy gamma; the work of adhesion is W = 2 gamma")
struct cohesion_jkr_given {
    COHESION_JKR_KEYS(LAW_GIVEN_MEMBER)
};

/* `length`: law_jkr_length */
#define COHESION_JKR_NUMBERS(NUMBER) NUMBER(jkr, surface_energy) NUMBER(jkr, length)
struct cohesion_jkr {
    COHESION_JKR_NUMBERS(LAW_NUMBER_MEMBER)
};

/* Where a contact ends as it is pulled apart: at the pull-off distance, where no equilibrium is left at
 * a given distance; or at the largest pull, which a given force cannot exceed (LAMMPS). */
enum law_jkr_end { LAW_JKR_END_DISTANCE, LAW_JKR_END_FORCE };

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

static inline const char *cohesion_jkr_wrong(const struct cohesion_jkr_given *given) {
    (void)given;
    return NULL;
}

static inline struct cohesion_jkr cohesion_jkr_of(const struct law_coefficients *c,
                                                  const struct cohesion_jkr_given *given) {
    return (struct cohesion_jkr){.surface_energy = given->surface_energy,
                                 .length = law_jkr_length(law_modulus(c), given->surface_energy)};
}

static inline bool cohesion_jkr_sticks(const struct cohesion_jkr *p) {
    return p->surface_energy > 0.0;
}

/* The gap at which a contact breaks. */
static inline double cohesion_jkr_range(const struct cohesion_jkr *p, double radius, enum law_jkr_end end) {
    return law_jkr_end_gap(p->length, radius, end);
}

/* The energy of a contact as it breaks, counted from a = 0. */
static inline double cohesion_jkr_last(const struct cohesion_jkr *p, const struct law_coefficients *c,
                                       double radius, enum law_jkr_end end) {
    double last = law_jkr_end_radius(law_modulus(c), p->surface_energy, radius, end);
    return law_jkr_at(law_modulus(c), p->surface_energy, radius, last).energy;
}

/* The normal direction at the overlap `depth` of spheres with the effective radius `radius`; updates `held`. As a^2/R* = d + s
 * sqrt(a), the force is 2/3 E* a (2 d - s sqrt(a)). The energy counts from a = 0. */
LAW_INLINE struct law_grip cohesion_jkr_grip(const struct cohesion_jkr *p, const struct law_coefficients *c,
                                             double radius, double depth, enum law_jkr_end end, bool *held) {
    double modulus = law_modulus(c), s = p->length;
    bool holds = depth > 0.0 || (*held && law_jkr_holds(s, radius, depth, end));
    double largest = law_jkr_root(s, radius, depth), root = holds ? largest : 0.0, a = root * root;
    double force = 2.0 / 3.0 * modulus * a * (2.0 * depth - s * root);
    struct law_jkr now = law_jkr_state(modulus, s, radius, root);
    *held = holds;
    return (struct law_grip){.interacts = holds,
                             .touches = holds,
                             .force = force,
                             .least = force < 0.0 ? force : 0.0,
                             .press = holds ? 6.0 * M_PI * p->surface_energy * radius : 0.0,
                             .a = a,
                             .spring = c->k_n * a,
                             .factor = a,
                             .tangent = now.tangent,
                             .tangential = c->k_t * a,
                             .energy = now.energy};
}

static const struct law_cohesion_form cohesion_jkr_form = {
    .remembers = true,
    .fixed = true,
    .press = 1.0,
    .step_error = {0.0023, 0.0034, 0.0075, 0.017, 0.02, 0.028, 0.033}};

#endif
