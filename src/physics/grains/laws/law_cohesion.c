/* SPDX-License-Identifier: BSD-3-Clause */
/* What the rows of cohesions do, chosen by the options. Read law_cohesion.h first. */
#include "physics/grains/laws/law_cohesion.h"

struct law_pull law_cohesion_pull(enum law_cohesion cohesion, const struct law_surfaces *s, double overlap,
                                  bool energy) {
    const union law_sticky sticky = law_sticky_of(cohesion, s->c, s->extra);
    const struct law_radii radii = {s->radius[0], s->radius[1], s->effective};
    struct law_pull pull = {0};
#define CASE(NAME, name, with, summary)                                                                      \
    if (cohesion == LAW_COHESION_##NAME) {                                                                   \
        pull = cohesion_##name##_pull(&sticky.name, &radii, overlap);                                        \
        if (energy && pull.force > 0.0)                                                                      \
            pull.energy = cohesion_##name##_energy(&sticky.name, &radii, overlap);                           \
    }
    LAW_PULL_TABLE(CASE)
#undef CASE
    return pull;
}

/* The range of surfaces with these numbers; it is no less for larger ones. */
static double range_of(const struct law_options *options, const union law_sticky *sticky, double effective) {
#define CASE(NAME, name, with, summary)                                                                      \
    if (options->cohesion == LAW_COHESION_##NAME)                                                            \
        return cohesion_##name##_range(&sticky->name, effective);
    LAW_PULL_TABLE(CASE)
#undef CASE
#define CASE(NAME, name, with, summary)                                                                      \
    if (options->cohesion == LAW_COHESION_##NAME)                                                            \
        return cohesion_##name##_range(&sticky->name, effective, options->jkr_end);
    LAW_ADHESION_TABLE(CASE)
#undef CASE
    return 0.0;
}

double law_cohesion_range(const struct law_options *options, const struct law_surfaces *s) {
    const union law_sticky sticky = law_sticky_of(options->cohesion, s->c, s->extra);
    return range_of(options, &sticky, s->effective);
}

bool law_adhesion_sticks(enum law_cohesion cohesion, const union law_sticky *sticky) {
#define CASE(NAME, name, with, summary)                                                                      \
    if (cohesion == LAW_COHESION_##NAME)                                                                     \
        return cohesion_##name##_sticks(&sticky->name);
    LAW_ADHESION_TABLE(CASE)
#undef CASE
    return false;
}

struct law_grip law_adhesion_grip(const struct law_options *options, const union law_sticky *sticky,
                                  const struct law_coefficients *c, double radius, double depth, bool *held) {
#define CASE(NAME, name, with, summary)                                                                      \
    if (options->cohesion == LAW_COHESION_##NAME)                                                            \
        return cohesion_##name##_grip(&sticky->name, c, radius, depth, options->jkr_end, held);
    LAW_ADHESION_TABLE(CASE)
#undef CASE
    return (struct law_grip){0};
}

double law_adhesion_last(const struct law_options *options, const union law_sticky *sticky,
                         const struct law_coefficients *c, double radius) {
#define CASE(NAME, name, with, summary)                                                                      \
    if (options->cohesion == LAW_COHESION_##NAME)                                                            \
        return cohesion_##name##_last(&sticky->name, c, radius, options->jkr_end);
    LAW_ADHESION_TABLE(CASE)
#undef CASE
    return 0.0;
}

double law_range_of(const struct law *law, int a, int b, double radius_a, double radius_b) {
    return range_of(&law->options, law_sticky_at(law, a, b), 1.0 / (1.0 / radius_a + 1.0 / radius_b));
}

double law_range(const struct law *law, double radius_a, double radius_b) {
    if (law->materials == 0)
        return -INFINITY;
    return range_of(&law->options, &law->widest, 1.0 / (1.0 / radius_a + 1.0 / radius_b));
}
