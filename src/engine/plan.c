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

/* What a plan is made of. */
struct plan_source {
    const struct physics_set *set;
    const struct timers *timers;
    const struct simulation *simulation;
};

static void add_engine(struct plan *plan, const struct plan_source *from, const struct engine_pass *pass) {
    for (; pass && pass->run; pass++)
        if (pass->needed == NULL || pass->needed(from->simulation))
            add(plan, &(struct plan_pass){.name = pass->name,
                                          .why = pass->why,
                                          .timer = stages_find(from->timers, pass->timer),
                                          .run = pass->run});
}

static struct plan_pass entry_of(const struct plan_source *from, const struct physics_active *active,
                                 const struct physics_pass *pass) {
    const struct physics_set *set = from->set;
    assert(pass->block == NULL || active->row->search);
    return (struct plan_pass){.name = pass->name,
                              .why = pass->why,
                              .timer = stages_of_pass(from->timers, pass),
                              .pass = pass,
                              .context = &active->context,
                              .list = pass->rows ? set->active[0].context.list[0] : active->context.list[0],
                              .speed = set->speed};
}

/* Adds the passes of a place to the plan; passes that fit the visit go to `visit` instead. */
static void add_place(struct plan *plan, struct plan_visit *visit, const struct plan_source *from,
                      enum pass_place place) {
    const struct physics_set *set = from->set;
    for (int k = 0; k < set->count; k++)
        for (int p = 0; p < set->active[k].row->passes; p++) {
            const struct physics_active *active = &set->active[k];
            const struct physics_pass *pass = &active->row->pass[p];
            if (pass->place != place || (pass->needed && !pass->needed(&active->context)))
                continue;
            struct plan_pass entry = entry_of(from, active, pass);
            bool joins = visit && (place != PASS_PAIRS || entry.list == set->active[0].context.list[0]);
            if (joins)
                visit_add(visit, &entry);
            else
                add(plan, &entry);
        }
}

void plan_make(struct step_plan *plan, const struct physics_set *set, const struct engine_passes *engine,
               const struct timers *timers, const struct simulation *simulation) {
    const struct plan_source from = {set, timers, simulation};
    *plan = (struct step_plan){.moves.speed = set->speed};
    struct plan_visit *const visit[PASS_PLACES] = {[PASS_MOVE] = &plan->moves, [PASS_PAIRS] = &plan->pairs};
    for (enum pass_place place = PASS_FIRST; place < PASS_LOOK; place++) {
        add_engine(&plan->plain, &from, engine->before[place]);
        add_engine(&plan->fused, &from, engine->before[place]);
        if (place == PASS_PAIRS) {
            add_engine(&plan->plain, &from, engine->renew);
            add_engine(&plan->fused, &from, engine->sweep);
            plan->forces = plan->plain.passes;
        }
        add_place(&plan->plain, NULL, &from, place);
        add_place(&plan->fused, visit[place], &from, place);
    }
    add_engine(&plan->plain, &from, engine->before[PASS_LOOK]);
    add_engine(&plan->fused, &from, engine->before[PASS_LOOK]);
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

void plan_run(const struct plan *plan, int first, struct timers *timers, struct simulation *simulation) {
    for (int p = first; p < plan->passes; p++) {
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

void plan_print_visits(const struct step_plan *plan, FILE *file) {
    for (int p = 0; p < plan->moves.count; p++)
        fprintf(file, "%s%s", p > 0 ? ", " : "", plan->moves.pass[p].name);
    for (int p = 0; p < plan->pairs.count; p++)
        fprintf(file, "%s%s", p + plan->moves.count > 0 ? ", " : "", plan->pairs.pass[p].name);
}
