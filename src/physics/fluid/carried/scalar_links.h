/* SPDX-License-Identifier: BSD-3-Clause */
/* The links of a scalar between neighbours: sum over j of K_ij (c_j - c_i), K = D w_ij - a_ij, with what boundaries make of
 * c_j at a wall entry:
 *
 *   a given value c_w:   c_j - c_i = -(1 + beta) (c_i - c_w),   with an image m at an open side  2 c_w - c_m - c_i
 *   a given slope s, into the fluid, along the normal:   c_j - c_i = -(d_i + d_j) s
 *   else no flux: 0,   with an image m at an open side  c_m - c_i
 *
 * With upwind differences K = D w_ij - a_ij + |a_ij|, which is never negative on a lattice.
 *
 * Where the flow is rigid in grains (solid_field.h) D w_ij is multiplied by the mean of the free parts 1 - Phi of i and j, or by 0 if one of them is 0: nothing diffuses into a particle that grains fill whole, and what is in it
 * rides along.
 *
 * A wall neighbour without flux drops out; shares.h has the shares k_ij that make up for it, with w_ij k_ij in place of w_ij. */
#ifndef SCREE_CARRIED_SCALAR_LINKS_H
#define SCREE_CARRIED_SCALAR_LINKS_H

#include "physics/fluid/operators/assembly.h"

/* All borrowed. */
struct links {
    const struct weights *weights;
    double diffusivity;  /* D */
    const double *carry; /* by entry: a_ij (neighbour_fluxes.h); NULL: none */
    bool upwind;
    const double *given; /* by foot: the value there; NAN: none */
    const double *slope; /* by foot, where no value is given; NULL: 0 */
    const double
        *filled; /* by particle number, copies too: the part that grains fill (rigid_fields_solid); NULL: 0 */
    const double *share;               /* by entry: k_ij (shares.h); NULL: 1 */
    const struct weights_input *input; /* of the weights: for scalar_links_flux alone */
};

/* Values of the assembly: those of diagonal c - factor sum over j of K_ij (c_j - c_i), without what is given. `diagonal` is by
 * row; NULL: 1. Opens its own team, as all here. */
void scalar_links_matrix(const struct links *links, double factor, const double *diagonal,
                         struct assembly *assembly);

/* side[row] = factor times what is given. */
void scalar_links_side(const struct links *links, double factor, double *side);

/* out[row] = sum over j of K_ij (c_j - c_i); values by particle number, whose copies are up to date. */
void scalar_links_apply(const struct links *links, const double *value, double *out);

/* out[row] = the flux density u c - D grad c of the same values: sum over j of F_ij (x_j - x_i) / 2, F_ij what i gives to j. */
void scalar_links_flux(const struct links *links, const double *value, double (*out)[3]);

#endif
