/* SPDX-License-Identifier: BSD-3-Clause */
/* The passes of the fused order. Read fused.h first. */
#include "engine/fused.h"
#include "engine/decide.h"
#include "engine/rebuild.h"
#include "engine/values.h"
#include <string.h>

static void plan_sweep(struct simulation *s) {
    size_t count = 0;
    const uint32_t *sent = NULL;
    if (!s->search.sweep->stale)
        return;
    if (!s->ranks.alone)
        sent = ghosts_step_originals(s->ranks.ghosts, &count);
    sweep_build(s->search.sweep, s->search.list, s->particles->owned, sent, count);
}

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

static bool needs_copies(const struct simulation *s) {
    return !s->ranks.alone;
}

const struct engine_pass fused_sweep[] = {{"plan", "new pairs", "pairs", NULL, plan_sweep},
                                          {"early", "several ranks", "advance", needs_copies, early_run},
                                          {"sweep", NULL, "sweep", NULL, sweep_run},
                                          {"receive", "several ranks", "comm", needs_copies, values_receive},
                                          {"copies", "several ranks", "contact", needs_copies, copies_run},
                                          {"verify", NULL, "decide", NULL, verify_run},
                                          {0}};

bool fused_due(const struct simulation *s) {
    return s->scene->step.fused && !s->agree.signals.rebuild && !skin_nearly_due(s->search.skin, &s->classes);
}
