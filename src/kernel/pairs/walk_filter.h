/* SPDX-License-Identifier: BSD-3-Clause */
/* The first operation on a block (walk.h): the near pairs become candidates. Included by walk_block.c alone, which is
 * compiled for several instruction sets. */
#ifndef SCREE_PAIRS_WALK_FILTER_H
#define SCREE_PAIRS_WALK_FILTER_H

#include "kernel/pairs/walk_four.h"
#include "kernel/pairs/walk_kernel.h"

/* Half a record of a particle: x y z radius, and vx vy vz 1/mass. */
#define WALK_HALF(state, half) (*(const walk_four *)((const double *)(state) + 4 * (half)))

/* Data that the loops over pairs read, side by side: a compiler must assume that stores change the data
 * behind pointers. */
struct walk_view {
    const struct particle_state *state;
    struct walk_field gather[WALK_GATHER_MAX];
    const double *target; /* only to fetch it ahead of the scatter */
    size_t stride;
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

/* Appends those of the block's pairs [first, last) that are near. */
static inline __attribute__((always_inline)) void walk_filter(const struct walk_view view,
                                                              enum walk_cutoff cutoff,
                                                              struct walk_thread *restrict thread,
                                                              size_t first, size_t last) {
    uint32_t *out = thread->candidate + thread->candidates;
    size_t k = first;
    for (; k + WALK_QUAD <= last; k += WALK_QUAD) {
        for (size_t lane = 0; lane < WALK_QUAD; lane++)
            __builtin_prefetch(&view.state[pair_partner(view.j[k + lane + WALK_AHEAD])]);
        out = walk_append(out, k, walk_near(&view, cutoff, view.i + k, view.j + k));
    }
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

#endif
