/* SPDX-License-Identifier: BSD-3-Clause */
/* The shares s_ij of unresolved_grains.h, and the scratch of a step that has them. */
#ifndef SCREE_COUPLING_UNRESOLVED_SHARES_H
#define SCREE_COUPLING_UNRESOLVED_SHARES_H

#include "engine/physics.h"
#include "physics/fluid/operators/operators.h"

struct fluid;

/* Scratch of a step of the fluid. All owned. */
struct unresolved {
    /* In the rows of such grains in the pairs of owned particles: s_ij and the number of j, from the start of a row i to end[i]. */
    double *share;
    uint32_t *of;
    size_t *end;
    double (*seen)[3];  /* by owned particle: w of the fluid at a grain, before the step */
    double (*body)[3];  /* by row: force/volume of grains on the fluid */
    double *resist;     /* by row: a */
    double (*slope)[3]; /* by row */
};

void unresolved_shares_destroy(struct unresolved **unresolved);

/* True if owned particle i is a grain that the fluid does not resolve. Any thread. */
bool unresolved_shares_has(const struct physics_context *context, size_t i);

/* Makes fluid->dust, where there is none yet, the shares for the present places, and what grains see by them; an error on all ranks if a grain has no fluid around it.
 * Opens its own team. Collective. */
void unresolved_shares_make(const struct physics_context *context);

/* mean = the sum over the fluid around grain i of shares and `count` values of each particle. Any thread. */
void unresolved_shares_mean(const struct fluid *fluid, size_t i, struct operators_values value, int count,
                            double *mean);

#endif
