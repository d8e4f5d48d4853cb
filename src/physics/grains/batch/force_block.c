/* SPDX-License-Identifier: BSD-3-Clause */
/* A batch of contacts through the law: coefficients, geometry, the law, sums (force_kernel.h). Compiled once
 * for each instruction set, under the name that FORCE_KERNEL gives. Read kernel/pairs/walk.h first. */
#include "physics/grains/batch/force_account.h"
#include "physics/grains/batch/force_grip.h"
#include "physics/grains/batch/force_kernel.h"
#include "physics/grains/batch/force_physics.h"
#include "physics/grains/laws/law_general.h"
#include "physics/grains/laws/law_user.h"
#include "kernel/particles/material.h"

/* True if all contacts of the batch are between the same two materials, in the same order. */
static inline bool force_alike(const uint8_t *material, const struct walk_batch *restrict b) {
    const int p = material_of(material, b->i[0]), q = material_of(material, b->j[0]);
    const int middle = b->count / 2, last = b->count - 1;
    if (material_of(material, b->i[middle]) != p || material_of(material, b->j[middle]) != q ||
        material_of(material, b->i[last]) != p || material_of(material, b->j[last]) != q)
        return false; /* mixed materials mostly end here */
    int other = 0;
    for (int k = 0; k < b->padded; k++)
        other |= (material_of(material, b->i[k]) ^ p) | (material_of(material, b->j[k]) ^ q);
    return other == 0;
}

/* Coefficients of each contact, where they differ between materials; a batch whose contacts are all alike has those of
 * the batch before, if these were of the same materials. */
static inline void force_mix(const struct law *law, struct force_thread *thread) {
    const uint8_t *material = thread->material;
    struct force_batch *b = &thread->batch;
    const int p = material_of(material, b->walk.i[0]), q = material_of(material, b->walk.j[0]);
    const int alike = force_alike(material, &b->walk) ? p * law->materials + q : FORCE_UNLIKE;
    if (alike == FORCE_UNLIKE)
        for (int k = 0; k < b->walk.padded; k++)
            force_set_coefficients(
                b, k,
                law_pair_of(law, material_of(material, b->walk.i[k]), material_of(material, b->walk.j[k])));
    else if (alike != thread->alike)
        for (int k = 0; k < FORCE_BATCH; k++)
            force_set_coefficients(b, k, law_pair_of(law, p, q));
    thread->alike = alike;
}

/* What contact k of a law with parts takes of the materials p and q. */
static inline void force_set_parts(const struct law *law, struct force_batch *b, int k, int p, int q) {
    force_set_coefficients(b, k, law_pair_of(law, p, q));
    force_set_sticky(b, k, law->options.cohesion, law_sticky_at(law, p, q));
    b->extra[k] = law_extra_of(law, p, q);
    if (law->memory.past >= 0)
        force_set_branch(b, k, b->extra[k]);
}

static void force_mix_parts(const struct law *law, const uint8_t *material, struct force_batch *b) {
    for (int k = 0; k < b->walk.padded; k++)
        force_set_parts(law, b, k, material_of(material, b->walk.i[k]), material_of(material, b->walk.j[k]));
}

/* The same coefficients for all contacts of all batches. */
static void force_mix_one(const struct law *law, struct force_batch *b) {
    for (int k = 0; k < FORCE_BATCH; k++)
        force_set_parts(law, b, k, 0, 0);
}

/* The springs of a law of the user's: its loop over the batch. */
static void force_ask(const struct law_user *user, struct force_batch *b) {
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
    user->law->batch(&batch);
}

/* Its parameters of contact k. */
static void force_parameters(const struct law_user *user, struct force_batch *b, int k,
                             const struct law_extra *extra) {
    for (int p = 0; p < user->law->parameters; p++)
        b->parameter[p][k] = extra->parameter[p];
}

static void force_begin(struct force_thread *thread, const struct force_context *context) {
    const struct law_options *options = &context->law->options;
    thread->step = law_step_of(options, context->dt);
    thread->energies = context->want_sums;
    thread->kernel = &FORCE_KERNEL;
    thread->rubs = !context->want_sums && law_general_rubs(context->law);
    thread->material = material_numbers(context->particles);
    thread->alike = FORCE_UNLIKE;
    thread->grip = thread->rubs ? force_grip_find(options) : NULL;
    thread->measure = force_measure_find(options);
    if (context->law->uniform)
        force_mix_one(context->law, &thread->batch);
    if (context->law->general)
        return;
    thread->respond = force_respond_find(options, context->want_sums);
    for (int k = 0; options->user && k < FORCE_BATCH; k++)
        force_parameters(options->user, &thread->batch, k, law_extra_of(context->law, 0, 0));
}

static void force_compute(const struct walk_task *task, struct walk_batch *batch) {
    const struct force_context *context = task->work->context;
    struct force_thread *thread = (struct force_thread *)batch;
    if (!context->law->uniform)
        force_mix(context->law, thread);
    thread->measure(&thread->batch, thread->step);
    const struct law_user *user = context->law->options.user;
    for (int k = 0; user && !context->law->uniform && k < batch->padded; k++)
        force_parameters(user, &thread->batch, k,
                         law_extra_of(context->law, material_of(thread->material, batch->i[k]),
                                      material_of(thread->material, batch->j[k])));
    if (user)
        force_ask(user, &thread->batch);
    thread->respond(&thread->batch, thread->step);
}

static void force_add(const struct force_context *context, struct force_thread *thread) {
    force_watch(context->particles, &thread->batch, &thread->sums);
    if (thread->energies)
        force_account(context, thread);
}

static void force_note(const struct walk_task *task, struct walk_batch *batch) {
    const struct force_context *context = task->work->context;
    struct force_thread *thread = (struct force_thread *)batch;
    thread->sums.contact_sides += 2 * (size_t)batch->count - (size_t)(batch->one - batch->both);
    force_watch(context->particles, &thread->batch, &thread->sums);
    if (thread->energies)
        force_account(context, thread);
    if (thread->energies && context->pair_work)
        force_put_work(task, &thread->batch);
}

static void force_answer(const struct law_options *options, bool energies, struct force_batch *batch,
                         struct law_step step) {
    batch->walk.padded = (batch->walk.count + FORCE_LANES - 1) / FORCE_LANES * FORCE_LANES;
    for (int k = 0; options->user && k < batch->walk.count; k++)
        force_parameters(options->user, batch, k, batch->extra[k]);
    if (options->user)
        force_ask(options->user, batch);
    force_respond_find(options, energies)(batch, step);
}

static void force_rub_batch(const struct law_options *options, struct force_batch *batch,
                            struct law_step step) {
    force_rub_find(options)(batch, step);
}

const struct force_kernel FORCE_KERNEL = {.name = FORCE_KERNEL_NAME,
                                          .begin = force_begin,
                                          .compute = force_compute,
                                          .note = force_note,
                                          .account = force_add,
                                          .mix = force_mix_parts,
                                          .grip_find = force_grip_find,
                                          .rub = force_rub_batch,
                                          .respond = force_answer};
