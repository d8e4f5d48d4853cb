/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of integrators and the passes that move particles, vector and scalar. Read integrator.h first. */
#include "physics/grains/motion/integrator.h"
#include "kernel/particles/spin.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include <stddef.h>
#include <string.h>

static const struct integrator integrator_table[] = {
    {"synchronised_verlet", "leapfrog; springs advance in the tangent plane of the half step", true},
    {"velocity_verlet", "leapfrog; springs advance in the tangent plane of the full step", false}};

int integrator_count(void) {
    return sizeof integrator_table / sizeof integrator_table[0];
}

const struct integrator *integrator_get(int k) {
    return &integrator_table[k];
}

const struct integrator *integrator_find(const char *name) {
    for (int k = 0; k < integrator_count(); k++)
        if (strcmp(integrator_table[k].name, name) == 0)
            return &integrator_table[k];
    return NULL;
}

/* Two doubles that move together: every x86-64 CPU has registers of this size. */
typedef double integrator_two __attribute__((vector_size(16), aligned(8), may_alias));

/* Data of a pass over particles, side by side. */
struct integrator_pass {
    double dt[3];   /* 0 for z in 2D */
    double fall[3]; /* change of velocity by gravity */
    size_t stride;  /* doubles of a force record */
    const struct integrator_motion *motion;
    struct particle_state *state;
    double *force;
    double (*omega)[4];   /* NULL without spin */
    const uint8_t *group; /* NULL where all are free */
    const int64_t *body;  /* of carried grains, else -1; NULL without bodies */
};

static inline __attribute__((always_inline)) struct integrator_pass
integrator_pass_of(const struct particles *particles, const struct integrator_context *context, double dt,
                   bool spin) {
    double z = context->dimension == 3 ? dt : 0.0;
    const double *g = context->gravity;
    return (struct integrator_pass){.dt = {dt, dt, z},
                                    .fall = {dt * g[0], dt * g[1], z * g[2]},
                                    .stride = (size_t)particles->force_stride,
                                    .motion = context->motion,
                                    .state = particles->state,
                                    .force = particles->force,
                                    .omega = spin ? spin_of(particles) : NULL,
                                    .group = context->groups > 1 ? groups_of(particles) : NULL,
                                    .body = context->carried ? carried_by(particles) : NULL};
}

/* The prescribed motion of particle i, or NULL if it is free. */
static inline const struct integrator_motion *integrator_motion_of(const struct integrator_pass *pass,
                                                                   size_t i) {
    if (pass->group == NULL || !pass->motion[pass->group[i]].prescribed)
        return NULL;
    return &pass->motion[pass->group[i]];
}

/* True if a body carries particle i. */
static inline bool integrator_carries(const struct integrator_pass *pass, size_t i) {
    return pass->body && pass->body[i] >= 0;
}

/* 1 / moment of inertia of a solid sphere: 5 / (2 m r^2). */
static inline double integrator_inverse_inertia(const struct particle_state *state) {
    return 2.5 * state->inverse_mass / (state->radius * state->radius);
}

/* Velocities of particle i after pass->dt under its present force, or as prescribed. A sphere in 2D turns
 * about z only, as its torque has no other component. */
static inline void integrator_kick(const struct integrator_pass pass, size_t i) {
    struct particle_state *state = &pass.state[i];
    const double *force = pass.force + i * pass.stride;
    const struct integrator_motion *motion = integrator_motion_of(&pass, i);
    if (motion) {
        memcpy(state->v, motion->velocity, sizeof motion->velocity);
        if (pass.omega)
            memcpy(pass.omega[i], motion->omega, sizeof motion->omega);
        return;
    }
    for (int c = 0; c < 3; c++)
        state->v[c] += pass.dt[c] * (force[c] * state->inverse_mass) + pass.fall[c];
    if (pass.omega == NULL)
        return;
    double lightness = pass.dt[0] * integrator_inverse_inertia(state);
    for (int c = 0; c < 3; c++)
        pass.omega[i][c] += force[4 + c] * lightness;
}

/* Kick and drift of a free particle, operation for operation as integrator_kick does it. Returns its squared
 * speed. */
static inline double integrator_move(struct particle_state *state, const double *force, double *omega,
                                     const struct integrator_pass *pass) {
    integrator_two *record = (integrator_two *)state; /* x y, z radius, vx vy, vz 1/mass */
    const integrator_two *push = (const integrator_two *)force;
    const integrator_two dt = {pass->dt[0], pass->dt[1]}, fall = {pass->fall[0], pass->fall[1]};
    double mass = state->inverse_mass, dt_z = pass->dt[2];
    if (omega) {
        double lightness = dt[0] * integrator_inverse_inertia(state);
        ((integrator_two *)omega)[0] += push[2] * lightness;
        omega[2] += force[6] * lightness;
    }
    integrator_two v = record[2] + (dt * (push[0] * mass) + fall);
    double v_z = state->v[2] + (dt_z * (force[2] * mass) + pass->fall[2]);
    record[0] += dt * v;
    state->x[2] += dt_z * v_z;
    record[2] = v;
    state->v[2] = v_z;
    return v[0] * v[0] + v[1] * v[1] + v_z * v_z;
}

void integrator_prescribe(struct particles *particles, const struct integrator_context *context) {
    const struct integrator_pass pass = integrator_pass_of(particles, context, 0.0, true);
    if (pass.group == NULL)
        return;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < particles->owned; i++)
        if (integrator_motion_of(&pass, i) && !integrator_carries(&pass, i))
            integrator_kick(pass, i);
}

double integrator_advance(struct particles *particles, const struct integrator_context *context, size_t first,
                          size_t last) {
    const struct integrator_pass pass = integrator_pass_of(particles, context, context->dt, true);
    double fastest = 0.0, squares = 0.0, turns = 0.0; /* sums, which one number that is not finite spoils */
    integrator_two spins = {0.0, 0.0};
    for (size_t i = first; i < last; i++) {
        struct particle_state *state = &pass.state[i];
        double *force = pass.force + i * pass.stride, square = 0.0;
        if (integrator_carries(&pass, i)) {
            square = carried_move(context->carried, i, context->dt, context->dimension == 2, state,
                                  pass.omega ? pass.omega[i] : NULL);
        } else if (integrator_motion_of(&pass, i)) {
            integrator_kick(pass, i);
            for (int c = 0; c < 3; c++) {
                state->x[c] += pass.dt[c] * state->v[c];
                square += state->v[c] * state->v[c];
            }
        } else {
            square = integrator_move(state, force, pass.omega ? pass.omega[i] : NULL, &pass);
        }
        fastest = square > fastest ? square : fastest;
        squares += square;
        memset(force, 0, 4 * sizeof(double));
        if (pass.omega) {
            spins += *(integrator_two *)pass.omega[i];
            turns += pass.omega[i][2];
            memset(force + 4, 0, 4 * sizeof(double));
        }
    }
    return fastest + 0.0 * (squares + spins[0] + spins[1] + turns);
}

void integrator_stagger(struct particles *particles, const struct integrator_context *context, size_t first,
                        size_t last) {
    const struct integrator_pass pass = integrator_pass_of(particles, context, -0.5 * context->dt, true);
    for (size_t i = first; i < last; i++)
        if (!integrator_carries(&pass, i))
            integrator_kick(pass, i);
}

/* As integrator_full_step, of a particle that moves by itself if `grain`; omega may be NULL. */
static inline void full_step(const struct integrator_pass *pass, size_t i, bool grain, double velocity[3],
                             double *omega) {
    const double *force = pass->force + i * pass->stride;
    const struct particle_state *state = &pass->state[i];
    bool free = grain && integrator_motion_of(pass, i) == NULL;
    for (int c = 0; c < 3; c++)
        velocity[c] =
            state->v[c] + (free ? pass->dt[c] * (force[c] * state->inverse_mass) + pass->fall[c] : 0.0);
    if (omega == NULL)
        return;
    for (int c = 0; c < 3; c++)
        omega[c] = pass->omega[i][c] +
                   (free ? pass->dt[0] * (force[4 + c] * integrator_inverse_inertia(state)) : 0.0);
}

void integrator_full_step(const struct particles *particles, const struct integrator_context *context,
                          size_t i, double velocity[3], double omega[3]) {
    const struct integrator_pass pass =
        integrator_pass_of(particles, context, 0.5 * context->dt, omega != NULL);
    const uint8_t *kind = kinds_of(particles);
    if (integrator_carries(&pass, i))
        carried_full_step(context->carried, i, velocity, omega);
    else
        full_step(&pass, i, kind == NULL || kind[i] == KIND_GRAIN, velocity, omega);
}

void integrator_energies(const struct particles *particles, const struct integrator_context *context,
                         size_t first, size_t last, double energy[2]) {
    const struct integrator_pass pass = integrator_pass_of(particles, context, 0.5 * context->dt, true);
    const uint8_t *kind = kinds_of(particles);
    for (size_t i = first; i < last; i++) {
        const struct particle_state *state = &pass.state[i];
        double v[3], w[3] = {0.0, 0.0, 0.0};
        if (context->carried && kind[i] == KIND_BODY)
            energy[1] += context->carried->pose[context->carried->pose_of[i]].energy;
        if (!(state->inverse_mass > 0.0) || (kind && kind[i] != KIND_GRAIN))
            continue;
        if (integrator_carries(&pass, i))
            carried_full_step(context->carried, i, v, w);
        else
            full_step(&pass, i, true, v, pass.omega ? w : NULL);
        double mass = 1.0 / state->inverse_mass;
        energy[0] += 0.5 * mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        energy[1] += 0.2 * mass * state->radius * state->radius * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    }
}
