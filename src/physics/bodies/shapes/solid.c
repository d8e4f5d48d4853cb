/* SPDX-License-Identifier: BSD-3-Clause */
/* From corners to faces and edges. Read solid.h first. */
#include "physics/bodies/shapes/solid.h"
#include "base/vector.h"
#include "physics/bodies/shapes/convex.h"
#include "base/rotor.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

/* Corners that are this much nearer to a plane than the solid is large lie in it. */
static const double flat_part = 1e-6;

/* Three corners span a plane if twice their area is more than this part of the square of the size. */
static const double thin_part = 1e-5;

static const char what[] = "a solid";

static void minus(const double a[3], const double b[3], double c[3]) {
    for (int d = 0; d < 3; d++)
        c[d] = a[d] - b[d];
}

void solid_free(struct solid *solid) {
    memory_free(solid->corner);
    memory_free(solid->face);
    memory_free(solid->edge);
    memory_free(solid->ring);
    memory_free(solid->rim);
    *solid = (struct solid){0};
}

static void room_make(struct solid *solid) {
    *solid = (struct solid){.corner = memory_allocate_zero(SOLID_CORNERS_MAX, sizeof *solid->corner, what),
                            .face = memory_allocate_zero(SOLID_FACES_MAX, sizeof *solid->face, what),
                            .edge = memory_allocate_zero(SOLID_EDGES_MAX, sizeof *solid->edge, what),
                            .ring = memory_allocate_zero(2 * SOLID_EDGES_MAX, sizeof *solid->ring, what),
                            .rim = memory_allocate_zero(2 * SOLID_EDGES_MAX, sizeof *solid->rim, what)};
}

void solid_dot(struct solid *solid) {
    room_make(solid);
    solid->corners = 1;
}

/* The longest edge of the box around points. */
static double size_of(const double (*point)[3], size_t points) {
    double size = 0;
    for (int d = 0; d < 3; d++) {
        double least = INFINITY, most = -INFINITY;
        for (size_t k = 0; k < points; k++) {
            least = fmin(least, point[k][d]);
            most = fmax(most, point[k][d]);
        }
        size = fmax(size, most - least);
    }
    return size;
}

/* Sorts the corners of a face around its normal, from the lowest number on. */
static void ring_sort(const struct solid *solid, const struct solid_face *face, int *ring) {
    double middle[3] = {0}, axis[3], other[3], angle[SOLID_CORNERS_MAX];
    for (int k = 0; k < face->sides; k++)
        for (int d = 0; d < 3; d++)
            middle[d] += solid->corner[ring[k]][d] / face->sides;
    minus(solid->corner[ring[0]], middle, axis);
    vector_cross(face->normal, axis, other);
    for (int k = 0; k < face->sides; k++) {
        double from[3];
        minus(solid->corner[ring[k]], middle, from);
        angle[k] = k == 0 ? -4 : atan2(vector_dot(from, other), vector_dot(from, axis));
        angle[k] = k > 0 && angle[k] < 0 ? angle[k] + 2 * M_PI : angle[k];
    }
    for (int k = 1; k < face->sides; k++)
        for (int m = k; m > 0 && angle[m] < angle[m - 1]; m--) {
            double swap = angle[m];
            int number = ring[m];
            angle[m] = angle[m - 1];
            ring[m] = ring[m - 1];
            angle[m - 1] = swap;
            ring[m - 1] = number;
        }
}

/* Adds the face through three corners, if all corners lie on one side of it and the face is new. False: no room. */
static bool face_add(struct solid *solid, const int three[3], double size) {
    struct solid_face face = {.first = solid->rings};
    double along[3], across[3];
    minus(solid->corner[three[1]], solid->corner[three[0]], along);
    minus(solid->corner[three[2]], solid->corner[three[0]], across);
    vector_cross(along, across, face.normal);
    double area = sqrt(vector_dot(face.normal, face.normal));
    if (!(area > thin_part * size * size))
        return true;
    int above = 0, below = 0, on[SOLID_CORNERS_MAX];
    for (int d = 0; d < 3; d++)
        face.normal[d] /= area;
    face.offset = vector_dot(face.normal, solid->corner[three[0]]);
    for (int k = 0; k < solid->corners; k++) {
        double height = vector_dot(face.normal, solid->corner[k]) - face.offset;
        if (fabs(height) <= flat_part * size)
            on[face.sides++] = k;
        else if (height > 0)
            above++;
        else
            below++;
    }
    if (above > 0 && below > 0)
        return true;
    /* The first three of the corners in a plane that span it stand for the face. */
    for (int f = 0; f < solid->faces; f++) {
        const struct solid_face *known = &solid->face[f];
        int shared = 0;
        for (int k = 0; k < known->sides; k++)
            for (int m = 0; m < face.sides; m++)
                shared += solid->ring[known->first + k] == on[m];
        if (shared >= 3)
            return true;
    }
    if (solid->faces == SOLID_FACES_MAX || solid->rings + face.sides > 2 * SOLID_EDGES_MAX)
        return false;
    for (int d = 0; d < 3 && above > 0; d++)
        face.normal[d] = -face.normal[d];
    face.offset = above > 0 ? -face.offset : face.offset;
    memcpy(solid->ring + solid->rings, on, (size_t)face.sides * sizeof *on);
    ring_sort(solid, &face, solid->ring + solid->rings);
    solid->rings += face.sides;
    solid->face[solid->faces++] = face;
    return true;
}

/* The edge between two corners of face f: an edge that has one face so far, or a new one. -1: more than two faces. */
static int edge_of(struct solid *solid, int f, int from, int to) {
    for (int e = 0; e < solid->edges; e++) {
        struct solid_edge *edge = &solid->edge[e];
        if (edge->end[0] == to && edge->end[1] == from && edge->face[1] < 0) {
            edge->face[1] = f;
            return e;
        }
    }
    if (solid->edges == SOLID_EDGES_MAX)
        return -1;
    solid->edge[solid->edges] = (struct solid_edge){{from, to}, {f, -1}};
    return solid->edges++;
}

static bool edges_make(struct solid *solid) {
    for (int f = 0; f < solid->faces; f++) {
        const struct solid_face *face = &solid->face[f];
        for (int k = 0; k < face->sides; k++) {
            int from = solid->ring[face->first + k], to = solid->ring[face->first + (k + 1) % face->sides];
            int edge = edge_of(solid, f, from, to);
            if (edge < 0)
                return false;
            solid->rim[face->first + k] = edge;
        }
    }
    for (int e = 0; e < solid->edges; e++)
        if (solid->edge[e].face[1] < 0)
            return false;
    return solid->corners - solid->edges + solid->faces == 2;
}

/* Removes corners in the middle of faces or edges: those of fewer than three faces. Returns their number. */
static int corners_thin(struct solid *solid) {
    int kept = 0, removed = 0;
    for (int k = 0; k < solid->corners; k++) {
        int faces = 0;
        for (int r = 0; r < solid->rings; r++)
            faces += solid->ring[r] == k;
        if (faces < 3) {
            removed++;
            continue;
        }
        memcpy(solid->corner[kept++], solid->corner[k], sizeof *solid->corner);
    }
    solid->corners = kept;
    return removed;
}

static bool faces_make(struct solid *solid, double size) {
    do {
        solid->faces = solid->rings = solid->edges = 0;
        int three[3];
        for (three[0] = 0; three[0] < solid->corners; three[0]++)
            for (three[1] = three[0] + 1; three[1] < solid->corners; three[1]++)
                for (three[2] = three[1] + 1; three[2] < solid->corners; three[2]++)
                    if (!face_add(solid, three, size))
                        return false;
    } while (corners_thin(solid) > 0);
    return edges_make(solid);
}

/* The least extent of a solid: over the directions of its faces. */
static double thickness_of(const struct solid *solid) {
    double least = INFINITY;
    for (int f = 0; f < solid->faces; f++) {
        double low = INFINITY;
        for (int k = 0; k < solid->corners; k++)
            low = fmin(low, vector_dot(solid->face[f].normal, solid->corner[k]));
        least = fmin(least, solid->face[f].offset - low);
    }
    return least;
}

bool solid_make(struct solid *solid, const double (*point)[3], size_t points, struct error *error) {
    double size = size_of(point, points);
    int *corner = memory_allocate(points, sizeof *corner, what);
    size_t corners = convex_corners(point, points, corner);
    room_make(solid);
    if (corners > SOLID_CORNERS_MAX)
        error_set(error, ERROR_USER,
                  "has a hull of %zu corners; allowed are at most %d: leave small facets out", corners,
                  SOLID_CORNERS_MAX);
    for (size_t k = 0; k < corners && corners <= SOLID_CORNERS_MAX; k++)
        memcpy(solid->corner[solid->corners++], point[corner[k]], sizeof *solid->corner);
    memory_free(corner);
    if (corners == 0)
        error_set(error, ERROR_USER, "has no volume: it needs four points that are not in a plane");
    if (corners == 0 || corners > SOLID_CORNERS_MAX)
        return false;
    bool good = faces_make(solid, size);
    if (solid->faces >= 4 && !(thickness_of(solid) > SOLID_SLIVER * size))
        return error_set(error, ERROR_USER,
                         "is a sliver: its thickness is %.3g of its size; allowed is %g or more",
                         thickness_of(solid) / size, SOLID_SLIVER);
    if (!good)
        return error_set(
            error, ERROR_USER,
            "has corners that are too near to the planes of other faces to say which face they belong "
            "to: move or leave out points");
    return true;
}

/* The place where three planes, moved inwards, meet; false: nowhere in particular. */
static bool planes_meet(const struct solid_face *const face[3], double depth, double place[3]) {
    double across[3], other[3][3];
    vector_cross(face[1]->normal, face[2]->normal, across);
    double volume = vector_dot(face[0]->normal, across);
    if (!(fabs(volume) > 1e-9))
        return false;
    for (int k = 0; k < 3; k++)
        vector_cross(face[(k + 1) % 3]->normal, face[(k + 2) % 3]->normal, other[k]);
    for (int d = 0; d < 3; d++) {
        place[d] = 0;
        for (int k = 0; k < 3; k++)
            place[d] += (face[k]->offset - depth) * other[k][d] / volume;
    }
    return true;
}

bool solid_inset(struct solid *core, const struct solid *solid, double depth, struct error *error) {
    enum { MOST = 4 * SOLID_FACES_MAX };
    const double size = size_of(solid->corner, (size_t)solid->corners), near = 1e-9 * size;
    double place[MOST][3];
    size_t places = 0;
    for (int a = 0; a < solid->faces; a++)
        for (int b = a + 1; b < solid->faces; b++)
            for (int c = b + 1; c < solid->faces; c++) {
                const struct solid_face *const three[3] = {&solid->face[a], &solid->face[b], &solid->face[c]};
                double x[3];
                if (places == MOST || !planes_meet(three, depth, x) || solid_depth(solid, x) < depth - near)
                    continue;
                bool known = false;
                for (size_t k = 0; k < places && !known; k++)
                    known = fabs(x[0] - place[k][0]) + fabs(x[1] - place[k][1]) + fabs(x[2] - place[k][2]) <
                            10 * near;
                if (!known)
                    memcpy(place[places++], x, sizeof x);
            }
    struct error small = {0};
    if (solid_make(core, (const double(*)[3])place, places, &small))
        return true;
    return error_set(error, ERROR_USER, "leaves no core: the solid without a layer of %.6g %s", depth,
                     small.text);
}

void solid_moments(const struct solid *solid, struct moments *moments) {
    double(*triangle)[9] = memory_allocate((size_t)solid->rings, sizeof *triangle, what);
    size_t triangles = 0;
    for (int f = 0; f < solid->faces; f++) {
        const int *ring = solid->ring + solid->face[f].first;
        for (int k = 2; k < solid->face[f].sides; k++, triangles++) {
            memcpy(triangle[triangles], solid->corner[ring[0]], 3 * sizeof(double));
            memcpy(triangle[triangles] + 3, solid->corner[ring[k - 1]], 3 * sizeof(double));
            memcpy(triangle[triangles] + 6, solid->corner[ring[k]], 3 * sizeof(double));
        }
    }
    moments_solid((const double(*)[9])triangle, triangles, moments);
    memory_free(triangle);
}

void solid_move(struct solid *solid, const double centre[3], const double turn[9]) {
    for (int k = 0; k < solid->corners; k++) {
        minus(solid->corner[k], centre, solid->corner[k]);
        rotor_turn_back(turn, solid->corner[k], solid->corner[k]);
    }
    for (int f = 0; f < solid->faces; f++) {
        struct solid_face *face = &solid->face[f];
        face->offset -= vector_dot(face->normal, centre);
        rotor_turn_back(turn, face->normal, face->normal);
    }
}

double solid_depth(const struct solid *solid, const double place[3]) {
    double least = INFINITY;
    for (int f = 0; f < solid->faces; f++)
        least = fmin(least, solid->face[f].offset - vector_dot(solid->face[f].normal, place));
    return least;
}

double solid_extent(const struct solid *solid) {
    double most = 0;
    for (int k = 0; k < solid->corners; k++)
        most = fmax(most, sqrt(vector_dot(solid->corner[k], solid->corner[k])));
    return most;
}
