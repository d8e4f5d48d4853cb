/* SPDX-License-Identifier: BSD-3-Clause */
/* The corners of the convex hull of points, by Qhull. The only file that calls Qhull. */
#ifndef SCREE_SHAPES_CONVEX_H
#define SCREE_SHAPES_CONVEX_H

#include <stddef.h>

/* Writes the numbers of the points that are corners of the hull, increasing, to `corner`, which has room for all. Returns
 * their number; 0: the points lie in a plane, or are fewer than four. Any thread. */
size_t convex_corners(const double (*point)[3], size_t points, int *corner);

#endif
