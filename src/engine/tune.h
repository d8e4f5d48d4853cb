/* SPDX-License-Identifier: BSD-3-Clause */
/* Trials of what an index that chooses has on offer. */
#ifndef SCREE_ENGINE_TUNE_H
#define SCREE_ENGINE_TUNE_H

#include "engine/state.h"

/* Around order, build and pairs of a rebuild, with `index.measure`: selects a variant, takes its time, and
 * keeps the one that was fastest on the slowest rank. tune_end is collective. */
void tune_begin(struct simulation *simulation);
void tune_end(struct simulation *simulation);

/* Seconds a rebuild that order, build and pairs took so far, this rank. */
double tune_measured(const struct simulation *simulation);

#endif
