/* SPDX-License-Identifier: BSD-3-Clause */
/* The one computation of contacts: a batch through the law (force_kernel.h), and a batch of pairs before and after. Compiled once
 * for each instruction set, under the name that FORCE_KERNEL gives. Read kernel/pairs/walk.h first. */
#include "physics/grains/batch/force_account.h"
#include "physics/grains/batch/force_general.h"
#include "physics/grains/batch/force_grip.h"
#include "physics/grains/batch/force_kernel.h"
#include "physics/grains/batch/force_physics.h"
#include "physics/grains/batch/force_resist.h"
#include "physics/grains/laws/law_general.h"
#include "physics/grains/laws/law_user.h"
#include "kernel/particles/material.h"

/* Fills what contact k takes of the materials p and q. */
static inline void force_set_materials(const struct law *law, struct force_batch *b, int k, int p, int q) {
    const struct law_extra *extra = law_extra_of(law, p, q);
    force_set_coefficients(b, k, law_pair_of(law, p, q));
    for (int n = 0; law->options.user && n < law->options.user->law->parameters; n++)
        b->parameter[n][k] = extra->parameter[n];
    force_set_resistances(b, k, &law->options, extra);
    if (!law->general)
        return;
    b->extra[k] = extra;
    force_set_sticky(b, k, law->options.cohesion, law_sticky_at(law, p, q));
    if (law->memory.past >= 0)
        force_set_branch(b, k, extra);
}

/* True if all contacts of the batch are between the same two materials, in the same order. */
static inline bool force_alike(const struct force_batch *restrict b) {
    const uint8_t *p = b->material[0], *q = b->material[1];
    const int middle = b->walk.count / 2, last = b->walk.count - 1;
    if (p[middle] != p[0] || q[middle] != q[0] || p[last] != p[0] || q[last] != q[0])
        return false; /* mixed materials mostly end here */
    int other = 0;
    for (int k = 0; k < b->walk.padded; k++)
        other |= (p[k] ^ p[0]) | (q[k] ^ q[0]);
    return other == 0;
}

/* Coefficients of each contact, where they differ between materials; a batch whose contacts are all alike has those of
 * the batch before, if these were of the same materials. */
static inline void force_mix(const struct law *law, struct force_batch *b) {
    const uint8_t *p = b->material[0], *q = b->material[1];
    const int alike = force_alike(b) ? p[0] * law->materials + q[0] : FORCE_UNLIKE;
    const bool plain = !law->general && law->options.user == NULL;
    for (int k = 0; plain && alike == FORCE_UNLIKE && k < b->walk.padded; k++)
        force_set_coefficients(b, k, law_pair_of(law, p[k], q[k]));
    for (int k = 0; !plain && alike == FORCE_UNLIKE && k < b->walk.padded; k++)
        force_set_materials(law, b, k, p[k], q[k]);
    for (int k = 0; alike != FORCE_UNLIKE && alike != b->alike && k < FORCE_BATCH; k++)
        force_set_materials(law, b, k, p[0], q[0]);
    b->alike = alike;
}

/* The push of a law of the user's: its file's loop over the batch, and the damper. */
static void force_ask(const struct law *law, struct law_step step, struct force_batch *restrict b) {
    const bool given = law_damping_form_of(law->options.damping)->given;
    struct scree_law_batch batch = {.count = b->walk.padded,
                                    .overlap = b->overlap,
                                    .radius = b->effective,
                                    .k_n = b->coefficient[FORCE_k_n],
                                    .k_t = b->coefficient[FORCE_k_t],
                                    .force = b->springs[0],
                                    .stiffness = b->springs[1],
                                    .tangential = b->springs[2],
                                    .contact = b->springs[3],
                                    .energy = b->springs[4]};
    for (int p = 0; p < LAW_PARAMETERS_MAX; p++)
        batch.parameter[p] = b->parameter[p];
    law->options.user->law->batch(&batch);
#pragma omp simd
    for (int k = 0; k < batch.count; k++)
        force_damp(given, b, k, step);
}

/* The push of a law; NULL: its loop has all. */
static force_pusher *force_push_find(const struct law *law, bool energies) {
    if (law->general) {
        force_pusher *grip = energies ? NULL : force_grip_find(&law->options);
        return !force_resist_has(law) ? force_general_respond : grip ? grip : force_general_push;
    }
    return law->options.user ? force_ask : NULL;
}

static void force_begin(struct force_form *form, struct force_batch *b, const struct law *law, double dt,
                        bool energies) {
    *form = (struct force_form){.law = law,
                                .step = law_step_of(&law->options, dt),
                                .measure = force_measure_find(&law->options),
                                .push = force_push_find(law, energies)};
    form->step.energies = energies;
    if (form->push == NULL)
        form->respond = force_respond_find(&law->options, energies);
    else if (form->push != force_general_respond)
        force_resist_find(&law->options, energies, form->resist);
    memset(b->active, true, sizeof b->active);
    b->alike = FORCE_UNLIKE;
    for (int k = 0; law->uniform && k < FORCE_BATCH; k++)
        force_set_materials(law, b, k, 0, 0);
}

static void force_contacts(const struct force_form *form, struct force_batch *b) {
    const struct law *law = form->law;
    if (!law->uniform)
        force_mix(law, b);
    if (form->push)
        form->push(law, form->step, b);
    for (int k = 0; law->general && k < b->walk.padded; k++)
        b->active[k] = b->springs[5][k] > 0.0;
    if (form->respond)
        form->respond(b, form->step);
    for (int r = 0; r < FORCE_RESISTS; r++)
        if (form->resist[r])
            form->resist[r](law, form->step, b);
}

/* LAMMPS's slip of pair_style granular: the radii are the levers. */
static void force_slip_lammps(struct force_batch *b, int k) {
    struct law_vector wi = force_vector(b->omega[0], k), wj = force_vector(b->omega[1], k);
    force_set(b->surface, k, law_add(law_scale(b->walk.radius[0][k], wi), b->walk.radius[1][k], wj));
}

static void force_compute(const struct walk_task *task, struct walk_batch *batch) {
    struct force_thread *thread = (struct force_thread *)batch;
    struct force_batch *b = &thread->batch;
    const struct law *law = thread->form.law;
    for (int k = 0; !law->uniform && k < batch->padded; k++) {
        b->material[0][k] = (uint8_t)material_of(thread->material, batch->i[k]);
        b->material[1][k] = (uint8_t)material_of(thread->material, batch->j[k]);
    }
    (void)task;
    thread->form.measure(b, thread->form.step);
    for (int k = 0; law->options.lammps_granular && law->spin && k < batch->padded; k++)
        force_slip_lammps(b, k);
    force_contacts(&thread->form, b);
}

static void force_note(const struct walk_task *task, struct walk_batch *batch) {
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
    force_watch(context->particles, &thread->batch, &thread->sums);
    if (!context->want_sums)
        return;
    force_account(context, thread);
    if (context->pair_work)
        force_put_work(task, &thread->batch);
}

const struct force_kernel FORCE_KERNEL = {.name = FORCE_KERNEL_NAME,
                                          .begin = force_begin,
                                          .contacts = force_contacts,
                                          .compute = force_compute,
                                          .note = force_note};
