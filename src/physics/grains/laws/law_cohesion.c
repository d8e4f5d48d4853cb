/* SPDX-License-Identifier: BSD-3-Clause */
/* The cohesive forces, one function each (law_cohesion.h; docs/physics.md). */
#include "physics/grains/laws/law_cohesion.h"
#include <stddef.h>

/* The integral of the force of simplified JKR from the touch to the overlap. */
static double energy_sjkr(const struct law_surfaces *s, double overlap) {
    double density = M_PI * s->extra->cohesion_density, r = s->radius[0], q = s->radius[1];
    if (isinf(q))
        return -density * overlap * overlap * (r - overlap / 3.0);
    double distance = r + q - overlap, sum = r * r + q * q, difference = (r - q) * (r + q);
    double odd = difference * difference / (4.0 * distance * distance);
    double touch = r + q, far = difference * difference / (4.0 * touch);
    double within = 0.5 * sum * touch - touch * touch * touch / 12.0 + far;
    double here = 0.5 * sum * distance - distance * distance * distance / 12.0 + odd * distance;
    return -density * (within - here);
}

/* The integral of a bridge's force from its rupture to the gap, and on to the overlap. */
static double energy_capillary(const struct law_sticky *sticky, double effective, double overlap) {
    double r = 2.0 * effective, gap = fmax(-overlap, 0.0), end = law_bridge_rupture(sticky, r);
    double unit = sqrt(r / law_bridge_volume(sticky, r)), b = 1.05 * unit, c = 2.5 * unit * unit;
    double root = sqrt(4.0 * c - b * b);
    double area = 2.0 / root * (atan((2.0 * c * end + b) / root) - atan((2.0 * c * gap + b) / root));
    return -sticky->tension * r * (area + fmax(overlap, 0.0));
}

static double energy_van_der_waals(const struct law_sticky *sticky, double effective, double overlap) {
    double gap = fmax(-overlap, sticky->gap_least), scale = sticky->hamaker * effective / 6.0;
    return -scale * (1.0 / gap - 1.0 / sticky->cut_off) - scale / (gap * gap) * (gap + overlap);
}

static double pull_energy(enum law_cohesion cohesion, const struct law_sticky *sticky,
                          const struct law_surfaces *s, double force, double overlap) {
    switch (cohesion) {
    case LAW_COHESION_DMT:
        return -force * overlap;
    case LAW_COHESION_SJKR:
        return energy_sjkr(s, overlap);
    case LAW_COHESION_CAPILLARY:
        return energy_capillary(sticky, s->effective, overlap);
    case LAW_COHESION_VAN_DER_WAALS:
        return energy_van_der_waals(sticky, s->effective, overlap);
    case LAW_COHESION_NONE:
    case LAW_COHESION_JKR:
    case LAW_COHESION_COUNT:
        break;
    }
    return 0.0;
}

struct law_pull law_cohesion_pull(enum law_cohesion cohesion, const struct law_surfaces *s, double overlap,
                                  bool energy) {
    struct law_sticky sticky = law_sticky_of(cohesion, s->c, s->extra);
    struct law_pull pull = law_pull_at(cohesion, &sticky, s->radius[0], s->radius[1], s->effective, overlap);
    if (energy && pull.force > 0.0)
        pull.energy = pull_energy(cohesion, &sticky, s, pull.force, overlap);
    return pull;
}

/* The range of surfaces with these numbers; it grows with each. */
static double range_of(const struct law_options *options, const struct law_sticky *sticky, double effective) {
    if (options->cohesion == LAW_COHESION_JKR)
        return law_jkr_end_gap(sticky->length, effective, options->jkr_end);
    return law_pull_range(options->cohesion, sticky, effective);
}

double law_cohesion_range(const struct law_options *options, const struct law_surfaces *s) {
    struct law_sticky sticky = law_sticky_of(options->cohesion, s->c, s->extra);
    return range_of(options, &sticky, s->effective);
}

double law_cohesion_largest(enum law_cohesion cohesion, const struct law_surfaces *s) {
    double scale = M_PI * s->extra->surface_energy * s->effective;
    return cohesion == LAW_COHESION_JKR ? 3.0 * scale : cohesion == LAW_COHESION_DMT ? 4.0 * scale : 0.0;
}

double law_range_of(const struct law *law, int a, int b, double radius_a, double radius_b) {
    return range_of(&law->options, law_sticky_at(law, a, b), 1.0 / (1.0 / radius_a + 1.0 / radius_b));
}

double law_range(const struct law *law, double radius_a, double radius_b) {
    if (law->materials == 0)
        return -INFINITY;
    return range_of(&law->options, &law->farthest, 1.0 / (1.0 / radius_a + 1.0 / radius_b));
}
