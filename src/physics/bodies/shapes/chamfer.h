/* SPDX-License-Identifier: BSD-3-Clause */
/* The surface of a rounded solid by flat polygons, for pictures and files: its faces, a strip along each edge, and a polygon at each
 * corner. The surface is closed; it lies on the rounded one at the faces, and inside of it elsewhere. */
#ifndef SCREE_SHAPES_CHAMFER_H
#define SCREE_SHAPES_CHAMFER_H

#include "physics/bodies/shapes/solid.h"

/* Plain data in arrays of their own. Lengths are those of the core. */
struct chamfer {
    int corners, polygons;
    double (*corner)[3];
    int *
        start; /* corners of polygon p: ring[start[p]] ... [start[p + 1]), around its normal outwards by the right hand */
    int *ring;
};

/* Makes the surface around a core with faces. chamfer_free releases. */
void chamfer_make(struct chamfer *chamfer, const struct solid *core, double rounding);
void chamfer_free(struct chamfer *chamfer);

#endif
