#include "integrate/integrator.h"
#include <stddef.h>
#include <string.h>

/* Four doubles that move together; lowered to narrower registers where the CPU has none so wide. */
typedef double integrator_four __attribute__((vector_size(32), aligned(8), may_alias));

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

/* What a pass needs of the context, per component: the time step (0 for z in 2D) and the change of velocity
 * by gravity. */
struct integrator_pass {
    integrator_four dt, fall;
};

static struct integrator_pass integrator_pass_of(const struct integrator_context *context, double dt) {
    double z = context->dimension == 3 ? dt : 0.0;
    const double *g = context->gravity;
    return (struct integrator_pass){.dt = {dt, dt, z, 0.0}, .fall = {dt * g[0], dt * g[1], z * g[2], 0.0}};
}

/* The prescribed motion of particle i, or NULL if it is free. */
static inline const struct integrator_motion *
integrator_motion_of(const struct particles *particles, const struct integrator_context *context, size_t i) {
    if (particles->group == NULL || !context->motion[particles->group[i]].prescribed)
        return NULL;
    return &context->motion[particles->group[i]];
}

/* 1 / moment of inertia of a solid sphere: 5 / (2 m r^2). */
static inline double integrator_inverse_inertia(const struct particle_state *state) {
    return 2.5 * state->inverse_mass / (state->radius * state->radius);
}

/* Velocities of particle i after `pass->dt` under its present force. A sphere in 2D turns about z only, as
 * its torque has no other component. */
static inline void integrator_kick(struct particles *particles, const struct integrator_pass *pass, size_t i,
                                   const integrator_four *force) {
    struct particle_state *state = &particles->state[i];
    integrator_four v = {state->v[0], state->v[1], state->v[2], 0.0};
    v += pass->dt * (force[0] * state->inverse_mass) + pass->fall;
    memcpy(state->v, &v, sizeof state->v);
    if (particles->omega)
        *(integrator_four *)particles->omega[i] +=
            pass->dt[0] * (force[1] * integrator_inverse_inertia(state));
}

/* Sets the prescribed velocities of particle i. */
static void integrator_prescribe(struct particles *particles, const struct integrator_motion *motion,
                                 size_t i) {
    memcpy(particles->state[i].v, motion->velocity, sizeof motion->velocity);
    if (particles->omega)
        memcpy(particles->omega[i], motion->omega, sizeof motion->omega);
}

double integrator_advance(struct particles *particles, const struct integrator_context *context, size_t first,
                          size_t last) {
    const struct integrator_pass pass = integrator_pass_of(context, context->dt);
    const size_t stride = (size_t)particles->force_stride;
    const integrator_four zero = {0.0, 0.0, 0.0, 0.0};
    double fastest = 0.0, poison = 0.0; /* the second: 0, or NaN once a square is not finite */
    for (size_t i = first; i < last; i++) {
        struct particle_state *state = &particles->state[i];
        integrator_four *force = (integrator_four *)(particles->force + i * stride);
        const struct integrator_motion *motion = integrator_motion_of(particles, context, i);
        if (motion)
            integrator_prescribe(particles, motion, i);
        else
            integrator_kick(particles, &pass, i, force);
        for (size_t c = 0; c < stride / 4; c++)
            force[c] = zero;
        for (int c = 0; c < 3; c++)
            state->x[c] += pass.dt[c] * state->v[c];
        double square = state->v[0] * state->v[0] + state->v[1] * state->v[1] + state->v[2] * state->v[2];
        fastest = square > fastest ? square : fastest;
        poison += 0.0 * square;
    }
    return fastest + poison;
}

void integrator_stagger(struct particles *particles, const struct integrator_context *context, size_t first,
                        size_t last) {
    const struct integrator_pass pass = integrator_pass_of(context, -0.5 * context->dt);
    const size_t stride = (size_t)particles->force_stride;
    for (size_t i = first; i < last; i++) {
        const struct integrator_motion *motion = integrator_motion_of(particles, context, i);
        if (motion)
            integrator_prescribe(particles, motion, i);
        else
            integrator_kick(particles, &pass, i, (const integrator_four *)(particles->force + i * stride));
    }
}

void integrator_full_step(const struct particles *particles, const struct integrator_context *context,
                          size_t i, double velocity[3], double omega[3]) {
    const struct particle_state *state = &particles->state[i];
    const struct integrator_motion *motion = integrator_motion_of(particles, context, i);
    const double *force = particles->force + i * (size_t)particles->force_stride;
    const struct integrator_pass pass = integrator_pass_of(context, motion ? 0.0 : 0.5 * context->dt);
    for (int c = 0; c < 3; c++)
        velocity[c] = state->v[c] + pass.dt[c] * (force[c] * state->inverse_mass) + pass.fall[c];
    if (omega == NULL)
        return;
    for (int c = 0; c < 3; c++)
        omega[c] = particles->omega[i][c] + pass.dt[0] * (force[4 + c] * integrator_inverse_inertia(state));
}
