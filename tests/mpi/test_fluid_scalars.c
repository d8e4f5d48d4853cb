/* SPDX-License-Identifier: BSD-3-Clause */
/* Scalars that a fluid carries: a wave that decays and travels, exactly as its lattice has it; the straight line between two walls with given
 * values; values at the start.
 * Ranks: 1 2 */
#include "tests/test.h"

#include "fluid_run.h"
#include "team.h"
#include "physics/fluid/carried/scalars.h"
#include "physics/fluid/carried/scalars_fields.h"

#include <complex.h>
#include <math.h>

static const double diffusivity = 0.02, velocity[2] = {0.6, -0.3}, wave[2] = {2 * M_PI, 4 * M_PI};

static const char periodic[] =
    "units: none\nthreads: 1\n"
    "box: {lower: [-1, 0, 0], upper: [0, 1, 0], periodic: [true, true, false], dimension: 2}\n"
    "step: {dt: 0.05, count: 1, force: true}\n"
    "fluid:\n  spacing: 0.0625\n  density: 1\n  viscosity: 1\n  initial: {velocity: [0.6, -0.3, 0]}\n"
    "  scalars:\n"
    "    - {diffusivity: 0.02, initial: {value: 5, elsewhere: 2, region: {shape: box, lower: [-1, 0, -1],"
    " upper: [-0.5, 1, 1]}}}\n"
    "    - {diffusivity: 0.02, initial: 7}\n";

/* D times sum of w_ij (1 - cos k . r) + i times sum of (u . b_ij) sin k . r: what div grad and u . grad make of a wave. */
static double complex factor_of(const struct fluid_run *run) {
    const struct weights *weights = &run->fluid->weights;
    double complex sum = 0;
    for (size_t e = weights->start[0]; e < weights->start[1]; e++) {
        double apart[3];
        const double *b = weights_vector(weights, e);
        weights_apart(weights, &run->fluid->input, 0, e, apart);
        double phase = wave[0] * apart[0] + wave[1] * apart[1];
        sum += diffusivity * weights_scalar(weights, e) * (1 - cos(phase));
        sum += I * (velocity[0] * b[0] + velocity[1] * b[1]) * sin(phase);
    }
    return sum;
}

static double complex phase_of(const struct fluid_run *run, size_t i) {
    const double *x = run->context->particles->state[i].x;
    return cexp(I * (wave[0] * x[0] + wave[1] * x[1]));
}

/* The largest distance of both scalars from real and imaginary part of the wave with this amplitude. */
static double apart_from(const struct fluid_run *run, double complex amplitude) {
    const struct particles *p = run->context->particles;
    double worst = 0;
    for (size_t row = 0; row < run->fluid->weights.rows; row++) {
        size_t i = run->fluid->weights.first + row;
        double complex exact = amplitude * phase_of(run, i);
        worst = fmax(worst, cabs(scalars_value(p, 0)[i] + I * scalars_value(p, 1)[i] - exact));
    }
    return worst;
}

/* At the start a scalar has its value in the region, and the other one elsewhere, in the user's coordinates. */
static void values_begin(const struct fluid_run *run, struct team *team) {
    const struct particles *p = run->context->particles;
    int wrong = 0;
    for (size_t row = 0; row < run->fluid->weights.rows; row++) {
        size_t i = run->fluid->weights.first + row;
        wrong += scalars_value(p, 0)[i] != (p->state[i].x[0] < 0.5 ? 5 : 2) || scalars_value(p, 1)[i] != 7;
    }
    team_expect(team, wrong == 0, "%d values are wrong at the start", wrong);
}

/* Real and imaginary part of exp(i k . x) in a uniform flow: with s = D lambda + i omega of the lattice, z_1 = z_0 / (1 + dt s), then
 * z_n+1 = (a z_n - b z_n-1) / (1 + g dt s) with the factors of scalars.h, here for a second step half as long as the first. */
static void waves_decay_and_travel(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    static const double dt[3] = {0.05, 0.025, 0.025};
    if (fluid_run_begin(&run, team, periodic, false)) {
        const struct particles *p = run.context->particles;
        double complex s = factor_of(&run), now = 1, before = 0;
        double closed[2] = {diffusivity * (wave[0] * wave[0] + wave[1] * wave[1]),
                            velocity[0] * wave[0] + velocity[1] * wave[1]};
        team_expect(team, fabs(creal(s) / closed[0] - 1) < 0.1, "decay %g, not about %g", creal(s),
                    closed[0]);
        values_begin(&run, team);
        for (size_t row = 0; row < run.fluid->weights.rows; row++) {
            size_t i = run.fluid->weights.first + row;
            scalars_value(p, 0)[i] = creal(phase_of(&run, i));
            scalars_value(p, 1)[i] = cimag(phase_of(&run, i));
        }
        for (int n = 0; n < 3; n++) {
            double r = n > 0 ? dt[n] / dt[n - 1] : 0, whole = 1 + 2 * r;
            double complex next = ((1 + r) * (1 + r) * now - r * r * before) / whole;
            run.clock->dt = dt[n];
            scalars_step(run.context, n == 0);
            team_expect(team, run.fluid->error.kind == ERROR_NONE, "%s", run.fluid->error.text);
            before = now;
            now = next / (1 + dt[n] * (1 + r) / whole * s);
            double apart = apart_from(&run, now);
            team_expect(team, apart < 1e-7, "step %d is off by %g", n + 1, apart);
        }
    }
    fluid_run_free(&run);
    team_finish(team);
}

/* Between walls of 1 and 3, after a step without end: the straight line, and its flux of -2 D through a section; nothing goes through walls where
 * nothing is given. */
static void values_are_given_at_walls(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    const char *text =
        "units: none\nthreads: 1\n"
        "box: {lower: [0, 0, 0], upper: [0.5, 1, 0], periodic: [true, false, false], dimension: 2}\n"
        "walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]},"
        " {name: ceiling, shape: plane, point: [0, 1, 0], normal: [0, -1, 0]}]\n"
        "step: {dt: 0.05, count: 1, force: true}\n"
        "fluid:\n  spacing: 0.0625\n  density: 1\n  viscosity: 1\n"
        "  scalars:\n"
        "    - {diffusivity: 0.02, given: [{wall: floor, value: 1}, {wall: ceiling, value: 3}]}\n"
        "    - {diffusivity: 0.02, initial: 7}\n";
    if (fluid_run_begin(&run, team, text, false)) {
        const struct particles *p = run.context->particles;
        double worst = 0, flux[2] = {0}, other = 0;
        run.clock->dt = 1e9;
        scalars_step(run.context, true);
        team_expect(team, run.fluid->error.kind == ERROR_NONE, "%s", run.fluid->error.text);
        scalars_look(run.context);
        for (size_t row = 0; row < run.fluid->weights.rows; row++) {
            size_t i = run.fluid->weights.first + row;
            worst = fmax(worst, fabs(scalars_value(p, 0)[i] - 1 - 2 * p->state[i].x[1]));
            other = fmax(other, fabs(scalars_value(p, 1)[i] - 7));
            flux[0] += scalars_flux(run.fluid->scalars, 0)[row][1];
            flux[1]++;
        }
        team_expect(team, worst < 1e-6, "the line is off by %g", worst);
        comm_sum(&team->comm, flux, 2);
        team_expect(team, fabs(flux[0] / flux[1] + 2 * diffusivity) < 1e-8, "a flux of %g",
                    flux[0] / flux[1]);
        team_expect(team, other < 1e-4, "what nothing is given of has changed by %g", other);
    }
    fluid_run_free(&run);
    team_finish(team);
}

TEAM_MAIN(fluid_scalars, team_case(waves_decay_and_travel), team_case(values_are_given_at_walls))
