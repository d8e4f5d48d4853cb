/* SPDX-License-Identifier: BSD-3-Clause */
/* Connected regions of fluid on the lattice of nodes, across all ranks. A pocket, such as between grains in contact, is a region too
 * small to matter: it becomes solid, as its pressure would be a further unknown constant. */
#ifndef SCREE_LATTICE_REGIONS_H
#define SCREE_LATTICE_REGIONS_H

#include "physics/fluid/lattice/nodes.h"

/* A region with less than this part of the nodes of the largest one is a pocket. */
#define REGIONS_POCKET 0.01

/* The owner of a node in a pocket that has become solid. */
enum { REGIONS_NOBODY = INT32_MAX };

/* Of all ranks. */
struct regions {
    int count;      /* regions that stay fluid; 0: no fluid at all */
    int64_t fluid;  /* nodes in them */
    int64_t pocket; /* nodes in pockets */
};

/* Numbers the regions, from the largest one on (owner of the fluid nodes), and fills the pockets, among this rank's own
 * nodes. Nodes of a region are joined along the edges of the lattice. The same on any number of ranks. Collective. */
struct regions regions_find(struct nodes *nodes);

#endif
