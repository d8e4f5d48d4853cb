/* SPDX-License-Identifier: BSD-3-Clause */
/* The least translation that parts two convex solids which overlap: over all axes at which it can lie, the normals of the
 * faces of both and the cross products of their edges. Exact, without steps or tolerances; its work grows with the product
 * of the numbers of edges, for the few contacts that are deeper than the rounding. */
#ifndef SCREE_SHAPES_DEEP_H
#define SCREE_SHAPES_DEEP_H

#include "physics/bodies/shapes/posed.h"

/* The depth: moving B by it along `normal`, a unit vector, makes A and B touch. B lies at `apart` from A. Below 0: they do
 * not overlap. Any thread. */
double deep_overlap(const struct posed *a, const struct posed *b, const double apart[3], double normal[3]);

#endif
