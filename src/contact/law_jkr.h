/* SPDX-License-Identifier: BSD-3-Clause */
/* JKR: elastic spheres with surface energy (Johnson, Kendall and Roberts, Proc. R. Soc. A 324 (1971) 301). With
 * the work of adhesion W = 2 gamma and s = sqrt(2 pi W / E*) the contact radius a parametrises all:
 *
 *   overlap  d = a^2/R* - s sqrt(a)       force F = 4/3 E* a^3/R* - 2 E* s a^(3/2)
 *   energy   U = E* (8/15 a^5/R*^2 - 4/3 s a^(7/2)/R* + 1/2 s^2 a^2),  dU/dd = F,  U(a = 0) = 0
 *
 * The largest pull is 3/2 pi W R*, at a^3 = 9/16 s^2 R*^2; the pull-off distance, dd/da = 0, lies at
 * a^3 = s^2 R*^2 / 16, where the force is 5/9 of that. */
#ifndef SCREE_CONTACT_LAW_JKR_H
#define SCREE_CONTACT_LAW_JKR_H

#include "contact/law_parts.h"
#include "contact/law_root.h"

/* One state of a contact: contact radius, force (positive: repulsion), dF/dd, energy. */
struct law_jkr {
    double a, force, tangent, energy;
};

/* The largest contact radius at an overlap, by the explicit solution of the quartic in sqrt(a) (Parteli et al.,
 * Sci. Rep. 4 (2014) 6227; LAMMPS's pair_style granular). `modulus` is E*, more than 0; with gamma 0 that of
 * Hertz, for overlaps >= 0. */
LAW_INLINE double law_jkr_radius(double modulus, double gamma, double radius, double overlap) {
    double product = overlap * radius, square = product * product, area = radius * radius;
    double hertz = sqrt(law_most(product, 0.0));
    double t0 = gamma * gamma * area * area * modulus, t1 = 27.0 * M_PI * M_PI * t0;
    double t2 = 8.0 * product * square * modulus * modulus * modulus, t3 = 4.0 * square * modulus;
    double root = sqrt(law_most(0.0, t0 * (t1 + 2.0 * t2)));
    double t4 = law_cbrt(t1 + t2 + 3.0 * sqrt(3.0) * M_PI * root), t5 = t3 / t4 + t4 / modulus;
    double t6 = sqrt(law_most(0.0, 2.0 * product + t5));
    double last = 4.0 * product - t5 + 6.0 * sqrt(6.0) * gamma * M_PI * area / (modulus * t6);
    double sticky = (t6 + sqrt(law_most(0.0, last))) / sqrt(6.0);
    return gamma == 0.0 ? hertz : sticky;
}

/* The state at contact radius a. */
LAW_INLINE struct law_jkr law_jkr_at(double modulus, double gamma, double radius, double a) {
    double s = 2.0 * sqrt(M_PI * gamma / modulus), root = sqrt(a), cube = a * a * a / radius;
    double rise = 4.0 * a * a / radius - 3.0 * s * root,
           way = 2.0 * a / radius - 0.5 * s / law_most(root, 1e-150);
    return (struct law_jkr){.a = a,
                            .force = modulus * (4.0 / 3.0 * cube - 2.0 * s * a * root),
                            .tangent = modulus * rise / way,
                            .energy = modulus * (8.0 / 15.0 * cube * a * a / radius -
                                                 4.0 / 3.0 * s * cube * root + 0.5 * s * s * a * a)};
}

/* The contact radius at the end of a contact that is pulled apart, and the overlap there, which is negative. */
LAW_INLINE double law_jkr_end_radius(double modulus, double gamma, double radius, enum law_jkr_end end) {
    double cube = 0.25 * M_PI * gamma * radius * radius / modulus;
    return law_cbrt(end == LAW_JKR_END_FORCE ? 9.0 * cube : cube);
}

LAW_INLINE double law_jkr_end_overlap(double modulus, double gamma, double radius, enum law_jkr_end end) {
    double a = law_jkr_end_radius(modulus, gamma, radius, end);
    return -a * a / radius * (end == LAW_JKR_END_FORCE ? 1.0 / 3.0 : 3.0);
}

#endif
