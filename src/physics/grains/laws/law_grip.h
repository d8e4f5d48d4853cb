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

/* The normal direction of a contact. */
struct law_grip {
    bool interacts; /* false: there is no force, and nothing is remembered */
    bool touches;   /* the surfaces touch: dampers and friction act */
    double force;   /* elastic and cohesive; positive: repulsion */
    double least;   /* the damper may pull no harder than to this force, where it may not pull (end: force) */
    double press;   /* what friction's limit adds to the force */
    double a;       /* contact radius; also law_grip_radius */
    double spring;  /* force of the spring / overlap; of JKR k_n a: sets the damper of a restitution */
    double factor;  /* of a given damping coefficient */
    double tangent; /* d force / d overlap, for the stable step */
    double tangential; /* stiffness of the tangential spring */
    double energy;
};

/* What a contact remembers of the normal direction. */
struct law_past {
    bool held;                   /* the surfaces held to each other one step ago; updated */
    double number[LAW_PAST_MAX]; /* of a law with hysteresis (law_form.h); updated */
    bool no_energy;              /* nobody asks for the energy, which may cost more than the force */
};

/* JKR at the overlap `depth` of spheres with the effective radius `radius`; updates `held`. `s`: law_jkr_length. Arithmetic without
 * branches, as the next one: loops over contacts vectorise (force_grip.h). As a^2/R* = d + s sqrt(a), the force is
 * 2/3 E* a (2 d - s sqrt(a)). The energy counts from a = 0; law_grip_at lets it count from where the contact breaks. */
LAW_INLINE struct law_grip law_grip_jkr(const struct law_coefficients *c, double s, double gamma,
                                        double radius, double depth, enum law_jkr_end end, bool *held) {
    double modulus = law_modulus(c);
    bool holds = depth > 0.0 || (*held && law_jkr_holds(s, radius, depth, end));
    double largest = law_jkr_root(s, radius, depth), root = holds ? largest : 0.0, a = root * root;
    double force = 2.0 / 3.0 * modulus * a * (2.0 * depth - s * root);
    struct law_jkr now = law_jkr_state(modulus, s, radius, root);
    *held = holds;
    return (struct law_grip){.interacts = holds,
                             .touches = holds,
                             .force = force,
                             .least = force < 0.0 ? force : 0.0,
                             .press = holds ? 6.0 * M_PI * gamma * radius : 0.0,
                             .a = a,
                             .spring = c->k_n * a,
                             .factor = a,
                             .tangent = now.tangent,
                             .tangential = c->k_t * a,
                             .energy = now.energy};
}

/* The springs of a law at the overlap, 0 of a gap, and a cohesion other than JKR; updates `held`. */
LAW_INLINE struct law_grip law_grip_join(enum law_cohesion cohesion, const struct law_springs *springs,
                                         const struct law_pull *pull, double range, double overlap,
                                         bool *held) {
    bool touches = overlap > 0.0, remembers = law_cohesion_remembers(cohesion);
    bool near = range > 0.0 && -overlap < range;
    bool holds = touches | (remembers ? *held & near : near);
    double force = touches ? springs->force : 0.0, press = touches ? springs->press : 0.0;
    double attraction = holds ? pull->force : 0.0;
    *held = holds;
    return (struct law_grip){.interacts = holds,
                             .touches = touches,
                             .force = force - attraction,
                             .least = (force < 0.0 ? force : 0.0) - attraction,
                             .press = press + (cohesion == LAW_COHESION_DMT ? 2.0 : 1.0) * attraction,
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

/* True if the contact radius depends on what the contact remembers: necks of JKR, and surfaces that have flowed. */
bool law_grip_radius_recalls(const struct law *law);

/* The contact radius at an overlap (negative: a gap), 0 if the surfaces do not touch. `record`: the contact's record in the
 * history, after this step's forces or before; NULL: it has none. JKR: that of its state, necks under tension included; surfaces
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
