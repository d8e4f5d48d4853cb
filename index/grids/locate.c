/* SPDX-License-Identifier: BSD-3-Clause */
/* The batches of locate.h, as plain loops. */
#include "index/grids/levels_parts.h"

#include "base/clones.h"

/* Coordinates in direction d; true if one was clamped. A coordinate that is not a number counts as
 * clamped. */
SCREE_CLONES static bool frame_batch(const struct frame *frame, int d, const double *restrict x, size_t n,
                                     float *restrict to) {
    const double low = frame->low[d], high = frame->high[d], centre = frame->centre[d], scale = frame->scale;
    uint64_t clamped = 0;
    for (size_t k = 0; k < n; k++) {
        double inside = x[k] > low ? x[k] : low;
        inside = inside < high ? inside : high;
        clamped |= (uint64_t)(inside != x[k]);
        to[k] = (float)((inside - centre) * scale);
    }
    return clamped != 0;
}

void locate_particles(struct located *located, const struct index_view *view, const struct frame *frame,
                      const uint32_t *list, size_t first) {
    const size_t n = located->count, stride = view->stride;
    double x[3][LOCATE_BATCH];
    for (size_t k = 0; k < n; k++) {
        size_t at = (list != NULL ? list[k] : first + k) * stride;
        x[0][k] = view->position[at];
        x[1][k] = view->position[at + 1];
        x[2][k] = view->position[at + 2];
        located->r[k] = view->radius[at];
    }
    located->clamped = false;
    for (int d = 0; d < 3; d++) {
        located->clamped = frame_batch(frame, d, x[d], n, located->x[d]) || located->clamped;
    }
}

void locate_cells(struct located *located, const struct grid *grid) {
    for (int d = 0; d < 3; d++) {
        const float anchor = grid->anchor[d], inverse = grid->inverse[d];
        const float base = grid->base[d], top = grid->top[d];
        const int first = (int)base;
        const float *restrict x = located->x[d];
        uint32_t *restrict cell = located->cell[d];
        for (size_t k = 0; k < located->count; k++) {
            float t = (x[k] - anchor) * inverse;
            t = t > base ? t : base;
            t = t < top ? t : top;
            int c = (int)t;
            c -= (float)c > t;
            cell[k] = (uint32_t)(c - first);
        }
    }
}
