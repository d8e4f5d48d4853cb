/* SPDX-License-Identifier: BSD-3-Clause */
/* Cuts edges and corners flat. Read chamfer.h first.
 *
 * Each corner of a face, moved out by the rounding, is a corner of the surface; it has the number of its entry in the ring of the solid. */
#include "physics/bodies/shapes/chamfer.h"
#include "base/memory.h"

/* Where entries of the ring lie. */
struct around {
    const struct solid *core;
    int *face;     /* of each entry */
    int (*has)[2]; /* entries at which each edge begins, from either end */
};

static int next_of(const struct around *around, int entry) {
    const struct solid_face *face = &around->core->face[around->face[entry]];
    return face->first + (entry - face->first + 1) % face->sides;
}

static int last_of(const struct around *around, int entry) {
    const struct solid_face *face = &around->core->face[around->face[entry]];
    return face->first + (entry - face->first + face->sides - 1) % face->sides;
}

/* The entry in the other face beside the edge that begins at an entry; it begins at the other end of the edge. */
static int across(const struct around *around, int entry) {
    const int *has = around->has[around->core->rim[entry]];
    return has[0] == entry ? has[1] : has[0];
}

static void around_make(struct around *around, const struct solid *core) {
    *around =
        (struct around){.core = core,
                        .face = memory_allocate((size_t)core->rings, sizeof *around->face, "faces of a rock"),
                        .has = memory_allocate((size_t)core->edges, sizeof *around->has, "edges of a rock")};
    for (int e = 0; e < core->edges; e++)
        around->has[e][0] = -1;
    for (int f = 0; f < core->faces; f++)
        for (int k = core->face[f].first; k < core->face[f].first + core->face[f].sides; k++) {
            int *has = around->has[core->rim[k]];
            around->face[k] = f;
            has[has[0] < 0 ? 0 : 1] = k;
        }
}

static void polygon_end(struct chamfer *chamfer, int rings) {
    chamfer->start[++chamfer->polygons] = rings;
}

/* From a face to the face before it around the corner of an entry, until the first comes again. */
static int corner_add(struct chamfer *chamfer, const struct around *around, int entry, bool *done,
                      int rings) {
    while (!done[entry]) {
        done[entry] = true;
        chamfer->ring[rings++] = entry;
        entry = across(around, last_of(around, entry));
    }
    polygon_end(chamfer, rings);
    return rings;
}

void chamfer_make(struct chamfer *chamfer, const struct solid *core, double rounding) {
    const size_t entries = (size_t)core->rings;
    const size_t polygons = (size_t)(core->faces + core->edges + core->corners);
    struct around around;
    int rings = 0;
    around_make(&around, core);
    *chamfer = (struct chamfer){
        .corners = core->rings,
        .corner = memory_allocate(entries, sizeof *chamfer->corner, "surface of a rock"),
        .start = memory_allocate_zero(polygons + 1, sizeof *chamfer->start, "surface of a rock"),
        .ring = memory_allocate(2 * entries + 4 * (size_t)core->edges, sizeof *chamfer->ring,
                                "surface of a rock")};
    for (int k = 0; k < core->rings; k++)
        for (int d = 0; d < 3; d++)
            chamfer->corner[k][d] =
                core->corner[core->ring[k]][d] + rounding * core->face[around.face[k]].normal[d];
    for (int f = 0; f < core->faces; f++) {
        for (int k = 0; k < core->face[f].sides; k++)
            chamfer->ring[rings++] = core->face[f].first + k;
        polygon_end(chamfer, rings);
    }
    for (int e = 0; e < core->edges; e++) {
        const int here = around.has[e][0], there = around.has[e][1];
        const int strip[4] = {next_of(&around, here), here, next_of(&around, there), there};
        for (int k = 0; k < 4; k++)
            chamfer->ring[rings++] = strip[k];
        polygon_end(chamfer, rings);
    }
    bool *done = memory_allocate_zero(entries, sizeof *done, "surface of a rock");
    for (int k = 0; k < core->rings; k++)
        if (!done[k])
            rings = corner_add(chamfer, &around, k, done, rings);
    memory_free(done);
    memory_free(around.face);
    memory_free(around.has);
}

void chamfer_free(struct chamfer *chamfer) {
    memory_free(chamfer->corner);
    memory_free(chamfer->start);
    memory_free(chamfer->ring);
    *chamfer = (struct chamfer){0};
}
