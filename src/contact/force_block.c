/* SPDX-License-Identifier: BSD-3-Clause */
/* A batch of contacts through the law: coefficients, geometry, the law, sums (force_kernel.h). Compiled once
 * for each instruction set, under the name that FORCE_KERNEL gives. Read pairs/walk.h first. */
#include "contact/force_account.h"
#include "contact/force_kernel.h"
#include "contact/force_physics.h"
#include "contact/material.h"

/* Coefficients of each contact, where they differ between materials. */
static inline void force_mix(const struct law *law, const uint8_t *material, struct force_batch *restrict b) {
    for (int k = 0; k < b->walk.padded; k++)
        force_set_coefficients(
            b, k, &law->pair[material_of(material, b->walk.i[k])][material_of(material, b->walk.j[k])]);
}

/* The same coefficients for all contacts of a batch. */
static void force_mix_one(struct force_batch *b, const struct law_coefficients *c) {
    for (int k = 0; k < FORCE_BATCH; k++)
        force_set_coefficients(b, k, c);
}

static void force_begin(struct force_thread *thread, const struct force_context *context) {
    const struct law_options *options = &context->law->options;
    thread->step = law_step_of(options, context->dt);
    thread->energies = context->want_sums;
    thread->material = material_numbers(context->particles);
    thread->measure = force_measure_find(options);
    if (context->law->general)
        return;
    thread->respond = force_respond_find(options, context->want_sums);
    if (context->law->uniform)
        force_mix_one(&thread->batch, &context->law->pair[0][0]);
}

static void force_compute(const struct walk_task *task, struct walk_batch *batch) {
    const struct force_context *context = task->work->context;
    struct force_thread *thread = (struct force_thread *)batch;
    if (!context->law->uniform)
        force_mix(context->law, thread->material, &thread->batch);
    thread->measure(&thread->batch, thread->step);
    thread->respond(&thread->batch, thread->step);
}

static void force_add(const struct force_context *context, struct force_thread *thread) {
    force_watch(context->particles, &thread->batch, &thread->sums);
    if (thread->energies)
        force_account(&thread->batch, context->want_virial, &thread->sums);
}

static void force_note(const struct walk_task *task, struct walk_batch *batch) {
    const struct force_context *context = task->work->context;
    struct force_thread *thread = (struct force_thread *)batch;
    thread->sums.contact_sides += 2 * (size_t)batch->count - (size_t)(batch->one - batch->both);
    force_watch(context->particles, &thread->batch, &thread->sums);
    if (thread->energies)
        force_account(&thread->batch, context->want_virial, &thread->sums);
}

static void force_answer(const struct law_options *options, bool energies, struct force_batch *batch,
                         struct law_step step) {
    batch->walk.padded = (batch->walk.count + FORCE_LANES - 1) / FORCE_LANES * FORCE_LANES;
    force_respond_find(options, energies)(batch, step);
}

const struct force_kernel FORCE_KERNEL = {FORCE_KERNEL_NAME, force_begin, force_compute,
                                          force_note,        force_add,   force_answer};
