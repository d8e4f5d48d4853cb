/* SPDX-License-Identifier: BSD-3-Clause */
/* The field of grains that bodies carry, and their motion from the pose of the body. Read carried.h first. */
#include "physics/grains/motion/carried.h"
#include "kernel/particles/fields.h"
#include <math.h>

static const struct field body = {.name = "body",
                                  .type = FIELD_INT64,
                                  .components = 1,
                                  .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_FIXED,
                                  .fill = -1,
                                  .needed_for = "bodies",
                                  .help = "id of the body that carries the grain, -1: none"};

void carried_register(struct particles *particles) {
    fields_register(particles, &body);
}

int64_t *carried_by(const struct particles *particles) {
    return fields_values(particles, &body);
}

static const struct field solid = {
    .name = "solid_radius",
    .type = FIELD_DOUBLE,
    .components = 1,
    .use = FIELD_TRAVELS | FIELD_FIXED,
    .unit = "m",
    .needed_for = "bodies",
    .help = "radius of a sphere with a member's share of the volume of its body; 0: its own"};

void carried_register_solid(struct particles *particles) {
    fields_register(particles, &solid);
}

double *carried_solid(const struct particles *particles) {
    return fields_values(particles, &solid);
}

static void turned(const double turn[9], const double place[3], double to[3]) {
    for (int d = 0; d < 3; d++)
        to[d] = turn[3 * d] * place[0] + turn[3 * d + 1] * place[1] + turn[3 * d + 2] * place[2];
}

/* v + w x r */
static void rigid(const double v[3], const double w[3], const double r[3], double velocity[3]) {
    velocity[0] = v[0] + (w[1] * r[2] - w[2] * r[1]);
    velocity[1] = v[1] + (w[2] * r[0] - w[0] * r[2]);
    velocity[2] = v[2] + (w[0] * r[1] - w[1] * r[0]);
}

void carried_drift(const struct carried *carried, size_t i, double drift[3]) {
    if (carried->box->motion.moves)
        box_drift(carried->box, carried->image[i], drift);
    else
        drift[0] = drift[1] = drift[2] = 0.0;
}

double carried_move(const struct carried *carried, size_t i, double dt, bool flat,
                    struct particle_state *state, double *omega) {
    const struct carried_pose *pose = &carried->pose[carried->pose_of[i]];
    const bool moves = carried->box->motion.moves;
    double after[3], middle[3], shift[3], drift[3], square = 0.0, moved = 0.0;
    turned(pose->turn, carried->offset[i], after);
    turned(pose->middle, carried->offset[i], middle);
    rigid(pose->v, pose->w, middle, state->v);
    box_shift(carried->box, carried->image[i], shift);
    carried_drift(carried, i, drift);
    if (flat)
        state->v[2] = 0.0;
    for (int d = 0; d < (flat ? 2 : 3); d++) {
        if (moves) {
            state->v[d] += drift[d];
            shift[d] += dt * drift[d];
        }
        double x = (pose->x[d] + after[d]) + shift[d], step = x - state->x[d];
        state->x[d] = x;
        moved += step * step;
        square += state->v[d] * state->v[d];
    }
    for (int d = 0; omega && d < 3; d++)
        omega[d] = pose->w[d];
    moved /= dt * dt;
    return (moved > square ? moved : square) + 0.0 * moved; /* no number if one of the two is none */
}

void carried_full_step(const struct carried *carried, size_t i, double velocity[3], double *omega) {
    const struct carried_pose *pose = &carried->pose[carried->pose_of[i]];
    double place[3], drift[3];
    turned(pose->turn, carried->offset[i], place);
    rigid(pose->full_v, pose->full_w, place, velocity);
    carried_drift(carried, i, drift);
    for (int d = 0; carried->box->motion.moves && d < 3; d++)
        velocity[d] += drift[d];
    for (int d = 0; omega && d < 3; d++)
        omega[d] = pose->full_w[d];
}

void carried_stress(const struct carried *carried, const struct particles *particles, size_t i, bool full,
                    const double v[3], double part[6]) {
    static const int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
    const struct carried_pose *pose = &carried->pose[carried->pose_of[i]];
    const struct particle_state *state = &particles->state[i];
    const double *force = particles->force + i * (size_t)particles->force_stride;
    const double mass = state->inverse_mass > 0.0 ? 1.0 / state->inverse_mass : 0.0;
    double lever[3], centre[3], here[3], there[3], drift[3];
    turned(pose->turn, carried->offset[i], lever);
    carried_drift(carried, i, drift);
    for (int d = 0; d < 3; d++) {
        here[d] = v[d];
        there[d] = (full ? pose->full_v[d] : pose->v[d]) + drift[d];
        centre[d] = state->x[d] - lever[d];
    }
    if (carried->box->motion.moves) {
        double at[3], about[3];
        box_flow(carried->box, state->x, at);
        box_flow(carried->box, centre, about);
        for (int d = 0; d < 3; d++) {
            here[d] -= at[d];
            there[d] -= about[d];
        }
    }
    for (int c = 0; c < 6; c++)
        part[c] += mass * (there[row[c]] * there[column[c]] - here[row[c]] * here[column[c]]) -
                   0.5 * (lever[row[c]] * force[column[c]] + lever[column[c]] * force[row[c]]);
}
