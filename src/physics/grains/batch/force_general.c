/* SPDX-License-Identifier: BSD-3-Clause */
/* A batch of contacts of a law with parts. Read force_general.h first. */
#include "physics/grains/batch/force_general.h"
#include "physics/grains/laws/law_general.h"
#include <string.h>

_Static_assert((int)LAW_MEMORY_MAX <= (int)HISTORY_COMPONENTS_MAX, "a law remembers more than history holds");

static struct law_vector vector_of(const double row[3][FORCE_BATCH], int k) {
    return (struct law_vector){row[0][k], row[1][k], row[2][k]};
}

static void vector_set(double row[3][FORCE_BATCH], int k, struct law_vector v) {
    row[0][k] = v.x;
    row[1][k] = v.y;
    row[2][k] = v.z;
}

/* What the normal direction of contact k needs. */
static void contact_take(const struct law *law, const struct force_batch *b, int k, struct law_general *in) {
    double ri = b->walk.radius[0][k], rj = b->walk.radius[1][k];
    in->contact.overlap = b->overlap[k];
    in->contact.mass = b->mass[k];
    in->contact.radius = isinf(rj) ? ri : ri * rj / (ri + rj);
    in->contact.normal = vector_of(b->normal, k);
    in->contact.velocity = vector_of(b->velocity, k);
    in->contact.coefficients = force_coefficients_of(b, k);
    in->extra = b->extra[k];
    in->radius[0] = ri;
    in->radius[1] = rj;
    for (int c = 0; c < law->history_components; c++)
        in->value[c] = b->walk.history[c][k];
}

void force_general_respond(const struct law *law, struct law_step step, struct force_batch *b, int count) {
    struct law_general in = {0};
    for (int k = 0; k < count; k++) {
        struct law_response out;
        contact_take(law, b, k, &in);
        if (law->spin) {
            in.contact.half_normal = vector_of(b->half_normal, k);
            in.contact.surface = vector_of(b->surface, k);
            in.contact.spin = vector_of(b->spin, k);
        }
        b->active[k] = law_general_respond(law, step, &in, &out);
        vector_set(b->walk.out + FORCE_OUT, k, out.force);
        vector_set(b->walk.out + FORCE_MOMENT, k, out.moment);
        vector_set(b->walk.out + FORCE_ROLLING, k, out.rolling);
        b->energy[0][k] = out.normal_energy;
        b->energy[1][k] = out.spring_energy;
        b->energy[2][k] = out.taken;
        for (int c = 0; c < law->history_components; c++)
            b->walk.history[c][k] = in.value[c];
    }
}

/* The normal direction of a law that rubs, one contact after another. */
static void grip_each(const struct law *law, struct law_step step, struct force_batch *b, int count) {
    struct law_general in = {0};
    for (int k = 0; k < count; k++) {
        struct law_push push;
        contact_take(law, b, k, &in);
        b->springs[5][k] = law_general_push(law, step, &in, &push) ? 1.0 : 0.0;
        b->effective[k] = in.contact.radius;
        b->springs[0][k] = push.force;
        b->springs[1][k] = push.base;
        b->springs[2][k] = push.grip.tangential;
        b->springs[3][k] = push.press;
        b->springs[4][k] = push.grip.touches ? 1.0 : 0.0;
        for (int c = law->history_odd; c < law->history_components; c++)
            b->walk.history[c][k] = in.value[c];
    }
}

void force_general_rub(const struct law *law, struct law_step step, struct force_thread *thread) {
    struct force_batch *b = &thread->batch;
    step.energies = false;
    if (thread->grip)
        thread->grip(law, b);
    else
        grip_each(law, step, b, b->walk.padded);
    for (int k = 0; k < b->walk.padded; k++)
        b->active[k] = b->springs[5][k] > 0.0;
    thread->kernel->rub(&law->options, b, step);
}

/* LAMMPS's slip of pair_style granular: the radii are the levers. */
static void slip_lammps(struct force_batch *b, int k) {
    const double *omega = b->walk.gathered[0][k], ri = b->walk.radius[0][k], rj = b->walk.radius[1][k];
    vector_set(b->surface, k,
               (struct law_vector){ri * omega[0] + rj * omega[4], ri * omega[1] + rj * omega[5],
                                   ri * omega[2] + rj * omega[6]});
}

void force_general_compute(const struct walk_task *task, struct walk_batch *batch) {
    const struct force_context *context = task->work->context;
    const struct law *law = context->law;
    struct force_thread *thread = (struct force_thread *)batch;
    struct force_batch *b = &thread->batch;
    thread->measure(b, thread->step);
    if (!law->uniform)
        thread->kernel->mix(law, thread->material, b);
    for (int k = 0; law->options.lammps_granular && law->spin && k < batch->padded; k++)
        slip_lammps(b, k);
    struct law_step step = law_general_step(&law->options, context->dt);
    step.energies = thread->energies;
    if (thread->rubs)
        force_general_rub(law, step, thread);
    else
        force_general_respond(law, step, b, batch->padded);
}

void force_general_note(const struct walk_task *task, struct walk_batch *batch) {
    const struct force_context *context = task->work->context;
    struct force_thread *thread = (struct force_thread *)batch;
    const bool *active = thread->batch.active;
    unsigned sides = 0;
#pragma omp simd reduction(+ : sides)
    for (int k = 0; k < batch->count; k++)
        sides += active[k] ? 2u : 0u;
#pragma omp simd reduction(+ : sides)
    for (int k = batch->both; k < batch->one; k++)
        sides -= active[k] ? 1u : 0u;
    thread->sums.contact_sides += sides;
    thread->kernel->account(context, thread);
    if (thread->energies && context->pair_work)
        force_put_work(task, &thread->batch);
}
