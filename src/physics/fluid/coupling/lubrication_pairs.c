/* SPDX-License-Identifier: BSD-3-Clause */
/* Lubrication of the grains of a scene. Read lubrication_pairs.h first. */
#include "physics/fluid/coupling/lubrication_pairs.h"
#include "base/memory.h"
#include "base/vector.h"
#include "kernel/particles/kinds.h"
#include "kernel/particles/spin.h"
#include "physics/fluid/coupling/lubrication.h"
#include "physics/fluid/fluid_state.h"
#include "physics/grains/grains.h"
#include "physics/grains/motion/carried.h"
#include "physics/grains/walls/wall.h"
#include <math.h>
#include <string.h>

bool lubrication_wanted(const struct physics_context *context) {
    const struct fluid_options *options = context->options;
    return !isnan(options->grains.lubrication);
}

/* True of two members of one body. */
static bool together(const struct particles *p, size_t i, size_t j) {
    const int64_t *body = carried_by(p);
    return body != NULL && body[i] >= 0 && body[i] == body[j];
}

void lubrication_pairs_take(const struct physics_context *context, const struct pair_rows *rows) {
    struct fluid *fluid = context->self;
    const struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    struct kind_span span = kinds_span(p, context->classes, KIND_GRAIN);
    size_t most = span.end > span.first ? rows->start[span.end] - rows->start[span.first] : 0;
    if (fluid->lubrication == NULL)
        fluid->lubrication = memory_allocate_zero(1, sizeof *fluid->lubrication, "lubrication");
    struct lubrication_pairs *pairs = fluid->lubrication;
    if (most > pairs->room) {
        pairs->room = most + most / 4;
        pairs->near = memory_resize(pairs->near, pairs->room, sizeof *pairs->near, "lubrication");
    }
    pairs->count = 0;
    for (size_t i = span.first; i < span.end; i++)
        for (size_t e = rows->start[i]; e < rows->start[i + 1]; e++) {
            uint32_t j = pair_partner(rows->partner[e]);
            if (kind[j] == KIND_GRAIN && !together(p, i, j))
                pairs->near[pairs->count++] = (struct lubrication_near){(uint32_t)i, rows->partner[e]};
        }
}

static struct lubrication lubrication_make(const struct physics_context *context) {
    const struct fluid_options *options = context->options;
    return (struct lubrication){options->viscosity, options->spacing, options->grains.lubrication,
                                context->box->dimension};
}

/* The motion of particle i as end e of a pair. */
static void end_set(const struct particles *p, size_t i, int e, struct lubrication_pair *pair) {
    const struct particle_state *state = &p->state[i];
    double(*spin)[4] = spin_of(p);
    memcpy(pair->velocity[e], state->v, sizeof pair->velocity[e]);
    pair->lightness[e] = state->inverse_mass;
    if (spin == NULL)
        return;
    memcpy(pair->spin[e], spin[i], sizeof pair->spin[e]);
    pair->swing[e] = 2.5 * state->inverse_mass / (state->radius * state->radius);
}

/* Adds a force to grain i; returns its work in a step, none on one that no force moves. */
static double force_add(const struct physics_context *context, size_t i, const double force[6]) {
    const struct particles *p = context->particles;
    const double *v = p->state[i].v;
    double(*spin)[4] = spin_of(p), *on = p->force + i * (size_t)p->force_stride, power = 0;
    for (int d = 0; d < 3; d++) {
        on[d] += force[d];
        power += force[d] * v[d];
        if (spin != NULL) {
            on[4 + d] += force[3 + d];
            power += force[3 + d] * spin[i][d];
        }
    }
    return p->state[i].inverse_mass > 0 && context->evaluation->dt > 0 ? power * context->clock->dt : 0;
}

/* The force on the first of a pair of grains; false: they are not near. */
static bool pair_force(const struct physics_context *context, const struct lubrication *lubrication,
                       const struct lubrication_near *near, double force[6]) {
    const struct particles *p = context->particles;
    const struct particle_state *a = &p->state[near->grain], *b = &p->state[pair_partner(near->partner)];
    const double *shift = context->list[0]->shift[pair_image(near->partner)];
    struct lubrication_pair pair = {0};
    double apart[3], distance, gap;
    for (int d = 0; d < 3; d++)
        apart[d] = b->x[d] + shift[d] - a->x[d];
    distance = sqrt(vector_dot(apart, apart));
    gap = distance - a->radius - b->radius;
    if (!(gap < LUBRICATION_REACH * lubrication->spacing) || !(distance > 0))
        return false;
    for (int d = 0; d < 3; d++)
        pair.normal[d] = apart[d] / distance;
    pair.lever[0] = a->radius + 0.5 * gap;
    pair.lever[1] = b->radius + 0.5 * gap;
    end_set(p, near->grain, 0, &pair);
    end_set(p, pair_partner(near->partner), 1, &pair);
    struct lubrication_parts parts =
        lubrication_of(lubrication, a->radius * b->radius / (a->radius + b->radius), false, gap);
    lubrication_limit(&parts, &pair, context->clock->dt);
    lubrication_force(&parts, &pair, force);
    return true;
}

/* The pairs of one thread's grains near walls. */
struct at_walls {
    const struct physics_context *context;
    struct lubrication lubrication;
    int thread;
    double work;
};

/* Called by the one thread that has the grain. */
static void at_wall(void *self, const struct wall_place *place) {
    struct at_walls *at = self;
    const struct physics_context *context = at->context;
    const struct particles *p = context->particles;
    const double radius = p->state[place->particle].radius;
    struct lubrication_pair pair = {.lever = {radius + 0.5 * place->gap, INFINITY}};
    double force[6], against[3];
    if (kinds_of(p)[place->particle] != KIND_GRAIN || context->scene->wall[place->wall].permeable)
        return;
    memcpy(pair.normal, place->normal, sizeof pair.normal);
    memcpy(pair.velocity[1], place->velocity, sizeof pair.velocity[1]);
    end_set(p, place->particle, 0, &pair);
    struct lubrication_parts parts = lubrication_of(&at->lubrication, radius, true, place->gap);
    lubrication_limit(&parts, &pair, context->clock->dt);
    lubrication_force(&parts, &pair, force);
    at->work += force_add(context, place->particle, force);
    for (int d = 0; d < 3; d++)
        against[d] = -force[d];
    walls_push(grains_walls(context), at->thread, place, against, 0);
}

void lubrication_pairs_add(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    const struct lubrication_pairs *pairs = fluid->lubrication;
    const struct lubrication lubrication = lubrication_make(context);
    const struct lubrication_near *near = pairs->near;
    double work = 0;
#pragma omp parallel for schedule(static) reduction(+ : work)
    for (size_t k = 0; k < pairs->count; k++) {
        double force[6];
        if (k > 0 && near[k - 1].grain == near[k].grain) /* one thread has all pairs of a grain */
            continue;
        for (size_t m = k; m < pairs->count && near[m].grain == near[k].grain; m++)
            if (pair_force(context, &lubrication, &near[m], force))
                work += force_add(context, near[m].grain, force);
    }
#pragma omp parallel for schedule(static, 1) reduction(+ : work)
    for (int t = 0; t < context->threads; t++) {
        struct at_walls at = {context, lubrication, t, 0};
        if (grains_walls(context) != NULL)
            walls_visit(grains_walls(context), context->particles, t, LUBRICATION_REACH * lubrication.spacing,
                        at_wall, &at);
        work += at.work;
    }
    fluid->work += work;
}

void lubrication_pairs_destroy(struct lubrication_pairs **pairs) {
    if (*pairs != NULL)
        memory_free((*pairs)->near);
    memory_free(*pairs);
    *pairs = NULL;
}
