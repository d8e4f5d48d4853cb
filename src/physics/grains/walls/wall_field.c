/* SPDX-License-Identifier: BSD-3-Clause */
/* Tiles of signed distances. Read wall_field.h first. */
#include "physics/grains/walls/wall_field.h"
#include "physics/grains/walls/wall_tree.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

enum { CELLS = WALL_FIELD_CELLS, NODES = CELLS + 3, RIM = 1 };

/* Tile (0, 0, 0) begins at the lower corner of the mesh; node n of a tile along a direction lies n - RIM cells behind the
 * beginning of the tile. */
struct tile {
    int32_t place[3];
    double value[NODES][NODES][NODES]; /* z y x */
};

struct wall_field {
    const struct wall_mesh *mesh; /* borrowed */
    const char *name;             /* of the wall, borrowed */
    struct wall_tree *tree;
    struct law_vector *out; /* of each feature of the mesh: away from the solid, any length */
    double spacing, reach, error;
    double lower[3]; /* of tile (0, 0, 0) */
    int32_t low[3];  /* the first tile along each direction of the directory */
    int32_t across[3];
    int32_t *directory; /* numbers of tiles; -1: none */
    size_t tiles;
    struct tile *tile;
};

/* The angle of a triangle at a corner. */
static double corner_angle(const struct wall_triangle *triangle, int k) {
    struct law_vector a = law_add(triangle->corner[(k + 1) % 3], -1.0, triangle->corner[k]),
                      b = law_add(triangle->corner[(k + 2) % 3], -1.0, triangle->corner[k]),
                      across = law_cross(a, b);
    return atan2(sqrt(law_dot(across, across)), law_dot(a, b));
}

/* The direction out of the solid at each feature: of a vertex the mean of the patches by angle (Baerentzen and Aanaes, IEEE
 * Trans. Vis. Comput. Graph. 11 (2005) 243), of an edge that of both patches. */
static void find_out(struct wall_field *field) {
    const struct wall_mesh *mesh = field->mesh;
    field->out = memory_allocate_zero(wall_mesh_features(mesh), sizeof *field->out, "field of a mesh");
    for (size_t p = 0; p < mesh->patches; p++)
        field->out[p] = mesh->patch[p].normal;
    for (size_t t = 0; t < mesh->triangles; t++) {
        const struct wall_triangle *triangle = &mesh->triangle[t];
        struct law_vector normal = mesh->patch[triangle->patch].normal;
        for (int k = 0; k < 3; k++) {
            if (triangle->edge[k] >= 0)
                field->out[triangle->edge[k]] = law_add(field->out[triangle->edge[k]], 1.0, normal);
            if (triangle->vertex[k] >= 0)
                field->out[triangle->vertex[k]] =
                    law_add(field->out[triangle->vertex[k]], corner_angle(triangle, k), normal);
        }
    }
}

bool wall_field_create(struct wall_field **made, const struct wall_mesh *mesh, double spacing,
                       const char *name, struct error *error) {
    struct law_vector edge = law_add(mesh->upper, -1.0, mesh->lower);
    double longest = law_max(law_max(edge.x, edge.y), edge.z);
    size_t open = wall_mesh_open_edges(mesh, true);
    *made = NULL;
    if (open > 0)
        return error_set(
            error, ERROR_USER,
            "wall '%s': field: %zu edges are not shared by two triangles of one orientation; a field "
            "needs a closed surface; allowed for other meshes: field: false",
            name, open);
    if (!(spacing > 0.0))
        spacing = longest / WALL_FIELD_USUAL;
    if (spacing * WALL_FIELD_ACROSS < longest)
        return error_set(error, ERROR_USER,
                         "wall '%s': field_spacing is %g, must be at least %g for a mesh of this size", name,
                         spacing, longest / WALL_FIELD_ACROSS);
    struct wall_field *field = *made = memory_allocate_zero(1, sizeof *field, "field of a mesh");
    *field = (struct wall_field){.mesh = mesh,
                                 .name = name,
                                 .spacing = spacing,
                                 .reach = -1.0,
                                 .lower = {mesh->lower.x, mesh->lower.y, mesh->lower.z}};
    field->tree = wall_tree_create(mesh);
    find_out(field);
    return true;
}

void wall_field_destroy(struct wall_field **field) {
    if (*field == NULL)
        return;
    wall_tree_destroy(&(*field)->tree);
    memory_free((*field)->out);
    memory_free((*field)->directory);
    memory_free((*field)->tile);
    memory_free(*field);
    *field = NULL;
}

/* The signed distance of a place from the triangles, of which one is nearer than `reach`. */
static double exact_distance(const struct wall_field *field, struct law_vector x, double reach) {
    struct wall_nearest near;
    if (!wall_tree_nearest(field->tree, x, reach, &near))
        return reach;
    int32_t feature = near.feature >= 0 ? near.feature : field->mesh->triangle[near.triangle].patch;
    return law_dot(near.to, field->out[feature]) > 0.0 ? -near.distance : near.distance;
}

/* The place of a node; half cells are places in the middle. */
static struct law_vector node_place(const struct wall_field *field, const int32_t tile[3], double x, double y,
                                    double z) {
    return (struct law_vector){field->lower[0] + field->spacing * (tile[0] * CELLS + x),
                               field->lower[1] + field->spacing * (tile[1] * CELLS + y),
                               field->lower[2] + field->spacing * (tile[2] * CELLS + z)};
}

/* Fills a tile: of two neighbours the distances differ by a spacing at most. */
static void tile_fill(const struct wall_field *field, struct tile *tile) {
    double last = INFINITY, slack = 4.0 * field->mesh->tolerance;
    for (int z = 0; z < NODES; z++)
        for (int y = 0; y < NODES; y++)
            for (int x = 0; x < NODES; x++) {
                struct law_vector at = node_place(field, tile->place, x - RIM, y - RIM, z - RIM);
                double bound = x > 0 ? fabs(last) + 1.01 * field->spacing + slack : INFINITY;
                tile->value[z][y][x] = last = exact_distance(field, at, bound);
            }
}

/* Counts the tiles of a cube of `size` tiles that are near the surface, and in the directory; with `store` there is room for
 * them. */
static void select_tiles(struct wall_field *field, const int32_t place[3], int32_t size, bool store) {
    double half = 0.5 * size * CELLS, far = field->reach + 1.001 * sqrt(3.0) * half * field->spacing;
    struct wall_nearest near;
    for (int d = 0; d < 3; d++)
        if (place[d] >= field->low[d] + field->across[d])
            return;
    if (!wall_tree_nearest(field->tree, node_place(field, place, half, half, half), far, &near))
        return;
    if (size == 1) {
        if (store)
            memcpy(field->tile[field->tiles].place, place, sizeof field->tile->place);
        field->tiles++;
        return;
    }
    for (int child = 0; child < 8; child++) {
        const int32_t at[3] = {place[0] + (child & 1 ? size / 2 : 0), place[1] + (child & 2 ? size / 2 : 0),
                               place[2] + (child & 4 ? size / 2 : 0)};
        select_tiles(field, at, size / 2, store);
    }
}

static size_t directory_place(const struct wall_field *field, const int32_t place[3]) {
    return ((size_t)(place[2] - field->low[2]) * (size_t)field->across[1] +
            (size_t)(place[1] - field->low[1])) *
               (size_t)field->across[0] +
           (size_t)(place[0] - field->low[0]);
}

/* Lays out the directory around the mesh and its reach. Returns the side of a cube of a power of two that holds all. */
static int32_t directory_lay(struct wall_field *field) {
    const struct wall_mesh *mesh = field->mesh;
    const double upper[3] = {mesh->upper.x, mesh->upper.y, mesh->upper.z};
    double width = field->spacing * CELLS;
    int32_t size = 1;
    for (int d = 0; d < 3; d++) {
        field->low[d] = (int32_t)floor(-field->reach / width) - 1;
        field->across[d] =
            (int32_t)floor((upper[d] - field->lower[d] + field->reach) / width) + 2 - field->low[d];
        while (size < field->across[d])
            size *= 2;
    }
    return size;
}

/* The largest error in the middle of some cells of a tile. */
static double tile_error(const struct wall_field *field, const struct tile *tile) {
    double most = 0.0;
    for (int k = 0; k < WALL_FIELD_LOOKS; k++) {
        int x = 2 * (k % 4), y = 2 * (k / 4 % 4) + 1, z = 2 * (k / 16);
        struct law_vector gradient, at = node_place(field, tile->place, x + 0.5, y + 0.5, z + 0.5);
        double found, exact = exact_distance(field, at, INFINITY);
        if (fabs(exact) < field->reach && wall_field_at(field, at, &found, &gradient))
            most = law_max(most, fabs(found - exact));
    }
    return most;
}

/* Makes the tiles in a cube of `size` tiles, without their values. */
static void tiles_place(struct wall_field *field, int32_t size) {
    field->tiles = 0;
    select_tiles(field, field->low, size, false);
    memory_free(field->tile);
    field->tile = NULL;
    if (field->tiles > memory_room() / sizeof *field->tile)
        error_fatal(
            "wall '%s': its field needs %zu MiB, more than there are, as particles look %g far for it; "
            "a larger field_spacing than %g needs less",
            field->name, field->tiles * sizeof *field->tile >> 20, field->reach, field->spacing);
    field->tile = memory_allocate(field->tiles, sizeof *field->tile, "field of a mesh");
    field->tiles = 0;
    select_tiles(field, field->low, size, true);
}

void wall_field_cover(struct wall_field *field, double reach) {
    if (reach <= field->reach)
        return;
    field->reach = 1.1 * reach; /* so that a reach that grows a little needs no new tiles */
    tiles_place(field, directory_lay(field));
    size_t places = (size_t)field->across[0] * (size_t)field->across[1] * (size_t)field->across[2];
    field->directory = memory_resize(field->directory, places, sizeof *field->directory, "field of a mesh");
    memset(field->directory, -1, places * sizeof *field->directory);
    double error = 0.0;
#pragma omp parallel for schedule(dynamic, 4)
    for (size_t t = 0; t < field->tiles; t++)
        tile_fill(field, &field->tile[t]);
    for (size_t t = 0; t < field->tiles; t++)
        field->directory[directory_place(field, field->tile[t].place)] = (int32_t)t;
#pragma omp parallel for schedule(dynamic, 4) reduction(max : error)
    for (size_t t = 0; t < field->tiles; t++)
        error = law_max(error, tile_error(field, &field->tile[t]));
    field->error = error;
}

/* The weights of four nodes for a place a part t behind the second, and their slopes. */
static void weights(double t, double w[4], double slope[4]) {
    w[0] = 0.5 * t * (t * (2.0 - t) - 1.0);
    w[1] = 0.5 * t * t * (3.0 * t - 5.0) + 1.0;
    w[2] = 0.5 * t * (t * (4.0 - 3.0 * t) + 1.0);
    w[3] = 0.5 * t * t * (t - 1.0);
    slope[0] = 0.5 * (t * (4.0 - 3.0 * t) - 1.0);
    slope[1] = 0.5 * t * (9.0 * t - 10.0);
    slope[2] = 0.5 * (t * (8.0 - 9.0 * t) + 1.0);
    slope[3] = 0.5 * t * (3.0 * t - 2.0);
}

/* Sums over 4 x 4 x 4 nodes from `first` on: the value and its slopes over cells. Four nodes along x go together through y
 * and z, so that loops over them are those of the vector units. */
static void interpolate(const struct tile *tile, const int first[3], const double w[3][4],
                        const double slope[3][4], double sum[4]) {
    double value[4] = {0}, over_y[4] = {0}, over_z[4] = {0};
    for (int z = 0; z < 4; z++) {
        const double(*v)[NODES] = &tile->value[first[2] + z][first[1]];
        double line[4], across[4];
#pragma omp simd
        for (int x = 0; x < 4; x++) {
            const int n = first[0] + x;
            line[x] = w[1][0] * v[0][n] + w[1][1] * v[1][n] + w[1][2] * v[2][n] + w[1][3] * v[3][n];
            across[x] =
                slope[1][0] * v[0][n] + slope[1][1] * v[1][n] + slope[1][2] * v[2][n] + slope[1][3] * v[3][n];
        }
#pragma omp simd
        for (int x = 0; x < 4; x++) {
            value[x] += w[2][z] * line[x];
            over_y[x] += w[2][z] * across[x];
            over_z[x] += slope[2][z] * line[x];
        }
    }
    for (int k = 0; k < 4; k++)
        sum[k] = 0.0;
    for (int x = 0; x < 4; x++) {
        sum[0] += w[0][x] * value[x];
        sum[1] += slope[0][x] * value[x];
        sum[2] += w[0][x] * over_y[x];
        sum[3] += w[0][x] * over_z[x];
    }
}

bool wall_field_at(const struct wall_field *field, struct law_vector x, double *distance,
                   struct law_vector *gradient) {
    const double at[3] = {x.x, x.y, x.z};
    int32_t place[3];
    int first[3];
    double w[3][4], slope[3][4], sum[4];
    if (field->directory == NULL)
        return false;
    for (int d = 0; d < 3; d++) {
        double cells = (at[d] - field->lower[d]) / field->spacing - (double)field->low[d] * CELLS;
        if (!(cells >= 0.0 && cells < (double)field->across[d] * CELLS))
            return false;
        int cell = (int)cells;
        place[d] = field->low[d] + cell / CELLS;
        first[d] = cell % CELLS;
        weights(cells - cell, w[d], slope[d]);
    }
    int32_t number = field->directory[directory_place(field, place)];
    if (number < 0)
        return false;
    interpolate(&field->tile[number], first, (const double(*)[4])w, (const double(*)[4])slope, sum);
    double scale = 1.0 / field->spacing;
    *distance = sum[0];
    *gradient = (struct law_vector){scale * sum[1], scale * sum[2], scale * sum[3]};
    return true;
}

bool wall_field_near(const struct wall_field *field, struct law_vector x, double reach, double *distance,
                     struct law_vector *gradient) {
    struct wall_nearest near;
    if (wall_field_at(field, x, distance, gradient))
        return fabs(*distance) < reach;
    if (!wall_tree_nearest(field->tree, x, reach, &near))
        return false;
    int32_t feature = near.feature >= 0 ? near.feature : field->mesh->triangle[near.triangle].patch;
    struct law_vector out = field->out[feature];
    double way = law_dot(near.to, out) > 0.0 ? -1.0 : 1.0;
    *distance = way * near.distance;
    *gradient = near.distance > 0.0 ? law_scale(-way / near.distance, near.to)
                                    : law_scale(1.0 / sqrt(law_dot(out, out)), out);
    return true;
}

struct wall_field_figures wall_field_look(const struct wall_field *field) {
    return (struct wall_field_figures){.spacing = field->spacing,
                                       .error = field->error,
                                       .tiles = field->tiles,
                                       .bytes = field->tiles * sizeof *field->tile};
}
