/* SPDX-License-Identifier: BSD-3-Clause */
/* The preconditioner of Newton's method: the incomplete Cholesky factor, without fill, of the matrix of this rank's bodies in
 * blocks of six by six. Bodies of other ranks are left out, but for their part in the diagonal blocks: over ranks it is
 * block Jacobi's. Bodies are taken in the order of their numbers, by one thread. */
#ifndef SCREE_HARD_NEWTON_BLOCKS_H
#define SCREE_HARD_NEWTON_BLOCKS_H

#include "physics/hard/border.h"
#include "physics/hard/newton_body.h"
#include "physics/hard/newton_row.h"

typedef double hard_block[6][6];

struct hard_blocks {
    size_t bodies;                   /* owned */
    size_t *start;                   /* bodies + 1: blocks left of the diagonal, by body and column */
    uint32_t *column;                /* of each block */
    uint32_t *of_row;                /* the block of each row of the problem; UINT32_MAX: none */
    hard_block *value;               /* left of the diagonal */
    hard_block *diagonal;            /* of bodies and copies; once factored the inverse of the factor's */
    const double (*root)[HARD_ROOT]; /* of the bodies (newton_body.h); NULL: all are spheres. Borrowed */
    size_t body_room, start_room, block_room, column_room, row_room;
};

void hard_blocks_free(struct hard_blocks *blocks);

/* Finds which blocks the problem has; `bodies` are owned. */
void hard_blocks_shape(struct hard_blocks *blocks, const struct hard_problem *problem, size_t bodies);

/* Fills and factors the matrix 1 + St Jt G J S: G the derivatives of the rows, S the roots of the bodies' 1/mass and inverse
 * inertia. Collective. */
void hard_blocks_make(struct hard_blocks *blocks, const struct hard_problem *problem,
                      const struct hard_newton_row *newton, struct hard_border *border);

/* z = the inverse of the factored matrix times r. */
void hard_blocks_solve(const struct hard_blocks *blocks, const double (*r)[6], double (*z)[6]);

#endif
