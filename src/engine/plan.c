/* SPDX-License-Identifier: BSD-3-Clause */
/* Merging passes into a plan, and running it. Read plan.h first. */
#include "engine/plan.h"
#include "engine/stages.h"
#include <assert.h>
#include <math.h>
#include <string.h>

static void visit_add(struct plan_visit *visit, const struct plan_pass *pass) {
    assert(visit->count < PLAN_PASSES_MAX);
    visit->pass[visit->count++] = *pass;
}

static void add(struct plan *plan, const struct plan_pass *pass) {
    assert(plan->passes < PLAN_PASSES_MAX);
    plan->pass[plan->passes++] = *pass;
}

static void add_engine(struct plan *plan, const struct engine_pass *pass, const struct timers *timers,
                       const struct simulation *simulation) {
    for (; pass && pass->run; pass++)
        if (pass->needed == NULL || pass->needed(simulation))
            add(plan, &(struct plan_pass){.name = pass->name,
                                          .why = pass->why,
                                          .timer = stages_find(timers, pass->timer),
                                          .run = pass->run});
}

static struct plan_pass entry_of(const struct physics_set *set, const struct physics_active *active,
                                 const struct physics_pass *pass, const struct timers *timers) {
    assert(pass->block == NULL || active->row->search);
    return (struct plan_pass){.name = pass->name,
                              .why = pass->why,
                              .timer = stages_of_pass(timers, pass),
                              .pass = pass,
                              .context = &active->context,
                              .list = pass->rows ? set->active[0].context.list[0] : active->context.list[0],
                              .speed = set->speed};
}

/* Adds the passes of a place to the plan; passes that fit the visit go to `visit` instead. */
static void add_place(struct plan *plan, struct plan_visit *visit, const struct physics_set *set,
                      const struct timers *timers, enum pass_place place) {
    for (int k = 0; k < set->count; k++)
        for (int p = 0; p < set->active[k].row->passes; p++) {
            const struct physics_active *active = &set->active[k];
            const struct physics_pass *pass = &active->row->pass[p];
            if (pass->place != place || (pass->needed && !pass->needed(&active->context)))
                continue;
            struct plan_pass entry = entry_of(set, active, pass, timers);
            bool joins = visit && (place != PASS_PAIRS || entry.list == set->active[0].context.list[0]);
            if (joins)
                visit_add(visit, &entry);
            else
                add(plan, &entry);
        }
}

/* True if one of the names in `a`, separated by blanks, is among those in `b`; NULL: no names. */
static bool share_names(const char *a, const char *b) {
    for (size_t n; a && b && *a; a += n + strspn(a + n, " ")) {
        n = strcspn(a, " ");
        for (const char *at = b; *at; at += strcspn(at, " "), at += strspn(at, " "))
            if (strcspn(at, " ") == n && strncmp(at, a, n) == 0)
                return true;
    }
    return false;
}

/* True if particles may move before the pass runs, as far as `moves` are concerned. */
static bool allows_moves(const struct physics_pass *pass, const struct plan_visit *moves) {
    for (int p = 0; p < moves->count; p++) {
        const struct physics_pass *move = moves->pass[p].pass;
        if (share_names(pass->writes, move->reads) || share_names(pass->writes, move->writes) ||
            share_names(pass->reads, move->writes))
            return false;
    }
    return true;
}

/* True if the passes of a step allow the ring order: those after the visit, and those before the moves, which in this
 * order come after the moves of the step before. */
static bool ring_fits(const struct physics_set *set, const struct plan_visit *moves) {
    for (int k = 0; k < set->count; k++)
        for (int p = 0; p < set->active[k].row->passes; p++) {
            const struct physics_active *active = &set->active[k];
            const struct physics_pass *pass = &active->row->pass[p];
            bool runs = pass->needed == NULL || pass->needed(&active->context);
            bool visit =
                pass->place == PASS_MOVE || pass->place == PASS_LOOK ||
                (pass->place == PASS_PAIRS && active->context.list[0] == set->active[0].context.list[0]);
            if (runs && !visit && !pass->at_end && !allows_moves(pass, moves))
                return false;
        }
    return true;
}

static void ring_make(struct step_plan *plan, const struct plan *alone, const struct physics_set *set,
                      const struct engine_passes *engine, const struct timers *timers,
                      const struct simulation *simulation) {
    add_engine(&plan->begin, engine->before_first, timers, simulation);
    add_place(&plan->begin, NULL, set, timers, PASS_FIRST);
    add_place(&plan->begin, NULL, set, timers, PASS_MOVE);
    add_engine(&plan->begin, engine->before_moved, timers, simulation);
    add_place(&plan->begin, NULL, set, timers, PASS_MOVED);
    add_engine(&plan->begin, engine->after_moved, timers, simulation);
    add_engine(&plan->go_on, engine->before_first, timers, simulation);
    add_place(&plan->go_on, NULL, set, timers, PASS_FIRST);
    add_engine(&plan->go_on, engine->before_moved, timers, simulation);
    add_place(&plan->go_on, NULL, set, timers, PASS_MOVED);
    add_engine(&plan->go_on, engine->after_moved, timers, simulation);
    add_engine(&plan->exchange, engine->renew, timers, simulation);
    if (!ring_fits(set, &plan->moves))
        return;
    add_engine(&plan->ring, engine->ring, timers, simulation);
    for (int p = 0; p < alone->passes; p++)
        add(&plan->ring, &alone->pass[p]);
    add_place(&plan->ring, NULL, set, timers, PASS_SHARES);
    add_place(&plan->ring, NULL, set, timers, PASS_CLOSE);
    add_engine(&plan->ring, engine->after_close, timers, simulation);
    add_engine(&plan->ring, engine->settle, timers, simulation);
}

void plan_make(struct step_plan *plan, const struct physics_set *set, const struct engine_passes *engine,
               const struct timers *timers, const struct simulation *simulation) {
    struct plan alone = {0};
    *plan = (struct step_plan){0};
    add_engine(&plan->plain, engine->before_first, timers, simulation);
    add_place(&plan->plain, NULL, set, timers, PASS_FIRST);
    add_place(&plan->plain, NULL, set, timers, PASS_MOVE);
    add_engine(&plan->plain, engine->before_moved, timers, simulation);
    add_place(&plan->plain, NULL, set, timers, PASS_MOVED);
    add_engine(&plan->plain, engine->after_moved, timers, simulation);
    add_engine(&plan->plain, engine->renew, timers, simulation);
    add_place(&plan->forces, NULL, set, timers, PASS_PAIRS);
    add_place(&plan->forces, NULL, set, timers, PASS_SHARES);
    add_engine(&plan->forces, engine->before_close, timers, simulation);
    add_place(&plan->forces, NULL, set, timers, PASS_CLOSE);
    add_engine(&plan->forces, engine->after_close, timers, simulation);
    for (int p = 0; p < plan->forces.passes; p++)
        add(&plan->plain, &plan->forces.pass[p]);

    add_engine(&plan->fused, engine->before_first, timers, simulation);
    add_place(&plan->fused, NULL, set, timers, PASS_FIRST);
    add_engine(&plan->fused, engine->before_moved, timers, simulation);
    add_place(&plan->fused, NULL, set, timers, PASS_MOVED);
    plan->moves.speed = set->speed;
    add_place(&plan->fused, &plan->moves, set, timers, PASS_MOVE);
    add_place(&alone, &plan->pairs, set, timers, PASS_PAIRS);
    add_engine(&plan->fused, engine->sweep, timers, simulation);
    for (int p = 0; p < alone.passes; p++)
        add(&plan->fused, &alone.pass[p]);
    add_place(&plan->fused, NULL, set, timers, PASS_SHARES);
    add_engine(&plan->fused, engine->before_close, timers, simulation);
    add_place(&plan->fused, NULL, set, timers, PASS_CLOSE);
    add_engine(&plan->fused, engine->after_close, timers, simulation);
    ring_make(plan, &alone, set, engine, timers, simulation);
}

void plan_move(const struct plan_visit *moves, int thread, size_t first, size_t last, int size_class) {
    double *largest = &moves->speed[thread][size_class];
    for (int p = 0; p < moves->count; p++) {
        double v2 = moves->pass[p].pass->rows(moves->pass[p].context, thread, first, last, size_class);
        /* what is no number is kept, so that the guards find it */
        if (!isnan(*largest) && !(v2 <= *largest))
            *largest = v2;
    }
}

void plan_block(const struct plan_visit *pairs, int thread, int block) {
    for (int p = 0; p < pairs->count; p++)
        pairs->pass[p].pass->block(pairs->pass[p].context, thread, block);
}

void plan_move_all(const struct plan_visit *moves, const struct pairlist *list) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < list->threads; t++)
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
            const struct pair_block *block = &list->blocks[b];
            if (block->kind == PAIR_BLOCK_ROWS)
                plan_move(moves, t, block->first_row, block->last_row, block->size_class);
        }
}

void plan_block_all(const struct plan_visit *pairs, const struct pairlist *list) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < list->threads; t++)
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
            plan_block(pairs, t, b);
}

void plan_abandon(const struct plan_visit *pairs) {
    for (int p = 0; p < pairs->count; p++)
        if (pairs->pass[p].pass->abandon)
            pairs->pass[p].pass->abandon(pairs->pass[p].context);
}

static void pass_run(const struct plan_pass *entry, struct simulation *simulation) {
    const struct physics_pass *pass = entry->pass;
    const struct physics_context *context = entry->context;
    if (entry->run) {
        entry->run(simulation);
    } else if (pass->whole) {
        pass->whole(context);
    } else if (pass->share) {
#pragma omp parallel for schedule(static, 1)
        for (int t = 0; t < context->threads; t++)
            pass->share(context, t);
    } else {
        struct plan_visit one = {.count = 1, .speed = entry->speed, .pass = {*entry}};
        if (pass->rows)
            plan_move_all(&one, entry->list);
        else
            plan_block_all(&one, entry->list);
    }
}

void plan_run(const struct plan *plan, struct timers *timers, struct simulation *simulation) {
    for (int p = 0; p < plan->passes; p++) {
        timer_start(timers, plan->pass[p].timer);
        pass_run(&plan->pass[p], simulation);
        timer_stop(timers, plan->pass[p].timer);
    }
}

void plan_print(const struct plan *plan, FILE *file) {
    for (int p = 0; p < plan->passes; p++) {
        const struct plan_pass *entry = &plan->pass[p];
        fprintf(file, "  %-10s %s%s", entry->name, entry->why ? "for " : "always",
                entry->why ? entry->why : "");
        if (entry->pass && entry->pass->reads)
            fprintf(file, "; reads %s", entry->pass->reads);
        if (entry->pass && entry->pass->writes)
            fprintf(file, "; writes %s", entry->pass->writes);
        fprintf(file, "\n");
    }
}

void plan_print_visits(const struct plan_visit *first, const struct plan_visit *second, FILE *file) {
    const char *separator = "";
    for (int p = 0; p < first->count + second->count; p++) {
        const struct plan_pass *pass = p < first->count ? &first->pass[p] : &second->pass[p - first->count];
        fprintf(file, "%s%s", separator, pass->name);
        separator = ", ";
    }
}
