/* SPDX-License-Identifier: BSD-3-Clause */
/* Steps of Newton's method. Read newton.h first. */
#include "physics/hard/newton.h"
#include "base/memory.h"
#include <string.h>

enum {
    SIX = 6,
    ITERATIONS_MOST = 200,
    SMOOTH_SWEEPS = 10,
    SMOOTH_MOST = 160,
    FAILED_STEPS = 3,
    BARE_STEPS = 6
};

/* A step must leave less than this part of the miss, or sweeps follow, each time twice as many. Behind FAILED_STEPS of such steps
 * BARE_STEPS go without, and so on in turns. */
static const double progress = 0.5;

/* Tolerance of the linear systems: stiff rows enlarge what is left. */
static const double linear = 1e-4;

void hard_newton_renew(struct hard_newton *newton) {
    solve_destroy(&newton->system);
}

void hard_newton_free(struct hard_newton *newton) {
    hard_newton_renew(newton);
    solve_end(&newton->solve, NULL, 0);
    hard_blocks_free(&newton->blocks);
    memory_free(newton->row);
    memory_free(newton->free);
    memory_free(newton->root);
    memory_free(newton->y);

    memory_free(newton->right);
    memory_free(newton->step);
    memory_free(newton->way);
    memory_free(newton->sum);
    *newton = (struct hard_newton){0};
}

static void *grow(void *array, size_t *room, size_t count) {
    return hard_problem_grow(array, room, count, sizeof(double[SIX]));
}

void hard_newton_begin(struct hard_newton *newton, struct hard_problem *problem, struct hard_border *border,
                       size_t bodies) {
    newton->problem = problem;
    newton->border = border;
    newton->bodies = bodies;
    newton->free = hard_problem_grow(newton->free, &newton->free_room, bodies, sizeof *newton->free);
    memcpy(newton->free, problem->body, bodies * sizeof *newton->free);
}

static void rooms_make(struct hard_newton *newton) {
    size_t own = newton->bodies, all = newton->problem->bodies;
    newton->y = grow(newton->y, &newton->own_room[0], own);

    newton->right = grow(newton->right, &newton->own_room[1], own);
    newton->step = grow(newton->step, &newton->own_room[2], own);
    newton->way = grow(newton->way, &newton->all_room[0], all);
    newton->sum = grow(newton->sum, &newton->all_room[1], all);
    newton->row =
        hard_problem_grow(newton->row, &newton->row_room, newton->problem->rows, sizeof *newton->row);
}

/* The roots of all bodies, where some are no spheres. */
static void roots_make(struct hard_newton *newton) {
    int32_t count = hard_clumps_count(newton->clumps);
    size_t all = newton->problem->bodies;
    if (count == 0)
        return;
    newton->root = grow(newton->root, &newton->all_room[2], all);
    for (size_t k = 0; k < all; k++)
        memcpy(newton->root[k], hard_root_sphere, sizeof hard_root_sphere);
    for (int32_t b = 0; b < count; b++) {
        uint32_t k;
        const double *turn = hard_clumps_at(newton->clumps, b, &k);
        hard_root_make(turn, newton->root[k]);
    }
}

/* The root of the inverse inertia of a body. */
static const double *root_of(const struct hard_newton *newton, size_t k) {
    return hard_root_at((const double(*)[HARD_ROOT])newton->root, k);
}

static void sum_pulls(void *context, size_t row, size_t end) {
    const struct hard_newton *newton = context;
    for (size_t r = row; r < end; r++) {
        const struct hard_row *contact = &newton->problem->row[r];
        double impulse[3];
        for (int d = 0; d < 3; d++)
            impulse[d] = contact->p * contact->normal[d] + contact->q[d];
        hard_scatter(newton->sum, contact, impulse);
    }
}

static void sum_answers(void *context, size_t row, size_t end) {
    const struct hard_newton *newton = context;
    for (size_t r = row; r < end; r++) {
        const struct hard_row *contact = &newton->problem->row[r];
        double du[3], impulse[3];
        hard_gather((const double(*)[SIX])newton->way, contact, du);
        hard_newton_answer(contact, &newton->row[r], du, impulse);
        hard_scatter(newton->sum, contact, impulse);
    }
}

/* The sum over rows of what `visit` scatters, times St, for owned bodies. */
static void pulls(struct hard_newton *newton, void (*visit)(void *, size_t, size_t), double (*out)[SIX]) {
    memset(newton->sum, 0, newton->problem->bodies * sizeof *newton->sum);
    hard_problem_visit(newton->problem, visit, newton);
    hard_border_collect(newton->border, newton->sum);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < newton->bodies; k++)
        hard_root_back(&newton->problem->body[k], root_of(newton, k), newton->sum[k], out[k]);
}

/* S x as velocities of all bodies. */
static void spread(struct hard_newton *newton, const double (*x)[SIX]) {
    size_t own = newton->bodies;
    memset(newton->way[own], 0, (newton->problem->bodies - own) * sizeof *newton->way);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < own; k++)
        hard_root_times(&newton->problem->body[k], root_of(newton, k), x[k], newton->way[k]);
    hard_border_spread(newton->border, newton->way);
}

static void multiply(void *context, const double *x, double *y) {
    struct hard_newton *newton = context;
    spread(newton, (const double(*)[SIX])x);
    pulls(newton, sum_answers, (double(*)[SIX])y);
    for (size_t k = 0; k < SIX * newton->bodies; k++)
        y[k] += x[k];
}

static void precondition(void *context, const double *r, double *z) {
    const struct hard_newton *newton = context;
    hard_blocks_solve(&newton->blocks, (const double(*)[SIX])r, (double(*)[SIX])z);
}

/* The linear solver for the present number of bodies. */
static void system_make(struct hard_newton *newton) {
    struct solve_options options = solve_options_regular("contacts_");
    const struct solve_free work = {.count = (int32_t)(SIX * newton->bodies),
                                    .context = newton,
                                    .multiply = multiply,
                                    .precondition = precondition};
    struct error error = {0};
    options.method = "gmres";
    options.preconditioner = "none";
    options.iterations = options.restart = ITERATIONS_MOST;
    if (newton->solve == NULL)
        newton->solve = solve_begin(newton->comm, NULL, &error);
    if (newton->solve && newton->system == NULL)
        newton->system = solve_create_free(newton->solve, &work, &options, &error);
    if (newton->system == NULL)
        error_fatal("%s", error.text);
}

static void keep_all(void *context, size_t row, size_t end) {
    const struct hard_newton *newton = context;
    for (size_t r = row; r < end; r++) {
        const struct hard_row *contact = &newton->problem->row[r];
        double *kept = newton->row[r].kept;
        kept[0] = contact->p;
        memcpy(kept + 1, contact->q, sizeof contact->q);
        kept[4] = contact->deep;
    }
}

static void return_all(void *context, size_t row, size_t end) {
    const struct hard_newton *newton = context;
    for (size_t r = row; r < end; r++) {
        struct hard_row *contact = &newton->problem->row[r];
        const double *kept = newton->row[r].kept;
        contact->p = kept[0];
        memcpy(contact->q, kept + 1, sizeof contact->q);
        contact->deep = kept[4];
    }
}

/* What a visit of each row would make of it: impulse and velocity then, and the derivative there. */
static void plan_all(void *context, size_t row, size_t end) {
    const struct hard_newton *newton = context;
    for (size_t r = row; r < end; r++) {
        struct hard_row *contact = &newton->problem->row[r];
        const struct hard_body *a = &newton->problem->body[contact->body[0]],
                               *b = &newton->problem->body[contact->body[1]];
        hard_newton_plan(contact, &newton->row[r], newton->problem->dt, a, b);
    }
}

static void sum_leads(void *context, size_t row, size_t end) {
    const struct hard_newton *newton = context;
    for (size_t r = row; r < end; r++)
        hard_scatter(newton->sum, &newton->problem->row[r], newton->row[r].lead);
}

/* The impulses after the step. */
static void go_all(void *context, size_t row, size_t end) {
    const struct hard_newton *newton = context;
    for (size_t r = row; r < end; r++) {
        struct hard_row *contact = &newton->problem->row[r];
        double du[3], back[3];
        hard_gather((const double(*)[SIX])newton->way, contact, du);
        hard_newton_answer(contact, &newton->row[r], du, back);
        for (int d = 0; d < 3; d++)
            contact->q[d] = newton->row[r].lead[d] - back[d];
        contact->p = vector_dot(contact->q, contact->normal);
        for (int d = 0; d < 3; d++)
            contact->q[d] -= contact->p * contact->normal[d];
    }
}

/* The velocities of all bodies by V* + S x. */
static void bodies_set(struct hard_newton *newton, const double (*x)[SIX]) {
    struct hard_body *body = newton->problem->body;
    for (size_t k = 0; k < newton->bodies; k++) {
        double way[SIX];
        hard_root_times(&body[k], root_of(newton, k), x[k], way);
        for (int d = 0; d < 3; d++) {
            body[k].v[d] = newton->free[k].v[d] + way[d];
            body[k].w[d] = newton->free[k].w[d] + way[3 + d];
        }
    }
    hard_border_send(newton->border, newton->problem);
}

/* The velocities that belong to the impulses of the rows, their miss, and the residual. */
static double settle(struct hard_newton *newton) {
    double sum[3];
    pulls(newton, sum_pulls, newton->y);
    bodies_set(newton, (const double(*)[SIX])newton->y);
    hard_problem_residual(newton->problem, sum);
    comm_sum(newton->comm, sum, 3);
    double most = fmax(sum[1], sum[2]);
    newton->miss = sqrt(sum[0]);
    return most > 0.0 ? sqrt(sum[0] / most) : 0.0;
}

/* Sweeps of Gauss and Seidel. */
static void smooth(struct hard_newton *newton, int sweeps) {
    for (int k = 0; k < sweeps; k++)
        hard_border_turns(newton->border, newton->problem, hard_problem_sweep);
}

/* A step of the method; returns the iterations of its linear solver. */
static int step(struct hard_newton *newton) {
    hard_problem_visit(newton->problem, plan_all, newton);
    pulls(newton, sum_leads, newton->right);
    for (size_t k = 0; k < newton->bodies; k++)
        for (int d = 0; d < SIX; d++)
            newton->right[k][d] -= newton->y[k][d];
    newton->blocks.root = (const double(*)[HARD_ROOT])newton->root;
    hard_blocks_make(&newton->blocks, newton->problem, newton->row, newton->border);
    solve_solve(newton->system, (double *)newton->right, (double *)newton->step, false);
    spread(newton, (const double(*)[SIX])newton->step);
    hard_problem_visit(newton->problem, go_all, newton);
    return solve_report(newton->system)->iterations;
}

static void begin(struct hard_newton *newton) {
    rooms_make(newton);
    roots_make(newton);
    system_make(newton);
    solve_tolerance(newton->system, linear);
    hard_blocks_shape(&newton->blocks, newton->problem, newton->bodies);
    hard_problem_visit(newton->problem, keep_all, newton);
    settle(newton);
}

/* The course of the method: the least miss of all, with its residual, whose impulses the rows keep; sweeps of the next time; steps that have
 * failed, and steps that go without sweeps. */
struct course {
    double best, residual;
    int sweeps, failed, bare;
};

static void best_keep(struct hard_newton *newton, struct course *course, double residual) {
    if (!(newton->miss < course->best))
        return;
    hard_problem_visit(newton->problem, keep_all, newton);
    course->best = newton->miss;
    course->residual = residual;
}

/* The impulses of the least miss; returns their residual. */
static double best_take(struct hard_newton *newton, const struct course *course) {
    hard_problem_visit(newton->problem, return_all, newton);
    settle(newton);
    return course->residual;
}

/* Sweeps behind a step that has failed; returns the residual then. */
static double sweeps_follow(struct hard_newton *newton, struct course *course) {
    smooth(newton, course->sweeps);
    double residual = settle(newton);
    best_keep(newton, course, residual);
    course->sweeps = 2 * course->sweeps > SMOOTH_MOST ? SMOOTH_MOST : 2 * course->sweeps;
    course->bare = ++course->failed % FAILED_STEPS == 0 ? BARE_STEPS : 0;
    return residual;
}

/* Behind a step without sweeps: the last of them goes back to the least miss. Returns the residual then. */
static double bare_end(struct hard_newton *newton, struct course *course, double residual) {
    if (--course->bare > 0 || newton->miss <= course->best)
        return residual;
    return best_take(newton, course);
}

struct hard_newton_result hard_newton_solve(struct hard_newton *newton,
                                            const struct hard_newton_limits *limits) {
    struct hard_newton_result result = {.residual = limits->begin};
    begin(newton);
    struct course course = {newton->miss, limits->begin, SMOOTH_SWEEPS, 0, 0};
    while (result.steps < limits->steps && (result.steps == 0 || result.residual > limits->tolerance)) {
        double before = newton->miss;
        result.iterations += step(newton);
        result.residual = settle(newton);
        result.steps++;
        best_keep(newton, &course, result.residual);
        if (result.residual <= limits->tolerance)
            break;
        if (course.bare > 0)
            result.residual = bare_end(newton, &course, result.residual);
        else if (newton->miss > progress * before)
            result.residual = sweeps_follow(newton, &course);
    }
    if (result.residual > limits->tolerance && newton->miss > course.best)
        result.residual = best_take(newton, &course);
    else
        smooth(newton, 1); /* no row pulls, none has more friction than it may */
    return result;
}
