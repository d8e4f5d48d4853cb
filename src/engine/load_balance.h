/* SPDX-License-Identifier: BSD-3-Clause */
/* Balance of the load among ranks (`domain: bisection`), and the part of a rank's time that is work. */
#ifndef SCREE_ENGINE_LOAD_BALANCE_H
#define SCREE_ENGINE_LOAD_BALANCE_H

#include "engine/state.h"

/* Lays the bricks by the positions of the particles of all ranks and the grid that the scene wants (`wanted`: ranks per
 * direction, 0: any), or with the grid of a resume's checkpoint (`resumed`, 0: none) if that grid fits. Before the first
 * rebuild; does nothing for a bisection. Collective. */
void load_lay(struct ranks *ranks, const struct particles *particles, const struct box *box,
              const struct comm *comm, const int wanted[3], const int resumed[3]);

/* The map of the particles of all ranks for domain_grid_choose; memory_free. Collective. */
double *load_map(const struct particles *particles, const struct box *box, const struct comm *comm);

/* Divides the box by the numbers of particles, once, before the first migration. Does nothing for bricks.
 * Collective. */
void load_begin(struct ranks *ranks, const struct particles *particles, const struct box *box,
                const struct comm *comm);

/* Divides the box by the tree of a checkpoint written on as many ranks; becomes the owner of the tree.
 * `fresh`: the imbalance has not been measured since the division. `reached`: the imbalance after the
 * division. */
void load_restore(struct ranks *ranks, struct domain_tree *tree, bool fresh, double reached);

/* At a rebuild, while the last pair list is still valid: divides the box again if the loads have become
 * uneven. Collective. */
void load_balance(struct simulation *simulation);

#endif
