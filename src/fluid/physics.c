/* SPDX-License-Identifier: BSD-3-Clause */
/* A fluid as a physics: its interaction, its particles, its weights after each rebuild, its passes. Read
 * engine/physics.h and weights.h first. */
#include "contact/spin.h"
#include "core/memory.h"
#include "engine/physics.h"
#include "fluid/fields.h"
#include "fluid/fill.h"
#include "fluid/mirror.h"
#include "fluid/state.h"
#include "particles/kinds.h"
#include "walls/wall.h"
#include <math.h>
#include <string.h>

/* Fluid meets fluid and boundary within the support, and grains whose surface is as near. */
static double range(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    const struct fluid_options *options = context;
    double support = options->spacing * (isnan(options->kernel.support) ? 3.1 : options->kernel.support);
    bool fluid = kind_a == KIND_FLUID || kind_b == KIND_FLUID;
    if (!fluid || isinf(radius_a) || isinf(radius_b))
        return -INFINITY;
    if (kind_a == KIND_GRAIN || kind_b == KIND_GRAIN)
        return support - (kind_a == KIND_GRAIN ? radius_b : radius_a);
    return support - radius_a - radius_b;
}

static void *create(const struct physics_context *context) {
    struct fluid *fluid = memory_allocate_zero(1, sizeof *fluid, "fluid");
    fluid->options = context->options;
    fluid->support = fluid_support(fluid->options, context->box->dimension);
    fluid->volume =
        fluid->options->fill.jitter > 0 ? 0 : kernel_power(fluid->options->spacing, context->box->dimension);
    return fluid;
}

static void destroy(void *self) {
    struct fluid *fluid = self;
    weights_free(&fluid->weights);
    pair_rows_free(&fluid->pairs);
    memory_free(fluid);
}

static void wall_foot(const void *context, int wall, const double x[3], struct weights_foot *foot) {
    struct wall_foot found;
    walls_foot(context, wall, x, &found);
    foot->distance = found.distance;
    memcpy(foot->normal, found.normal, sizeof foot->normal);
    memcpy(foot->velocity, found.velocity, sizeof foot->velocity);
}

/* Weights and mirrors from the new list. */
static void rebuilt(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    struct kind_span span = kinds_span(p, context->classes, KIND_FLUID);
    pair_rows_build(&fluid->pairs, context->list[0], p->owned);
    const struct weights_input input = {.particles = p,
                                        .kind = kinds_of(p),
                                        .first = span.first,
                                        .end = span.end,
                                        .pairs = &fluid->pairs,
                                        .shift = (const double(*)[4])context->list[0]->shift,
                                        .dimension = context->box->dimension};
    const struct weights_options options = {
        .kernel = kernel_make(fluid->options->kernel.name, fluid->support, context->box->dimension),
        .operators = fluid->options->operators,
        .spacing = fluid->options->spacing,
        .volume = fluid->volume,
        .slip = fluid_slip(fluid->options)};
    weights_make(&fluid->weights, &input, &options);
    const struct mirror_input mirror = {.rows = &input,
                                        .body = fluid_body(p),
                                        .spin = (const double(*)[4])spin_of(p),
                                        .spacing = fluid->options->spacing,
                                        .wall = wall_foot,
                                        .context = context->walls};
    fluid->lost = mirror_make(&fluid->weights, &mirror);
    pair_rows_free(&fluid->pairs);
    fluid->rows[0] = (double)fluid->weights.rows;
    fluid->rows[1] = (double)fluid->weights.poor;
    comm_sum(context->comm, fluid->rows, 2);
}

/* The part of all rows that may have singular tensors. */
static const double poor_most = 1e-3;

static void guard(const struct physics_context *context, struct error *error) {
    const struct fluid *fluid = context->self;
    if (fluid->lost > 0)
        error_set(error, ERROR_PHYSICS, "fluid: %zu wall neighbours have lost their grain", fluid->lost);
    if (fluid->rows[1] > poor_most * fluid->rows[0])
        scene_fail(context->scene, error, "fluid.kernel.support",
                   "%g spacings give %g of %g particles too few neighbours for the corrected operators; more "
                   "support is needed (2.2 on a cubic lattice)",
                   fluid->support / fluid->options->spacing, fluid->rows[1], fluid->rows[0]);
}

const struct physics fluid_physics = {.name = "fluid",
                                      .interactions = 1,
                                      .interaction = {{.name = "fluid", .range = range}},
                                      .create = create,
                                      .destroy = destroy,
                                      .fill = fill_run,
                                      .rebuilt = rebuilt,
                                      .guard = guard};
