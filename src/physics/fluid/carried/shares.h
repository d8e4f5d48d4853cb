/* SPDX-License-Identifier: BSD-3-Clause */
/* The shares of links beside bodies that let nothing through (scalar_links.h). A wall neighbour without flux drops out, and with it what it should bring of
 * changes along the wall. So w_ij stands for w_ij k_ij,
 *
 *   k_ij = 1 + m_i (x_i / r)^2 / 2 + m_j (x_j / r)^2 / 2,   x_i the part of x_j - x_i along the wall beside i, r its length
 *   sum over the entries left of w_ij (1 + m_i (x_i / r)^2) x_i^2 / 2 = (dimension - 1) t_i
 *
 * t of layer.h: the sum over a section is then that of the room between the bodies, wherever they lie on the lattice, links are symmetric, and those across
 * the wall stay as they are. Across the wall nothing of first order changes, as there is no flux. The error is of second order in the spacing. */
#ifndef SCREE_CARRIED_SHARES_H
#define SCREE_CARRIED_SHARES_H

#include "engine/physics.h"
#include "physics/fluid/fluid.h"
#include "physics/fluid/operators/weights.h"

/* The largest m; k is not negative. */
#define SHARES_MOST 10.0

/* k_ij by entry of the fluid's weights, beside all walls and grains but those in a list of surfaces; 1 of wall entries. `given` is by foot, NAN
 * for the feet that let nothing through (NULL: all). The caller frees it. Increment and prediction of the flow are scratch. Collective, at a rebuild,
 * while the fluid has its pairs, and after boundary_values_find of the list. */
double *shares_make(const struct physics_context *context, const struct fluid_surface *surface, int surfaces,
                    const double *given);

#endif
