/* SPDX-License-Identifier: BSD-3-Clause */
/* The sums over the nodes of grains in a step with rigid grains (rigid_step.h), and what follows from them for each grain. The field of loads
 * (fluid_load) carries the sums of copies to the owners. */
#ifndef SCREE_COUPLING_RIGID_SUMS_H
#define SCREE_COUPLING_RIGID_SUMS_H

#include "engine/physics.h"
#include "physics/fluid/coupling/rigid_grains.h"
#include "physics/fluid/coupling/rigid_walls.h"
#include "physics/fluid/coupling/solid_field.h"
#include "physics/fluid/schemes/anderson.h"
#include "physics/fluid/schemes/flow.h"
#include "kernel/particles/kinds.h"

/* What a step keeps in memory; all owned. */
struct rigid {
    struct solid_field solid;
    struct rigid_walls walls;
    struct anderson anderson;
    size_t rows, parts_room, grains;
    double (*bare)[3];              /* w, by row of the weights */
    double (*try)[3], (*lack)[3];   /* q, and what it lacks, by row that has parts of grains */
    struct rigid_grains_sums *sums; /* by owned grain and body */
    double (*section)[2];           /* rigid_bodies_sections */
    int64_t iterations, steps;      /* so far: solves of the pressure, and steps */
    bool apart;                     /* it was told that a fixed point was not found */
};

/* A step in progress. */
struct rigid_work {
    const struct physics_context *context;
    struct fluid *fluid;
    struct rigid *rigid;
    const struct flow *flow;
    struct kind_span grains; /* owned grains and bodies */
    double dt, share;        /* share: dt / rho */
    double kappa;
};

/* The motion of what fills a part of a node: `found` are those of grains. Any thread. */
static inline const double *rigid_motion_at(const struct rigid *rigid, const double (*found)[6],
                                            const struct solid_part *part) {
    int wall = solid_wall(part->grain);
    return wall >= 0 ? rigid->walls.wall[wall].motion : found[part->grain];
}

/* m, s and J of all grains: in two rounds, as six numbers of a grain travel at once. Collective. */
void rigid_sums_moments(const struct rigid_work *work);

/* The momenta of v, and those about the centres, of all grains: in the field of loads. v[k] is by node of the solid. Collective. */
void rigid_sums_momenta(const struct rigid_work *work, const double (*v)[3]);

/* The motions of all grains that go with these momenta, copies too: in the field rigid_fields_found. Collective. */
void rigid_sums_motions(const struct rigid_work *work);

/* The loads of grains and walls: what the fluid loses, and what the fluid in the grain takes to follow; the motions found become those of the grains. The momenta of v are in the field of loads. Collective. */
void rigid_sums_loads(const struct rigid_work *work);

#endif
