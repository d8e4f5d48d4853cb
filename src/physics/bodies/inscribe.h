/* SPDX-License-Identifier: BSD-3-Clause */
/* Spheres inside of a closed surface of triangles, and the volume, centre and inertia of what the surface holds. */
#ifndef SCREE_BODIES_INSCRIBE_H
#define SCREE_BODIES_INSCRIBE_H

#include "base/moments.h"
#include "base/error.h"

/* What to fill, and how. */
struct inscribe_options {
    const char *file; /* STL, or a table of nine numbers a row */
    double scale;     /* lengths of the file x this */
    int spheres;      /* at most */
};

/* Reads a surface and fills it with up to `spheres` spheres, which may overlap; `sphere` has room for them. The spheres
 * are chosen one after another: each has its centre at the deepest place that no earlier sphere covers, and reaches
 * to the surface. Places are the nodes of a cubic lattice, 24 across the longest edge of the surface, then moved by
 * up to a lattice spacing to where the surface is farthest. Spheres of less than a tenth of the first are left out.
 * `moments` are those of the solid, by exact integrals over tetrahedra, and do not depend on the spheres. Returns
 * the number of spheres; 0 with a user's error if the file is none, or the surface is not closed, or has triangles
 * of both orientations or more than 20,000. One thread; the same bits on all ranks. */
int inscribe_spheres(const struct inscribe_options *options, struct clump_sphere *sphere,
                     struct moments *moments, struct error *error);

#endif
