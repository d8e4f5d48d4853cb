/* SPDX-License-Identifier: BSD-3-Clause */
/* The force loop: the contact laws as a client of the walk over pairs. Read kernel/pairs/walk.h first. */
#include "physics/grains/batch/force.h"
#include "physics/grains/batch/force_kernel.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include "base/memory.h"
#include <assert.h>
#include <string.h>

struct force_loop {
    const struct force_kernel *kernel;
    struct walk_client client;
    struct walk *walk;
    int threads;
};

const struct force_kernel *force_kernel_find(const char *name) {
    static const struct force_kernel *const kernels[] = {
        &force_kernel_baseline,
#ifdef SCREE_X86_KERNELS
        &force_kernel_v3,
        &force_kernel_v4,
#endif
    };
    int level = walk_level(name);
    return level < 0 ? NULL : kernels[level];
}

static void force_loop_take(struct force_loop *loop, const struct force_kernel *kernel) {
    loop->kernel = kernel;
    loop->client.compute = kernel->compute;
    loop->client.note = kernel->note;
}

/* True if both particles are prescribed and move and turn alike: their overlap never changes, and does not
 * count as a contact. */
static bool force_fixed(const double record[8], const double *omega) {
    if (record[7] != 0.0 || record[4] != 0.0 || record[5] != 0.0 || record[6] != 0.0)
        return false;
    return omega == NULL || (omega[0] == omega[4] && omega[1] == omega[5] && omega[2] == omega[6]);
}

/* True if surfaces pull beyond touch only where they have touched. */
static bool force_waits(const struct law *law) {
    return law->general && law_cohesion_form_of(law->options.cohesion)->remembers;
}

void force_walk_select(const struct walk_task *task, const struct walk_batch *batch, uint8_t *keep) {
    const struct force_context *context = task->work->context;
    for (int k = 0; k < batch->count; k++) {
        if (force_fixed(batch->record[k], task->work->gathers > 0 ? batch->gathered[0][k] : NULL))
            keep[k] = 0;
        if (context->joined && keep[k])
            keep[k] = !context->joined(context->joined_context, batch->i[k], batch->j[k]);
    }
}

struct force_loop *force_loop_create(int threads) {
    struct force_loop *loop = memory_allocate_zero(1, sizeof *loop, "force loop");
    loop->threads = threads;
    loop->client = (struct walk_client){
        .name = "contact", .memory = sizeof(struct force_thread), .select = force_walk_select};
    force_loop_take(loop, force_kernel_find(NULL));
    loop->walk = walk_create(&loop->client, threads);
    return loop;
}

void force_loop_destroy(struct force_loop **loop) {
    if (*loop == NULL)
        return;
    walk_destroy(&(*loop)->walk);
    memory_free(*loop);
    *loop = NULL;
}

const char *force_loop_kernel(const struct force_loop *loop) {
    return loop->kernel->name;
}

bool force_loop_choose(struct force_loop *loop, const char *name) {
    const struct force_kernel *found = force_kernel_find(name);
    if (found) {
        force_loop_take(loop, found);
        walk_choose(loop->walk, name);
    }
    return found != NULL;
}

struct walk_work force_walk_work(const struct force_context *context) {
    const struct particles *particles = context->particles;
    struct walk_work work = {.context = context,
                             .particles = particles,
                             .list = context->list,
                             .history = context->history,
                             .target = particles->force,
                             .stride = (size_t)particles->force_stride,
                             .radii = true,
                             .range = context->range,
                             .waits = force_waits(context->law),
                             .held = context->law->memory.held,
                             .selective = context->prescribed || context->joined,
                             .ordered = context->ordered};
    if (context->law->spin) {
        work.gathers = 1;
        work.gather[0] = (struct walk_field){&spin_values(particles)[0][0], 4};
    }
    return work;
}

static struct force_thread *force_loop_thread(const struct force_loop *loop, int thread) {
    return (struct force_thread *)walk_batch_of(loop->walk, thread);
}

static void force_loop_clear(struct force_loop *loop) {
    for (int t = 0; t < loop->threads; t++)
        force_loop_thread(loop, t)->sums = (struct force_sums){0};
}

void force_thread_begin(struct force_thread *own, const struct force_kernel *kernel,
                        const struct force_context *context, int thread) {
    own->exact = context->exact ? &context->exact[thread] : NULL;
    own->material = material_numbers(context->particles);
    kernel->begin(&own->form, &own->batch, context->law, context->dt, context->want_sums);
}

void force_loop_prepare(struct force_loop *loop, const struct force_context *context) {
    struct walk_work work = force_walk_work(context);
    assert((context->history != NULL) == (context->law->history_components > 0));
    loop->client.scatter = !context->law->spin                                  ? WALK_FORCE
                           : law_case_of(&context->law->options, false).rolling ? WALK_ROLLING
                                                                                : WALK_TORQUE;
    walk_prepare(loop->walk, &work);
    force_loop_clear(loop);
}

void force_loop_block(struct force_loop *loop, const struct force_context *context, int thread, int block) {
    struct walk_work work = force_walk_work(context);
    if (block == context->list->thread_block[thread])
        force_thread_begin(force_loop_thread(loop, thread), loop->kernel, context, thread);
    walk_block(loop->walk, &work, thread, block);
}

void force_sums_add(struct force_sums *total, const struct force_sums *part) {
    total->elastic_normal += part->elastic_normal;
    total->elastic_tangential += part->elastic_tangential;
    total->taken += part->taken;
    for (int c = 0; c < 6; c++)
        total->virial[c] += part->virial[c];
    total->contact_sides += part->contact_sides;
    total->contacts = total->contact_sides / 2;
    if (part->overlap_max > total->overlap_max) {
        total->overlap_max = part->overlap_max;
        total->overlap_id[0] = part->overlap_id[0];
        total->overlap_id[1] = part->overlap_id[1];
    }
}

void force_loop_finish(struct force_loop *loop, const struct force_context *context,
                       struct force_sums *sums) {
    struct walk_work work = force_walk_work(context);
    walk_finish(loop->walk, &work);
    *sums = (struct force_sums){0};
    for (int t = 0; t < loop->threads; t++)
        force_sums_add(sums, &force_loop_thread(loop, t)->sums);
    force_loop_clear(loop);
}

void force_loop_abandon(struct force_loop *loop, const struct force_context *context) {
    struct walk_work work = force_walk_work(context);
    walk_abandon(loop->walk, &work);
    force_loop_clear(loop);
    if (context->exact)
        memset(context->exact, 0, (size_t)loop->threads * sizeof *context->exact);
}

void force_loop_run(struct force_loop *loop, const struct force_context *context, struct force_sums *sums) {
    const struct pairlist *list = context->list;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < loop->threads; t++)
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
            force_loop_block(loop, context, t, b);
    force_loop_finish(loop, context, sums);
}
