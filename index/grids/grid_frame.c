/* SPDX-License-Identifier: BSD-3-Clause */
/* Derivation of the tolerance. Let M be the largest coordinate of the frame and e = 2^-24. Each of two
 * coordinates has an error of e M; a periodic edge, at most 2 M (and a millionth), has 2 e M; the coordinate
 * shifted by the edge adds 3 e M; the difference of the two, near the cut-off, adds next to nothing. The sum
 * is below 8 e M a direction, so below 8 sqrt(3) e M < 16 e M = 2^-20 M in all. */
#include "index/grids/grid_frame.h"

#include <float.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>

enum { SAMPLE = 1024, CELLS_ACROSS = 1 << 20 };

int grid_frame_partner(const struct index_view *view, int c) {
    int nearest = -1;
    if (index_wanted(view, c, c)) {
        return c;
    }
    for (int b = 0; b < view->classes; b++) {
        if (index_wanted(view, c, b) &&
            (nearest < 0 || view->radius_max[b] + view->margin[c][b] <
                                view->radius_max[nearest] + view->margin[c][nearest])) {
            nearest = b;
        }
    }
    return nearest;
}

struct grid_frame_cutoffs grid_frame_cutoffs(const struct index_view *view, int first, int last) {
    struct grid_frame_cutoffs cutoffs = {INFINITY, 0};
    for (int c = first; c <= last; c++) {
        int b = grid_frame_partner(view, c);
        double cutoff = b < 0 ? 0 : view->radius_max[c] + view->radius_max[b] + view->margin[c][b];
        if (cutoff > 0) {
            cutoffs.smallest = fmin(cutoffs.smallest, cutoff);
            cutoffs.largest = fmax(cutoffs.largest, cutoff);
        }
    }
    return cutoffs.largest > 0 ? cutoffs : (struct grid_frame_cutoffs){1, 1};
}

struct extent {
    double low[3], high[3];
    bool finite;
};

static struct extent extent_none(void) {
    struct extent extent = {.finite = true};
    for (int d = 0; d < 3; d++) {
        extent.low[d] = DBL_MAX;
        extent.high[d] = -DBL_MAX;
    }
    return extent;
}

static void extent_add(struct extent *extent, const struct extent *other) {
    for (int d = 0; d < 3; d++) {
        extent->low[d] = fmin(extent->low[d], other->low[d]);
        extent->high[d] = fmax(extent->high[d], other->high[d]);
    }
    extent->finite = extent->finite && other->finite;
}

static void extent_scan(struct extent *extent, const struct index_view *view, size_t begin, size_t end) {
    for (size_t k = begin; k < end; k++) {
        const double *x = view->position + k * view->stride;
        for (int d = 0; d < 3; d++) {
            extent->low[d] = x[d] < extent->low[d] ? x[d] : extent->low[d];
            extent->high[d] = x[d] > extent->high[d] ? x[d] : extent->high[d];
        }
        double null = (x[0] - x[0]) + (x[1] - x[1]) + (x[2] - x[2]);
        extent->finite = extent->finite && null == 0;
    }
}

static struct extent extent_of(const struct index_view *view, size_t begin, size_t end) {
    struct extent all = extent_none();
#pragma omp parallel num_threads(view->threads) if (end - begin > 10000)
    {
        size_t threads = (size_t)omp_get_num_threads();
        size_t thread = (size_t)omp_get_thread_num();
        struct extent mine = extent_none();
        extent_scan(&mine, view, begin + (end - begin) * thread / threads,
                    begin + (end - begin) * (thread + 1) / threads);
#pragma omp critical(scree_frame_extent)
        extent_add(&all, &mine);
    }
    return all;
}

static int compare_doubles(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Bounds in direction d that hold all but outliers: from a sample, with room of 16 times the middle's width.
 */
static void bounds_robust(const struct index_view *view, int d, double room, double bounds[2]) {
    double sample[SAMPLE];
    size_t count = 0;
    size_t step = view->total / SAMPLE + 1;
    for (size_t k = 0; k < view->total && count < SAMPLE; k += step) {
        double x = view->position[k * view->stride + (size_t)d];
        if (x - x == 0) {
            sample[count++] = x;
        }
    }
    if (count == 0) {
        sample[count++] = 0;
    }
    qsort(sample, count, sizeof sample[0], compare_doubles);
    double low = sample[count / 20], high = sample[count - 1 - count / 20];
    double width = 16 * (high - low) + room;
    bounds[0] = low - width;
    bounds[1] = high + width;
}

static void open_direction(struct frame *frame, const struct index_view *view, int d,
                           const struct extent extents[2]) {
    struct extent all = extents[0];
    extent_add(&all, &extents[1]);
    double bounds[2] = {all.low[d], all.high[d]};
    if (!all.finite || !(bounds[1] - bounds[0] < CELLS_ACROSS * frame->unit)) {
        bounds_robust(view, d, 1024 * frame->unit + grid_frame_cutoffs(view, 0, view->classes - 1).largest,
                      bounds);
        bounds[0] = fmax(bounds[0], all.low[d]);
        bounds[1] = fmin(bounds[1], all.high[d]);
    }
    if (!(bounds[0] <= bounds[1])) {
        bounds[0] = bounds[1] = 0;
    }
    frame->low[d] = bounds[0];
    frame->high[d] = bounds[1];
    const struct extent *inner = extents[0].low[d] <= extents[0].high[d] ? &extents[0] : &extents[1];
    double low = fmin(fmax(inner->low[d], bounds[0]), bounds[1]);
    double high = fmax(fmin(inner->high[d], bounds[1]), bounds[0]);
    frame->centre[d] = low + (high - low) / 2;
    frame->owned_low[d] = grid_frame_coordinate(frame, d, low);
    frame->owned_high[d] = grid_frame_coordinate(frame, d, high);
    frame->all_low[d] = grid_frame_coordinate(frame, d, bounds[0]);
    frame->all_high[d] = grid_frame_coordinate(frame, d, bounds[1]);
}

static void periodic_direction(struct frame *frame, const struct index_view *view, int d) {
    double edge = view->edge[d];
    frame->centre[d] = edge / 2;
    frame->low[d] = -edge * 0x1p-20;
    frame->high[d] = edge + edge * 0x1p-20;
    frame->edge[d] = (float)(edge * frame->scale);
    frame->owned_low[d] = frame->all_low[d] = grid_frame_coordinate(frame, d, 0);
    frame->owned_high[d] = frame->all_high[d] = grid_frame_coordinate(frame, d, edge);
}

/* How far the ghost lies inside of the owned particles' extent: the distance to the next open face, 0 if it is beyond.
 */
static float depth_of(const struct frame *frame, const double *x) {
    float depth = INFINITY;
    for (int d = 0; d < 3; d++) {
        if (!frame->periodic[d]) {
            const float at = grid_frame_coordinate(frame, d, x[d]);
            depth = fminf(depth, fminf(at - frame->owned_low[d], frame->owned_high[d] - at));
        }
    }
    return fmaxf(depth, 0);
}

bool grid_frame_meet(struct frame *frame, const struct index_view *view) {
    float depth = 0;
    int out = 0;
#pragma omp parallel for num_threads(view->threads)                                                          \
    reduction(max                                                                                            \
              : depth, out) if (view->total - view->owned > 10000)
    for (size_t k = view->owned; k < view->total; k++) {
        const double *x = view->position + k * view->stride;
        for (int d = 0; d < 3; d++) {
            out = grid_frame_holds(frame, d, x[d]) ? out : 1;
        }
        depth = fmaxf(depth, depth_of(frame, x));
    }
    for (int d = 0; d < 3; d++) {
        frame->hollow_low[d] = frame->owned_low[d] + depth;
        frame->hollow_high[d] = frame->owned_high[d] - depth;
    }
    return out <= 0;
}

/* The extent of the ghosts, or of the places where they will be: where no bound of these is known, they may lie somewhat
 * beyond the owned particles, as a neighbour's heap is somewhat higher. */
static struct extent extent_around(const struct index_view *view, const struct extent *owned) {
    if (!view->around.known || view->total > view->owned || view->owned == 0) {
        return extent_of(view, view->owned, view->total);
    }
    struct extent extent = *owned;
    for (int d = 0; d < 3; d++) {
        const double low = view->around.low[d], high = view->around.high[d];
        const double room = 0.1 * (owned->high[d] - owned->low[d]);
        extent.low[d] = isfinite(low) ? low : owned->low[d] - room;
        extent.high[d] = isfinite(high) ? high : owned->high[d] + room;
    }
    return extent;
}

void grid_frame_make(struct frame *frame, const struct index_view *view) {
    *frame = (struct frame){.unit = grid_frame_cutoffs(view, 0, view->classes - 1).smallest};
    frame->scale = 1 / frame->unit;
    struct extent extents[2] = {extent_none(), extent_none()};
    if (!(view->periodic[0] && view->periodic[1] && view->periodic[2])) {
        extents[0] = extent_of(view, 0, view->owned);
        extents[1] = extent_around(view, &extents[0]);
    }
    double size = 0;
    for (int d = 0; d < 3; d++) {
        frame->periodic[d] = view->periodic[d];
        if (view->periodic[d]) {
            periodic_direction(frame, view, d);
        } else {
            open_direction(frame, view, d, extents);
        }
        size =
            fmax(size, fmax(fabs(frame->low[d] - frame->centre[d]), fabs(frame->high[d] - frame->centre[d])));
    }
    frame->tolerance = (float)(size * frame->scale * 0x1p-20);
    grid_frame_meet(frame, view);
}

void grid_frame_loosen(struct frame *frame) {
    const double size = (double)frame->tolerance * frame->unit * 0x1p20;
    for (int d = 0; d < 3; d++) {
        frame->low[d] = fmin(frame->low[d], frame->centre[d] - 1.5 * size);
        frame->high[d] = fmax(frame->high[d], frame->centre[d] + 1.5 * size);
    }
    frame->tolerance *= 2;
}
