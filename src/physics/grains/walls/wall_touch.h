/* SPDX-License-Identifier: BSD-3-Clause */
/* The contact points of a sphere with a wall: geometry alone, no forces.
 *
 * A mesh is resolved in two stages. First each triangle near the sphere names its point nearest to the
 * centre: inside (a face: then the distance is that to the plane of its patch), on an edge, or at a corner.
 * Of these, points on edges inside a patch and corners inside a patch are no contacts, nor is a point of an
 * edge or corner that is not the nearest point of every triangle there. Then the rest is taken by kind, face
 * before edge before vertex, and by distance, and a contact is dropped that is *hidden* by one taken before:
 * one whose point lies on or behind the tangent plane of the other (the plane through its point,
 * perpendicular to its normal), with a tolerance of a millionth of the mesh or a thousandth of the radius,
 * whichever is less. So
 *   - all triangles of a patch, and patches in one plane, give one contact
 *   - edges and vertices give none where a face covers them: in concave corners only the faces count
 *   - a convex edge gives one contact, of the edge, once the centre has left the prisms over both faces
 *   - the far side of a thin plate is not felt through the near one.
 * Of contacts whose normals differ by less than WALL_TOUCH_SMOOTH only the nearest one is left: they are one
 * smooth patch, and its elastic energy is that of the distance to it, which has no jump where the sphere goes
 * from a facet to the next. If both acted, the second would begin with all but r angle^2 / 2 of the overlap
 * of the first, with energy from nowhere. A limit of the method, as of all that add up contacts: bodies of a
 * wall that are nearer to one another than the overlap's width sqrt(2 r overlap), and concave edges of a
 * larger angle that a sphere overlaps by more than r angle^2 / 2 (1.1 % of r) when it comes to them, come
 * into contact with a jump. */
#ifndef SCREE_WALLS_WALL_TOUCH_H
#define SCREE_WALLS_WALL_TOUCH_H

#include "physics/grains/walls/wall_mesh.h"
#include "physics/grains/walls/wall_motion.h"

/* Contacts with a wall whose normals differ by less than this angle (rad, 8.6 degrees) are one. */
#define WALL_TOUCH_SMOOTH 0.15

enum wall_touch_kind { WALL_TOUCH_FACE, WALL_TOUCH_EDGE, WALL_TOUCH_VERTEX };

/* One contact. */
struct wall_touch {
    enum wall_touch_kind kind;
    int32_t feature;          /* of the wall, see wall.h */
    int32_t triangle;         /* of a mesh: the one whose point touches */
    int image;                /* code of the wall's image */
    double distance;          /* from the centre to the wall; below 0 beyond a one-sided wall */
    struct law_vector normal; /* unit vector from the centre to the wall (to its outside, where beyond it) */
};

/* The result of a triangle: its point nearest to a centre. */
struct wall_nearest {
    enum wall_touch_kind kind;
    int32_t feature; /* -1: inside of a patch, no contact */
    int32_t triangle;
    int image;
    double distance;
    struct law_vector to; /* from the centre to the point; face: perpendicular to the patch */
};

/* The point of triangle t nearest to x, both in the body's frame. If the point is farther than `reach`, only
 * the distance is set, to any value from `reach` on. Any thread. */
struct wall_nearest wall_touch_nearest(const struct wall_mesh *mesh, int32_t t, struct law_vector x,
                                       double reach);

/* How far a foot in the plane of triangle t lies inside of the triangle; below 0 outside. x in the body's frame. Any thread. */
double wall_touch_inside(const struct wall_mesh *mesh, int32_t t, struct law_vector x);

/* The contact of a sphere whose centre x lies above triangle t with the triangle's patch, wherever it is. Any thread. */
struct wall_touch wall_touch_face(const struct wall_mesh *mesh, int32_t t, struct law_vector x);

/* Second stage: makes contacts of the `count` nearest points of triangles (all of those that may touch; order
 * is changed) that are nearer than the radius; `touch` has room for `count`. Normals are in the body's frame.
 * Returns the number of contacts. Any thread. */
size_t wall_touch_resolve(const struct wall_mesh *mesh, struct wall_nearest *near, size_t count,
                          double radius, struct wall_touch *touch);

/* The direction (unit vector) and distance from x to a feature of a mesh, in the body's frame: of a patch its
 * plane. */
struct law_vector wall_touch_toward(const struct wall_mesh *mesh, int32_t feature, struct law_vector x,
                                    double *distance);

/* Ends of an edge feature. */
static inline const struct law_vector *wall_touch_edge(const struct wall_mesh *mesh, int32_t feature) {
    return mesh->edge[(size_t)feature - mesh->patches];
}

/* Of contacts sorted by distance those that no nearer one hides by the rule above; cut in place. Returns their number. */
size_t wall_touch_show(struct wall_touch *touch, size_t count, double tolerance);

/* A cylinder, in any frame. */
struct wall_cylinder {
    struct law_vector point, axis; /* middle and direction (unit vector) */
    double radius, length;         /* length 0: infinite */
    bool inside;
};

/* The features of a cylinder. */
enum { WALL_CYLINDER_SHELL, WALL_CYLINDER_UPPER, WALL_CYLINDER_LOWER };

/* Direction (unit vector) and distance from x to a feature of a cylinder. */
struct law_vector wall_cylinder_toward(const struct wall_cylinder *cylinder, int32_t feature,
                                       struct law_vector x, double *distance);

/* The contact of a sphere with a cylinder; false if there is none. */
bool wall_cylinder_touch(const struct wall_cylinder *cylinder, struct law_vector x, double radius,
                         struct wall_touch *touch);

/* Of the contacts of a sphere with images of a cylinder those that no other one hides, by the rule above
 * (shell before rim, then by distance): where ends of images meet, or images overlap, they are one tube.
 * `touch` is sorted and cut in place. Returns the number of contacts left. */
size_t wall_cylinder_resolve(const struct wall_cylinder *cylinder, struct wall_touch *touch, size_t count,
                             double radius);

/* True if a sphere comes nearer than `reach` from its centre to the cylinder. */
bool wall_cylinder_near(const struct wall_cylinder *cylinder, struct law_vector x, double reach);

#endif
