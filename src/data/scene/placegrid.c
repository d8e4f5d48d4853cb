/* SPDX-License-Identifier: BSD-3-Clause */
/* The hashed cells of placed spheres. Read placegrid.h first. */
#include "data/scene/placegrid.h"

#include "base/memory.h"
#include "base/hash.h"

#include <math.h>
#include <stdint.h>

enum { LEVELS_MAX = 40 };

struct sphere {
    double x[3], radius;
    int level;
    int64_t cell[3];
};

struct level {
    double cell[3];    /* cell edges; in periodic directions they divide the box */
    int64_t cells[3];  /* periodic directions: cells around the box; else 0 */
    double radius_max; /* of the spheres on it; 0: none */
};

struct placegrid {
    struct box box;
    double radius_min;
    struct level level[LEVELS_MAX];
    struct sphere *sphere;
    size_t count; /* room for as many as the table */
    struct hash by_cell;
};

struct placegrid *placegrid_create(const struct box *box, double radius_min) {
    struct placegrid *grid = memory_allocate_zero(1, sizeof(*grid), "placed spheres");
    grid->box = *box;
    grid->radius_min = radius_min;
    for (int l = 0; l < LEVELS_MAX; l++)
        for (int d = 0; d < 3; d++) {
            double edge = ldexp(2 * radius_min, l + 1);
            int64_t cells = box->periodic[d] ? (int64_t)fmin(floor(box->edge[d] / edge), 1e9) : 0;
            cells = box->periodic[d] && cells < 1 ? 1 : cells;
            grid->level[l].cells[d] = cells;
            grid->level[l].cell[d] = cells ? box->edge[d] / (double)cells : edge;
        }
    hash_start(&grid->by_cell, 1, "placed spheres");
    grid->sphere = memory_allocate(grid->by_cell.room, sizeof(*grid->sphere), "placed spheres");
    return grid;
}

void placegrid_destroy(struct placegrid **grid) {
    if (!*grid)
        return;
    memory_free((*grid)->sphere);
    hash_free(&(*grid)->by_cell);
    memory_free(*grid);
    *grid = NULL;
}

static int level_of(const struct placegrid *grid, double radius) {
    int exponent;
    frexp(radius / grid->radius_min, &exponent); /* radius < radius_min 2^exponent */
    int level = exponent - 1;
    return level < 0 ? 0 : level >= LEVELS_MAX ? LEVELS_MAX - 1 : level;
}

static void sphere_put(struct placegrid *grid, size_t k) {
    uint64_t key = mix_cell((uint64_t)grid->sphere[k].level, grid->sphere[k].cell);
    hash_put(&grid->by_cell, key, (uint32_t)k);
}

static void grow(struct placegrid *grid) {
    hash_start(&grid->by_cell, grid->count + 1, "placed spheres");
    grid->sphere = memory_resize(grid->sphere, grid->by_cell.room, sizeof(*grid->sphere), "placed spheres");
    for (size_t k = 0; k < grid->count; k++)
        sphere_put(grid, k);
}

/* Cell of a coordinate, not yet wrapped. */
static int64_t cell_at(const struct level *level, int d, double x) {
    return (int64_t)floor(fmin(fmax(x / level->cell[d], -1e15), 1e15)); /* far outside: any cell does */
}

void placegrid_add(struct placegrid *grid, const double x[3], double radius) {
    if (grid->count == grid->by_cell.room)
        grow(grid);
    struct sphere *sphere = &grid->sphere[grid->count];
    *sphere = (struct sphere){.x = {x[0], x[1], x[2]}, .radius = radius, .level = level_of(grid, radius)};
    struct level *level = &grid->level[sphere->level];
    level->radius_max = fmax(level->radius_max, radius);
    for (int d = 0; d < 3; d++) {
        sphere->cell[d] = cell_at(level, d, x[d]);
        if (level->cells[d] && sphere->cell[d] >= level->cells[d])
            sphere->cell[d] = level->cells[d] - 1;
        if (level->cells[d] && sphere->cell[d] < 0)
            sphere->cell[d] = 0;
    }
    sphere_put(grid, grid->count++);
}

static bool cell_touches(const struct placegrid *grid, int level, const int64_t cell[3], const double x[3],
                         double radius) {
    uint32_t k = hash_first(&grid->by_cell, mix_cell((uint64_t)level, cell));
    for (; k != HASH_END; k = grid->by_cell.next[k]) {
        const struct sphere *sphere = &grid->sphere[k];
        double reach = radius + sphere->radius;
        if (sphere->level == level && sphere->cell[0] == cell[0] && sphere->cell[1] == cell[1] &&
            sphere->cell[2] == cell[2] && box_distance2(&grid->box, sphere->x, x) < reach * reach)
            return true;
    }
    return false;
}

static bool level_touches(const struct placegrid *grid, int l, const double x[3], double radius) {
    const struct level *level = &grid->level[l];
    double reach = radius + level->radius_max;
    int64_t first[3], last[3];
    for (int d = 0; d < 3; d++) {
        first[d] = cell_at(level, d, x[d] - reach);
        last[d] = cell_at(level, d, x[d] + reach);
        if (level->cells[d] && last[d] - first[d] >= level->cells[d])
            last[d] = first[d] + level->cells[d] - 1; /* all around, each cell once */
    }
    int64_t cell[3], wrapped[3];
    for (cell[2] = first[2]; cell[2] <= last[2]; cell[2]++)
        for (cell[1] = first[1]; cell[1] <= last[1]; cell[1]++)
            for (cell[0] = first[0]; cell[0] <= last[0]; cell[0]++) {
                for (int d = 0; d < 3; d++) {
                    int64_t n = level->cells[d];
                    wrapped[d] = n ? ((cell[d] % n) + n) % n : cell[d];
                }
                if (cell_touches(grid, l, wrapped, x, radius))
                    return true;
            }
    return false;
}

bool placegrid_touches(const struct placegrid *grid, const double x[3], double radius) {
    for (int l = LEVELS_MAX - 1; l >= 0; l--)
        if (grid->level[l].radius_max > 0 && level_touches(grid, l, x, radius))
            return true;
    return false;
}
