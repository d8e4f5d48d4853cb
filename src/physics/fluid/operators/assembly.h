/* SPDX-License-Identifier: BSD-3-Clause */
/* The matrices of the fluid from rows of weights. One pattern serves momentum and pressure: the diagonal and
 * the fluid neighbours, columns increasing, those of two images of one particle merged. Counted, scanned and
 * filled by threads, each its own rows. */
#ifndef SCREE_OPERATORS_ASSEMBLY_H
#define SCREE_OPERATORS_ASSEMBLY_H

#include "physics/fluid/schemes/flow.h"
#include "physics/solve/solve.h"

/* All owned. */
struct assembly {
    int32_t rows;
    int32_t *start, *column; /* as in struct solve_rows */
    int32_t
        *place; /* by entry of the weights: where the value of a fluid neighbour, or of an image, is added */
    int32_t *diagonal;     /* by row: where the diagonal stands */
    double *value;         /* scratch for one matrix at a time */
    struct timers *timers; /* of the flow, borrowed */
};

/* Makes the pattern of a flow whose rows are numbered. False, with a user's error, if the numbers do not fit
 * into 32 bits. Collective. */
bool assembly_make(struct assembly *assembly, const struct flow *flow, struct error *error);
void assembly_free(struct assembly *assembly);

/* value = inertia - viscous div grad, for component `component` of a velocity; with a slip length the walls
 * give each component a diagonal of its own. */
void assembly_momentum(struct assembly *assembly, const struct weights *weights, double inertia,
                       double viscous, int component);

/* value = - div grad, no flux through walls; regular if a pressure is given at open sides. `whole`: - div c grad, c of gradient_correction.h
 * where the weights have it. With a factor `mobility` > 0 of each particle, copies included, unless NULL. */
void assembly_pressure(struct assembly *assembly, const struct weights *weights, bool whole,
                       const double *mobility);

/* value = - div k grad, the same with a factor k > 0 of each particle, copies included. */
void assembly_darcy(struct assembly *assembly, const struct weights *weights, struct operators_values k);

/* The same with a factor of each entry (shares.h). */
void assembly_shared(struct assembly *assembly, const struct weights *weights, const double *share);

struct solve_rows assembly_rows(const struct assembly *assembly);

/* The factor of (u_i - u_w) in component `component` of a wall entry, and what the other components add to
 * it with a slip length (factor of n_c n_d (u_i - u_w)_d). */
double assembly_wall_factor(const struct weights *weights, size_t wall, int component);

#endif
