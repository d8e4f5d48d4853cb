/* SPDX-License-Identifier: BSD-3-Clause */
/* Cohesion: the pull between two surfaces, at touch and beyond. All forces derive from a potential, except
 * that a bridge or an adhesive contact forms at touch and breaks farther apart. Formulas and sources in
 * docs/physics.md. The `static inline` functions are arithmetic without branches: a loop over contacts that calls
 * one, with `cohesion` a constant, vectorises (force_grip.h). Any thread. */
#ifndef SCREE_LAWS_LAW_COHESION_H
#define SCREE_LAWS_LAW_COHESION_H

#include "physics/grains/laws/law.h"
#include "physics/grains/laws/law_jkr.h"

/* Two surfaces as cohesion sees them. radius: of both; a wall's is infinite; effective: R*. */
struct law_surfaces {
    const struct law_coefficients *c;
    const struct law_extra *extra;
    double radius[2], effective;
};

/* The attraction of a law other than JKR: force >= 0, d force/d overlap, and energy <= 0 with d energy/d overlap =
 * -force. */
struct law_pull {
    double force, slope, energy;
};

/* Of a bridge between surfaces with r = 2 R*: its volume, and the gap at which the bridge breaks, (1 + theta/2) V^(1/3)
 * (Lian, Thornton and Adams 1993). The volume of a pair is given, or is a share: the other is 0. */
LAW_INLINE double law_bridge_volume(const struct law_sticky *sticky, double r) {
    return sticky->volume + sticky->volume_share * (r * r * r);
}

LAW_INLINE double law_bridge_rupture(const struct law_sticky *sticky, double r) {
    return law_most(sticky->rupture, sticky->rupture_share * r);
}

/* Derjaguin, Muller and Toporov (1975): 2 pi W R*, W = 2 gamma, while the spheres touch. */
LAW_INLINE struct law_pull law_pull_dmt(const struct law_sticky *sticky, double effective, double overlap) {
    return (struct law_pull){.force = overlap > 0.0 ? 4.0 * M_PI * sticky->surface_energy * effective : 0.0};
}

/* Simplified JKR of LIGGGHTS: energy density times the area of the circle in which the spheres intersect. With
 * the distance D of the centres its radius obeys a^2 = (r_i^2 + r_j^2)/2 - D^2/4 - (r_i^2 - r_j^2)^2/(4 D^2). */
LAW_INLINE struct law_pull law_pull_sjkr(const struct law_sticky *sticky, double r, double q,
                                         double overlap) {
    double density = M_PI * sticky->density, distance = r + q - overlap;
    double sum = r * r + q * q, difference = (r - q) * (r + q);
    double odd = difference * difference / (4.0 * distance * distance);
    double area = isinf(q) ? overlap * (2.0 * r - overlap) : 0.5 * sum - 0.25 * distance * distance - odd;
    double slope = isinf(q) ? 2.0 * (r - overlap) : 0.5 * distance - 2.0 * odd / distance;
    return (struct law_pull){.force = overlap > 0.0 ? density * area : 0.0,
                             .slope = overlap > 0.0 ? density * slope : 0.0};
}

/* Willett et al. (2000), their closed form for small bridges: 2 pi r gamma cos(theta) / (1 + 1.05 S + 2.5 S^2)
 * with r = 2 R* and S = gap sqrt(r/V). */
LAW_INLINE struct law_pull law_pull_capillary(const struct law_sticky *sticky, double effective,
                                              double overlap) {
    double r = 2.0 * effective, volume = law_bridge_volume(sticky, r), gap = law_most(-overlap, 0.0);
    double most = sticky->tension * r, unit = sqrt(r / law_most(volume, 1e-300));
    double b = 1.05 * unit, c = 2.5 * unit * unit, below = 1.0 + gap * (b + c * gap);
    bool holds = volume > 0.0 && gap < law_bridge_rupture(sticky, r);
    return (struct law_pull){.force = holds ? most / below : 0.0,
                             .slope =
                                 holds && overlap < 0.0 ? most * (b + 2.0 * c * gap) / (below * below) : 0.0};
}

/* Hamaker (1937) for spheres near each other: A R* / (6 gap^2), constant below the least gap. */
LAW_INLINE struct law_pull law_pull_van_der_waals(const struct law_sticky *sticky, double effective,
                                                  double overlap) {
    double gap = law_most(-overlap, sticky->gap_least), scale = sticky->hamaker * effective / 6.0;
    double force = -overlap < sticky->cut_off ? scale / (gap * gap) : 0.0;
    return (struct law_pull){.force = force, .slope = -overlap > sticky->gap_least ? 2.0 * force / gap : 0.0};
}

/* The attraction at an overlap (negative: a gap) between surfaces of radii r and q, without its energy; 0 of JKR, which
 * takes the place of the elastic force. */
LAW_INLINE struct law_pull law_pull_at(enum law_cohesion cohesion, const struct law_sticky *sticky, double r,
                                       double q, double effective, double overlap) {
    switch (cohesion) {
    case LAW_COHESION_DMT:
        return law_pull_dmt(sticky, effective, overlap);
    case LAW_COHESION_SJKR:
        return law_pull_sjkr(sticky, r, q, overlap);
    case LAW_COHESION_CAPILLARY:
        return law_pull_capillary(sticky, effective, overlap);
    case LAW_COHESION_VAN_DER_WAALS:
        return law_pull_van_der_waals(sticky, effective, overlap);
    case LAW_COHESION_NONE:
    case LAW_COHESION_JKR:
    case LAW_COHESION_COUNT:
        break;
    }
    return (struct law_pull){0};
}

/* The largest gap at which a cohesion other than JKR acts, length; 0 where there is none, or none beyond touch. */
LAW_INLINE double law_pull_range(enum law_cohesion cohesion, const struct law_sticky *sticky,
                                 double effective) {
    if (cohesion == LAW_COHESION_CAPILLARY)
        return law_bridge_rupture(sticky, 2.0 * effective);
    return cohesion == LAW_COHESION_VAN_DER_WAALS && sticky->hamaker > 0.0 ? sticky->cut_off : 0.0;
}

/* The attraction at an overlap (negative: a gap within the range); its energy only with `energy`, as it may cost more than
 * the force. */
struct law_pull law_cohesion_pull(enum law_cohesion cohesion, const struct law_surfaces *s, double overlap,
                                  bool energy);

/* The largest gap at which two surfaces interact, length: that at which a bridge or an adhesive contact breaks,
 * or an attraction ends. 0 where there is no cohesion, or none beyond touch. */
double law_cohesion_range(const struct law_options *options, const struct law_surfaces *s);

/* The largest pull on the surfaces at rest, force: 3/2 pi W R* of JKR, 2 pi W R* of DMT. */
double law_cohesion_largest(enum law_cohesion cohesion, const struct law_surfaces *s);

#endif
