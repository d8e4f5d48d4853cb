/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls as triangles with loads, for output. Read wall.h first. */
#include "physics/grains/walls/walls_parts.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POLYGON_MAX = 4 + 6 };

/* A flat polygon, box-relative. */
struct polygon {
    int count;
    struct law_vector corner[POLYGON_MAX];
};

static double component(struct law_vector v, int d) {
    return d == 0 ? v.x : d == 1 ? v.y : v.z;
}

static void add_triangle(struct wall_surface *surface, const struct walls *walls, int wall,
                         const struct law_vector corner[3]) {
    size_t k = surface->triangles++;
    surface->corner = memory_resize(surface->corner, k + 1, sizeof *surface->corner, "triangles for output");
    surface->wall = memory_resize(surface->wall, k + 1, sizeof *surface->wall, "triangles for output");
    surface->wall[k] = wall;
    for (int c = 0; c < 3; c++)
        for (int d = 0; d < 3; d++)
            surface->corner[k][3 * c + d] = component(corner[c], d) + walls->box.origin[d];
}

/* Cuts off the part of the polygon below (side 1) or above (side -1) `bound` along d (Sutherland and Hodgman). */
static void polygon_cut(struct polygon *polygon, int d, double bound, double side) {
    struct polygon left = {0};
    for (int k = 0; k < polygon->count; k++) {
        struct law_vector a = polygon->corner[k], b = polygon->corner[(k + 1) % polygon->count];
        double in_a = side * (component(a, d) - bound), in_b = side * (component(b, d) - bound);
        if (in_a >= 0.0)
            left.corner[left.count++] = a;
        if ((in_a < 0.0) != (in_b < 0.0))
            left.corner[left.count++] = law_add(a, in_a / (in_a - in_b), law_add(b, -1.0, a));
    }
    *polygon = left;
}

/* The part of a plane in the box, or, where the plane lies beyond, before the faces of the box. */
static struct polygon plane_polygon(const struct wall *wall, const double edge[3]) {
    struct law_vector n = wall->axis_now, middle = law_scale(0.5, wall_vector(edge));
    double far = 2.0 * sqrt(law_dot(middle, middle)), most = 0.0;
    middle = law_add(middle, -law_dot(n, law_add(middle, -1.0, wall->point_now)), n);
    struct law_vector aside =
        fabs(n.x) < 0.6 ? (struct law_vector){1.0, 0.0, 0.0} : (struct law_vector){0.0, 1.0, 0.0};
    struct law_vector u = law_cross(n, aside);
    u = law_scale(far / sqrt(law_dot(u, u)), u);
    struct law_vector v = law_cross(n, u);
    struct polygon all = {.count = 4}, cut;
    int main = 0; /* direction of the largest component of the normal */
    for (int k = 0; k < 4; k++)
        all.corner[k] = law_add(law_add(middle, k == 0 || k == 3 ? 1.0 : -1.0, u), k < 2 ? 1.0 : -1.0, v);
    for (int d = 0; d < 3; d++)
        if (fabs(component(n, d)) > most) {
            most = fabs(component(n, d));
            main = d;
        }
    for (int d = 0; d < 3; d++) {
        double slack = 1e-12 * edge[d];
        if (d == main)
            continue;
        polygon_cut(&all, d, -slack, 1.0);
        polygon_cut(&all, d, edge[d] + slack, -1.0);
    }
    cut = all;
    polygon_cut(&cut, main, -1e-12 * edge[main], 1.0);
    polygon_cut(&cut, main, edge[main] * (1.0 + 1e-12), -1.0);
    return cut.count >= 3 ? cut : all;
}

static void add_plane(struct wall_surface *surface, const struct walls *walls, int w) {
    struct polygon polygon = plane_polygon(&walls->wall[w], walls->box.edge);
    for (int k = 2; k < polygon.count; k++)
        add_triangle(surface, walls, w,
                     (struct law_vector[3]){polygon.corner[0], polygon.corner[k - 1], polygon.corner[k]});
}

static void add_cylinder(struct wall_surface *surface, const struct walls *walls, int w) {
    const struct wall *wall = &walls->wall[w];
    struct law_vector axis = wall->axis_now;
    double low = -0.5 * wall->options.length, high = -low;
    if (wall->options.length == 0.0) {
        low = INFINITY, high = -INFINITY;
        for (int corner = 0; corner < 8; corner++) {
            struct law_vector at = {corner & 1 ? walls->box.edge[0] : 0.0,
                                    corner & 2 ? walls->box.edge[1] : 0.0,
                                    corner & 4 ? walls->box.edge[2] : 0.0};
            double along = law_dot(axis, law_add(at, -1.0, wall->point_now));
            low = fmin(low, along);
            high = fmax(high, along);
        }
    }
    struct law_vector aside =
        fabs(axis.x) < 0.6 ? (struct law_vector){1.0, 0.0, 0.0} : (struct law_vector){0.0, 1.0, 0.0};
    struct law_vector first = law_cross(axis, aside);
    first = law_scale(wall->options.radius / sqrt(law_dot(first, first)), first);
    struct law_vector second = law_cross(axis, first), corner[2][2];
    for (int k = 0; k <= WALL_SURFACE_SECTORS; k++) {
        double angle = 2.0 * M_PI * (k % WALL_SURFACE_SECTORS) / WALL_SURFACE_SECTORS;
        struct law_vector out = law_add(law_scale(cos(angle), first), sin(angle), second);
        corner[k % 2][0] = law_add(law_add(wall->point_now, 1.0, out), low, axis);
        corner[k % 2][1] = law_add(law_add(wall->point_now, 1.0, out), high, axis);
        const struct law_vector *a = corner[1 - k % 2], *b = corner[k % 2];
        if (k == 0)
            continue;
        add_triangle(surface, walls, w, (struct law_vector[3]){a[0], b[0], b[1]});
        add_triangle(surface, walls, w, (struct law_vector[3]){a[0], b[1], a[1]});
    }
}

static void add_mesh(struct wall_surface *surface, const struct walls *walls, int w) {
    double(*triangle)[9];
    size_t count = walls_triangles(walls, w, &triangle), all = surface->triangles + count;
    surface->corner = memory_resize(surface->corner, all, sizeof *surface->corner, "triangles for output");
    surface->wall = memory_resize(surface->wall, all, sizeof *surface->wall, "triangles for output");
    memcpy(surface->corner + surface->triangles, triangle, count * sizeof *triangle);
    for (; surface->triangles < all; surface->triangles++)
        surface->wall[surface->triangles] = w;
    memory_free(triangle);
}

/* The square of about the distance from x to a triangle: exact over the triangle, too large beside it. */
static double distance2(const double corner[9], struct law_vector x) {
    struct law_vector a = wall_vector(corner), u = law_add(wall_vector(corner + 3), -1.0, a),
                      v = law_add(wall_vector(corner + 6), -1.0, a), from = law_add(x, -1.0, a);
    double uu = law_dot(u, u), uv = law_dot(u, v), vv = law_dot(v, v), whole = uu * vv - uv * uv;
    if (!(whole > 0.0))
        return INFINITY;
    double s = law_max(0.0, (vv * law_dot(from, u) - uv * law_dot(from, v)) / whole);
    double t = law_max(0.0, (uu * law_dot(from, v) - uv * law_dot(from, u)) / whole);
    double sum = law_max(1.0, s + t);
    struct law_vector to = law_add(law_add(from, -s / sum, u), -t / sum, v);
    return law_dot(to, to);
}

/* The triangle, of those from `first` to before `last`, that is nearest to the point of a load; `last` if there is
 * none. */
static size_t nearest(const struct wall_surface *surface, const struct walls *walls, size_t first,
                      size_t last, const struct wall_load *load) {
    struct law_vector x = law_add(wall_vector(load->at), 1.0, wall_vector(walls->box.origin));
    double best = INFINITY;
    size_t found = last;
    for (size_t k = first; k < last; k++) {
        double square = distance2(surface->corner[k], x);
        if (square < best) {
            best = square;
            found = k;
        }
    }
    return found;
}

static void add_parts(struct wall_surface *surface, const struct walls *walls,
                      const struct force_context *context, const size_t *first) {
    struct wall_load *load;
    size_t count = walls_loads(walls, context, &load);
    surface->part = memory_allocate(count, sizeof *surface->part, "loads of triangles");
    for (size_t k = 0; k < count; k++) {
        int w = load[k].wall;
        bool known = walls->wall[w].mesh && load[k].triangle != WALL_PIECE_FIELD;
        size_t at = known ? first[w] + (size_t)load[k].triangle
                          : nearest(surface, walls, first[w], first[w + 1], &load[k]);
        if (at == first[w + 1])
            continue;
        struct wall_surface_part *part = &surface->part[surface->parts++];
        *part = (struct wall_surface_part){.triangle = at};
        memcpy(part->load, load[k].force, sizeof load[k].force);
        part->load[3] = load[k].push;
    }
    memory_free(load);
}

/* By triangle, then by the bits of the load: parts that are alike in all may change places. */
static int part_compare(const void *a, const void *b) {
    const struct wall_surface_part *x = a, *y = b;
    if (x->triangle != y->triangle)
        return x->triangle < y->triangle ? -1 : 1;
    return memcmp(x->load, y->load, sizeof x->load);
}

double (*wall_surface_sum(const struct wall_surface *surface, struct wall_surface_part *part,
                          size_t parts))[4] {
    double(*load)[4] = memory_allocate_zero(surface->triangles, sizeof *load, "triangles for output");
    if (parts > 0)
        qsort(part, parts, sizeof *part, part_compare);
    for (size_t k = 0; k < parts; k++)
        for (int c = 0; c < 4; c++)
            load[part[k].triangle][c] += part[k].load[c];
    return load;
}

void wall_surface_make(struct wall_surface *surface, const struct walls *walls,
                       const struct force_context *context) {
    size_t first[WALLS_MAX + 1];
    *surface = (struct wall_surface){0};
    for (int w = 0; w < walls->count; w++) {
        first[w] = surface->triangles;
        if (walls->wall[w].mesh)
            add_mesh(surface, walls, w);
        else if (walls->wall[w].options.shape == WALL_PLANE)
            add_plane(surface, walls, w);
        else
            add_cylinder(surface, walls, w);
    }
    first[walls->count] = surface->triangles;
    if (context)
        add_parts(surface, walls, context, first);
}

void wall_surface_free(struct wall_surface *surface) {
    memory_free(surface->corner);
    memory_free(surface->wall);
    memory_free(surface->part);
    *surface = (struct wall_surface){0};
}

double wall_surface_area(const double corner[9]) {
    struct law_vector a = wall_vector(corner), u = law_add(wall_vector(corner + 3), -1.0, a),
                      v = law_add(wall_vector(corner + 6), -1.0, a), n = law_cross(u, v);
    return 0.5 * sqrt(law_dot(n, n));
}
