/* SPDX-License-Identifier: BSD-3-Clause */
/* Potential, applied field and force of an electrolyte. Read electrolyte.h first. */
#include "physics/fluid/carried/electrolyte.h"
#include "base/memory.h"
#include "physics/fluid/carried/applied_field.h"
#include "physics/fluid/carried/electrolyte_fields.h"
#include "physics/fluid/schemes/boundary_values.h"
#include "physics/fluid/carried/scalar_links.h"
#include "physics/fluid/schemes/fluid_motion.h"
#include "physics/fluid/schemes/residual.h"
#include "physics/fluid/carried/shares.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Steps of Newton's method; the last one changes no potential by more than ENOUGH; one step changes them by STEP_MOST at most. */
enum { STEPS_MOST = 100, HALVINGS_MOST = 20 };
#define ENOUGH 1e-8
#define STEP_MOST 2.0

/* The part of the Debye length above which the spacing is called too coarse. */
#define COARSE 0.3

struct electrolyte {
    const struct fluid_electrolyte *options; /* borrowed */
    bool made;
    struct assembly assembly;
    struct solve_system *system;
    double *share;                                /* by entry, of the field (shares.h) */
    double *given, *slope;                        /* by foot, in thermal voltages */
    double *gap, *side, *change, *old, *diagonal; /* [rows] */
    double gap_size;                              /* norm of the gap */
    double (*force)[3];                           /* by row, force/volume */
};

/* The surfaces alone. */
static void surfaces_of(const struct fluid_electrolyte *options, struct fluid_surface *surface) {
    for (int k = 0; k < options->surfaces; k++)
        surface[k] = options->surface[k].at;
}

static bool surface_suits(const struct physics_context *context, int k, struct error *error) {
    const struct fluid_options *options = context->options;
    const struct fluid_charged *surface = &options->electrolyte.surface[k];
    char key[64];
    snprintf(key, sizeof key, "fluid.electrolyte.surfaces[%d]", k);
    if (isnan(surface->zeta) == isnan(surface->charge))
        return scene_fail(context->scene, error, key, "needed is one of zeta and charge, %s",
                          isnan(surface->zeta) ? "not none" : "not both");
    snprintf(key, sizeof key, "fluid.electrolyte.surfaces[%d].side", k);
    return surface->at.side < 0 || isnan(surface->charge) ||
           scene_fail(context->scene, error, key, "an open side has a zeta, or nothing, but no charge");
}

bool electrolyte_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    struct fluid_surface surface[FLUID_SURFACES_MAX];
    if (!options->electrolytes)
        return true;
    if (fluid_motion_moves(options))
        return scene_fail(context->scene, error, "fluid.electrolyte",
                          "an electrolyte goes with fluid.motion: fixed alone");
    if (!isnan(options->drive.mass_flow))
        return scene_fail(context->scene, error, "fluid.drive.mass_flow",
                          "a field drives the flow of an electrolyte; allowed besides: body_force and "
                          "pressure_drop");
    for (int k = 0; k < options->electrolyte.surfaces; k++)
        if (!surface_suits(context, k, error))
            return false;
    surfaces_of(&options->electrolyte, surface);
    return boundary_values_suits(context, "fluid.electrolyte.surfaces", surface,
                                 options->electrolyte.surfaces, error);
}

struct electrolyte *electrolyte_create(const struct physics_context *context) {
    const struct fluid_options *options = context->options;
    if (!options->electrolytes)
        return NULL;
    struct electrolyte *electrolyte = memory_allocate_zero(1, sizeof *electrolyte, "electrolyte");
    electrolyte->options = &options->electrolyte;
    electrolyte_fields(context->particles);
    return electrolyte;
}

void electrolyte_forget(struct electrolyte *electrolyte) {
    if (electrolyte == NULL)
        return;
    solve_destroy(&electrolyte->system);
    assembly_free(&electrolyte->assembly);
    memory_free(electrolyte->share);
    memory_free(electrolyte->given);
    memory_free(electrolyte->slope);
    memory_free(electrolyte->gap);
    memory_free(electrolyte->side);
    memory_free(electrolyte->change);
    memory_free(electrolyte->old);
    memory_free(electrolyte->diagonal);
    memory_free(electrolyte->force);
    *electrolyte = (struct electrolyte){.options = electrolyte->options};
}

void electrolyte_destroy(struct electrolyte **electrolyte) {
    electrolyte_forget(*electrolyte);
    memory_free(*electrolyte);
    *electrolyte = NULL;
}

/* 1 or -1: the sign of a surface at the foot of x. */
static double sign_at(const struct physics_context *context, const struct fluid_charged *surface,
                      const double x[3], const struct weights_foot *foot) {
    int d = surface->axis;
    double place = x[d] - foot->distance * foot->normal[d] + context->box->origin[d];
    if (isnan(surface->period))
        return 1;
    return fmod(floor(2 * place / surface->period), 2) == 0 ? 1 : -1;
}

/* Potentials and slopes at the feet. */
static void given_make(const struct physics_context *context, struct electrolyte *electrolyte) {
    const struct fluid *fluid = context->self;
    const struct weights *weights = &fluid->weights;
    const struct fluid_electrolyte *options = electrolyte->options;
    size_t feet = weights->foot_start[weights->rows];
    struct fluid_surface surface[FLUID_SURFACES_MAX];
    int *number = memory_allocate(feet, sizeof *number, "electrolyte");
    surfaces_of(options, surface);
    boundary_values_find(context, weights, surface, options->surfaces, number);
    electrolyte->given = memory_resize(electrolyte->given, feet, sizeof(double), "electrolyte");
    electrolyte->slope = memory_resize(electrolyte->slope, feet, sizeof(double), "electrolyte");
    for (size_t row = 0; row < weights->rows; row++)
        for (size_t k = weights->foot_start[row]; k < weights->foot_start[row + 1]; k++) {
            electrolyte->given[k] = NAN;
            electrolyte->slope[k] = 0;
            if (number[k] < 0)
                continue;
            const struct fluid_charged *at = &options->surface[number[k]];
            double sign =
                sign_at(context, at, context->particles->state[weights->first + row].x, &weights->foot[k]) /
                options->thermal_voltage;
            electrolyte->given[k] = sign * at->zeta;
            electrolyte->slope[k] = isnan(at->charge) ? 0 : -sign * at->charge / options->permittivity;
        }
    memory_free(number);
}

static double ions(const struct electrolyte *electrolyte, double psi) {
    return electrolyte->options->equation == FLUID_DEBYE_HUECKEL ? psi : sinh(psi);
}

static double ions_slope(const struct electrolyte *electrolyte, double psi) {
    return electrolyte->options->equation == FLUID_DEBYE_HUECKEL ? 1 : cosh(psi);
}

static struct links links_of(const struct fluid *fluid) {
    return (struct links){.weights = &fluid->weights,
                          .diffusivity = 1,
                          .given = fluid->electrolyte->given,
                          .slope = fluid->electrolyte->slope};
}

/* gap = div grad psi - sinh(psi) / lambda^2 of the potential, whose copies are brought up to date. Returns its norm. */
static double gap_find(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct electrolyte *electrolyte = fluid->electrolyte;
    const double *psi = electrolyte_potential(context->particles);
    double inverse = 1 / (electrolyte->options->debye_length * electrolyte->options->debye_length), sum = 0;
    struct links links = links_of(fluid);
    electrolyte_fields_forward(context);
    scalar_links_apply(&links, psi, electrolyte->gap);
    for (size_t row = 0; row < fluid->weights.rows; row++) {
        electrolyte->gap[row] -= inverse * ions(electrolyte, psi[fluid->weights.first + row]);
        sum += electrolyte->gap[row] * electrolyte->gap[row];
    }
    comm_sum(context->comm, &sum, 1);
    return sqrt(sum);
}

/* Solves for Newton's step; false if the linear solver failed. */
static bool change_find(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct electrolyte *electrolyte = fluid->electrolyte;
    const double *psi = electrolyte_potential(context->particles) + fluid->weights.first;
    double inverse = 1 / (electrolyte->options->debye_length * electrolyte->options->debye_length);
    struct links links = links_of(fluid);
    for (size_t row = 0; row < fluid->weights.rows; row++) {
        electrolyte->diagonal[row] = inverse * ions_slope(electrolyte, psi[row]);
        electrolyte->side[row] = electrolyte->gap[row];
    }
    scalar_links_matrix(&links, 1, electrolyte->diagonal, &electrolyte->assembly);
    if (electrolyte->system != NULL) {
        solve_values(electrolyte->system, electrolyte->assembly.value);
    } else {
        struct solve_rows rows = assembly_rows(&electrolyte->assembly);
        struct solve_options options = solve_options_regular("fluid_e_");
        options.preconditioner = fluid->options->solver.preconditioner == FLUID_GAMG ? "gamg" : "boomeramg";
        electrolyte->system = solve_create(fluid->solve, &rows, &options, &fluid->error);
    }
    if (electrolyte->system == NULL)
        return false;
    solve_solve(electrolyte->system, electrolyte->side, electrolyte->change, false);
    return residual_check(solve_report(electrolyte->system), "potential", &fluid->error);
}

/* psi = old + share change. */
static double change_take(const struct physics_context *context, double share) {
    struct fluid *fluid = context->self;
    struct electrolyte *electrolyte = fluid->electrolyte;
    double *psi = electrolyte_potential(context->particles) + fluid->weights.first;
    for (size_t row = 0; row < fluid->weights.rows; row++)
        psi[row] = electrolyte->old[row] + share * electrolyte->change[row];
    return gap_find(context);
}

/* One step of Newton's method. Returns the largest change of a potential. */
static double newton_step(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct electrolyte *electrolyte = fluid->electrolyte;
    const double *psi = electrolyte_potential(context->particles) + fluid->weights.first;
    double most = 0;
    memcpy(electrolyte->old, psi, fluid->weights.rows * sizeof *psi);
    for (size_t row = 0; row < fluid->weights.rows; row++)
        most = fmax(most, fabs(electrolyte->change[row]));
    comm_max(context->comm, &most, 1);
    double share = most > STEP_MOST ? STEP_MOST / most : 1, size = change_take(context, share);
    for (int k = 0; k < HALVINGS_MOST && share * most > ENOUGH && !(size < electrolyte->gap_size); k++)
        size = change_take(context, share /= 2);
    electrolyte->gap_size = size;
    return share * most;
}

/* The potential, in thermal voltages. */
static bool newton(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct electrolyte *electrolyte = fluid->electrolyte;
    double most = INFINITY;
    memset(electrolyte_potential(context->particles) + fluid->weights.first, 0,
           fluid->weights.rows * sizeof(double));
    electrolyte->gap_size = gap_find(context);
    for (int k = 0; k < STEPS_MOST && most > ENOUGH && electrolyte->gap_size > 0; k++) {
        if (!change_find(context))
            return false;
        most = newton_step(context);
    }
    return most <= ENOUGH || electrolyte->gap_size == 0 ||
           error_set(&fluid->error, ERROR_PHYSICS,
                     "the potential of the electrolyte did not converge in %d steps of Newton's method: the "
                     "last one changed it by %.2g thermal voltages",
                     STEPS_MOST, most);
}

/* Charge density and force; the potential becomes one in volts. */
static void charge_make(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    const struct electrolyte *electrolyte = fluid->electrolyte;
    const struct fluid_electrolyte *options = electrolyte->options;
    const struct particles *p = context->particles;
    double *psi = electrolyte_potential(p), *charge = electrolyte_charge(p), *field = electrolyte_field(p);
    double unit =
        options->permittivity * options->thermal_voltage / (options->debye_length * options->debye_length);
    for (size_t row = 0; row < fluid->weights.rows; row++) {
        size_t i = fluid->weights.first + row;
        charge[i] = -unit * ions(electrolyte, psi[i]);
        psi[i] *= options->thermal_voltage;
        for (size_t d = 0; d < 3; d++)
            electrolyte->force[row][d] = charge[i] * field[3 * i + d];
    }
}

void electrolyte_rebuilt(const struct physics_context *context) {
    const struct fluid *fluid = context->self;
    if (fluid->electrolyte != NULL)
        fluid->electrolyte->share = shares_make(context, NULL, 0, NULL);
}

static bool make(const struct physics_context *context, struct fluid *fluid) {
    struct electrolyte *electrolyte = fluid->electrolyte;
    size_t rows = fluid->weights.rows;
    if (!assembly_make(&electrolyte->assembly, &fluid->flow, &fluid->error))
        return false;
    electrolyte->gap = memory_allocate(rows, sizeof(double), "electrolyte");
    electrolyte->side = memory_allocate(rows, sizeof(double), "electrolyte");
    electrolyte->change = memory_allocate(rows, sizeof(double), "electrolyte");
    electrolyte->old = memory_allocate(rows, sizeof(double), "electrolyte");
    electrolyte->diagonal = memory_allocate(rows, sizeof(double), "electrolyte");
    electrolyte->force = memory_allocate(rows, sizeof *electrolyte->force, "electrolyte");
    given_make(context, electrolyte);
    const struct applied applied = {
        .flow = &fluid->flow,
        .input = &fluid->input,
        .assembly = &electrolyte->assembly,
        .solve = fluid->solve,
        .share = electrolyte->share,
        .preconditioner = fluid->options->solver.preconditioner == FLUID_GAMG ? "gamg" : "boomeramg"};
    bool good = applied_field(&applied, electrolyte->options->field, electrolyte_field(context->particles),
                              &fluid->error);
    if (!good || !newton(context))
        return false;
    charge_make(context);
    electrolyte_fields_forward(context);
    electrolyte->made = true;
    return true;
}

void electrolyte_step(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    if (fluid->electrolyte->made || make(context, fluid))
        fluid->flow.body = (const double(*)[3])fluid->electrolyte->force;
}

void electrolyte_print(const struct physics_context *context, FILE *file) {
    const struct fluid_options *options = context->options;
    double spacings = options->electrolyte.debye_length / options->spacing;
    if (!options->electrolytes)
        return;
    fprintf(file, "  electrolyte  %sDebye length %g = %.3g spacings; charged surfaces: %d\n",
            spacings * COARSE < 1 ? "NOTE: too coarse within 1 %: " : "", options->electrolyte.debye_length,
            spacings, options->electrolyte.surfaces);
}
