/* SPDX-License-Identifier: BSD-3-Clause */
/* The interactions of a scene and the pair lists that they have of their own (interaction.h). */
#include "kernel/pairs/interaction.h"
#include "base/memory.h"
#include "base/scan.h"
#include "kernel/pairs/pairlist_build.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

int interactions_add(struct interactions *interactions, const struct interaction *row) {
    assert(interactions->count < INTERACTIONS_MAX);
    interactions->row[interactions->count] = *row;
    return interactions->count++;
}

static double range_of_all(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    const struct interactions *interactions = context;
    double most = -INFINITY;
    for (int k = 0; k < interactions->count; k++) {
        const struct interaction *row = &interactions->row[k];
        most = fmax(most, row->range(row->context, kind_a, radius_a, kind_b, radius_b));
    }
    return most;
}

struct classes_range interactions_range(const struct interactions *interactions) {
    return (struct classes_range){range_of_all, interactions, interactions->moving};
}

void interactions_create(struct interactions *interactions, const struct pairlist_options *options) {
    interactions->all = pairlist_create(options);
}

void interactions_free(struct interactions *interactions) {
    for (int k = 0; k < interactions->count; k++)
        if (interactions->own[k])
            pairlist_destroy(&interactions->own[k]);
    if (interactions->all)
        pairlist_destroy(&interactions->all);
}

struct pairlist *interaction_list(const struct interactions *interactions, int k) {
    return interactions->own[k] ? interactions->own[k] : interactions->all;
}

/* The margins of interaction k: its range and the skin of all. */
static void margins_set(struct interactions *interactions, int k, const struct size_classes *classes) {
    const struct interaction *row = &interactions->row[k];
    const struct classes_range range = {row->range, row->context, interactions->moving};
    for (int a = 0; a < classes->count; a++)
        for (int b = 0; b < classes->count; b++)
            interactions->margin[k][a][b] = classes_range_of(classes, &range, a, b) + classes->skin[a][b];
}

/* True if the interaction looks into clearly less space than all together in some class pair. */
static bool reaches_less(const struct interactions *interactions, int k, const struct size_classes *classes) {
    for (int a = 0; a < classes->count; a++)
        for (int b = 0; b < classes->count; b++) {
            double touch = classes->radius_min[a] + classes->radius_min[b];
            double own = fmax(touch + interactions->margin[k][a][b], 0);
            double all = touch + classes->margin[a][b];
            if (own * own * own < INTERACTION_SHARE * all * all * all)
                return true;
        }
    return false;
}

void interactions_divide(struct interactions *interactions, const struct size_classes *classes,
                         const struct pairlist_options *options) {
    for (int k = 0; interactions->count > 1 && k < interactions->count; k++) {
        margins_set(interactions, k, classes);
        if (interactions->own[k] == NULL && reaches_less(interactions, k, classes))
            interactions->own[k] = pairlist_create(options);
    }
}

void interactions_set_margins(struct interactions *interactions, const struct size_classes *classes) {
    for (int k = 0; interactions->count > 1 && k < interactions->count; k++)
        margins_set(interactions, k, classes);
}

/* Room for as many pairs and blocks as `from` has. */
static void list_reserve(struct pairlist *list, const struct pairlist *from) {
    struct pairlist_build *build = list->build;
    if (from->capacity > list->capacity) {
        list->capacity = from->capacity;
        list->i = memory_resize(list->i, list->capacity + INDEX_SINK_PAD, sizeof *list->i, "pair list");
        list->j = memory_resize(list->j, list->capacity + INDEX_SINK_PAD, sizeof *list->j, "pair list");
    }
    if (from->block_count > build->blocks_capacity) {
        build->blocks_capacity = from->block_count;
        list->blocks =
            memory_resize(list->blocks, (size_t)build->blocks_capacity, sizeof *list->blocks, "pair blocks");
    }
}

static bool near_enough(const struct pairlist *list, const struct index_view *view,
                        double (*margin)[CLASS_MAX], size_t k) {
    uint32_t i = list->i[k], j = pair_partner(list->j[k]);
    const double *xi = view->position + i * view->stride, *xj = view->position + j * view->stride;
    const double *shift = list->shift[pair_image(list->j[k])];
    double reach = view->radius[i * view->stride] + view->radius[j * view->stride] +
                   margin[view->size_class[i]][view->size_class[j]];
    double square = 0;
    for (int d = 0; d < 3; d++) {
        double apart = xj[d] - xi[d] + shift[d];
        square += apart * apart;
    }
    return reach > 0 && square <= reach * reach;
}

/* The pairs of [first, end) that are near enough, from `at` on; returns the end of the pairs written. */
static size_t part_select(struct pairlist *list, const struct pairlist *from, const struct index_view *view,
                          double (*margin)[CLASS_MAX], size_t first, size_t end, size_t at) {
    for (size_t k = first; k < end; k++)
        if (near_enough(from, view, margin, k)) {
            list->i[at] = from->i[k];
            list->j[at] = from->j[k];
            at++;
        }
    return at;
}

/* A thread's pairs begin where they do in the list of all, so that threads need not wait for each other. Mirrored
 * pairs and their originals have exactly opposite separations, so both or none are near enough. */
static size_t thread_select(struct pairlist *list, const struct pairlist *from, const struct index_view *view,
                            double (*margin)[CLASS_MAX], int t, size_t *primary) {
    size_t first = pairlist_thread_first(from, t), at = first;
    *primary = 0;
    for (int b = from->thread_block[t]; b < from->thread_block[t + 1]; b++) {
        const struct pair_block *block = &from->blocks[b];
        struct pair_block *own = &list->blocks[b];
        *own = *block;
        own->first_pair = at;
        own->one_sided = at = part_select(list, from, view, margin, block->first_pair, block->one_sided, at);
        own->slotted = at = part_select(list, from, view, margin, block->one_sided, block->slotted, at);
        own->end_pair = at = part_select(list, from, view, margin, block->slotted, block->end_pair, at);
        struct pair_visit pair = pairlist_block(b);
        while (own->kind != PAIR_BLOCK_MIRROR && pairlist_each(list, &pair))
            *primary += pair.i < view->owned;
    }
    return at - first;
}

static void list_select(struct pairlist *list, const struct pairlist *from, const struct index_view *view,
                        double (*margin)[CLASS_MAX]) {
    size_t pairs = 0, primary = 0;
    list_reserve(list, from);
    list->sides = 0;
    list->block_count = from->block_count;
    memcpy(list->thread_block, from->thread_block, ((size_t)from->threads + 1) * sizeof *from->thread_block);
    memcpy(list->shift, from->shift, sizeof list->shift);
    memcpy(list->drift, from->drift, sizeof list->drift);
    list->moves = from->moves;
    pairlist_reserve_slots(list, from->slot_count > 0 ? view->total : 0, from->slot_count);
    list->slot_count = from->slot_count;
    if (from->slot_count > 0) {
        memcpy(list->busy, from->busy, from->slot_count * sizeof *from->busy);
        memcpy(list->slot_of, from->slot_of, view->total * sizeof *from->slot_of);
    }
#pragma omp parallel for schedule(static, 1) reduction(+ : pairs, primary)
    for (int t = 0; t < list->threads; t++) {
        size_t own;
        pairs += thread_select(list, from, view, margin, t, &own);
        primary += own;
    }
    list->pair_count = pairs;
    list->primary_count = primary;
}

void interactions_select(struct interactions *interactions, const struct size_classes *classes,
                         const struct index_view *view) {
    for (int k = 0; k < interactions->count; k++) {
        if (interactions->own[k] == NULL)
            continue;
        margins_set(interactions, k, classes);
        list_select(interactions->own[k], interactions->all, view, interactions->margin[k]);
    }
}

void interactions_follow(struct interactions *interactions, const struct box *box) {
    pairlist_follow(interactions->all, box);
    for (int k = 0; k < interactions->count; k++)
        if (interactions->own[k])
            pairlist_follow(interactions->own[k], box);
}

void interactions_release(struct interactions *interactions) {
    pairlist_release(interactions->all);
    for (int k = 0; k < interactions->count; k++)
        if (interactions->own[k])
            pairlist_release(interactions->own[k]);
}

static int partner_compare(const void *a, const void *b) {
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    uint32_t i = pair_partner(x), j = pair_partner(y);
    return i != j ? (i > j) - (i < j) : (x > y) - (x < y);
}

/* Both sides of the pairs of one thread: rows of the thread's own particles at the places `next`, and those of busy
 * particles, which all threads add to, at the thread's own places `slot`. Without `partner` the places count. */
struct rows_visit {
    const struct pairlist *list;
    size_t owned, *next, *slot;
    uint32_t *partner;
};

static void row_add(const struct rows_visit *visit, size_t *next, uint32_t partner) {
    if (visit->partner != NULL)
        visit->partner[*next] = partner;
    ++*next;
}

/* Visits the pairs of a thread: the particle that gets the force of a pair in the thread's part of the list gets
 * the pair. */
static void rows_visit(const struct rows_visit *visit, int thread) {
    const struct pairlist *list = visit->list;
    struct pair_visit pair = pairlist_thread(list, thread);
    while (pairlist_each(list, &pair)) {
        uint32_t back = pair.i | image_opposite(pair.image) << PARTICLE_INDEX_BITS;
        row_add(visit, &visit->next[pair.i], list->j[pair.k]);
        if (pair.j >= visit->owned || pair_gives_one(&pair))
            continue;
        size_t *next = pair_gives_both(&pair) ? &visit->next[pair.j] : &visit->slot[list->slot_of[pair.j]];
        row_add(visit, next, back);
    }
}

/* Visits the pairs of all threads; `slot` has list->slot_count places a thread. */
static void rows_visit_all(struct rows_visit visit) {
    const struct pairlist *list = visit.list;
    size_t *slot = visit.slot;
#pragma omp parallel for schedule(static, 1) firstprivate(visit)
    for (int t = 0; t < list->threads; t++) {
        visit.slot = slot + (size_t)t * list->slot_count;
        rows_visit(&visit, t);
    }
}

/* The count of a busy particle over all threads. */
static size_t slot_sum(const struct pairlist *list, const size_t *slot, size_t s) {
    size_t sum = 0;
    for (int t = 0; t < list->threads; t++)
        sum += slot[(size_t)t * list->slot_count + s];
    return sum;
}

/* Counts (row i at start[i + 1], threads in `slot`) to places: row i begins at start[i + 1]; in the row of a busy
 * particle the places of the threads follow its own. Returns the number of places. */
static size_t rows_scan(struct pair_rows *rows, const struct pairlist *list, size_t *slot) {
    for (size_t s = 0; s < list->slot_count; s++)
        if (list->busy[s] < rows->rows)
            rows->start[list->busy[s] + 1] += slot_sum(list, slot, s);
    scan_sizes(rows->start + 1, rows->rows, rows->start + 1);
    for (size_t s = 0; s < list->slot_count; s++) {
        if (list->busy[s] >= rows->rows)
            continue;
        size_t at = rows->start[list->busy[s] + 2] - slot_sum(list, slot, s);
        for (int t = 0; t < list->threads; t++) {
            size_t *place = &slot[(size_t)t * list->slot_count + s], count = *place;
            *place = at;
            at += count;
        }
    }
    return rows->start[rows->rows + 1];
}

static void rows_reserve(struct pair_rows *rows, size_t owned) {
    if (owned + 2 > rows->row_capacity) {
        rows->row_capacity = owned + owned / 8 + 2;
        rows->start = memory_resize(rows->start, rows->row_capacity, sizeof *rows->start, "rows of pairs");
    }
    rows->rows = owned;
    memset(rows->start, 0, (owned + 2) * sizeof *rows->start);
}

void pair_rows_build(struct pair_rows *rows, const struct pairlist *list, size_t owned) {
    size_t slots = (size_t)list->threads * list->slot_count;
    size_t *slot = memory_allocate_zero(slots, sizeof *slot, "rows of pairs");
    rows_reserve(rows, owned);
    struct rows_visit visit = {.list = list, .owned = owned, .next = rows->start + 1, .slot = slot};
    rows_visit_all(visit);
    size_t pairs = rows_scan(rows, list, slot);
    if (pairs > rows->capacity) {
        rows->capacity = pairs + pairs / 8;
        rows->partner = memory_resize(rows->partner, rows->capacity, sizeof *rows->partner, "rows of pairs");
    }
    visit.partner = rows->partner;
    rows_visit_all(visit);
    /* each row now ends where the next one begins, but for the places of threads */
    for (size_t s = 0; s < list->slot_count; s++)
        if (list->busy[s] < owned)
            rows->start[list->busy[s] + 1] = slot[slots - list->slot_count + s];
    memory_free(slot);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < owned; i++)
        qsort(rows->partner + rows->start[i], rows->start[i + 1] - rows->start[i], sizeof *rows->partner,
              partner_compare);
}

void pair_rows_free(struct pair_rows *rows) {
    memory_free(rows->start);
    memory_free(rows->partner);
    *rows = (struct pair_rows){0};
}
