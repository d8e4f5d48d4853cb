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
 *     wall       particle-wall forces, each thread its share of the particles near walls
 *     caller     forces of a program that has the library (scree.h)
 *     finish     sums over threads, histories change places
 *     reverse    forces of copies are sent to the originals (newton on, several ranks)
 *
 * A box that moves adds the passes flow, box and stress. The passes of grains stand in physics/grains/grains_physics.c, the
 * engine's own below.
 *
 * The other order stands in fused.h, and gives the same bits: a step is fused unless a rebuild is due or to be expected. The
 * lists of passes are made once from the scene, without passes that the scene does not need.
 */
#include "engine/step.h"
#include "engine/fused.h"
#include "engine/decide.h"
#include "engine/values.h"
#include "engine/deform.h"
#include "engine/guards.h"
#include "engine/skin_auto.h"
#include "engine/stages.h"
#include "engine/sources.h"
#include "engine/rebuild.h"
#include <string.h>

static void exchange_run(struct simulation *s) {
    if (s->agree.signals.rebuild) {
        s->particles->force_clear = true;
        rebuild_run(s);
        s->particles->force_clear = false;
    } else if (!s->ranks.alone) {
        values_send(s->ranks.ghosts, s->particles);
        values_receive(s->ranks.ghosts, s->particles);
    }
}

static void reverse_run(struct simulation *s) {
    struct field_list fields = fields_with(s->particles, FIELD_REVERSE);
    ghosts_step_reverse(s->ranks.ghosts, s->particles, &fields);
}

static void flow_run(struct simulation *s) {
    deform_flow(&s->box, s->particles);
}

static void box_run(struct simulation *s) {
    deform_advance(&s->box, &s->search.interactions, &s->classes, &s->clock, &s->error);
}

static const struct engine_pass before_first[] = {{"flow", "a box that moves", "advance", NEED_BOX_MOTION,
                                                   flow_run},
                                                  {0}},
                                before_moved[] = {
                                    {"box", "a box that moves", "advance", NEED_BOX_MOTION, box_run}, {0}};

static const struct engine_pass renew[] = {
    {"decide", NULL, "decide", 0, decide_run}, {"exchange", NULL, "comm", 0, exchange_run}, {0}};

static void caller_run(struct simulation *s) {
    s->caller.force(s->caller.context, s);
}

static const struct engine_pass before_close[] = {
    {"caller", "a force of the calling program", "contact", NEED_CALLER, caller_run}, {0}};

static const struct engine_pass after_close[] = {
    {"reverse", "newton on, several ranks", "comm", NEED_RANKS | NEED_REVERSE, reverse_run},
    {"stress", "a box that follows its stress", "comm", NEED_STRESS, deform_control},
    {0}};

void step_plan(struct simulation *s) {
    static const struct engine_passes own = {.before = {[PASS_FIRST] = before_first,
                                                        [PASS_MOVED] = before_moved,
                                                        [PASS_CLOSE] = before_close,
                                                        [PASS_LOOK] = after_close},
                                             .renew = renew,
                                             .sweep = fused_sweep};
    const struct physics *physics[PHYSICS_ALL];
    for (int k = 0; k < s->physics.count; k++)
        physics[k] = s->physics.active[k].row;
    stages_register(&s->timers, physics, s->physics.count);
    unsigned holds = (s->ranks.alone ? 0 : NEED_RANKS) | (s->scene->ghosts.newton ? NEED_REVERSE : 0) |
                     (s->box.motion.moves ? NEED_BOX_MOTION : 0) | (s->servo.on ? NEED_STRESS : 0) |
                     (s->caller.force ? NEED_CALLER : 0);
    plan_make(&s->plan, &s->physics, &own, &s->timers, holds);
}

void step_plan_print(const struct step_plan *plan, bool fused, FILE *file) {
    if (fused) {
        fprintf(file, " fused; sweep: ");
        plan_print_visits(plan, file);
        fprintf(file, "\n");
        plan_print(&plan->fused, file);
        fprintf(file, " at rebuilds:\n");
    }
    plan_print(&plan->plain, file);
}

void step_run(struct simulation *s, bool rebuild) {
    s->clock.step++;
    s->clock.time = clock_time(&s->clock, s->clock.step);
    s->agree.signals.rebuild = rebuild || sources_due(&s->sources, s->scene, &s->clock) ||
                               physics_due(&s->physics) || skin_auto_due(s);
    physics_prepare(&s->physics);
    memset(s->search.speed, 0, (size_t)s->threads * sizeof *s->search.speed);
    bool fused = fused_due(s->scene->step.fused, &s->agree.signals, s->search.skin, &s->classes);
    plan_run(fused ? &s->plan.fused : &s->plan.plain, 0, &s->timers, s);
    guards_check(s);
    team_step(&s->team, s->timers.since, timer_sum(&s->timers, TIMER_WORK, TIMER_REBUILD));
}

void step_forces(struct simulation *s) {
    double dt = s->evaluation.dt;
    s->evaluation.dt = 0;
    physics_prepare(&s->physics);
    s->particles->force_clear = false;
    plan_run(&s->plan.plain, s->plan.forces, &s->timers, s);
    guards_check(s);
    s->evaluation.dt = dt;
    physics_prepare(&s->physics);
}
