/* SPDX-License-Identifier: BSD-3-Clause */
/* Operators on arrays of values, applied row by row from weights (weights.h). Inputs are arrays by particle
 * number, owned particles and copies, `stride` doubles from one to the next; copies must be up to date.
 * Outputs are arrays by row. Each function opens its own team; bits do not depend on threads.
 *
 * Pressure has no flux through walls: wall neighbours drop out. Velocity is mirrored at the walls. Open sides of
 * given pressure are the other way round: pressure is mirrored, velocity goes on as it is. */
#ifndef SCREE_FLUID_OPERATORS_H
#define SCREE_FLUID_OPERATORS_H

#include "fluid/weights.h"

/* Values of all particles. */
struct operators_values {
    const double *value;
    size_t stride; /* doubles */
    double open;   /* of a pressure: at open sides its value is this times the pressure that is given there */
};

/* out[row] = grad p; in two dimensions the third component is 0. */
void operators_gradient(const struct weights *weights, struct operators_values p, double (*out)[3]);

/* p_j - p_i of a wall entry: 0, but for an open side. Any thread. */
double operators_pressure_step(const struct weights *weights, size_t wall, struct operators_values p,
                               double own);

/* out[row] = div grad p. */
void operators_laplacian(const struct weights *weights, struct operators_values p, double *out);

/* out[row] = div u, mirrored at the walls with the capped coefficient. */
void operators_divergence(const struct weights *weights, struct operators_values u, double *out);

/* out[row] = div grad u, each component, mirrored (no slip, or the slip of the weights). */
void operators_laplacian_velocity(const struct weights *weights, struct operators_values u, double (*out)[3]);

/* The operator of Stokes' equations in one go, component after component: out[d rows + row] = gradient (grad p)_d -
 * viscous (div grad u)_d for each direction d, then out[dimension rows + row] = -divergence div u. */
struct operators_stokes {
    double gradient, viscous, divergence; /* factors */
};
void operators_stokes(const struct weights *weights, struct operators_values u, struct operators_values p,
                      const struct operators_stokes *factor, double *out);

/* out[row] = (carrier . grad) u, mirrored with a beta of `most` at the most; of the carrier the values of owned particles
 * alone are read. */
void operators_advection(const struct weights *weights, struct operators_values carrier,
                         struct operators_values u, double most, double (*out)[3]);

/* out[row] = div g over fluid neighbours alone, without walls: of a gradient of the pressure. */
void operators_divergence_inner(const struct weights *weights, struct operators_values g, double *out);

/* The difference u_j - u_i of the velocity at a wall entry: no penetration along the normal, the slip of the
 * walls across; at an open side what is given there. Any thread. */
void operators_mirror(const struct weights *weights, size_t wall, struct operators_values u,
                      const double *own, double difference[3]);

#endif
