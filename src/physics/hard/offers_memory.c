/* SPDX-License-Identifier: BSD-3-Clause */
/* What points of rocks remember: over rebuilds as rows of particles, and from step to step. Read offers.h first. */
#include "base/memory.h"
#include "engine/physics.h"
#include "physics/bodies/rocks_state.h"
#include "physics/hard/problem.h"
#include "physics/hard/offers.h"
#include <assert.h>
#include <math.h>

static const char what[] = "contacts of rocks";

/* Place and feature stand behind the numbers of a contact of spheres. */
static size_t place_at(const struct hard_pairs *pairs) {
    return (size_t)pairs->history->components;
}

/* The vector from the end with the lower id of pair m to the other one; true if that is the order of the row. */
static bool separation_of(const struct hard_pairs *pairs, const struct physics_context *context, size_t m,
                          double separation[3]) {
    const struct particles *p = context->particles;
    const uint32_t *end = pairs->end[m];
    const double *shift = context->list[0]->shift[pairs->image[m]];
    bool ordered = p->id[end[0]] < p->id[end[1]];
    for (int d = 0; d < 3; d++) {
        double apart = (p->state[end[1]].x[d] - p->state[end[0]].x[d]) + shift[d];
        separation[d] = ordered ? apart : -apart;
    }
    return ordered;
}

/* Turns the vectors of a row, which are those of the order of ids, into the order of the pair, or back. */
static void vectors_turn(struct hard_memory *memory, struct hard_couple *couple) {
    for (int d = 0; d < 3; d++) {
        memory->rub[d] = -memory->rub[d];
        couple->roll[d] = -couple->roll[d];
    }
}

static void past_add(struct hard_rocks *rocks, const struct hard_past *past) {
    rocks->past = hard_problem_grow(rocks->past, &rocks->past_room, rocks->pasts + 1, sizeof *rocks->past);
    rocks->past[rocks->pasts++] = *past;
}

void hard_rocks_forget(struct hard_rocks *rocks) {
    rocks->pasts = 0;
}

void hard_rocks_remember(struct hard_rocks *rocks, const struct hard_past *past) {
    if (past->memory.push > 0.0)
        past_add(rocks, past);
}

/* Images of a particle are farther from each other than twice this. */
static double near_of(const struct box *box) {
    double near = INFINITY;
    for (int d = 0; d < 3; d++)
        if (box->periodic[d])
            near = fmin(near, 0.5 * box->edge[d]);
    return near;
}

/* Takes what the rows of one end of a pair remember of it; returns whether there was any. */
static bool rows_take(struct hard_rocks *rocks, const struct hard_pairs *pairs, size_t n, int side,
                      double near) {
    const struct particles *p = rocks->context->particles;
    const uint32_t m = rocks->pair[n].pair, carrier = pairs->end[m][side];
    const size_t at = place_at(pairs), before = rocks->pasts;
    double separation[3], off[3];
    bool ordered = separation_of(pairs, rocks->context, m, separation);
    for (size_t r = pairs->rows.start[carrier]; r < pairs->rows.start[carrier + 1]; r++) {
        const struct history_row *row = &pairs->rows.row[r];
        struct hard_past past = {.pair = m, .key = (uint32_t)row->value[at + 3]};
        vector_minus(row->separation, separation, off);
        if (row->partner != p->id[pairs->end[m][!side]] || !(vector_dot(off, off) < near * near))
            continue;
        hard_memory_get(pairs, row->value, &past.memory, &past.couple);
        memcpy(past.place, row->value + at, sizeof past.place);
        if (!ordered)
            vectors_turn(&past.memory, &past.couple);
        hard_rocks_remember(rocks, &past);
    }
    return rocks->pasts > before;
}

/* The number of each pair of rocks by its number in the list; UINT32_MAX: it is none. */
static uint32_t *numbers_of(const struct rocks *all, const struct pairlist *list) {
    uint32_t *number = memory_allocate(list->capacity, sizeof *number, what);
    memset(number, 0xff, list->capacity * sizeof *number);
    for (size_t k = 0; k < all->pairs; k++)
        if (all->pair[k].wall < 0)
            number[all->pair[k].number] = (uint32_t)k;
    return number;
}

/* Lists the pairs that this rank solves, and rocks with walls behind them. */
static void lists_make(struct hard_rocks *rocks, const struct hard_pairs *pairs) {
    const struct rocks *all = rocks->rocks;
    uint32_t *number = numbers_of(all, rocks->context->list[0]);
    memory_free(rocks->pair);
    memory_free(rocks->of);
    memory_free(rocks->first);
    rocks->pair = memory_allocate(all->pairs, sizeof *rocks->pair, what);
    rocks->of = memory_allocate(pairs->colours.pairs, sizeof *rocks->of, what);
    rocks->pairs = rocks->walls = 0;
    for (size_t m = 0; m < pairs->colours.pairs; m++) {
        uint32_t rock = number[pairs->number[m]];
        rocks->of[m] = rock == UINT32_MAX ? -1 : (int32_t)rocks->pairs;
        if (rock != UINT32_MAX)
            rocks->pair[rocks->pairs++] = (struct hard_rocks_pair){(uint32_t)m, rock};
    }
    for (size_t k = 0; k < all->pairs; k++)
        if (all->pair[k].wall >= 0)
            rocks->pair[rocks->pairs + rocks->walls++] = (struct hard_rocks_pair){UINT32_MAX, (uint32_t)k};
    rocks->first = memory_allocate_zero(rocks->pairs + 1, sizeof *rocks->first, what);
    memory_free(number);
}

void hard_rocks_link(struct hard_rocks *rocks, struct hard_pairs *pairs) {
    const double near = near_of(rocks->context->box);
    if (rocks->rocks == NULL)
        return;
    rocks->pasts = rocks->offers = 0;
    lists_make(rocks, pairs);
    for (size_t n = 0; n < rocks->pairs; n++) {
        const uint32_t m = rocks->pair[n].pair;
        bool found = false;
        pairs->memory[m] = (struct hard_memory){0}; /* of the row of spheres that this pair is not */
        for (int side = 0; side < 2 && pairs->rows.start && !found; side++)
            if (pairs->end[m][side] < rocks->context->particles->owned)
                found = rows_take(rocks, pairs, n, side, near);
    }
}

/* The row of a point at its end `side`. */
static struct history_row row_of(const struct hard_rocks *rocks, const struct hard_pairs *pairs,
                                 const struct hard_past *past, int side) {
    const int64_t *id = rocks->context->particles->id;
    const uint32_t *end = pairs->end[past->pair];
    const size_t at = place_at(pairs);
    struct hard_past turned = *past;
    struct history_row row = {.id = id[end[side]], .partner = id[end[!side]]};
    assert(at + HARD_ROCK_ROW <= HISTORY_COMPONENTS_MAX);
    if (!separation_of(pairs, rocks->context, past->pair, row.separation))
        vectors_turn(&turned.memory, &turned.couple);
    hard_memory_put(pairs, &turned.memory, &turned.couple, row.value);
    memcpy(row.value + at, past->place, sizeof past->place);
    row.value[at + 3] = past->key;
    return row;
}

void hard_rocks_detach(const struct hard_rocks *rocks, const struct hard_pairs *pairs,
                       struct history_rows *rows) {
    const size_t owned = rocks->context->particles->owned;
    *rows = (struct history_rows){0};
    rows->start = memory_allocate_zero(owned + 2, sizeof *rows->start, what);
    for (size_t k = 0; k < rocks->pasts; k++)
        for (int side = 0; side < 2; side++)
            if (pairs->end[rocks->past[k].pair][side] < owned)
                rows->start[pairs->end[rocks->past[k].pair][side] + 2]++;
    for (size_t i = 0; i < owned; i++)
        rows->start[i + 2] += rows->start[i + 1];
    rows->count = rows->start[owned + 1];
    rows->row = memory_allocate(rows->count, sizeof *rows->row, what);
    for (size_t k = 0; k < rocks->pasts; k++)
        for (int side = 0; side < 2; side++) {
            uint32_t i = pairs->end[rocks->past[k].pair][side];
            if (i < owned)
                rows->row[rows->start[i + 1]++] = row_of(rocks, pairs, &rocks->past[k], side);
        }
}
