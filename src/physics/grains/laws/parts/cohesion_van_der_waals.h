/* SPDX-License-Identifier: BSD-3-Clause */
/* Van der Waals: Hamaker's attraction (Physica 4 (1937) 1058) for spheres near each other, A R* / (6 gap^2), constant below the
 * least gap, none beyond the cut-off. */
#ifndef SCREE_LAWS_COHESION_VAN_DER_WAALS_H
#define SCREE_LAWS_COHESION_VAN_DER_WAALS_H

#include "physics/grains/laws/law_part.h"
#define COHESION_VAN_DER_WAALS_KEYS(KEY)                                                                     \
    KEY(van_der_waals, hamaker, "[0, inf)", .unit = "J", .required = true, .example = "6.5e-20 J",           \
        .help = "Hamaker's constant")                                                                        \
    KEY(van_der_waals, gap_least, "(0, inf)", .unit = "m", .required = true, .example = "0.4 nm",            \
        .help = "gap below which the pull grows no more")                                                    \
    KEY(van_der_waals, cut_off, "(0, inf)", .unit = "m", .required = true, .example = "100 nm",              \
        .help = "gap beyond which there is no pull")
struct cohesion_van_der_waals_given {
    COHESION_VAN_DER_WAALS_KEYS(LAW_GIVEN_MEMBER)
};

#define COHESION_VAN_DER_WAALS_NUMBERS(NUMBER)                                                               \
    NUMBER(van_der_waals, hamaker)                                                                           \
    NUMBER(van_der_waals, gap_least) NUMBER(van_der_waals, cut_off) NUMBER(van_der_waals, range)
struct cohesion_van_der_waals {
    COHESION_VAN_DER_WAALS_NUMBERS(LAW_NUMBER_MEMBER)
};

static inline const char *cohesion_van_der_waals_wrong(const struct cohesion_van_der_waals_given *given) {
    return given->gap_least > given->cut_off ? "gap_least is above cut_off" : NULL;
}

static inline struct cohesion_van_der_waals
cohesion_van_der_waals_of(const struct law_coefficients *c,
                          const struct cohesion_van_der_waals_given *given) {
    (void)c;
    return (struct cohesion_van_der_waals){.hamaker = given->hamaker,
                                           .gap_least = given->gap_least,
                                           .cut_off = given->cut_off,
                                           .range = given->hamaker > 0.0 ? given->cut_off : 0.0};
}

LAW_INLINE struct law_pull cohesion_van_der_waals_pull(const struct cohesion_van_der_waals *p,
                                                       const struct law_radii *radii, double overlap) {
    double gap = law_most(-overlap, p->gap_least), scale = p->hamaker * radii->effective / 6.0;
    double force = -overlap < p->cut_off ? scale / (gap * gap) : 0.0;
    return (struct law_pull){.force = force, .slope = -overlap > p->gap_least ? 2.0 * force / gap : 0.0};
}

LAW_INLINE double cohesion_van_der_waals_range(const struct cohesion_van_der_waals *p, double effective) {
    (void)effective;
    return p->range;
}

/* The integral of the force from the cut-off to the gap or overlap. */
static inline double cohesion_van_der_waals_energy(const struct cohesion_van_der_waals *p,
                                                   const struct law_radii *radii, double overlap) {
    double gap = fmax(-overlap, p->gap_least), scale = p->hamaker * radii->effective / 6.0;
    return -scale * (1.0 / gap - 1.0 / p->cut_off) - scale / (gap * gap) * (gap + overlap);
}

static const struct law_cohesion_form cohesion_van_der_waals_form = {
    .press = 1.0, .step_error = {0.0004, 0.0011, 0.0018, 0.0061, 0.02, 0.023, 0.021}};

#endif
