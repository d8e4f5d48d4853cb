/* SPDX-License-Identifier: BSD-3-Clause */
/* Which particles are rocks, and which pairs and walls they may touch, from a rebuild to the next. Read rocks.h first. */
#include "physics/bodies/rocks_state.h"
#include "physics/bodies/bodies_fields.h"
#include "physics/bodies/bodies_links.h"
#include "physics/grains/grains.h"
#include "base/memory.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include "fields_table.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char what[] = "contacts of rocks";

static const struct field shape = {.name = "rock_shape",
                                   .type = FIELD_INT32,
                                   .components = 1,
                                   .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT,
                                   .fill = -1,
                                   .needed_for = "rocks",
                                   .help = "number of the shape of a rock's ball; -1: a sphere"};
static const struct field turn = {
    .name = "rock_orientation",
    .type = FIELD_DOUBLE,
    .components = 4,
    .use = FIELD_FORWARD | FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT,
    .needed_for = "rocks",
    .help = "of the ball around a rock: unit quaternion w x y z from the frame of the shape to space"};

int32_t *rocks_shapes(const struct particles *particles) {
    return fields_values(particles, &shape);
}

double (*rocks_orientations(const struct particles *particles))[4] {
    return fields_values(particles, &turn);
}

void rocks_register(struct particles *particles) {
    fields_register(particles, &shape);
    fields_register(particles, &turn);
}

struct rocks *rocks_create(const struct physics_context *context) {
    struct rocks *rocks = memory_allocate_zero(1, sizeof *rocks, what);
    rocks_register(context->particles);
    solid_dot(&rocks->dot);
    return rocks;
}

static void lists_free(struct rocks *rocks) {
    memory_free(rocks->first);
    memory_free(rocks->end);
    memory_free(rocks->stand_of);
    memory_free(rocks->stand);
    memory_free(rocks->corner);
}

void rocks_free(struct rocks **rocks) {
    if (*rocks == NULL)
        return;
    lists_free(*rocks);
    memory_free((*rocks)->pair);
    solid_free(&(*rocks)->dot);
    history_rows_free(&(*rocks)->rows);
    memory_free(*rocks);
    *rocks = NULL;
}

void rocks_member(const struct particles *particles, size_t m, int number, const double orientation[4]) {
    rocks_shapes(particles)[m] = number;
    memcpy(rocks_orientations(particles)[m], orientation, 4 * sizeof *orientation);
}

int rocks_shape(const struct particles *particles, size_t i) {
    return rocks_shapes(particles)[i];
}

void rocks_turn(const struct bodies *bodies, const struct particles *particles) {
    const struct bodies_links *l = bodies->links;
    double(*orientation)[4] = rocks_orientations(particles);
#pragma omp parallel for schedule(static)
    for (int32_t b = 0; b < l->rows; b++)
        for (size_t k = l->start[b]; k < l->start[b + 1]; k++)
            memcpy(orientation[l->member[k]], l->state[b] + 9, sizeof orientation[l->member[k]]);
}

double rocks_inner(const struct bodies *bodies, const struct particles *p, size_t i) {
    const int shape = bodies && bodies->rocks ? rocks_shape(p, i) : -1;
    const double radius = p->state[i].radius;
    return shape < 0 ? radius : radius / bodies->clump[shape].extent * bodies->clump[shape].inner;
}

/* Lists the rocks among particles and copies. */
static void stands_make(struct bodies *bodies, const struct particles *p) {
    struct rocks *rocks = bodies->rocks;
    const int32_t *number = rocks_shapes(p);
    size_t corners = 0;
    rocks->particles = p->owned + p->ghosts;
    rocks->stands = 0;
    rocks->stand_of = memory_allocate(rocks->particles, sizeof *rocks->stand_of, what);
    for (size_t k = 0; k < rocks->particles; k++) {
        rocks->stand_of[k] = number[k] >= 0 ? (int32_t)rocks->stands++ : -1;
        corners += number[k] >= 0 ? (size_t)bodies->clump[number[k]].core.corners : 0;
    }
    rocks->stand = memory_allocate_zero(rocks->stands, sizeof *rocks->stand, what);
    rocks->corner = memory_allocate(corners, sizeof *rocks->corner, what);
    corners = 0;
    for (size_t k = 0; k < rocks->particles; k++) {
        if (rocks->stand_of[k] < 0)
            continue;
        const struct clump *clump = &bodies->clump[number[k]];
        struct rocks_stand *stand = &rocks->stand[rocks->stand_of[k]];
        double scale = p->state[k].radius / clump->extent;
        *stand = (struct rocks_stand){.particle = (uint32_t)k, .corner = rocks->corner + corners};
        stand->posed = (struct posed){.core = &clump->core,
                                      .corner = (const double(*)[3])stand->corner,
                                      .turn = stand->turn,
                                      .scale = scale,
                                      .rounding = scale * clump->rounding};
        stand->inner = rocks_inner(bodies, p, k);
        corners += (size_t)clump->core.corners;
    }
}

static struct rocks_pair *pair_add(struct rocks *rocks) {
    if (rocks->pairs == rocks->room) {
        rocks->room = 2 * rocks->room + 64;
        rocks->pair = memory_resize(rocks->pair, rocks->room, sizeof *rocks->pair, what);
    }
    memset(&rocks->pair[rocks->pairs], 0, sizeof *rocks->pair);
    return &rocks->pair[rocks->pairs++];
}

/* Each pair of the list once, as both threads of a pair have it. */
static void pairs_take(struct rocks *rocks, const struct particles *p, const struct pairlist *list,
                       bool newton) {
    struct pair_visit visit = pairlist_all(list);
    while (pairlist_each(list, &visit)) {
        if (visit.block->kind == PAIR_BLOCK_MIRROR || visit.i >= p->owned ||
            (rocks->stand_of[visit.i] < 0 && rocks->stand_of[visit.j] < 0))
            continue;
        struct rocks_pair *pair = pair_add(rocks);
        bool turned = p->id[visit.j] < p->id[visit.i];
        pair->end[turned] = visit.i;
        pair->end[!turned] = visit.j;
        pair->gives[turned] = true;
        pair->gives[!turned] = visit.j < p->owned || newton;
        pair->turned = turned;
        pair->image = (uint8_t)visit.image;
        pair->number = (uint32_t)visit.k;
        pair->wall = -1;
    }
}

/* Each rock with each image of a wall near its ball. */
static void walls_take(struct rocks *rocks, const struct particles *p, const struct walls *walls) {
    for (size_t s = 0; walls && s < rocks->stands; s++) {
        struct wall_group group = {0};
        const uint32_t particle = rocks->stand[s].particle;
        while (particle < p->owned && walls_group_next(walls, particle, &group)) {
            struct rocks_pair *pair = pair_add(rocks);
            pair->end[0] = particle;
            pair->end[1] = ROCKS_WALL;
            pair->gives[0] = true;
            pair->wall = group.wall;
            pair->group = group;
        }
    }
}

static int end_compare(const void *a, const void *b) {
    const struct rocks_end *x = a, *y = b;
    return x->partner != y->partner ? (x->partner > y->partner) - (x->partner < y->partner)
                                    : (x->pair > y->pair) - (x->pair < y->pair);
}

/* The ends of each particle, in the order of the ids of their partners. */
static void ends_make(struct rocks *rocks, const struct particles *p) {
    size_t *first = rocks->first = memory_allocate_zero(rocks->particles + 2, sizeof *first, what);
    rocks->end = memory_allocate(2 * rocks->pairs, sizeof *rocks->end, what);
    for (size_t k = 0; k < rocks->pairs; k++)
        for (int side = 0; side < 2; side++)
            if (rocks->pair[k].gives[side])
                first[rocks->pair[k].end[side] + 2]++;
    for (size_t k = 0; k < rocks->particles; k++)
        first[k + 2] += first[k + 1];
    for (size_t k = 0; k < rocks->pairs; k++)
        for (int side = 0; side < 2; side++) {
            const struct rocks_pair *pair = &rocks->pair[k];
            if (!pair->gives[side])
                continue;
            rocks->end[first[pair->end[side] + 1]++] =
                (struct rocks_end){.pair = (uint32_t)k,
                                   .side = (uint8_t)side,
                                   .partner = pair->wall >= 0 ? -1 - pair->wall : p->id[pair->end[!side]]};
        }
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < rocks->particles; k++)
        if (first[k + 1] > first[k] + 1)
            qsort(rocks->end + first[k], first[k + 1] - first[k], sizeof *rocks->end, end_compare);
}

void rocks_apart(const struct rocks_pair *pair, const struct particles *p, const struct pairlist *list,
                 double apart[3]) {
    const double *a = p->state[pair->end[0]].x, *b = p->state[pair->end[1]].x,
                 *shift = list->shift[pair->image];
    for (int d = 0; d < 3; d++)
        apart[d] = (b[d] - a[d]) + (pair->turned ? -shift[d] : shift[d]);
}

/* The point that a row remembers. */
static struct touch_memory memory_of(const struct history_row *row) {
    struct touch_memory memory = {.key = row->value[9]};
    memcpy(memory.spring, row->value, sizeof memory.spring);
    memcpy(memory.roll, row->value + 3, sizeof memory.roll);
    memcpy(memory.place, row->value + 6, sizeof memory.place);
    return memory;
}

/* Gives a pair what the rows of one of its ends remember of it. `near`: images are farther from each other. */
static void recall(struct rocks *rocks, struct rocks_pair *pair, const struct physics_context *context,
                   int side, double near) {
    const struct particles *p = context->particles;
    const uint32_t carrier = pair->end[side];
    int64_t partner = pair->wall >= 0 ? wall_row_partner(pair->wall, 0) : p->id[pair->end[!side]];
    double apart[3] = {0};
    if (pair->wall < 0)
        rocks_apart(pair, p, grains_list(context), apart);
    for (size_t r = rocks->rows.start[carrier]; r < rocks->rows.start[carrier + 1]; r++) {
        const struct history_row *row = &rocks->rows.row[r];
        double square = 0;
        for (int d = 0; d < 3 && pair->wall < 0; d++)
            square += (row->separation[d] - apart[d]) * (row->separation[d] - apart[d]);
        if (row->partner == partner && square < near * near && pair->points < TOUCH_POINTS_MAX)
            pair->point[pair->points++] = memory_of(row);
    }
}

void rocks_rebuilt(struct bodies *bodies, const struct physics_context *context) {
    struct rocks *rocks = bodies->rocks;
    const struct particles *p = context->particles;
    const struct pairlist *list = grains_list(context);
    double near = INFINITY;
    lists_free(rocks);
    rocks->pairs = 0;
    stands_make(bodies, p);
    pairs_take(rocks, p, list, context->scene->ghosts.newton && !context->ordered);
    walls_take(rocks, p, grains_walls(context));
    ends_make(rocks, p);
    for (int d = 0; d < 3; d++)
        if (context->box->periodic[d])
            near = fmin(near, 0.5 * context->box->edge[d]);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < rocks->pairs; k++)
        for (int side = 0; side < 2 && rocks->rows.start && rocks->pair[k].points == 0; side++)
            if (rocks->pair[k].end[side] < p->owned)
                recall(rocks, &rocks->pair[k], context, side, near);
}

/* Writes the points of the ends of particle i to `row`, or counts them where it is NULL. */
static size_t rows_of(const struct rocks *rocks, const struct physics_context *context, size_t i,
                      struct history_row *row) {
    const struct particles *p = context->particles;
    size_t count = 0;
    for (size_t e = rocks->first[i]; e < rocks->first[i + 1]; e++) {
        const struct rocks_end *end = &rocks->end[e];
        const struct rocks_pair *pair = &rocks->pair[end->pair];
        for (int k = 0; k < pair->points; k++, count++) {
            const struct touch_memory *memory = &pair->point[k];
            if (row == NULL)
                continue;
            struct history_row *to = &row[count];
            *to = (struct history_row){
                .id = p->id[i], .partner = pair->wall >= 0 ? wall_row_partner(pair->wall, 0) : end->partner};
            if (pair->wall < 0)
                rocks_apart(pair, p, grains_list(context), to->separation);
            memcpy(to->value, memory->spring, sizeof memory->spring);
            memcpy(to->value + 3, memory->roll, sizeof memory->roll);
            memcpy(to->value + 6, memory->place, sizeof memory->place);
            to->value[9] = memory->key;
        }
    }
    return count;
}

struct history_rows *rocks_rows(struct bodies *bodies, const struct physics_context *context) {
    struct rocks *rocks = bodies->rocks;
    struct history_rows *rows = &rocks->rows;
    const size_t owned = context->particles->owned;
    if (rocks->carried)
        return rows;
    history_rows_free(rows);
    rows->start = memory_allocate_zero(owned + 1, sizeof *rows->start, what);
    for (size_t i = 0; rocks->first && i < owned; i++)
        rows->start[i + 1] = rows->start[i] + rows_of(rocks, context, i, NULL);
    rows->count = rows->start[owned];
    rows->row = memory_allocate(rows->count, sizeof *rows->row, what);
    for (size_t i = 0; rocks->first && i < owned; i++)
        rows_of(rocks, context, i, rows->row + rows->start[i]);
    rocks->carried = true;
    return rows;
}
