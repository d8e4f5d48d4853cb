/* SPDX-License-Identifier: BSD-3-Clause */
/* A step in which grains are rigid fluid: what holds exactly, to rounding and the solver of the velocity, of a heavy disc that has been pushed into a fluid at
 * rest.
 * Ranks: 1 2 */
#include "tests/test.h"

#include "fluid_run.h"
#include "team.h"
#include "kernel/particles/kinds.h"
#include "physics/fluid/coupling/rigid_bodies.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/coupling/rigid_grains.h"
#include "physics/fluid/coupling/rigid_step.h"
#include "physics/fluid/coupling/rigid_sums.h"
#include "physics/fluid/fluid_fields.h"

#include <math.h>
#include <string.h>

/* 2.5 times as heavy as the fluid in it. */
static const char disc[] = "units: none\nthreads: 1\n"
                           "box: {lower: [0, 0, 0], upper: [24, 16, 0], dimension: 2, periodic: true}\n"
                           "particles: {from: single, position: [12.3, 8.4, 0], radius: 4, density: 0.46875, "
                           "velocity: [0.5, 0.2, 0]}\n"
                           "step: {dt: 0.25, count: 1, force: true}\n"
                           "fluid: {spacing: 1, density: 1, viscosity: 0.2, equations: stokes, grains: "
                           "{motion: free, coupling: rigid}}\n";

/* The state of the disc, on all ranks. */
struct disc {
    double motion[6], load[6], mass, more; /* more: than the fluid in it */
};

static struct disc disc_of(const struct fluid_run *run) {
    const struct particles *p = run->context->particles;
    struct kind_span grains = rigid_bodies_span(run->context);
    struct disc disc = {0};
    for (size_t i = grains.first; i < grains.end; i++) {
        const struct rigid_inertia inertia = rigid_bodies_inertia(run->context, NULL, i);
        memcpy(disc.motion, rigid_fields_motion(p)[i], sizeof disc.motion);
        memcpy(disc.load, fluid_load(p)[i], sizeof disc.load);
        disc.mass = inertia.mass;
        disc.more = inertia.mass - inertia.displaced;
    }
    comm_sum(run->context->comm, disc.motion, 6);
    comm_sum(run->context->comm, disc.load, 6);
    comm_sum(run->context->comm, &disc.mass, 1);
    comm_sum(run->context->comm, &disc.more, 1);
    return disc;
}

static bool step(struct fluid_run *run, struct team *team) {
    return team_expect(team, rigid_step(run->context, &run->error), "%s", run->error.text);
}

/* Newton's law of the disc, M dU/dt = load, and the momentum of all: what the fluid has, and what the disc has more than the fluid in it. At the start the fluid in
 * the disc moves with it, so that all together have M U as far as nodes fill the disc. */
static void momentum_stays(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    if (fluid_run_begin(&run, team, disc, true) && step(&run, team)) {
        struct disc first = disc_of(&run);
        double all = fluid_run_momentum(&run, 0) + first.more * first.motion[0];
        team_expect(team, fabs(all / (0.5 * first.mass) - 1) < 0.03, "momentum %g of %g", all,
                    0.5 * first.mass);
        for (int n = 0; n < 3; n++) {
            struct disc before = disc_of(&run);
            double fluid[2] = {fluid_run_momentum(&run, 0), fluid_run_momentum(&run, 1)};
            if (!step(&run, team))
                break;
            struct disc after = disc_of(&run);
            double unit = before.mass * hypot(before.motion[0], before.motion[1]);
            team_expect(team, unit > 1, "momentum %g", unit);
            for (int d = 0; d < 2; d++) {
                double change = after.motion[d] - before.motion[d],
                       sum = fluid_run_momentum(&run, d) - fluid[d] + before.more * change;
                team_expect(team, fabs(change) > 1e-4, "nothing slows the disc down: %g", change);
                team_expect(team, fabs(sum) < 1e-7 * unit, "momentum changes by %g of %g", sum, unit);
                team_expect(team, fabs(after.mass * change - 0.25 * after.load[d]) < 1e-10 * unit,
                            "M dU = %g, F dt = %g", after.mass * change, 0.25 * after.load[d]);
            }
        }
    }
    fluid_run_free(&run);
    team_finish(team);
}

/* Nodes that a disc fills move as it does, U + omega x r. */
static void the_fluid_in_it_is_rigid(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    double worst = 0, nodes = 0, apart = 0;
    if (fluid_run_begin(&run, team, disc, true) && step(&run, team) && step(&run, team)) {
        const struct particles *p = run.context->particles;
        const struct solid_field *solid = &run.fluid->rigid->solid;
        for (size_t node = 0; node < solid->nodes; node++) {
            const struct solid_part *part = &solid->part[solid->start[node]];
            const double *u = flow_velocity_of(&run.fluid->flow, part->row);
            double rigid[3];
            if (rigid_fields_solid(p)[run.fluid->weights.first + part->row] < 1)
                continue;
            rigid_grains_velocity(rigid_fields_found(p)[part->grain], part->arm, rigid);
            for (int d = 0; d < 2; d++)
                worst = fmax(worst, fabs(u[d] - rigid[d]));
            nodes++;
        }
        struct disc found = disc_of(&run);
        apart = fabs(found.motion[2]) + fabs(found.motion[3]) + fabs(found.motion[4]);
        comm_sum(&team->comm, &nodes, 1);
        team_expect(team, nodes > 20 && nodes < 16 * M_PI, "%g nodes", nodes);
        team_expect(team, worst < 1e-12, "nodes of the disc differ by %g from it", worst);
        team_expect(team, apart == 0, "it leaves the plane by %g", apart);
    }
    fluid_run_free(&run);
    team_finish(team);
}

/* A disc that moves as the fluid does all around: nothing changes, and no load is felt. */
static void a_common_motion_stays(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    const double u[2] = {0.5, 0.2};
    double worst = 0;
    if (fluid_run_begin(&run, team, disc, true)) {
        for (size_t row = 0; row < run.fluid->weights.rows; row++)
            memcpy(flow_velocity_of(&run.fluid->flow, row), u, sizeof u);
        flow_forward(&run.fluid->flow, FLOW_VELOCITY);
        for (int n = 0; n < 2 && step(&run, team); n++)
            for (size_t row = 0; row < run.fluid->weights.rows; row++)
                for (int d = 0; d < 2; d++)
                    worst = fmax(worst, fabs(flow_velocity_of(&run.fluid->flow, row)[d] - u[d]));
        struct disc found = disc_of(&run);
        for (int d = 0; d < 2; d++)
            worst = fmax(worst, fmax(fabs(found.motion[d] - u[d]), fabs(found.load[d]) / found.mass));
        team_expect(team, worst < 1e-9, "the common motion changes by %g", worst);
    }
    fluid_run_free(&run);
    team_finish(team);
}

TEAM_MAIN(fluid_rigid_step, team_case(momentum_stays), team_case(the_fluid_in_it_is_rigid),
          team_case(a_common_motion_stays))
