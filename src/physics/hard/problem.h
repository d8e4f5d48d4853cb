/* SPDX-License-Identifier: BSD-3-Clause */
/* The contact problem of a step as arrays, and sweeps of Gauss and Seidel over it.
 *
 * Rows lie in an order of colours: two rows of one colour have no body in common, except rows of one *cut*, which one
 * thread visits one after another. The cuts of a colour are therefore visited by many threads, and the result does
 * not depend on their number. */
#ifndef SCREE_HARD_PROBLEM_H
#define SCREE_HARD_PROBLEM_H

#include "physics/hard/row.h"
#include <stddef.h>

/* The turns of a sweep over ranks: contacts of a rank's own bodies; those with copies of bodies of higher ranks (or of its own,
 * across a periodic box), and of lower ones. */
enum hard_turn { HARD_TURN_INSIDE, HARD_TURN_UP, HARD_TURN_DOWN, HARD_TURNS, HARD_TURN_ALL = HARD_TURNS };

struct hard_problem {
    double dt;
    size_t bodies, body_room;
    struct hard_body *body;
    size_t rows, row_room;
    struct hard_row *row;
    size_t turn_room;
    uint8_t *turn; /* of each row, enum hard_turn; only where bodies have copies (border.h) */
    int colours, colour_room;
    size_t *colour; /* colours + 1: the cuts of colour c are cut[colour[c]] ... cut[colour[c + 1]] */
    size_t cuts, cut_room;
    size_t *cut; /* cuts + 1: first row of each */
};

/* Frees the arrays. */
void hard_problem_free(struct hard_problem *problem);

/* Makes room; the counts stay. Rows, cuts and bodies that are there keep their values. */
void hard_problem_reserve(struct hard_problem *problem, size_t bodies, size_t rows, size_t cuts);

/* Grows an array of `room` entries that is too small for `count`. */
void *hard_problem_grow(void *array, size_t *room, size_t count, size_t size);

/* Begins without colours; adds a colour whose cuts end at the present number of cuts. One thread. */
void hard_problem_begin(struct hard_problem *problem, double dt);
void hard_problem_end_colour(struct hard_problem *problem);

/* Applies the pulls of cohesion, which are given. Opens its own team of threads, as the functions below. */
void hard_problem_pull(struct hard_problem *problem);

/* Applies the impulses that the rows begin with. */
void hard_problem_warm(struct hard_problem *problem);

/* Calls `visit` for the rows of each cut, the cuts of a colour by many threads. */
void hard_problem_visit(const struct hard_problem *problem,
                        void (*visit)(void *context, size_t row, size_t end), void *context);

/* Visits each row of a turn once. */
void hard_problem_sweep(struct hard_problem *problem, enum hard_turn turn);

/* The same for rows that rebound (hard_rebounds), and whether this rank has such rows. */
void hard_problem_rebound(struct hard_problem *problem, enum hard_turn turn);
bool hard_problem_rebounds(const struct hard_problem *problem);

/* Rows that rebound shall keep 1 + restitution times their normal impulses from now on. Returns whether this rank has any. */
bool hard_problem_expand(struct hard_problem *problem);

/* Adds the squares of p - z, p and z over the rows, z what a visit would make of p if all others stay: the residual
 * of Alart and Curnier is sqrt(sum[0] / max(sum[1], sum[2])). The same bits for any number of threads. */
void hard_problem_residual(const struct hard_problem *problem, double sum[3]);

#endif
