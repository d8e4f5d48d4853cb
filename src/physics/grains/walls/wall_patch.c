/* SPDX-License-Identifier: BSD-3-Clause */
/* Flat patches and features of a mesh (rules in wall_mesh.h).
 *
 * Sides, the edges as seen from their triangles, are sorted by their two vertices, so that the triangles at
 * an edge lie together. Patches grow from seeds, the largest triangles first, over edges to triangles that
 * lie in the seed's plane on the other side of the edge; the plane never moves while a patch grows, so that a
 * finely divided curved surface cannot be swallowed step by step. */
#include "physics/grains/walls/wall_mesh.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

static const double patch_angle_sine = 1e-3; /* normals of one patch differ by no more */

/* Edge k of a triangle. */
struct side {
    int32_t low, high; /* its vertices */
    int32_t triangle, k;
};

/* A triangle as a seed. */
struct seed {
    double area;
    int32_t triangle;
};

/* A vertex at the rim of a patch. */
struct rim {
    int32_t vertex, patch;
};

struct finder {
    struct wall_mesh *mesh;
    const struct wall_weld *weld;
    struct side *side;         /* sorted */
    int32_t (*first)[3];       /* of edge k of a triangle: first side of that edge in `side` */
    struct law_vector *normal; /* of each triangle, length twice the area */
    int32_t *stack;
};

static struct law_vector vertex_of(const struct finder *f, int32_t triangle, int k) {
    return f->weld->vertex[f->weld->corner[triangle][k % 3]];
}

static int side_compare(const void *a, const void *b) {
    const struct side *x = a, *y = b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    if (x->high != y->high)
        return x->high < y->high ? -1 : 1;
    return x->triangle < y->triangle ? -1 : x->triangle > y->triangle;
}

static int seed_compare(const void *a, const void *b) {
    const struct seed *x = a, *y = b;
    if (x->area != y->area)
        return x->area > y->area ? -1 : 1;
    return x->triangle < y->triangle ? -1 : 1;
}

static int rim_compare(const void *a, const void *b) {
    const struct rim *x = a, *y = b;
    if (x->vertex != y->vertex)
        return x->vertex < y->vertex ? -1 : 1;
    return x->patch < y->patch ? -1 : x->patch > y->patch;
}

static bool side_same(const struct side *a, const struct side *b) {
    return a->low == b->low && a->high == b->high;
}

static void sides_sort(struct finder *f) {
    size_t triangles = f->weld->triangles;
    for (size_t s = 0; s < 3 * triangles; s++) {
        const int32_t *v = f->weld->corner[s / 3];
        int32_t a = v[s % 3], b = v[(s + 1) % 3];
        f->side[s] = (struct side){a < b ? a : b, a < b ? b : a, (int32_t)(s / 3), (int32_t)(s % 3)};
    }
    qsort(f->side, 3 * triangles, sizeof *f->side, side_compare);
    size_t first = 0;
    for (size_t s = 0; s < 3 * triangles; s++) {
        if (!side_same(&f->side[s], &f->side[first]))
            first = s;
        f->first[f->side[s].triangle][f->side[s].k] = (int32_t)first;
    }
}

/* True if the two triangles at an edge lie on different sides of it, seen along `normal`. */
static bool sides_oppose(const struct finder *f, const struct side *a, const struct side *b,
                         struct law_vector normal) {
    struct law_vector from = f->weld->vertex[a->low], along = law_add(f->weld->vertex[a->high], -1.0, from);
    struct law_vector across = law_cross(normal, along);
    double to_a = law_dot(across, law_add(vertex_of(f, a->triangle, a->k + 2), -1.0, from));
    double to_b = law_dot(across, law_add(vertex_of(f, b->triangle, b->k + 2), -1.0, from));
    return (to_a > 0.0) != (to_b > 0.0);
}

/* True if a triangle lies in a plane. */
static bool triangle_flat(const struct finder *f, int32_t triangle, const struct wall_patch *plane) {
    double far = 0.0;
    for (int k = 0; k < 3; k++)
        far = law_max(far,
                      fabs(law_dot(plane->normal, law_add(vertex_of(f, triangle, k), -1.0, plane->point))));
    struct law_vector n = f->normal[triangle], sine = law_cross(plane->normal, n);
    bool parallel = law_dot(sine, sine) <= patch_angle_sine * patch_angle_sine * law_dot(n, n);
    return far <= (parallel ? f->weld->tolerance : 0.1 * f->weld->tolerance);
}

static struct law_vector unit(struct law_vector a) {
    return law_scale(1.0 / sqrt(law_dot(a, a)), a);
}

/* The patch of a seed: marks its triangles, and sets the mean plane. */
static void patch_grow(struct finder *f, int32_t seed) {
    struct wall_triangle *triangle = f->mesh->triangle;
    int32_t patch = (int32_t)f->mesh->patches++, depth = 0;
    struct wall_patch plane = {.normal = unit(f->normal[seed]), .point = vertex_of(f, seed, 0)};
    struct law_vector sum = {0.0, 0.0, 0.0}, middle = sum;
    double area = 0.0;
    triangle[seed].patch = patch;
    f->stack[depth++] = seed;
    while (depth > 0) {
        int32_t t = f->stack[--depth];
        struct law_vector n = f->normal[t];
        double twice = sqrt(law_dot(n, n));
        sum = law_add(sum, law_dot(n, plane.normal) < 0.0 ? -1.0 : 1.0, n);
        for (int k = 0; k < 3; k++)
            middle = law_add(middle, twice / 3.0, law_add(vertex_of(f, t, k), -1.0, plane.point));
        area += twice;
        for (int k = 0; k < 3; k++) {
            size_t first = (size_t)f->first[t][k];
            struct side self = {f->side[first].low, f->side[first].high, t, k};
            for (size_t s = first; s < 3 * f->weld->triangles && side_same(&f->side[s], &self); s++) {
                int32_t other = f->side[s].triangle;
                if (triangle[other].patch >= 0 || !sides_oppose(f, &self, &f->side[s], plane.normal) ||
                    !triangle_flat(f, other, &plane))
                    continue;
                triangle[other].patch = patch;
                f->stack[depth++] = other;
            }
        }
    }
    plane.normal = unit(sum);
    plane.point = law_add(plane.point, 1.0 / area, middle);
    f->mesh->patch[patch] = plane;
}

static void patches_find(struct finder *f) {
    size_t triangles = f->weld->triangles;
    struct seed *seed = memory_allocate(triangles, sizeof *seed, "patches of a mesh");
    for (size_t t = 0; t < triangles; t++) {
        struct law_vector a = vertex_of(f, (int32_t)t, 0), b = vertex_of(f, (int32_t)t, 1),
                          c = vertex_of(f, (int32_t)t, 2);
        f->normal[t] = law_cross(law_add(b, -1.0, a), law_add(c, -1.0, a));
        seed[t] = (struct seed){law_dot(f->normal[t], f->normal[t]), (int32_t)t};
        f->mesh->triangle[t].patch = -1;
    }
    qsort(seed, triangles, sizeof *seed, seed_compare);
    f->mesh->patch = memory_allocate(triangles, sizeof *f->mesh->patch, "patches of a mesh");
    for (size_t k = 0; k < triangles; k++)
        if (f->mesh->triangle[seed[k].triangle].patch < 0)
            patch_grow(f, seed[k].triangle);
    memory_free(seed);
}

/* True if the patch of side `a` goes on behind it; the sides of its edge are [first, last). */
static bool side_inner(const struct finder *f, size_t a, size_t first, size_t last) {
    const struct wall_triangle *triangle = f->mesh->triangle;
    int32_t patch = triangle[f->side[a].triangle].patch;
    for (size_t s = first; s < last; s++)
        if (s != a && triangle[f->side[s].triangle].patch == patch &&
            sides_oppose(f, &f->side[a], &f->side[s], f->mesh->patch[patch].normal))
            return true;
    return false;
}

/* Numbers the edges that are features, and lists the vertices at the rims of patches. */
static size_t edges_find(struct finder *f, struct rim *rim) {
    size_t sides = 3 * f->weld->triangles, rims = 0;
    struct wall_mesh *mesh = f->mesh;
    mesh->edge = memory_allocate(sides, sizeof *mesh->edge, "edges of a mesh");
    for (size_t first = 0, last; first < sides; first = last) {
        bool feature = false;
        for (last = first; last < sides && side_same(&f->side[last], &f->side[first]);)
            last++;
        for (size_t s = first; s < last; s++) {
            struct wall_triangle *t = &mesh->triangle[f->side[s].triangle];
            bool inner = side_inner(f, s, first, last);
            t->edge[f->side[s].k] = inner ? -1 : (int32_t)(mesh->patches + mesh->edges);
            if (inner)
                continue;
            feature = true;
            rim[rims++] = (struct rim){f->side[s].low, t->patch};
            rim[rims++] = (struct rim){f->side[s].high, t->patch};
        }
        if (!feature)
            continue;
        mesh->edge[mesh->edges][0] = f->weld->vertex[f->side[first].low];
        mesh->edge[mesh->edges++][1] = f->weld->vertex[f->side[first].high];
    }
    return rims;
}

/* Numbers the vertices that are features, and tells the triangles. */
static void vertices_find(struct finder *f, struct rim *rim, size_t rims) {
    struct wall_mesh *mesh = f->mesh;
    int32_t *number = memory_allocate(f->weld->vertices, sizeof *number, "vertices of a mesh");
    mesh->vertex = memory_allocate(f->weld->vertices, sizeof *mesh->vertex, "vertices of a mesh");
    qsort(rim, rims, sizeof *rim, rim_compare);
    for (size_t r = 0; r < rims; r++) {
        if (r > 0 && rim[r].vertex == rim[r - 1].vertex)
            continue;
        number[rim[r].vertex] = (int32_t)(mesh->patches + mesh->edges + mesh->vertices);
        mesh->vertex[mesh->vertices++] = f->weld->vertex[rim[r].vertex];
    }
    for (size_t t = 0; t < mesh->triangles; t++)
        for (int k = 0; k < 3; k++) {
            struct rim key = {f->weld->corner[t][k], mesh->triangle[t].patch};
            bool feature = bsearch(&key, rim, rims, sizeof *rim, rim_compare) != NULL;
            mesh->triangle[t].vertex[k] = feature ? number[key.vertex] : -1;
        }
    memory_free(number);
}

/* Corners and the vectors that tell inside from outside. */
static void triangles_fill(struct finder *f) {
    for (size_t t = 0; t < f->mesh->triangles; t++) {
        struct wall_triangle *triangle = &f->mesh->triangle[t];
        struct law_vector normal = f->mesh->patch[triangle->patch].normal;
        for (int k = 0; k < 3; k++)
            triangle->corner[k] = vertex_of(f, (int32_t)t, k);
        for (int k = 0; k < 3; k++) {
            struct law_vector from = triangle->corner[k];
            struct law_vector in =
                unit(law_cross(normal, law_add(triangle->corner[(k + 1) % 3], -1.0, from)));
            double side = law_dot(in, law_add(triangle->corner[(k + 2) % 3], -1.0, from));
            triangle->inward[k] = law_scale(side < 0.0 ? -1.0 : 1.0, in);
        }
    }
}

void wall_patch_find(struct wall_mesh *mesh, const struct wall_weld *weld) {
    size_t n = weld->triangles;
    struct finder f = {.mesh = mesh,
                       .weld = weld,
                       .side = memory_allocate(3 * n, sizeof *f.side, "edges of a mesh"),
                       .first = memory_allocate(n, sizeof *f.first, "edges of a mesh"),
                       .normal = memory_allocate(n, sizeof *f.normal, "patches of a mesh"),
                       .stack = memory_allocate(n, sizeof *f.stack, "patches of a mesh")};
    struct rim *rim = memory_allocate(6 * n, sizeof *rim, "vertices of a mesh");
    mesh->triangles = n;
    mesh->triangle = memory_allocate_zero(n, sizeof *mesh->triangle, "triangles of a mesh");
    sides_sort(&f);
    patches_find(&f);
    size_t rims = edges_find(&f, rim);
    vertices_find(&f, rim, rims);
    triangles_fill(&f);
    memory_free(rim);
    memory_free(f.side);
    memory_free(f.first);
    memory_free(f.normal);
    memory_free(f.stack);
    mesh->patch = memory_resize(mesh->patch, mesh->patches, sizeof *mesh->patch, "patches of a mesh");
    mesh->edge = memory_resize(mesh->edge, mesh->edges, sizeof *mesh->edge, "edges of a mesh");
    mesh->vertex = memory_resize(mesh->vertex, mesh->vertices, sizeof *mesh->vertex, "vertices of a mesh");
}
