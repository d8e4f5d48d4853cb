/* SPDX-License-Identifier: BSD-3-Clause */
/* A step of a fluid and of the velocities of the grains that it moves: the equations of the grains hold in the end, nothing happens to grain and fluid that move
 * alike, and momentum is neither made nor lost.
 * Ranks: 1 2 */
#include "tests/test.h"

#include "fluid_run.h"
#include "team.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include "kernel/particles/spin.h"
#include "physics/fluid/coupling/coupled_solve.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/lattice/surface_feet.h"

#include <math.h>
#include <string.h>

enum { NUMBERS = 6 };
static const double dt = 0.004, mass = 4.0 / 3 * M_PI * 0.008 * 3,
                    inertia = 0.4 * 4.0 / 3 * M_PI * 0.008 * 3 * 0.04;

static const char disc[] =
    "units: none\nthreads: 1\n"
    "box: {lower: [0, 0, 0], upper: [1, 1, 0], periodic: [true, true, false], dimension: 2}\n"
    "contact: {law: hertz}\n"
    "materials: [{name: glass, density: 3, young: 1e5, poisson: 0.2}]\n"
    "material_pairs: [{restitution: 0.5, friction: 0.3}]\n"
    "particles: {from: single, position: [0.47, 0.51, 0], radius: 0.2, velocity: [1, 0.5, 0]}\n"
    "step: {dt: 0.004, count: 1, force: true}\n"
    "fluid: {spacing: 0.05, density: 1, viscosity: 0.1, motion: lagrangian, grains: free}\n";

/* Velocity and spin of the disc, and the load on it, on all ranks. */
struct disc {
    double motion[NUMBERS], load[NUMBERS], jump[NUMBERS];
};

static size_t number_of(const struct fluid_run *run) {
    struct kind_span span = kinds_span(run->context->particles, run->context->classes, KIND_GRAIN);
    return span.end > span.first ? span.first : SIZE_MAX;
}

static struct disc disc_of(const struct fluid_run *run) {
    const struct particles *p = run->context->particles;
    size_t i = number_of(run);
    struct disc disc = {0};
    if (i != SIZE_MAX) {
        memcpy(disc.motion, p->state[i].v, 3 * sizeof(double));
        memcpy(disc.motion + 3, spin_of(p)[i], 3 * sizeof(double));
        memcpy(disc.load, fluid_load(p)[i], sizeof disc.load);
        if (run->fluid->jump != NULL)
            memcpy(disc.jump, run->fluid->jump[i], sizeof disc.jump);
    }
    comm_sum(run->context->comm, disc.motion, NUMBERS);
    comm_sum(run->context->comm, disc.load, NUMBERS);
    comm_sum(run->context->comm, disc.jump, NUMBERS);
    return disc;
}

/* Sets the load that was held until now, and the spin with which the disc arrives; copies and feet follow. */
static void disc_set(const struct fluid_run *run, const double load[NUMBERS], double spin) {
    struct particles *p = run->context->particles;
    struct field_list list = fields_one(fields_find(p, "angular_velocity"));
    size_t i = number_of(run);
    if (i != SIZE_MAX) {
        memcpy(fluid_load(p)[i], load, sizeof *fluid_load(p));
        spin_of(p)[i][2] = spin;
    }
    if (run->context->ghosts != NULL) {
        ghosts_forward_begin(run->context->ghosts, p, &list);
        ghosts_forward_end(run->context->ghosts, p);
    }
    surface_feet_mirror(run->context, run->fluid);
}

static bool solved(struct fluid_run *run, struct team *team) {
    const double none[3] = {0};
    const struct moving_step_push push = {none, 0};
    struct path path =
        moving_step_begin(run->fluid->projection, &run->fluid->flow, &run->fluid->past, dt, &push);
    return team_expect(team, coupled_step(run->context, &path, &run->error), "%s", run->error.text);
}

/* m (U - U*) = dt (F - F0), I (omega - omega*) = dt (T - T0), with F and T as they are on the disc in the end; within the tolerance, 1e-3 of the forces. */
static void the_equations_hold(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    const double held[NUMBERS] = {7, -4, 0, 0, 0, 0.3}, start[NUMBERS] = {1, 0.5, 0, 0, 0, 6};
    if (fluid_run_begin(&run, team, disc, true)) {
        disc_set(&run, held, start[5]);
        const double before[2] = {fluid_run_momentum(&run, 0), fluid_run_momentum(&run, 1)};
        if (solved(&run, team)) {
            struct disc end = disc_of(&run);
            double force = hypot(end.load[0], end.load[1]) + hypot(held[0], held[1]);
            double torque = fabs(end.load[5]) + fabs(held[5]);
            for (int d = 0; d < NUMBERS; d++) {
                double jump = end.motion[d] - start[d], size = d < 3 ? force : torque;
                double lack = (d < 3 ? mass : inertia) * jump - dt * (end.load[d] - held[d]);
                team_expect(team, fabs(lack) < 3e-3 * dt * size, "equation %d lacks %g of %g", d, lack,
                            dt * size);
                team_expect(team, fabs(end.jump[d] - jump) < 1e-14, "jump %g, not %g", end.jump[d], jump);
            }
            team_expect(team, force > 20 && fabs(end.motion[0] - 1) > 0.1 && fabs(end.motion[5] - 6) > 0.1,
                        "the fluid hardly acts: %g, %g", end.motion[0], end.motion[5]);
            for (int d = 0; d < 2;
                 d++) { /* what the disc lost, and what the held load had given, the fluid has */
                double won = fluid_run_momentum(&run, d) - before[d];
                double lost = -dt * end.load[d];
                team_expect(team, fabs(won - lost) < 0.05 * mass, "the fluid won %g, the disc lost %g", won,
                            lost);
            }
        }
    }
    fluid_run_free(&run);
    team_finish(team);
}

/* Grain and fluid with one velocity: no force, no jump, and the fluid stays as it is. */
static void a_common_motion_stays(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    const double none[NUMBERS] = {0}, start[NUMBERS] = {1, 0.5, 0, 0, 0, 0};
    if (fluid_run_begin(&run, team, disc, true)) {
        double worst = 0;
        disc_set(&run, none, 0);
        for (size_t row = 0; row < run.fluid->weights.rows; row++)
            memcpy(flow_velocity_of(&run.fluid->flow, row), start, 2 * sizeof(double));
        flow_forward(&run.fluid->flow, FLOW_VELOCITY);
        if (solved(&run, team)) {
            struct disc end = disc_of(&run);
            for (size_t row = 0; row < run.fluid->weights.rows; row++)
                for (int d = 0; d < 2; d++)
                    worst = fmax(worst, fabs(flow_velocity_of(&run.fluid->flow, row)[d] - start[d]));
            for (int d = 0; d < NUMBERS; d++)
                worst = fmax(worst, fmax(fabs(end.motion[d] - start[d]), dt * fabs(end.load[d])));
            team_expect(team, worst < 1e-8, "the common motion changes by %g", worst);
        }
    }
    fluid_run_free(&run);
    team_finish(team);
}

TEAM_MAIN(fluid_coupled_solve, team_case(the_equations_hold), team_case(a_common_motion_stays))
