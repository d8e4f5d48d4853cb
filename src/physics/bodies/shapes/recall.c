/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds the same points again. Read recall.h first. */
#include "physics/bodies/shapes/recall.h"
#include "base/rotor.h"
#include "base/vector.h"
#include <string.h>

/* What was before, and which of it has found its point. */
struct past {
    const struct touch_memory *memory;
    int count;
    bool taken[TOUCH_POINTS_MAX];
};

/* The number of the first memory with these features that is not taken; -1: none. */
static int find_key(const struct past *past, const struct touch_memory *now) {
    for (int m = 0; m < past->count; m++)
        if (!past->taken[m] && past->memory[m].key == now->key)
            return m;
    return -1;
}

/* The number of the nearest memory within the reach that is not taken; -1: none. */
static int find_place(const struct past *past, const struct touch_memory *now, double reach) {
    double least = reach * reach;
    int best = -1;
    for (int m = 0; m < past->count; m++) {
        double off[3];
        vector_minus(past->memory[m].place, now->place, off);
        if (past->taken[m] || !(vector_dot(off, off) < least))
            continue;
        least = vector_dot(off, off);
        best = m;
    }
    return best;
}

/* Takes springs of memory m; false: there is no such memory. */
static bool take(struct past *past, int m, struct touch_memory *now) {
    if (m < 0)
        return false;
    past->taken[m] = true;
    memcpy(now->spring, past->memory[m].spring, sizeof now->spring);
    memcpy(now->roll, past->memory[m].roll, sizeof now->roll);
    return true;
}

void recall_points(const struct touch_memory *before, int count, const double turn[9],
                   const struct touch *touch, double reach, struct touch_memory *now) {
    struct past past = {.memory = before, .count = count};
    bool found[TOUCH_POINTS_MAX];
    for (int k = 0; k < touch->points; k++) {
        now[k] = (struct touch_memory){.key = touch->point[k].key};
        rotor_turn_back(turn, touch->point[k].at, now[k].place);
        found[k] = take(&past, find_key(&past, &now[k]), &now[k]);
    }
    for (int k = 0; k < touch->points; k++)
        if (!found[k])
            take(&past, find_place(&past, &now[k], reach), &now[k]);
}
