/* THE STEP. State at its start: positions x(n), velocities v(n-1/2), forces f(n).
 *
 * In plain order, pass after pass:
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
 * Fused, the particles of a block move just before the first pair that looks at them, while they are in the
 * cache:
 *
 *     servo, walls
 *     early      (several ranks) what others look at moves (pairs/sweep.h); values leave for the copies
 *     sweep      (one rank: early particles,) block by block: late ones move, then the block's forces
 *     receive    values arrive; meanwhile the ranks agree on bounds
 *     copies     forces of pairs with copies
 *     verify     did a particle leave its skin after all? Then forces are made anew after a rebuild
 *     wall, finish, reverse
 *
 * Both give the same bits. A step is fused unless a rebuild must come or is to be expected
 * (docs/architecture.md). The lists are made once from the scene: what a scene does not need is not in them.
 */
#include "engine/guards.h"
#include <assert.h>
#include <math.h>
#include <string.h>

static void servo_run(struct simulation *s) {
    double part[WALLS_MAX][6];
    walls_forces(s->walls, part);
    for (int w = 0; w < walls_count(s->walls); w++)
        memcpy(s->servo_force[w], part[w], sizeof s->servo_force[w]);
    comm_sum(s->comm, s->servo_force[0], 3 * walls_count(s->walls));
}

/* Moves a range of particles of one class. A speed that is no number stays: the guards look for it. */
static void advance(struct simulation *s, int thread, size_t first, size_t last, int size_class) {
    double v2 = integrator_advance(s->particles, &s->motion, first, last);
    double *largest = &s->speed[thread][size_class];
    if (!isnan(*largest) && !(v2 <= *largest))
        *largest = v2;
}

static void advance_run(struct simulation *s) {
    const struct pairlist *list = s->list;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < list->threads; t++) {
        memset(s->speed[t], 0, sizeof s->speed[t]);
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
            const struct pair_block *block = &list->blocks[b];
            if (block->kind == PAIR_BLOCK_ROWS)
                advance(s, t, block->first_row, block->last_row, block->size_class);
        }
    }
    s->particles->force_clear = true;
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

/* Bounds, signals and errors on their way to being the same on all ranks. */
static void agree_begin(struct simulation *s) {
    double *value = s->agreed;
    int n = s->classes.count;
    decide_skin(s);
    if (s->alone)
        return;
    memcpy(value, s->skin->bound, (size_t)n * sizeof *value);
    memcpy(value + n, s->skin->second, (size_t)n * sizeof *value);
    value[2 * n] = s->signals.rebuild;
    value[2 * n + 1] = s->signals.stop;
    value[2 * n + 2] = s->signals.checkpoint;
    value[2 * n + 3] = s->signals.error;
    comm_max_begin(s->comm, value, 2 * n + 4, &s->reduction);
}

static void agree_end(struct simulation *s) {
    const double *value = s->agreed;
    int n = s->classes.count;
    if (!s->alone) {
        comm_max_end(&s->reduction);
        memcpy(s->skin->bound, value, (size_t)n * sizeof *value);
        memcpy(s->skin->second, value + n, (size_t)n * sizeof *value);
        s->signals.rebuild = value[2 * n] > 0;
        s->signals.stop = value[2 * n + 1] > 0;
        s->signals.checkpoint = value[2 * n + 2] > 0;
        s->signals.error = value[2 * n + 3] > 0;
    }
    skin_settle(s->skin, n);
}

/* The two largest displacements of each class, on all ranks. */
static void measure_all(struct simulation *s) {
    double two[CLASS_MAX][2];
    int n = s->classes.count;
    skin_measure(s->skin, s->particles, n);
    for (int c = 0; c < n; c++) {
        two[c][0] = s->skin->bound[c];
        two[c][1] = s->skin->second[c];
    }
    comm_max_two(s->comm, two, n);
    for (int c = 0; c < n; c++) {
        s->skin->bound[c] = two[c][0];
        s->skin->second[c] = two[c][1];
    }
}

/* Where the bounds say that a rebuild may be due, displacements are measured. */
static void measure(struct simulation *s) {
    if (s->signals.rebuild || !skin_due(s->skin, &s->classes))
        return;
    s->signals.rebuild = skin_surely_due(s->skin, &s->classes);
    if (s->signals.rebuild)
        return;
    measure_all(s);
    s->signals.rebuild = skin_due(s->skin, &s->classes);
}

static void decide_run(struct simulation *s) {
    agree_begin(s);
    agree_end(s);
    measure(s);
}

/* Copies carry no force yet. */
static void copies_clear(struct simulation *s) {
    fields_clear_reverse(s->particles, s->particles->owned, s->particles->ghosts);
}

static void exchange_run(struct simulation *s) {
    if (s->signals.rebuild) {
        rebuild_run(s);
        return;
    }
    if (s->alone)
        return;
    struct field_list fields = fields_with(s->particles, FIELD_FORWARD);
    ghosts_forward_begin(s->ghosts, s->particles, &fields);
    ghosts_forward_end(s->ghosts, s->particles);
    copies_clear(s);
}

static void contact_run(struct simulation *s) {
    s->particles->force_clear = false;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->list->threads; t++)
        for (int b = s->list->thread_block[t]; b < s->list->thread_block[t + 1]; b++)
            force_loop_block(s->loop, &s->contact, t, b);
}

/* The early particles of a thread, before all others. */
static void early_move(struct simulation *s, int t) {
    const struct sweep_thread *plan = &s->sweep->thread[t];
    memset(s->speed[t], 0, sizeof s->speed[t]);
    for (size_t r = 0; r < plan->early_count; r++)
        advance(s, t, plan->early[r].first, plan->early[r].last, plan->early[r].size_class);
}

static void early_run(struct simulation *s) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        early_move(s, t);
    struct field_list fields = fields_with(s->particles, FIELD_FORWARD);
    ghosts_forward_begin(s->ghosts, s->particles, &fields);
}

/* The blocks of a thread: late particles move, then forces. */
static void late_sweep(struct simulation *s, int t) {
    const struct pairlist *list = s->list;
    const struct sweep_thread *plan = &s->sweep->thread[t];
    int first = list->thread_block[t];
    for (int b = first; b < list->thread_block[t + 1]; b++) {
        for (size_t r = plan->start[b - first]; r < plan->start[b - first + 1]; r++)
            advance(s, t, plan->late[r].first, plan->late[r].last, plan->late[r].size_class);
        if (s->alone || list->blocks[b].kind != PAIR_BLOCK_GHOST)
            force_loop_block(s->loop, &s->contact, t, b);
    }
}

static void sweep_run(struct simulation *s) {
#pragma omp parallel
    {
        if (s->alone) {
#pragma omp for schedule(static, 1)
            for (int t = 0; t < s->threads; t++)
                early_move(s, t);
        }
#pragma omp for schedule(static, 1) nowait
        for (int t = 0; t < s->threads; t++)
            late_sweep(s, t);
    }
    agree_begin(s);
}

static void receive_run(struct simulation *s) {
    ghosts_forward_end(s->ghosts, s->particles);
    copies_clear(s);
}

static void copies_run(struct simulation *s) {
    const struct pairlist *list = s->list;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        force_loop_block(s->loop, &s->contact, t, list->thread_block[t + 1] - 1);
}

static void verify_run(struct simulation *s) {
    agree_end(s);
    measure(s);
    if (!s->signals.rebuild)
        return;
    size_t doubles = (s->particles->owned + s->particles->ghosts) * (size_t)s->particles->force_stride;
    force_loop_abandon(s->loop, &s->contact);
    memset(s->particles->force, 0, doubles * sizeof(double));
    s->particles->force_clear = true;
    rebuild_run(s);
    contact_run(s);
}

static void wall_run(struct simulation *s) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < s->threads; t++)
        walls_force_share(s->walls, &s->contact, t);
}

/* Forces on walls summed without rounding: rank 0 gets those of all ranks. */
static void walls_agree(struct simulation *s) {
    int count;
    int64_t *words = walls_exact(s->walls, &count);
    if (!s->alone)
        comm_sum_int(s->comm, words, count);
    walls_close(s->walls, s->contact.dt, s->comm->rank == 0);
}

static void finish_run(struct simulation *s) {
    s->sums = (struct force_sums){0};
    force_loop_finish(s->loop, &s->contact, &s->sums);
    if (s->walls)
        walls_finish(s->walls, &s->contact, &s->sums);
    if (s->walls && s->scene->reproducible)
        walls_agree(s);
    s->taken += s->sums.taken;
    guards_check(s);
}

static void reverse_run(struct simulation *s) {
    struct field_list fields = fields_with(s->particles, FIELD_REVERSE);
    ghosts_reverse(s->ghosts, s->particles, &fields);
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

static bool needs_copies(const struct simulation *s) {
    return !s->alone;
}

static const struct step_pass plain_passes[] = {
    {"servo", "a wall driven to a force", TIMER_COMM, needs_servo, servo_run},
    {"advance", NULL, TIMER_ADVANCE, NULL, advance_run},
    {"walls", "walls that move", TIMER_WALL, needs_motion, walls_run},
    {"decide", NULL, TIMER_DECIDE, NULL, decide_run},
    {"exchange", NULL, TIMER_COMM, NULL, exchange_run},
    {"contact", NULL, TIMER_CONTACT, NULL, contact_run},
    {"wall", "walls", TIMER_WALL, needs_walls, wall_run},
    {"finish", NULL, TIMER_CONTACT, NULL, finish_run},
    {"reverse", "newton on, several ranks", TIMER_COMM, needs_reverse, reverse_run},
    {0},
};

static const struct step_pass fused_passes[] = {
    {"servo", "a wall driven to a force", TIMER_COMM, needs_servo, servo_run},
    {"walls", "walls that move", TIMER_WALL, needs_motion, walls_run},
    {"early", "several ranks", TIMER_ADVANCE, needs_copies, early_run},
    {"sweep", NULL, TIMER_SWEEP, NULL, sweep_run},
    {"receive", "several ranks", TIMER_COMM, needs_copies, receive_run},
    {"copies", "several ranks", TIMER_CONTACT, needs_copies, copies_run},
    {"verify", NULL, TIMER_DECIDE, NULL, verify_run},
    {"wall", "walls", TIMER_WALL, needs_walls, wall_run},
    {"finish", NULL, TIMER_CONTACT, NULL, finish_run},
    {"reverse", "newton on, several ranks", TIMER_COMM, needs_reverse, reverse_run},
    {0},
};

static void order_make(const struct simulation *s, const struct step_pass *all, struct step_order *order) {
    order->passes = 0;
    for (const struct step_pass *pass = all; pass->run; pass++)
        if (pass->needed == NULL || pass->needed(s))
            order->pass[order->passes++] = *pass;
}

void step_plan(struct simulation *s) {
    order_make(s, plain_passes, &s->plain);
    order_make(s, fused_passes, &s->fused);
}

static void order_print(const struct step_order *order, FILE *file) {
    for (int p = 0; p < order->passes; p++)
        fprintf(file, "  %-10s %s%s\n", order->pass[p].name, order->pass[p].why ? "for " : "always",
                order->pass[p].why ? order->pass[p].why : "");
}

void step_plan_print(const struct simulation *s, FILE *file) {
    if (s->scene->step.fused) {
        fprintf(file, " fused:\n");
        order_print(&s->fused, file);
        fprintf(file, " at rebuilds:\n");
    }
    order_print(&s->plain, file);
}

/* Seconds in the stages whose work is dealt out to threads and that wait for no other rank. */
static double work_seconds(const struct timers *timers) {
    return timers->seconds[TIMER_ADVANCE] + timers->seconds[TIMER_SWEEP] + timers->seconds[TIMER_CONTACT] +
           timers->seconds[TIMER_WALL];
}

void step_run(struct simulation *s, bool rebuild) {
    s->step++;
    s->time = s->time_base + (double)(s->step - s->step_base) * s->dt;
    s->signals.rebuild = rebuild || sources_due(s);
    bool fused = s->scene->step.fused && !s->signals.rebuild && !skin_nearly_due(s->skin, &s->classes);
    const struct step_order *order = fused ? &s->fused : &s->plain;
    if (fused)
        rebuild_plan(s);
    for (int p = 0; p < order->passes; p++) {
        timer_start(&s->timers, order->pass[p].stage);
        order->pass[p].run(s);
        timer_stop(&s->timers, order->pass[p].stage);
    }
    team_step(&s->team, s->timers.since, work_seconds(&s->timers));
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
