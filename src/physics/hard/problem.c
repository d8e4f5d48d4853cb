/* SPDX-License-Identifier: BSD-3-Clause */
/* Sweeps over the rows of a contact problem, colour by colour. Read problem.h and row.h first. */
#include "physics/hard/problem.h"
#include "base/memory.h"

/* Fewer rows than this are visited by one thread: barriers would cost more. */
enum { ROWS_ALONE = 1500 };

void hard_problem_free(struct hard_problem *problem) {
    memory_free(problem->body);
    memory_free(problem->row);
    memory_free(problem->turn);
    memory_free(problem->colour);
    memory_free(problem->cut);
    *problem = (struct hard_problem){0};
}

void *hard_problem_grow(void *array, size_t *room, size_t count, size_t size) {
    if (count <= *room)
        return array;
    *room = count + count / 4 + 64;
    return memory_resize(array, *room, size, "contact problem");
}

void hard_problem_reserve(struct hard_problem *problem, size_t bodies, size_t rows, size_t cuts) {
    problem->body = hard_problem_grow(problem->body, &problem->body_room, bodies, sizeof *problem->body);
    problem->row = hard_problem_grow(problem->row, &problem->row_room, rows, sizeof *problem->row);
    problem->cut = hard_problem_grow(problem->cut, &problem->cut_room, cuts + 1, sizeof *problem->cut);
}

void hard_problem_begin(struct hard_problem *problem, double dt) {
    size_t room = (size_t)problem->colour_room;
    hard_problem_reserve(problem, 0, 0, 0);
    problem->colour = hard_problem_grow(problem->colour, &room, 1, sizeof *problem->colour);
    problem->colour_room = (int)room;
    problem->dt = dt;
    problem->colours = 0;
    problem->colour[0] = problem->rows = problem->cuts = problem->cut[0] = 0;
}

void hard_problem_end_colour(struct hard_problem *problem) {
    size_t room = (size_t)problem->colour_room, next = (size_t)++problem->colours;
    problem->colour = hard_problem_grow(problem->colour, &room, next + 1, sizeof *problem->colour);
    problem->colour_room = (int)room;
    problem->colour[next] = problem->cuts;
}

void hard_problem_visit(const struct hard_problem *problem,
                        void (*visit)(void *context, size_t row, size_t end), void *context) {
#pragma omp parallel if (problem->rows >= ROWS_ALONE)
    for (int c = 0; c < problem->colours; c++) {
#pragma omp for schedule(static)
        for (size_t k = problem->colour[c]; k < problem->colour[c + 1]; k++)
            visit(context, problem->cut[k], problem->cut[k + 1]);
    }
}

static void pull(void *context, size_t row, size_t end) {
    static const double none[3] = {0.0, 0.0, 0.0};
    struct hard_problem *problem = context;
    for (struct hard_row *r = &problem->row[row]; r < &problem->row[end]; r++)
        hard_apply(r, &problem->body[r->body[0]], &problem->body[r->body[1]], -r->pull, none);
}

void hard_problem_pull(struct hard_problem *problem) {
    hard_problem_visit(problem, pull, problem);
}

static void warm(void *context, size_t row, size_t end) {
    struct hard_problem *problem = context;
    for (struct hard_row *r = &problem->row[row]; r < &problem->row[end]; r++) {
        struct hard_body *a = &problem->body[r->body[0]], *b = &problem->body[r->body[1]];
        hard_apply(r, a, b, r->p, r->q);
        if (r->resist) {
            double moment[3];
            hard_resist_moment(r->resist, r->normal, &r->resist->now, moment);
            hard_resist_apply(r->arm, a, b, moment);
        }
    }
}

void hard_problem_warm(struct hard_problem *problem) {
    hard_problem_visit(problem, warm, problem);
}

static void sweep(void *context, size_t row, size_t end) {
    struct hard_problem *problem = context;
    for (struct hard_row *r = &problem->row[row]; r < &problem->row[end]; r++)
        hard_visit(r, problem->dt, &problem->body[r->body[0]], &problem->body[r->body[1]]);
}

static void rebound(void *context, size_t row, size_t end) {
    struct hard_problem *problem = context;
    for (struct hard_row *r = &problem->row[row]; r < &problem->row[end]; r++)
        if (hard_rebounds(r))
            hard_rebound(r, &problem->body[r->body[0]], &problem->body[r->body[1]]);
}

/* Visits of the rows of a turn, by runs of them. */
struct visit {
    struct hard_problem *problem;
    enum hard_turn turn;
    void (*run)(void *context, size_t row, size_t end);
};

static void visit_turn(void *context, size_t row, size_t end) {
    const struct visit *visit = context;
    const uint8_t *turn = visit->problem->turn;
    for (size_t r = row, next; r < end; r = next) {
        for (next = r + 1; next < end && turn[next] == turn[r];)
            next++;
        if (turn[r] == (uint8_t)visit->turn)
            visit->run(visit->problem, r, next);
    }
}

static void visit_rows(struct hard_problem *problem, enum hard_turn turn,
                       void (*run)(void *context, size_t row, size_t end)) {
    if (turn == HARD_TURN_ALL)
        hard_problem_visit(problem, run, problem);
    else
        hard_problem_visit(problem, visit_turn, &(struct visit){problem, turn, run});
}

void hard_problem_sweep(struct hard_problem *problem, enum hard_turn turn) {
    visit_rows(problem, turn, sweep);
}

void hard_problem_rebound(struct hard_problem *problem, enum hard_turn turn) {
    visit_rows(problem, turn, rebound);
}

bool hard_problem_rebounds(const struct hard_problem *problem) {
    bool any = false;
    for (size_t r = 0; r < problem->rows && !any; r++)
        any = hard_rebounds(&problem->row[r]);
    return any;
}

bool hard_problem_expand(struct hard_problem *problem) {
    bool any = false;
    for (size_t r = 0; r < problem->rows; r++) {
        struct hard_row *row = &problem->row[r];
        if (!hard_rebounds(row))
            continue;
        row->least = (1.0 + row->restitution) * row->p;
        any = true;
    }
    return any;
}

/* What the couples of a row add to the squares of hard_problem_residual. */
static void couple_count(const struct hard_couple *now, const struct hard_couple *next, double sum[3]) {
    double change[3], twist = next->twist - now->twist;
    vector_minus(next->roll, now->roll, change);
    sum[0] += vector_dot(change, change) + twist * twist;
    sum[1] += vector_dot(now->roll, now->roll) + now->twist * now->twist;
    sum[2] += vector_dot(next->roll, next->roll) + next->twist * next->twist;
}

void hard_problem_residual(const struct hard_problem *problem, double sum[3]) {
    double(*part)[3] = memory_allocate_zero(problem->cuts, sizeof *part, "residual of contacts");
#pragma omp parallel for schedule(static) if (problem->rows >= ROWS_ALONE)
    for (size_t k = 0; k < problem->cuts; k++)
        for (size_t r = problem->cut[k]; r < problem->cut[k + 1]; r++) {
            struct hard_row row = problem->row[r];
            struct hard_answer answer;
            hard_wish(&row, problem->dt, &problem->body[row.body[0]], &problem->body[row.body[1]], &answer);
            double p = answer.p, square = (p - row.p) * (p - row.p);
            for (int d = 0; d < 3; d++)
                square += (answer.q[d] - row.q[d]) * (answer.q[d] - row.q[d]);
            part[k][0] += square;
            part[k][1] += row.p * row.p + vector_dot(row.q, row.q);
            part[k][2] += p * p + vector_dot(answer.q, answer.q);
            if (row.resist)
                couple_count(&row.resist->now, &answer.couple, part[k]);
        }
    sum[0] = sum[1] = sum[2] = 0.0;
    for (size_t k = 0; k < problem->cuts; k++)
        for (int c = 0; c < 3; c++)
            sum[c] += part[k][c];
    memory_free(part);
}
