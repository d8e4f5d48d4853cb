/* SPDX-License-Identifier: BSD-3-Clause */
/* Places of neighbours on a lattice, found by a grid of cells. Read pattern.h first. */
#include "physics/fluid/lattice/pattern.h"
#include <math.h>
#include <string.h>

/* Places nearer than this, in cells, are the same. */
static const double same = 1e-5;

/* The number of the cell of a place that is moved by `off` cells along each axis with a bit in `corner`, and back along the
 * others; -1 outside of the grid. */
static int cell_of(const struct pattern *pattern, const double place[3], int corner, double off) {
    int cell = 0;
    for (int d = 2; d >= 0; d--) {
        double at = place[d] / pattern->cell + 0.5 * PATTERN_SIDE + (corner >> d & 1 ? off : -off);
        if (!(at >= 0 && at < PATTERN_SIDE))
            return -1;
        cell = PATTERN_SIDE * cell + (int)at;
    }
    return cell;
}

static void place_of(const struct correction_tensors_neighbour *neighbour, double place[3]) {
    for (int d = 0; d < 3; d++)
        place[d] = neighbour->distance * neighbour->e[d];
}

bool pattern_make(struct pattern *pattern, const struct correction_tensors_neighbour *neighbour, size_t count,
                  double support) {
    if (count > PATTERN_NEIGHBOURS_MAX)
        return false;
    memset(pattern->number, 0, sizeof pattern->number);
    pattern->count = count;
    pattern->cell = 2.2 * support / PATTERN_SIDE;
    for (size_t k = 0; k < count; k++) {
        place_of(&neighbour[k], pattern->place[k]);
        for (int corner = 0; corner < 8; corner++) {
            int cell = cell_of(pattern, pattern->place[k], corner, same);
            if (cell < 0 || (pattern->number[cell] != 0 && pattern->number[cell] != k + 1))
                return false;
            pattern->number[cell] = (uint8_t)(k + 1);
        }
    }
    return true;
}

/* The number of the place of a neighbour; PATTERN_NEIGHBOURS_MAX: none. */
static size_t find(const struct pattern *pattern, const struct correction_tensors_neighbour *neighbour) {
    double place[3];
    place_of(neighbour, place);
    int cell = cell_of(pattern, place, 0, 0);
    if (cell < 0 || pattern->number[cell] == 0)
        return PATTERN_NEIGHBOURS_MAX;
    size_t k = pattern->number[cell] - 1u;
    for (int d = 0; d < 3; d++)
        if (!(fabs(place[d] - pattern->place[k][d]) <= same * pattern->cell))
            return PATTERN_NEIGHBOURS_MAX;
    return k;
}

bool pattern_find(const struct pattern *pattern, const struct correction_tensors_neighbour *neighbour,
                  size_t count, uint8_t *code) {
    bool seen[PATTERN_NEIGHBOURS_MAX] = {false};
    if (count != pattern->count)
        return false;
    for (size_t e = 0; e < count; e++) {
        size_t k = find(pattern, &neighbour[e]);
        if (k == PATTERN_NEIGHBOURS_MAX || seen[k])
            return false;
        seen[k] = true;
        code[e] = (uint8_t)k;
    }
    return true;
}
