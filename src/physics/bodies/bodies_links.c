/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds the body of each member by its id, and the members of each body. Read bodies_links.h first. */
#include "physics/bodies/bodies_links.h"
#include "physics/grains/grains.h"
#include "physics/bodies/bodies_fields.h"
#include "base/rotor.h"
#include "base/memory.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

void bodies_links_free(struct bodies_links **links) {
    struct bodies_links *l = *links;
    if (l == NULL)
        return;
    memory_free(l->row);
    memory_free(l->pose);
    memory_free(l->sum);
    memory_free(l->state);
    memory_free(l->full);
    memory_free(l->start);
    memory_free(l->member);
    memory_free(l->pose_of);
    memory_free(l->offset);
    memory_free(l->image);
    ghosts_part_destroy(&l->part);
    memory_free(l);
    *links = NULL;
}

/* The row of an id. */
struct named {
    int64_t id;
    int32_t row;
};

static int named_compare(const void *a, const void *b) {
    const struct named *x = a, *y = b;
    return x->id != y->id ? (x->id > y->id) - (x->id < y->id) : (x->row > y->row) - (x->row < y->row);
}

/* The lowest row with an id: the own body before copies. */
static int32_t named_find(const struct named *named, int32_t rows, int64_t id) {
    int32_t low = 0, high = rows;
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        if (named[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == rows || named[low].id != id)
        error_fatal("body %lld is not known to a rank that has a member of it, or a copy of one",
                    (long long)id);
    return named[low].row;
}

static void row_make(const struct bodies *bodies, const struct physics_context *context, uint32_t particle,
                     struct bodies_row *row) {
    const struct particles *p = context->particles;
    const uint8_t *group = groups_of(p);
    const struct clump *clump = &bodies->clump[bodies_part(p)[particle]];
    double scale = p->state[particle].radius / clump->extent, mass = bodies_mass(p)[particle];
    *row = (struct bodies_row){.particle = particle, .clump = clump, .scale = scale, .mass = mass};
    for (int d = 0; d < 3; d++)
        row->inertia[d] = mass * clump->gyration[d] * scale * scale;
    if (group && grains_motion(context)->motion[group[particle]].prescribed)
        row->motion = &grains_motion(context)->motion[group[particle]];
}

/* Rows of own bodies and of copies, and the rows of all particles (-1: no body); to be freed. */
static int32_t *rows_make(struct bodies_links *l, const struct bodies *bodies,
                          const struct physics_context *context) {
    const struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    size_t all = p->owned + p->ghosts, count = 0;
    int32_t *row_of = memory_allocate(all, sizeof *row_of, "rows of bodies");
    for (size_t k = 0; k < all; k++) {
        row_of[k] = kind[k] == KIND_BODY ? (int32_t)count++ : -1;
        if (k + 1 == p->owned)
            l->own = (int32_t)count;
    }
    l->rows = (int32_t)count;
    l->row = memory_allocate_zero(count, sizeof *l->row, "bodies");
    for (size_t k = 0; k < all; k++)
        if (row_of[k] >= 0)
            row_make(bodies, context, (uint32_t)k, &l->row[row_of[k]]);
    return row_of;
}

/* States of own bodies from their fields. */
static void states_take(struct bodies_links *l, const struct particles *p) {
    double(*velocity)[3] = bodies_velocity(p), (*spin)[3] = bodies_spin(p),
    (*orientation)[4] = bodies_orientation(p);
    for (int32_t b = 0; b < l->own; b++) {
        const struct bodies_row *row = &l->row[b];
        double *state = l->state[b], turn[9];
        memcpy(state, p->state[row->particle].x, 3 * sizeof *state);
        memcpy(state + 3, velocity[row->particle], 3 * sizeof *state);
        memcpy(state + 9, orientation[row->particle], 4 * sizeof *state);
        rotor_matrix(state + 9, turn);
        if (row->motion)
            memcpy(state + 6, row->motion->omega, 3 * sizeof *state);
        else
            rotor_velocity(turn, spin[row->particle], row->inertia, state + 6);
    }
}

void bodies_links_send(struct bodies_links *l) {
    if (l->part)
        ghosts_part_forward(l->part, l->state[0], BODIES_STATE);
#pragma omp parallel for schedule(static)
    for (int32_t b = 0; b < l->rows; b++) {
        const double *state = l->state[b];
        struct carried_pose *pose = &l->pose[b];
        double turn[9];
        memcpy(pose->x, state, sizeof pose->x);
        memcpy(pose->v, state + 3, sizeof pose->v);
        memcpy(pose->w, state + 6, sizeof pose->w);
        rotor_matrix(state + 9, turn);
        for (int k = 0; k < 9; k++)
            pose->middle[k] = 0.5 * (pose->turn[k] + turn[k]);
        memcpy(pose->turn, turn, sizeof turn);
    }
}

/* Place and image of a member, whose particle lies where its body has put it, but for whole edges of the box. */
static void member_place(struct bodies_links *l, const struct physics_context *context, size_t i) {
    const struct bodies_row *row = &l->row[l->pose_of[i]];
    const struct carried_pose *pose = &l->pose[l->pose_of[i]];
    const struct clump_sphere *sphere = &row->clump->sphere[bodies_part(context->particles)[i]];
    const double *x = context->particles->state[i].x;
    double place[3];
    for (int d = 0; d < 3; d++)
        l->offset[i][d] = row->scale * sphere->centre[d];
    rotor_turn(pose->turn, l->offset[i], place);
    for (int d = 0; d < 3; d++)
        place[d] = x[d] - (pose->x[d] + place[d]);
    box_images(context->box, place, l->image[i]);
}

static void members_find(struct bodies_links *l, const struct physics_context *context) {
    const struct particles *p = context->particles;
    const int64_t *body = carried_by(p);
    struct named *named = memory_allocate((size_t)l->rows, sizeof *named, "ids of bodies");
    for (int32_t b = 0; b < l->rows; b++)
        named[b] = (struct named){p->id[l->row[b].particle], b};
    qsort(named, (size_t)l->rows, sizeof *named, named_compare);
    /* a solver of contacts and a fluid ask for the bodies of copies, too */
    bool asked = grains_solved(context) || context->scene->physics_given[PHYSICS_fluid];
    size_t all = asked ? p->owned + p->ghosts : p->owned;
    l->pose_of = memory_allocate(all, sizeof *l->pose_of, "bodies of particles");
    l->offset = memory_allocate_zero(all, sizeof *l->offset, "places of members");
    l->image = memory_allocate_zero(all, sizeof *l->image, "images of members");
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < all; i++) {
        l->pose_of[i] = body[i] >= 0 ? named_find(named, l->rows, body[i]) : -1;
        if (l->pose_of[i] >= 0)
            member_place(l, context, i);
    }
    memory_free(named);
}

/* Members by body, in each body by their number. Then bodies get their own poses. */
static void members_sort(struct bodies_links *l, const struct physics_context *context) {
    const struct particles *p = context->particles;
    const int32_t *part = bodies_part(p);
    size_t *at = l->start = memory_allocate_zero((size_t)l->rows + 2, sizeof *at, "members of bodies");
    l->member = memory_allocate(p->owned, sizeof *l->member, "members of bodies");
    for (size_t i = 0; i < p->owned; i++)
        if (l->pose_of[i] >= 0)
            at[l->pose_of[i] + 2]++;
    for (int32_t b = 0; b < l->rows; b++)
        at[b + 2] += at[b + 1];
    for (size_t i = 0; i < p->owned; i++)
        if (l->pose_of[i] >= 0)
            l->member[at[l->pose_of[i] + 1]++] = (uint32_t)i;
#pragma omp parallel for schedule(static)
    for (int32_t b = 0; b < l->rows; b++)
        for (size_t k = l->start[b] + 1; k < l->start[b + 1]; k++)
            for (size_t m = k; m > l->start[b] && part[l->member[m]] < part[l->member[m - 1]]; m--) {
                uint32_t swap = l->member[m];
                l->member[m] = l->member[m - 1];
                l->member[m - 1] = swap;
            }
    for (int32_t b = 0; b < l->own; b++)
        l->pose_of[l->row[b].particle] = b;
}

void bodies_links_make(struct bodies *bodies, const struct physics_context *context) {
    bodies_links_free(&bodies->links);
    struct bodies_links *l = bodies->links = memory_allocate_zero(1, sizeof *l, "links of bodies");
    int32_t *row_of = rows_make(l, bodies, context);
    size_t rows = (size_t)l->rows;
    if (context->ghosts)
        l->part = ghosts_part_create(context->ghosts, row_of);
    memory_free(row_of);
    l->pose = memory_allocate_zero(rows, sizeof *l->pose, "poses of bodies");
    l->sum = memory_allocate(rows * (size_t)sums_width(context->ordered), sizeof *l->sum, "forces on bodies");
    l->state = memory_allocate(rows, sizeof *l->state, "states of bodies");
    l->full = memory_allocate(rows, sizeof *l->full, "states of bodies");
    states_take(l, context->particles);
    bodies_links_send(l);
    members_find(l, context);
    members_sort(l, context);
    bodies->carried = (struct carried){
        l->pose_of,   (const double(*)[3])l->offset,    (const int32_t(*)[3])l->image, l->pose,
        context->box, carried_solid(context->particles)};
}
