/* SPDX-License-Identifier: BSD-3-Clause */
/* Simplified JKR of LIGGGHTS: energy density times the area of the circle in which the spheres intersect. With
 * the distance D of the centres its radius obeys a^2 = (r_i^2 + r_j^2)/2 - D^2/4 - (r_i^2 - r_j^2)^2/(4 D^2). */
#ifndef SCREE_LAWS_COHESION_SJKR_H
#define SCREE_LAWS_COHESION_SJKR_H

#include "physics/grains/laws/law_part.h"
#define COHESION_SJKR_KEYS(KEY)                                                                              \
    KEY(sjkr, cohesion_density, "[0, inf)", .unit = "J/m3", .required = true, .example = "1e5 J/m3",         \
        .help = "energy over volume: the pull over the area of the overlap")
struct cohesion_sjkr_given {
    COHESION_SJKR_KEYS(LAW_GIVEN_MEMBER)
};

#define COHESION_SJKR_NUMBERS(NUMBER) NUMBER(sjkr, density)
struct cohesion_sjkr {
    COHESION_SJKR_NUMBERS(LAW_NUMBER_MEMBER)
};

static inline const char *cohesion_sjkr_wrong(const struct cohesion_sjkr_given *given) {
    (void)given;
    return NULL;
}

static inline struct cohesion_sjkr cohesion_sjkr_of(const struct law_coefficients *c,
                                                    const struct cohesion_sjkr_given *given) {
    (void)c;
    return (struct cohesion_sjkr){.density = given->cohesion_density};
}

LAW_INLINE struct law_pull cohesion_sjkr_pull(const struct cohesion_sjkr *p, const struct law_radii *radii,
                                              double overlap) {
    double r = radii->one, q = radii->other;
    double density = M_PI * p->density, distance = r + q - overlap;
    double sum = r * r + q * q, difference = (r - q) * (r + q);
    double odd = difference * difference / (4.0 * distance * distance);
    double area = isinf(q) ? overlap * (2.0 * r - overlap) : 0.5 * sum - 0.25 * distance * distance - odd;
    double slope = isinf(q) ? 2.0 * (r - overlap) : 0.5 * distance - 2.0 * odd / distance;
    return (struct law_pull){.force = overlap > 0.0 ? density * area : 0.0,
                             .slope = overlap > 0.0 ? density * slope : 0.0};
}

LAW_INLINE double cohesion_sjkr_range(const struct cohesion_sjkr *p, double effective) {
    (void)p;
    (void)effective;
    return 0.0;
}

/* The integral of the force from the touch to the overlap. */
static inline double cohesion_sjkr_energy(const struct cohesion_sjkr *p, const struct law_radii *radii,
                                          double overlap) {
    double density = M_PI * p->density, r = radii->one, q = radii->other;
    if (isinf(q))
        return -density * overlap * overlap * (r - overlap / 3.0);
    double distance = r + q - overlap, sum = r * r + q * q, difference = (r - q) * (r + q);
    double odd = difference * difference / (4.0 * distance * distance);
    double touch = r + q, far = difference * difference / (4.0 * touch);
    double within = 0.5 * sum * touch - touch * touch * touch / 12.0 + far;
    double here = 0.5 * sum * distance - distance * distance * distance / 12.0 + odd * distance;
    return -density * (within - here);
}

static const struct law_cohesion_form cohesion_sjkr_form = {
    .press = 1.0, .step_error = {0.00017, 0.00041, 0.00058, 0.0022, 0.0042, 0.0059, 0.0079}};

#endif
