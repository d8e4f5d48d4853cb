/* SPDX-License-Identifier: BSD-3-Clause */
/* The choice of size classes. It stands here, and not beside the classes, as `auto` asks the cost model of the index. */
#ifndef SCREE_PAIRS_CLASSES_CHOOSE_H
#define SCREE_PAIRS_CLASSES_CHOOSE_H

#include "kernel/particles/classes.h"

/* Chooses cuts from a sample of radii (all of them, or a sample that is the same on every rank; sorted in
 * place). Fills count, cut, radius_min/max of the sample, and the skins and margins for the given range.
 * n = 0 gives one empty class. Fails (user) if the cuts are not increasing or leave a radius above the last.
 */
bool classes_choose(struct size_classes *classes, const struct classes_options *options,
                    const struct classes_range *range, double *radii, size_t n, struct error *error);

#endif
