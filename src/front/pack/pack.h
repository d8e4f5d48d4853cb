/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes packings: spheres of a law of sizes in a container, at random, without overlap. One process with threads;
 * the result is the same bits for any number of threads. */
#ifndef SCREE_PACK_PACK_H
#define SCREE_PACK_PACK_H

#include "data/formats/rows.h"
#include "front/pack/options_read.h"
#include "front/pack/pack_report.h"

/* Makes a packing: rows with id from 1, position, radius, mass, material, and velocity if one is asked for.
 * The caller frees the rows with rows_free. Positions lie in the box of the rows, that around the container. Fails (user) if the spheres do not
 * fit. Opens its own thread team. */
bool pack_make(const struct pack_options *options, const struct pack_hook *hook, struct rows *rows,
               struct pack_report *report, struct error *error);

#endif
