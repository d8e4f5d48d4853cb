/* SPDX-License-Identifier: BSD-3-Clause */
/* Messages about some of the copies alone: numbers that their owner keeps in an array of its own travel between
 * originals and copies, without the other particles. A part is made after ghosts_make and is valid until the next
 * ghosts_make or ghosts_drop. */
#ifndef SCREE_COMM_GHOSTS_PART_H
#define SCREE_COMM_GHOSTS_PART_H

#include "kernel/comm/ghosts.h"

struct ghosts_part;

/* The part of the particles k with row[k] >= 0, owned ones and copies; the number is the row of the particle in
 * the arrays below. Ranks must agree: a copy is in the part if and only if its original is. Not collective. */
struct ghosts_part *ghosts_part_create(struct ghosts *ghosts, const int32_t *row);
void ghosts_part_destroy(struct ghosts_part **part);

/* Sends the rows of originals (`width` doubles each) to the rows of their copies, as they are: nothing is shifted
 * by images. Collective (neighbours). */
void ghosts_part_forward(struct ghosts_part *part, double *value, int width);

/* Adds the rows of copies to the rows of their originals, by the rank that held the copy, then in the order of the
 * copies there. Copies keep their rows. Collective (neighbours). */
void ghosts_part_sum(struct ghosts_part *part, double *value, int width);

#endif
