/* SPDX-License-Identifier: BSD-3-Clause */
/* Triangles, and polygons cut into triangles, for the readers of meshes. Read mesh.h first.
 *
 * A polygon loses one corner after another: one that bends outwards, and whose triangle with its neighbours holds no
 * other corner (an ear). Corners are seen along the normal of the polygon (Newell's sum), so the order of the corners
 * decides, and a polygon may be concave. Where no ear is left, as in a polygon that crosses itself, the rest is cut
 * from its first corner. */
#include "physics/grains/walls/mesh.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

double *mesh_add(struct mesh *mesh, size_t line) {
    if (mesh->count == mesh->room) {
        mesh->room = mesh->room ? 2 * mesh->room : 64;
        mesh->corner = memory_resize(mesh->corner, mesh->room, sizeof *mesh->corner, "triangles");
        if (line > 0)
            mesh->line = memory_resize(mesh->line, mesh->room, sizeof *mesh->line, "triangles");
    }
    if (line > 0)
        mesh->line[mesh->count] = (uint32_t)line;
    return mesh->corner[mesh->count++];
}

/* The polygon as it is cut: its corners in a plane, and what is left of them. */
struct polygon {
    double flat[MESH_CORNERS_MAX][2];
    int left[MESH_CORNERS_MAX];
    int count;
};

/* Component `d` of corner `k` relative to the first one. Halves, as a difference may be beyond the largest number. */
static double polygon_relative(const double (*point)[3], const uint32_t *corner, int k, int d) {
    return point[corner[k]][d] / 2 - point[corner[0]][d] / 2;
}

/* Puts the corners, in units of their extent, into the plane in which the polygon is largest; there they go round
 * anticlockwise. */
static void polygon_flatten(struct polygon *p, const double (*point)[3], const uint32_t *corner) {
    double normal[3] = {0}, size = 0.0;
    for (int k = 0; k < p->count; k++)
        for (int d = 0; d < 3; d++)
            size = fmax(size, fabs(polygon_relative(point, corner, k, d)));
    for (int axis = 0; size > 0.0 && axis < 3; axis++)
        for (int k = 0; k < p->count; k++) {
            int after = (k + 1) % p->count, along = (axis + 1) % 3, across = (axis + 2) % 3;
            normal[axis] += polygon_relative(point, corner, k, along) / size *
                                (polygon_relative(point, corner, after, across) / size) -
                            polygon_relative(point, corner, k, across) / size *
                                (polygon_relative(point, corner, after, along) / size);
        }
    int axis = fabs(normal[1]) > fabs(normal[0]) ? 1 : 0;
    axis = fabs(normal[2]) > fabs(normal[axis]) ? 2 : axis;
    int along = (axis + (normal[axis] < 0.0 ? 2 : 1)) % 3, across = 3 - axis - along;
    for (int k = 0; k < p->count; k++) {
        p->flat[k][0] = polygon_relative(point, corner, k, along) / (size > 0.0 ? size : 1.0);
        p->flat[k][1] = polygon_relative(point, corner, k, across) / (size > 0.0 ? size : 1.0);
    }
}

/* Twice the area of a triangle, positive if it goes round anticlockwise. */
static double polygon_turn(const double a[2], const double b[2], const double c[2]) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* True if corner `at` of what is left is an ear. */
static bool polygon_is_ear(const struct polygon *p, int at) {
    const double *a = p->flat[p->left[(at + p->count - 1) % p->count]], *b = p->flat[p->left[at]],
                 *c = p->flat[p->left[(at + 1) % p->count]];
    if (!(polygon_turn(a, b, c) > 0.0))
        return false;
    for (int k = 0; k < p->count; k++) {
        const double *x = p->flat[p->left[k]];
        bool same = memcmp(x, a, sizeof *p->flat) == 0 || memcmp(x, b, sizeof *p->flat) == 0 ||
                    memcmp(x, c, sizeof *p->flat) == 0;
        if (!same && polygon_turn(a, b, x) >= 0.0 && polygon_turn(b, c, x) >= 0.0 &&
            polygon_turn(c, a, x) >= 0.0)
            return false;
    }
    return true;
}

/* The first ear from corner `from` of what is left on, or -1. */
static int polygon_ear(const struct polygon *p, int from) {
    for (int k = 0; k < p->count; k++)
        if (polygon_is_ear(p, (from + k) % p->count))
            return (from + k) % p->count;
    return -1;
}

void mesh_add_polygon(struct mesh *mesh, const double (*point)[3], const uint32_t *corner, int corners,
                      size_t line) {
    struct polygon p;
    p.count = corners;
    for (int k = 0; k < corners; k++)
        p.left[k] = k;
    if (corners > 3)
        polygon_flatten(&p, point, corner);
    for (int ear = 1; p.count >= 3;) {
        ear = p.count > 3 && ear >= 0 ? polygon_ear(&p, ear) : -1;
        int cut = ear < 0 ? 1 : ear;
        double *to = mesh_add(mesh, line);
        for (int c = 0; c < 3; c++)
            memcpy(to + 3 * c, point[corner[p.left[(cut + p.count - 1 + c) % p.count]]], sizeof *point);
        p.count--;
        memmove(p.left + cut, p.left + cut + 1, (size_t)(p.count - cut) * sizeof *p.left);
    }
}
