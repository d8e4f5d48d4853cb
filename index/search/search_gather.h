/* SPDX-License-Identifier: BSD-3-Clause */
/* The middle part of the search (search_rows.h tells the whole): which slices of a table hold candidates of a
 * span of rows, by windows around the span, or by the stencil of the class. */
#ifndef SCREE_INDEX_SEARCH_SEARCH_GATHER_H
#define SCREE_INDEX_SEARCH_SEARCH_GATHER_H

#include "index/search/search_pairs.h"

#include <math.h>

/* The parts of the box (three at most) that a window meets in one direction: an image, and cells. */
struct window {
    int parts;
    int image[3], first[3], last[3];
    float shift[3]; /* added to candidates, frame unit */
};

LANES_INLINE uint32_t image_bits(int sx, int sy, int sz) {
    return (sx | sy | sz) == 0 ? 0 : image_code(sx, sy, sz) << INDEX_IMAGE_SHIFT;
}

/* The window [low, high] in direction d. The unshifted box comes first. */
LANES_INLINE struct window window_of(const struct frame *frame, const struct grid *grid, int d, float low,
                                     float high) {
    struct window window = {.parts = 1};
    window.first[0] = grid_cell(grid, d, low);
    window.last[0] = grid_cell(grid, d, high);
    if (!frame->periodic[d] || (low > frame->all_low[d] + frame->tolerance * 4 &&
                                high < frame->all_high[d] - frame->tolerance * 4)) {
        return window;
    }
    float edge = frame->edge[d];
    float slack = edge * 0x1p-18f + 4 * frame->tolerance;
    for (int s = -1; s <= 1; s += 2) {
        float from = low - (float)s * edge, to = high - (float)s * edge;
        if (to >= frame->all_low[d] - slack && from <= frame->all_high[d] + slack) {
            int p = window.parts++;
            window.image[p] = s;
            window.shift[p] = (float)s * edge;
            window.first[p] = grid_cell(grid, d, from);
            window.last[p] = grid_cell(grid, d, to);
        }
    }
    return window;
}

/* True if an image of the box meets the span's own cells: see the head of this file. */
LANES_INLINE bool window_returns(const struct window *window, int own_low, int own_high) {
    for (int p = 1; p < window->parts; p++) {
        if (window->first[p] <= own_high && window->last[p] >= own_low) {
            return true;
        }
    }
    return false;
}

/* The reach in x that remains for the pencil (y, z); -1: the pencil is beyond the reach. low and high bound
 * the rows. */
LANES_INLINE float reach_left(const struct grid *grid, const int cell[3], const float low[3],
                              const float high[3], float reach) {
    float rest = reach * reach;
    for (int d = 1; d < 3; d++) {
        float slack = grid->size[d] * (1e-3f + (float)grid->n[d] * 0x1p-20f);
        float from = grid->anchor[d] + (grid->base[d] + (float)cell[d]) * grid->size[d] - slack;
        float to = from + grid->size[d] + 2 * slack;
        float gap = from - high[d] > low[d] - to ? from - high[d] : low[d] - to;
        rest -= gap > 0 ? gap * gap : 0;
    }
    return rest < 0 ? -1 : sqrtf(rest) * (1 + 0x1p-18f);
}

/* One part of the box: cells first ... last in each direction, seen from rows at low ... high. */
struct part {
    int first[3], last[3];
    float low[3], high[3], shift[3];
    float reach;
    uint32_t bits;
    bool round; /* leave out pencils beyond the reach */
};

/* The run of part's cells in pencil (y, z). */
LANES_INLINE void append_pencil(struct quest *quest, const struct part *part, int y, int z) {
    const struct grid *grid = &quest->search->level->grid;
    int x0 = part->first[0], x1 = part->last[0];
    SEARCH_EVENT(COST_RUN, 1);
    SEARCH_EVENT(COST_SPARSE, quest->search->cells->sparse);
    if (part->round) {
        SEARCH_EVENT(COST_ROUND, 1);
        float left = reach_left(grid, (const int[3]){0, y, z}, part->low, part->high, part->reach);
        if (left < 0) {
            return;
        }
        x0 = grid_cell(grid, 0, part->low[0] - left);
        x1 = grid_cell(grid, 0, part->high[0] + left);
    }
    append(quest, cells_run(quest->search->cells, grid, x0, x1, y, z), part->shift, part->bits);
}

/* Appends the candidates of a part from a sparse table with fewer pencils than the part, pencil by pencil.
 * The pencils before `start` hold no new pairs. */
LANES_INLINE void append_all_pencils(struct quest *quest, const struct part *part, size_t start) {
    const struct cells *cells = quest->search->cells;
    for (size_t p = start; p < cells->pencils; p++) {
        int y = (int)(uint32_t)cells->pencil[p], z = (int)(cells->pencil[p] >> 32);
        if (y < part->first[1] || y > part->last[1] || z < part->first[2] || z > part->last[2]) {
            continue;
        }
        SEARCH_EVENT(COST_RUN, 1);
        SEARCH_EVENT(COST_SPARSE, 1);
        struct cells_slice slice = {cells_bisect(cells, (int64_t)p, part->first[0]),
                                    cells_bisect(cells, (int64_t)p, part->last[0] + 1)};
        append(quest, slice, part->shift, part->bits);
    }
}

LANES_INLINE bool empty_rows(const struct cells *cells, const struct grid *grid, int y0, int y1, int z) {
    size_t row = (size_t)z * (size_t)grid->n[1], n = (size_t)grid->n[0];
    return !cells->sparse && cells->begin[(row + (size_t)y0) * n] == cells->begin[(row + (size_t)y1 + 1) * n];
}

/* Appends all pencils of a part. With `own`: only the block's own pencil, first, and the pencils after it. */
LANES_INLINE void append_part(struct quest *quest, const struct part *part, bool own) {
    const struct cells *cells = quest->search->cells;
    const struct grid *grid = &quest->search->level->grid;
    int own_y = quest->span.own_low[1], own_z = quest->span.own_low[2];
    size_t pencils =
        (size_t)(part->last[1] - part->first[1] + 1) * (size_t)(part->last[2] - part->first[2] + 1);
    if (cells->sparse && pencils > cells->pencils) {
        append_all_pencils(quest, part, own ? (size_t)cells_find_pencil(cells, own_y, own_z) : 0);
        return;
    }
    for (int z = own ? own_z : part->first[2]; z <= part->last[2]; z++) {
        int y0 = own && z == own_z ? own_y : part->first[1];
        SEARCH_EVENT(COST_RUN, !cells->sparse);
        if (empty_rows(cells, grid, y0, part->last[1], z)) {
            continue;
        }
        for (int y = y0; y <= part->last[1]; y++) {
            append_pencil(quest, part, y, z);
        }
    }
}

/* Candidates within the reach of the span, by windows. False if rows must go one by one. */
LANES_INLINE bool gather_windows(struct quest *quest) {
    const struct frame *frame = &quest->levels->frame;
    const struct search *search = quest->search;
    const struct span *span = &quest->span;
    const struct grid *grid = &search->level->grid;
    struct part part = {.reach = span->r_max + search->reach};
    struct window window[3];
    bool returns = false;
    for (int d = 0; d < 3; d++) {
        window[d] = window_of(frame, grid, d, span->low[d] - part.reach, span->high[d] + part.reach);
        returns = returns || window_returns(&window[d], span->own_low[d], span->own_high[d]);
    }
    if (search->half && returns && span->to - span->from > 1) {
        return false;
    }
    for (int pz = 0; pz < window[2].parts; pz++) {
        for (int py = 0; py < window[1].parts; py++) {
            for (int px = 0; px < window[0].parts; px++) {
                const int p[3] = {px, py, pz};
                for (int d = 0; d < 3; d++) {
                    part.first[d] = window[d].first[p[d]];
                    part.last[d] = window[d].last[p[d]];
                    part.shift[d] = window[d].shift[p[d]];
                    part.low[d] = span->low[d] - part.shift[d];
                    part.high[d] = span->high[d] - part.shift[d];
                }
                part.bits = image_bits(window[0].image[px], window[1].image[py], window[2].image[pz]);
                part.round = part.last[1] - part.first[1] + part.last[2] - part.first[2] > 5;
                append_part(quest, &part, search->half && part.bits == 0);
            }
        }
    }
    return true;
}

/* Wraps cell c of direction d into the box; false if it lies in no box that is searched. */
LANES_INLINE bool wrap_cell(const struct frame *frame, const struct grid *grid, int d, int *c, int *image) {
    int n = grid->n[d];
    *image = *c < 0 ? -1 : *c >= n ? 1 : 0;
    *c -= *image * n;
    return *image == 0 || (frame->periodic[d] && *c >= 0 && *c < n);
}

/* The cells c - dx ... c + dx of a pencil, cut at the ends of the box. */
LANES_INLINE void append_stencil_run(struct quest *quest, const struct stencil_run *run, int cx,
                                     const int yz[2], const int image_yz[2]) {
    const struct frame *frame = &quest->levels->frame;
    const struct grid *grid = &quest->search->level->grid;
    int n = grid->n[0];
    for (int s = 0; s < 3; s++) {
        int image = s == 0 ? 0 : 2 * s - 3;
        int x0 = cx - run->dx - image * n, x1 = cx + run->dx - image * n;
        x0 = x0 > 0 ? x0 : 0;
        x1 = x1 < n - 1 ? x1 : n - 1;
        if (x0 > x1 || (image != 0 && !frame->periodic[0])) {
            continue;
        }
        const float shift[3] = {(float)image * frame->edge[0], (float)image_yz[0] * frame->edge[1],
                                (float)image_yz[1] * frame->edge[2]};
        append(quest, cells_run(quest->search->cells, grid, x0, x1, yz[0], yz[1]), shift,
               image_bits(image, image_yz[0], image_yz[1]));
    }
}

/* Candidates by the stencil of the class; the block lies in one cell. False if rows must go one by one. */
LANES_INLINE bool gather_stencil(struct quest *quest) {
    const struct frame *frame = &quest->levels->frame;
    const struct search *search = quest->search;
    const struct stencil *stencil = search->stencil;
    const struct grid *grid = &search->level->grid;
    const int *own = quest->span.own_low;
    for (int d = 0; d < 3; d++) {
        if (search->half && quest->span.to - quest->span.from > 1 && frame->periodic[d] &&
            stencil->extent[d] >= grid->n[d]) {
            return false;
        }
    }
    if (search->half) {
        const int yz[2] = {own[1], own[2]}, here[2] = {0, 0};
        append_stencil_run(quest, &stencil->run[stencil->middle], own[0], yz, here);
    }
    for (size_t k = 0; k < stencil->count; k++) {
        int yz[2] = {own[1] + stencil->run[k].dy, own[2] + stencil->run[k].dz}, image[2];
        bool inside =
            wrap_cell(frame, grid, 1, &yz[0], &image[0]) && wrap_cell(frame, grid, 2, &yz[1], &image[1]);
        bool earlier = search->half && image[0] == 0 && image[1] == 0 && k <= stencil->middle;
        if (inside && !earlier) {
            append_stencil_run(quest, &stencil->run[k], own[0], yz, image);
        }
    }
    return true;
}

/* True if the span's reach ends where no ghost lies. */
LANES_INLINE bool span_inside(const struct quest *quest) {
    const struct frame *frame = &quest->levels->frame;
    const struct span *span = &quest->span;
    const float reach = span->r_max + quest->search->reach;
    for (int d = 0; d < 3; d++) {
        if (!frame->periodic[d] &&
            !(span->low[d] - reach > frame->hollow_low[d] && span->high[d] + reach < frame->hollow_high[d])) {
            return false;
        }
    }
    return true;
}

LANES_INLINE bool gather(struct quest *quest) {
    quest->buffer.count = 0;
    quest->buffer.continued = false;
    if (quest->search->beyond && span_inside(quest)) {
        return true;
    }
    return quest->search->stencil != NULL ? gather_stencil(quest) : gather_windows(quest);
}

#endif
