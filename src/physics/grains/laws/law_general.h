/* SPDX-License-Identifier: BSD-3-Clause */
/* A contact of a law with parts (law_parts.h): one contact in, forces and torques out, as law_respond of
 * law_kernel.h, whose signs hold here, too. One function for all parts, with branches; force_general.c calls
 * it for each contact of a batch. */
#ifndef SCREE_LAWS_LAW_GENERAL_H
#define SCREE_LAWS_LAW_GENERAL_H

#include "physics/grains/laws/law_grip.h"

/* The normal direction of a contact. */
struct law_push {
    struct law_grip grip;
    double force; /* normal, with the damper */
    double base;  /* the damper's coefficient over c_n */
    double press; /* the force that limits of friction are multiples of */
    double taken; /* work taken in this step, by the damper and by plastic flow; if energies are asked for */
};

/* What the push takes of the options. */
struct law_manner {
    enum law_base base;
    double tangent; /* of the law's form */
    bool least,
        fixed; /* the damper may pull no harder than the grip; friction's limit counts the grip, not the damper */
};

/* `cohesion`: that of the options, a constant in a loop that is specialised for it. */
LAW_INLINE struct law_manner law_manner_of(const struct law_options *options, enum law_cohesion cohesion) {
    return (struct law_manner){.base = law_damping_form_of(options->damping)->base,
                               .tangent = law_form_of(options)->tangent,
                               .least = options->end == LAW_END_FORCE,
                               .fixed = law_cohesion_form_of(cohesion)->fixed};
}

/* The damper's coefficient over c_n: the base of all dampers. */
LAW_INLINE double law_damper_base(struct law_manner manner, const struct law_grip *grip, double mass) {
    double root = sqrt(mass * grip->spring);
    double of_spring = manner.tangent * grip->spring; /* A dF/dd of the spring alone */
    double base = manner.base == LAW_BASE_MASS    ? mass * grip->factor
                  : manner.base == LAW_BASE_SLOPE ? of_spring
                                                  : root;
    return grip->touches ? base : 0.0;
}

/* The normal direction with its damper; without branches. `taken` is left empty. */
LAW_INLINE struct law_push law_push_of(struct law_manner manner, const struct law_grip *grip, double c_n,
                                       double mass, double rate) {
    struct law_push push = {.grip = *grip, .base = law_damper_base(manner, grip, mass)};
    double damped = grip->force - c_n * push.base * rate;
    push.force = manner.least && damped < grip->least ? grip->least : damped;
    push.press = fabs((manner.fixed ? grip->force : push.force) + grip->press);
    return push;
}

/* The normal direction alone: as law_general_respond, which calls it; updates what the contact remembers of it. */
bool law_general_push(const struct law *law, struct law_step step, struct law_general *in,
                      struct law_push *push);

/* Forces and torques of the contact; false if the surfaces do not interact: then all results and `value` are 0. */
bool law_general_respond(const struct law *law, struct law_step step, struct law_general *in,
                         struct law_response *out);

/* Springs and dampers of a contact for small changes. */
struct law_stiff law_general_stiff(const struct law *law, const struct law_surfaces *surfaces, double mass,
                                   double overlap);

#endif
