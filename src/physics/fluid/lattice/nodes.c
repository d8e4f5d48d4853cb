/* SPDX-License-Identifier: BSD-3-Clause */
/* The nodes of the lattice: where they are, and what each is. Read nodes.h first. */
#include "physics/fluid/lattice/nodes.h"
#include "physics/grains/grains.h"
#include "base/memory.h"
#include "base/random.h"
#include "physics/fluid/coupling/rigid_walls.h"
#include "physics/fluid/coupling/unresolved_grains.h"
#include "physics/fluid/fluid.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double same = 1e-6; /* part of a step by which lengths may differ from whole numbers of it */

static int64_t wrap(int64_t value, int64_t count) {
    return (value % count + count) % count;
}

/* The numbers on the lattice of a node in the three directions. */
static void split(const struct nodes *nodes, int64_t node, int64_t at[3]) {
    at[0] = node % nodes->count[0];
    at[1] = node / nodes->count[0] % nodes->count[1];
    at[2] = node / nodes->count[0] / nodes->count[1];
    at[nodes->cut] = wrap(at[nodes->cut] + nodes->plane, nodes->whole[nodes->cut]);
}

/* The node with these numbers, which may go on across periodic sides; -1 if there is none, or it is not held. */
static int64_t join(const struct nodes *nodes, const int64_t at[3]) {
    int64_t held[3];
    for (int d = 0; d < 3; d++) {
        held[d] = at[d] - (d == nodes->cut ? nodes->plane : 0);
        if (nodes->box->periodic[d])
            held[d] = wrap(held[d], nodes->whole[d]);
        if (held[d] < 0 || held[d] >= nodes->count[d])
            return -1;
    }
    return held[0] + nodes->count[0] * (held[1] + nodes->count[1] * held[2]);
}

/* The place that a node has, not wrapped. */
static void place_at(const struct nodes *nodes, const int64_t at[3], double x[3]) {
    for (int d = 0; d < 3; d++)
        x[d] = nodes->first[d] + (double)at[d] * nodes->lattice.step[d];
}

/* The displacement of the node of that number. */
static void displace(const struct nodes *nodes, int64_t number, double x[3]) {
    struct random_sequence random = random_sequence(nodes->seed, RANDOM_POSITION, (uint64_t)number);
    for (int d = 0; d < nodes->dimension && nodes->jitter > 0; d++)
        x[d] += nodes->jitter * nodes->spacing * (random_uniform(&random) - 0.5);
}

/* The place of a node on the lattice, displaced, not wrapped. */
static void place_of(const struct nodes *nodes, int64_t node, double x[3]) {
    int64_t at[3];
    split(nodes, node, at);
    place_at(nodes, at, x);
    displace(nodes, nodes_number(nodes, node), x);
}

int64_t nodes_number(const struct nodes *nodes, int64_t node) {
    int64_t at[3];
    split(nodes, node, at);
    return at[0] + nodes->whole[0] * (at[1] + nodes->whole[1] * at[2]);
}

void nodes_place(const struct nodes *nodes, int64_t number, double x[3]) {
    const int64_t at[3] = {number % nodes->whole[0], number / nodes->whole[0] % nodes->whole[1],
                           number / nodes->whole[0] / nodes->whole[1]};
    place_at(nodes, at, x);
    displace(nodes, number, x);
    for (int d = 0; d < nodes->dimension; d++)
        if (nodes->box->periodic[d]) {
            double edge = nodes->box->edge[d];
            x[d] -= edge * floor(x[d] / edge);
            x[d] = x[d] < edge ? x[d] : 0;
        }
}

int64_t nodes_plane(const struct nodes *nodes, int64_t node) {
    int64_t at[3];
    split(nodes, node, at);
    return at[nodes->cut];
}

bool nodes_own(const struct nodes *nodes, int64_t node) {
    int64_t plane = nodes_plane(nodes, node);
    return plane >= nodes->own[0] && plane < nodes->own[1];
}

/* The first plane of a rank. */
static int64_t plane_of(const struct nodes *nodes, int rank) {
    return nodes->whole[nodes->cut] * rank / nodes->comm->size;
}

int nodes_rank_of(const struct nodes *nodes, int64_t plane) {
    int64_t whole = nodes->whole[nodes->cut];
    return (int)(((plane + 1) * nodes->comm->size - 1) / whole);
}

int64_t nodes_neighbour(const struct nodes *nodes, int64_t node, const int step[3]) {
    int64_t at[3];
    split(nodes, node, at);
    for (int d = 0; d < 3; d++)
        at[d] += step[d];
    return join(nodes, at);
}

/* The planes within the support of one. */
static int64_t margin_of(const struct nodes *nodes, int d) {
    return (int64_t)ceil(nodes->support / nodes->lattice.step[d]);
}

/* Lays the lattice: how many nodes, and where the first one is. */
static bool lay(struct nodes *nodes, const struct physics_context *context,
                const struct fluid_options *options, struct error *error) {
    const struct box *box = context->box;
    const struct arrangement *lattice = &nodes->lattice;
    for (int d = 0; d < 3; d++) {
        nodes->whole[d] = lattice->planes[d];
        nodes->first[d] = 0.5 * lattice->step[d] + options->fill.offset[d];
        if (d == 2 && nodes->dimension == 2) {
            nodes->whole[d] = 1;
            nodes->first[d] = 0.5 * box->edge[d];
        } else if (!box->periodic[d]) {
            nodes->whole[d] = (int64_t)ceil(box->edge[d] / lattice->step[d] - same) + 2 * margin_of(nodes, d);
            nodes->first[d] -= (double)margin_of(nodes, d) * lattice->step[d];
        }
        if (box->periodic[d] && box->edge[d] <= 2 * nodes->support)
            return scene_fail(context->scene, error, "fluid.spacing",
                              "the periodic %c edge, %g, must be longer than two support radii, %g", 'x' + d,
                              box->edge[d], 2 * nodes->support);
    }
    return true;
}

void nodes_deal(struct nodes *nodes) {
    int cut = nodes->cut = nodes->dimension - 1;
    int64_t margin = margin_of(nodes, cut), whole = nodes->whole[cut];
    nodes->own[0] = plane_of(nodes, nodes->comm->rank);
    nodes->own[1] = plane_of(nodes, nodes->comm->rank + 1);
    int64_t from = nodes->own[0] - margin, to = nodes->own[1] + margin;
    if (nodes->own[0] == nodes->own[1])
        from = to = nodes->own[0];
    if (!nodes->box->periodic[cut]) {
        from = from < 0 ? 0 : from;
        to = to > whole ? whole : to;
    } else if (to - from >= whole) {
        from = 0;
        to = whole;
    }
    nodes->plane = from;
    memcpy(nodes->count, nodes->whole, sizeof nodes->count);
    nodes->count[cut] = to - from;
    nodes->all = nodes->count[0] * nodes->count[1] * nodes->count[2];
}

/* Gathers the grains of all ranks on every rank. */
static void gather(struct nodes *nodes, const struct physics_context *context) {
    const struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    struct nodes_grain *mine = memory_allocate(p->owned, sizeof *mine, "grains in a fluid");
    size_t count = 0;
    void *all = NULL;
    for (size_t k = 0; k < p->owned; k++)
        if (kind[k] == KIND_GRAIN && !unresolved_is(context->options, p->state[k].radius)) {
            memcpy(mine[count].x, p->state[k].x, sizeof mine[count].x);
            mine[count].radius = p->state[k].radius;
            mine[count++].id = p->id[k];
        }
    int64_t total = (int64_t)count;
    comm_sum_int(context->comm, &total, 1);
    comm_gather_varying(context->comm, mine, count * sizeof *mine, &all, NULL);
    memory_free(mine);
    nodes->grains = (size_t)total;
    nodes->grain = memory_allocate(nodes->grains, sizeof *nodes->grain, "grains in a fluid");
    if (all)
        memcpy(nodes->grain, all, nodes->grains * sizeof *nodes->grain);
    memory_free(all);
    comm_broadcast(context->comm, nodes->grain, nodes->grains * sizeof *nodes->grain);
}

void nodes_claim(struct nodes *nodes, int64_t node, int32_t owner, double depth) {
    if (nodes->state[node] == NODES_ABSENT ||
        (nodes->state[node] == NODES_SOLID && !((float)depth > nodes->depth[node])))
        return;
    nodes->state[node] = NODES_SOLID;
    nodes->owner[node] = owner;
    nodes->depth[node] = (float)depth;
}

static void claim_if_inside(struct nodes *nodes, int32_t number, const int64_t at[3]) {
    const struct nodes_grain *grain = &nodes->grain[number];
    int64_t node = join(nodes, at);
    double x[3], square = 0;
    if (node < 0 || !arrangement_has(&nodes->lattice, at))
        return;
    place_at(nodes, at, x);
    displace(nodes, nodes_number(nodes, node), x);
    for (int d = 0; d < nodes->dimension; d++)
        square += (x[d] - grain->x[d]) * (x[d] - grain->x[d]);
    if (square <= grain->radius * grain->radius)
        nodes_claim(nodes, node, number, grain->radius - sqrt(square));
}

/* True if the planes of a number across the cut are held. */
static bool is_held(const struct nodes *nodes, int64_t plane) {
    int64_t held = plane - nodes->plane;
    if (nodes->box->periodic[nodes->cut])
        held = wrap(held, nodes->whole[nodes->cut]);
    return held >= 0 && held < nodes->count[nodes->cut];
}

/* Marks the nodes in a grain; places of nodes are not wrapped here, so that a grain reaches across the box. */
static void grain_mark(struct nodes *nodes, int32_t number) {
    const struct nodes_grain *grain = &nodes->grain[number];
    int64_t from[3], to[3], at[3];
    double reach = grain->radius + nodes->jitter * nodes->spacing;
    for (int d = 0; d < 3; d++) {
        bool flat = d >= nodes->dimension;
        double step = nodes->lattice.step[d];
        from[d] = flat ? 0 : (int64_t)floor((grain->x[d] - reach - nodes->first[d]) / step);
        to[d] = flat ? 0 : (int64_t)ceil((grain->x[d] + reach - nodes->first[d]) / step);
    }
    for (at[2] = from[2]; at[2] <= to[2]; at[2]++)
        for (at[1] = from[1]; at[1] <= to[1]; at[1]++) {
            if (!is_held(nodes, at[nodes->cut]))
                continue;
            for (at[0] = from[0]; at[0] <= to[0]; at[0]++)
                claim_if_inside(nodes, number, at);
        }
}

/* Marks the nodes behind a wall that is no mesh. */
static void wall_mark(struct nodes *nodes, const struct walls *walls, int wall) {
#pragma omp parallel for schedule(static)
    for (int64_t node = 0; node < nodes->all; node++) {
        struct wall_foot foot;
        double x[3];
        if (nodes->state[node] == NODES_ABSENT)
            continue;
        place_of(nodes, node, x);
        walls_foot(walls, wall, x, INFINITY, &foot);
        if (foot.distance <= 0)
            nodes_claim(nodes, node, -1 - wall, -foot.distance);
    }
}

/* Marks the nodes in the region and in the box as fluid, and counts them. */
static void region_mark(struct nodes *nodes, const struct fluid_options *options) {
    const struct box *box = nodes->box;
    struct region_space space = {.dimension = nodes->dimension, .plane = box->origin[2] + 0.5 * box->edge[2]};
    struct region region = options->fill.region;
    double length = sqrt(region.axis[0] * region.axis[0] + region.axis[1] * region.axis[1] +
                         region.axis[2] * region.axis[2]);
    for (int d = 0; d < 3 && length > 0; d++)
        region.axis[d] /= length;
    int64_t wanted = 0;
#pragma omp parallel for schedule(static) reduction(+ : wanted)
    for (int64_t node = 0; node < nodes->all; node++) {
        double x[3], user[3];
        int64_t at[3];
        bool inside = true;
        split(nodes, node, at);
        nodes->state[node] = NODES_ABSENT;
        if (!arrangement_has(&nodes->lattice, at))
            continue;
        nodes_place(nodes, nodes_number(nodes, node), x);
        for (int d = 0; d < 3; d++) {
            inside = inside && x[d] >= 0 && x[d] <= box->edge[d];
            user[d] = x[d] + box->origin[d];
        }
        nodes->state[node] = inside && region_contains(&region, &space, user, 0) ? NODES_FLUID : NODES_VOID;
        wanted += nodes->state[node] == NODES_FLUID && nodes_own(nodes, node);
    }
    comm_sum_int(nodes->comm, &wanted, 1);
    nodes->wanted = wanted;
}

/* Grains must be large enough for the spacing to see the flow around them. */
static bool grains_suit(const struct nodes *nodes, const struct physics_context *context,
                        struct error *error) {
    const double least = 4;
    for (size_t k = 0; k < nodes->grains; k++)
        if (2 * nodes->grain[k].radius < least * nodes->spacing)
            return scene_fail(context->scene, error, "fluid.spacing",
                              "%g is too coarse for grain %lld of diameter %g; needed are %g spacings a "
                              "diameter or more",
                              nodes->spacing, (long long)nodes->grain[k].id, 2 * nodes->grain[k].radius,
                              least);
    return true;
}

static int by_x(const void *a, const void *b) {
    const struct nodes_grain *x = a, *y = b;
    return (x->x[0] > y->x[0]) - (x->x[0] < y->x[0]);
}

bool nodes_make(struct nodes *nodes, const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    *nodes = (struct nodes){.dimension = context->box->dimension,
                            .spacing = options->spacing,
                            .lattice = arrangement_make(options, context->box),
                            .support = fluid_support(options, context->box->dimension),
                            .jitter = options->fill.jitter,
                            .box = context->box,
                            .comm = context->comm,
                            .seed = context->scene->seed};
    if (!arrangement_suits(&nodes->lattice, context, error) || !lay(nodes, context, options, error))
        return false;
    nodes_deal(nodes);
    gather(nodes, context);
    if (!grains_suit(nodes, context, error))
        return false;
    qsort(nodes->grain, nodes->grains, sizeof *nodes->grain, by_x);
    size_t all = (size_t)nodes->all;
    nodes->state = memory_allocate_zero(all, sizeof *nodes->state, "lattice of the fluid");
    nodes->owner = memory_allocate_zero(all, sizeof *nodes->owner, "lattice of the fluid");
    nodes->depth = memory_allocate_zero(all, sizeof *nodes->depth, "lattice of the fluid");
    region_mark(nodes, options);
    for (size_t k = 0; k < nodes->grains && !fluid_rigid(options); k++)
        grain_mark(nodes, (int32_t)k);
    for (int w = 0; w < context->scene->walls; w++)
        if (!wall_shape_meshed(context->scene->wall[w].shape) &&
            rigid_walls_bounds(context, &context->scene->wall[w]))
            wall_mark(nodes, grains_walls(context), w);
    return true;
}

void nodes_free(struct nodes *nodes) {
    memory_free(nodes->state);
    memory_free(nodes->owner);
    memory_free(nodes->depth);
    memory_free(nodes->grain);
    *nodes = (struct nodes){0};
}
