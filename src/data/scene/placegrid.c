/* SPDX-License-Identifier: BSD-3-Clause */
/* The hashed cells of placed spheres. Read placegrid.h first. */
#include "data/scene/placegrid.h"

#include "base/memory.h"

#include <math.h>
#include <stdint.h>

enum { LEVELS_MAX = 40 };

struct sphere {
    double x[3], radius;
    uint32_t next; /* in the chain of its bucket, + 1; 0: end */
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
    size_t count, capacity;
    uint32_t *bucket; /* first sphere + 1, 0: empty */
    size_t buckets;   /* a power of two */
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
    grid->buckets = 1024;
    grid->bucket = memory_allocate_zero(grid->buckets, sizeof(*grid->bucket), "placed spheres");
    return grid;
}

void placegrid_destroy(struct placegrid **grid) {
    if (!*grid)
        return;
    memory_free((*grid)->sphere);
    memory_free((*grid)->bucket);
    memory_free(*grid);
    *grid = NULL;
}

static int level_of(const struct placegrid *grid, double radius) {
    int exponent;
    frexp(radius / grid->radius_min, &exponent); /* radius < radius_min 2^exponent */
    int level = exponent - 1;
    return level < 0 ? 0 : level >= LEVELS_MAX ? LEVELS_MAX - 1 : level;
}

static size_t bucket_of(const struct placegrid *grid, int level, const int64_t cell[3]) {
    uint64_t h = (uint64_t)level * 0x9e3779b97f4a7c15u;
    for (int d = 0; d < 3; d++) {
        h ^= (uint64_t)cell[d] + 0x9e3779b97f4a7c15u + (h << 6) + (h >> 2);
        h *= 0xbf58476d1ce4e5b9u;
        h ^= h >> 29;
    }
    return (size_t)h & (grid->buckets - 1);
}

static void link_sphere(struct placegrid *grid, size_t k) {
    size_t b = bucket_of(grid, grid->sphere[k].level, grid->sphere[k].cell);
    grid->sphere[k].next = grid->bucket[b];
    grid->bucket[b] = (uint32_t)(k + 1);
}

static void grow(struct placegrid *grid) {
    grid->capacity = grid->capacity ? 2 * grid->capacity : 1024;
    grid->sphere = memory_resize(grid->sphere, grid->capacity, sizeof(*grid->sphere), "placed spheres");
    grid->buckets = 2 * grid->capacity;
    memory_free(grid->bucket);
    grid->bucket = memory_allocate_zero(grid->buckets, sizeof(*grid->bucket), "placed spheres");
    for (size_t k = 0; k < grid->count; k++)
        link_sphere(grid, k);
}

/* Cell of a coordinate, not yet wrapped. */
static int64_t cell_at(const struct level *level, int d, double x) {
    return (int64_t)floor(fmin(fmax(x / level->cell[d], -1e15), 1e15)); /* far outside: any cell does */
}

void placegrid_add(struct placegrid *grid, const double x[3], double radius) {
    if (grid->count == grid->capacity)
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
    link_sphere(grid, grid->count++);
}

static bool cell_touches(const struct placegrid *grid, int level, const int64_t cell[3], const double x[3],
                         double radius) {
    for (uint32_t k = grid->bucket[bucket_of(grid, level, cell)]; k; k = grid->sphere[k - 1].next) {
        const struct sphere *sphere = &grid->sphere[k - 1];
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
