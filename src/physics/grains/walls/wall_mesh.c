/* SPDX-License-Identifier: BSD-3-Clause */
/* Merges vertices, drops triangles without area, and makes the surface. Read wall_mesh.h first. */
#include "physics/grains/walls/wall_mesh.h"
#include "base/memory.h"
#include "base/hash.h"
#include <stdlib.h>
#include <string.h>

enum { NOTES_MAX = 20, TRIANGLES_MAX = 1 << 28 };

static const double weld_relative = 1e-6; /* tolerance / diagonal */

/* Merges corners through a hash table of cells, four tolerances wide: a corner looks into the cells that the
 * cube of its tolerance meets. */
struct welder {
    struct wall_weld *weld;
    struct hash by_cell; /* the vertices */
    struct law_vector lower;
};

static void weld_cell(const struct welder *w, struct law_vector x, double by, int64_t cell[3]) {
    double width = 4.0 * w->weld->tolerance;
    cell[0] = (int64_t)floor((x.x - w->lower.x + by) / width);
    cell[1] = (int64_t)floor((x.y - w->lower.y + by) / width);
    cell[2] = (int64_t)floor((x.z - w->lower.z + by) / width);
}

/* The first vertex within the tolerance of x, or -1. */
static int32_t weld_find(const struct welder *w, struct law_vector x) {
    double tolerance = w->weld->tolerance;
    int64_t low[3], high[3], cell[3];
    int32_t found = -1;
    weld_cell(w, x, -tolerance, low);
    weld_cell(w, x, tolerance, high);
    for (cell[2] = low[2]; cell[2] <= high[2]; cell[2]++)
        for (cell[1] = low[1]; cell[1] <= high[1]; cell[1]++)
            for (cell[0] = low[0]; cell[0] <= high[0]; cell[0]++)
                for (uint32_t v = hash_first(&w->by_cell, mix_cell(0, cell)); v != HASH_END;
                     v = w->by_cell.next[v]) {
                    struct law_vector d = law_add(w->weld->vertex[v], -1.0, x);
                    if (law_dot(d, d) <= tolerance * tolerance && (found < 0 || (int32_t)v < found))
                        found = (int32_t)v;
                }
    return found;
}

static int32_t weld_add(struct welder *w, struct law_vector x) {
    int64_t cell[3];
    int32_t v = (int32_t)w->weld->vertices++;
    weld_cell(w, x, 0.0, cell);
    w->weld->vertex[v] = x;
    hash_put(&w->by_cell, mix_cell(0, cell), (uint32_t)v);
    return v;
}

/* Numbers the vertices; returns the number of moved corners, and the largest displacement. */
static size_t weld_run(struct wall_weld *weld, const struct law_vector *corner, size_t corners,
                       struct law_vector lower, double *farthest) {
    struct welder w = {.weld = weld, .lower = lower};
    size_t moved = 0;
    hash_start(&w.by_cell, corners, "vertices of a mesh");
    *farthest = 0.0;
    for (size_t k = 0; k < corners; k++) {
        int32_t v = weld_find(&w, corner[k]);
        if (v < 0)
            v = weld_add(&w, corner[k]);
        struct law_vector d = law_add(weld->vertex[v], -1.0, corner[k]);
        double far = sqrt(law_dot(d, d));
        moved += far > 0.0;
        *farthest = far > *farthest ? far : *farthest;
        weld->corner[k / 3][k % 3] = v;
    }
    hash_free(&w.by_cell);
    return moved;
}

/* Smallest height of a triangle: twice the area over the longest side; 0 if corners coincide. */
static double triangle_height(const struct wall_weld *weld, const int32_t v[3]) {
    struct law_vector a = weld->vertex[v[0]], b = weld->vertex[v[1]], c = weld->vertex[v[2]];
    struct law_vector ab = law_add(b, -1.0, a), ac = law_add(c, -1.0, a), bc = law_add(c, -1.0, b);
    struct law_vector normal = law_cross(ab, ac);
    double longest = law_max(law_max(law_dot(ab, ab), law_dot(ac, ac)), law_dot(bc, bc));
    return longest > 0.0 ? sqrt(law_dot(normal, normal) / longest) : 0.0;
}

/* Names a triangle of the file in a note. */
static void note_triangle(FILE *notes, const struct mesh *file, const char *path, size_t k,
                          const char *what) {
    if (file->line)
        fprintf(notes, "%s:%u: triangle %zu %s\n", path, file->line[k], k + 1, what);
    else
        fprintf(notes, "%s: triangle %zu %s\n", path, k + 1, what);
}

/* A triangle by its vertices in increasing order. */
struct triangle_key {
    int32_t vertex[3];
    uint32_t number;
};

static int key_compare(const void *a, const void *b) {
    const struct triangle_key *x = a, *y = b;
    for (int k = 0; k < 3; k++)
        if (x->vertex[k] != y->vertex[k])
            return x->vertex[k] < y->vertex[k] ? -1 : 1;
    return x->number < y->number ? -1 : 1;
}

static struct triangle_key key_of(const int32_t v[3], size_t number) {
    struct triangle_key key = {.vertex = {v[0], v[1], v[2]}, .number = (uint32_t)number};
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2 - a; b++)
            if (key.vertex[b] > key.vertex[b + 1]) {
                int32_t swap = key.vertex[b];
                key.vertex[b] = key.vertex[b + 1];
                key.vertex[b + 1] = swap;
            }
    return key;
}

/* Marks triangles that have the corners of an earlier one. */
static void mark_copies(const struct wall_weld *weld, uint8_t *drop) {
    struct triangle_key *key = memory_allocate(weld->triangles, sizeof *key, "triangles of a mesh");
    for (size_t k = 0; k < weld->triangles; k++)
        key[k] = key_of(weld->corner[k], k);
    qsort(key, weld->triangles, sizeof *key, key_compare);
    for (size_t k = 1; k < weld->triangles; k++)
        if (memcmp(key[k].vertex, key[k - 1].vertex, sizeof key[k].vertex) == 0)
            drop[key[k].number] = 2;
    memory_free(key);
}

/* Notes the triangles that were left out: the first few of each kind by name. */
static void note_dropped(const uint8_t *drop, const struct mesh *file, const char *path, FILE *notes) {
    static const char *const what[] = {
        "", "is too thin (its height is a millionth of the mesh or less): left out",
        "has the corners of an earlier one: left out"};
    size_t dropped[3] = {0};
    for (size_t k = 0; k < file->count; k++)
        if (drop[k] && dropped[drop[k]]++ < NOTES_MAX)
            note_triangle(notes, file, path, k, what[drop[k]]);
    for (int kind = 1; kind <= 2; kind++)
        if (dropped[kind] > NOTES_MAX)
            fprintf(notes, "%s: and %zu triangles more of which each %s\n", path, dropped[kind] - NOTES_MAX,
                    what[kind]);
}

/* Leaves out slivers and copies. No notes where nothing is left: that is an error, which says so. */
static void weld_clean(struct wall_weld *weld, const struct mesh *file, const char *path, FILE *notes) {
    uint8_t *drop = memory_allocate_zero(weld->triangles, 1, "triangles of a mesh");
    size_t kept = 0;
    mark_copies(weld, drop);
    for (size_t k = 0; k < weld->triangles; k++) {
        if (triangle_height(weld, weld->corner[k]) <= weld->tolerance)
            drop[k] = 1;
        if (!drop[k])
            memmove(weld->corner[kept++], weld->corner[k], sizeof *weld->corner);
    }
    if (notes && kept > 0)
        note_dropped(drop, file, path, notes);
    weld->triangles = kept;
    memory_free(drop);
}

/* Scales and shifts the corners, and finds their bounding box. */
static bool place_corners(struct wall_mesh *mesh, struct law_vector *corner, const struct mesh *file,
                          const char *path, const struct wall_mesh_place *place, struct error *error) {
    mesh->lower = (struct law_vector){INFINITY, INFINITY, INFINITY};
    mesh->upper = law_scale(-1.0, mesh->lower);
    for (size_t k = 0; k < 3 * file->count; k++) {
        const double *x = file->corner[k / 3] + 3 * (k % 3);
        corner[k] =
            (struct law_vector){x[0] * place->scale + place->shift[0], x[1] * place->scale + place->shift[1],
                                x[2] * place->scale + place->shift[2]};
        mesh->lower = (struct law_vector){fmin(mesh->lower.x, corner[k].x), fmin(mesh->lower.y, corner[k].y),
                                          fmin(mesh->lower.z, corner[k].z)};
        mesh->upper = (struct law_vector){fmax(mesh->upper.x, corner[k].x), fmax(mesh->upper.y, corner[k].y),
                                          fmax(mesh->upper.z, corner[k].z)};
    }
    struct law_vector edge = law_add(mesh->upper, -1.0, mesh->lower);
    double diagonal = sqrt(law_dot(edge, edge));
    double far = sqrt(law_max(law_dot(mesh->lower, mesh->lower), law_dot(mesh->upper, mesh->upper)));
    if (!(diagonal > 0.0))
        return error_set(error, ERROR_USER, "%s: all corners lie at one point", path);
    if (!isfinite(far) || diagonal < 1e-8 * far)
        return error_set(
            error, ERROR_USER,
            "%s: a mesh of size %g at a distance of %g cannot be handled; check scale and offset", path,
            diagonal, far);
    mesh->centre = law_scale(0.5, law_add(mesh->lower, 1.0, mesh->upper));
    mesh->tolerance = weld_relative * diagonal;
    mesh->slack = 1e-10 * diagonal + 1e-15 * far;
    for (size_t k = 0; k < 3 * file->count; k++) {
        struct law_vector d = law_add(corner[k], -1.0, mesh->centre);
        mesh->radius = law_max(mesh->radius, sqrt(law_dot(d, d)));
    }
    return true;
}

bool wall_mesh_create(struct wall_mesh **mesh, const struct mesh *file, const char *path,
                      const struct wall_mesh_place *place, FILE *notes, struct error *error) {
    if (file->count > TRIANGLES_MAX)
        return error_set(error, ERROR_USER, "%s: %zu triangles are more than %d", path, file->count,
                         TRIANGLES_MAX);
    *mesh = memory_allocate_zero(1, sizeof **mesh, "mesh");
    struct law_vector *corner = memory_allocate(3 * file->count, sizeof *corner, "corners of a mesh");
    bool good = place_corners(*mesh, corner, file, path, place, error);
    if (good) {
        double farthest;
        struct wall_weld weld = {.triangles = file->count, .tolerance = (*mesh)->tolerance};
        weld.vertex = memory_allocate(3 * file->count, sizeof *weld.vertex, "vertices of a mesh");
        weld.corner = memory_allocate(file->count, sizeof *weld.corner, "triangles of a mesh");
        size_t moved = weld_run(&weld, corner, 3 * file->count, (*mesh)->lower, &farthest);
        if (moved > 0 && notes)
            fprintf(notes, "%s: %zu corners moved by up to %.3g onto vertices that they nearly meet\n", path,
                    moved, farthest);
        weld_clean(&weld, file, path, notes);
        good = weld.triangles > 0 ||
               error_set(error, ERROR_USER, "%s: no triangle is left: all %zu are degenerate", path,
                         file->count);
        if (good)
            wall_patch_find(*mesh, &weld);
        memory_free(weld.vertex);
        memory_free(weld.corner);
    }
    memory_free(corner);
    if (!good)
        wall_mesh_destroy(mesh);
    return good;
}

double wall_mesh_turn(const struct wall_mesh *mesh, double above) {
    double least = INFINITY;
    struct law_vector *first =
        memory_allocate_zero(mesh->edges ? mesh->edges : 1, sizeof *first, "edges of a mesh");
    for (size_t t = 0; t < 3 * mesh->triangles; t++) {
        const struct wall_triangle *triangle = &mesh->triangle[t / 3];
        struct law_vector inward = triangle->inward[t % 3];
        int32_t edge = triangle->edge[t % 3];
        if (edge < 0)
            continue;
        struct law_vector *other = &first[(size_t)edge - mesh->patches];
        double angle = acos(fmin(fmax(-law_dot(*other, inward), -1.0), 1.0)); /* flat: they are opposite */
        if (law_dot(*other, *other) == 0.0)
            *other = inward;
        else if (angle > above)
            least = fmin(least, angle);
    }
    memory_free(first);
    return least;
}

double wall_mesh_area(const struct wall_mesh *mesh) {
    double area = 0.0;
    for (size_t t = 0; t < mesh->triangles; t++) {
        const struct law_vector *corner = mesh->triangle[t].corner;
        struct law_vector across =
            law_cross(law_add(corner[1], -1.0, corner[0]), law_add(corner[2], -1.0, corner[0]));
        area += 0.5 * sqrt(law_dot(across, across));
    }
    return area;
}

/* A directed edge of a mesh. Welded corners have the same bits. */
struct rim {
    struct law_vector from, to;
};

static int compare_points(struct law_vector a, struct law_vector b) {
    if (a.x != b.x)
        return a.x < b.x ? -1 : 1;
    if (a.y != b.y)
        return a.y < b.y ? -1 : 1;
    return a.z != b.z ? (a.z < b.z ? -1 : 1) : 0;
}

static int compare_rims(const void *a, const void *b) {
    const struct rim *x = a, *y = b;
    int order = compare_points(x->from, y->from);
    return order != 0 ? order : compare_points(x->to, y->to);
}

size_t wall_mesh_open_edges(const struct wall_mesh *mesh, bool oriented) {
    struct rim *rim = memory_allocate(3 * mesh->triangles, sizeof *rim, "edges of a mesh");
    size_t edges = 3 * mesh->triangles, open = 0;
    for (size_t k = 0; k < edges; k++) {
        const struct law_vector *corner = mesh->triangle[k / 3].corner;
        struct law_vector from = corner[k % 3], to = corner[(k + 1) % 3];
        bool turned = !oriented && compare_points(from, to) > 0;
        rim[k] = turned ? (struct rim){to, from} : (struct rim){from, to};
    }
    qsort(rim, edges, sizeof *rim, compare_rims);
    for (size_t k = 0; k < edges; k++) {
        const struct rim back = {rim[k].to, rim[k].from};
        bool before = k > 0 && compare_rims(&rim[k], &rim[k - 1]) == 0;
        bool after = k + 1 < edges && compare_rims(&rim[k], &rim[k + 1]) == 0;
        if (oriented)
            open += after || bsearch(&back, rim, edges, sizeof *rim, compare_rims) == NULL;
        else
            open += before == after; /* not two of them */
    }
    memory_free(rim);
    return open;
}

void wall_mesh_destroy(struct wall_mesh **mesh) {
    if (*mesh == NULL)
        return;
    memory_free((*mesh)->triangle);
    memory_free((*mesh)->patch);
    memory_free((*mesh)->edge);
    memory_free((*mesh)->vertex);
    memory_free(*mesh);
    *mesh = NULL;
}
