/* SPDX-License-Identifier: BSD-3-Clause */
/* Places of neighbours on a lattice, found by a grid of cells. Read stencil.h first. */
#include "fluid/stencil.h"
#include <math.h>
#include <string.h>

/* Places nearer than this, in cells, are the same. */
static const double same = 1e-5;

/* The number of the cell of a place that is moved by `off` cells along each axis with a bit in `corner`, and back along the
 * others; -1 outside of the grid. */
static int cell_of(const struct stencil *stencil, const double place[3], int corner, double off) {
    int cell = 0;
    for (int d = 2; d >= 0; d--) {
        double at = place[d] / stencil->cell + 0.5 * STENCIL_SIDE + (corner >> d & 1 ? off : -off);
        if (!(at >= 0 && at < STENCIL_SIDE))
            return -1;
        cell = STENCIL_SIDE * cell + (int)at;
    }
    return cell;
}

static void place_of(const struct tensors_neighbour *neighbour, double place[3]) {
    for (int d = 0; d < 3; d++)
        place[d] = neighbour->distance * neighbour->e[d];
}

bool stencil_make(struct stencil *stencil, const struct tensors_neighbour *neighbour, size_t count,
                  double support) {
    if (count > STENCIL_NEIGHBOURS_MAX)
        return false;
    memset(stencil->number, 0, sizeof stencil->number);
    stencil->count = count;
    stencil->cell = 2.2 * support / STENCIL_SIDE;
    for (size_t k = 0; k < count; k++) {
        place_of(&neighbour[k], stencil->place[k]);
        for (int corner = 0; corner < 8; corner++) {
            int cell = cell_of(stencil, stencil->place[k], corner, same);
            if (cell < 0 || (stencil->number[cell] != 0 && stencil->number[cell] != k + 1))
                return false;
            stencil->number[cell] = (uint8_t)(k + 1);
        }
    }
    return true;
}

/* The number of the place of a neighbour; STENCIL_NEIGHBOURS_MAX: none. */
static size_t find(const struct stencil *stencil, const struct tensors_neighbour *neighbour) {
    double place[3];
    place_of(neighbour, place);
    int cell = cell_of(stencil, place, 0, 0);
    if (cell < 0 || stencil->number[cell] == 0)
        return STENCIL_NEIGHBOURS_MAX;
    size_t k = stencil->number[cell] - 1u;
    for (int d = 0; d < 3; d++)
        if (!(fabs(place[d] - stencil->place[k][d]) <= same * stencil->cell))
            return STENCIL_NEIGHBOURS_MAX;
    return k;
}

bool stencil_find(const struct stencil *stencil, const struct tensors_neighbour *neighbour, size_t count,
                  uint8_t *code) {
    bool seen[STENCIL_NEIGHBOURS_MAX] = {false};
    if (count != stencil->count)
        return false;
    for (size_t e = 0; e < count; e++) {
        size_t k = find(stencil, &neighbour[e]);
        if (k == STENCIL_NEIGHBOURS_MAX || seen[k])
            return false;
        seen[k] = true;
        code[e] = (uint8_t)k;
    }
    return true;
}
