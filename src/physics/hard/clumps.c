/* SPDX-License-Identifier: BSD-3-Clause */
/* Bodies of spheres and the contact problem of a step. Read clumps.h first. */
#include "physics/hard/clumps.h"
#include "base/memory.h"
#include "physics/bodies/bodies_fields.h"
#include "physics/bodies/bodies_links.h"
#include "physics/bodies/bodies_parts.h"
#include "base/rotor.h"
#include <string.h>

void hard_clumps_free(struct hard_clumps *clumps) {
    memory_free(clumps->turn);
    memory_free(clumps->free);
    *clumps = (struct hard_clumps){0};
}

void hard_clumps_link(struct hard_clumps *clumps, const struct physics_context *context) {
    const struct bodies *bodies = bodies_of(context->set);
    clumps->context = context;
    clumps->links = bodies ? bodies->links : NULL;
    if (clumps->links == NULL || (size_t)clumps->links->rows <= clumps->room)
        return;
    clumps->room = (size_t)clumps->links->rows + (size_t)clumps->links->rows / 4;
    clumps->turn = memory_resize(clumps->turn, clumps->room, sizeof *clumps->turn, "bodies in contact");
    clumps->free = memory_resize(clumps->free, clumps->room, sizeof *clumps->free, "bodies in contact");
}

bool hard_clumps_carries(const struct hard_clumps *clumps, uint32_t i) {
    return clumps->links && clumps->links->pose_of[i] >= 0;
}

uint32_t hard_clumps_carrier(const struct hard_clumps *clumps, uint32_t i) {
    return hard_clumps_carries(clumps, i) ? clumps->links->row[clumps->links->pose_of[i]].particle : i;
}

void hard_clumps_lever(const struct hard_clumps *clumps, uint32_t i, double lever[3]) {
    const struct bodies_links *links = clumps->links;
    rotor_turn(links->pose[links->pose_of[i]].turn, links->offset[i], lever);
}

const double *hard_clumps_turn(const struct hard_clumps *clumps, uint32_t i) {
    return clumps->turn[clumps->links->pose_of[i]];
}

int32_t hard_clumps_count(const struct hard_clumps *clumps) {
    return clumps->links ? clumps->links->rows : 0;
}

const double *hard_clumps_at(const struct hard_clumps *clumps, int32_t b, uint32_t *particle) {
    *particle = clumps->links->row[b].particle;
    return clumps->turn[b];
}

/* turn x diagonal x its transpose, times a vector. */
static void inertia_times(const struct bodies_links *links, int32_t b, const double w[3], double out[3]) {
    double own[3];
    rotor_turn_back(links->pose[b].turn, w, own);
    for (int d = 0; d < 3; d++)
        own[d] *= links->row[b].inertia[d];
    rotor_turn(links->pose[b].turn, own, out);
}

/* The inverse inertia of body b in space; in two dimensions bodies turn about z alone. */
static void turn_set(struct hard_clumps *clumps, int32_t b) {
    static const int place[HARD_TENSOR][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    const struct bodies_row *row = &clumps->links->row[b];
    const double *r = clumps->links->pose[b].turn;
    bool flat = clumps->context->box->dimension == 2;
    for (int k = 0; k < HARD_TENSOR; k++) {
        double sum = 0.0;
        for (int d = 0; d < 3; d++)
            sum += r[3 * place[k][0] + d] * r[3 * place[k][1] + d] / row->inertia[d];
        clumps->turn[b][k] = flat && k != 2 ? 0.0 : sum;
    }
}

/* Own body b without contacts: as the mover would kick it. */
static struct hard_body free_of(const struct hard_clumps *clumps, int32_t b) {
    const struct bodies_links *links = clumps->links;
    const struct bodies_row *row = &links->row[b];
    const struct particles *p = clumps->context->particles;
    struct hard_body body = {.lightness = 1.0 / row->mass, .swing = 1.0};
    double spin[3];
    if (row->motion) {
        body.lightness = body.swing = 0.0;
        memcpy(body.v, row->motion->velocity, sizeof body.v);
        memcpy(body.w, row->motion->omega, sizeof body.w);
        return body;
    }
    bodies_motion_push(links, clumps->context, b, clumps->duration, body.v, spin);
    for (int d = 0; d < 3; d++) {
        body.v[d] += bodies_velocity(p)[row->particle][d];
        spin[d] += bodies_spin(p)[row->particle][d];
    }
    rotor_velocity(links->pose[b].turn, spin, row->inertia, body.w);
    return body;
}

void hard_clumps_begin(struct hard_clumps *clumps, double duration) {
    clumps->duration = duration;
    if (clumps->links == NULL)
        return;
    bodies_motion_gather((struct bodies_links *)clumps->links, clumps->context);
#pragma omp parallel for schedule(static)
    for (int32_t b = 0; b < clumps->links->rows; b++) {
        turn_set(clumps, b);
        if (b < clumps->links->own)
            clumps->free[b] = free_of(clumps, b);
    }
}

double hard_clumps_set(const struct hard_clumps *clumps, struct hard_problem *problem, double *pull) {
    const struct bodies_links *links = clumps->links;
    double fastest = 0.0;
    for (int32_t b = 0; links && b < links->rows; b++) {
        const struct bodies_row *row = &links->row[b];
        struct hard_body *body = &problem->body[row->particle];
        bool free = row->motion == NULL;
        *body = (struct hard_body){.lightness = free ? 1.0 / row->mass : 0.0, .swing = free ? 1.0 : 0.0};
        if (b >= links->own)
            continue;
        *body = clumps->free[b];
        double radius = clumps->context->particles->state[row->particle].radius, square = 0.0;
        fastest =
            fmax(fastest, sqrt(vector_dot(body->v, body->v)) + radius * sqrt(vector_dot(body->w, body->w)));
        const double *v = bodies_velocity(clumps->context->particles)[row->particle];
        for (int d = 0; d < 3 && free; d++)
            square += (body->v[d] - v[d]) * (body->v[d] - v[d]);
        *pull = fmax(*pull, sqrt(square) / clumps->duration);
    }
    return fastest;
}

/* Impulse and moment of the contacts on own body b. */
static void impulse_of(const struct hard_clumps *clumps, const struct hard_body *after, int32_t b,
                       double impulse[6]) {
    const struct hard_body *free = &clumps->free[b];
    double spin[3];
    for (int d = 0; d < 3; d++) {
        impulse[d] = (after->v[d] - free->v[d]) * clumps->links->row[b].mass;
        spin[d] = after->w[d] - free->w[d];
    }
    inertia_times(clumps->links, b, spin, impulse + 3);
}

double hard_clumps_give(const struct hard_clumps *clumps, const struct hard_problem *problem,
                        const double *(*gathered)(const void *context, size_t k), const void *of) {
    const struct bodies_links *links = clumps->links;
    struct particles *p = clumps->context ? clumps->context->particles : NULL;
    double lost = 0.0;
    for (int32_t b = 0; links && b < links->own; b++) {
        const struct bodies_row *row = &links->row[b];
        const struct hard_body *after = &problem->body[row->particle];
        double *force = p->force + (size_t)row->particle * (size_t)p->force_stride, impulse[6], w[3];
        const double *v = bodies_velocity(p)[row->particle];
        rotor_velocity(links->pose[b].turn, bodies_spin(p)[row->particle], row->inertia, w);
        if (row->motion) {
            memcpy(impulse, gathered(of, row->particle), sizeof impulse);
            v = row->motion->velocity;
            memcpy(w, row->motion->omega, sizeof w);
        } else {
            impulse_of(clumps, after, b, impulse);
        }
        for (int d = 0; d < 3; d++) {
            force[d] += impulse[d] / clumps->duration;
            force[4 + d] += impulse[3 + d] / clumps->duration;
            lost -= 0.5 * (impulse[d] * (v[d] + after->v[d]) + impulse[3 + d] * (w[d] + after->w[d]));
        }
    }
    return lost;
}
