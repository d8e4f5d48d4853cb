/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums the forces on bodies, and moves the bodies. Read bodies.h first. */
#include "physics/bodies/bodies_parts.h"
#include "physics/bodies/bodies_fields.h"
#include "physics/bodies/bodies_links.h"
#include "base/rotor.h"
#include "kernel/particles/spin.h"
#include <string.h>

/* The units of the sums of body b; none where the order of a sum may matter. */
static struct sums_units units_of(const struct bodies_links *l, const struct physics_context *context,
                                  int32_t b) {
    const struct bodies_row *row = &l->row[b];
    if (!context->ordered)
        return (struct sums_units){0};
    return sums_units_of(row->mass, context->particles->state[row->particle].radius, context->clock->dt);
}

/* Adds the force and the torque on the particle of own body b itself. */
static void own_add(struct bodies_links *l, const struct physics_context *context, int32_t b) {
    const struct particles *p = context->particles;
    const double *f = p->force + l->row[b].particle * (size_t)p->force_stride;
    sums_add(l->sum + (size_t)b * (size_t)sums_width(context->ordered), context->ordered,
             units_of(l, context, b), f, f + 4);
}

void bodies_motion_gather(struct bodies_links *l, const struct physics_context *context) {
    const struct particles *p = context->particles;
    const int width = sums_width(context->ordered);
    memset(l->sum, 0, (size_t)l->rows * (size_t)width * sizeof *l->sum);
#pragma omp parallel for schedule(static)
    for (int32_t b = 0; b < l->rows; b++) {
        const struct sums_units units = units_of(l, context, b);
        for (size_t k = l->start[b]; k < l->start[b + 1]; k++) {
            size_t i = l->member[k];
            const double *f = p->force + i * (size_t)p->force_stride, *t = f + 4;
            double r[3], torque[3];
            rotor_turn(l->pose[b].turn, l->offset[i], r);
            for (int d = 0; d < 3; d++) {
                int e = (d + 1) % 3, g = (d + 2) % 3;
                torque[d] = (r[e] * f[g] - r[g] * f[e]) + t[d];
            }
            sums_add(l->sum + (size_t)b * (size_t)width, context->ordered, units, f, torque);
        }
        if (b < l->own)
            own_add(l, context, b);
    }
    if (l->part)
        ghosts_part_sum(l->part, l->sum, width);
}

void bodies_motion_force(const struct bodies_links *l, const struct physics_context *context, int32_t b,
                         double force[3], double torque[3]) {
    sums_value(l->sum + (size_t)b * (size_t)sums_width(context->ordered), context->ordered,
               units_of(l, context, b), force, torque);
}

void bodies_motion_push(const struct bodies_links *l, const struct physics_context *context, int32_t b,
                        double time, double velocity[3], double spin[3]) {
    const struct bodies_row *row = &l->row[b];
    const bool flat = context->box->dimension == 2;
    double force[3], torque[3];
    bodies_motion_force(l, context, b, force, torque);
    for (int d = 0; d < 3; d++) {
        velocity[d] = flat && d == 2 ? 0 : time * (force[d] / row->mass + context->scene->gravity[d]);
        spin[d] = flat && d < 2 ? 0 : time * torque[d];
    }
}

/* The free body b: kick and drift. Its angular velocity of the half step is the mean of those before and after the
 * turn. */
static void move_free(struct bodies_links *l, const struct physics_context *context, int32_t b, double kick,
                      double v[3], double spin[3]) {
    const struct bodies_row *row = &l->row[b];
    const double dt = context->clock->dt;
    double *state = l->state[b];
    double faster[3], more[3], before[3], after[3], turn[9];
    bodies_motion_push(l, context, b, kick, faster, more);
    for (int d = 0; d < 3; d++) {
        v[d] += faster[d];
        spin[d] += more[d];
        state[d] += dt * v[d];
        state[3 + d] = v[d];
    }
    rotor_velocity(l->pose[b].turn, spin, row->inertia, before);
    rotor_advance(state + 9, spin, row->inertia, dt);
    rotor_matrix(state + 9, turn);
    rotor_velocity(turn, spin, row->inertia, after);
    for (int d = 0; d < 3; d++)
        state[6 + d] = 0.5 * (before[d] + after[d]);
}

static void move_prescribed(struct bodies_links *l, const struct physics_context *context, int32_t b) {
    const struct integrator_motion *motion = l->row[b].motion;
    const double dt = context->clock->dt;
    double *state = l->state[b];
    for (int d = 0; d < (context->box->dimension == 2 ? 2 : 3); d++)
        state[d] += dt * motion->velocity[d];
    memcpy(state + 3, motion->velocity, sizeof motion->velocity);
    memcpy(state + 6, motion->omega, sizeof motion->omega);
    rotor_spin(state + 9, motion->omega, dt);
}

void bodies_motion_step(struct bodies *bodies, const struct physics_context *context) {
    struct bodies_links *l = bodies->links;
    struct particles *p = context->particles;
    double(*orientation)[4] = bodies_orientation(p), (*velocity)[3] = bodies_velocity(p),
    (*spin)[3] = bodies_spin(p);
    const double kick = 0.5 * (bodies->before + context->clock->dt);
    bodies_motion_gather(l, context);
#pragma omp parallel for schedule(static)
    for (int32_t b = 0; b < l->own; b++) {
        uint32_t particle = l->row[b].particle;
        if (l->row[b].motion)
            move_prescribed(l, context, b);
        else
            move_free(l, context, b, kick, velocity[particle], spin[particle]);
        memcpy(p->state[particle].x, l->state[b], sizeof p->state[particle].x);
        memcpy(orientation[particle], l->state[b] + 9, sizeof orientation[particle]);
        memset(p->force + particle * (size_t)p->force_stride, 0, (size_t)p->force_stride * sizeof *p->force);
    }
    bodies_links_send(l);
    bodies->before = context->clock->dt;
}

/* What the masses of members do not account for. */
static void rest_set(const struct bodies_row *row, struct carried_pose *pose) {
    double own[3];
    const double factor = row->mass * row->scale * row->scale;
    rotor_turn_back(pose->turn, pose->full_w, own);
    rotor_turn(row->clump->rest, own, own);
    rotor_turn(pose->turn, own, own);
    pose->energy = 0;
    for (int d = 0; d < 3; d++) {
        pose->rest[d] = row->motion ? 0 : factor * own[d];
        pose->energy += 0.5 * pose->full_w[d] * pose->rest[d];
    }
}

static void full_free(struct bodies_links *l, const struct physics_context *context, int32_t b, double time) {
    const struct bodies_row *row = &l->row[b];
    const struct particles *p = context->particles;
    double faster[3], more[3], spin[3], *full = l->full[b];
    bodies_motion_push(l, context, b, time, faster, more);
    for (int d = 0; d < 3; d++) {
        full[d] = bodies_velocity(p)[row->particle][d] + faster[d];
        spin[d] = bodies_spin(p)[row->particle][d] + more[d];
    }
    rotor_velocity(l->pose[b].turn, spin, row->inertia, full + 3);
}

void bodies_motion_full_step(struct bodies *bodies, const struct physics_context *context) {
    struct bodies_links *l = bodies->links;
    struct particles *p = context->particles;
    double(*omega)[4] = spin_of(p);
    bodies_motion_gather(l, context);
#pragma omp parallel for schedule(static)
    for (int32_t b = 0; b < l->own; b++) {
        const struct integrator_motion *motion = l->row[b].motion;
        uint32_t particle = l->row[b].particle;
        if (motion) {
            memcpy(l->full[b], motion->velocity, sizeof motion->velocity);
            memcpy(l->full[b] + 3, motion->omega, sizeof motion->omega);
        } else {
            full_free(l, context, b, 0.5 * bodies->before);
        }
        memcpy(p->state[particle].v, l->full[b], sizeof p->state[particle].v);
        memcpy(omega[particle], l->full[b] + 3, 3 * sizeof **omega);
    }
    if (l->part)
        ghosts_part_forward(l->part, l->full[0], BODIES_FULL);
#pragma omp parallel for schedule(static)
    for (int32_t b = 0; b < l->rows; b++) {
        memcpy(l->pose[b].full_v, l->full[b], sizeof l->pose[b].full_v);
        memcpy(l->pose[b].full_w, l->full[b] + 3, sizeof l->pose[b].full_w);
        rest_set(&l->row[b], &l->pose[b]);
    }
}
