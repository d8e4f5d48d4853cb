/* SPDX-License-Identifier: BSD-3-Clause */
/* Chooses the grid of bricks, by area or by load. Read domain_grid.h first. */
#include "kernel/comm/domain_grid.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

/* The price of a grid: first the area along which the grid cuts the box, then the thinnest part that a cut
 * leaves. */
struct grid_price {
    double area, thinnest;
};

static struct grid_price price_of(const int grid[3], const struct box *box) {
    struct grid_price price = {0, INFINITY};
    for (int d = 0; d < 3; d++) {
        if (grid[d] == 1)
            continue;
        int faces = box->periodic[d] ? grid[d] : grid[d] - 1;
        price.area += faces * box->edge[(d + 1) % 3] * box->edge[(d + 2) % 3];
        price.thinnest = fmin(price.thinnest, box->edge[d] / grid[d]);
    }
    return price;
}

static bool price_better(struct grid_price a, struct grid_price b) {
    const double equal = 1e-12;
    if (fabs(a.area - b.area) > equal * b.area)
        return a.area < b.area;
    return a.thinnest > b.thinnest * (1 + equal);
}

static bool grid_allowed(const int grid[3], const struct box *box, const int wanted[3]) {
    for (int d = 0; d < 3; d++)
        if (wanted[d] != 0 && wanted[d] != grid[d])
            return false;
    return box->dimension == 3 || grid[2] == 1;
}

/* The share of bin b along an axis that lies in slab i of n. */
static double bin_share(int b, int i, int n) {
    double bins = DOMAIN_DENSITY_BINS, low = fmax(b / bins, (double)i / n);
    double high = fmin((b + 1) / bins, (i + 1.0) / n);
    return fmax(high - low, 0) * bins;
}

/* The bins merged along one axis into n slabs: from `planes` x BINS x `inner` values to `planes` x n x
 * `inner`. */
static void bins_merge(const double *from, size_t planes, size_t inner, int n, double *to) {
    memset(to, 0, planes * (size_t)n * inner * sizeof *to);
    for (size_t p = 0; p < planes; p++)
        for (int b = 0; b < DOMAIN_DENSITY_BINS; b++)
            for (int i = b * n / DOMAIN_DENSITY_BINS; i < n && i * DOMAIN_DENSITY_BINS < (b + 1) * n; i++) {
                const double *row = from + (p * DOMAIN_DENSITY_BINS + (size_t)b) * inner;
                double share = bin_share(b, i, n), *sum = to + (p * (size_t)n + (size_t)i) * inner;
                for (size_t k = 0; k < inner; k++)
                    sum[k] += share * row[k];
            }
}

/* The largest number of particles in a brick. */
static double grid_load(const int grid[3], const double *density) {
    size_t bins = DOMAIN_DENSITY_BINS, x = (size_t)grid[0], y = (size_t)grid[1], z = (size_t)grid[2];
    double *along_z = memory_allocate(z * bins * bins, sizeof *along_z, "loads");
    double *along_y = memory_allocate(z * y * bins, sizeof *along_y, "loads");
    double *bricks = memory_allocate(z * y * x, sizeof *bricks, "loads"), most = 0;
    bins_merge(density, 1, bins * bins, grid[2], along_z);
    bins_merge(along_z, z, bins, grid[1], along_y);
    bins_merge(along_y, z * y, 1, grid[0], bricks);
    for (size_t k = 0; k < x * y * z; k++)
        most = fmax(most, bricks[k]);
    memory_free(along_z);
    memory_free(along_y);
    memory_free(bricks);
    return most;
}

/* Calls `look` with each way to write `size` as a product of three that is allowed. Larger numbers come first
 * in y, then x. Particles are sorted by z, y and x, so the particles at a face in y lie together in memory,
 * and the particles at a face in x do not. With gravity along z all columns are filled alike. In 2D gravity
 * is along y. */
static void grids_each(int size, const struct box *box, const int wanted[3],
                       void (*look)(void *context, const int grid[3]), void *context) {
    const int first = box->dimension == 2 ? 0 : 1;
    for (int a = size; a >= 1; a--) {
        if (size % a != 0)
            continue;
        for (int b = size / a; b >= 1; b--) {
            int grid[3];
            grid[first] = a;
            grid[1 - first] = b;
            grid[2] = size / a / b;
            if (size / a % b == 0 && grid_allowed(grid, box, wanted))
                look(context, grid);
        }
    }
}

/* The search for the best grid. */
struct grid_search {
    const struct box *box;
    const double *density; /* NULL: loads do not matter */
    double bound;          /* on the largest load */
    bool found;
    struct grid_price least;
    int best[3];
};

static void look_for_load(void *context, const int grid[3]) {
    struct grid_search *search = context;
    search->bound = fmin(search->bound, grid_load(grid, search->density));
}

static void look_for_area(void *context, const int grid[3]) {
    struct grid_search *search = context;
    struct grid_price price = price_of(grid, search->box);
    if ((search->found && !price_better(price, search->least)) ||
        (search->density && grid_load(grid, search->density) > search->bound))
        return;
    search->least = price;
    search->found = true;
    memcpy(search->best, grid, sizeof search->best);
}

static double density_sum(const double *density) {
    double sum = 0;
    for (int k = 0; density && k < DOMAIN_DENSITY_BINS * DOMAIN_DENSITY_BINS * DOMAIN_DENSITY_BINS; k++)
        sum += density[k];
    return sum;
}

bool domain_grid_choose(int size, const struct box *box, const int wanted[3], const double *density,
                        int best[3]) {
    double particles = density_sum(density);
    struct grid_search search = {.box = box, .bound = INFINITY};
    if (particles > 0) {
        search.density = density;
        grids_each(size, box, wanted, look_for_load, &search);
        search.bound *= 1.1 + 3 / sqrt(particles / size); /* a tenth, and the error of the counts */
    }
    grids_each(size, box, wanted, look_for_area, &search);
    memcpy(best, search.best, sizeof search.best);
    return search.found;
}

bool domain_grid_refuse(int size, const struct box *box, const int wanted[3], struct error *error) {
    if (box->dimension == 2 && wanted[2] > 1)
        return error_set(error, ERROR_USER,
                         "domain grid %d x %d x %d: a 2D box is not divided in z; allowed there are 0 and 1",
                         wanted[0], wanted[1], wanted[2]);
    return error_set(error, ERROR_USER,
                     "domain grid %d x %d x %d does not fit %d rank%s: the product must be the number of "
                     "ranks; 0 leaves a direction to the program",
                     wanted[0], wanted[1], wanted[2], size, size == 1 ? "" : "s");
}
