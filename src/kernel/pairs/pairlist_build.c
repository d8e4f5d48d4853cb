/* SPDX-License-Identifier: BSD-3-Clause */
/* The build of a pair list; pairlist.h describes the layout, and pairlist_blocks.c cuts the rows into blocks. The order of events
 * in one pass:
 *
 *   1. every thread visits its row blocks and sorts the pairs found: into the segments of the block, into
 *      `mirror` (second copies for other threads), into `ghost`;
 *      each ghost is given to the first thread, in thread order, that meets it;
 *   2. every thread sorts its `mirror` and `ghost` by the threads that take the second copies;
 *   3. every thread appends its mirror block, picking its shares of all threads' `mirror` in thread order,
 *      and its ghost block.
 *
 * A pass whose region overflowed has counted the room that it needs; the layout is made from the counts
 * and the pass is repeated. The pass is repeated too if the set of busy classes turns out otherwise than
 * assumed. */
#include "kernel/pairs/pairlist_build.h"
#include "base/memory.h"
#include "index/grids/members.h"
#include <assert.h>
#include <string.h>

enum { SINK_FIRST = 1 << 14, REGION_SPARE = 1024 };

static void buffer_put(struct pair_buffer *buffer, uint32_t i, uint32_t j) {
    if (buffer->count == buffer->capacity) {
        buffer->capacity = buffer->capacity ? 2 * buffer->capacity : SINK_FIRST;
        buffer->i = memory_resize(buffer->i, buffer->capacity, sizeof *buffer->i, "pair buffer");
        buffer->j = memory_resize(buffer->j, buffer->capacity, sizeof *buffer->j, "pair buffer");
    }
    buffer->i[buffer->count] = i;
    buffer->j[buffer->count] = j;
    buffer->count++;
}

/* Data of a pass. */
struct pass {
    struct pairlist *list;
    const struct index *index;
    const struct index_view *view;
};

/* Writes all pairs that the index finds in a block to the worker's sink, which grows. */
static void block_visit(const struct pass *pass, struct pairlist_worker *worker,
                        const struct pair_block *block) {
    struct index_sink *sink = &worker->sink;
    for (;;) {
        sink->count = 0;
        index_visit(pass->index, pass->view, block->first_row, block->last_row, sink);
        if (sink->count <= sink->capacity)
            return;
        sink->capacity = sink->count + sink->count / 4 + SINK_FIRST;
        memory_free(sink->i);
        memory_free(sink->j);
        sink->i = memory_allocate(sink->capacity + INDEX_SINK_PAD, sizeof *sink->i, "pairs of a block");
        sink->j = memory_allocate(sink->capacity + INDEX_SINK_PAD, sizeof *sink->j, "pairs of a block");
    }
}

/* The rest of the worker's region as a sink; `pad` entries at its end stay free. */
static struct index_sink region_sink(const struct pass *pass, const struct pairlist_worker *worker,
                                     size_t pad) {
    if (worker->used + pad >= worker->room)
        return (struct index_sink){0};
    return (struct index_sink){.i = pass->list->i + worker->first + worker->used,
                               .j = pass->list->j + worker->first + worker->used,
                               .capacity = worker->room - worker->used - pad};
}

/* Appends pairs to the worker's region, or only counts where it is full. */
static void region_put(struct pairlist *list, struct pairlist_worker *worker, uint32_t i, uint32_t j) {
    if (worker->used < worker->room) {
        list->i[worker->first + worker->used] = i;
        list->j[worker->first + worker->used] = j;
    }
    worker->used++;
}

static void region_append(struct pairlist *list, struct pairlist_worker *worker, struct pair_buffer *buffer) {
    for (size_t k = 0; k < buffer->count; k++)
        region_put(list, worker, buffer->i[k], buffer->j[k]);
    buffer->count = 0;
}

/* The mirror image of a pair (i, j). */
static uint32_t mirror_partner(uint32_t i, uint32_t j) {
    return i | image_opposite(pair_image(j)) << PARTICLE_INDEX_BITS;
}

/* Rows of one class that lie together and belong to one thread: for partners among these rows no look-up of
 * the thread is needed. Empty for a busy class. */
struct own_rows {
    uint32_t first, count;
};

static struct own_rows own_rows_of(const struct pairlist *list, int t, const struct pair_block *block) {
    const struct pair_block *first = block, *last = block;
    if (list->build->busy_class[block->size_class])
        return (struct own_rows){0, 0};
    while (first > list->blocks + list->thread_block[t] && first[-1].last_row == first->first_row &&
           first[-1].size_class == block->size_class)
        first--;
    while (last[1].kind == PAIR_BLOCK_ROWS && last[1].first_row == last->last_row &&
           last[1].size_class == block->size_class)
        last++;
    return (struct own_rows){first->first_row, last->last_row - first->first_row};
}

/* Sorts a pair whose partner is not one of the own rows. True if both are of this thread: the pair keeps its place. */
static bool pair_sort(const struct pass *pass, struct pairlist_worker *worker, int t, uint32_t i,
                      uint32_t j) {
    const struct pairlist_build *build = pass->list->build;
    const struct index_view *view = pass->view;
    uint32_t partner = pair_partner(j);
    int class_j = view->size_class[partner];
    worker->partners[class_j]++;
    if (partner >= view->owned) {
        buffer_put(&worker->ghost, i, j);
    } else if (build->busy_class[class_j]) {
        buffer_put(&worker->slot, i, j);
    } else if (build->thread_of[partner] != t) {
        buffer_put(&worker->one, i, j);
        buffer_put(&worker->mirror, partner, mirror_partner(i, j));
    } else {
        return true;
    }
    return false;
}

/* True if all of these partners are among the own rows. */
static bool all_own(const uint32_t *j, size_t count, const struct own_rows own) {
    unsigned other = 0;
    for (size_t k = 0; k < count; k++)
        other |= pair_partner(j[k]) - own.first >= own.count;
    return other == 0;
}

/* Moves the pairs of other threads from the sink into the worker's buffers and closes the gaps; returns the number of
 * pairs whose partner is not one of the own rows. Most batches have none and move as a whole, if at all. */
static size_t pairs_keep(const struct pass *pass, struct pairlist_worker *worker, int t,
                         struct index_sink *sink, const struct own_rows own) {
    enum { BATCH = 128 };
    size_t kept = 0, others = 0, found = sink->count;
    for (size_t first = 0; first < found; first += BATCH) {
        size_t last = first + BATCH < found ? first + BATCH : found;
        if (all_own(sink->j + first, last - first, own)) {
            if (kept < first) {
                memmove(sink->i + kept, sink->i + first, (last - first) * sizeof *sink->i);
                memmove(sink->j + kept, sink->j + first, (last - first) * sizeof *sink->j);
            }
            kept += last - first;
            continue;
        }
        for (size_t k = first; k < last; k++) {
            uint32_t i = sink->i[k], j = sink->j[k];
            bool other = pair_partner(j) - own.first >= own.count;
            others += other;
            if (other && !pair_sort(pass, worker, t, i, j))
                continue;
            sink->i[kept] = i;
            sink->j[kept++] = j;
        }
    }
    sink->count = kept;
    return others;
}

/* Finds the pairs of a block and sorts them into its segments and the worker's buffers. The index writes them into the
 * region at once, unless that is too small. */
static void block_find(const struct pass *pass, struct pairlist_worker *worker, int t,
                       const struct pair_block *block) {
    const struct own_rows own = own_rows_of(pass->list, t, block);
    struct index_sink sink = region_sink(pass, worker, INDEX_SINK_PAD);
    index_visit(pass->index, pass->view, block->first_row, block->last_row, &sink);
    const bool apart = sink.count > sink.capacity;
    if (apart) {
        block_visit(pass, worker, block);
        sink = worker->sink;
    }
    worker->primary += sink.count;
    worker->partners[block->size_class] += 2 * sink.count;
    worker->partners[block->size_class] -= pairs_keep(pass, worker, t, &sink, own);
    for (size_t k = 0; apart && k < sink.count; k++)
        region_put(pass->list, worker, sink.i[k], sink.j[k]);
    worker->used += apart ? 0 : sink.count;
}

/* With one thread and no ghosts there is nothing to sort. */
static void block_fill(const struct pass *pass, struct pairlist_worker *worker,
                       const struct pair_block *block) {
    struct index_sink sink = region_sink(pass, worker, 0);
    index_visit(pass->index, pass->view, block->first_row, block->last_row, &sink);
    worker->used += sink.count;
    worker->primary += sink.count;
}

static void pass_rows(const struct pass *pass, int t) {
    struct pairlist *list = pass->list;
    struct pairlist_worker *worker = &list->build->worker[t];
    bool plain = list->threads == 1 && pass->view->total == pass->view->owned;
    worker->used = worker->primary = worker->mirror.count = worker->ghost.count = 0;
    memset(worker->partners, 0, sizeof worker->partners);
    for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
        struct pair_block *block = &list->blocks[b];
        if (block->kind != PAIR_BLOCK_ROWS)
            continue;
        block->first_pair = worker->first + worker->used;
        if (plain)
            block_fill(pass, worker, block);
        else
            block_find(pass, worker, t, block);
        block->one_sided = worker->first + worker->used;
        region_append(list, worker, &worker->one);
        block->slotted = worker->first + worker->used;
        region_append(list, worker, &worker->slot);
        block->end_pair = worker->first + worker->used;
    }
}

static void block_begin(struct pair_block *block, const struct pairlist_worker *worker) {
    block->first_pair = block->one_sided = block->slotted = block->end_pair = worker->first + worker->used;
}

static void pass_mirror(const struct pass *pass, int t) {
    struct pairlist *list = pass->list;
    struct pairlist_build *build = list->build;
    struct pairlist_worker *worker = &build->worker[t];
    struct pair_block *block = &list->blocks[list->thread_block[t + 1] - 2];
    block_begin(block, worker);
    for (int from = 0; from < list->threads; from++) {
        const struct pair_shares *mirrors = &build->worker[from].mirrors;
        for (size_t k = pairlist_shares_first(mirrors, t); k < mirrors->end[t]; k++)
            region_put(list, worker, mirrors->pairs.i[k], mirrors->pairs.j[k]);
    }
    block->slotted = block->end_pair = worker->first + worker->used;
}

static void pass_ghosts(const struct pass *pass, int t) {
    struct pairlist *list = pass->list;
    struct pairlist_build *build = list->build;
    struct pairlist_worker *worker = &build->worker[t];
    struct pair_block *block = &list->blocks[list->thread_block[t + 1] - 1];
    bool newton = pass->view->newton;
    block_begin(block, worker);
    for (size_t k = 0; k < worker->ghost.count; k++) {
        uint32_t i = worker->ghost.i[k], j = worker->ghost.j[k], partner = pair_partner(j);
        if (newton && build->busy_class[pass->view->size_class[partner]])
            buffer_put(&worker->slot, i, j);
        else if (newton && build->thread_of[partner] == t)
            region_put(list, worker, i, j);
        else
            buffer_put(&worker->one, i, j);
    }
    block->one_sided = worker->first + worker->used;
    region_append(list, worker, &worker->one);
    for (int from = 0; newton && from < list->threads; from++) {
        const struct pair_shares *ghosts = &build->worker[from].ghosts;
        for (size_t k = pairlist_shares_first(ghosts, t); k < ghosts->end[t]; k++) {
            uint32_t i = ghosts->pairs.i[k], j = ghosts->pairs.j[k];
            region_put(list, worker, pair_partner(j), mirror_partner(i, j));
        }
    }
    block->slotted = worker->first + worker->used;
    region_append(list, worker, &worker->slot);
    block->end_pair = worker->first + worker->used;
}

static void pass_run(const struct pass *pass) {
    struct pairlist *list = pass->list;
#pragma omp parallel
    {
#pragma omp for schedule(static, 1)
        for (int t = 0; t < list->threads; t++) {
            pass_rows(pass, t);
            pairlist_shares_mirrors(list, t);
            pairlist_shares_meet(list, t);
        }
#pragma omp for schedule(static, 1)
        for (int t = 0; t < list->threads; t++) {
            if (list->threads > 1 && pass->view->newton)
                pairlist_shares_ghosts(list, pass->view, t);
        }
#pragma omp for schedule(static, 1) nowait
        for (int t = 0; t < list->threads; t++) {
            pass_mirror(pass, t);
            pass_ghosts(pass, t);
        }
    }
}

/* True if every region was large enough; else lays the list out again from the counts of the pass. */
static bool regions_suffice(struct pairlist *list) {
    struct pairlist_build *build = list->build;
    bool suffice = true;
    for (int t = 0; t < list->threads; t++)
        suffice = suffice && build->worker[t].used <= build->worker[t].room;
    if (suffice)
        return true;
    size_t capacity = 0;
    for (int t = 0; t < list->threads; t++) {
        struct pairlist_worker *worker = &build->worker[t];
        worker->first = capacity;
        worker->room = worker->used + worker->used / 32 + REGION_SPARE;
        capacity += worker->room;
    }
    memory_free(list->i);
    memory_free(list->j);
    list->i = memory_allocate(capacity + INDEX_SINK_PAD, sizeof *list->i, "pair list");
    list->j = memory_allocate(capacity + INDEX_SINK_PAD, sizeof *list->j, "pair list");
    list->capacity = capacity;
    return false;
}

/* Decides which classes are busy from the partners counted; true if the pass assumed the same classes. */
static bool busy_settled(struct pairlist *list, const struct index_view *view) {
    struct pairlist_build *build = list->build;
    uint64_t partners[CLASS_MAX] = {0};
    bool settled = true;
    if (list->threads == 1)
        return true;
    for (int t = 0; t < list->threads; t++)
        for (int c = 0; c < view->classes; c++)
            partners[c] += build->worker[t].partners[c];
    for (int c = 0; c < view->classes; c++) {
        double mean = build->population[c] ? (double)partners[c] / (double)build->population[c] : 0;
        bool busy = mean > (build->busy_class[c] ? build->busy_bound / 2 : build->busy_bound);
        settled = settled && busy == build->busy_class[c];
        build->busy_class[c] = busy;
    }
    return settled;
}

/* Numbers the slots of the particles of busy classes, run by run. */
static void slots_make(struct pairlist *list, const struct index_view *view) {
    bool busy = false;
    for (int c = 0; c < view->classes; c++)
        busy = busy || list->build->busy_class[c];
    list->slot_count = 0;
    for (size_t first = 0, last; busy && first < view->total; first = last) {
        last = members_run(view->size_class, first, view->total);
        if (!list->build->busy_class[view->size_class[first]])
            continue;
        pairlist_reserve_slots(list, view->total, list->slot_count + last - first);
        for (size_t k = first; k < last; k++) {
            list->slot_of[k] = (int32_t)list->slot_count;
            list->busy[list->slot_count++] = (uint32_t)k;
        }
    }
}

void pairlist_build(struct pairlist *list, const struct index *index, const struct index_view *view,
                    const struct box *box) {
    assert(view->total < (size_t)1 << PARTICLE_INDEX_BITS);
    struct pass pass = {list, index, view};
    list->sides = 0;
    pairlist_follow(list, box);
    pairlist_blocks_make(list, view);
    for (;;) {
        pass_run(&pass);
        bool settled = busy_settled(list, view);
        if (regions_suffice(list) && settled)
            break;
    }
    slots_make(list, view);
    list->pair_count = list->primary_count = 0;
    for (int t = 0; t < list->threads; t++) {
        list->pair_count += list->build->worker[t].used;
        list->primary_count += list->build->worker[t].primary;
    }
}
