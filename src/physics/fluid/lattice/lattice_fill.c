/* SPDX-License-Identifier: BSD-3-Clause */
/* From nodes of the lattice to particles. Read lattice_fill.h first. */
#include "physics/fluid/lattice/lattice_fill.h"
#include "physics/grains/grains.h"
#include "base/memory.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/coupling/rigid_suits.h"
#include "physics/fluid/coupling/rigid_walls.h"
#include "physics/fluid/carried/electrolyte.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/lattice/lattice_fill_parts.h"
#include "physics/fluid/lattice/narrow_gaps.h"
#include "physics/fluid/schemes/fluid_motion.h"
#include "physics/fluid/schemes/open_sides.h"
#include "physics/fluid/lattice/regions.h"
#include "physics/fluid/carried/scalars.h"
#include "physics/fluid/fluid_state.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include "physics/solve/solve.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Vortices of one wave an edge in x and y, and their pressure without viscosity. */
static double taylor_green(const struct nodes *nodes, const struct fluid_options *options, const double x[3],
                           double v[3]) {
    double u = options->initial.speed, k = 2 * M_PI / nodes->box->edge[0];
    v[0] = u * sin(k * x[0]) * cos(k * x[1]);
    v[1] = -u * cos(k * x[0]) * sin(k * x[1]);
    v[2] = 0;
    return options->equations == FLUID_NAVIER_STOKES
               ? options->density * u * u / 4 * (cos(2 * k * x[0]) + cos(2 * k * x[1]))
               : 0;
}

/* The flow at the start; returns the pressure. */
static double flow_at(const struct nodes *nodes, const struct fluid_options *options, const double x[3],
                      double v[3]) {
    if (options->initial.profile == FLUID_TAYLOR_GREEN)
        return taylor_green(nodes, options, x, v);
    memcpy(v, options->initial.velocity, 3 * sizeof *v);
    return 0;
}

static int64_t body_at(const struct nodes *nodes, int64_t node) {
    int32_t owner = nodes->owner[node];
    return owner == REGIONS_NOBODY ? BODY_NONE
           : owner < 0             ? body_of_wall(-1 - owner)
                                   : nodes->grain[owner].id;
}

/* Appends the particle of a node. */
static void append(const struct nodes *nodes, const struct physics_context *context, int64_t node,
                   int64_t first_id) {
    struct particles *p = context->particles;
    bool fluid = nodes->state[node] == NODES_FLUID;
    size_t i = particles_append(p);
    struct particle_state *state = &p->state[i];
    nodes_place(nodes, nodes_number(nodes, node), state->x);
    state->radius = 0.5 * nodes->spacing;
    p->id[i] = first_id + nodes_number(nodes, node);
    kinds_of(p)[i] = fluid ? KIND_FLUID : KIND_BOUNDARY;
    if (fluid) {
        fluid_pressure(p)[i] = flow_at(nodes, context->options, state->x, state->v);
        fluid_region(p)[i] = nodes->owner[node];
        scalars_begin(context, i);
    } else {
        fluid_body(p)[i] = body_at(nodes, node);
    }
}

/* The lowest number on the lattice of a fluid node at a side without a wall: a node within the support is neither fluid
 * nor solid. -1: there is none. Collective. */
static int64_t open_find(const struct nodes *nodes) {
    int(*steps)[3];
    size_t count = arrangement_around(&nodes->lattice, nodes->spacing, nodes->support, &steps);
    int64_t open = INT64_MAX;
#pragma omp parallel for schedule(static) reduction(min : open)
    for (int64_t node = 0; node < nodes->all; node++) {
        int64_t number = nodes_number(nodes, node);
        if (nodes->state[node] != NODES_FLUID || number > open || !nodes_own(nodes, node))
            continue;
        for (size_t k = 0; k < count; k++) {
            int64_t next = nodes_neighbour(nodes, node, steps[k]);
            if (next < 0 || nodes->state[next] == NODES_VOID)
                open = number < open ? number : open;
        }
    }
    memory_free(steps);
    open = -open;
    comm_max_int(nodes->comm, &open, 1);
    return open > -INT64_MAX ? -open : -1;
}

/* Refuses a lattice without fluid, and says where its nodes are. Collective. */
static bool dry(const struct nodes *nodes, const struct physics_context *context, struct error *error) {
    int64_t solid[2] = {0, 0}; /* in grains; behind walls and sides */
    for (int64_t node = 0; node < nodes->all; node++)
        if (nodes->state[node] == NODES_SOLID && nodes_own(nodes, node) && nodes->wanted > 0)
            solid[nodes->owner[node] < 0]++;
    comm_sum_int(nodes->comm, solid, 2);
    if (nodes->wanted == 0)
        return scene_fail(context->scene, error, "fluid.fill",
                          "there is no fluid: no node of the lattice lies in the region and in the box");
    return scene_fail(
        context->scene, error, "fluid.fill",
        "there is no fluid: grains or walls stand at all %lld nodes of the lattice in the region (%lld "
        "nodes lie in grains, %lld behind walls, those outside of the region counted)",
        (long long)nodes->wanted, (long long)solid[0], (long long)solid[1]);
}

/* Refuses a lattice without fluid, or with a side that nothing bounds. */
static bool suits(const struct nodes *nodes, const struct regions *regions,
                  const struct physics_context *context, struct error *error) {
    if (regions->count == 0)
        return dry(nodes, context, error);
    int64_t open = open_find(nodes);
    if (open < 0)
        return true;
    double x[3];
    char side[64] = "";
    nodes_place(nodes, open, x);
    for (int k = 0; k < 2 * nodes->dimension; k++) {
        double away = k % 2 ? context->box->edge[k / 2] - x[k / 2] : x[k / 2];
        if (!context->box->periodic[k / 2] && away < nodes->support && side[0] == '\0')
            snprintf(side, sizeof side, ", the side %s of the box", open_name(k));
    }
    for (int d = 0; d < 3; d++)
        x[d] += context->box->origin[d];
    return scene_fail(
        context->scene, error, "fluid.fill",
        "the fluid has an open side near (%g, %g, %g)%s; needed there: a wall, a grain, a periodic "
        "direction, or, at a side of the box, a velocity or pressure in fluid.open (free "
        "surfaces are not built yet)",
        x[0], x[1], x[2], side);
}

/* Taylor and Green's vortices need a square that repeats. */
static bool flow_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    const struct box *box = context->box;
    return options->initial.profile != FLUID_TAYLOR_GREEN ||
           (box->periodic[0] && box->periodic[1] &&
            fabs(box->edge[0] - box->edge[1]) <= 1e-9 * box->edge[0]) ||
           scene_fail(context->scene, error, "fluid.initial.flow",
                      "taylor_green needs a box that is periodic in x and y and as long in x as in y");
}

static bool solver_there(const struct physics_context *context, struct error *error) {
    return solve_available() || scene_fail(context->scene, error, "fluid",
                                           "this program was built without PETSc, which solves the equations "
                                           "of a fluid; install it (Debian: "
                                           "libpetsc-real-dev) and configure again");
}

/* A flow in time is stable where the divergence of the gradient is at most 4/3 of the Laplacian of the pressure, for any pressure. Of moving least
 * squares that goes for order 1, and without bodies for orders 2 and 4 (order 3 has up to 1.56 on a square lattice): beside bodies, where their neighbours
 * drop out, the small or negative weights of near neighbours are too large a part. */
static bool operators_suit(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    const struct scene *scene = context->scene;
    bool bounded = scene->sources > 0 || scene->walls > 0 || options->opens > 0;
    int order = options->operators.name == WEIGHTS_MLS ? options->operators.order : 1;
    return options->time == FLUID_STEADY || order == 1 || (order != 3 && !bounded) ||
           scene_fail(
               scene, error, "fluid.operators",
               "moving least squares of order %d let a flow in time grow without bound; allowed in time: "
               "order 1, and orders 2 and 4 without walls, grains (unresolved ones, too) and open sides; "
               "with time: steady all",
               order);
}

/* Combinations of keys. */
static bool options_suit(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    if (options->time == FLUID_STEADY && options->equations != FLUID_STOKES)
        return scene_fail(
            context->scene, error, "fluid.time",
            "steady goes with equations: stokes alone; for the steady flow of navier_stokes run a "
            "transient one until it no longer changes");
    if (context->scene->reproducible)
        return scene_fail(
            context->scene, error, "reproducible",
            "the linear systems of a fluid are solved in sums that depend on the layout; allowed "
            "beside `fluid`: false");
    return operators_suit(context, error) && flow_drive_suits(context, error) &&
           fluid_motion_suits(context, error) && grain_suits(context, error) && rigid_suits(context, error) &&
           scalars_suit(context, error) && electrolyte_suits(context, error);
}

/* Meshes must be closed, in three dimensions. */
static bool walls_suit(const struct physics_context *context, struct error *error) {
    for (int w = 0; w < context->scene->walls; w++) {
        const struct wall_options *wall = &context->scene->wall[w];
        size_t open = walls_open_edges(grains_walls(context), w);
        char key[64];
        if (wall->permeable)
            continue;
        snprintf(key, sizeof key, "walls[%d].free", w);
        if (wall->free.given)
            return scene_fail(
                context->scene, error, key,
                "wall '%s' is free, which no wall beside `fluid` may be: the fluid does not push it; "
                "allowed: walls at rest or with a given motion, and bodies (`bodies`) that the fluid moves",
                wall->name);
        snprintf(key, sizeof key, "walls[%d].file", w);
        if (open > 0)
            return scene_fail(
                context->scene, error, key,
                "wall '%s' has %zu edges that are not shared by two triangles of one orientation; beside "
                "`fluid` a mesh must be closed, with normals that point to the fluid",
                wall->name, open);
        if (wall_shape_meshed(wall->shape) && context->box->dimension == 2 &&
            !rigid_walls_through(context, wall))
            return scene_fail(
                context->scene, error, key,
                "wall '%s' is a mesh, which cannot bound a fluid of two dimensions; take planes and "
                "cylinders, or fluid.grains: {coupling: rigid}",
                wall->name);
        if (!rigid_walls_suit(context, w, error))
            return false;
    }
    return true;
}

bool lattice_fill_suits(const struct physics_context *context, struct error *error) {
    return solver_there(context, error) && options_suit(context, error) && open_suits(context, error) &&
           flow_suits(context, error) && walls_suit(context, error);
}

bool lattice_fill_run(const struct physics_context *context, const struct physics_share *share,
                      struct error *error) {
    struct nodes nodes = {0};
    struct regions regions = {0};
    bool good = grain_grains_suit(context, error) && nodes_make(&nodes, context, error);
    if (good) {
        surface_marks_make(&nodes, context);
        regions = regions_find(&nodes);
    }
    good = good && suits(&nodes, &regions, context, error) &&
           lattice_fill_open_suits(&nodes, &regions, context, error);
    for (int64_t node = 0; good && node < nodes.all; node++) {
        bool deep = nodes.state[node] == NODES_SOLID && nodes.depth[node] >= nodes.support;
        bool wanted = nodes.state[node] == NODES_FLUID || (nodes.state[node] == NODES_SOLID && !deep);
        if (wanted && nodes_own(&nodes, node))
            append(&nodes, context, node, share->first_id);
    }
    if (good && regions.pocket > 0 && context->comm->rank == 0)
        log_tell(context->log, "note: %lld of %lld nodes of the fluid lie in closed pockets, and are solid",
                 (long long)regions.pocket, (long long)(regions.pocket + regions.fluid));
    struct fluid *fluid = context->self;
    if (good) {
        fluid->gaps = memory_allocate(1, sizeof *fluid->gaps, "gaps");
        *fluid->gaps = narrow_gaps_find(&nodes, context);
    }
    fluid->filled = good;
    if (good && context->comm->rank == 0)
        narrow_gaps_note(fluid->gaps, context);
    nodes_free(&nodes);
    return good;
}

/* True if a body is a wall or an open side that the scene lacks. */
static bool body_missing(const struct physics_context *context, int64_t body) {
    return body_side(body) >= 0 ? open_at(context->options, body_side(body)) == NULL
                                : body < BODY_NONE && body_wall(body) >= context->scene->walls;
}

/* A particle of the fluid has the spacing of the scene, and a wall or an open side of the scene as its body. */
static bool kept_suits(const struct physics_context *context, size_t i, struct error *error) {
    const struct fluid_options *options = context->options;
    const struct particles *p = context->particles;
    double spacing = 2 * p->state[i].radius;
    int64_t body = kinds_of(p)[i] == KIND_BOUNDARY ? fluid_body(p)[i] : BODY_NONE;
    if (!(fabs(spacing - options->spacing) <= 1e-9 * options->spacing))
        return scene_fail(
            context->scene, error, "fluid.spacing",
            "the particles of the fluid were made with a spacing of %g; allowed in a resume and in "
            "a later stage: this one",
            spacing);
    if (!body_missing(context, body))
        return true;
    if (body_side(body) >= 0)
        return scene_fail(
            context->scene, error, "fluid.open",
            "the side %s bounds the fluid and is missing; allowed in a resume and in a later stage: "
            "the sides of the start",
            open_name(body_side(body)));
    return scene_fail(
        context->scene, error, "walls",
        "wall number %d bounds the fluid and is missing (%d are given); allowed in a resume and in a "
        "later stage: the walls of the start, in their order",
        body_wall(body) + 1, context->scene->walls);
}

bool lattice_fill_kept_suits(const struct physics_context *context, struct error *error) {
    const struct particles *p = context->particles;
    bool good = grain_grains_suit(context, error);
    for (size_t i = 0; good && i < p->owned; i++)
        good = kinds_of(p)[i] == KIND_GRAIN || kinds_of(p)[i] == KIND_BODY || kept_suits(context, i, error);
    for (size_t i = 0; i < p->owned + p->ghosts; i++)
        if (kinds_of(p)[i] == KIND_BOUNDARY && body_missing(context, fluid_body(p)[i]))
            fluid_body(p)[i] = BODY_NONE; /* until the guard stops the run */
    return comm_agree(context->comm, error) && good;
}
