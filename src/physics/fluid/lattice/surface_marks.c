/* SPDX-License-Identifier: BSD-3-Clause */
/* Marks of meshes and open sides. Read lattice_fill_parts.h first. */
#include "physics/fluid/lattice/lattice_fill_parts.h"
#include "physics/grains/grains.h"
#include "base/memory.h"
#include "physics/fluid/coupling/rigid_walls.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include <math.h>

static const int around[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

static double distance_of(const struct nodes *nodes, const struct walls *walls, int wall, int64_t node,
                          double reach) {
    struct wall_foot foot;
    double x[3];
    nodes_place(nodes, nodes_number(nodes, node), x);
    walls_foot(walls, wall, x, reach, &foot);
    return foot.distance;
}

/* Gives the sign of a node to all nodes around that have none. */
static void spread(const struct nodes *nodes, int64_t start, float value, float *distance, int64_t *stack) {
    int64_t depth = 0;
    stack[depth++] = start;
    distance[start] = value;
    while (depth > 0) {
        int64_t node = stack[--depth];
        for (int k = 0; k < 6; k++) {
            int64_t next = nodes_neighbour(nodes, node, around[k]);
            if (next < 0 || !isinf(distance[next]))
                continue;
            distance[next] = value;
            stack[depth++] = next;
        }
    }
}

/* Fills distance[nodes->all] with the distance of each node from the surface of a closed mesh, negative in its solid:
 * exact where it is below `reach`, which is more than two spacings. From there the signs spread, as no surface lies between
 * two neighbours that are both far from it. */
static void mesh_distances(const struct nodes *nodes, const struct walls *walls, int wall, double reach,
                           float *distance) {
#pragma omp parallel for schedule(dynamic, 256)
    for (int64_t node = 0; node < nodes->all; node++)
        distance[node] = (float)distance_of(nodes, walls, wall, node, reach);
    int64_t *stack = memory_allocate((size_t)nodes->all, sizeof *stack, "nodes around a mesh");
    for (int64_t node = 0; node < nodes->all; node++) {
        if (!isinf(distance[node]))
            continue;
        double exact = distance_of(nodes, walls, wall, node, INFINITY);
        spread(nodes, node, (float)(exact < 0 ? -reach : reach), distance, stack);
    }
    memory_free(stack);
}

static void mesh_mark(struct nodes *nodes, const struct walls *walls, int wall) {
    float *distance = memory_allocate((size_t)nodes->all, sizeof *distance, "nodes around a mesh");
    mesh_distances(nodes, walls, wall, nodes->support + 3 * nodes->spacing, distance);
    for (int64_t node = 0; node < nodes->all; node++)
        if (distance[node] <= 0)
            nodes_claim(nodes, node, (int32_t)body_of_wall(wall), -distance[node]);
    memory_free(distance);
}

static void side_mark(struct nodes *nodes, int side) {
    int d = side / 2;
#pragma omp parallel for schedule(static)
    for (int64_t node = 0; node < nodes->all; node++) {
        double x[3];
        nodes_place(nodes, nodes_number(nodes, node), x);
        double beyond = side % 2 == 1 ? x[d] - nodes->box->edge[d] : -x[d];
        if (nodes->state[node] == NODES_VOID && beyond > 0)
            nodes_claim(nodes, node, (int32_t)body_of_side(side), beyond);
    }
}

void surface_marks_make(struct nodes *nodes, const struct physics_context *context) {
    const struct fluid_options *options = context->options;
    for (int w = 0; w < context->scene->walls; w++)
        if (wall_shape_meshed(context->scene->wall[w].shape) &&
            rigid_walls_bounds(context, &context->scene->wall[w]))
            mesh_mark(nodes, grains_walls(context), w);
    for (int k = 0; k < options->opens; k++)
        side_mark(nodes, options->open[k].side);
}
