/* SPDX-License-Identifier: BSD-3-Clause */
/* Shares from the surfaces around each row. Read shares.h and layer.h first. */
#include "physics/fluid/carried/shares.h"
#include "base/memory.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include "physics/fluid/coupling/rigid_sums.h"
#include "physics/fluid/coupling/unresolved_grains.h"
#include "physics/fluid/lattice/surface_feet.h"
#include "physics/fluid/schemes/boundary_values.h"
#include "physics/fluid/carried/layer.h"
#include "physics/grains/grains.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

/* Bodies beside one row that are looked at. */
enum { NEAR_MOST = 16 };

struct build {
    const struct physics_context *context;
    const struct fluid *fluid;
    const struct fluid_surface *surface;
    int surfaces;
    const double *given;
    const uint8_t *group;
};

/* The feet of a row, within the reach of layer.h. */
struct near {
    int count;
    struct weights_foot foot[NEAR_MOST];
};

static void near_add(const struct build *build, struct near *near, const struct weights_foot *foot) {
    if (foot->distance < LAYER_REACH * build->fluid->options->spacing && near->count < NEAR_MOST)
        near->foot[near->count++] = *foot;
}

static void grains_add(const struct build *build, size_t i, struct near *near) {
    const struct weights_input *input = &build->fluid->input;
    const struct particles *p = input->particles;
    if (build->fluid->rigid != NULL) /* grains are part of the fluid, and move */
        return;
    for (size_t e = input->pairs->start[i]; e < input->pairs->start[i + 1]; e++) {
        size_t j = pair_partner(input->pairs->partner[e]);
        const double *shift = input->shift[pair_image(input->pairs->partner[e])];
        struct weights_foot foot = {0};
        double away[3];
        if (input->kind[j] != KIND_GRAIN || unresolved_is(build->fluid->options, p->state[j].radius) ||
            boundary_values_number(build->surface, build->surfaces, p->id[j],
                                   build->group ? build->group[j] : -1) >= 0)
            continue;
        for (int d = 0; d < 3; d++)
            away[d] = p->state[i].x[d] - p->state[j].x[d] - shift[d];
        body_sphere_foot(away, p->state[j].radius, input->dimension, p->state[j].v, NULL, &foot);
        near_add(build, near, &foot);
    }
}

static void walls_add(const struct build *build, size_t i, struct near *near) {
    const struct physics_context *context = build->context;
    const struct feet feet = {grains_walls(context), build->fluid->options, context->box};
    int walls = grains_walls(context) != NULL ? walls_count(grains_walls(context)) : 0;
    for (int wall = 0; wall < walls; wall++) {
        struct weights_foot foot = {0};
        bool through = build->fluid->rigid != NULL && build->fluid->rigid->walls.wall[wall].body;
        if (through || context->scene->wall[wall].permeable ||
            boundary_values_number(build->surface, build->surfaces, body_of_wall(wall), -1) >= 0)
            continue;
        surface_feet_on(&feet, body_of_wall(wall), context->particles->state[i].x, &foot);
        near_add(build, near, &foot);
    }
}

/* The nearest foot; NULL: none. */
static const struct weights_foot *near_first(const struct near *near) {
    const struct weights_foot *first = NULL;
    for (int k = 0; k < near->count; k++)
        if (first == NULL || near->foot[k].distance < first->distance)
            first = &near->foot[k];
    return first;
}

/* t of layer.h: of the nearest surface, and of what lies across. */
static double part_of(const struct near *near, const struct weights_foot *first, double spacing) {
    double gap = INFINITY, distance = fmax(first->distance, 0);
    for (int k = 0; k < near->count; k++) {
        double along = 0;
        for (int d = 0; d < 3; d++)
            along -= near->foot[k].normal[d] * first->normal[d];
        if (along > 0)
            gap = fmin(gap, distance + fmax(near->foot[k].distance, 0) / along);
    }
    return layer_part(distance / spacing, gap / spacing);
}

/* True if a foot lets nothing through. */
static bool closed(const struct build *build, size_t foot) {
    return !build->fluid->weights.foot[foot].open && (build->given == NULL || isnan(build->given[foot]));
}

/* The nearest closed foot of a row; NULL: none. */
static const struct weights_foot *closed_foot(const struct build *build, size_t row) {
    const struct weights *weights = &build->fluid->weights;
    const struct weights_foot *nearest = NULL;
    for (size_t k = weights->foot_start[row]; k < weights->foot_start[row + 1]; k++)
        if (closed(build, k) && (nearest == NULL || weights->foot[k].distance < nearest->distance))
            nearest = &weights->foot[k];
    return nearest;
}

/* The square of the part of x_j - x_i of an entry along a wall, and (x / r)^2. */
struct along {
    double square, share;
};

static struct along along_of(const struct build *build, size_t row, size_t entry, const double normal[3]) {
    const struct weights *weights = &build->fluid->weights;
    double apart[3], square = 0, across = 0;
    weights_apart(weights, &build->fluid->input, row, entry, apart);
    for (int d = 0; d < weights->dimension; d++) {
        across += apart[d] * normal[d];
        square += apart[d] * apart[d];
    }
    double along = fmax(square - across * across, 0);
    return (struct along){along, along / square};
}

/* m of a row whose nearest wall has this normal, and that stands for `part`. */
static double more_of(const struct build *build, size_t row, const double normal[3], double part) {
    const struct weights *weights = &build->fluid->weights;
    size_t walls = weights_walls(weights, row), w = weights->wall_start[row];
    double left = 0, slope = 0;
    for (size_t e = weights->start[row]; e < weights->start[row + 1]; e++) {
        if (e >= walls && closed(build, weights->wall_foot[w++]))
            continue;
        struct along along = along_of(build, row, e, normal);
        double term = 0.5 * weights_scalar(weights, e) * along.square / (weights->dimension - 1);
        left += term;
        slope += e < walls ? term * along.share : 0;
    }
    return slope > 0 ? fmin((part - left) / slope, SHARES_MOST) : 0;
}

/* m and the normal of a row; without a body 0. */
static void row_make(const struct build *build, size_t row) {
    const struct flow *flow = &build->fluid->flow;
    size_t i = build->fluid->weights.first + row;
    struct near near = {0};
    grains_add(build, i, &near);
    walls_add(build, i, &near);
    const struct weights_foot *foot = near_first(&near);
    double part = foot != NULL ? part_of(&near, foot, build->fluid->options->spacing) : 1;
    if (foot == NULL)
        foot = closed_foot(build, row);
    for (size_t d = 0; d < 3; d++)
        flow->predicted[3 * i + d] = foot != NULL ? foot->normal[d] : 0;
    flow->increment[i] = foot != NULL ? more_of(build, row, foot->normal, part) : 0;
}

/* k of the fluid entries of a row. */
static void row_share(const struct build *build, size_t row, double *share) {
    const struct weights *weights = &build->fluid->weights;
    const struct flow *flow = &build->fluid->flow;
    size_t i = weights->first + row;
    for (size_t e = weights->start[row]; e < weights->start[row + 1]; e++) {
        size_t j = pair_partner(weights->partner[e]);
        share[e] = 1;
        if (e >= weights_walls(weights, row) || (flow->increment[i] == 0 && flow->increment[j] == 0))
            continue;
        double own = flow->increment[i] * along_of(build, row, e, flow->predicted + 3 * i).share,
               other = flow->increment[j] * along_of(build, row, e, flow->predicted + 3 * j).share;
        share[e] = fmax(1 + 0.5 * (own + other), 0);
    }
}

double *shares_make(const struct physics_context *context, const struct fluid_surface *surface, int surfaces,
                    const double *given) {
    struct fluid *fluid = context->self;
    const struct build build = {context, fluid, surface, surfaces, given, groups_of(context->particles)};
    double *share =
        memory_allocate(fluid->weights.start[fluid->weights.rows], sizeof *share, "shares beside bodies");
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < fluid->weights.rows; row++)
        row_make(&build, row);
    flow_forward(&fluid->flow, FLOW_INCREMENT);
    flow_forward(&fluid->flow, FLOW_PREDICTED);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < fluid->weights.rows; row++)
        row_share(&build, row, share);
    return share;
}
