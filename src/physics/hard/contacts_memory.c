/* SPDX-License-Identifier: BSD-3-Clause */
/* What contacts remember: from the solved rows, and over rebuilds. Read contacts.h first. */
#include "physics/hard/contacts.h"
#include "base/memory.h"
#include <stdlib.h>

static const char what[] = "contacts of a step";

/* An impact is over in a step: the next one begins without it, as without the friction of a cohesion that has been torn. */
static bool is_over(const struct hard_row *row) {
    return row->impact || !(row->p > 0.0);
}

static struct hard_memory memory_of(const struct hard_row *row, const struct hard_pace *pace) {
    struct hard_memory memory = {0};
    if (is_over(row))
        return memory;
    memory.push = row->p / pace->duration;
    for (int d = 0; d < 3; d++)
        memory.rub[d] = row->q[d] / pace->duration;
    return memory;
}

static struct hard_couple couple_of(const struct hard_row *row, const struct hard_pace *pace) {
    struct hard_couple couple = {0};
    if (is_over(row) || row->resist == NULL)
        return couple;
    couple.twist = row->resist->now.twist / pace->duration;
    for (int d = 0; d < 3; d++)
        couple.roll[d] = row->resist->now.roll[d] / pace->duration;
    return couple;
}

static int by_particle(const void *a, const void *b) {
    const struct hard_wall_memory *x = a, *y = b;
    if (x->particle != y->particle)
        return x->particle < y->particle ? -1 : 1;
    if (x->wall != y->wall)
        return x->wall < y->wall ? -1 : 1;
    return x->feature < y->feature ? -1 : x->feature > y->feature;
}

/* Points of rocks remember, in the order of their pairs. */
static void points_remember(const struct hard_contacts *contacts, const struct hard_problem *problem,
                            struct hard_rocks *rocks, const struct hard_pace *pace) {
    hard_rocks_forget(rocks);
    for (size_t r = 0; rocks->rocks && r < contacts->pair_rows; r++) {
        const struct hard_row *row = &problem->row[r];
        if (hard_rocks_of(rocks, contacts->pair[r]) < 0)
            continue;
        const struct hard_offer *offer = &rocks->offer[contacts->spot[r]];
        struct hard_past past = {.pair = contacts->pair[r],
                                 .key = offer->key,
                                 .memory = memory_of(row, pace),
                                 .couple = couple_of(row, pace)};
        memcpy(past.place, offer->place, sizeof past.place);
        hard_rocks_remember(rocks, &past);
    }
}

void hard_contacts_remember(struct hard_contacts *contacts, const struct hard_problem *problem,
                            struct hard_pairs *pairs, struct hard_rocks *rocks,
                            const struct hard_pace *pace) {
    points_remember(contacts, problem, rocks, pace);
#pragma omp parallel for schedule(static)
    for (size_t r = 0; r < contacts->pair_rows; r++) {
        if (hard_rocks_of(rocks, contacts->pair[r]) >= 0)
            continue;
        pairs->memory[contacts->pair[r]] = memory_of(&problem->row[r], pace);
        if (pairs->couple)
            pairs->couple[contacts->pair[r]] = couple_of(&problem->row[r], pace);
    }
    contacts->past =
        hard_problem_grow(contacts->past, &contacts->past_room, contacts->walls, sizeof *contacts->past);
    for (size_t k = 0; k < contacts->walls; k++) {
        const struct wall_place *place = &contacts->wall[k].place;
        const struct hard_row *row = &problem->row[contacts->pair_rows + k];
        struct hard_memory memory = memory_of(row, pace);
        if (memory.push > 0.0)
            contacts->past[contacts->pasts++] = (struct hard_wall_memory){
                (uint32_t)place->particle, place->wall, place->feature, memory, couple_of(row, pace)};
    }
    for (size_t k = 1; k < contacts->pasts; k++)
        if (contacts->past[k].particle < contacts->past[k - 1].particle) { /* bodies had another order */
            qsort(contacts->past, contacts->pasts, sizeof *contacts->past, by_particle);
            break;
        }
}

void hard_contacts_rename(const struct hard_pairs *pairs, struct history_rows *rows, const int *now,
                          int walls, size_t owned) {
    for (size_t r = 0; rows->start && r < rows->start[owned]; r++) {
        struct history_row *row = &rows->row[r];
        if (row->partner >= 0)
            continue;
        int wall = wall_row_wall(row) < walls ? now[wall_row_wall(row)] : -1;
        if (wall >= 0)
            row->partner = wall_row_partner(wall, wall_row_feature(row));
        else
            row->value[pairs->history->odd] = 0.0;
    }
}

void hard_contacts_detach(const struct hard_contacts *contacts, struct hard_pairs *pairs,
                          const struct hard_rocks *rocks, const struct pairlist *list,
                          const struct particles *particles) {
    struct history_rows *rows = &pairs->rows, all = {0}, points = {0};
    if (rows->start)
        return;
    hard_pairs_detach(pairs, list, particles);
    if (rocks->rocks)
        hard_rocks_detach(rocks, pairs, &points);
    all.start = memory_allocate(particles->owned + 1, sizeof *all.start, what);
    all.row = memory_allocate(rows->count + contacts->pasts + points.count, sizeof *all.row, what);
    for (size_t k = 0, p = 0; k < particles->owned; k++) {
        all.start[k] = all.count;
        for (size_t r = rows->start[k]; r < rows->start[k + 1]; r++, all.count++) {
            all.row[all.count] = rows->row[r];
            for (int c = pairs->history->components; c < HISTORY_COMPONENTS_MAX; c++)
                all.row[all.count].value[c] = 0.0;
        }
        for (size_t r = rocks->rocks ? points.start[k] : 0; rocks->rocks && r < points.start[k + 1]; r++)
            all.row[all.count++] = points.row[r];
        for (; p < contacts->pasts && contacts->past[p].particle == k; p++) {
            const struct hard_wall_memory *past = &contacts->past[p];
            struct history_row *row = &all.row[all.count++];
            *row = (struct history_row){.id = particles->id[k],
                                        .partner = wall_row_partner(past->wall, past->feature)};
            hard_memory_put(pairs, &past->memory, &past->couple, row->value);
        }
    }
    all.start[particles->owned] = all.count;
    history_rows_free(&points);
    history_rows_free(rows);
    *rows = all;
}

void hard_contacts_attach(struct hard_contacts *contacts, const struct hard_pairs *pairs,
                          const struct particles *particles) {
    const struct history_rows *rows = &pairs->rows;
    contacts->pasts = contacts->walls = 0;
    for (size_t k = 0; rows->start && k < particles->owned; k++)
        for (size_t r = rows->start[k]; r < rows->start[k + 1]; r++) {
            const struct history_row *row = &rows->row[r];
            struct hard_wall_memory past = {.particle = (uint32_t)k};
            hard_memory_get(pairs, row->value, &past.memory, &past.couple);
            if (row->partner >= 0 || !(past.memory.push > 0.0)) /* of a pair, or of a wall that is gone */
                continue;
            contacts->past = hard_problem_grow(contacts->past, &contacts->past_room, contacts->pasts + 1,
                                               sizeof *contacts->past);
            past.wall = wall_row_wall(row);
            past.feature = wall_row_feature(row);
            contacts->past[contacts->pasts++] = past;
        }
}
