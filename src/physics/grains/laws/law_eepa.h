/* SPDX-License-Identifier: BSD-3-Clause */
/* EEPA, the Edinburgh elasto-plastic adhesion law (Morrissey 2013; Thakur, Morrissey, Sun, Chen and Ooi, Granular Matter 16
 * (2014) 383), with the exponent 3/2 of spheres. Loading along k_1 d^(3/2), k_1 = 4/3 E* sqrt(R*); unloading and
 * reloading along the steeper k_2 (d^(3/2) - d_p^(3/2)), k_2 = k_1/(1 - lambda), lambda the plasticity ratio; pulled
 * apart, along the adhesive branch
 *
 *   -f_min (d/d_min)^chi,   f_min = 3/2 pi dgamma a up to k_2 d_p^(3/2)/2,   a^2 = 2 R* d_p,
 *   d_min^(3/2) = d_p^(3/2) - f_min/k_2
 *
 * that meets the unloading branch where the pull is f_min. d_p = lambda^(2/3) d_m is the overlap left by a loading up
 * to d_m. A constant pull acts while the surfaces touch. A contact remembers d_m, and d_p^(3/2) of the present
 * unloading branch, which moves on the adhesive branch: reloading starts there. law_eepa_springs is the loading branch;
 * law_eepa_unload all of the law, for the general loop. The coefficient k_n is 4/3 E*. */
#ifndef SCREE_LAWS_LAW_EEPA_H
#define SCREE_LAWS_LAW_EEPA_H

#include "physics/grains/laws/law_parts.h"
#include "physics/grains/laws/law_root.h"
#include "physics/grains/laws/law_spheres.h"

LAW_INLINE struct law_springs law_eepa_springs(const struct law_coefficients *c, double radius,
                                               double overlap) {
    return law_spheres_springs(c, radius, overlap);
}

/* x^(2/3), x >= 0. */
LAW_INLINE double law_eepa_length(double x) {
    double root = law_cbrt(x);
    return root * root;
}

/* The pull of the adhesive branch after a loading up to `most` > 0; `power` is overlap^(3/2). */
static inline double law_eepa_pull(const struct law_extra *extra, double radius, double k_2, double most,
                                   double overlap, double power) {
    double foot = extra->plasticity_ratio * most * sqrt(most);
    double patch = sqrt(2.0 * radius * law_eepa_length(foot));
    double pull = fmin(1.5 * M_PI * extra->adhesion_energy * patch, 0.5 * k_2 * foot);
    double least = foot - pull / k_2;
    if (!(least > 0.0))
        return 0.0;
    if (extra->adhesion_exponent == 1.5)
        return pull * power / least;
    return pull * pow(overlap / law_eepa_length(least), extra->adhesion_exponent);
}

static inline struct law_springs law_eepa_unload(const struct law_coefficients *c,
                                                 const struct law_extra *extra, double radius, double overlap,
                                                 double past[LAW_PAST_MAX]) {
    double k_1 = c->k_n * sqrt(radius), k_2 = k_1 / (1.0 - extra->plasticity_ratio);
    double root = sqrt(overlap), power = overlap * root, contact = sqrt(radius * overlap);
    double force = k_2 * (power - past[1]);
    if (force >= k_1 * power) {
        force = k_1 * power;
        past[0] = overlap;
        past[1] = extra->plasticity_ratio * power;
    }
    double pull = law_eepa_pull(extra, radius, k_2, past[0], overlap, power);
    if (force < -pull) {
        force = -pull;
        past[1] = power + pull / k_2;
    }
    double foot = law_eepa_length(past[1]);
    double stored = k_2 * (0.4 * (power * overlap - past[1] * foot) - past[1] * (overlap - foot));
    return (struct law_springs){.force = force - extra->pull_off,
                                .stiffness = k_1 * root,
                                .tangent = 1.5 * k_2 * root,
                                .tangential = c->k_t * contact,
                                .contact = contact,
                                .energy = stored - extra->pull_off * overlap,
                                .press = pull + extra->pull_off};
}

static const struct law_form law_eepa = {
    .radius = true,
    .damper = 2.23606797749978969641, /* sqrt(5) */
    .tangent = 1.5,
    .moduli = law_spheres_moduli,
    .unload = law_eepa_unload,
    .remembers = 2,
    .impact = law_spheres_impact,
    .duration = law_spheres_duration,
    .step_error = {0.00017, 0.00039, 0.0008, 0.0026, 0.0062, 0.013, 0.027}};

#endif
