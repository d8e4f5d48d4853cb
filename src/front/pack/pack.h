/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes packings: the particles that the scene of a recipe makes, as rows. One process with threads; the result is the same bits for any
 * number of threads. */
#ifndef SCREE_PACK_PACK_H
#define SCREE_PACK_PACK_H

#include "data/formats/rows.h"
#include "data/scene/packed.h"
#include "front/pack/recipe.h"
#include "data/scene/region.h"

/* A bed of spheres that lie on each other in a container. */

struct bed {
    double height; /* above the lowest point of the container: three quarters of the solid volume lie below */
    double fraction; /* solid fraction of the container below this height, free of the bed's loose top */
};

/* Measures the bed of these rows (position, radius, box) in a region. The volume of a region other than a box below the height comes from 200,000
 * random points in the whole: to about 0.3 % of a bed that fills half of it, worse for a shallow one. One thread. */
struct bed bed_measure(const struct region *region, const struct region_space *space,
                       const struct rows *rows);

/* What a packing tells its caller: while it is made, and when it is done. */
struct pack_report {
    struct packed_report packed; /* as the source tells, also while it works */
    char container[256];         /* its shape and size in words */
    double fraction;             /* of the container's volume that is solid */
    double smallest, largest;    /* radii */
    uint64_t kinds[2];           /* particles of the first and the second material */
    struct bed bed;              /* of spheres that have settled; else all 0 */
};

/* Called now and then while the packing is made. */
struct pack_hook {
    void (*show)(void *context, const struct pack_report *report);
    void *context;
};

/* Makes a packing: rows with id from 1, position, radius, mass, material, and velocity if one is asked for. The caller frees the rows
 * with rows_free. Positions lie in the box of the rows. Fails (user) if the spheres do not fit. Opens its own thread team. */
bool pack_make(const struct recipe *recipe, const struct pack_hook *hook, struct rows *rows,
               struct pack_report *report, struct error *error);

#endif
