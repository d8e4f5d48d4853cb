/* SPDX-License-Identifier: BSD-3-Clause */
/* Chooses and runs the order of a step. Read order.h first. */
#include "engine/order.h"
#include "engine/decide.h"
#include "engine/guards.h"
#include "engine/order_plan.h"
#include "engine/rebuild.h"
#include "engine/values.h"
#include <assert.h>
#include <string.h>

/* Moves the early particles of a thread, before all other particles. */
static void early_move(struct simulation *s, int t) {
    const struct sweep_thread *plan = &s->search.sweep->thread[t];
    for (size_t r = 0; r < plan->early_count; r++)
        plan_move(&s->plan.moves, t, plan->early[r].first, plan->early[r].last, plan->early[r].size_class);
}

static void early_run(struct simulation *s) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        early_move(s, t);
    values_send(s);
}

/* Computes the blocks of a thread: late particles move, then forces. */
static void late_sweep(struct simulation *s, int t) {
    const struct pairlist *list = s->search.list;
    const struct sweep_thread *plan = &s->search.sweep->thread[t];
    int first = list->thread_block[t];
    for (int b = first; b < list->thread_block[t + 1]; b++) {
        for (size_t r = plan->start[b - first]; r < plan->start[b - first + 1]; r++)
            plan_move(&s->plan.moves, t, plan->late[r].first, plan->late[r].last, plan->late[r].size_class);
        if (s->ranks.alone || list->blocks[b].kind != PAIR_BLOCK_GHOST)
            plan_block(&s->plan.pairs, t, b);
    }
}

static void sweep_run(struct simulation *s) {
#pragma omp parallel
    {
        if (s->ranks.alone) {
#pragma omp for schedule(static, 1)
            for (int t = 0; t < s->threads; t++)
                early_move(s, t);
        }
#pragma omp for schedule(static, 1) nowait
        for (int t = 0; t < s->threads; t++)
            late_sweep(s, t);
    }
    decide_begin(s);
}

static void copies_run(struct simulation *s) {
    const struct pairlist *list = s->search.list;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        plan_block(&s->plan.pairs, t, list->thread_block[t + 1] - 1);
}

static void verify_run(struct simulation *s) {
    decide_end(s);
    decide_measure(s);
    if (!s->agree.signals.rebuild)
        return;
    size_t doubles = (s->particles->owned + s->particles->ghosts) * (size_t)s->particles->force_stride;
    plan_abandon(&s->plan.pairs);
    memset(s->particles->force, 0, doubles * sizeof(double));
    s->particles->force_clear = true;
    rebuild_run(s);
    s->particles->force_clear = false;
    plan_block_all(&s->plan.pairs, s->search.list);
}

/* Computes one block of a thread; then the particles move for which this was the last. */
static void ring_block(struct simulation *s, int t, int b) {
    const struct ring_thread *plan = &s->order.ring->thread[t];
    int number = b - s->search.list->thread_block[t];
    plan_block(&s->plan.pairs, t, b);
    for (size_t r = plan->start[number]; r < plan->start[number + 1]; r++)
        plan_move(&s->plan.moves, t, plan->range[r].first, plan->range[r].last, plan->range[r].size_class);
}

static void ring_run(struct simulation *s) {
    const struct pairlist *list = s->search.list;
    memset(s->search.speed, 0, (size_t)s->threads * sizeof *s->search.speed);
    s->evaluation.ring = s->order.ring;
    physics_prepare(&s->physics);
    s->order.ahead = true;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
            if (s->ranks.alone || list->blocks[b].kind != PAIR_BLOCK_GHOST)
                ring_block(s, t, b);
}

/* After a rebuild the copies are new. */
static void ring_receive(struct simulation *s) {
    if (!s->agree.signals.rebuild)
        values_receive(s);
}

static void ring_copies(struct simulation *s) {
    const struct pairlist *list = s->search.list;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        ring_block(s, t, list->thread_block[t + 1] - 1);
}

static void settle_run(struct simulation *s) {
    s->evaluation.ring = NULL;
    physics_prepare(&s->physics);
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        early_move(s, t);
}

static bool needs_copies(const struct simulation *s) {
    return !s->ranks.alone;
}

const struct engine_pass order_ring[] = {{"ring", NULL, "sweep", NULL, ring_run},
                                         {"receive", "several ranks", "comm", needs_copies, ring_receive},
                                         {"copies", "several ranks", "contact", needs_copies, ring_copies},
                                         {0}};

const struct engine_pass order_settle[] = {{"settle", NULL, "advance", NULL, settle_run}, {0}};

const struct engine_pass order_sweep[] = {{"early", "several ranks", "advance", needs_copies, early_run},
                                          {"sweep", NULL, "sweep", NULL, sweep_run},
                                          {"receive", "several ranks", "comm", needs_copies, values_receive},
                                          {"copies", "several ranks", "contact", needs_copies, copies_run},
                                          {"verify", NULL, "decide", NULL, verify_run},
                                          {0}};

/* Reproducible sums wait for all shares; a skin that the run chooses looks at particles between steps. */
static bool ring_wanted(const struct simulation *s) {
    return s->plan.ring.passes > 0 && s->scene->step.fused && !s->scene->reproducible &&
           !s->scene->classes.skin_auto && !s->box.motion.moves && !s->caller.force;
}

void order_make(struct simulation *s) {
    s->order.ring = ring_wanted(s) ? ring_create(s->threads) : NULL;
}

void order_print(const struct simulation *s, FILE *file) {
    if (!s->scene->step.fused)
        return;
    fprintf(file, " fused; sweep: ");
    plan_print_visits(&s->plan.moves, &s->plan.pairs, file);
    fprintf(file, "\n");
    plan_print(&s->plan.fused, file);
    if (s->order.ring) {
        fprintf(file, " steps after which nobody looks; ring: ");
        plan_print_visits(&s->plan.pairs, &s->plan.moves, file);
        fprintf(file, "\n");
        plan_print(&s->plan.go_on, file);
        plan_print(&s->plan.exchange, file);
        plan_print(&s->plan.ring, file);
    }
    fprintf(file, " at rebuilds:\n");
}

/* False if the plan says that most of the ring's gain would be lost (order_plan); before a new plan is made, true.
 * Several ranks agree on this at a rebuild. */
static bool ring_pays(const struct simulation *s) {
    if (!s->ranks.alone)
        return s->order.agreed;
    return s->order.ring && (s->search.sweep->stale || s->order.ring->sweep);
}

/* True if this step takes the way of the ring order. The order of messages and reductions differs between that way and
 * the fused order, so all ranks go the same way, whether or not their particles have moved ahead. */
static bool ring_due(const struct simulation *s, bool unseen) {
    bool before = s->ranks.alone ? s->order.ahead : s->order.before;
    return ring_pays(s) && (unseen || before);
}

void order_choose(struct simulation *s, bool unseen) {
    bool in_ring = ring_due(s, unseen);
    bool fused =
        s->scene->step.fused && !s->agree.signals.rebuild && !skin_nearly_due(s->search.skin, &s->classes);
    assert(in_ring || !s->order.ahead);
    s->order.kind = in_ring ? ORDER_RING : fused ? ORDER_FUSED : ORDER_PLAIN;
    s->order.unseen = unseen;
    s->order.before = in_ring && unseen;
    if (!s->order.ahead)
        memset(s->search.speed, 0, (size_t)s->threads * sizeof *s->search.speed);
}

/* A step that begins in ring order ends in it, or in plain order, where the state at its end will be looked at. */
static void ring_step(struct simulation *s) {
    plan_run(s->order.ahead ? &s->plan.go_on : &s->plan.begin, &s->timers, s);
    s->order.ahead = false;
    bool unseen = s->order.unseen && !s->agree.signals.error && guards_calm(s);
    bool rebuild = s->agree.signals.rebuild;
    if (rebuild)
        plan_run(&s->plan.exchange, &s->timers, s);
    unseen = unseen && s->error.kind == ERROR_NONE && s->sources.last_step != s->clock.step;
    if (unseen)
        order_plan(s);
    unseen = unseen && ring_pays(s);
    if (!rebuild && !unseen)
        plan_run(&s->plan.exchange, &s->timers, s);
    else if (!rebuild && !s->ranks.alone)
        values_send(s);
    plan_run(unseen ? &s->plan.ring : &s->plan.forces, &s->timers, s);
}

void order_run(struct simulation *s) {
    if (s->order.kind == ORDER_RING) {
        ring_step(s);
    } else if (s->order.kind == ORDER_FUSED) {
        order_plan(s);
        plan_run(&s->plan.fused, &s->timers, s);
    } else {
        plan_run(&s->plan.plain, &s->timers, s);
    }
}

bool order_finish(struct simulation *s) {
    return !s->order.ahead;
}
