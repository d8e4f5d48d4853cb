/* SPDX-License-Identifier: BSD-3-Clause */
/* Exchanges of velocities between the holders of a body. Read border.h first. */
#include "physics/hard/border.h"
#include "base/memory.h"
#include <string.h>

enum { NUMBERS = 6 };

void hard_border_free(struct hard_border *border) {
    memory_free(border->last);
    memory_free(border->share);
    border->last = NULL;
    border->share = NULL;
    border->room = 0;
}

static double *numbers_of(const struct hard_border *border, size_t k) {
    return (double *)fields_base(border->particles, border->field, NULL) + k * NUMBERS;
}

static void put(double *number, const struct hard_body *body) {
    memcpy(number, body->v, sizeof body->v);
    memcpy(number + 3, body->w, sizeof body->w);
}

static void take(struct hard_body *body, const double *number) {
    memcpy(body->v, number, sizeof body->v);
    memcpy(body->w, number + 3, sizeof body->w);
}

/* Originals send what `numbers_of` has for them; copies take it as their velocity, and it is what all agree on. */
static void forward(struct hard_border *border, struct hard_problem *problem) {
    const struct field_list fields = fields_one(border->field);
    struct particles *p = border->particles;
    size_t count;
    const uint32_t *original = ghosts_originals(border->ghosts, &count);
    ghosts_forward_begin(border->ghosts, p, &fields);
    ghosts_forward_end(border->ghosts, p);
    for (size_t k = 0; k < p->ghosts; k++)
        take(&problem->body[p->owned + k], numbers_of(border, p->owned + k));
    for (size_t k = 0; k < p->ghosts; k++)
        border->last[p->owned + k] = problem->body[p->owned + k];
    for (size_t k = 0; k < count; k++)
        border->last[original[k]] = problem->body[original[k]];
}

void hard_border_send(struct hard_border *border, struct hard_problem *problem) {
    struct particles *p = border->particles;
    size_t count, all = p->owned + p->ghosts;
    if (border->ghosts == NULL)
        return;
    if (all > border->room) {
        border->room = all + all / 4;
        border->last = memory_resize(border->last, border->room, sizeof *border->last, "copies of contacts");
        border->share =
            memory_resize(border->share, border->room, sizeof *border->share, "copies of contacts");
    }
    const uint32_t *original = ghosts_originals(border->ghosts, &count);
    for (size_t k = 0; k < count; k++)
        put(numbers_of(border, original[k]), &problem->body[original[k]]);
    forward(border, problem);
}

/* Adds the numbers of copies to those of their originals. */
static void sum_home(struct hard_border *border) {
    const struct field_list fields = fields_one(border->field);
    ghosts_sum(border->ghosts, border->particles, &fields);
}

/* Numbers of a particle while rows are counted: by turn, and the rank that owns it. */
enum { RANK = HARD_TURNS };

/* The turn of a row, from the ranks of its bodies. */
static uint8_t turn_of(const struct hard_border *border, const struct hard_row *row, int rank) {
    size_t owned = border->particles->owned, all = owned + border->particles->ghosts;
    int turn = HARD_TURN_INSIDE;
    for (int e = 0; e < 2; e++)
        if (row->body[e] >= owned && row->body[e] < all)
            turn = numbers_of(border, row->body[e])[RANK] < rank ? HARD_TURN_DOWN : HARD_TURN_UP;
    return (uint8_t)turn;
}

/* Copies take the numbers of their originals. */
static void spread_all(struct hard_border *border) {
    const struct field_list fields = fields_one(border->field);
    ghosts_forward_begin(border->ghosts, border->particles, &fields);
    ghosts_forward_end(border->ghosts, border->particles);
}

/* The weight of the contacts of others beside a holder's own. */
static const double others_usual = 0.25, others_careful = 1.0;

/* The part of the mass of particle k that this holder has in a turn; 1: all. */
static double part_of(const struct hard_border *border, size_t k, enum hard_turn turn) {
    const struct hard_share *share = &border->share[k];
    if (turn == HARD_TURN_ALL || !(share->own[turn] > 0.0))
        return 1.0;
    double own = share->own[turn], others = share->all[turn] - own;
    return own / (own + (border->careful ? others_careful : others_usual) * others);
}

void hard_border_count(struct hard_border *border, struct hard_problem *problem, int rank) {
    size_t all;
    if (border->ghosts == NULL)
        return;
    all = border->particles->owned + border->particles->ghosts;
    for (size_t k = 0; k < all; k++) {
        memset(numbers_of(border, k), 0, NUMBERS * sizeof(double));
        numbers_of(border, k)[RANK] = k < border->particles->owned ? rank : 0.0;
    }
    spread_all(border);
    problem->turn = hard_problem_grow(problem->turn, &problem->turn_room, problem->rows, 1);
    for (size_t r = 0; r < problem->rows; r++) {
        const struct hard_row *row = &problem->row[r];
        problem->turn[r] = turn_of(border, row, rank);
        for (int e = 0; e < 2; e++)
            if (row->body[e] < all)
                numbers_of(border, row->body[e])[problem->turn[r]] += 1.0;
    }
    for (size_t k = 0; k < all; k++) {
        struct hard_share *share = &border->share[k];
        *share =
            (struct hard_share){.lightness = problem->body[k].lightness, .swing = problem->body[k].swing};
        memcpy(share->own, numbers_of(border, k), sizeof share->own);
    }
    sum_home(border);
    spread_all(border);
    for (size_t k = 0; k < all; k++)
        memcpy(border->share[k].all, numbers_of(border, k), sizeof border->share[k].all);
    border->careful = false;
}

/* Adds the impulses of a row to the numbers of its end `e`, if that is a particle without lightness. */
static void gather_end(struct hard_border *border, const struct hard_problem *problem,
                       const struct hard_row *row, int e) {
    size_t k = row->body[e], all = border->particles->owned + border->particles->ghosts;
    double impulse[6];
    if (k >= all || problem->body[k].lightness > 0.0)
        return;
    hard_impulse(row, e, impulse);
    for (int d = 0; d < 6; d++)
        numbers_of(border, k)[d] += impulse[d];
}

void hard_border_gather(struct hard_border *border, const struct hard_problem *problem) {
    for (size_t k = 0; k < border->particles->owned + border->particles->ghosts; k++)
        memset(numbers_of(border, k), 0, NUMBERS * sizeof(double));
    for (size_t r = 0; r < problem->rows; r++)
        for (int e = 0; e < 2; e++)
            gather_end(border, problem, &problem->row[r], e);
    if (border->ghosts)
        sum_home(border);
}

const double *hard_border_gathered(const struct hard_border *border, size_t k) {
    return numbers_of(border, k);
}

void hard_border_spread(struct hard_border *border, double (*value)[6]) {
    const struct field_list fields = fields_one(border->field);
    struct particles *p = border->particles;
    size_t count;
    if (border->ghosts == NULL)
        return;
    const uint32_t *original = ghosts_originals(border->ghosts, &count);
    for (size_t k = 0; k < count; k++)
        memcpy(numbers_of(border, original[k]), value[original[k]], sizeof *value);
    ghosts_forward_begin(border->ghosts, p, &fields);
    ghosts_forward_end(border->ghosts, p);
    for (size_t k = p->owned; k < p->owned + p->ghosts; k++)
        memcpy(value[k], numbers_of(border, k), sizeof *value);
}

void hard_border_collect(struct hard_border *border, double (*value)[6]) {
    struct particles *p = border->particles;
    size_t count;
    if (border->ghosts == NULL)
        return;
    const uint32_t *original = ghosts_originals(border->ghosts, &count);
    for (size_t k = 0; k < count; k++)
        memcpy(numbers_of(border, original[k]), value[original[k]], sizeof *value);
    for (size_t k = p->owned; k < p->owned + p->ghosts; k++)
        memcpy(numbers_of(border, k), value[k], sizeof *value);
    sum_home(border);
    for (size_t k = 0; k < count; k++)
        memcpy(value[original[k]], numbers_of(border, original[k]), sizeof *value);
}

/* Gives the bodies at borders the parts of their masses that this holder has in a turn, or the whole. */
static void masses_split(const struct hard_border *border, struct hard_problem *problem,
                         enum hard_turn turn) {
    const struct particles *p = border->particles;
    size_t count;
    const uint32_t *original = ghosts_originals(border->ghosts, &count);
    for (size_t n = 0; n < count + p->ghosts; n++) {
        size_t k = n < count ? original[n] : p->owned + (n - count);
        const struct hard_share *share = &border->share[k];
        double part = part_of(border, k, turn);
        problem->body[k].lightness = share->lightness / part;
        problem->body[k].swing = share->swing / part;
    }
}

/* What a holder has done to body k since the last exchange, times its part. */
static void change_of(const struct hard_border *border, const struct hard_problem *problem, size_t k,
                      enum hard_turn turn, double change[NUMBERS]) {
    const struct hard_body *body = &problem->body[k], *last = &border->last[k];
    double part = part_of(border, k, turn);
    for (int d = 0; d < 3; d++) {
        change[d] = part * (body->v[d] - last->v[d]);
        change[3 + d] = part * (body->w[d] - last->w[d]);
    }
}

/* Joins what the holders have done; HARD_TURN_ALL: with whole masses. */
static void join(struct hard_border *border, struct hard_problem *problem, enum hard_turn turn) {
    struct particles *p = border->particles;
    size_t count;
    const uint32_t *original = ghosts_originals(border->ghosts, &count);
    for (size_t k = p->owned; k < p->owned + p->ghosts; k++)
        change_of(border, problem, k, turn, numbers_of(border, k));
    for (size_t k = 0; k < count; k++)
        memset(numbers_of(border, original[k]), 0, NUMBERS * sizeof(double));
    sum_home(border);
    for (size_t k = 0; k < count; k++) {
        struct hard_body *body = &problem->body[original[k]];
        const struct hard_body *last = &border->last[original[k]];
        double *number = numbers_of(border, original[k]), own[NUMBERS];
        change_of(border, problem, original[k], turn, own);
        for (int d = 0; d < 3; d++) {
            body->v[d] = last->v[d] + (number[d] + own[d]);
            body->w[d] = last->w[d] + (number[3 + d] + own[3 + d]);
        }
        put(number, body);
    }
    forward(border, problem);
}

void hard_border_join(struct hard_border *border, struct hard_problem *problem) {
    if (border->ghosts)
        join(border, problem, HARD_TURN_ALL);
}

void hard_border_turns(struct hard_border *border, struct hard_problem *problem,
                       void (*visit)(struct hard_problem *problem, enum hard_turn turn)) {
    if (border->ghosts == NULL) {
        visit(problem, HARD_TURN_ALL);
        return;
    }
    visit(problem, HARD_TURN_INSIDE);
    hard_border_send(border, problem);
    for (int turn = HARD_TURN_UP; turn < HARD_TURNS; turn++) {
        masses_split(border, problem, (enum hard_turn)turn);
        visit(problem, (enum hard_turn)turn);
        join(border, problem, (enum hard_turn)turn);
    }
    masses_split(border, problem, HARD_TURN_ALL);
}
