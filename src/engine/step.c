/* SPDX-License-Identifier: BSD-3-Clause */
/* THE STEP. State at its start: positions x(n), velocities v(n-1/2), forces f(n).
 *
 * In plain order, pass after pass:
 *
 *     servo      forces on walls summed over ranks, if a servo needs the sums
 *     advance    v(n+1/2) = v(n-1/2) + dt (f/m + g);  x(n+1) = x(n) + dt v(n+1/2);  forces to zero
 *     walls      walls move to n+1
 *     decide     whether a rebuild is due (one reduction, with several ranks)
 *     exchange   rebuild (rebuild.c), or new values for the copies
 *     contact    particle-particle forces, block by block
 *     wall       particle-wall forces, block by block
 *     caller     forces of a program that has the library (scree.h)
 *     finish     sums over threads, histories change places
 *     reverse    forces of copies are sent to the originals (newton on, several ranks)
 *
 * In fused order the particles of a block move just before the first pair that reads the particles, while
 * they are in the cache:
 *
 *     servo, walls
 *     early      (several ranks) particles that others read move (pairs/sweep.h); values leave for copies
 *     sweep      (one rank: early particles,) block by block: late particles move, then the block's forces
 *     receive    values arrive; meanwhile the ranks agree on bounds
 *     copies     forces of pairs with copies
 *     verify     if a particle has left its skin: rebuild, and compute the forces again
 *     wall, caller, finish, reverse
 *
 * In ring order, for steps after which nobody looks, particles come moved from the step before, or move first, and the
 * particles of a block move on to n+1 as soon as all their forces are there (pairs/ring.h):
 *
 *     servo, advance (only after a step in another order), walls, decide
 *     exchange   rebuild, or values leave for copies
 *     ring       block by block: forces, then the particles of which this was the last block move
 *     receive    values arrive
 *     copies     forces of pairs with copies, then the particles that waited for these move
 *     wall, finish, reverse
 *     settle     particles that others read, and those at walls, move
 *
 * All orders give the same bits. A step is fused unless a rebuild is due or to be expected
 * (docs/architecture.md). The lists of passes are made once from the scene, without passes that the scene
 * does not need.
 */
#include "engine/step.h"
#include "engine/decide.h"
#include "engine/deform.h"
#include "engine/guards.h"
#include "engine/skin_auto.h"
#include "engine/stages.h"
#include "engine/sources.h"
#include "engine/rebuild.h"
#include <assert.h>
#include <string.h>

/* Sets the forces of copies to zero. */
static void copies_clear(struct simulation *s) {
    fields_clear_reverse(s->particles, s->particles->owned, s->particles->ghosts);
}

static void values_send(struct simulation *s) {
    struct field_list fields = fields_with(s->particles, FIELD_FORWARD);
    ghosts_step_begin(s->ranks.ghosts, s->particles, &fields);
}

static void receive_run(struct simulation *s) {
    ghosts_forward_end(s->ranks.ghosts, s->particles);
    copies_clear(s);
}

static void exchange_run(struct simulation *s) {
    if (s->agree.signals.rebuild) {
        s->particles->force_clear = true;
        rebuild_run(s);
        s->particles->force_clear = false;
    } else if (!s->ranks.alone) {
        values_send(s);
        receive_run(s);
    }
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

/* Computes one block of a thread; then the particles move for which this was the last. */
static void ring_block(struct simulation *s, int t, int b) {
    const struct ring_thread *plan = &s->search.ring->thread[t];
    int number = b - s->search.list->thread_block[t];
    plan_block(&s->plan.pairs, t, b);
    for (size_t r = plan->start[number]; r < plan->start[number + 1]; r++)
        plan_move(&s->plan.moves, t, plan->range[r].first, plan->range[r].last, plan->range[r].size_class);
}

static void ring_run(struct simulation *s) {
    const struct pairlist *list = s->search.list;
    memset(s->search.speed, 0, (size_t)s->threads * sizeof *s->search.speed);
    s->evaluation.ring = s->search.ring;
    physics_prepare(&s->physics);
    s->ahead = true;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
            if (s->ranks.alone || list->blocks[b].kind != PAIR_BLOCK_GHOST)
                ring_block(s, t, b);
}

/* After a rebuild the copies are new. */
static void ring_receive(struct simulation *s) {
    if (!s->agree.signals.rebuild)
        receive_run(s);
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

static void reverse_run(struct simulation *s) {
    struct field_list fields = fields_with(s->particles, FIELD_REVERSE);
    ghosts_step_reverse(s->ranks.ghosts, s->particles, &fields);
}

static bool needs_box(const struct simulation *s) {
    return s->box.motion.moves;
}

static bool needs_stress(const struct simulation *s) {
    return s->servo.on;
}

static bool needs_reverse(const struct simulation *s) {
    return !s->ranks.alone && s->scene->ghosts.newton;
}

static bool needs_copies(const struct simulation *s) {
    return !s->ranks.alone;
}

static const struct engine_pass first[] = {{"flow", "a box that moves", "advance", needs_box, deform_flow},
                                           {0}},
                                moving[] = {{"box", "a box that moves", "advance", needs_box, deform_advance},
                                            {0}};

static const struct engine_pass moved[] = {{"decide", NULL, "decide", NULL, decide_run}, {0}},
                                renew[] = {{"exchange", NULL, "comm", NULL, exchange_run}, {0}};

static const struct engine_pass ring[] = {{"ring", NULL, "sweep", NULL, ring_run},
                                          {"receive", "several ranks", "comm", needs_copies, ring_receive},
                                          {"copies", "several ranks", "contact", needs_copies, ring_copies},
                                          {0}},
                                settle[] = {{"settle", NULL, "advance", NULL, settle_run}, {0}};

static const struct engine_pass sweep[] = {{"early", "several ranks", "advance", needs_copies, early_run},
                                           {"sweep", NULL, "sweep", NULL, sweep_run},
                                           {"receive", "several ranks", "comm", needs_copies, receive_run},
                                           {"copies", "several ranks", "contact", needs_copies, copies_run},
                                           {"verify", NULL, "decide", NULL, verify_run},
                                           {0}};

static void caller_run(struct simulation *s) {
    s->caller.force(s->caller.context, s);
}

static bool has_caller(const struct simulation *s) {
    return s->caller.force != NULL;
}

static const struct engine_pass shared[] = {
    {"caller", "a force of the calling program", "contact", has_caller, caller_run}, {0}};

static const struct engine_pass paired[] = {
    {"stress", "a box that follows its stress", "comm", needs_stress, deform_control},
    {"reverse", "newton on, several ranks", "comm", needs_reverse, reverse_run},
    {0}};

/* Reproducible sums wait for all shares; a skin that the run chooses looks at particles between steps. */
static bool ring_wanted(const struct simulation *s) {
    return s->plan.ring.passes > 0 && s->scene->step.fused && !s->scene->reproducible &&
           !s->scene->classes.skin_auto && !s->box.motion.moves && !s->caller.force;
}

void step_plan(struct simulation *s) {
    static const struct engine_passes own = {.first = first,
                                             .moving = moving,
                                             .moved = moved,
                                             .renew = renew,
                                             .shared = shared,
                                             .paired = paired,
                                             .sweep = sweep,
                                             .ring = ring,
                                             .settle = settle};
    const struct physics *physics[PHYSICS_ALL];
    for (int k = 0; k < s->physics.count; k++)
        physics[k] = s->physics.active[k].row;
    stages_register(&s->timers, physics, s->physics.count);
    plan_make(&s->plan, &s->physics, &own, &s->timers, s);
    s->search.ring = ring_wanted(s) ? ring_create(s->threads) : NULL;
}

void step_plan_print(const struct simulation *s, FILE *file) {
    if (s->scene->step.fused) {
        fprintf(file, " fused; sweep: ");
        plan_print_visits(&s->plan.moves, &s->plan.pairs, file);
        fprintf(file, "\n");
        plan_print(&s->plan.fused, file);
        if (s->search.ring) {
            fprintf(file, " steps after which nobody looks; ring: ");
            plan_print_visits(&s->plan.pairs, &s->plan.moves, file);
            fprintf(file, "\n");
            plan_print(&s->plan.go_on, file);
            plan_print(&s->plan.exchange, file);
            plan_print(&s->plan.ring, file);
        }
        fprintf(file, " at rebuilds:\n");
    }
    plan_print(&s->plan.plain, file);
    fprintf(file, "\npasses of a rebuild\n");
    rebuild_print(s, file);
}

/* False if the plan says that most of the ring's gain would be lost (rebuild_plan); before a new plan is made, true.
 * Several ranks agree on this at a rebuild. */
static bool ring_pays(const struct simulation *s) {
    if (!s->ranks.alone)
        return s->search.ring_agreed;
    return s->search.ring && (s->search.sweep->stale || s->search.ring->sweep);
}

/* True if this step takes the way of the ring order. The order of messages and reductions differs between that way and
 * the fused order, so all ranks go the same way, whether or not their particles have moved ahead. */
static bool ring_due(const struct simulation *s, bool unseen) {
    bool before = s->ranks.alone ? s->ahead : s->search.ring_before;
    return ring_pays(s) && (unseen || before);
}

/* The rest of a step in ring order, or, where the state at its end will be looked at, in plain order. */
static void ring_step(struct simulation *s, bool unseen) {
    plan_run(s->ahead ? &s->plan.go_on : &s->plan.begin, &s->timers, s);
    s->ahead = false;
    unseen = unseen && !s->agree.signals.error && guards_calm(s);
    bool rebuild = s->agree.signals.rebuild;
    if (rebuild)
        plan_run(&s->plan.exchange, &s->timers, s);
    unseen = unseen && s->error.kind == ERROR_NONE && s->sources.last_step != s->clock.step;
    if (unseen)
        rebuild_plan(s);
    unseen = unseen && ring_pays(s);
    if (!rebuild && !unseen)
        plan_run(&s->plan.exchange, &s->timers, s);
    else if (!rebuild && !s->ranks.alone)
        values_send(s);
    plan_run(unseen ? &s->plan.ring : &s->plan.forces, &s->timers, s);
}

void step_run(struct simulation *s, bool rebuild, bool unseen) {
    s->clock.step++;
    s->clock.time = s->clock.time_base + (double)(s->clock.step - s->clock.step_base) * s->clock.dt;
    s->agree.signals.rebuild = rebuild || sources_due(s) || physics_due(&s->physics) || skin_auto_due(s);
    physics_prepare(&s->physics);
    if (!s->ahead)
        memset(s->search.speed, 0, (size_t)s->threads * sizeof *s->search.speed);
    bool fused =
        s->scene->step.fused && !s->agree.signals.rebuild && !skin_nearly_due(s->search.skin, &s->classes);
    bool in_ring = ring_due(s, unseen);
    s->search.ring_before = in_ring && unseen;
    assert(in_ring || !s->ahead);
    if (in_ring) {
        ring_step(s, unseen);
    } else {
        if (fused)
            rebuild_plan(s);
        plan_run(fused ? &s->plan.fused : &s->plan.plain, &s->timers, s);
    }
    guards_check(s);
    team_step(&s->team, s->timers.since, timer_sum(&s->timers, TIMER_WORK, TIMER_REBUILD));
}

void step_forces(struct simulation *s) {
    double dt = s->evaluation.dt;
    s->evaluation.dt = 0;
    physics_prepare(&s->physics);
    s->particles->force_clear = false;
    plan_run(&s->plan.forces, &s->timers, s);
    guards_check(s);
    s->evaluation.dt = dt;
    physics_prepare(&s->physics);
}
