/* SPDX-License-Identifier: BSD-3-Clause */
/* The neighbours of a row on a lattice, by place. All rows of a lattice have neighbours at the same places, so that
 * one table of weights serves all: a byte an entry takes the place of four numbers (weights.h). */
#ifndef SCREE_LATTICE_PATTERN_H
#define SCREE_LATTICE_PATTERN_H

#include "physics/fluid/operators/correction_tensors.h"
#include <stdint.h>

/* Neighbours of a row at most, so that a byte tells each; cells a side of the grid of places. */
enum { PATTERN_NEIGHBOURS_MAX = 255, PATTERN_SIDE = 32 };

struct pattern {
    size_t count;
    double place[PATTERN_NEIGHBOURS_MAX][3]; /* r = x_i - x_j, length */
    double cell;                             /* edge of a cell, length */
    uint8_t
        number[PATTERN_SIDE * PATTERN_SIDE * PATTERN_SIDE]; /* 1 + number of the place in a cell; 0: none */
};

/* Takes the places of a row with `count` neighbours within `support`. False if there are too many, or two in one cell of
 * the grid. Any thread. */
bool pattern_make(struct pattern *pattern, const struct correction_tensors_neighbour *neighbour, size_t count,
                  double support);

/* Writes the number of the place of each of `count` neighbours to code[count]. False if they are not the neighbours of
 * the lattice, to a millionth of the support. Any thread. */
bool pattern_find(const struct pattern *pattern, const struct correction_tensors_neighbour *neighbour,
                  size_t count, uint8_t *code);

#endif
