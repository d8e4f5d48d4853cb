/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls that move through a fluid in which the flow is rigid in solids: what the fluid gains is what the wall loses; a rod is to the fluid what a disc of a group with the same motion is.
 * Ranks: 1 2 */
#include "tests/test.h"

#include "fluid_run.h"
#include "team.h"
#include "kernel/particles/kinds.h"
#include "physics/fluid/coupling/rigid_bodies.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/coupling/rigid_step.h"
#include "physics/fluid/coupling/rigid_sums.h"
#include "physics/fluid/coupling/rigid_walls.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/grains/grains.h"
#include "physics/grains/walls/wall.h"

#include <math.h>
#include <string.h>

#define TOP                                                                                                  \
    "units: none\nthreads: 1\nbox: {lower: [0, 0, 0], upper: [24, 16, 0], dimension: 2, periodic: true}\n"
#define FLUID                                                                                                \
    "step: {dt: 0.25, count: 1, force: true}\n"                                                              \
    "fluid: {spacing: 1, density: 1.5, viscosity: 0.2, equations: stokes, drive: {body_force: [0.01, 0, "    \
    "0]}, grains: {coupling: rigid}}\n"

/* Beside the rod a small disc is held, so that both runs have grains. */
static const char rod[] =
    TOP "walls: [{name: rod, shape: cylinder, point: [12.3, 8.4, 0], axis: [0, 0, 1], radius: 4, inside: "
        "false, motion: [{kind: "
        "translate, velocity: [0.5, 0.2, 0]}]}]\n"
        "groups: [{name: held, motion: frozen}]\n"
        "particles: {from: single, position: [1, 1, 0], radius: 2, density: 1, group: held}\n" FLUID;
static const char disc[] =
    TOP "groups: [{name: held, motion: frozen}, {name: moved, motion: moving, velocity: [0.5, 0.2, 0]}]\n"
        "particles: {sources: [{from: single, position: [1, 1, 0], radius: 2, density: 1, group: held}, "
        "{from: single, position: [12.3, "
        "8.4, 0], radius: 4, density: 1, group: moved}]}\n" FLUID;

static bool step(struct fluid_run *run, struct team *team) {
    return team_expect(team, rigid_step(run->context, &run->error), "%s", run->error.text);
}

/* The load of the disc, without that of the drive on the fluid in its place. */
static void load_of_disc(const struct fluid_run *run, double load[6]) {
    const struct particles *p = run->context->particles;
    struct kind_span grains = rigid_bodies_span(run->context);
    memset(load, 0, 6 * sizeof *load);
    for (size_t i = grains.first; i < grains.end; i++)
        for (int d = 0; d < 6 && p->state[i].radius > 3; d++)
            load[d] = fluid_load(p)[i][d] - (d == 0 ? 0.01 * M_PI * 16 : 0);
    comm_sum(run->context->comm, load, 6);
}

/* The force that holds grains that do not move, on the fluid. */
static void held(const struct fluid_run *run, double force[2]) {
    const struct particles *p = run->context->particles;
    struct kind_span grains = rigid_bodies_span(run->context);
    force[0] = force[1] = 0;
    for (size_t i = grains.first; i < grains.end; i++)
        for (int d = 0; d < 2; d++)
            force[d] -= fluid_load(p)[i][d];
    comm_sum(run->context->comm, force, 2);
}

/* At a constant velocity the fluid, with what is in the rod, gains what the drive gives and loses the loads. */
static void momentum_goes_to_the_wall(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    if (fluid_run_begin(&run, team, rod, true) && step(&run, team)) {
        const struct rigid_wall *wall = &run.fluid->rigid->walls.wall[0];
        team_expect(team, wall->body && run.fluid->rigid->walls.bodies == 1, "the rod is no body");
        team_expect(team, fabs(wall->whole.mass / 1.5 / (16 * M_PI) - 1) < 0.02, "the rod fills %g",
                    wall->whole.mass / 1.5);
        for (int n = 0; n < 3; n++) {
            double before[2] = {fluid_run_momentum(&run, 0), fluid_run_momentum(&run, 1)}, other[2];
            if (!step(&run, team))
                break;
            held(&run, other);
            for (int d = 0; d < 2; d++) {
                double drive = d == 0 ? 0.01 * (24 * 16 - wall->whole.mass / 1.5) : 0,
                       gain = fluid_run_momentum(&run, d) - before[d],
                       given = 0.25 * (drive + other[d] - wall->load[d]);
                team_expect(team, fabs(wall->load[d]) > 0.05, "no load along %d: %g", d, wall->load[d]);
                team_expect(team, fabs(gain - given) < 1e-7, "the fluid gains %g of %g along %d", gain, given,
                            d);
            }
        }
    }
    fluid_run_free(&run);
    team_finish(team);
}

/* Momentum of the fluid after three steps, and the load of what moves. */
static bool three_steps(const char *scene, bool wall, double momentum[2], double load[6], struct team *team) {
    struct fluid_run run;
    bool good = fluid_run_begin(&run, team, scene, true);
    for (int n = 0; good && n < 3; n++)
        good = step(&run, team);
    for (int d = 0; good && d < 2; d++)
        momentum[d] = fluid_run_momentum(&run, d);
    if (good && !wall)
        load_of_disc(&run, load);
    if (good && wall) { /* the rod knows its area by nodes, and where these lie */
        const struct rigid_wall *rod_wall = &run.fluid->rigid->walls.wall[0];
        memcpy(load, rod_wall->load, sizeof rod_wall->load);
        load[0] -= 0.01 * (M_PI * 16 - rod_wall->whole.mass / 1.5);
        load[5] -= 0.01 * rod_wall->whole.first[1] / 1.5;
    }
    fluid_run_free(&run);
    return good;
}

/* Flow and load of a rod and of a disc. */
static void a_rod_is_a_disc(void **state) {
    struct team *team = *state;
    double momentum[2][2] = {{0}}, load[2][6] = {{0}};
    if (three_steps(rod, true, momentum[0], load[0], team) &&
        three_steps(disc, false, momentum[1], load[1], team)) {
        for (int d = 0; d < 2; d++)
            team_expect(team, fabs(momentum[0][d] - momentum[1][d]) < 1e-6, "momentum %d: %g and %g", d,
                        momentum[0][d], momentum[1][d]);
        for (int d = 0; d < 6; d++)
            team_expect(team, fabs(load[0][d] - load[1][d]) < 1e-6 * (1 + fabs(load[1][d])),
                        "load %d: %g and %g", d, load[0][d], load[1][d]);
    }
    team_finish(team);
}

/* A wall that turns: nodes in it have its velocity. */
static void the_fluid_in_it_turns(void **state) {
    struct team *team = *state;
    static const char paddle[] =
        TOP "walls: [{name: paddle, shape: box, lower: [8, 6, -4], upper: [16, 10, 4], motion: [{kind: "
            "rotate, direction: [0, 0, 1], point: "
            "[12, 8, 0], rate: 0.1}]}]\n"
            "groups: [{name: held, motion: frozen}]\n"
            "particles: {from: single, position: [1, 1, 0], radius: 2, density: 1, group: held}\n" FLUID;
    struct fluid_run run;
    double worst = 0, nodes = 0;
    if (fluid_run_begin(&run, team, paddle, true) && step(&run, team) && step(&run, team)) {
        const struct particles *p = run.context->particles;
        const struct weights *weights = &run.fluid->weights;
        for (size_t row = 0; row < weights->rows; row++) {
            const double *u = flow_velocity_of(&run.fluid->flow, row), *x = p->state[weights->first + row].x;
            bool in = fabs(x[0] - 12) < 3 && fabs(x[1] - 8) < 1;
            if (!in)
                continue;
            nodes++;
            worst = fmax(worst, fabs(u[0] + 0.1 * (x[1] - 8)) + fabs(u[1] - 0.1 * (x[0] - 12)));
        }
        comm_sum(&team->comm, &nodes, 1);
        team_expect(team, nodes == 12, "%g nodes deep inside", nodes);
        team_expect(team, worst < 1e-12, "they differ by %g", worst);
        const double *load = run.fluid->rigid->walls.wall[0].load;
        team_expect(team, load[5] < -1, "torque %g", load[5]);
    }
    fluid_run_free(&run);
    team_finish(team);
}

TEAM_MAIN(fluid_rigid_walls, team_case(momentum_goes_to_the_wall), team_case(a_rod_is_a_disc),
          team_case(the_fluid_in_it_turns))
