/* SPDX-License-Identifier: BSD-3-Clause */
/* A field in a fluid between walls and around grains that let nothing of it through:
 *
 *   div grad Phi = 0,   no flux through walls and grains,   Phi + E_0 . x periodic,   E = - grad Phi
 *
 * Phi = phi - E_0 . x; the matrix of phi is that of the pressure, with the shares of shares.h. In the gradient a wall neighbour j counts with the part of
 * grad Phi . (x_j - x_i) along the wall, so that a field along a wall is exact. */
#ifndef SCREE_CARRIED_APPLIED_FIELD_H
#define SCREE_CARRIED_APPLIED_FIELD_H

#include "physics/fluid/operators/assembly.h"

/* All borrowed. */
struct applied {
    const struct flow *flow; /* its increment is scratch */
    const struct weights_input *input;
    struct assembly *assembly; /* has the pattern; the values are overwritten */
    struct solve *solve;
    const double *share; /* by entry (shares.h) */
    const char *preconditioner;
};

/* field[3 i ...] = E of the owned fluid particles i. False, with an error, if the solver failed. Collective. */
bool applied_field(const struct applied *applied, const double far[3], double *field, struct error *error);

#endif
