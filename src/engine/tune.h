/* SPDX-License-Identifier: BSD-3-Clause */
/* Trials of the variants that an index offers. */
#ifndef SCREE_ENGINE_TUNE_H
#define SCREE_ENGINE_TUNE_H

#include "engine/state.h"

/* Called before and after order, build and pairs of a rebuild, tune_select before all, only with `index.measure`. The
 * functions select a variant, measure its time, and keep the variant that was fastest on the slowest rank. tune_end is
 * collective. */
void tune_select(struct search *search);
void tune_begin(struct tuning *tuning);
void tune_end(struct search *search, const struct comm *comm);

/* Mean seconds of this rank for order, build and pairs of a rebuild so far. */
double tune_measured(const struct search *search);

#endif
