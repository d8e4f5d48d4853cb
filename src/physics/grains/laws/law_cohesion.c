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

double law_cohesion_range(const struct law_options *options, const struct law_surfaces *s) {
    const union law_sticky sticky = law_sticky_of(options->cohesion, s->c, s->extra);
#define CASE(NAME, name, with, summary)                                                                      \
    if (options->cohesion == LAW_COHESION_##NAME)                                                            \
        return cohesion_##name##_range(&sticky.name, s->effective);
    LAW_PULL_TABLE(CASE)
#undef CASE
#define CASE(NAME, name, with, summary)                                                                      \
    if (options->cohesion == LAW_COHESION_##NAME)                                                            \
        return cohesion_##name##_range(&sticky.name, s->c, s->effective, options->jkr_end);
    LAW_ADHESION_TABLE(CASE)
#undef CASE
    return 0.0;
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

/* The range of a pair of materials. */
static double law_pair_range(const struct law *law, int a, int b, double radius_a, double radius_b) {
    const struct law_form *form = law_form_of(&law->options);
    double effective = 1.0 / (1.0 / radius_a + 1.0 / radius_b);
    struct law_surfaces surfaces = {
        law_pair_of(law, a, b), law_extra_of(law, a, b), {radius_a, radius_b}, effective};
    double range = form->range ? form->range(law_pair_of(law, a, b), radius_a, radius_b) : 0.0;
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
