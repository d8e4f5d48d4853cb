/* SPDX-License-Identifier: BSD-3-Clause */
/* A table of particles in cell order: the part of a grid that holds the owned particles, or the ghosts.
 *
 * Slots are sorted by (z cell, y cell, x cell), and within a cell by particle number. A *pencil* is a row of
 * cells in x, so that the particles of any run of cells of a pencil are one slice of slots. Two forms:
 *
 *   dense    begin[cell], for every cell of the grid
 *   sparse   only pencils with particles: their keys in order, their slices, the x cell of each slot
 *            (searched by bisection), and a hash from key to pencil. Memory grows with the particles alone */
#ifndef SCREE_INDEX_GRIDS_CELLS_TABLE_H
#define SCREE_INDEX_GRIDS_CELLS_TABLE_H

#include "base/hash.h"
#include "index/grids/grid.h"
#include "index/grids/members.h"

struct cells {
    size_t count;
    float *x, *y, *z;   /* frame coordinates of each slot */
    float *r;           /* radius of each slot, frame unit, larger by a factor 1 + CELLS_RADIUS_EXCESS */
    uint32_t *particle; /* number of each slot's particle */
    float r_min, r_max; /* over r; 0 if empty */
    bool in_order;      /* the particles came in the order of the slots */
    bool moved;         /* the particles have moved since the cells were made (cells_follow): */
    float *origin[3];   /* the coordinates by which each slot has its cell ... */
    float drift;        /* ... and the largest distance from there, frame unit; 0 unless moved */
    bool clamped;       /* some coordinate was clamped by the frame */
    bool sparse;
    uint32_t *begin;    /* dense: grid cells + 1; sparse: pencils + 1 */
    size_t pencils;     /* sparse only, as all members below */
    uint64_t *pencil;   /* y + (z << 32) of each pencil, ascending in (z, y) */
    uint32_t *x_cell;   /* of each slot */
    struct hash by_key; /* the pencils */
    size_t capacity, place_capacity, origin_capacity, begin_capacity, pencil_capacity, x_cell_capacity;
    size_t occupied; /* sparse: cells with particles */
};

/* Number of slots behind the last one that hold a place far from every particle: searches read whole
 * vectors. */
enum { CELLS_PAD = 16 };

#define CELLS_RADIUS_EXCESS 0x1p-19

/* Scratch of the sort, one for all tables of an index. */
struct cells_scratch {
    uint64_t *key, *bucket_key;
    uint32_t *bucket_particle;
    size_t capacity;
    size_t *histogram;
    size_t histogram_capacity;
};

/* Source of a table: group g of the members. */
struct cells_source {
    const struct index_view *view;
    const struct frame *frame;
    const struct grid *grid;
    const struct members *members;
    int group;
    bool sparse;
};

#endif
