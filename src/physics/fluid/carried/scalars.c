/* SPDX-License-Identifier: BSD-3-Clause */
/* Steps of the scalars that a fluid carries. Read scalars.h first. */
#include "physics/fluid/carried/scalars.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "base/memory.h"
#include "base/timer.h"
#include "physics/fluid/operators/neighbour_fluxes.h"
#include "physics/fluid/schemes/boundary_values.h"
#include "physics/fluid/carried/scalar_links.h"
#include "physics/fluid/schemes/fluid_motion.h"
#include "physics/fluid/schemes/residual.h"
#include "physics/fluid/carried/scalars_fields.h"
#include "physics/fluid/carried/shares.h"
#include "kernel/particles/fields.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Relative residual of a step. */
#define TOLERANCE 1e-10

/* From this g dt D / spacing^2 on Jacobi takes too many iterations. */
#define JACOBI_MOST 20.0

/* One scalar. All owned. */
struct scalar {
    struct solve_system *system; /* NULL: not made yet */
    double factor;               /* g dt of its values; NAN: none */
    double *given;               /* by foot: the value there; NAN: none */
    double *share;               /* by entry (shares.h) */
    double (*flux)[3];           /* by row, of the last look; NULL: none yet */
};

struct scalars {
    const struct fluid_options *options; /* borrowed */
    struct assembly assembly;
    bool made; /* the pattern of the matrices is there */
    struct fluxes fluxes;
    struct scalar scalar[FLUID_SCALARS_MAX];
    double *side, *solution; /* [rows] */
    int64_t steps;           /* made so far */
    double dt;               /* of the last step */
};

bool scalars_suit(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    if (options->scalars > 0 && fluid_motion_moves(options))
        return scene_fail(context->scene, error, "fluid.scalars",
                          "scalars go with fluid.motion: fixed alone");
    for (int k = 0; k < options->scalars; k++) {
        struct fluid_surface surface[FLUID_SURFACES_MAX];
        char key[64];
        for (int g = 0; g < options->scalar[k].givens; g++)
            surface[g] = options->scalar[k].given[g].at;
        snprintf(key, sizeof key, "fluid.scalars[%d].given", k);
        if (!boundary_values_suits(context, key, surface, options->scalar[k].givens, error))
            return false;
    }
    return true;
}

struct scalars *scalars_create(const struct physics_context *context) {
    const struct fluid_options *options = context->options;
    if (options->scalars == 0)
        return NULL;
    struct scalars *scalars = memory_allocate_zero(1, sizeof *scalars, "scalars of a fluid");
    scalars->options = options;
    scalars_fields(context->particles, options->scalars);
    return scalars;
}

void scalars_begin(const struct physics_context *context, size_t i) {
    const struct fluid_options *options = context->options;
    const struct box *box = context->box;
    const struct particles *p = context->particles;
    const struct region_space space = {.dimension = box->dimension,
                                       .plane = box->origin[2] + 0.5 * box->edge[2]};
    double x[3];
    for (int d = 0; d < 3; d++)
        x[d] = p->state[i].x[d] + box->origin[d];
    for (int k = 0; k < options->scalars; k++) {
        const struct fluid_scalar_initial *initial = &options->scalar[k].initial;
        struct region region = initial->region;
        double length = sqrt(region.axis[0] * region.axis[0] + region.axis[1] * region.axis[1] +
                             region.axis[2] * region.axis[2]);
        for (int d = 0; d < 3 && length > 0; d++)
            region.axis[d] /= length;
        bool inside = region_contains(&region, &space, x, 0);
        scalars_value(p, k)[i] = inside ? initial->value : initial->elsewhere;
    }
}

void scalars_forget(struct scalars *scalars) {
    if (scalars == NULL)
        return;
    for (int k = 0; k < scalars->options->scalars; k++) {
        struct scalar *scalar = &scalars->scalar[k];
        solve_destroy(&scalar->system);
        memory_free(scalar->given);
        memory_free(scalar->share);
        memory_free(scalar->flux);
        *scalar = (struct scalar){0};
    }
    neighbour_fluxes_free(&scalars->fluxes);
    assembly_free(&scalars->assembly);
    memory_free(scalars->side);
    memory_free(scalars->solution);
    scalars->side = scalars->solution = NULL;
    scalars->made = false;
}

void scalars_destroy(struct scalars **scalars) {
    scalars_forget(*scalars);
    memory_free(*scalars);
    *scalars = NULL;
}

static struct links links_of(const struct fluid *fluid, int k) {
    const struct fluid_scalar *options = &fluid->options->scalar[k];
    return (struct links){.weights = &fluid->weights,
                          .diffusivity = options->diffusivity,
                          .carry = fluid->scalars->fluxes.carry,
                          .upwind = options->advection == FLUID_UPWIND,
                          .given = fluid->scalars->scalar[k].given,
                          .filled = rigid_fields_solid(fluid->input.particles),
                          .share = fluid->scalars->scalar[k].share,
                          .input = &fluid->input};
}

/* What is given at the feet of scalar k, and the shares beside the others. */
static void surface_make(const struct physics_context *context, int k) {
    const struct fluid *fluid = context->self;
    const struct fluid_scalar *options = &fluid->options->scalar[k];
    struct scalar *scalar = &fluid->scalars->scalar[k];
    size_t feet = fluid->weights.foot_start[fluid->weights.rows];
    struct fluid_surface surface[FLUID_SURFACES_MAX];
    int *number = memory_allocate(feet, sizeof *number, "scalars of a fluid");
    for (int g = 0; g < options->givens; g++)
        surface[g] = options->given[g].at;
    boundary_values_find(context, &fluid->weights, surface, options->givens, number);
    scalar->given = memory_resize(scalar->given, feet, sizeof *scalar->given, "scalars of a fluid");
    for (size_t foot = 0; foot < feet; foot++)
        scalar->given[foot] = number[foot] >= 0 ? options->given[number[foot]].value : NAN;
    memory_free(number);
    memory_free(scalar->share);
    scalar->share = shares_make(context, surface, options->givens, scalar->given);
}

void scalars_rebuilt(const struct physics_context *context) {
    const struct fluid *fluid = context->self;
    for (int k = 0; fluid->scalars != NULL && k < fluid->scalars->options->scalars; k++)
        surface_make(context, k);
}

/* What does not change with the step. */
static bool prepare(struct fluid *fluid) {
    struct scalars *scalars = fluid->scalars;
    if (scalars->made)
        return true;
    size_t rows = fluid->weights.rows;
    if (!assembly_make(&scalars->assembly, &fluid->flow, &fluid->error))
        return false;
    scalars->side = memory_allocate(rows, sizeof(double), "scalars of a fluid");
    scalars->solution = memory_allocate(rows, sizeof(double), "scalars of a fluid");
    scalars->made = true;
    return true;
}

/* Makes the matrix of scalar k for g dt, or gives it new values. */
static bool fill(struct fluid *fluid, int k, double factor) {
    struct scalars *scalars = fluid->scalars;
    struct scalar *scalar = &scalars->scalar[k];
    struct links links = links_of(fluid, k);
    if (scalar->system != NULL && scalar->factor == factor)
        return true;
    scalar->factor = factor;
    scalar_links_matrix(&links, factor, NULL, &scalars->assembly);
    if (scalar->system != NULL) {
        solve_values(scalar->system, scalars->assembly.value);
        solve_renew(scalar->system);
        return true;
    }
    struct solve_rows rows = assembly_rows(&scalars->assembly);
    struct solve_options options = solve_options_regular("fluid_c_");
    double spacing = fluid->options->spacing;
    options.tolerance = TOLERANCE;
    if (factor * fluid->options->scalar[k].diffusivity > JACOBI_MOST * spacing * spacing)
        options.preconditioner = fluid->options->solver.preconditioner == FLUID_GAMG ? "gamg" : "boomeramg";
    scalar->system = solve_create(fluid->solve, &rows, &options, &fluid->error);
    return scalar->system != NULL;
}

/* A step of scalar k; `r` is dt over that of the step before, 0 in the first step. */
static bool step_one(const struct physics_context *context, int k, double dt, double r) {
    struct fluid *fluid = context->self;
    struct scalars *scalars = fluid->scalars;
    struct scalar *scalar = &scalars->scalar[k];
    double *value = scalars_value(context->particles, k) + fluid->weights.first,
           *before = scalars_before(context->particles, k) + fluid->weights.first;
    double factor = dt * (1 + r) / (1 + 2 * r), now = (1 + r) * (1 + r) / (1 + 2 * r),
           past = r * r / (1 + 2 * r);
    struct links links = links_of(fluid, k);
    if (!fill(fluid, k, factor))
        return false;
    scalar_links_side(&links, factor, scalars->side);
    for (size_t row = 0; row < fluid->weights.rows; row++) {
        scalars->side[row] += now * value[row] - past * before[row];
        scalars->solution[row] = value[row];
    }
    solve_solve(scalar->system, scalars->side, scalars->solution, true);
    if (!residual_check(solve_report(scalar->system), "scalars", &fluid->error))
        return false;
    memcpy(before, value, fluid->weights.rows * sizeof *before);
    memcpy(value, scalars->solution, fluid->weights.rows * sizeof *value);
    return true;
}

void scalars_step(const struct physics_context *context, bool flows) {
    struct fluid *fluid = context->self;
    struct scalars *scalars = fluid->scalars;
    double dt = grain_dt(context), r = scalars->steps > 0 ? dt / scalars->dt : 0;
    if (!prepare(fluid))
        return;
    if (fluid->rigid != NULL)
        rigid_fields_solid_forward(context);
    if (flows || scalars->fluxes.carry == NULL) {
        if (!neighbour_fluxes_make(&scalars->fluxes, fluid->solve, &scalars->assembly, &fluid->flow,
                                   fluid->volume > 0, &fluid->error))
            return;
        for (int k = 0; k < scalars->options->scalars; k++)
            scalars->scalar[k].factor = NAN;
    }
    for (int k = 0; k < scalars->options->scalars; k++)
        if (!step_one(context, k, dt, r))
            return;
    scalars->steps++;
    scalars->dt = dt;
}

void scalars_look(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct scalars *scalars = fluid->scalars;
    size_t rows = fluid->weights.rows;
    if (fluid->rigid != NULL)
        rigid_fields_solid_forward(context);
    for (int k = 0; k < scalars->options->scalars; k++) {
        struct scalar *scalar = &scalars->scalar[k];
        struct links links = links_of(fluid, k);
        scalars_fields_forward(context, k);
        scalar->flux = memory_resize(scalar->flux, rows, sizeof *scalar->flux, "scalars of a fluid");
        scalar_links_flux(&links, scalars_value(context->particles, k), scalar->flux);
    }
}

const double (*scalars_flux(const struct scalars *scalars, int k))[3] {
    return (const double(*)[3])scalars->scalar[k].flux;
}

void scalars_restart(struct scalars *scalars, struct restart *list) {
    restart_add(list, RESTART_INTEGER, true, &scalars->steps, "fluid: steps of scalars");
    restart_add(list, RESTART_REAL, true, &scalars->dt, "fluid: last time step of scalars");
}

void scalars_print(const struct physics_context *context, FILE *file) {
    const struct fluid_options *options = context->options;
    for (int k = 0; k < options->scalars; k++)
        fprintf(file, "  scalar_%d     %s: diffusivity %g, given at %d surface%s\n", k + 1,
                options->scalar[k].name, options->scalar[k].diffusivity, options->scalar[k].givens,
                options->scalar[k].givens == 1 ? "" : "s");
}
