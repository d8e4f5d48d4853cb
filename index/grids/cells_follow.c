/* SPDX-License-Identifier: BSD-3-Clause */
/* Tables whose particles have moved and stay in their cells: searches reach farther by the drift. Read cells.h first.
 */
#include "base/clones.h"
#include "base/image.h"
#include "base/memory.h"
#include "index/grids/cells.h"
#include "index/grids/cells_slots.h"
#include "index/grids/cells_sort.h"

#include <math.h>
#include <string.h>

/* The coordinates that the cells were made by become the origin. */
static void leave_origin(struct cells *cells) {
    for (int d = 0; d < 3 && cells->origin_capacity != cells->place_capacity; d++) {
        memory_free(cells->origin[d]);
        cells->origin[d] = memory_allocate(cells->place_capacity, sizeof(float), "index coordinates");
    }
    cells->origin_capacity = cells->place_capacity;
    float **const place[3] = {&cells->x, &cells->y, &cells->z};
    for (int d = 0; d < 3; d++) {
        float *now = *place[d];
        *place[d] = cells->origin[d];
        cells->origin[d] = now;
    }
    cells->moved = true;
}

/* The square of the distance that no particle goes without crossing a periodic face. */
static float crossing2(const struct frame *frame) {
    float half = INFINITY;
    for (int d = 0; d < 3; d++) {
        half = frame->periodic[d] ? fminf(half, frame->edge[d] / 2) : half;
    }
    return half * half;
}

/* Brings the particles of the batch that have crossed a face since back to the images near their cells; true if there are
 * some. */
static bool batch_turn(const struct cells *cells, const struct cells_source *source, size_t k,
                       struct located *located, uint8_t *turn) {
    const struct frame *frame = source->frame;
    const struct index_view *view = source->view;
    const size_t first = source->members->begin[source->group] + k;
    bool some = false;
    for (size_t m = 0; m < located->count; m++) {
        const double *x = view->position + members_get(source->members, first + m) * view->stride;
        int image[3] = {0, 0, 0};
        for (int d = 0; d < 3; d++) {
            float apart = located->x[d][m] - cells->origin[d][k + m];
            if (frame->periodic[d] && fabsf(apart) > frame->edge[d] / 2) {
                image[d] = apart > 0 ? -1 : 1;
                some = true;
                located->x[d][m] = grid_frame_coordinate(frame, d, x[d] + image[d] * view->edge[d]);
            }
        }
        turn[m] = (uint8_t)image_code(image[0], image[1], image[2]);
    }
    return some;
}

/* The square of the largest distance of the batch from its origin. */
SCREE_CLONES static float batch_drift(const struct cells *cells, size_t k, const struct located *located) {
    const float *restrict ox = cells->origin[0] + k, *restrict oy = cells->origin[1] + k,
                          *restrict oz = cells->origin[2] + k;
    const float *restrict x = located->x[0], *restrict y = located->x[1], *restrict z = located->x[2];
    const size_t n = located->count;
    int32_t most = 0;
    for (size_t m = 0; m < n; m++) {
        float dx = x[m] - ox[m], dy = y[m] - oy[m], dz = z[m] - oz[m];
        int32_t square = cells_bits(dx * dx + dy * dy + dz * dz);
        most = square > most ? square : most;
    }
    return cells_float(most);
}

bool cells_follow(struct cells *cells, const struct cells_source *source, uint8_t *turn) {
    const float crossing = crossing2(source->frame);
    unsigned turned = 0;
    if (!cells->moved) {
        leave_origin(cells);
    }
    cells_bounds_start(cells);
#pragma omp parallel num_threads(source->view->threads)                                                      \
    reduction(|                                                                                              \
              : turned) if (cells->count > CELLS_THREADED)
    {
        struct cells_range range = cells_share(cells->count);
        struct cells mine = *cells;
        struct located located;
        float drift2 = 0;
        for (size_t k = range.begin; k < range.end; k += located.count) {
            located.count = range.end - k < LOCATE_BATCH ? range.end - k : LOCATE_BATCH;
            cells_locate(&located, source, k);
            uint8_t *codes = turn + members_get(source->members, source->members->begin[source->group] + k);
            memset(codes, 0, located.count);
            float square = batch_drift(cells, k, &located);
            if (square >= crossing && batch_turn(cells, source, k, &located, codes)) {
                square = batch_drift(cells, k, &located);
                turned = 1;
            }
            drift2 = square > drift2 ? square : drift2;
            mine.clamped = mine.clamped || located.clamped;
            cells_slots_put(&mine, source->frame, k, &located);
        }
        mine.drift = sqrtf(drift2) * (1 + 0x1p-18f) + 2 * source->frame->tolerance;
        /* the merge begins when every thread has its copy of the bounds */
#pragma omp barrier
        cells_bounds_merge(cells, &mine, true);
    }
    cells_slots_pad(cells);
    return turned != 0;
}
