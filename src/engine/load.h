/* SPDX-License-Identifier: BSD-3-Clause */
/* Balance of the load among ranks (`domain: bisection`), and what of a rank's time is work. */
#ifndef SCREE_ENGINE_LOAD_H
#define SCREE_ENGINE_LOAD_H

#include "engine/state.h"

/* Lays the bricks by where the particles of all ranks are, or as the checkpoint of a resume has them
 * (`resumed`: ranks per direction, 0: none) where that serves. Before the first rebuild; a bisection:
 * nothing. Collective. */
void load_lay(struct simulation *simulation, const int resumed[3]);

/* Divides the box by the numbers of particles, once, before the first migration. Bricks: nothing. Collective.
 */
void load_begin(struct simulation *simulation);

/* Divides the box as a checkpoint on as many ranks had it; takes the tree over. `fresh`: the imbalance was
 * not measured since; `reached`: the imbalance after the division. */
void load_restore(struct simulation *simulation, struct domain_tree *tree, bool fresh, double reached);

/* At a rebuild, while the last pair list still stands: divides the box again if the loads have become uneven.
 * Collective. */
void load_balance(struct simulation *simulation);

/* Seconds of this rank so far: of work, and in communication (waiting for others included). */
double load_seconds(const struct simulation *simulation);
double load_waiting(const struct simulation *simulation);

#endif
