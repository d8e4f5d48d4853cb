/* SPDX-License-Identifier: BSD-3-Clause */
/* What a packing tells its caller: while it is made, and when it is done. */
#ifndef SCREE_PACK_PACK_REPORT_H
#define SCREE_PACK_PACK_REPORT_H

#include "front/pack/bed.h"
#include "front/pack/relax.h"

/* Called after each sweep with the name of the relaxed set ("spheres", "large", "small"). */
struct pack_hook {
    void (*show)(void *context, const char *what, const struct relax_state *state);
    void *context;
};

struct pack_report {
    char container[256];      /* its shape and size in words */
    double box;               /* edge of the cube */
    double fraction;          /* of the container's volume that is solid */
    double smallest, largest; /* radii */
    double overlap;           /* the largest in the final packing, as part of the smaller radius; 0: none */
    int sweeps;
    struct pack_bed bed; /* SETTLED; else all 0 */
    /* BIDISPERSE: */
    double started_fraction; /* solid fraction of the small spheres before any was removed */
    uint64_t large, small, removed,
        thinned;        /* in the packing; removed at large spheres; taken out at random */
    int64_t difference; /* small spheres more than wanted (0 with the recipe) */
};

#endif
