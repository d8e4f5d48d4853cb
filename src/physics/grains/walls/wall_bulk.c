/* SPDX-License-Identifier: BSD-3-Clause */
/* Signs on a lattice. Read wall_bulk.h first. */
#include "physics/grains/walls/wall_bulk.h"
#include "base/memory.h"
#include <math.h>

/* The spacing over the reach: below 1, so that a node on the surface has no neighbour beyond the reach; above it memory grows. */
static const double fine = 0.9;

enum { MARGIN = 2 }; /* nodes outside of the box on each side */

static size_t nodes_along(double from, double to, double spacing) {
    return (size_t)ceil((to - from) / spacing) + 2 * MARGIN + 1;
}

struct wall_bulk *wall_bulk_create(struct law_vector lower, struct law_vector upper, double reach) {
    struct wall_bulk *bulk = memory_allocate_zero(1, sizeof *bulk, "the solid of a wall");
    const double spacing = fine * reach, outside = -MARGIN * spacing;
    bulk->reach = reach;
    bulk->spacing = spacing;
    bulk->lower = law_add(lower, outside, (struct law_vector){1.0, 1.0, 1.0});
    bulk->count[0] = nodes_along(lower.x, upper.x, spacing);
    bulk->count[1] = nodes_along(lower.y, upper.y, spacing);
    bulk->count[2] = nodes_along(lower.z, upper.z, spacing);
    bulk->solid = memory_allocate_zero(bulk->count[0] * bulk->count[1] * bulk->count[2], sizeof *bulk->solid,
                                       "the solid of a wall");
    return bulk;
}

void wall_bulk_destroy(struct wall_bulk **bulk) {
    if (*bulk != NULL)
        memory_free((*bulk)->solid);
    memory_free(*bulk);
    *bulk = NULL;
}

struct law_vector wall_bulk_node(const struct wall_bulk *bulk, size_t k) {
    const struct law_vector at = {(double)(k % bulk->count[0]), (double)(k / bulk->count[0] % bulk->count[1]),
                                  (double)(k / bulk->count[0] / bulk->count[1])};
    return law_add(bulk->lower, bulk->spacing, at);
}

/* The node nearest along one direction; the last one or more where there is none. */
static size_t nearest(double from, double x, double spacing, size_t count) {
    double at = rint((x - from) / spacing);
    return at >= 0.0 && at < (double)count ? (size_t)at : count;
}

bool wall_bulk_solid(const struct wall_bulk *bulk, struct law_vector x) {
    const size_t *count = bulk->count;
    size_t at[3] = {nearest(bulk->lower.x, x.x, bulk->spacing, count[0]),
                    nearest(bulk->lower.y, x.y, bulk->spacing, count[1]),
                    nearest(bulk->lower.z, x.z, bulk->spacing, count[2])};
    if (at[0] == count[0] || at[1] == count[1] || at[2] == count[2])
        return false;
    return bulk->solid[at[0] + count[0] * (at[1] + count[1] * at[2])] != 0;
}
