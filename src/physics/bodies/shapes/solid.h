/* SPDX-License-Identifier: BSD-3-Clause */
/* Convex solids with flat faces: corners, faces and edges. One corner alone is a solid, too: the middle of a sphere. */
#ifndef SCREE_SHAPES_SOLID_H
#define SCREE_SHAPES_SOLID_H

#include "base/moments.h"
#include "base/error.h"

enum {
    SOLID_CORNERS_MAX = 64,
    SOLID_FACES_MAX = 2 * SOLID_CORNERS_MAX,
    SOLID_EDGES_MAX = 3 * SOLID_CORNERS_MAX
};

/* A face: the points x with normal . x = offset, normal outwards; its corners run around the normal by the right hand. */
struct solid_face {
    double normal[3], offset;
    int first, sides; /* corner `first` ... of struct solid.ring, as many as sides */
};

/* An edge: its ends, and the two faces beside it. */
struct solid_edge {
    int end[2], face[2];
};

/* Plain data in arrays of their own. Lengths. */
struct solid {
    int corners, faces, edges, rings;
    double (*corner)[3];
    struct solid_face *face;
    struct solid_edge *edge;
    int *ring; /* numbers of corners, face by face */
    int *rim;  /* of each entry of ring: the edge from this corner to the next one of the face */
};

/* Makes the convex hull of points. Points in a plane within a millionth of their size are one face. False, with a user's
 * error that says what is wrong and does not name its place, where they have no hull of at most SOLID_CORNERS_MAX corners: fewer
 * than four, in a plane, thinner than SOLID_SLIVER of its size, faces that are too nearly flat against each other.
 * solid_free releases. */
#define SOLID_SLIVER 1e-3
bool solid_make(struct solid *solid, const double (*point)[3], size_t points, struct error *error);
void solid_free(struct solid *solid);

/* Makes the solid of one corner at the origin. */
void solid_dot(struct solid *solid);

/* Makes the solid whose faces lie `depth` inside of those of another one, which stay parallel. False where nothing is left, or too
 * little. */
bool solid_inset(struct solid *core, const struct solid *solid, double depth, struct error *error);

/* Volume, centre and inertia, exactly (moments_solid). */
void solid_moments(const struct solid *solid, struct moments *moments);

/* Moves the origin to `centre`, and turns the solid back by a rotation. */
void solid_move(struct solid *solid, const double centre[3], const double turn[9]);

/* Distance of a place to the nearest plane of a face, negative outside. */
double solid_depth(const struct solid *solid, const double place[3]);

/* The largest distance of a corner from the origin. */
double solid_extent(const struct solid *solid);

#endif
