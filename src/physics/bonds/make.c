/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the bonds, once a run: between near particles, or from a list of ids. Read bonds.h first. */
#include "physics/bonds/bonds_state.h"
#include "kernel/comm/comm.h"
#include "kernel/particles/kinds.h"
#include "physics/grains/motion/carried.h"
#include "kernel/particles/material.h"
#include "base/memory.h"
#include "base/lines.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Rows on the way, in any order. */
struct heap {
    size_t count, capacity;
    struct history_row *row;
};

static void heap_add(struct heap *heap, const struct history_row *row) {
    if (heap->count == heap->capacity) {
        heap->capacity = 2 * heap->capacity + 256;
        heap->row = memory_resize(heap->row, heap->capacity, sizeof *heap->row, "new bonds");
    }
    heap->row[heap->count++] = *row;
}

/* The row at particle `id` of the bond with `partner`; the separation goes from `id` to `partner`. */
static struct history_row row_of(int64_t id, int64_t partner, const double separation[3], int entry) {
    struct history_row row = {.id = id, .partner = partner};
    double square = 0.0;
    for (int d = 0; d < 3; d++) {
        row.separation[d] = (id < partner ? separation[d] : -separation[d]) + 0.0;
        square += separation[d] * separation[d];
    }
    row.value[BOND_REST] = sqrt(square);
    row.value[BOND_ENTRY] = entry;
    return row;
}

/* A pair of the list that is near enough, and does not move as one by order, gets a row at each end that this
 * rank owns; the row of a copy goes to `away`. */
static void pair_join(const struct bonds *bonds, const struct pairlist *list, const struct pair_visit *pair,
                      struct heap *here, struct heap *away) {
    const struct particles *p = bonds->context->particles;
    uint32_t i = pair->i, j = pair->j;
    const struct particle_state *a = &p->state[i], *b = &p->state[j];
    const double *shift = list->shift[pair->image];
    double apart[3], square = 0.0, reach = a->radius + b->radius + bonds->options->gap;
    for (int d = 0; d < 3; d++) {
        apart[d] = (b->x[d] - a->x[d]) + shift[d];
        square += apart[d] * apart[d];
    }
    const uint8_t *material = material_numbers(p), *group = bonds_groups(p);
    bool fixed = a->inverse_mass + b->inverse_mass == 0.0 && group[i] == group[j];
    if (!(square <= reach * reach) || p->id[i] == p->id[j] || fixed)
        return;
    int entry = bonds_entry_of(bonds->options, (int[2]){material_of(material, i), material_of(material, j)},
                               (int[2]){group[i], group[j]});
    if (entry < 0)
        return;
    struct history_row row = row_of(p->id[i], p->id[j], apart, entry), other = row;
    other.id = row.partner;
    other.partner = row.id;
    heap_add(i < p->owned ? here : away, &row);
    heap_add(j < p->owned ? here : away, &other);
}

static void pairs_join(const struct bonds *bonds, struct heap *here, struct heap *away) {
    const struct pairlist *list = bonds->context->list[0];
    struct pair_visit pair = pairlist_all(list);
    while (pairlist_each(list, &pair))
        if (pair.block->kind != PAIR_BLOCK_MIRROR)
            pair_join(bonds, list, &pair, here, away);
}

static int row_order(const void *a, const void *b) {
    const struct history_row *x = a, *y = b;
    if (x->id != y->id)
        return x->id < y->id ? -1 : 1;
    if (x->partner != y->partner)
        return x->partner < y->partner ? -1 : 1;
    for (int d = 0; d < 3; d++)
        if (x->separation[d] != y->separation[d])
            return x->separation[d] < y->separation[d] ? -1 : 1;
    return 0;
}

/* All ranks get the rows of copies, and take those of their particles. Once a run. */
static void away_share(const struct comm *comm, struct heap *away) {
    void *all = NULL;
    size_t bytes = comm_gather_varying(comm, away->row, away->count * sizeof *away->row, &all, NULL);
    int64_t total = (int64_t)bytes;
    comm_max_int(comm, &total, 1);
    size_t count = (size_t)total / sizeof *away->row;
    memory_free(away->row);
    away->row = memory_allocate(count, sizeof *away->row, "new bonds");
    away->count = away->capacity = count;
    if (comm->rank == 0)
        memcpy(away->row, all, (size_t)total);
    memory_free(all);
    comm_broadcast(comm, away->row, (size_t)total);
}

/* The first row of an id at or behind `from` in sorted rows. */
static size_t rows_from(const struct heap *heap, int64_t id) {
    size_t low = 0, high = heap->count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (heap->row[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Deals the rows out to the owned particles, each once, in the order of partners. */
static void rows_lay(struct bonds *bonds, const struct heap *heap) {
    const struct particles *p = bonds->context->particles;
    struct history_rows *rows = &bonds->rows;
    rows->row = memory_resize(rows->row, heap->count, sizeof *rows->row, "bonds");
    rows->count = 0;
    for (size_t i = 0; i < p->owned; i++) {
        rows->start[i] = rows->count;
        for (size_t k = rows_from(heap, p->id[i]); k < heap->count && heap->row[k].id == p->id[i]; k++)
            if (rows->count == rows->start[i] || row_order(&rows->row[rows->count - 1], &heap->row[k]) != 0)
                rows->row[rows->count++] = heap->row[k];
    }
    rows->start[p->owned] = rows->count;
}

/* The pairs of ids of a list. */
struct id_list {
    size_t count, capacity;
    int64_t (*pair)[2];
};

static bool list_read(const char *path, struct id_list *list, struct error *error) {
    struct lines lines;
    bool good = lines_open(&lines, path, error);
    if (!good)
        return false;
    while (good && lines_next_filled(&lines)) {
        char *word[2];
        int64_t id[2];
        good = (lines_words(&lines, word, 2) == 2 && lines_integer(word[0], &id[0]) &&
                lines_integer(word[1], &id[1])) ||
               lines_refuse(&lines, error, "two ids of particles are needed");
        if (good && id[0] == id[1])
            good = lines_refuse(&lines, error, "a particle has no bond with itself");
        if (!good)
            break;
        if (list->count == list->capacity) {
            list->capacity = 2 * list->capacity + 256;
            list->pair = memory_resize(list->pair, list->capacity, sizeof *list->pair, "list of bonds");
        }
        memcpy(list->pair[list->count++], id, sizeof id);
    }
    if (good && lines.damaged)
        good = lines_refuse(&lines, error, "the file cannot be read to its end");
    lines_close(&lines);
    return good;
}

bool bonds_list_good(const char *path, struct error *error) {
    struct id_list list = {0};
    bool good = list_read(path, &list, error);
    memory_free(list.pair);
    return good;
}

/* A particle of the list, known to all ranks. */
enum { END_COUNT, END_X, END_MATERIAL = 4, END_GROUP, END_BODY, END_KIND, END_NUMBERS };

/* Finds the particles of the list on all ranks. */
static double (*ends_find(const struct bonds *bonds, const struct id_list *list))[END_NUMBERS] {
    const struct particles *p = bonds->context->particles;
    double(*end)[END_NUMBERS] = memory_allocate_zero(2 * list->count, sizeof *end, "list of bonds");
    struct heap mine = {0};
    for (size_t i = 0; i < p->owned; i++)
        heap_add(&mine, &(struct history_row){.id = p->id[i], .partner = (int64_t)i});
    if (mine.count > 0)
        qsort(mine.row, mine.count, sizeof *mine.row, row_order);
    for (size_t k = 0; k < 2 * list->count; k++) {
        int64_t id = list->pair[k / 2][k % 2];
        size_t at = rows_from(&mine, id);
        if (at == mine.count || mine.row[at].id != id)
            continue;
        size_t i = (size_t)mine.row[at].partner;
        end[k][END_COUNT] = 1.0;
        end[k][END_MATERIAL] = material_of(material_numbers(p), i);
        end[k][END_GROUP] = bonds_groups(p)[i];
        end[k][END_BODY] = carried_by(p) ? (double)carried_by(p)[i] : -1.0;
        end[k][END_KIND] = kinds_of(p) ? kinds_of(p)[i] : KIND_GRAIN;
        memcpy(&end[k][END_X], p->state[i].x, 3 * sizeof *end[k]);
    }
    memory_free(mine.row);
    comm_sum(bonds->context->comm, end[0], (int)(2 * list->count * END_NUMBERS));
    return end;
}

/* The vector between two ends over the nearest image. */
static void nearest(const struct box *box, const double a[3], const double b[3], double apart[3]) {
    for (int d = 0; d < 3; d++) {
        apart[d] = b[d] - a[d];
        if (box->periodic[d])
            apart[d] -= box->edge[d] * round(apart[d] / box->edge[d]);
    }
}

/* A pair of the list becomes a bond. */
static bool ends_join(const struct bonds *bonds, const int64_t id[2], double (*end)[END_NUMBERS],
                      struct heap *here, struct error *error) {
    double apart[3];
    for (int e = 0; e < 2; e++) {
        if (end[e][END_COUNT] == 0.0)
            return error_set(error, ERROR_USER, "%s: there is no particle %lld", bonds->options->list,
                             (long long)id[e]);
        if (end[e][END_KIND] != KIND_GRAIN)
            return error_set(error, ERROR_USER,
                             "%s: particle %lld is no grain; allowed are grains, those of rigid bodies too",
                             bonds->options->list, (long long)id[e]);
    }
    if (end[0][END_BODY] >= 0.0 && end[0][END_BODY] == end[1][END_BODY])
        return error_set(error, ERROR_USER, "%s: the particles %lld and %lld are of one rigid body",
                         bonds->options->list, (long long)id[0], (long long)id[1]);
    int entry = bonds_entry_of(bonds->options, (int[2]){(int)end[0][END_MATERIAL], (int)end[1][END_MATERIAL]},
                               (int[2]){(int)end[0][END_GROUP], (int)end[1][END_GROUP]});
    if (entry < 0)
        return error_set(error, ERROR_USER, "%s: no entry of bonds.laws serves the particles %lld and %lld",
                         bonds->options->list, (long long)id[0], (long long)id[1]);
    nearest(bonds->context->box, &end[0][END_X], &end[1][END_X], apart);
    struct history_row row = row_of(id[0], id[1], apart, entry), other = row;
    other.id = row.partner;
    other.partner = row.id;
    heap_add(here, &row);
    heap_add(here, &other);
    return true;
}

static void list_join(struct bonds *bonds, struct heap *here) {
    struct id_list list = {0};
    if (!list_read(bonds->options->list, &list, &bonds->error))
        return;
    double(*end)[END_NUMBERS] = ends_find(bonds, &list);
    for (size_t k = 0; k < list.count && bonds->error.kind == ERROR_NONE; k++)
        ends_join(bonds, list.pair[k], end + 2 * k, here, &bonds->error);
    memory_free(end);
    memory_free(list.pair);
}

void bonds_make(struct bonds *bonds) {
    struct heap here = {0}, away = {0};
    if (bonds->options->list[0]) {
        list_join(bonds, &here);
    } else {
        pairs_join(bonds, &here, &away);
        away_share(bonds->context->comm, &away);
        for (size_t k = 0; k < away.count; k++)
            heap_add(&here, &away.row[k]);
    }
    if (here.count > 0)
        qsort(here.row, here.count, sizeof *here.row, row_order);
    rows_lay(bonds, &here);
    memory_free(here.row);
    memory_free(away.row);
}
