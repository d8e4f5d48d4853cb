/* SPDX-License-Identifier: BSD-3-Clause */
/* Number density as a physics: one interaction, one field, one pass before output (engine/physics.h). */
#include "physics/density/density.h"
#include "base/memory.h"
#include "engine/physics.h"
#include "kernel/pairs/walk.h"
#include "kernel/particles/kinds.h"
#include <math.h>

static double weight(const struct physics_context *context) {
    double h = ((const struct density_options *)context->options)->support;
    return context->box->dimension == 2 ? 7.0 / (M_PI * h * h) : 21.0 / (2.0 * M_PI * h * h * h);
}

static void compute(const struct walk_task *task, struct walk_batch *batch) {
    const struct physics_context *context = task->work->context;
    double w = weight(context), h = task->work->range;
    for (int k = 0; k < batch->padded; k++) {
        const double *d = batch->record[k];
        double q = fmin(sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / h, 1.0), p = (1.0 - q) * (1.0 - q);
        batch->out[0][k] = batch->out[1][k] = w * p * p * (1.0 + 4.0 * q);
    }
}

static const struct walk_client client = {.name = "number density",
                                          .memory = sizeof(struct walk_batch),
                                          .scatter = WALK_VALUES,
                                          .values = 1,
                                          .compute = compute};

static double range(const void *options, int kind_a, double radius_a, int kind_b, double radius_b) {
    if (kind_a == KIND_BODY || kind_b == KIND_BODY)
        return -INFINITY;
    return ((const struct density_options *)options)->support - radius_a - radius_b;
}

static void *create(const struct physics_context *context) {
    return walk_create(&client, context->threads);
}
static void destroy(void *self) {
    struct walk *walk = self;
    walk_destroy(&walk);
}

/* Sums over pairs; the particle itself counts once, and the shares of copies are sent to their originals. */
static void sum(const struct physics_context *context) {
    struct particles *p = context->particles;
    struct field_list field = fields_one(fields_find(p, "number_density"));
    double *value = fields_base(p, field.field[0], NULL);
    for (size_t i = 0; i < p->owned + p->ghosts; i++)
        value[i] = i < p->owned ? weight(context) : 0.0;
    struct walk_work work = {.context = context,
                             .particles = p,
                             .list = context->list[0],
                             .target = value,
                             .stride = 1,
                             .range = ((const struct density_options *)context->options)->support,
                             .ordered = context->ordered};
    walk_prepare(context->self, &work);
    walk_run(context->self, &work);
    if (context->ghosts)
        ghosts_reverse(context->ghosts, p, &field);
}

static const struct physics_pass pass = {.name = "number_density",
                                         .place = PASS_LOOK,
                                         .reads = "position",
                                         .writes = "number_density",
                                         .whole = sum};
static const struct physics_search search = {.interactions = 1,
                                             .interaction = {{.name = "number density", .range = range}}};

const struct physics density_physics = {.name = "density",
                                        .box_moves = true,
                                        .create = create,
                                        .destroy = destroy,
                                        .passes = 1,
                                        .pass = &pass,
                                        .search = &search};
