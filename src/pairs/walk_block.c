/* SPDX-License-Identifier: BSD-3-Clause */
/* One block of the pair list through the stages of walk.h. Compiled once for each instruction set, under the
 * name that WALK_KERNEL gives. Read walk.h first. */
#include "pairs/walk_four.h"
#include "pairs/walk_kernel.h"
#include <string.h>

/* Half a record of a particle: x y z radius, and vx vy vz 1/mass. */
#define WALK_HALF(state, half) (*(const walk_four *)((const double *)(state) + 4 * (half)))

/* Data that the loops over pairs read, side by side: a compiler must assume that stores change the data
 * behind pointers. */
struct walk_view {
    const struct particle_state *state;
    struct walk_field gather[WALK_GATHER_MAX];
    const double *target; /* only to fetch it ahead of the scatter */
    size_t stride;
    const int32_t *place;  /* shift of the ring */
    const uint32_t *i, *j; /* from the first pair of the block on */
    const double (*shift)[4];
    const double (*drift)[4]; /* velocities of images; NULL: the box is at rest */
    double range;
    int gathers;
};

static inline struct walk_view walk_view_of(const struct walk_task *task) {
    const struct walk_work *work = task->work;
    struct walk_view view = {.state = work->particles->state,
                             .target = work->target,
                             .stride = work->stride,
                             .place = work->ring ? work->ring->shift : NULL,
                             .i = work->list->i + task->block->first_pair,
                             .j = work->list->j + task->block->first_pair,
                             .shift = work->list->shift,
                             .drift = work->list->moves ? work->list->drift : NULL,
                             .range = work->range,
                             .gathers = work->gathers};
    for (int g = 0; g < work->gathers; g++)
        view.gather[g] = work->gather[g];
    return view;
}

/* The records of a pair: half 0 gives x_j - x_i and r_i + r_j, half 1 v_j - v_i and 1/m_i + 1/m_j. */
static inline walk_four walk_between(const struct particle_state *i, const struct particle_state *j,
                                     int half) {
    const walk_four sign = {-1.0, -1.0, -1.0, 1.0};
    return WALK_HALF(j, half) + WALK_HALF(i, half) * sign;
}

/* How a cut-off is formed; a constant where the filter is inlined. */
enum walk_cutoff { WALK_TOUCH, WALK_RADII, WALK_RANGE };

/* The near ones of four pairs, one bit each. */
static inline unsigned walk_near(const struct walk_view *view, enum walk_cutoff cutoff,
                                 const uint32_t i[WALK_QUAD], const uint32_t j[WALK_QUAD]) {
    walk_four between[WALK_QUAD], row[WALK_QUAD];
    for (int k = 0; k < WALK_QUAD; k++)
        between[k] = walk_between(&view->state[i[k]], &view->state[pair_partner(j[k])], 0) +
                     *(const walk_four *)view->shift[pair_image(j[k])];
    walk_turn(row, between[0], between[1], between[2], between[3]);
    const walk_four range = {view->range, view->range, view->range, view->range};
    if (cutoff == WALK_RADII)
        row[3] += range;
    if (cutoff == WALK_RANGE)
        row[3] = range;
    return walk_bits(row[0] * row[0] + row[1] * row[1] + row[2] * row[2] < row[3] * row[3]);
}

/* Fetches the next particles of the next block: their states, and the first field that is gathered. */
static inline void walk_fetch_some(const struct walk_view *view, struct walk_fetch *fetch) {
    if (fetch->row < fetch->last) {
        for (uint32_t k = 0; k < WALK_FETCH; k++)
            __builtin_prefetch(&view->state[fetch->row + k]);
        if (view->gathers > 0)
            __builtin_prefetch(view->gather[0].base + fetch->row * view->gather[0].stride);
        fetch->row += WALK_FETCH;
    } else if (fetch->ranges > 0) {
        fetch->row = fetch->range->first;
        fetch->last = fetch->range->last;
        fetch->range++;
        fetch->ranges--;
    }
}

/* Appends those of the block's pairs [first, last) that are near. */
static inline __attribute__((always_inline)) void walk_filter(const struct walk_view view,
                                                              enum walk_cutoff cutoff,
                                                              struct walk_thread *restrict thread,
                                                              size_t first, size_t last) {
    uint32_t *out = thread->candidate + thread->candidates;
    struct walk_fetch fetch = thread->fetch;
    size_t k = first;
    for (; k + WALK_QUAD <= last; k += WALK_QUAD) {
        for (size_t lane = 0; lane < WALK_QUAD; lane++)
            __builtin_prefetch(&view.state[pair_partner(view.j[k + lane + WALK_AHEAD])]);
        out = walk_append(out, k, walk_near(&view, cutoff, view.i + k, view.j + k));
        walk_fetch_some(&view, &fetch);
    }
    thread->fetch = fetch;
    if (k < last) {
        uint32_t i[WALK_QUAD], j[WALK_QUAD];
        for (size_t lane = 0; lane < WALK_QUAD; lane++) {
            i[lane] = view.i[k + lane < last ? k + lane : k];
            j[lane] = view.j[k + lane < last ? k + lane : k];
        }
        out = walk_append(out, k, walk_near(&view, cutoff, i, j) & ((1u << (last - k)) - 1));
    }
    thread->candidates = (size_t)(out - thread->candidate);
}

/* Adds the pairs up to `last` of the block that have a record whose number `held` is not 0 to the candidates from place `from` on, the
 * pairs that touch. Candidates and records run in the order of the list. */
static __attribute__((noinline)) void walk_add_held(const struct walk_task *task, size_t from, size_t last) {
    struct walk_thread *thread = task->thread;
    const struct history_part *old = task->old;
    const size_t components = (size_t)task->work->history->components;
    const size_t held = (size_t)task->work->held;
    const uint32_t offset = (uint32_t)(task->block->first_pair - task->pair_base);
    uint32_t *candidate = thread->candidate, apart[WALK_CHUNK];
    size_t count = thread->candidates, at = thread->ahead, next = from, more = 0;
    for (; at < old->count && old->pair[at] < offset + last; at++) {
        uint32_t pair = old->pair[at] - offset;
        while (next < count && candidate[next] < pair)
            next++;
        if ((next == count || candidate[next] != pair) && old->value[at * components + held] != 0.0)
            apart[more++] = pair;
    }
    thread->ahead = at;
    thread->candidates = count + more;
    for (size_t to = count + more; more > 0;)
        candidate[--to] =
            count > from && candidate[count - 1] > apart[more - 1] ? candidate[--count] : apart[--more];
}

/* A separate filter for contacts, as the filter for contacts must be fast. */
static inline void walk_filter_any(const struct walk_task *task, const struct walk_view *view, size_t first,
                                   size_t last) {
    const struct walk_work *work = task->work;
    size_t before = task->thread->candidates;
    if (work->radii && (work->waits || work->range == 0.0))
        walk_filter(*view, WALK_TOUCH, task->thread, first, last);
    else if (work->radii)
        walk_filter(*view, WALK_RADII, task->thread, first, last);
    else
        walk_filter(*view, WALK_RANGE, task->thread, first, last);
    if (work->waits)
        walk_add_held(task, before, last);
}

/* Takes out of the batch the pairs that the client does not want. */
static __attribute__((noinline)) void walk_select(const struct walk_task *task, int gathers) {
    struct walk_batch *restrict b = task->thread->batch;
    uint8_t keep[WALK_BATCH];
    int kept = 0;
    memset(keep, 1, sizeof keep);
    task->client->select(task, b, keep);
    for (int k = 0; k < b->count; k++) {
        if (!keep[k])
            continue;
        if (kept < k) {
            memcpy(b->record[kept], b->record[k], sizeof b->record[k]);
            for (int g = 0; g < gathers; g++)
                memcpy(b->gathered[g][kept], b->gathered[g][k], sizeof b->gathered[g][k]);
            b->i[kept] = b->i[k];
            b->j[kept] = b->j[k];
            b->pair[kept] = b->pair[k];
            b->radius[0][kept] = b->radius[0][k];
            b->radius[1][kept] = b->radius[1][k];
        }
        kept++;
    }
    b->count = kept;
}

/* Adds the velocities of the images, in a box that moves. */
static __attribute__((noinline)) void walk_drift(const struct walk_task *task, const uint32_t *j,
                                                 const double (*drift)[4], int count) {
    struct walk_batch *restrict b = task->thread->batch;
    for (int k = 0; k < count; k++)
        *(walk_four *)(b->record[k] + 4) +=
            *(const walk_four *)drift[pair_image(j[task->thread->candidate[k]])];
}

/* Fills the batch with the first `count` near pairs. */
static inline void walk_gather(const struct walk_task *task, const struct walk_view view, int count) {
    const struct walk_thread *restrict thread = task->thread;
    struct walk_batch *restrict b = thread->batch;
    uint32_t offset = (uint32_t)(task->block->first_pair - task->pair_base);
    for (int g = 0; g < view.gathers; g++)
        for (int k = 0; k < count; k++)
            __builtin_prefetch(view.gather[g].base +
                               pair_partner(view.j[thread->candidate[k]]) * view.gather[g].stride);
    for (int k = 0; k < count; k++) {
        uint32_t pair = thread->candidate[k], i = view.i[pair], code = view.j[pair], j = pair_partner(code);
        const struct particle_state *si = &view.state[i], *sj = &view.state[j];
        __builtin_prefetch(view.target + ring_record(view.place, i) * view.stride, 1);
        __builtin_prefetch(view.target + ring_record(view.place, j) * view.stride, 1);
        b->i[k] = i;
        b->j[k] = j;
        b->pair[k] = pair + offset;
        b->radius[0][k] = si->radius;
        b->radius[1][k] = sj->radius;
        *(walk_four *)b->record[k] =
            walk_between(si, sj, 0) + *(const walk_four *)view.shift[pair_image(code)];
        *(walk_four *)(b->record[k] + 4) = walk_between(si, sj, 1);
        for (int g = 0; g < view.gathers; g++) {
            const double *base = view.gather[g].base;
            *(walk_four *)b->gathered[g][k] = *(const walk_four *)(base + i * view.gather[g].stride);
            *(walk_four *)(b->gathered[g][k] + 4) = *(const walk_four *)(base + j * view.gather[g].stride);
        }
    }
    if (view.drift)
        walk_drift(task, view.j, view.drift, count);
    b->count = count;
    if (task->work->selective)
        walk_select(task, view.gathers);
    b->padded = (b->count + WALK_LANES - 1) / WALK_LANES * WALK_LANES;
}

/* The history of the batch where each of its pairs has one: records lie side by side. Reads up to a record of
 * padding at a time. */
static inline void walk_recall_run(struct walk_batch *restrict b, const double *restrict value,
                                   int components) {
    if (components == WALK_QUAD) {
        for (int k = 0; k < b->count; k += WALK_QUAD) {
            const walk_four *from = (const walk_four *)value + k;
            walk_four out[WALK_QUAD];
            walk_turn(out, from[0], from[1], from[2], from[3]);
            for (int row = 0; row < WALK_QUAD; row++)
                *(walk_four *)&b->history[row][k] = out[row];
        }
        return;
    }
    if (components % 3 != 0) {
        for (int k = 0; k < b->count; k++)
            for (int c = 0; c < components; c++)
                b->history[c][k] = value[k * components + c];
        return;
    }
    for (int k = 0; k < b->count; k += WALK_QUAD)
        for (int c = 0; c < components; c += 3) {
            const double *from = value + k * components + c;
            walk_four out[WALK_QUAD];
            walk_turn(out, *(const walk_four *)from, *(const walk_four *)(from + components),
                      *(const walk_four *)(from + 2 * components),
                      *(const walk_four *)(from + 3 * components));
            for (int row = 0; row < 3; row++)
                *(walk_four *)&b->history[c + row][k] = out[row];
        }
}

/* Finds the old records of the batch's pairs: both run in the order of the pairs. Most often no contact has
 * come or gone. */
static inline void walk_recall(const struct history_part old, struct walk_thread *restrict thread,
                               int components) {
    struct walk_batch *restrict b = thread->batch;
    size_t cursor = thread->cursor, count = (size_t)b->count;
    while (cursor < old.count && old.pair[cursor] < b->pair[0])
        cursor++;
    if (cursor + count <= old.count && memcmp(old.pair + cursor, b->pair, count * sizeof *b->pair) == 0) {
        walk_recall_run(b, old.value + cursor * (size_t)components, components);
        thread->cursor = cursor + count;
        return;
    }
    for (size_t k = 0; k < count; k++) {
        uint32_t pair = b->pair[k];
        while (cursor < old.count && old.pair[cursor] < pair)
            cursor++;
        bool known = cursor < old.count && old.pair[cursor] == pair;
        for (int c = 0; c < components; c++)
            b->history[c][k] = known ? old.value[cursor * (size_t)components + (size_t)c] : 0.0;
    }
    thread->cursor = cursor;
}

/* Appends the new records of the batch to the other buffer. Each store of three components spills into the
 * next, which is written after it: at the end, into the padding. */
static inline void walk_remember(struct history_part *new, const struct walk_batch *restrict b,
                                 int components) {
    double *restrict value = new->value + new->count *(size_t)components;
    memcpy(new->pair + new->count, b->pair, (size_t)b->count * sizeof *b->pair);
    for (int k = 0; components == WALK_QUAD && k < b->count; k += WALK_QUAD) {
        const double(*from)[WALK_BATCH] = b->history;
        walk_turn((walk_four *)value + k, *(const walk_four *)&from[0][k], *(const walk_four *)&from[1][k],
                  *(const walk_four *)&from[2][k], *(const walk_four *)&from[3][k]);
    }
    for (int k = 0; components != WALK_QUAD && components % 3 != 0 && k < b->count; k++)
        for (int c = 0; c < components; c++)
            value[k * components + c] = b->history[c][k];
    for (int k = 0; components % 3 == 0 && k < b->count; k += WALK_QUAD) {
        walk_four half[HISTORY_COMPONENTS_MAX / 3][WALK_QUAD];
        for (int c = 0; c < components; c += 3) {
            walk_four z = *(const walk_four *)&b->history[c + 2][k];
            walk_turn(half[c / 3], *(const walk_four *)&b->history[c][k],
                      *(const walk_four *)&b->history[c + 1][k], z, z);
        }
        for (int m = 0; m < WALK_QUAD; m++)
            for (int c = 0; c < components; c += 3)
                *(walk_four *)(value + (k + m) * components + c) = half[c / 3][m];
    }
    new->count += (size_t)b->count;
}

/* Fills the rest of the last lanes with repeats of the last pair. */
static inline void walk_pad(struct walk_batch *b, int gathers, int components) {
    int last = b->count - 1;
    for (int k = b->count; k < b->padded; k++) {
        memcpy(b->record[k], b->record[last], sizeof b->record[k]);
        for (int g = 0; g < gathers; g++)
            memcpy(b->gathered[g][k], b->gathered[g][last], sizeof b->gathered[g][k]);
        for (int side = 0; side < 2; side++)
            b->radius[side][k] = b->radius[side][last];
        for (int c = 0; c < components; c++)
            b->history[c][k] = b->history[c][last];
        b->i[k] = b->i[last];
        b->j[k] = b->j[last];
    }
}

/* The number of the batch's pairs, which run in the order of pairs, before pair `end` of the list. */
static inline int walk_before(const struct walk_task *task, size_t end) {
    const struct walk_batch *b = task->thread->batch;
    int low = 0, high = b->count;
    while (low < high) {
        int middle = (low + high) / 2;
        if (b->pair[middle] + task->pair_base < end)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Turns three components of the batch's pairs into records x y z 0 at share[k] + offset. */
static inline void walk_transpose(struct walk_batch *restrict b, double component[3][WALK_BATCH],
                                  int offset) {
    const walk_four zero = {0.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < b->padded; k += WALK_QUAD) {
        walk_four out[WALK_QUAD];
        walk_turn(out, *(const walk_four *)&component[0][k], *(const walk_four *)&component[1][k],
                  *(const walk_four *)&component[2][k], zero);
        for (int m = 0; m < WALK_QUAD; m++)
            *(walk_four *)(b->share[k + m] + offset) = out[m];
    }
}

/* The shares of all pairs as records. */
static inline void walk_share(struct walk_batch *restrict b, enum walk_scatter scatter) {
    walk_transpose(b, b->out, 0);
    if (scatter >= WALK_TORQUE)
        walk_transpose(b, b->out + 3, 4);
    if (scatter == WALK_ROLLING)
        walk_transpose(b, b->out + 6, 8);
}

/* Adds the share of pair k for i (side 0) or j (side 1) to a record. */
static inline __attribute__((always_inline)) void walk_add(double *record,
                                                           const struct walk_batch *restrict b, int k,
                                                           int side, enum walk_scatter scatter, int values) {
    if (scatter == WALK_VALUES) {
        for (int c = 0; c < values; c++)
            record[c] += b->out[side * values + c][k];
        return;
    }
    const walk_four *share = (const walk_four *)b->share[k];
    walk_four *sum = (walk_four *)record;
    sum[0] = side ? sum[0] + share[0] : sum[0] - share[0];
    if (scatter == WALK_FORCE)
        return;
    walk_four torque = share[1] * b->lever[side][k];
    if (scatter == WALK_ROLLING)
        torque = side ? torque + share[2] : torque - share[2];
    sum[1] += torque;
}

/* Doubles of a target's record. */
static inline size_t walk_stride(const struct walk_task *task, enum walk_scatter scatter) {
    return scatter >= WALK_TORQUE ? 8 : task->work->stride;
}

/* Writes down the share of pair k for i (side 0) or j (side 1), as entry `at`. */
static inline __attribute__((always_inline)) void walk_enter(const struct walk_task *task,
                                                             const struct walk_ledger ledger, size_t at,
                                                             int k, int side, enum walk_scatter scatter) {
    const struct walk_batch *b = task->thread->batch;
    const size_t stride = walk_stride(task, scatter);
    const int64_t *id = task->work->particles->id;
    unsigned image = pair_image(task->work->list->j[b->pair[k] + task->pair_base]);
    double share[WALK_VALUES_MAX] __attribute__((aligned(32))) = {0.0};
    walk_add(share, b, k, side, scatter, task->client->values);
    ledger.particle[at] = side ? b->j[k] : b->i[k];
    ledger.source[at] =
        (struct walk_source){id[side ? b->i[k] : b->j[k]], side ? image_opposite(image) : image};
    memcpy(ledger.share + at * stride, share, stride * sizeof *share);
}

/* Writes down the shares of the batch, to be summed in order. A one-sided pair has only one share here:
 * another thread or rank has the other side. */
static __attribute__((noinline)) void walk_record(const struct walk_task *task, enum walk_scatter scatter) {
    struct walk_ledger *ledger = task->thread->ledger;
    const struct walk_batch *b = task->thread->batch;
    size_t at = ledger->count;
    walk_ledger_reserve(ledger, at + 2 * (size_t)b->count, task->work->stride);
    for (int k = 0; k < b->count; k++) {
        walk_enter(task, *ledger, at++, k, 0, scatter);
        if (k < b->both || k >= b->one)
            walk_enter(task, *ledger, at++, k, 1, scatter);
    }
    ledger->count = at;
}

/* Adds the shares of the batch to the particles, by segment of the list. */
static inline __attribute__((always_inline)) void walk_scatter(const struct walk_task *task,
                                                               enum walk_scatter scatter) {
    struct walk_thread *thread = task->thread;
    const struct walk_batch *restrict b = thread->batch;
    const int32_t *slot_of = task->work->list->slot_of;
    const int32_t *shift = task->work->ring ? task->work->ring->shift : NULL;
    const size_t stride = walk_stride(task, scatter);
    const int values = task->client->values, both = b->both, one = b->one, count = b->count;
    double *target = task->work->target, *slots = thread->slots;
    if (scatter != WALK_VALUES)
        walk_share(thread->batch, scatter);
    if (thread->ledger) {
        walk_record(task, scatter);
        return;
    }
    for (int k = 0; k < both; k++) {
        walk_add(target + ring_record(shift, b->i[k]) * stride, b, k, 0, scatter, values);
        walk_add(target + ring_record(shift, b->j[k]) * stride, b, k, 1, scatter, values);
    }
    for (int k = both; k < count; k++)
        walk_add(target + ring_record(shift, b->i[k]) * stride, b, k, 0, scatter, values);
    for (int k = one; k < count; k++)
        walk_add(slots + (size_t)slot_of[b->j[k]] * stride, b, k, 1, scatter, values);
}

/* Takes the first `count` near pairs out, through a batch. */
static inline __attribute__((always_inline)) void walk_flush(const struct walk_task *task,
                                                             const struct walk_view *view, int count,
                                                             enum walk_scatter scatter, int components) {
    struct walk_thread *thread = task->thread;
    struct walk_batch *b = thread->batch;
    walk_gather(task, *view, count);
    if (b->count > 0) {
        if (components)
            walk_recall(*task->old, thread, components);
        walk_pad(b, view->gathers, components);
        b->both = walk_before(task, task->block->one_sided);
        b->one = walk_before(task, task->block->slotted);
        task->client->compute(task, b);
        if (scatter != WALK_NOTHING)
            walk_scatter(task, scatter);
        if (components)
            walk_remember(task->new, b, components);
        if (task->client->note)
            task->client->note(task, b);
    }
    thread->candidates -= (size_t)count;
    memmove(thread->candidate, thread->candidate + count, thread->candidates * sizeof thread->candidate[0]);
}

/* Takes the block through the stages, with constants for the results and the history of a pair. */
static inline __attribute__((always_inline)) void walk_through(const struct walk_task *task,
                                                               enum walk_scatter scatter, int components) {
    const struct walk_view view = walk_view_of(task);
    struct walk_thread *thread = task->thread;
    size_t pairs = task->block->end_pair - task->block->first_pair;
    thread->candidates = 0;
    for (size_t first = 0; first < pairs; first += WALK_CHUNK) {
        walk_filter_any(task, &view, first, first + WALK_CHUNK < pairs ? first + WALK_CHUNK : pairs);
        while (thread->candidates >= WALK_BATCH)
            walk_flush(task, &view, WALK_BATCH, scatter, components);
    }
    if (thread->candidates > 0)
        walk_flush(task, &view, (int)thread->candidates, scatter, components);
}

/* The usual combinations have a compiled form of their own. */
static void walk_rows(const struct walk_task *task) {
    int components = task->work->history ? task->work->history->components : 0;
    enum walk_scatter scatter = task->client->scatter;
    if (task->block->first_pair == task->block->end_pair)
        return; /* a list without pairs has no arrays */
    if (scatter == WALK_ROLLING && components == 6)
        walk_through(task, WALK_ROLLING, 6);
    else if (scatter == WALK_TORQUE && components == 3)
        walk_through(task, WALK_TORQUE, 3);
    else if (scatter == WALK_TORQUE && components == 4)
        walk_through(task, WALK_TORQUE, 4);
    else if (scatter == WALK_FORCE && components == 0)
        walk_through(task, WALK_FORCE, 0);
    else
        walk_through(task, scatter, components);
}

const struct walk_kernel WALK_KERNEL = {walk_rows};
