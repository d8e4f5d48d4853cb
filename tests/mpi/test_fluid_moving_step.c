/* SPDX-License-Identifier: BSD-3-Clause */
/* Steps of a flow on particles that drift, of waves on a periodic square lattice: there div grad is -lambda and a gradient is i kappa along the
 * wave, so that each line of the scheme of moving_step.h is one equation of complex numbers.
 * Ranks: 1 */
#include "tests/test.h"

#include "base/memory.h"
#include "physics/fluid/schemes/moving_step.h"
#include "team.h"
#include "tests/physics/fluid/fluid_cloud.h"

#include <complex.h>
#include <math.h>

static const double density = 1.3, viscosity = 0.4, wave = 2 * M_PI;

/* A flow with u = mean + real part of (along, across) exp(i k x), p = real part of pressure exp(i k x). */
struct waves {
    double complex along, across, pressure;
    double mean[2];
};

struct room {
    struct team *team;
    struct fluid_cloud cloud;
    struct weights weights;
    struct flow flow;
    struct solve *solve;
    struct error error;
    double lambda, kappa; /* of the wave */
};

static double *array(const struct room *r, size_t components) {
    return memory_allocate_zero(r->cloud.particles->owned, components * sizeof(double), "test");
}

static void symbols_find(struct room *r) {
    double apart[3];
    for (size_t e = r->weights.start[0]; e < r->weights.start[1]; e++) {
        weights_apart(&r->weights, &r->cloud.input, 0, e, apart);
        r->lambda += weights_scalar(&r->weights, e) * (1 - cos(wave * apart[0]));
        r->kappa += weights_vector(&r->weights, e)[0] * sin(wave * apart[0]);
    }
}

static void room_make(struct room *r, struct team *team) {
    *r = (struct room){.team = team};
    if (!solve_available())
        team_skip(team, "PETSc is not there");
    fluid_cloud_make(&r->cloud, 2, 12, 2.3, 0, 1);
    r->weights = fluid_cloud_weigh(&r->cloud, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    r->flow = (struct flow){.comm = &team->comm,
                            .weights = &r->weights,
                            .velocity = r->cloud.particles->state[0].v,
                            .velocity_stride = sizeof *r->cloud.particles->state / sizeof(double),
                            .pressure = array(r, 1),
                            .predicted = array(r, 3),
                            .increment = array(r, 1),
                            .advection_before = array(r, 3),
                            .velocity_before = array(r, 3),
                            .drift = array(r, 3),
                            .drift_advection = array(r, 3),
                            .gradient = array(r, 3),
                            .row = memory_allocate_zero(r->cloud.particles->owned, sizeof(int64_t), "test"),
                            .regions = 1};
    flow_number(&r->flow);
    r->solve = solve_begin(&team->comm, NULL, &r->error);
    team_expect(team, r->solve != NULL, "%s", r->error.text);
    symbols_find(r);
}

static void room_free(struct room *r) {
    solve_end(&r->solve, NULL, 0);
    memory_free(r->flow.pressure);
    memory_free(r->flow.predicted);
    memory_free(r->flow.increment);
    memory_free(r->flow.advection_before);
    memory_free(r->flow.velocity_before);
    memory_free(r->flow.drift);
    memory_free(r->flow.drift_advection);
    memory_free(r->flow.gradient);
    memory_free(r->flow.row);
    weights_free(&r->weights);
    fluid_cloud_free(&r->cloud);
}

/* Velocity and pressure of particle i. */
static void values_of(const struct room *r, const struct waves *waves, size_t i, double value[3]) {
    double complex phase = cexp(I * wave * r->cloud.particles->state[i].x[0]);
    value[0] = waves->mean[0] + creal(waves->along * phase);
    value[1] = waves->mean[1] + creal(waves->across * phase);
    value[2] = creal(waves->pressure * phase);
}

/* A step by the scheme; `ratio`: dt over that of the step before, 0 in the first step. */
static struct waves step_of(const struct room *r, const struct waves *now, const struct waves *before,
                            double dt, double ratio, double drift, const struct moving_step_push *push) {
    const double whole = 1 + 2 * ratio, g = (1 + ratio) / whole, a = (1 + ratio) * (1 + ratio) / whole,
                 b = ratio * ratio / whole, share = g * dt / density,
                 damped = 1 + share * viscosity * r->lambda;
    const double complex i = I * r->kappa, advect = g * dt * drift * i;
    struct waves next;
    double complex filter = push->filter * dt / density * (r->lambda - r->kappa * r->kappa) * now->pressure;
    next.across = (a * now->across - b * before->across +
                   advect * ((1 + ratio) * now->across - ratio * before->across)) /
                  damped;
    next.along = (a * now->along - b * before->along +
                  advect * ((1 + ratio) * now->along - ratio * before->along) - share * i * now->pressure) /
                 damped;
    double complex divergence = i * next.along, phi = -(divergence + filter) / share / r->lambda;
    next.along -= share * i * phi;
    next.pressure = now->pressure + phi - viscosity * divergence;
    for (int d = 0; d < 2; d++)
        next.mean[d] = a * now->mean[d] - b * before->mean[d] + share * push->force[d];
    return next;
}

static void flow_set(const struct room *r, const struct waves *waves, double drift) {
    for (size_t i = 0; i < r->weights.rows; i++) {
        double value[3];
        values_of(r, waves, i, value);
        r->cloud.particles->state[i].v[0] = value[0];
        r->cloud.particles->state[i].v[1] = value[1];
        r->flow.pressure[i] = value[2];
        r->flow.drift[3 * i] = drift;
    }
}

static double apart_from(const struct room *r, const struct waves *waves) {
    double worst = 0;
    for (size_t i = 0; i < r->weights.rows; i++) {
        double value[3];
        const double *v = r->cloud.particles->state[i].v;
        values_of(r, waves, i, value);
        worst = fmax(worst, fmax(fabs(v[0] - value[0]), fabs(v[1] - value[1])));
        worst = fmax(worst, fabs(r->flow.pressure[i] - value[2]));
    }
    return worst;
}

/* Four steps, of which the third is half as long as the others, under a force, with a drift and with a filter; each is tried twice. */
static void steps_are_those_of_the_scheme(void **state) {
    struct team *team = *state;
    struct room r;
    const double dt[4] = {0.04, 0.04, 0.02, 0.04}, drift = -0.7, force[3] = {0.8, -0.5, 0};
    const struct moving_step_push push = {force, 1.5};
    struct waves now = {0.4 + 0.3 * I, -0.2 + 0.9 * I, 0.5 - 0.6 * I, {0.3, -0.1}}, before = now;
    struct projection_past past = {0};
    room_make(&r, team);
    const struct projection_options options = {.density = density,
                                               .viscosity = viscosity,
                                               .spacing = r.cloud.spacing,
                                               .dt = dt[0],
                                               .preconditioner = "boomeramg",
                                               .tolerance_velocity = 1e-11,
                                               .tolerance_pressure = 1e-11};
    struct projection *projection =
        r.solve != NULL ? projection_create(r.solve, &r.flow, &options, &r.error) : NULL;
    flow_set(&r, &now, drift);
    moving_step_drift_advect(&r.flow);
    for (int n = 0; n < 4 && team_expect(team, projection != NULL, "%s", r.error.text); n++) {
        double ratio = n > 0 ? dt[n] / dt[n - 1] : 0;
        struct path path = moving_step_begin(projection, &r.flow, &past, dt[n], &push);
        for (int k = 0; k < 2; k++)
            team_expect(team, moving_step_try(&path, &r.error), "%s", r.error.text);
        past = (struct projection_past){past.steps + 1, dt[n]};
        struct waves next = step_of(&r, &now, &before, dt[n], ratio, drift, &push);
        before = now;
        now = next;
        double apart = apart_from(&r, &now);
        team_expect(team, apart < 1e-7, "step %d is off by %g", n + 1, apart);
        moving_step_drift_advect(&r.flow);
    }
    projection_destroy(&projection);
    room_free(&r);
    team_finish(team);
}

/* The velocity of a particle: that of the fluid, ahead by half a step, and its drift. */
static void particles_go_ahead(void **state) {
    double u[3] = {1, 2, 3}, before[3] = {0.5, 2.5, 3}, drift[3] = {0.1, 0, -0.1}, w[3];
    const struct flow flow = {.velocity = u, .velocity_stride = 3, .velocity_before = before, .drift = drift};
    (void)state;
    moving_step_velocity(&flow, 0, 0.5, w);
    assert_true(fabs(w[0] - 1.35) < 1e-15 && fabs(w[1] - 1.75) < 1e-15 && fabs(w[2] - 2.9) < 1e-15);
}

TEAM_MAIN(fluid_moving_step, team_case(steps_are_those_of_the_scheme), cmocka_unit_test(particles_go_ahead))
