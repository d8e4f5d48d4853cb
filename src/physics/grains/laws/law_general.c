/* SPDX-License-Identifier: BSD-3-Clause */
/* A contact of a law with parts. Read law_general.h first. */
#include "physics/grains/laws/law_general.h"
#include "physics/grains/laws/law_resist.h"
#include <string.h>

/* Energy lost as a bridge or an adhesive contact forms: at touch its energy jumps from 0 to that of the pull. A contact that
 * has no record, and overlapped one step ago, was there at the start of the run. */
static double forming_loss(const struct law *law, const struct law_surfaces *surfaces, double overlap,
                           double growth, const struct law_past *before) {
    if (law->memory.held < 0 || before->held || !(overlap > 0.0) || overlap - growth > 0.0)
        return 0.0;
    return -law_grip_at(&law->options, surfaces, 0.0, &(struct law_past){.held = true}).energy;
}

/* Energy lost by plastic flow in this step, or as the contact forms: the work of the elastic force less what it stores
 * more. */
static double grip_loss(const struct law *law, const struct law_surfaces *surfaces,
                        const struct law_grip *now, double overlap, double growth, struct law_past past) {
    if (law->memory.past < 0)
        return forming_loss(law, surfaces, overlap, growth, &past);
    if (!now->touches)
        return 0.0;
    struct law_grip before = law_grip_at(&law->options, surfaces, overlap - growth, &past);
    return 0.5 * (now->force + before.force) * growth - (now->energy - before.energy);
}

static void past_put(const struct law *law, const struct law_past *past, double *value) {
    if (law->memory.held >= 0)
        value[law->memory.held] = past->held ? 1.0 : 0.0;
    for (int k = 0; law->memory.past >= 0 && k < law_form_of(&law->options)->remembers; k++)
        value[law->memory.past + k] = past->number[k];
}

bool law_general_push(const struct law *law, struct law_step step, struct law_general *in,
                      struct law_push *push) {
    const struct law_options *options = &law->options;
    const struct law_contact *contact = &in->contact;
    struct law_surfaces surfaces = {
        &contact->coefficients, in->extra, {in->radius[0], in->radius[1]}, contact->radius};
    struct law_past past = law_grip_past(law, in->value);
    past.no_energy = !step.energies;
    struct law_past before = past;
    struct law_grip grip = law_grip_at(options, &surfaces, contact->overlap, &past);
    if (!grip.interacts) {
        memset(in->value, 0, sizeof in->value);
        *push = (struct law_push){0};
        return false;
    }
    past_put(law, &past, in->value);
    *push = law_push_of(law_manner_of(options, options->cohesion), &grip, contact->coefficients.c_n,
                        contact->mass, law_dot(contact->velocity, contact->normal));
    if (step.energies) {
        double rate = law_dot(contact->velocity, contact->normal);
        push->taken = (grip.force - push->force) * rate * step.dt +
                      grip_loss(law, &surfaces, &grip, contact->overlap, -rate * step.dt, before);
    }
    return true;
}

bool law_general_respond(const struct law *law, struct law_step step, struct law_general *in,
                         struct law_response *out) {
    const struct law_contact *contact = &in->contact;
    struct law_push push;
    *out = (struct law_response){0};
    if (!law_general_push(law, step, in, &push))
        return false;
    out->force = law_scale(push.force, contact->normal);
    if (step.energies) {
        out->normal_energy = push.grip.energy;
        out->taken = push.taken;
    }
    if (law->spin)
        law_resist(law, step, in, &(struct law_hold){&push.grip, push.press, push.base}, out);
    return true;
}

struct law_stiff law_general_stiff(const struct law *law, const struct law_surfaces *surfaces, double mass,
                                   double overlap) {
    const struct law_options *options = &law->options;
    struct law_grip grip = law_grip_at(options, surfaces, overlap, &(struct law_past){.held = true});
    double base = law_damper_base(law_manner_of(options, options->cohesion), &grip, mass);
    struct law_stiff stiff = {.k_n = fmax(grip.tangent, 0.0), .c_n = surfaces->c->c_n * base};
    if (law->spin && grip.touches)
        law_resist_stiff(law, surfaces, &(struct law_hold){&grip, 0.0, base}, mass, &stiff);
    return stiff;
}
