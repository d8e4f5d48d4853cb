/* SPDX-License-Identifier: BSD-3-Clause */
/* A fluid as a physics: its interaction, its particles, its passes. Read engine/physics.h and fluid_passes.h first. */
#include "base/memory.h"
#include "engine/physics.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/coupling/lubrication.h"
#include "physics/fluid/coupling/lubrication_pairs.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/coupling/rigid_motion.h"
#include "physics/fluid/coupling/rigid_step.h"
#include "physics/fluid/coupling/unresolved_grains.h"
#include "physics/fluid/carried/electrolyte.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/lattice/lattice_fill.h"
#include "physics/fluid/lattice/narrow_gaps.h"
#include "physics/fluid/lattice/surface_feet.h"
#include "physics/fluid/schemes/fluid_passes.h"
#include "physics/fluid/schemes/fluid_motion.h"
#include "physics/fluid/coupling/boundary_motion.h"
#include "physics/fluid/carried/scalars.h"
#include "physics/fluid/fluid_state.h"
#include "physics/fluid/schemes/solver_watch.h"
#include "kernel/particles/kinds.h"
#include "physics/grains/grains.h"
#include <math.h>

/* Grains meet grains and walls within the reach of lubrication; a wall has an infinite radius. */
static double range_of_grains(const struct fluid_options *options, int kind_a, double radius_a, int kind_b,
                              double radius_b) {
    bool meet = (kind_a == KIND_GRAIN || isinf(radius_a)) && (kind_b == KIND_GRAIN || isinf(radius_b));
    return meet && !isnan(options->grains.lubrication) ? LUBRICATION_REACH * options->spacing : -INFINITY;
}

/* Fluid meets fluid and boundary within the support, and grains whose surface is as near. */
static double range(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    const struct fluid *own = context;
    double support = own->support;
    bool fluid = kind_a == KIND_FLUID || kind_b == KIND_FLUID;
    bool grain = kind_a == KIND_GRAIN || kind_b == KIND_GRAIN;
    bool rides = kind_a != kind_b && grain && fluid_carries(own->options);
    if (kind_a == KIND_BODY || kind_b == KIND_BODY) /* its members are there */
        return -INFINITY;
    if (!(fluid || rides) || isinf(radius_a) || isinf(radius_b))
        return range_of_grains(own->options, kind_a, radius_a, kind_b, radius_b);
    if (!fluid) /* a boundary particle finds its grain */
        return 0;
    if (grain && fluid_rigid(own->options)) /* nodes of the solid (solid_field.h) */
        return SOLID_EDGE * own->options->spacing - (kind_a == KIND_GRAIN ? radius_b : radius_a);
    if (grain)
        return support - (kind_a == KIND_GRAIN ? radius_b : radius_a);
    return support - radius_a - radius_b;
}

static void *create(const struct physics_context *context) {
    struct fluid *fluid = memory_allocate_zero(1, sizeof *fluid, "fluid");
    fluid->options = context->options;
    fluid->drive = flow_drive_begin(fluid->options, context->box, &fluid->error);
    fluid->support = fluid_support(fluid->options, context->box->dimension);
    fluid->lattice = arrangement_make(fluid->options, context->box);
    if (grains_walls(context))
        walls_cover(grains_walls(context), surface_feet_reach(fluid->options, context->box));
    if (fluid->options->fill.jitter > 0 || fluid_motion_moves(fluid->options))
        fluid_fields_volumes(context->particles);
    else
        fluid->volume = fluid->lattice.volume;
    if (fluid->options->opens > 0)
        fluid_fields_open(context->particles);
    if (fluid_motion_moves(fluid->options))
        fluid_fields_moving(context->particles);
    fluid->riding = boundary_wanted(context);
    if (fluid->riding)
        fluid_fields_riding(context->particles);
    fluid->scalars = scalars_create(context);
    fluid->electrolyte = electrolyte_create(context);
    if (fluid_rigid(fluid->options)) {
        fluid_fields_free(context->particles);
        rigid_fields_add(context->particles);
        fluid->rigid = memory_allocate_zero(1, sizeof *fluid->rigid, "fluid");
        rigid_walls_create(&fluid->rigid->walls, context->scene);
    } else if (grain_free(fluid->options)) {
        fluid_fields_free(context->particles);
    }
    if (unresolved_any(fluid->options))
        unresolved_fields_add(fluid->options, context->particles);
    return fluid;
}

/* The part of all rows that may have singular tensors. */
static const double poor_most = 1e-3;

static void guard(const struct physics_context *context, struct error *error) {
    const struct fluid *fluid = context->self;
    if (error->kind == ERROR_NONE && fluid->error.kind != ERROR_NONE)
        *error = fluid->error;
    if (fluid->lost > 0)
        error_set(error, ERROR_PHYSICS, "fluid: %zu wall neighbours have lost their grain", fluid->lost);
    if (fluid->rows[2] > 0)
        error_set(error, ERROR_PHYSICS,
                  "fluid: %g particles of the fluid have gone behind a wall or into a grain in step %llu, t "
                  "= %.9g: shorter "
                  "steps, or motion: fixed",
                  fluid->rows[2], (unsigned long long)context->clock->step, context->clock->time);
    if (fluid->rows[1] > poor_most * fluid->rows[0])
        scene_fail(context->scene, error, "fluid.kernel.support",
                   "%g spacings give %g of %g particles too few neighbours for these operators; more "
                   "support is needed (2.2 on a cubic lattice)",
                   fluid->support / fluid->options->spacing, fluid->rows[1], fluid->rows[0]);
}

/* Bytes of the matrices of velocity and pressure, of multigrid and of Krylov vectors, a fluid particle. Steady: the peak of a flow through
 * 6,864 beads at 100, 64 and 40 um less particles, search and weights was 1820, 1580 and 1420. */
static const double bytes_steady = 1600, bytes_transient = 1400;

static void print(const struct physics_context *context, FILE *file) {
    const struct fluid *fluid = context->self;
    const uint8_t *kind = kinds_of(context->particles);
    bool steady = fluid->options->time == FLUID_STEADY;
    size_t rows = fluid->weights.rows;
    double sum[KINDS + 2] = {0};
    for (size_t k = 0; k < context->particles->owned; k++)
        sum[kind[k]]++;
    sum[KINDS] = rows > 0 ? (double)fluid->weights.start[rows] : 0;
    sum[KINDS + 1] = (double)weights_memory(&fluid->weights);
    comm_sum(context->comm, sum, KINDS + 2);
    if (context->comm->rank > 0)
        return;
    double fluids = sum[KIND_FLUID], solver = fluids * (steady ? bytes_steady : bytes_transient);
    fprintf(file, "\nfluid\n  particles    %.0f fluid, %.0f boundary, %.0f grains\n", fluids,
            sum[KIND_BOUNDARY], sum[KIND_GRAIN]);
    fprintf(file,
            "  neighbours   %.1f a fluid particle, within %.6g = %.3g spacings; %g have simpler operators\n",
            sum[KINDS] / fluids, fluid->support, fluid->support / fluid->options->spacing, fluid->rows[1]);
    fprintf(file, "  unknowns     %.0f: %d velocities and a pressure each; %d connected region%s\n",
            fluids * (context->box->dimension + 1), context->box->dimension, fluid->regions,
            fluid->regions == 1 ? "" : "s");
    fprintf(file, "  memory       weights %.1f MiB, matrices and solvers about %.0f MiB\n",
            sum[KINDS + 1] / 1048576, solver / 1048576);
    if (fluid->lattice.stretch > 0)
        fprintf(file, "  lattice      steps of %.6g, %.6g, %.6g: stretched by %.2g to fit the box\n",
                fluid->lattice.step[0], fluid->lattice.step[1], fluid->lattice.step[2],
                fluid->lattice.stretch);
    if (fluid->gaps)
        narrow_gaps_print(fluid->gaps, context, file);
    if (fluid->rigid != NULL)
        rigid_walls_print(&fluid->rigid->walls, context->scene, file);
    if (unresolved_any(fluid->options))
        fprintf(file, "  unresolved   grains up to the radius %.6g: the section drag moves them%s\n",
                fluid->options->grains.unresolved,
                unresolved_averaged(fluid->options) ? "; equations averaged over fluid and grains" : "");
    scalars_print(context, file);
    electrolyte_print(context, file);
    if (!steady && fluid->options->equations == FLUID_NAVIER_STOKES)
        fprintf(file, "  time step    up to half a spacing over the largest speed\n");
}

static void restart(const struct physics_context *context, struct restart *list) {
    struct fluid *fluid = context->self;
    /* matrices that stay keep their preconditioners, which follow from them */
    fluid->renew = fluid_motion_moves(fluid->options) || unresolved_averaged(fluid->options);
    restart_add(list, RESTART_INTEGER, false, &fluid->past.steps, "fluid: steps");
    restart_add(list, RESTART_REAL, false, &fluid->past.dt, "fluid: last time step");
    flow_drive_restart(&fluid->drive, fluid->options, list);
    if (grain_free(fluid->options) || unresolved_averaged(fluid->options))
        restart_add(list, RESTART_SUM, true, &fluid->work, "fluid: work on grains");
    if (fluid->rigid != NULL)
        rigid_walls_restart(&fluid->rigid->walls, context->scene, list);
    if (fluid->scalars == NULL)
        return;
    scalars_restart(fluid->scalars, list);
    restart_add(list, RESTART_INTEGER, true, &fluid->solved, "fluid: the steady flow is there");
}

static void energy(const struct physics_context *context, struct physics_energy *energy) {
    energy->work = ((const struct fluid *)context->self)->work;
}

/* Particles at rest have their weights from the first rebuild. */
static bool rests(const struct physics_context *context) {
    return !fluid_motion_moves(context->options) && !fluid_rigid(context->options);
}

static const struct physics_pass passes[] = {
    {.name = "kept",
     .why = "solved contacts of grains that a fluid moves",
     .place = PASS_FIRST,
     .timer = "flow",
     .reads = "force",
     .writes = "fluid_impulse",
     .needed = rigid_motion_solved,
     .whole = rigid_motion_gather_solved},
    {.name = "follow",
     .why = "particles of a fluid that move",
     .place = PASS_MOVE,
     .timer = "advance",
     .reads = "velocity fluid_velocity_before fluid_drift",
     .writes = "position",
     .needed = fluid_motion_needed,
     .rows = fluid_motion_move},
    {.name = "ride",
     .why = "boundary particles of grains that move in a fluid",
     .place = PASS_MOVED,
     .timer = "advance",
     .reads = "position velocity fluid_arm",
     .writes = "position velocity",
     .needed = boundary_wanted,
     .whole = boundary_follow},
    {.name = "lubrication",
     .why = "lubrication of grains that are near each other",
     .place = PASS_SHARES,
     .does = "lubrication that a fluid does not resolve",
     .reads = "position velocity",
     .writes = "force",
     .needed = lubrication_wanted,
     .whole = lubrication_pairs_add},
    {.name = "flow",
     .place = PASS_CLOSE,
     .does = "the flow of a fluid: operators, matrices and solves",
     .reads = "velocity pressure fluid_advection",
     .writes = "velocity pressure fluid_advection",
     .whole = fluid_passes_step},
    {.name = "look",
     .place = PASS_LOOK,
     .reads = "velocity pressure",
     .writes = "divergence drag",
     .whole = fluid_passes_look},
};

static const struct timer_stage stages[] = {
    {.name = "operators",
     .help = "weights of the operators of a fluid, and its walls",
     .use = TIMER_REBUILD | TIMER_WORK},
    {.name = "assembly", .help = "matrices of a fluid: filled, and handed to the solver", .use = TIMER_WORK},
    {.name = "preconditioner", .help = "preconditioners of these matrices made", .use = TIMER_WORK},
    {.name = "solve", .help = "solves for velocity and pressure of a fluid", .use = TIMER_WORK}};

static const struct physics_maker maker = {
    .moving = fluid_motion_kinds, .fill = lattice_fill_run, .admit = grain_admit};
static const struct physics_shown shown = {
    .stages = sizeof stages / sizeof stages[0], .stage = stages, .report = solver_watch_report};

static const struct physics_search search = {.interactions = 1,
                                             .interaction = {{.name = "fluid", .range = range}},
                                             .range_of_self = true,
                                             .rests = rests};
static const struct physics_limit limits = {
    .of = fluid_passes_limit, .why = "advection: the fluid may move by half a spacing in a step"};

static bool carries(const void *options, double *density, double *viscosity, double *largest) {
    const struct fluid_options *fluid = options;
    *density = fluid->density;
    *viscosity = fluid->viscosity;
    *largest = fluid->grains.unresolved;
    return unresolved_any(fluid);
}

static const struct physics_carrier carrier = {.of = carries};

const struct physics fluid_physics = {.name = "fluid",
                                      .passes = sizeof passes / sizeof passes[0],
                                      .pass = passes,
                                      .check = lattice_fill_suits,
                                      .create = create,
                                      .destroy = fluid_passes_end,
                                      .rebuilt = fluid_passes_rebuilt,
                                      .guard = guard,
                                      .print = print,
                                      .energy = energy,
                                      .restart = restart,
                                      .maker = &maker,
                                      .shown = &shown,
                                      .search = &search,
                                      .limit = &limits,
                                      .carrier = &carrier};
