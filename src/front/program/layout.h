/* SPDX-License-Identifier: BSD-3-Clause */
/* What a layout of ranks and threads will need, told by one rank: `scree check SCENE --ranks N --threads M`. */
#ifndef SCREE_PROGRAM_LAYOUT_H
#define SCREE_PROGRAM_LAYOUT_H

#include "engine/state.h"

/* Prints the bricks of `ranks` ranks, the particles and copies of a rank, and its memory, by the particles as they are
 * now. Counts each copy by the rule of kernel/comm/ghosts.h, for bricks; a bisection is more even. One rank, which has all
 * particles. False with a user's error if the box cannot be divided so. */
bool layout_print(const struct simulation *simulation, int ranks, int threads, struct error *error);

#endif
