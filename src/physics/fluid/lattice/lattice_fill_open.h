/* SPDX-License-Identifier: BSD-3-Clause */
/* What the open sides of the box need of the lattice. */
#ifndef SCREE_LATTICE_LATTICE_FILL_OPEN_H
#define SCREE_LATTICE_LATTICE_FILL_OPEN_H

#include "physics/fluid/lattice/nodes.h"
#include "physics/fluid/lattice/regions.h"

/* True if fluid lies at each open side; where no side has a pressure, if as much flows in as out; where one has, if each
 * connected region reaches such a side. Else a user's error with the key. Collective. */
bool lattice_fill_open_suits(const struct nodes *nodes, const struct regions *regions,
                             const struct physics_context *context, struct error *error);

#endif
