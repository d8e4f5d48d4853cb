/* SPDX-License-Identifier: BSD-3-Clause */
/* Exchanges of velocities between the holders of a body. Read border.h first. */
#include "physics/hard/border.h"
#include "base/memory.h"
#include <string.h>

enum { NUMBERS = 6 };

void hard_border_free(struct hard_border *border) {
    memory_free(border->last);
    memory_free(border->holders);
    border->last = NULL;
    border->holders = NULL;
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
        border->holders = memory_resize(border->holders, border->room, sizeof(double), "copies of contacts");
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

void hard_border_count(struct hard_border *border, const struct hard_problem *problem) {
    const struct field_list fields = fields_one(border->field);
    struct particles *p = border->particles;
    size_t all = p->owned + p->ghosts;
    if (border->ghosts == NULL)
        return;
    for (size_t k = 0; k < all; k++)
        memset(numbers_of(border, k), 0, NUMBERS * sizeof(double));
    for (size_t r = 0; r < problem->rows; r++)
        for (int e = 0; e < 2; e++)
            if (problem->row[r].body[e] < all)
                numbers_of(border, problem->row[r].body[e])[0] = 1.0;
    sum_home(border);
    ghosts_forward_begin(border->ghosts, p, &fields);
    ghosts_forward_end(border->ghosts, p);
    for (size_t k = 0; k < all; k++) {
        double holders = numbers_of(border, k)[0];
        border->holders[k] = holders > 1.0 ? holders : 1.0;
    }
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

void hard_border_split(const struct hard_border *border, struct hard_problem *problem, bool split) {
    for (size_t k = 0; border->ghosts && k < border->particles->owned + border->particles->ghosts; k++) {
        double factor = split ? border->holders[k] : 1.0 / border->holders[k];
        problem->body[k].lightness *= factor;
        problem->body[k].swing *= factor;
    }
}

void hard_border_join(struct hard_border *border, struct hard_problem *problem, bool split) {
    struct particles *p = border->particles;
    size_t count;
    if (border->ghosts == NULL)
        return;
    const uint32_t *original = ghosts_originals(border->ghosts, &count);
    for (size_t k = 0; k < p->ghosts; k++) {
        const struct hard_body *body = &problem->body[p->owned + k], *last = &border->last[p->owned + k];
        double *number = numbers_of(border, p->owned + k);
        for (int d = 0; d < 3; d++) {
            number[d] = body->v[d] - last->v[d];
            number[3 + d] = body->w[d] - last->w[d];
        }
    }
    for (size_t k = 0; k < count; k++)
        memset(numbers_of(border, original[k]), 0, NUMBERS * sizeof(double));
    sum_home(border);
    for (size_t k = 0; k < count; k++) {
        struct hard_body *body = &problem->body[original[k]];
        const struct hard_body *last = &border->last[original[k]];
        double *number = numbers_of(border, original[k]),
               share = split ? 1.0 / border->holders[original[k]] : 1.0;
        for (int d = 0; d < 3; d++) {
            body->v[d] = last->v[d] + share * (number[d] + (body->v[d] - last->v[d]));
            body->w[d] = last->w[d] + share * (number[3 + d] + (body->w[d] - last->w[d]));
        }
        put(number, body);
    }
    forward(border, problem);
}
