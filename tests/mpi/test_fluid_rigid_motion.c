/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains between the steps of a fluid in which they are rigid: the momentum of contacts by the trapezoidal rule over four steps, velocities half a step before those
 * that the fluid found, and weight and buoyancy of what is touched and what is not.
 * Ranks: 1 */
#include "tests/test.h"

#include "fluid_run.h"
#include "team.h"
#include "kernel/particles/kinds.h"
#include "physics/fluid/coupling/rigid_bodies.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/coupling/rigid_motion.h"
#include "physics/fluid/fluid_fields.h"
#include "tests/near.h"

#include <math.h>
#include <string.h>

enum { NUMBERS = 6 };
static const double dt = 0.1, gravity = -2, mass = 4.0 / 3 * M_PI * 64 * 0.5, displaced = 16 * M_PI;

static const char disc[] =
    "units: none\nthreads: 1\n"
    "box: {lower: [0, 0, 0], upper: [24, 16, 0], dimension: 2, periodic: true}\n"
    "gravity: [0, -2, 0]\n"
    "contact: {law: hertz}\nmaterials: [{name: a, density: 0.5, young: 1000, poisson: 0.3}]\n"
    "material_pairs: [{restitution: 0.2, friction: 0.3}]\n"
    "particles: {from: single, position: [12.3, 8.4, 0], radius: 4}\n"
    "step: {dt: 0.1, count: 1, force: true}\n"
    "fluid: {spacing: 1, density: 1, viscosity: 0.2, grains: {motion: free, coupling: rigid, every: 4}}\n";

/* The force record of the disc becomes this force and this torque of contacts. */
static void touch(const struct fluid_run *run, size_t i, const double contact[NUMBERS]) {
    double *force = run->context->particles->force + i * (size_t)run->context->particles->force_stride;
    memcpy(force, contact, 3 * sizeof *force);
    memcpy(force + 4, contact + 3, 3 * sizeof *force);
}

/* The force of a disc: first that of its contacts, then with what the fluid adds to it. */
static void force_is(const struct fluid_run *run, size_t i, double x, double y) {
    const double *force = run->context->particles->force + i * (size_t)run->context->particles->force_stride;
    assert_near(force[0], x, 1e-11);
    assert_near(force[1], y, 1e-11);
    assert_near(force[2], 0, 0);
}

/* Nothing touches at the start: weight and push add up to nothing, as the load of the fluid is taken to hold the disc, and stays so
 * until the fluid has made a step. Then a force in three steps, at the end of the last of which the fluid makes its step: that one
 * counts half, and its other half comes after that step. */
static void contacts_are_summed(void **state) {
    const double none[NUMBERS] = {0}, contact[NUMBERS] = {3, -1, 0, 0, 0, 0.4};
    struct team *team = *state;
    struct fluid_run run;
    if (fluid_run_begin(&run, team, disc, false)) {
        const struct particles *p = run.context->particles;
        size_t i = rigid_bodies_span(run.context).first;
        const double *impulse = rigid_fields_impulse(p)[i];
        touch(&run, i, none);
        rigid_motion_gather(run.context);
        rigid_motion_apply(run.context);
        force_is(&run, i, 0, -mass * gravity);
        for (run.clock->step = 2; run.clock->step <= 4; run.clock->step++) {
            double steps = run.clock->step < 4 ? (double)run.clock->step - 1 : 2.5;
            touch(&run, i, contact);
            rigid_motion_gather(run.context);
            for (int d = 0; d < NUMBERS; d++)
                assert_near(impulse[d], steps * dt * contact[d], 1e-13);
        }
        rigid_motion_apply(run.context);
        force_is(&run, i, contact[0], contact[1] - mass * gravity);
    }
    fluid_run_free(&run);
    team_finish(team);
}

/* After a step of the fluid: velocity and spin that are stored, half a step on under contacts, weight, buoyancy and the load that is held, are those that the fluid found; the jump is from those
 * before; and the first half of the next momentum is there. */
static void velocities_are_half_a_step_before(void **state) {
    const double contact[NUMBERS] = {3, -1, 0, 0, 0, 0.4}, found[NUMBERS] = {0.7, 0.2, 0, 0, 0, -0.3};
    const double before[NUMBERS] = {0.1, -0.6, 0, 0, 0, 0.5}, load[NUMBERS] = {5, -3, 0, 0, 0, 0.7};
    struct team *team = *state;
    struct fluid_run run;
    if (fluid_run_begin(&run, team, disc, false)) {
        const struct particles *p = run.context->particles;
        size_t i = rigid_bodies_span(run.context).first;
        double motion[NUMBERS];
        run.clock->step = 4;
        rigid_bodies_set(run.context, i, before);
        touch(&run, i, contact);
        rigid_motion_gather(run.context);
        memcpy(rigid_fields_motion(p)[i], found, sizeof found);
        memcpy(fluid_load(p)[i], load, sizeof load);
        rigid_motion_set(run.context);
        rigid_bodies_motion(run.context, i, motion);
        double held =
            (1 - RIGID_LOAD) * (displaced - mass) * gravity; /* of the start, where nothing touched */
        double push[2] = {RIGID_LOAD * load[0], held + RIGID_LOAD * load[1] - displaced * gravity};
        double inertia = 0.4 * mass * 16;
        for (int d = 0; d < 2; d++)
            assert_near(motion[d] + 0.5 * dt * ((contact[d] + push[d]) / mass + (d == 1 ? gravity : 0)),
                        found[d], 1e-13);
        assert_near(motion[5] + 0.5 * dt * (contact[5] + RIGID_LOAD * load[5]) / inertia, found[5], 1e-13);
        for (int d = 0; d < NUMBERS; d++) {
            assert_near(run.fluid->jump[i][d], motion[d] - before[d], 1e-14);
            assert_near(rigid_fields_impulse(p)[i][d], 0.5 * dt * contact[d], 1e-14);
        }
        rigid_motion_apply(run.context);
        force_is(&run, i, contact[0] + push[0], contact[1] + push[1]);
        assert_null(run.fluid->jump); /* it has been counted */
    }
    fluid_run_free(&run);
    team_finish(team);
}

TEAM_MAIN(fluid_rigid_motion, team_case(contacts_are_summed), team_case(velocities_are_half_a_step_before))
