/* SPDX-License-Identifier: BSD-3-Clause */
/* Volume, centre and inertia of spheres together, of solids and of sheets, and the quaternion of a rotation. */
#ifndef SCREE_BASE_MOMENTS_H
#define SCREE_BASE_MOMENTS_H

#include <stddef.h>

/* A sphere of a body, in the frame of the body. Lengths. */
struct clump_sphere {
    double centre[3], radius;
};

struct moments {
    double volume, centre[3];
    double gyration[9]; /* inertia about the centre over mass, row by row, of a uniform density */
};

/* Of spheres that do not overlap, by formula: 2/5 m r^2 each, and parallel axes. */
void moments_sum(const struct clump_sphere *sphere, int spheres, struct moments *moments);

/* Of the union of spheres, by quadrature: columns along z on a square grid, exact in z. The relative error is about
 * 1e-5 (a test has it for two spheres). One thread. */
void moments_union(const struct clump_sphere *sphere, int spheres, struct moments *moments);

/* Of the solid that closed triangles of one orientation bound, corners x y z of each: exact integrals over the
 * tetrahedra between the triangles and the first corner. */
void moments_solid(const double (*corner)[9], size_t triangles, struct moments *moments);

/* Of a thin sheet of uniform mass on triangles, closed or not: exact integrals. The volume is the area. */
void moments_sheet(const double (*corner)[9], size_t triangles, struct moments *moments);

/* The unit quaternion (w, x, y, z) of a rotation matrix. */
void moments_quaternion(const double turn[9], double q[4]);

#endif
