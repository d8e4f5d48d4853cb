/* SPDX-License-Identifier: BSD-3-Clause */
/* The cohesive forces, one function each (law_cohesion.h; docs/physics.md). */
#include "contact/law_cohesion.h"
#include "contact/law_jkr.h"
#include <stddef.h>

/* Derjaguin, Muller and Toporov (1975): 2 pi W R*, W = 2 gamma, while the spheres touch. */
static struct law_pull pull_dmt(const struct law_surfaces *s, double overlap) {
    double force = 4.0 * M_PI * s->extra->surface_energy * s->effective;
    if (!(overlap > 0.0))
        return (struct law_pull){0};
    return (struct law_pull){force, 0.0, -force * overlap};
}

/* Simplified JKR of LIGGGHTS: energy density times the area of the circle in which the spheres intersect. With
 * the distance D of the centres its radius obeys a^2 = (r_i^2 + r_j^2)/2 - D^2/4 - (r_i^2 - r_j^2)^2/(4 D^2). */
static struct law_pull pull_sjkr(const struct law_surfaces *s, double overlap) {
    double density = M_PI * s->extra->cohesion_density, r = s->radius[0], q = s->radius[1];
    if (!(overlap > 0.0))
        return (struct law_pull){0};
    if (isinf(q))
        return (struct law_pull){density * overlap * (2.0 * r - overlap), 2.0 * density * (r - overlap),
                                 -density * overlap * overlap * (r - overlap / 3.0)};
    double distance = r + q - overlap, sum = r * r + q * q, difference = (r - q) * (r + q);
    double odd = difference * difference / (4.0 * distance * distance);
    double touch = r + q, far = difference * difference / (4.0 * touch);
    double within = 0.5 * sum * touch - touch * touch * touch / 12.0 + far;
    double here = 0.5 * sum * distance - distance * distance * distance / 12.0 + odd * distance;
    return (struct law_pull){density * (0.5 * sum - 0.25 * distance * distance - odd),
                             density * (0.5 * distance - 2.0 * odd / distance), -density * (within - here)};
}

static double bridge_volume(const struct law_surfaces *s) {
    double r = 2.0 * s->effective;
    return s->extra->bridge_volume > 0.0 ? s->extra->bridge_volume
                                         : s->extra->bridge_fraction * 4.0 / 3.0 * M_PI * r * r * r;
}

/* Lian, Thornton and Adams (1993): (1 + theta/2) V^(1/3). */
static double bridge_rupture(const struct law_surfaces *s) {
    return (1.0 + 0.5 * s->extra->contact_angle) * cbrt(bridge_volume(s));
}

/* Willett et al. (2000), their closed form for small bridges: 2 pi R gamma cos(theta) / (1 + 1.05 S + 2.5 S^2)
 * with R = 2 R* and S = gap sqrt(R/V). */
static struct law_pull pull_capillary(const struct law_surfaces *s, double overlap, bool energy) {
    double r = 2.0 * s->effective, gap = fmax(-overlap, 0.0), area = 0.0;
    double most = 2.0 * M_PI * r * s->extra->surface_tension * cos(s->extra->contact_angle);
    if (!energy && overlap >= 0.0)
        return (struct law_pull){most, 0.0, 0.0};
    double end = bridge_rupture(s), unit = sqrt(r / bridge_volume(s)), b = 1.05 * unit, c = 2.5 * unit * unit;
    double below = 1.0 + gap * (b + c * gap), root = sqrt(4.0 * c - b * b);
    if (!(gap < end))
        return (struct law_pull){0};
    if (energy)
        area = 2.0 / root * (atan((2.0 * c * end + b) / root) - atan((2.0 * c * gap + b) / root));
    return (struct law_pull){most / below, overlap < 0.0 ? most * (b + 2.0 * c * gap) / (below * below) : 0.0,
                             -most * (area + fmax(overlap, 0.0))};
}

/* Hamaker (1937) for spheres near each other: A R* / (6 gap^2), constant below the least gap. */
static struct law_pull pull_van_der_waals(const struct law_surfaces *s, double overlap) {
    const struct law_extra *e = s->extra;
    double gap = fmax(-overlap, e->gap_least), scale = e->hamaker * s->effective / 6.0;
    if (!(-overlap < e->cut_off))
        return (struct law_pull){0};
    double force = scale / (gap * gap);
    return (struct law_pull){force, -overlap > e->gap_least ? 2.0 * force / gap : 0.0,
                             -scale * (1.0 / gap - 1.0 / e->cut_off) - force * (gap + overlap)};
}

struct law_pull law_cohesion_pull(enum law_cohesion cohesion, const struct law_surfaces *s, double overlap,
                                  bool energy) {
    switch (cohesion) {
    case LAW_COHESION_DMT:
        return pull_dmt(s, overlap);
    case LAW_COHESION_SJKR:
        return pull_sjkr(s, overlap);
    case LAW_COHESION_CAPILLARY:
        return bridge_volume(s) > 0.0 ? pull_capillary(s, overlap, energy) : (struct law_pull){0};
    case LAW_COHESION_VAN_DER_WAALS:
        return pull_van_der_waals(s, overlap);
    case LAW_COHESION_NONE:
    case LAW_COHESION_JKR:
    case LAW_COHESION_COUNT:
        break;
    }
    return (struct law_pull){0};
}

double law_cohesion_range(const struct law_options *options, const struct law_surfaces *s) {
    switch (options->cohesion) {
    case LAW_COHESION_JKR:
        return -law_jkr_end_overlap(law_modulus(s->c), s->extra->surface_energy, s->effective,
                                    options->jkr_end);
    case LAW_COHESION_CAPILLARY:
        return s->extra->surface_tension > 0.0 ? bridge_rupture(s) : 0.0;
    case LAW_COHESION_VAN_DER_WAALS:
        return s->extra->hamaker > 0.0 ? s->extra->cut_off : 0.0;
    case LAW_COHESION_NONE:
    case LAW_COHESION_DMT:
    case LAW_COHESION_SJKR:
    case LAW_COHESION_COUNT:
        break;
    }
    return 0.0;
}

double law_cohesion_largest(enum law_cohesion cohesion, const struct law_surfaces *s) {
    double scale = M_PI * s->extra->surface_energy * s->effective;
    return cohesion == LAW_COHESION_JKR ? 3.0 * scale : cohesion == LAW_COHESION_DMT ? 4.0 * scale : 0.0;
}

/* The range of a pair of materials. */
static double law_pair_range(const struct law *law, int a, int b, double radius_a, double radius_b) {
    const struct law_form *form = law_form_of(&law->options);
    double effective = 1.0 / (1.0 / radius_a + 1.0 / radius_b);
    struct law_surfaces surfaces = {&law->pair[a][b], &law->extra[a][b], {radius_a, radius_b}, effective};
    double range = form->range ? form->range(&law->pair[a][b], radius_a, radius_b) : 0.0;
    return fmax(range, law_cohesion_range(&law->options, &surfaces));
}

double law_range(const struct law *law, double radius_a, double radius_b) {
    double most = law->materials ? 0.0 : -INFINITY;
    if (law->options.cohesion == LAW_COHESION_NONE && law_form_of(&law->options)->range == NULL)
        return most;
    for (int a = 0; a < law->materials; a++)
        for (int b = 0; b <= a; b++)
            most = fmax(most, law_pair_range(law, a, b, radius_a, radius_b));
    return most;
}
