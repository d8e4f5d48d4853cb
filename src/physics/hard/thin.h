/* SPDX-License-Identifier: BSD-3-Clause */
/* Fewer contacts between two rigid bodies, or a body and a wall: members of clumps touch at dozens of points, of which four of a
 * direction bear all that many do. */
#ifndef SCREE_HARD_THIN_H
#define SCREE_HARD_THIN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Points that are kept of one pair of bodies and one direction of the normal. */
enum { HARD_POINTS = 4 };

struct hard_point {
    uint64_t bodies; /* the same for all points of a pair of bodies */
    uint64_t order;  /* of the points of a pair: from ids */
    size_t number;   /* for the caller */
    double place[3], normal[3], gap;
    bool pressed; /* it had a force in the last step */
    bool keep;    /* the result */
};

/* Chooses the points to keep: of those with normals within 20 degrees of the deepest the deepest one, then the farthest
 * ones; of two that are alike the one that pressed. Sorts the points. One thread. */
void hard_thin(struct hard_point *point, size_t points);

#endif
