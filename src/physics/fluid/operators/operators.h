/* SPDX-License-Identifier: BSD-3-Clause */
/* Operators on arrays of values, applied row by row from weights (weights.h). Inputs are arrays by particle
 * number, owned particles and copies, `stride` doubles from one to the next; copies must be up to date.
 * Outputs are arrays by row. Each function opens its own team; bits do not depend on threads.
 *
 * Pressure has no flux through walls: wall neighbours drop out. Velocity is mirrored at the walls. Open sides of
 * given pressure are the other way round: pressure is mirrored, velocity goes on as it is. */
#ifndef SCREE_OPERATORS_OPERATORS_H
#define SCREE_OPERATORS_OPERATORS_H

#include "physics/fluid/operators/weights.h"

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

/* out[row] = (carrier . grad) u, mirrored at the walls with the capped coefficient; of the carrier the values of owned particles
 * alone are read. */
void operators_advection(const struct weights *weights, struct operators_values carrier,
                         struct operators_values u, double (*out)[3]);

/* out[row] = the inertia of a flow without divergence, (u . grad) u + 1/2 (div u) u:
 *
 *   sum over j of (a_ij - k_ij) (u_j - u_i) + 1/2 b_ij . (u_j - u_i) u_i,   a_ij = 1/2 b_ij . (u_i + u_j)
 *
 * Without k, and on a lattice, where b_ij = -b_ji and the b_ij of a row add up to 0, that is sum over j of a_ij u_j with a_ij = -a_ji: the sum of
 * u . out over all particles is 0 for any u, so that inertia makes no kinetic energy, even where the lattice hardly resolves the flow and leaves a divergence in it
 * (the skew-symmetric form: Morinishi, Lund, Vasilyev, Moin, J. Comput. Phys. 143 (1998) 90). For bodies at rest to let nothing through in this sum,
 * too, they mirror the velocity as if j lay as deep as i lies high (beta = 1): u_j = -u_i, a_ij = 0.
 *
 * The projection of a flow beside bodies keeps no energy: its divergence mirrors with beta, its gradient sees fluid neighbours alone. In throats that hold a node or two,
 * pressure then feeds eddies of their size. So rows beside walls and grains have the diffusion k_ij = max(0, |a_ij| / OPERATORS_LINK_PECLET - viscosity w_ij): none
 * up to a speed of 2 OPERATORS_LINK_PECLET viscosities (kinematic) over the distance of j, 4.5 over the spacing for the farthest neighbours of the default support.
 * A link between such a row and one farther from bodies has it on one side alone. */
#define OPERATORS_LINK_PECLET 5.0

/* In general a volume flow g carries the velocity u:
 *
 *   sum over j of (a_ij - k_ij) (u_j - u_i) + share b_ij . (g_j - g_i) u_i,   a_ij = 1/2 b_ij . (g_i + g_j)
 *
 * With g = u and share 1/2 that is the sum above. With share 1 it is div (g u), which on a lattice is sum over j of a_ij (u_i + u_j): no momentum gets lost, and
 * where d e/dt = -div g no energy 1/2 e u^2. */
struct operators_stream {
    struct operators_values flow, velocity; /* g, u */
    double share;
};
void operators_inertia(const struct weights *weights, const struct operators_stream *stream, double viscosity,
                       double (*out)[3]);

/* out[row] = div g over fluid neighbours alone, without walls: of a gradient of the pressure. */
void operators_divergence_inner(const struct weights *weights, struct operators_values g, double *out);

/* The difference u_j - u_i of the velocity at a wall entry: no penetration along the normal, the slip of the
 * walls across; at an open side what is given there. Any thread. */
void operators_mirror(const struct weights *weights, size_t wall, struct operators_values u,
                      const double *own, double difference[3]);

#endif
