/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes packings: spheres of a law of sizes in a cube, at random, without overlap. One process with threads;
 * the result is the same bits for any number of threads. */
#ifndef SCREE_PACK_PACK_H
#define SCREE_PACK_PACK_H

#include "formats/rows.h"
#include "pack/options.h"
#include "pack/relax.h"

/* Called after each sweep with the name of the relaxed set ("spheres", "large", "small"). */
struct pack_hook {
    void (*show)(void *context, const char *what, const struct relax_state *state);
    void *context;
};

struct pack_report {
    double box;               /* edge of the cube */
    double fraction;          /* of its volume that is solid */
    double smallest, largest; /* radii */
    double overlap;           /* the largest in the final packing, as part of the smaller radius; 0: none */
    int sweeps;
    /* BIDISPERSE: */
    double started_fraction; /* solid fraction of the small spheres before any was removed */
    uint64_t large, small, removed,
        thinned;        /* in the packing; removed at large spheres; taken out at random */
    int64_t difference; /* small spheres more than wanted (0 with the recipe) */
};

/* Makes a packing: rows with id from 1, position, radius, mass, material, and velocity if one is asked for.
 * The caller frees the rows with rows_free. Positions lie in [0, box). Fails (user) if the spheres do not
 * fit. Opens its own thread team. */
bool pack_make(const struct pack_options *options, const struct pack_hook *hook, struct rows *rows,
               struct pack_report *report, struct error *error);

#endif
