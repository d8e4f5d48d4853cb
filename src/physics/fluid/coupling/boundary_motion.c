/* SPDX-License-Identifier: BSD-3-Clause */
/* Carries boundary particles along with their grains. Read boundary_motion.h first. */
#include "physics/fluid/coupling/boundary_motion.h"
#include "kernel/particles/spin.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/schemes/flow_fields.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

bool boundary_wanted(const struct physics_context *context) {
    const struct scene *scene = context->scene;
    bool moving = false;
    for (int k = 0; k < scene->groups; k++)
        moving = moving || scene->group[k].motion == SCENE_MOVING;
    if (fluid_rigid(context->options))
        return false;
    return grain_free(context->options) || (moving && fluid_carries(context->options));
}

/* a x b. */
static void cross(const double a[3], const double b[3], double out[3]) {
    for (int d = 0; d < 3; d++)
        out[d] = a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
}

/* Turns the arm by omega dt (Rodrigues). */
static void turn(double arm[3], const double omega[3], double dt) {
    double rate = sqrt(omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2]), axis[3], across[3];
    if (rate == 0)
        return;
    double c = cos(rate * dt), s = sin(rate * dt), along = 0;
    for (int d = 0; d < 3; d++) {
        axis[d] = omega[d] / rate;
        along += axis[d] * arm[d];
    }
    cross(axis, arm, across);
    for (int d = 0; d < 3; d++)
        arm[d] = c * arm[d] + s * across[d] + (1 - c) * along * axis[d];
}

static const double *spin_at(const struct particles *particles, size_t i) {
    static const double none[3] = {0};
    double(*spin)[4] = spin_of(particles);
    return spin ? spin[i] : none;
}

double boundary_move(const struct physics_context *context, size_t first, size_t last) {
    struct particles *p = context->particles;
    const int64_t *body = fluid_body(p);
    double(*arm)[3] = fluid_arm(p), dt = grain_dt(context);
    double largest = 0;
    for (size_t i = first; i < last; i++) {
        double before[3], surface[3], square = 0;
        if (body[i] <= 0)
            continue;
        memcpy(before, arm[i], sizeof before);
        cross(spin_at(p, i), before, surface);
        turn(arm[i], spin_at(p, i), dt);
        for (int d = 0; d < context->box->dimension; d++) {
            double moved = dt * (p->state[i].v[d] - surface[d]) + arm[i][d] - before[d];
            p->state[i].x[d] += moved;
            square += moved * moved / (context->clock->dt * context->clock->dt);
        }
        if (!isnan(largest) && !(square <= largest))
            largest = square;
    }
    return largest;
}

/* The grain of a boundary particle: its number; `centre` becomes the place of its image nearest to the particle. SIZE_MAX: not among
 * the pairs. */
static size_t grain_find(const struct fluid *fluid, size_t i, int64_t body, double centre[3]) {
    const struct weights_input *input = &fluid->input;
    const struct particle_state *state = input->particles->state;
    double nearest = INFINITY;
    size_t found = SIZE_MAX;
    for (size_t e = input->pairs->start[i]; e < input->pairs->start[i + 1]; e++) {
        size_t j = pair_partner(input->pairs->partner[e]);
        const double *shift = input->shift[pair_image(input->pairs->partner[e])];
        double at[3], square = 0;
        if (input->kind[j] != KIND_GRAIN || input->particles->id[j] != body)
            continue;
        for (int d = 0; d < 3; d++) {
            double to = d < input->dimension ? state[j].x[d] - state[i].x[d] + shift[d] : 0;
            at[d] = d < input->dimension ? state[j].x[d] + shift[d] : state[i].x[d];
            square += to * to;
        }
        if (square < nearest) {
            nearest = square;
            found = j;
            memcpy(centre, at, sizeof at);
        }
    }
    return found;
}

/* The place, velocity and spin of a particle on grain j. */
static void place(const struct fluid *fluid, size_t i, size_t j, const double centre[3],
                  const double arm[3]) {
    const struct particles *p = fluid->input.particles;
    double(*spin)[4] = spin_of(p), surface[3];
    struct particle_state *state = &p->state[i];
    for (int d = 0; d < fluid->input.dimension; d++)
        state->x[d] = centre[d] + arm[d];
    cross(spin_at(p, j), arm, surface);
    for (int d = 0; d < 3; d++)
        state->v[d] = p->state[j].v[d] + surface[d];
    if (spin)
        memcpy(spin[i], spin[j], sizeof spin[i]);
}

size_t boundary_settle(const struct physics_context *context, const struct fluid *fluid) {
    struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    const int64_t *body = fluid_body(p);
    double(*arm)[3] = fluid_arm(p);
    size_t lost = 0;
#pragma omp parallel for schedule(static) reduction(+ : lost)
    for (size_t i = 0; i < p->owned; i++) {
        double centre[3];
        if (kind[i] != KIND_BOUNDARY || body[i] <= 0)
            continue;
        size_t j = grain_find(fluid, i, body[i], centre);
        bool first = isnan(arm[i][0]);
        lost += j == SIZE_MAX;
        if (j == SIZE_MAX || !(first || grain_due(context)))
            continue;
        for (int d = 0; first && d < 3; d++)
            arm[i][d] = p->state[i].x[d] - centre[d];
        place(fluid, i, j, centre, arm[i]);
    }
    flow_fields_forward_places(context);
    return lost;
}

void boundary_follow(const struct physics_context *context) {
    const struct fluid *fluid = context->self;
    int64_t moved = fluid->followed == context->clock->step;
    if (!grain_due(context))
        return;
    comm_max_int(context->comm, &moved, 1);
    if (!moved)
        return;
    flow_fields_forward_places(context);
    boundary_settle(context, fluid);
}
