/* SPDX-License-Identifier: BSD-3-Clause */
/* The Poisson equation of the pressure, div grad phi = d (div c grad phi, c of gradient_correction.h), without flux through walls. Its matrix is singular:
 * the pressure of each connected region has a free constant. */
#ifndef SCREE_SCHEMES_PRESSURE_H
#define SCREE_SCHEMES_PRESSURE_H

#include "physics/fluid/operators/assembly.h"

struct pressure {
    bool
        whole; /* with c of gradient_correction.h where the weights have it, and flow->mobility; set before pressure_make, and kept */
    const double *
        share; /* instead: by entry, factors of w_ij (shares.h); set before pressure_make, and borrowed till then; NULL: none */
    struct solve_system *system;
    double *side, *solution; /* [rows] */
};

/* Makes the system; the assembly's values are overwritten. False with an error of an option. Collective. */
bool pressure_make(struct pressure *pressure, struct solve *solve, struct assembly *assembly,
                   const struct flow *flow, const struct solve_options *options, struct error *error);
void pressure_free(struct pressure *pressure);

/* Solves div grad phi = factor divergence, less its mean over each region; `divergence` is by row. phi, of mean
 * 0 in each region, goes to flow->increment of the owned particles. False if the solver failed: `error` says
 * so. Collective. */
bool pressure_solve(struct pressure *pressure, const struct flow *flow, const double *divergence,
                    double factor, bool guess, struct error *error);

#endif
