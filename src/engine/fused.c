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
static void early_move(const struct sweep *sweep, const struct plan_visit *moves, int t) {
    const struct sweep_thread *plan = &sweep->thread[t];
    for (size_t r = 0; r < plan->early_count; r++)
        plan_move(moves, t, plan->early[r].first, plan->early[r].last, plan->early[r].size_class);
}

static void early_run(struct simulation *s) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        early_move(s->search.sweep, &s->plan.moves, t);
    values_send(s->ranks.ghosts, s->particles);
}

/* Computes the blocks of a thread: late particles move, then forces. */
static void late_sweep(const struct search *search, const struct step_plan *visits, bool alone, int t) {
    const struct pairlist *list = search->list;
    const struct sweep_thread *plan = &search->sweep->thread[t];
    int first = list->thread_block[t];
    for (int b = first; b < list->thread_block[t + 1]; b++) {
        for (size_t r = plan->start[b - first]; r < plan->start[b - first + 1]; r++)
            plan_move(&visits->moves, t, plan->late[r].first, plan->late[r].last, plan->late[r].size_class);
        if (alone || list->blocks[b].kind != PAIR_BLOCK_GHOST)
            plan_block(&visits->pairs, t, b);
    }
}

static void sweep_run(struct simulation *s) {
#pragma omp parallel
    {
        if (s->ranks.alone) {
#pragma omp for schedule(static, 1)
            for (int t = 0; t < s->threads; t++)
                early_move(s->search.sweep, &s->plan.moves, t);
        }
#pragma omp for schedule(static, 1) nowait
        for (int t = 0; t < s->threads; t++)
            late_sweep(&s->search, &s->plan, s->ranks.alone, t);
    }
    decide_begin(s);
}

static void receive_run(struct simulation *s) {
    values_receive(s->ranks.ghosts, s->particles);
}

static void copies_run(struct simulation *s) {
    const struct pairlist *list = s->search.list;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        plan_block(&s->plan.pairs, t, list->thread_block[t + 1] - 1);
}

static void verify_run(struct simulation *s) {
    decide_end(&s->agree, s->search.skin, s->classes.count, s->ranks.alone);
    decide_measure(&s->agree, s->search.skin, s->particles, &s->classes, s->comm);
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

const struct engine_pass fused_sweep[] = {{"plan", "new pairs", "pairs", 0, plan_sweep},
                                          {"early", "several ranks", "advance", NEED_RANKS, early_run},
                                          {"sweep", NULL, "sweep", 0, sweep_run},
                                          {"receive", "several ranks", "comm", NEED_RANKS, receive_run},
                                          {"copies", "several ranks", "contact", NEED_RANKS, copies_run},
                                          {"verify", NULL, "decide", 0, verify_run},
                                          {0}};

bool fused_due(bool fused, const struct step_signals *signals, const struct skin *skin,
               const struct size_classes *classes) {
    return fused && !signals->rebuild && !skin_nearly_due(skin, classes);
}
