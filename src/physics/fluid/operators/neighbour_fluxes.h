/* SPDX-License-Identifier: BSD-3-Clause */
/* The fluxes by which a flow carries scalars between neighbours. On a lattice the weights b_ij of the gradient are odd,
 * so that
 *
 *   Q_ij = b_ij . (u_i + u_j) - w_ij (phi_j - phi_i)
 *
 * is what i loses to j, and j gains, over a volume; Q = 0 at walls and grains. phi solves sum over j of Q_ij = 0: the velocity of
 * a projection on collocated particles is free of divergence up to second order alone, and what is left of it would
 * make sources of a scalar. So a scalar that is the same everywhere stays the same, and sums over particles are
 * conserved, both to the solver's tolerance:
 *
 *   (u . grad) c = sum over j of Q_ij (c_i + c_j) / 2 = sum over j of a_ij (c_j - c_i),   a_ij = Q_ij / 2
 *
 * On displaced particles, whose weights are not odd, a_ij = u_i . b_ij: of second order, conserved as well as that. */
#ifndef SCREE_OPERATORS_NEIGHBOUR_FLUXES_H
#define SCREE_OPERATORS_NEIGHBOUR_FLUXES_H

#include "physics/fluid/operators/assembly.h"
#include "physics/fluid/schemes/pressure.h"

/* All zero: nothing made yet. */
struct fluxes {
    struct pressure pressure; /* of phi */
    double *carry;            /* by entry of the weights: a_ij, 1/time; 0 at walls and grains */
    double *sum;              /* by row: scratch */
};

/* Makes the fluxes of a flow whose copies are up to date. `assembly` has the pattern of its matrices, and its values are
 * overwritten in the first call. flow->increment is scratch. False, with an error, if the solver failed. Collective. */
bool neighbour_fluxes_make(struct fluxes *fluxes, struct solve *solve, struct assembly *assembly,
                           const struct flow *flow, bool lattice, struct error *error);
void neighbour_fluxes_free(struct fluxes *fluxes);

#endif
