/* SPDX-License-Identifier: BSD-3-Clause */
/* Records of contacts, how they leave a list and enter the next. Read history.h first. */
#include "kernel/pairs/history.h"
#include "base/memory.h"
#include "base/scan.h"
#include <assert.h>
#include <math.h>
#include <string.h>

struct history *history_create(int components, int threads) {
    assert(components > 0 && components <= HISTORY_COMPONENTS_MAX);
    struct history *history = memory_allocate_zero(1, sizeof *history, "contact history");
    history->components = history->odd = components;
    history->threads = threads;
    for (int b = 0; b < 2; b++)
        history->part[b] = memory_allocate_zero((size_t)threads, sizeof *history->part[b], "contact history");
    return history;
}

void history_destroy(struct history **history) {
    if (*history == NULL)
        return;
    for (int b = 0; b < 2; b++) {
        for (int t = 0; t < (*history)->threads; t++) {
            memory_free((*history)->part[b][t].pair);
            memory_free((*history)->part[b][t].value);
        }
        memory_free((*history)->part[b]);
    }
    memory_free(*history);
    *history = NULL;
}

void history_part_reserve(struct history_part *part, int components, size_t contacts) {
    if (contacts + HISTORY_PAD <= part->capacity)
        return;
    part->capacity = contacts + contacts / 16 + 1024;
    part->pair = memory_resize(part->pair, part->capacity, sizeof *part->pair, "contact history");
    part->value = memory_resize(part->value, part->capacity, (size_t)components * sizeof *part->value,
                                "contact history");
}

void history_reserve(struct history *history, int thread, size_t contacts) {
    history_part_reserve(&history->part[1 - history->now][thread], history->components, contacts);
}

const struct history_part *history_part_of(const struct history *history, const struct pairlist *list,
                                           size_t first) {
    for (int t = 0; history && t < list->threads; t++) {
        int block = list->thread_block[t];
        if (block < list->thread_block[t + 1] && list->blocks[block].first_pair == first)
            return &history->part[history->now][t];
    }
    return NULL;
}

const double *history_record(const struct history *history, const struct history_part *part, uint32_t pair) {
    size_t at = part ? scan_first(part->pair, part->count, pair) : 0;
    bool found = part && at < part->count && part->pair[at] == pair;
    return found ? part->value + at * (size_t)history->components : NULL;
}

void history_flip(struct history *history) {
    history->now = 1 - history->now;
}

size_t history_memory(const struct history *history) {
    size_t bytes = 0;
    for (int b = 0; b < 2; b++)
        for (int t = 0; t < history->threads; t++)
            bytes += history->part[b][t].capacity *
                     (sizeof(uint32_t) + (size_t)history->components * sizeof(double));
    return bytes;
}

/* The vector from i to j through the pair's image; the mirrored pair has its negative to the last bit. */
static void pair_separation(const struct pairlist *list, const struct particles *particles, uint32_t i,
                            uint32_t j, double separation[3]) {
    const double *shift = list->shift[pair_image(j)];
    const double *xi = particles->state[i].x, *xj = particles->state[pair_partner(j)].x;
    for (int d = 0; d < 3; d++)
        separation[d] = (xj[d] - xi[d]) + shift[d];
}

/* One record of the list, on its way into rows. */
struct record {
    uint32_t i, j; /* j with image code */
    const double *value;
};

/* Walks the primary records of a thread (not the mirrored copies of others'). Returns false at the end. */
struct record_walk {
    const struct history_part *part;
    const struct pairlist *list;
    size_t first, at;
    size_t mirror_first, mirror_last; /* pairs to leave out */
    const uint32_t *place;            /* pairs to leave out: those of two particles that stay; NULL: none */
    size_t owned;
    int components, odd;
};

static struct record_walk record_walk_begin(const struct history *history, const struct pairlist *list,
                                            size_t owned, const uint32_t *place, int t) {
    const struct pair_block *mirror = &list->blocks[list->thread_block[t + 1] - 2];
    assert(mirror->kind == PAIR_BLOCK_MIRROR);
    return (struct record_walk){.part = &history->part[history->now][t],
                                .list = list,
                                .first = pairlist_thread_first(list, t),
                                .mirror_first = mirror->first_pair,
                                .mirror_last = mirror->end_pair,
                                .place = place,
                                .owned = owned,
                                .components = history->components,
                                .odd = history->odd};
}

static bool stays(const struct record_walk *walk, uint32_t k) {
    return walk->place[k] != PARTICLE_LEFT;
}

static bool both_stay(const struct record_walk *walk, uint32_t i, uint32_t j) {
    return walk->place && j < walk->owned && stays(walk, i) && stays(walk, j);
}

static bool record_walk_next(struct record_walk *walk, struct record *record) {
    for (; walk->at < walk->part->count; walk->at++) {
        size_t k = walk->first + walk->part->pair[walk->at];
        uint32_t i = walk->list->i[k];
        if ((k >= walk->mirror_first && k < walk->mirror_last) || i >= walk->owned ||
            both_stay(walk, i, pair_partner(walk->list->j[k])))
            continue;
        record->i = i;
        record->j = walk->list->j[k];
        record->value = walk->part->value + walk->at * (size_t)walk->components;
        walk->at++;
        return true;
    }
    return false;
}

/* A zero of a row has no sign, for both orders of the pair. */
static void row_fill(struct history_row *row, const struct record *record, bool ordered,
                     const struct record_walk *walk, const double separation[3]) {
    double sign = ordered ? 1 : -1;
    for (int c = 0; c < walk->components; c++)
        row->value[c] = (c < walk->odd ? sign : 1) * record->value[c] + 0.0;
    for (int d = 0; d < 3; d++)
        row->separation[d] = sign * separation[d] + 0.0;
}

/* Counts a cursor up; `shared` where other threads may count the same one. */
static size_t cursor_next(size_t *cursor, bool shared) {
    size_t at;
    if (!shared)
        return (*cursor)++;
#pragma omp atomic capture
    at = (*cursor)++;
    return at;
}

/* Adds a thread's records to the rows, at the places that `cursor` counts up; without rows only counts. With
 * both_ends particles of other threads' ranges are touched, hence the atomic increments; the order within a
 * particle's rows is of no consequence, because rows are looked up by id. */
static void records_scatter(struct record_walk walk, const struct particles *particles, bool both_ends,
                            size_t *cursor, struct history_row *rows) {
    struct record record;
    while (record_walk_next(&walk, &record)) {
        uint32_t end[2] = {record.i, pair_partner(record.j)};
        int64_t id[2] = {particles->id[end[0]], particles->id[end[1]]};
        double separation[3] = {0, 0, 0};
        if (rows)
            pair_separation(walk.list, particles, record.i, record.j, separation);
        for (int e = 0; e < (both_ends && end[1] < walk.owned ? 2 : 1); e++) {
            size_t at = cursor_next(&cursor[end[e]], both_ends);
            if (rows == NULL)
                continue;
            rows[at].id = id[e];
            rows[at].partner = id[1 - e];
            row_fill(&rows[at], &record, id[0] < id[1], &walk, separation);
        }
    }
}

void history_detach(const struct history *history, const struct pairlist *list,
                    const struct particles *particles, bool both_ends, struct history_rows *rows) {
    size_t owned = particles->owned;
    rows->components = history->components;
    rows->start = memory_allocate_zero(owned + 1, sizeof *rows->start, "history rows");
    if (list->block_count == 0) {
        rows->count = 0;
        rows->row = memory_allocate(0, sizeof *rows->row, "history rows");
        return;
    }
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < history->threads; t++)
        records_scatter(record_walk_begin(history, list, owned, NULL, t), particles, both_ends, rows->start,
                        NULL);
    rows->count = scan_sizes(rows->start, owned, rows->start);
    rows->row = memory_allocate(rows->count, sizeof *rows->row, "history rows");
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < history->threads; t++)
        records_scatter(record_walk_begin(history, list, owned, NULL, t), particles, both_ends, rows->start,
                        rows->row);
    /* Each start is now the start of the next particle */
    memmove(rows->start + 1, rows->start, owned * sizeof *rows->start);
    rows->start[0] = 0;
}

/* Adds a thread's loose rows to loose[0] (of particles that stay) and loose[1] (of those that leave), from
 * at[0] and at[1] on; without room only counts. */
static void records_loosen(struct record_walk walk, const struct particles *particles,
                           struct history_loose *const loose[2], size_t at[2]) {
    static const double nowhere[3];
    struct record record;
    while (record_walk_next(&walk, &record)) {
        uint32_t end[2] = {record.i, pair_partner(record.j)};
        for (int e = 0; e < (end[1] < walk.owned ? 2 : 1); e++) {
            bool leaves = !stays(&walk, end[e]);
            size_t r = at[leaves]++;
            if (loose == NULL)
                continue;
            int64_t id = particles->id[end[e]], partner = particles->id[end[1 - e]];
            loose[leaves]->carrier[r] = leaves ? end[e] : walk.place[end[e]];
            loose[leaves]->row[r] = (struct history_row){.id = id, .partner = partner};
            row_fill(&loose[leaves]->row[r], &record, particles->id[end[0]] < particles->id[end[1]], &walk,
                     nowhere);
        }
    }
}

static void loose_reserve(struct history_loose *loose, size_t count) {
    loose->count = count;
    loose->carrier = memory_allocate(count, sizeof *loose->carrier, "history rows");
    loose->row = memory_allocate(count, sizeof *loose->row, "history rows");
}

void history_loosen(const struct history *history, const struct pairlist *list,
                    const struct particles *particles, const uint32_t *place, struct history_loose *stay,
                    struct history_loose *leave) {
    struct history_loose *const loose[2] = {stay, leave};
    size_t owned = particles->owned, count[2] = {0, 0};
    int threads = list->block_count == 0 ? 0 : history->threads;
    size_t(*at)[2] = memory_allocate_zero((size_t)threads + 1, sizeof *at, "history rows");
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < threads; t++)
        records_loosen(record_walk_begin(history, list, owned, place, t), particles, NULL, at[t]);
    for (int t = 0; t < threads; t++)
        for (int k = 0; k < 2; k++) {
            size_t own = at[t][k];
            at[t][k] = count[k];
            count[k] += own;
        }
    for (int k = 0; k < 2; k++)
        loose_reserve(loose[k], count[k]);
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < threads; t++)
        records_loosen(record_walk_begin(history, list, owned, place, t), particles, loose, at[t]);
    memory_free(at);
}

void history_loose_join(struct history_loose *loose, struct history_loose *more) {
    size_t count = loose->count + more->count;
    loose->carrier = memory_resize(loose->carrier, count, sizeof *loose->carrier, "history rows");
    loose->row = memory_resize(loose->row, count, sizeof *loose->row, "history rows");
    if (more->count > 0) {
        memcpy(loose->carrier + loose->count, more->carrier, more->count * sizeof *more->carrier);
        memcpy(loose->row + loose->count, more->row, more->count * sizeof *more->row);
    }
    loose->count = count;
    history_loose_free(more);
}

void history_loose_free(struct history_loose *loose) {
    memory_free(loose->carrier);
    memory_free(loose->row);
    *loose = (struct history_loose){0};
}

/* Data of an attach. */
struct attach {
    const struct history_rows *rows;
    const struct pairlist *list;
    const struct particles *particles;
    double near; /* separations that differ by less belong to the same image; squared length */
};

/* The row of particle `carrier` whose partner has id `partner`, or NULL. If there are several images, the row
 * of this separation. */
static const struct history_row *row_find(const struct attach *a, uint32_t carrier, int64_t partner,
                                          uint32_t i, uint32_t j) {
    for (size_t k = a->rows->start[carrier]; k < a->rows->start[carrier + 1]; k++) {
        const struct history_row *row = &a->rows->row[k];
        if (row->partner != partner)
            continue;
        if (isinf(a->near))
            return row;
        double separation[3], d2 = 0;
        pair_separation(a->list, a->particles, i, j, separation);
        double sign = a->particles->id[i] < a->particles->id[pair_partner(j)] ? 1 : -1;
        for (int d = 0; d < 3; d++) {
            double apart = sign * separation[d] - row->separation[d];
            d2 += apart * apart;
        }
        if (d2 < a->near)
            return row;
    }
    return NULL;
}

static const struct history_row *pair_find(const struct attach *a, size_t k) {
    uint32_t i = a->list->i[k], j = a->list->j[k], partner = pair_partner(j);
    const size_t *start = a->rows->start;
    size_t owned = a->particles->owned;
    const struct history_row *row = NULL;
    if (i < owned && start[i] != start[i + 1])
        row = row_find(a, i, a->particles->id[partner], i, j);
    if (row == NULL && partner < owned && start[partner] != start[partner + 1])
        row = row_find(a, partner, a->particles->id[i], i, j);
    return row;
}

static void attach_thread(struct history *history, const struct attach *a, int t) {
    const struct pairlist *list = a->list;
    struct history_part *part = &history->part[history->now][t];
    size_t first = pairlist_thread_first(list, t);
    size_t components = (size_t)history->components;
    part->count = 0;
    struct pair_visit pair = pairlist_thread(list, t);
    while (pairlist_each(list, &pair)) {
        const struct history_row *row = pair_find(a, pair.k);
        if (row == NULL)
            continue;
        history_part_reserve(part, history->components, part->count + 1);
        double sign = a->particles->id[pair.i] < a->particles->id[pair.j] ? 1 : -1;
        assert(pair.k - first <= UINT32_MAX);
        part->pair[part->count] = (uint32_t)(pair.k - first);
        for (size_t c = 0; c < components; c++)
            part->value[part->count * components + c] = (c < (size_t)history->odd ? sign : 1) * row->value[c];
        part->count++;
    }
}

void history_attach(struct history *history, const struct history_rows *rows, const struct pairlist *list,
                    const struct particles *particles, double apart) {
    struct attach attach = {rows, list, particles, 0.25 * apart * apart};
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < history->threads; t++)
        attach_thread(history, &attach, t);
}
