/* SPDX-License-Identifier: BSD-3-Clause */
/* Scalars that the fluid carries: concentrations or temperatures, which do not act on the flow. On particles at rest
 *
 *   (c - a c^n + b c^(n-1)) / (g dt) = - (u . grad) c + D div grad c
 *
 * at the end of the step, backward differences of second order as in moving_step.h (r = dt over that of the step before, g =
 * (1 + r) / (1 + 2 r), a = (1 + r)^2 / (1 + 2 r), b = r^2 / (1 + 2 r)), backward Euler in the first step. Space: w_ij of
 * weights.h, and the fluxes of neighbour_fluxes.h. No limit of dt. A boundary without a given value has no flux of c; at an open
 * side without one c does not change along the normal. A given value c_w is mirrored as a velocity is,
 *
 *   c_j - c_i = -(1 + beta) (c_i - c_w),   at an open side whose image m is a particle   c_j - c_i = 2 c_w - c_m - c_i
 *
 * Where the flow is rigid in grains (physics/fluid/coupling/rigid_step.h) scalars fill the grains, too, go with them, and do not diffuse there (scalar_links.h): so nothing has to open and close. What grains and fluid hold together is
 * conserved as it is elsewhere. */
#ifndef SCREE_CARRIED_SCALARS_H
#define SCREE_CARRIED_SCALARS_H

#include "engine/physics.h"
#include "physics/fluid/fluid_state.h"

struct scalars;

/* True if the scalars of the scene go with its other keys; else a user's error with the key. */
bool scalars_suit(const struct physics_context *context, struct error *error);

/* Makes the state of the scalars of the scene, and registers their fields; NULL without scalars. */
struct scalars *scalars_create(const struct physics_context *context);
void scalars_destroy(struct scalars **scalars);

/* The values of particle i at the start, i a particle of the fluid that has been placed. */
void scalars_begin(const struct physics_context *context, size_t i);

/* The particles, or their order, are others: matrices and fluxes are made again. */
void scalars_forget(struct scalars *scalars);

/* After scalars_forget and a rebuild, while the fluid has its pairs: what surfaces are to the scalars. Collective. */
void scalars_rebuilt(const struct physics_context *context);

/* A step of all scalars to the end of the step of the clock, after that of the flow; `flows`: the flow has changed.
 * An error goes to fluid->error. Collective. */
void scalars_step(const struct physics_context *context, bool flows);

/* The flux densities of the present values, for observables. Collective. */
void scalars_look(const struct physics_context *context);

/* u c - D grad c of scalar k by row, as of the last look; NULL before it. */
const double (*scalars_flux(const struct scalars *scalars, int k))[3];

void scalars_restart(struct scalars *scalars, struct restart *list);
void scalars_print(const struct physics_context *context, FILE *file);

#endif
