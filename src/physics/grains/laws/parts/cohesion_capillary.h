/* SPDX-License-Identifier: BSD-3-Clause */
/* A liquid bridge, which forms at touch and breaks at its rupture distance. Force: Willett et al. (Langmuir 16 (2000) 9396), their
 * closed form for small bridges, 2 pi r gamma cos(theta) / (1 + 1.05 S + 2.5 S^2) with r = 2 R* and S = gap sqrt(r/V). Rupture:
 * (1 + theta/2) V^(1/3) (Lian, Thornton and Adams, J. Colloid Interface Sci. 161 (1993) 138). */
#ifndef SCREE_LAWS_COHESION_CAPILLARY_H
#define SCREE_LAWS_COHESION_CAPILLARY_H

#include "physics/grains/laws/law_part.h"
#define COHESION_CAPILLARY_KEYS(KEY)                                                                         \
    KEY(capillary, surface_tension, "[0, inf)", .unit = "N/m", .required = true, .example = "0.072",         \
        .help = "of the liquid")                                                                             \
    KEY(capillary, contact_angle, "[0, 1.5707963267948966]", .unit = "rad", .fallback = "0",                 \
        .example = "20 deg", .help = "between liquid and solid")                                             \
    KEY(capillary, bridge_volume, "(0, inf)", .unit = "m3", .example = "1e-12 m3",                           \
        .help = "of each liquid bridge; this or bridge_fraction")                                            \
    KEY(capillary, bridge_fraction, "(0, inf)", .example = "0.01",                                           \
        .help = "volume of a bridge over that of a sphere with twice the effective radius (one of two like " \
                "spheres): grows with the particles")
struct cohesion_capillary_given {
    COHESION_CAPILLARY_KEYS(LAW_GIVEN_MEMBER)
};

/* Of a bridge with r = 2 R*: force over r; volume, and volume over r^3; the gap at which it breaks, and that over r. The volume is
 * given, or is a share: the other is 0. */
#define COHESION_CAPILLARY_NUMBERS(NUMBER)                                                                   \
    NUMBER(capillary, tension)                                                                               \
    NUMBER(capillary, volume)                                                                                \
    NUMBER(capillary, volume_share) NUMBER(capillary, rupture) NUMBER(capillary, rupture_share)
struct cohesion_capillary {
    COHESION_CAPILLARY_NUMBERS(LAW_NUMBER_MEMBER)
};

static inline const char *cohesion_capillary_wrong(const struct cohesion_capillary_given *given) {
    bool one = !(given->bridge_volume > 0.0) != !(given->bridge_fraction > 0.0);
    return given->surface_tension > 0.0 && !one ? "give one of bridge_volume and bridge_fraction, above 0"
                                                : NULL;
}

static inline struct cohesion_capillary cohesion_capillary_of(const struct law_coefficients *c,
                                                              const struct cohesion_capillary_given *given) {
    (void)c;
    struct cohesion_capillary p = {0};
    if (!(given->surface_tension > 0.0))
        return p;
    double reach = 1.0 + 0.5 * given->contact_angle;
    p.tension = 2.0 * M_PI * given->surface_tension * cos(given->contact_angle);
    p.volume = given->bridge_volume;
    if (!(given->bridge_volume > 0.0))
        p.volume_share = given->bridge_fraction * 4.0 / 3.0 * M_PI;
    p.rupture = reach * cbrt(p.volume);
    p.rupture_share = reach * cbrt(p.volume_share);
    return p;
}

LAW_INLINE double cohesion_capillary_volume(const struct cohesion_capillary *p, double r) {
    return p->volume + p->volume_share * (r * r * r);
}

LAW_INLINE double cohesion_capillary_range(const struct cohesion_capillary *p, double effective) {
    return law_most(p->rupture, p->rupture_share * (2.0 * effective));
}

LAW_INLINE struct law_pull cohesion_capillary_pull(const struct cohesion_capillary *p,
                                                   const struct law_radii *radii, double overlap) {
    double r = 2.0 * radii->effective, volume = cohesion_capillary_volume(p, r),
           gap = law_most(-overlap, 0.0);
    double most = p->tension * r, unit = sqrt(r / law_most(volume, 1e-300));
    double b = 1.05 * unit, c = 2.5 * unit * unit, below = 1.0 + gap * (b + c * gap);
    bool holds = volume > 0.0 && gap < cohesion_capillary_range(p, radii->effective);
    return (struct law_pull){.force = holds ? most / below : 0.0,
                             .slope =
                                 holds && overlap < 0.0 ? most * (b + 2.0 * c * gap) / (below * below) : 0.0};
}

/* The integral of the force from the rupture to the gap, and on to the overlap. */
static inline double cohesion_capillary_energy(const struct cohesion_capillary *p,
                                               const struct law_radii *radii, double overlap) {
    double r = 2.0 * radii->effective, gap = fmax(-overlap, 0.0),
           end = cohesion_capillary_range(p, radii->effective);
    double unit = sqrt(r / cohesion_capillary_volume(p, r)), b = 1.05 * unit, c = 2.5 * unit * unit;
    double root = sqrt(4.0 * c - b * b);
    double area = 2.0 / root * (atan((2.0 * c * end + b) / root) - atan((2.0 * c * gap + b) / root));
    return -p->tension * r * (area + fmax(overlap, 0.0));
}

static const struct law_cohesion_form cohesion_capillary_form = {
    .remembers = true,
    .press = 1.0,
    .step_error = {9.9e-05, 0.00024, 0.00039, 0.0011, 0.0033, 0.0057, 0.014}};

#endif
