/* SPDX-License-Identifier: BSD-3-Clause */
/* The normal direction of a contact of a law with parts: the elastic force and cohesion. */
#ifndef SCREE_LAWS_LAW_GRIP_H
#define SCREE_LAWS_LAW_GRIP_H

#include "physics/grains/laws/law_cohesion.h"
#include "physics/grains/laws/law_kernel.h"

/* A contact; `contact.spring` and `contact.roll` are not read: springs are in `value`. */
struct law_general {
    struct law_contact contact;
    const struct law_extra *extra;
    double radius[2];             /* of both surfaces; a wall's is infinite */
    double value[LAW_MEMORY_MAX]; /* in: the contact's history, 0 for a new one; out: the new one */
};

/* What a contact remembers of the normal direction. */
struct law_past {
    bool held;                   /* the surfaces held to each other one step ago; updated */
    double number[LAW_PAST_MAX]; /* of a law with hysteresis (law_form.h); updated */
    bool no_energy;              /* nobody asks for the energy, which may cost more than the force */
};

/* The springs of a law at the overlap, 0 of a gap, and a cohesion that pulls beside them; updates `held`. Arithmetic without branches: a loop
 * over contacts that calls it, with `cohesion` a constant, vectorises (force_grip.h). */
LAW_INLINE struct law_grip law_grip_join(enum law_cohesion cohesion, const struct law_springs *springs,
                                         const struct law_pull *pull, double range, double overlap,
                                         bool *held) {
    const struct law_cohesion_form *form = law_cohesion_form_of(cohesion);
    bool touches = overlap > 0.0, remembers = form->remembers;
    bool near = -overlap < range; /* range is 0 without one: then the surfaces touch */
    bool holds = touches | (remembers ? *held & near : near);
    double force = touches ? springs->force : 0.0, press = touches ? springs->press : 0.0;
    double attraction = holds ? pull->force : 0.0;
    *held = holds;
    return (struct law_grip){.interacts = holds,
                             .touches = touches,
                             .force = force - attraction,
                             .least = (force < 0.0 ? force : 0.0) - attraction,
                             .press = press + form->press * attraction,
                             .spring = touches ? springs->stiffness : 0.0,
                             .factor = springs->contact,
                             .tangent = (touches ? springs->tangent : 0.0) - pull->slope,
                             .tangential = springs->tangential,
                             .energy = (touches ? springs->energy : 0.0) + pull->energy};
}

/* The normal direction at an overlap (negative: a gap); updates `past`. */
struct law_grip law_grip_at(const struct law_options *options, const struct law_surfaces *surfaces,
                            double overlap, struct law_past *past);

/* What a contact remembers of the normal direction, from its record in the history. */
LAW_INLINE struct law_past law_grip_past(const struct law *law, const double *value) {
    struct law_past past = {.held = law->memory.held >= 0 && value[law->memory.held] != 0.0};
    for (int k = 0; law->memory.past >= 0 && k < law_form_of(&law->options)->remembers; k++)
        past.number[k] = value[law->memory.past + k];
    return past;
}

/* True if the contact radius depends on what the contact remembers: necks of an adhesion, and surfaces that have flowed. */
bool law_grip_radius_recalls(const struct law *law);

/* The contact radius at an overlap (negative: a gap), 0 if the surfaces do not touch. `record`: the contact's record in the
 * history, after this step's forces or before; NULL: it has none. An adhesion: that of its state, necks under tension included; surfaces
 * that have flowed: that of the flattened spheres; every other law and cohesion: sqrt(R* overlap). Any thread. */
double law_grip_radius(const struct law *law, const struct law_surfaces *surfaces, double overlap,
                       const double *record);

/* The overlap at which the elastic force and cohesion cancel, length; 0 without cohesion. */
double law_grip_rest(const struct law_options *options, const struct law_surfaces *surfaces);

/* Springs and dampers of a contact for small changes. */
struct law_stiff {
    double k_n, k_t, k_r, k_w; /* normal, tangential, rolling: force/length; twisting: torque/rad */
    double c_n, c_t, c_r, c_w; /* the dampers: the same times time */
};

#endif
