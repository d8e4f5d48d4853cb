/* SPDX-License-Identifier: BSD-3-Clause */
/* Enters triangles into cells and asks for those near a place. Read wall_grid.h first. */
#include "physics/grains/walls/wall_grid.h"
#include "physics/grains/walls/wall_touch.h"
#include "base/memory.h"
#include "base/scan.h"

enum { CELLS_PER_TRIANGLE = 2, CELLS_LEAST = 8, CELLS_ALONG_MAX = 1024 };

struct cell_range {
    int low[3], high[3];
};

struct wall_grid {
    const struct wall_mesh *mesh;
    double lower[3], edge[3]; /* of the box around the mesh */
    double width;             /* of a cell */
    int cells[3];
    size_t *start;            /* cells + 1 */
    int32_t *triangle;        /* of cell c: triangle[start[c]] ... */
    struct cell_range *range; /* of each triangle */
};

static size_t grid_cells(const struct wall_grid *grid) {
    return (size_t)grid->cells[0] * (size_t)grid->cells[1] * (size_t)grid->cells[2];
}

/* Cells of a width along each direction, one at least. */
static void grid_divide(struct wall_grid *grid, double width) {
    grid->width = width;
    for (int d = 0; d < 3; d++) {
        grid->cells[d] = (int)ceil(grid->edge[d] / width);
        grid->cells[d] = grid->cells[d] < 1 ? 1 : grid->cells[d];
    }
}

static int clamp_cell(double at, int cells) {
    return at < 0.0 ? 0 : at >= cells ? cells - 1 : (int)at;
}

/* The cells that a box meets; the cells at the border also stand for all places beyond. */
static struct cell_range range_of(const struct wall_grid *grid, const double low[3], const double high[3]) {
    struct cell_range range;
    for (int d = 0; d < 3; d++) {
        range.low[d] = clamp_cell((low[d] - grid->lower[d]) / grid->width, grid->cells[d]);
        range.high[d] = clamp_cell((high[d] - grid->lower[d]) / grid->width, grid->cells[d]);
    }
    return range;
}

static struct cell_range triangle_range(const struct wall_grid *grid, size_t t) {
    const struct law_vector *c = grid->mesh->triangle[t].corner;
    double low[3] = {fmin(fmin(c[0].x, c[1].x), c[2].x), fmin(fmin(c[0].y, c[1].y), c[2].y),
                     fmin(fmin(c[0].z, c[1].z), c[2].z)};
    double high[3] = {fmax(fmax(c[0].x, c[1].x), c[2].x), fmax(fmax(c[0].y, c[1].y), c[2].y),
                      fmax(fmax(c[0].z, c[1].z), c[2].z)};
    return range_of(grid, low, high);
}

static size_t cell_number(const struct wall_grid *grid, const int cell[3]) {
    return ((size_t)cell[2] * (size_t)grid->cells[1] + (size_t)cell[1]) * (size_t)grid->cells[0] +
           (size_t)cell[0];
}

/* Adds a triangle to the cells of its range: counts, or writes at the cells' cursors. */
static void grid_enter(struct wall_grid *grid, size_t t, size_t *cursor, bool write) {
    struct cell_range range = grid->range[t];
    int cell[3];
    for (cell[2] = range.low[2]; cell[2] <= range.high[2]; cell[2]++)
        for (cell[1] = range.low[1]; cell[1] <= range.high[1]; cell[1]++)
            for (cell[0] = range.low[0]; cell[0] <= range.high[0]; cell[0]++) {
                size_t at = cursor[cell_number(grid, cell)]++;
                if (write)
                    grid->triangle[at] = (int32_t)t;
            }
}

struct wall_grid *wall_grid_create(const struct wall_mesh *mesh) {
    struct wall_grid *grid = memory_allocate_zero(1, sizeof *grid, "grid of a mesh");
    struct law_vector edge = law_add(mesh->upper, -1.0, mesh->lower);
    *grid = (struct wall_grid){.mesh = mesh,
                               .lower = {mesh->lower.x, mesh->lower.y, mesh->lower.z},
                               .edge = {edge.x, edge.y, edge.z}};
    double width = fmax(fmax(edge.x, edge.y), edge.z), least = width / CELLS_ALONG_MAX;
    size_t wanted = CELLS_PER_TRIANGLE * mesh->triangles + CELLS_LEAST;
    grid_divide(grid, width);
    while (grid_cells(grid) < wanted && 0.8 * width >= least)
        grid_divide(grid, width *= 0.8);
    grid->range = memory_allocate(mesh->triangles, sizeof *grid->range, "grid of a mesh");
    for (size_t t = 0; t < mesh->triangles; t++)
        grid->range[t] = triangle_range(grid, t);
    size_t cells = grid_cells(grid);
    size_t *cursor = memory_allocate_zero(cells, sizeof *cursor, "grid of a mesh");
    for (size_t t = 0; t < mesh->triangles; t++)
        grid_enter(grid, t, cursor, false);
    grid->start = memory_allocate(cells + 1, sizeof *grid->start, "grid of a mesh");
    grid->triangle =
        memory_allocate(scan_sizes(cursor, cells, grid->start), sizeof *grid->triangle, "grid of a mesh");
    for (size_t c = 0; c < cells; c++)
        cursor[c] = grid->start[c];
    for (size_t t = 0; t < mesh->triangles; t++)
        grid_enter(grid, t, cursor, true);
    memory_free(cursor);
    return grid;
}

void wall_grid_destroy(struct wall_grid **grid) {
    if (*grid == NULL)
        return;
    memory_free((*grid)->start);
    memory_free((*grid)->triangle);
    memory_free((*grid)->range);
    memory_free(*grid);
    *grid = NULL;
}

/* True in the first cell that a query and a triangle share: there the triangle is looked at. */
static bool first_shared(const struct cell_range *query, const struct cell_range *triangle,
                         const int cell[3]) {
    for (int d = 0; d < 3; d++)
        if (cell[d] != (query->low[d] > triangle->low[d] ? query->low[d] : triangle->low[d]))
            return false;
    return true;
}

static size_t query_cell(const struct wall_grid *grid, const struct cell_range *query, const int cell[3],
                         struct law_vector x, double reach, int32_t *out) {
    size_t c = cell_number(grid, cell), count = 0;
    for (size_t k = grid->start[c]; k < grid->start[c + 1]; k++) {
        int32_t t = grid->triangle[k];
        if (!first_shared(query, &grid->range[t], cell) ||
            !(wall_touch_nearest(grid->mesh, t, x, reach).distance < reach))
            continue;
        if (out)
            out[count] = t;
        count++;
    }
    return count;
}

size_t wall_grid_query(const struct wall_grid *grid, struct law_vector x, double reach, int32_t *out) {
    double at[3] = {x.x, x.y, x.z}, low[3], high[3];
    for (int d = 0; d < 3; d++) {
        low[d] = at[d] - reach;
        high[d] = at[d] + reach;
        if (high[d] < grid->lower[d] || low[d] > grid->lower[d] + grid->edge[d])
            return 0;
    }
    struct cell_range query = range_of(grid, low, high);
    size_t count = 0;
    int cell[3];
    for (cell[2] = query.low[2]; cell[2] <= query.high[2]; cell[2]++)
        for (cell[1] = query.low[1]; cell[1] <= query.high[1]; cell[1]++)
            for (cell[0] = query.low[0]; cell[0] <= query.high[0]; cell[0]++)
                count += query_cell(grid, &query, cell, x, reach, out ? out + count : NULL);
    return count;
}
