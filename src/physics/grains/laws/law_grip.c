/* SPDX-License-Identifier: BSD-3-Clause */
/* The normal direction of a law with parts. Read law_grip.h first. */
#include "physics/grains/laws/law_grip.h"

/* JKR takes the place of Hertz's force, around the dent that plastic flow has left, which is remembered as long as the
 * spheres overlap. */
static struct law_grip grip_jkr(const struct law_options *options, const struct law_surfaces *s,
                                double overlap, struct law_past *past) {
    double modulus = law_modulus(s->c), gamma = s->extra->surface_energy;
    const struct law_form *form = law_form_of(options);
    struct law_flat flat = {s->effective, 0.0};
    if (form->flatten) {
        past->number[0] = fmax(past->number[0], overlap);
        flat = form->flatten(s->c, s->extra, s->effective, past->number[0]);
    }
    struct law_grip grip = law_grip_jkr(s->c, law_jkr_length(modulus, gamma), gamma, flat.radius,
                                        overlap - flat.left, options->jkr_end, &past->held);
    if (!past->held)
        return (struct law_grip){.interacts = overlap > 0.0};
    if (!past->no_energy) { /* counts from where the contact breaks, and nothing is left there */
        double last = law_jkr_end_radius(modulus, gamma, flat.radius, options->jkr_end);
        grip.energy -= law_jkr_at(modulus, gamma, flat.radius, last).energy;
    }
    return grip;
}

/* JKR takes the place of the force at touch. */
static bool is_jkr(const struct law_options *options, const struct law_surfaces *s) {
    return options->cohesion == LAW_COHESION_JKR &&
           (law_form_of(options)->flatten == NULL || s->extra->surface_energy > 0.0);
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
    if (is_jkr(options, s))
        return grip_jkr(options, s, overlap, past);
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
    return law->options.cohesion == LAW_COHESION_JKR || law_form_of(&law->options)->flatten != NULL;
}

double law_grip_radius(const struct law *law, const struct law_surfaces *s, double overlap,
                       const double *record) {
    struct law_past past = {0};
    if (record && law->general)
        past = law_grip_past(law, record);
    past.no_energy = true;
    if (is_jkr(&law->options, s))
        return grip_jkr(&law->options, s, overlap, &past).a;
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
