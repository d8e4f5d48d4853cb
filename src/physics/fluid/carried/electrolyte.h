/* SPDX-License-Identifier: BSD-3-Clause */
/* A symmetric electrolyte in the fluid: the potential psi of its ions beside charged walls and grains, and the force of an
 * applied field on their charge. In units of the thermal voltage V = k_B T / (z e), with the Debye length
 * lambda = sqrt(epsilon k_B T / (2 z^2 e^2 n)), n ions of each sign a volume (Poisson and Boltzmann):
 *
 *   div grad psi = sinh(psi) / lambda^2,   psi = zeta at a surface, or dpsi/dn = - sigma / (epsilon V) out of it
 *   charge density rho = - epsilon V / lambda^2 sinh(psi),   force on the fluid rho E
 *
 * with psi in place of sinh(psi) for Debye and Hueckel's equation. The gradient rho grad psi is a part of the pressure, and left
 * out. E = - grad Phi of an applied field E_0 in an insulating world: div grad Phi = 0, no field through walls and grains, Phi + E_0 . x
 * periodic. The charge does not follow the flow.
 *
 * Newton's method by the linear solver of solve.h, with the exact Jacobian (w_ij; Sum w + cosh(psi) / lambda^2 on the diagonal: an
 * M-matrix), from psi = 0; a step changes psi by 2 at most, and is halved until the residual falls. */
#ifndef SCREE_CARRIED_ELECTROLYTE_H
#define SCREE_CARRIED_ELECTROLYTE_H

#include "engine/physics.h"
#include "physics/fluid/fluid_state.h"

struct electrolyte;

/* True if the section goes with the other keys; else a user's error with the key. */
bool electrolyte_suits(const struct physics_context *context, struct error *error);

/* The state of the section, with its fields registered; NULL without the section. */
struct electrolyte *electrolyte_create(const struct physics_context *context);
void electrolyte_destroy(struct electrolyte **electrolyte);

/* The particles, or their order, are others. */
void electrolyte_forget(struct electrolyte *electrolyte);

/* After electrolyte_forget and a rebuild, while the fluid has its pairs: what surfaces are to the field. Collective. */
void electrolyte_rebuilt(const struct physics_context *context);

/* Solves for potential and field where that is not done yet, and gives the flow its force by row. An error goes to
 * fluid->error. Collective. */
void electrolyte_step(const struct physics_context *context);

void electrolyte_print(const struct physics_context *context, FILE *file);

#endif
