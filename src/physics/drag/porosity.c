/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums over pairs of grains, corrected for walls and for the grain itself. Read porosity.h first. */
#include "physics/drag/porosity.h"
#include "physics/grains/grains.h"
#include "base/memory.h"
#include "physics/drag/drag_fields.h"
#include "kernel/pairs/walk.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include "physics/grains/walls/wall.h"
#include <math.h>
#include <string.h>

/* Steps of the equation for the grain itself; each gains a digit or more. */
enum { ROUNDS = 12 };

struct porosity {
    const struct physics_context *context;
    double support, largest;
    double middle; /* W(0) */
    const uint8_t *kind;
    struct walk *walk;
    struct walk_work work;
    double *front; /* of the owned grains: C */
    size_t room;
};

double porosity_volume(double radius) {
    return 4.0 / 3.0 * M_PI * radius * radius * radius;
}

double porosity_front(double distance) {
    double z = fmin(distance, 1.0), z2 = z * z, z5 = z2 * z2 * z;
    return 0.5 + 21.0 * (z * (1.0 / 14.0 - z2 / 6.0) +
                         z5 * (0.5 - 2.0 / 3.0 * z + 5.0 / 14.0 * z2 - z2 * z / 14.0));
}

static bool counts(const struct porosity *porosity, size_t i, double radius) {
    return radius <= porosity->largest && (porosity->kind == NULL || porosity->kind[i] == KIND_GRAIN);
}

static void compute(const struct walk_task *task, struct walk_batch *batch) {
    const struct porosity *porosity = task->work->context;
    for (int k = 0; k < batch->padded; k++) {
        const double *d = batch->record[k], *r[2] = {batch->radius[0], batch->radius[1]};
        double q = fmin(sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / porosity->support, 1.0);
        double p = (1.0 - q) * (1.0 - q), w = porosity->middle * p * p * (1.0 + 4.0 * q);
        bool both = counts(porosity, batch->i[k], r[0][k]) && counts(porosity, batch->j[k], r[1][k]);
        batch->out[0][k] = both ? porosity_volume(r[1][k]) * w : 0.0;
        batch->out[1][k] = both ? porosity_volume(r[0][k]) * w : 0.0;
    }
}

static const struct walk_client client = {.name = "porosity",
                                          .memory = sizeof(struct walk_batch),
                                          .scatter = WALK_VALUES,
                                          .values = 1,
                                          .compute = compute};

struct porosity *porosity_create(const struct physics_context *context) {
    const struct drag_options *options = context->options;
    struct porosity *porosity = memory_allocate_zero(1, sizeof *porosity, "porosity");
    double h = options->porosity.support;
    porosity->context = context;
    porosity->support = h;
    porosity->largest = drag_largest(context->scene);
    porosity->middle = 21.0 / (2.0 * M_PI * h * h * h);
    porosity->walk = walk_create(&client, context->threads);
    porosity->work = (struct walk_work){.context = porosity,
                                        .particles = context->particles,
                                        .stride = 1,
                                        .range = h,
                                        .ordered = context->ordered};
    drag_porosity_register(context->particles);
    if (grains_walls(context))
        walls_visit_fixed(grains_walls(context));
    return porosity;
}

void porosity_destroy(struct porosity **porosity) {
    if (*porosity == NULL)
        return;
    walk_destroy(&(*porosity)->walk);
    memory_free((*porosity)->front);
    memory_free(*porosity);
    *porosity = NULL;
}

void porosity_rebuilt(struct porosity *porosity) {
    const struct particles *p = porosity->context->particles;
    if (p->owned > porosity->room) {
        porosity->room = p->owned + p->owned / 8;
        porosity->front = memory_resize(porosity->front, porosity->room, sizeof *porosity->front, "porosity");
    }
    porosity->kind = kinds_of(p);
    porosity->work.list = porosity->context->list[0];
    porosity->work.target = drag_porosity(p);
    walk_prepare(porosity->walk, &porosity->work);
}

/* A wall near a grain: called by the one thread that has the grain. */
static void at_wall(void *self, const struct wall_place *place) {
    struct porosity *porosity = self;
    size_t i = place->particle;
    double distance = place->gap + porosity->context->particles->state[i].radius;
    if (distance < porosity->support)
        porosity->front[i] *= porosity_front(fmax(distance, 0.0) / porosity->support);
}

static double structure(double f) {
    double g = 1.0 - f, f2 = f * f;
    return g * g * g * g / (1.0 + 4.0 * f + 4.0 * f2 - 4.0 * f * f2 + f2 * f2);
}

/* From the sum over the others to the porosity. */
static double solve(double others, double own, double front) {
    double f = fmin(others / front, POROSITY_SOLID_MOST);
    for (int k = 0; k < ROUNDS; k++)
        f = fmin((others + own * (1.0 - structure(f))) / front, POROSITY_SOLID_MOST);
    return 1.0 - f;
}

void porosity_sum(struct porosity *porosity) {
    const struct physics_context *context = porosity->context;
    struct particles *p = context->particles;
    struct field_list field = fields_one(drag_porosity_handle(p));
    double *value = porosity->work.target;
    memset(value, 0, (p->owned + p->ghosts) * sizeof *value);
    walk_run(porosity->walk, &porosity->work);
    if (context->ghosts)
        ghosts_reverse(context->ghosts, p, &field);
    for (size_t i = 0; i < p->owned; i++)
        porosity->front[i] = 1.0;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < context->threads; t++)
        if (grains_walls(context))
            walls_visit(grains_walls(context), p, t, porosity->support, at_wall, porosity);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->owned; i++) {
        double radius = p->state[i].radius;
        value[i] = counts(porosity, i, radius)
                       ? solve(value[i], porosity->middle * porosity_volume(radius), porosity->front[i])
                       : 1.0;
    }
}
