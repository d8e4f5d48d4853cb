/* SPDX-License-Identifier: BSD-3-Clause */
/* DMT: a constant pull while the spheres touch (Derjaguin, Muller and Toporov, J. Colloid Interface Sci. 53 (1975) 314): 2 pi W R*,
 * with W = 2 gamma. */
#ifndef SCREE_LAWS_COHESION_DMT_H
#define SCREE_LAWS_COHESION_DMT_H

#include "physics/grains/laws/law_part.h"
#define COHESION_DMT_KEYS(KEY)                                                                               \
    KEY(dmt, surface_energy, "[0, inf)", .unit = "J/m2", .required = true, .example = "0.05 J/m2",           \
        .help = "surface energy gamma; the work of adhesion is W = 2 gamma")
struct cohesion_dmt_given {
    COHESION_DMT_KEYS(LAW_GIVEN_MEMBER)
};

#define COHESION_DMT_NUMBERS(NUMBER) NUMBER(dmt, surface_energy)
struct cohesion_dmt {
    COHESION_DMT_NUMBERS(LAW_NUMBER_MEMBER)
};

static inline const char *cohesion_dmt_wrong(const struct cohesion_dmt_given *given) {
    (void)given;
    return NULL;
}

static inline struct cohesion_dmt cohesion_dmt_of(const struct law_coefficients *c,
                                                  const struct cohesion_dmt_given *given) {
    (void)c;
    return (struct cohesion_dmt){.surface_energy = given->surface_energy};
}

LAW_INLINE struct law_pull cohesion_dmt_pull(const struct cohesion_dmt *p, const struct law_radii *radii,
                                             double overlap) {
    return (struct law_pull){.force =
                                 overlap > 0.0 ? 4.0 * M_PI * p->surface_energy * radii->effective : 0.0};
}

LAW_INLINE double cohesion_dmt_range(const struct cohesion_dmt *p, double effective) {
    (void)p;
    (void)effective;
    return 0.0;
}

static inline double cohesion_dmt_energy(const struct cohesion_dmt *p, const struct law_radii *radii,
                                         double overlap) {
    return -cohesion_dmt_pull(p, radii, overlap).force * overlap;
}

static const struct law_cohesion_form cohesion_dmt_form = {
    .fixed = true,
    .constant = true,
    .press = 2.0,
    .step_error = {0.0029, 0.0063, 0.01, 0.023, 0.044, 0.065, 0.096}};

#endif
