/* SPDX-License-Identifier: BSD-3-Clause */
/* Collects the work of contacts for heat. Read heat_work.h first. */
#include "physics/heat/heat_work.h"
#include "physics/grains/grains.h"
#include "base/memory.h"
#include "physics/heat/heat_fields.h"
#include "kernel/pairs/walk.h"
#include <string.h>

struct heat_work {
    const struct physics_context *context;
    struct walk *walk;
    struct walk_work walks;
    struct force_work *pair; /* by pair of the list of contacts */
    double *work, *held;     /* of the fields, since the last rebuild; `work`: two doubles a grain */
};

static void compute(const struct walk_task *task, struct walk_batch *batch) {
    const struct heat_work *work = task->work->context;
    for (int k = 0; k < batch->count; k++) {
        struct force_work contact = work->pair[task->pair_base + batch->pair[k]];
        batch->out[0][k] = batch->out[2][k] = 0.5 * contact.taken;
        batch->out[1][k] = batch->out[3][k] = 0.5 * contact.stored;
    }
}

static const struct walk_client client = {.name = "heat_work",
                                          .memory = sizeof(struct walk_batch),
                                          .scatter = WALK_VALUES,
                                          .values = 2,
                                          .compute = compute};

struct heat_work *heat_work_create(const struct physics_context *context) {
    struct heat_work *work = memory_allocate_zero(1, sizeof *work, "heat");
    work->context = context;
    work->walk = walk_create(&client, context->threads);
    work->walks = (struct walk_work){.context = work,
                                     .particles = context->particles,
                                     .stride = 2,
                                     .radii = true,
                                     .ordered = context->ordered};
    heat_work_register(context->particles);
    grains_contact(context)->want_work = true;
    return work;
}

void heat_work_destroy(struct heat_work **work) {
    if (*work == NULL)
        return;
    walk_destroy(&(*work)->walk);
    memory_free((*work)->pair);
    memory_free(*work);
    *work = NULL;
}

void heat_work_rebuilt(struct heat_work *work) {
    struct force_context *contact = grains_contact(work->context);
    size_t pairs = contact->list->capacity; /* threads' regions may leave gaps */
    work->pair = memory_resize(work->pair, pairs + 1, sizeof *work->pair, "work of contacts");
    memset(work->pair, 0, (pairs + 1) * sizeof *work->pair);
    work->work = heat_work_field(work->context->particles);
    work->held = heat_held_field(work->context->particles);
    contact->pair_work = work->pair;
    contact->wall_work = (struct force_work *)work->work;
    work->walks.list = contact->list;
    work->walks.range = contact->range;
    work->walks.target = work->work;
    walk_prepare(work->walk, &work->walks);
}

void heat_work_finish(struct heat_work *work) {
    walk_run(work->walk, &work->walks);
}

double heat_work_lost(const struct heat_work *work, size_t i) {
    return work->work[2 * i] - (work->work[2 * i + 1] - work->held[i]);
}

double heat_work_take(struct heat_work *work, size_t i) {
    double lost = heat_work_lost(work, i);
    work->held[i] = work->work[2 * i + 1];
    work->work[2 * i] = work->work[2 * i + 1] = 0.0;
    return lost;
}
