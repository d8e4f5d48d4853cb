/* SPDX-License-Identifier: BSD-3-Clause */
/* The normal direction of a law with parts. Read law_grip.h first. */
#include "contact/law_grip.h"
#include "contact/law_jkr.h"

/* JKR takes the place of Hertz's force, around the dent that plastic flow has left. */
static struct law_grip grip_jkr(const struct law_options *options, const struct law_surfaces *s,
                                double overlap, struct law_past *past) {
    double modulus = law_modulus(s->c), gamma = s->extra->surface_energy;
    const struct law_form *form = law_form_of(options);
    struct law_flat flat = {s->effective, 0.0};
    if (form->flatten) {
        past->number[0] = fmax(past->number[0], overlap);
        flat = form->flatten(s->c, s->extra, s->effective, past->number[0]);
    }
    double depth = overlap - flat.left;
    past->held = depth > 0.0 ||
                 (past->held && depth > law_jkr_end_overlap(modulus, gamma, flat.radius, options->jkr_end));
    if (!past->held) /* a dent is remembered as long as the spheres overlap */
        return (struct law_grip){.interacts = overlap > 0.0};
    double a = law_jkr_radius(modulus, gamma, flat.radius, depth), left = 0.0;
    struct law_jkr now = law_jkr_at(modulus, gamma, flat.radius, a);
    if (!past->no_energy) {
        double last = law_jkr_end_radius(modulus, gamma, flat.radius, options->jkr_end);
        left = law_jkr_at(modulus, gamma, flat.radius, last).energy;
    }
    return (struct law_grip){.interacts = true,
                             .touches = true,
                             .force = now.force,
                             .least = fmin(now.force, 0.0),
                             .press = 6.0 * M_PI * gamma * flat.radius,
                             .a = a,
                             .spring = s->c->k_n * a,
                             .factor = a,
                             .tangent = now.tangent,
                             .tangential = s->c->k_t * a,
                             .energy = now.energy - fmin(left, 0.0)};
}

struct law_grip law_grip_at(const struct law_options *options, const struct law_surfaces *s, double overlap,
                            struct law_past *past) {
    struct law_grip grip = {0};
    if (options->cohesion == LAW_COHESION_JKR && s->extra->surface_energy > 0.0)
        return grip_jkr(options, s, overlap, past);
    bool remembers = law_cohesion_remembers(options->cohesion), touches = overlap > 0.0;
    past->held = touches || ((past->held || !remembers) && -overlap < law_cohesion_range(options, s));
    if (!past->held)
        return grip;
    if (touches) {
        const struct law_form *form = law_form_of(options);
        struct law_springs springs = form->unload
                                         ? form->unload(s->c, s->extra, s->effective, overlap, past->number)
                                         : law_springs_of(options, s->c, s->extra, s->effective, overlap);
        grip = (struct law_grip){.force = springs.force,
                                 .press = springs.press,
                                 .a = sqrt(s->effective * overlap),
                                 .spring = springs.stiffness,
                                 .factor = springs.contact,
                                 .tangent = springs.tangent,
                                 .tangential = springs.tangential,
                                 .energy = springs.energy};
    }
    struct law_pull pull = law_cohesion_pull(options->cohesion, s, overlap, !past->no_energy);
    grip.interacts = true;
    grip.touches = touches;
    grip.least = fmin(grip.force, 0.0) - pull.force;
    grip.force -= pull.force;
    grip.press += options->cohesion == LAW_COHESION_DMT ? 2.0 * pull.force : pull.force;
    grip.tangent -= pull.slope;
    grip.energy += pull.energy;
    return grip;
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
