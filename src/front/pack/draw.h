/* SPDX-License-Identifier: BSD-3-Clause */
/* Radii of a packing, drawn from its law: that of particle k depends on the seed, the law and k alone. */
#ifndef SCREE_PACK_DRAW_H
#define SCREE_PACK_DRAW_H

#include "base/error.h"
#include "front/pack/options.h"
#include <stdbool.h>
#include <stddef.h>

/* Fills radius[0 ... count-1]. Not for BIDISPERSE. Fails (user) on an empty law or a bad sieve file. Opens
 * its own thread team. */
bool draw_radii(const struct pack_options *options, double *radius, size_t count, struct error *error);

/* Draws radii until their spheres hold `solid`, to the nearest sphere; at most 134 million. The caller frees them with memory_free. NULL:
 * error (user). Opens its own thread team. */
double *draw_fill(const struct pack_options *options, double solid, size_t *count, struct error *error);

#endif
