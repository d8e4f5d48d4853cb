/* SPDX-License-Identifier: BSD-3-Clause */
/* The normal direction of a law with parts. Read law_grip.h first. */
#include "physics/grains/laws/law_grip.h"

/* An adhesion takes the place of the law's force, around the dent that plastic flow has left, which is remembered as long as the
 * spheres overlap. */
static struct law_grip grip_adhesion(const struct law_options *options, const union law_sticky *sticky,
                                     const struct law_surfaces *s, double overlap, struct law_past *past) {
    const struct law_form *form = law_form_of(options);
    struct law_flat flat = {s->effective, 0.0};
    if (form->flatten) {
        past->number[0] = fmax(past->number[0], overlap);
        flat = form->flatten(s->c, s->extra, s->effective, past->number[0]);
    }
    struct law_grip grip =
        law_adhesion_grip(options, sticky, s->c, flat.radius, overlap - flat.left, &past->held);
    if (!past->held)
        return (struct law_grip){.interacts = overlap > 0.0};
    if (!past->no_energy) /* counts from where the contact breaks, and nothing is left there */
        grip.energy -= law_adhesion_last(options, sticky, s->c, flat.radius);
    return grip;
}

/* True if an adhesion takes the place of the force at touch; its numbers. */
static bool adheres(const struct law_options *options, const struct law_surfaces *s,
                    union law_sticky *sticky) {
    if (!law_adheres(options->cohesion))
        return false;
    *sticky = law_sticky_of(options->cohesion, s->c, s->extra);
    return law_form_of(options)->flatten == NULL || law_adhesion_sticks(options->cohesion, sticky);
}

/* The contact radius of spheres that do not stick, after the largest overlap that they remember. */
static double radius_of(const struct law_form *form, const struct law_surfaces *s, double overlap,
                        const struct law_past *past) {
    struct law_flat flat = {s->effective, 0.0};
    if (form->flatten)
        flat = form->flatten(s->c, s->extra, s->effective, fmax(past->number[0], overlap));
    return sqrt(flat.radius * fmax(overlap - flat.left, 0.0));
}

struct law_grip law_grip_at(const struct law_options *options, const struct law_surfaces *s, double overlap,
                            struct law_past *past) {
    const struct law_form *form = law_form_of(options);
    struct law_springs springs = {0};
    union law_sticky sticky;
    if (adheres(options, s, &sticky))
        return grip_adhesion(options, &sticky, s, overlap, past);
    if (overlap > 0.0)
        springs = form->unload ? form->unload(s->c, s->extra, s->effective, overlap, past->number)
                               : law_springs_of(options, s->c, s->extra, s->effective, overlap);
    struct law_pull pull = {0};
    double range = 0.0;
    if (options->cohesion != LAW_COHESION_NONE) {
        pull = law_cohesion_pull(options->cohesion, s, overlap, !past->no_energy);
        range = law_cohesion_range(options, s);
    }
    struct law_grip grip = law_grip_join(options->cohesion, &springs, &pull, range, overlap, &past->held);
    if (!past->held)
        return (struct law_grip){0};
    grip.a = radius_of(form, s, fmax(overlap, 0.0), past);
    return grip;
}

bool law_grip_radius_recalls(const struct law *law) {
    return law_adheres(law->options.cohesion) || law_form_of(&law->options)->flatten != NULL;
}

double law_grip_radius(const struct law *law, const struct law_surfaces *s, double overlap,
                       const double *record) {
    struct law_past past = {0};
    if (record && law->general)
        past = law_grip_past(law, record);
    past.no_energy = true;
    union law_sticky sticky;
    if (adheres(&law->options, s, &sticky))
        return grip_adhesion(&law->options, &sticky, s, overlap, &past).a;
    return overlap > 0.0 ? radius_of(law_form_of(&law->options), s, overlap, &past) : 0.0;
}

double law_grip_rest(const struct law_options *options, const struct law_surfaces *surfaces) {
    double low = 0.0, high = surfaces->effective;
    if (options->cohesion == LAW_COHESION_NONE && surfaces->extra->pull_off == 0.0)
        return 0.0;
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high);
        if (law_grip_at(options, surfaces, middle, &(struct law_past){.held = true}).force < 0.0)
            low = middle;
        else
            high = middle;
    }
    return low;
}
