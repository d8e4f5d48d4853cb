/* SPDX-License-Identifier: BSD-3-Clause */
/* Which members belong to which bodies, on this rank, from a rebuild to the next. The bodies of this rank and the
 * copies of bodies that it holds are rows 0, 1, ...: own ones first. */
#ifndef SCREE_BODIES_BODIES_LINKS_H
#define SCREE_BODIES_BODIES_LINKS_H

#include "physics/bodies/bodies.h"
#include "physics/bodies/sums.h"
#include "kernel/comm/ghosts.h"

/* What does not change of a body. */
struct bodies_row {
    uint32_t particle; /* its particle, or copy */
    const struct clump *clump;
    double scale, mass, inertia[3];
    const struct integrator_motion *motion; /* prescribed; NULL: it moves by itself */
};

enum { BODIES_STATE = 13, BODIES_FULL = 6 };

struct bodies_links {
    int32_t rows, own;
    struct bodies_row *row;
    struct carried_pose *pose;
    double *sum;                   /* rows x sums_width */
    double (*state)[BODIES_STATE]; /* x v w q: what owners send */
    double (*full)[BODIES_FULL];   /* v w of the full step: what owners send */
    size_t *start; /* members of row b: member[start[b]] ... [start[b + 1]), by their number */
    uint32_t *member;
    int32_t *
        pose_of; /* of owned particles, as in struct carried; with a solver of contacts or a fluid also of copies */
    double (*offset)[3];
    int32_t (*image)[3];
    struct ghosts_part *part; /* NULL: one rank */
};

/* Makes the links after a rebuild, poses included; frees those before. Collective. */
void bodies_links_make(struct bodies *bodies, const struct physics_context *context);
void bodies_links_free(struct bodies_links **links);

/* Sends the states of own bodies to their copies, and sets the poses of all rows from them. Collective. */
void bodies_links_send(struct bodies_links *links);

#endif
