/* THE STEP. State at its start: positions x(n), velocities v(n-1/2), forces f(n).
 *
 *     servo      forces on walls summed over ranks, where a servo wants them
 *     advance    v(n+1/2) = v(n-1/2) + dt (f/m + g);  x(n+1) = x(n) + dt v(n+1/2);  forces to zero
 *     walls      walls move to n+1
 *     decide     is a rebuild due? (one reduction over ranks, where there are several)
 *     exchange   rebuild (rebuild.c), or new values for the copies
 *     contact    particle-particle forces, block by block
 *     wall       particle-wall forces, block by block
 *     finish     sums over threads, histories change places
 *     reverse    forces of copies go home (newton on, several ranks)
 *
 * The list is made once from the scene: what a scene does not need is not in it. */
#include "app/simulation.h"
#include <assert.h>
#include <math.h>
#include <omp.h>
#include <string.h>

static void servo_run(struct simulation *s) {
    double part[WALLS_MAX][6];
    walls_forces(s->walls, part);
    for (int w = 0; w < walls_count(s->walls); w++)
        memcpy(s->servo_force[w], part[w], sizeof s->servo_force[w]);
    comm_sum(s->comm, s->servo_force[0], 3 * walls_count(s->walls));
}

static void advance_run(struct simulation *s) {
    const struct pairlist *list = s->list;
#pragma omp parallel num_threads(list->threads)
    {
        int t = omp_get_thread_num();
        memset(s->speed[t], 0, sizeof s->speed[t]);
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
            const struct pair_block *block = &list->blocks[b];
            if (block->kind != PAIR_BLOCK_ROWS)
                continue;
            double v2 = integrator_advance(s->particles, &s->motion, block->first_row, block->last_row);
            if (!(v2 <= s->speed[t][block->size_class]))
                s->speed[t][block->size_class] = v2;
        }
    }
    s->particles->force_clear = true;
    s->step++;
    s->time = s->time_base + (double)(s->step - s->step_base) * s->dt;
}

static void walls_run(struct simulation *s) {
    double before = s->time_base + (double)(s->step - 1 - s->step_base) * s->dt;
    walls_advance(s->walls, before, s->dt, walls_have_servo(s->walls) ? s->servo_force : NULL);
}

/* Bounds of the displacements grow by the largest speeds; where they reach a skin, displacements are
 * measured. */
static void decide_skin(struct simulation *s) {
    double speed[CLASS_MAX] = {0};
    int classes = s->classes.count;
    for (int t = 0; t < s->threads; t++)
        for (int c = 0; c < classes; c++)
            speed[c] = fmax(speed[c], s->speed[t][c]);
    for (int c = 0; c < classes; c++)
        speed[c] = sqrt(speed[c]);
    skin_moved(s->skin, speed, classes, s->dt, s->walls ? walls_displacement(s->walls) : 0);
}

/* Makes bounds, signals and errors the same on all ranks. */
static void decide_agree(struct simulation *s) {
    double value[CLASS_MAX + 4];
    int n = s->classes.count;
    if (s->alone)
        return;
    memcpy(value, s->skin->bound, (size_t)n * sizeof *value);
    value[n] = s->signals.rebuild;
    value[n + 1] = s->signals.stop;
    value[n + 2] = s->signals.checkpoint;
    value[n + 3] = s->signals.error;
    comm_max(s->comm, value, n + 4);
    memcpy(s->skin->bound, value, (size_t)n * sizeof *value);
    s->signals.rebuild = value[n] > 0;
    s->signals.stop = value[n + 1] > 0;
    s->signals.checkpoint = value[n + 2] > 0;
    s->signals.error = value[n + 3] > 0;
    memcpy(s->skin->second, s->skin->bound, (size_t)n * sizeof *value);
}

static void decide_run(struct simulation *s) {
    decide_skin(s);
    decide_agree(s);
    s->signals.rebuild = s->signals.rebuild || sources_due(s);
    if (s->signals.rebuild || !skin_due(s->skin, &s->classes))
        return;
    skin_measure(s->skin, s->particles, s->classes.count);
    if (!s->alone) {
        comm_max(s->comm, s->skin->bound, s->classes.count);
        memcpy(s->skin->second, s->skin->bound, (size_t)s->classes.count * sizeof(double));
    }
    s->signals.rebuild = skin_due(s->skin, &s->classes);
}

static void exchange_run(struct simulation *s) {
    if (s->signals.rebuild) {
        rebuild_run(s);
        return;
    }
    if (s->alone)
        return;
    ghosts_forward_begin(s->ghosts, s->particles);
    ghosts_forward_end(s->ghosts, s->particles);
    size_t stride = (size_t)s->particles->force_stride;
    memset(s->particles->force + s->particles->owned * stride, 0,
           s->particles->ghosts * stride * sizeof(double));
}

static void contact_run(struct simulation *s) {
    s->particles->force_clear = false;
#pragma omp parallel num_threads(s->list->threads)
    {
        int t = omp_get_thread_num();
        for (int b = s->list->thread_block[t]; b < s->list->thread_block[t + 1]; b++)
            force_loop_block(s->loop, &s->contact, t, b);
    }
}

static void wall_run(struct simulation *s) {
    const struct pairlist *list = s->list;
#pragma omp parallel num_threads(list->threads)
    {
        int t = omp_get_thread_num();
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
            if (list->blocks[b].kind == PAIR_BLOCK_ROWS)
                walls_force_block(s->walls, &s->contact, t, list->blocks[b].first_row,
                                  list->blocks[b].last_row);
    }
}

static void finish_run(struct simulation *s) {
    s->sums = (struct force_sums){0};
    force_loop_finish(s->loop, &s->contact, &s->sums);
    if (s->walls)
        walls_finish(s->walls, &s->contact, &s->sums);
    s->dissipated += s->sums.dissipated;
    guards_check(s);
}

static void reverse_run(struct simulation *s) {
    ghosts_reverse(s->ghosts, s->particles);
}

static bool needs_servo(const struct simulation *s) {
    return s->walls && walls_have_servo(s->walls);
}
static bool needs_walls(const struct simulation *s) {
    return s->walls != NULL;
}
static bool needs_motion(const struct simulation *s) {
    return s->walls && walls_move(s->walls);
}
static bool needs_reverse(const struct simulation *s) {
    return !s->alone && s->view.newton;
}

static const struct step_pass step_passes[] = {
    {"servo", "a wall driven to a force", TIMER_COMM, needs_servo, servo_run},
    {"advance", NULL, TIMER_ADVANCE, NULL, advance_run},
    {"walls", "walls that move", TIMER_WALL, needs_motion, walls_run},
    {"decide", NULL, TIMER_DECIDE, NULL, decide_run},
    {"exchange", NULL, TIMER_COMM, NULL, exchange_run},
    {"contact", NULL, TIMER_CONTACT, NULL, contact_run},
    {"wall", "walls", TIMER_WALL, needs_walls, wall_run},
    {"finish", NULL, TIMER_CONTACT, NULL, finish_run},
    {"reverse", "newton on, several ranks", TIMER_COMM, needs_reverse, reverse_run},
};

enum { PASSES = sizeof step_passes / sizeof step_passes[0] };

void step_plan(struct simulation *s) {
    s->passes = 0;
    for (int p = 0; p < PASSES; p++)
        if (step_passes[p].needed == NULL || step_passes[p].needed(s))
            s->pass[s->passes++] = step_passes[p];
}

void step_plan_print(const struct simulation *s, FILE *file) {
    for (int p = 0; p < s->passes; p++)
        fprintf(file, "  %-10s %s%s\n", s->pass[p].name, s->pass[p].why ? "for " : "always",
                s->pass[p].why ? s->pass[p].why : "");
}

void step_run(struct simulation *s, bool rebuild) {
    s->signals.rebuild = rebuild;
    for (int p = 0; p < s->passes; p++) {
        timer_start(&s->timers, s->pass[p].stage);
        s->pass[p].run(s);
        timer_stop(&s->timers, s->pass[p].stage);
    }
}

void step_forces(struct simulation *s) {
    double dt = s->contact.dt;
    s->contact.dt = 0;
    timer_start(&s->timers, TIMER_CONTACT);
    contact_run(s);
    if (s->walls)
        wall_run(s);
    finish_run(s);
    timer_stop(&s->timers, TIMER_CONTACT);
    if (needs_reverse(s))
        reverse_run(s);
    s->contact.dt = dt;
}
