/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains that the fluid moves (`fluid.grains: free`): force and torque of the fluid on each of them go into the motion of
 * the grain, whose boundary particles ride on it (boundary_motion.h). The fluid makes a step every `every` steps of the grains, of the
 * length dt_f = every dt. Between its steps its load F, T, the momentum that it loses to the grain (surface_forces.h), is held, and
 * the grains have contacts, weight, buoyancy and this load; a step of the fluid then finds the load and the velocities of the grains
 * that belong together (coupled_solve.h), and the velocities of grains jump by what the load of this step has more than the one before. Before its first step the load is that of an added mass, rho V / 2, of a disc rho V, and of the forces on the grain at the start, held until that step. The forces at feet are those of
 * the velocity relative to the rigid motion of the grain (surface_forces.h), so that their torque is the whole one: a stress of no strain has none. -rho V g is buoyancy, as the
 * equations of the fluid have no gravity. In two dimensions forces and V are those per depth; a grain's mass is what the scene gives. */
#ifndef SCREE_COUPLING_GRAIN_COUPLING_H
#define SCREE_COUPLING_GRAIN_COUPLING_H

#include "engine/physics.h"
#include "physics/fluid/fluid.h"

/* True if the fluid moves grains. */
bool grain_free(const struct fluid_options *options);

/* What every message of a flow that stops a run adds where the fluid moves grains; else "". */
const char *grain_pockets(const struct fluid_options *options);

/* True if the keys go together with the others; else a user's error with the key. */
bool grain_suits(const struct physics_context *context, struct error *error);

/* True if the particles of the fluid let grains of groups with a given motion pass. */
bool grain_passes(const struct fluid_options *options);

/* True if all grains stand still, move as their group says among particles that move, or are those that the fluid moves; else a user's
 * error on all ranks. Collective. */
bool grain_grains_suit(const struct physics_context *context, struct error *error);

/* `admit` of struct physics_maker: no grain comes, and none goes where the fluid resolves any. */
struct physics_grain;
bool grain_admit(const struct physics_context *context, const struct physics_grain *grain,
                 struct error *error);

/* Steps of the grains in one of the fluid; true if the fluid makes one in this step of the grains; the length of its step. */
uint64_t grain_every(const struct physics_context *context);
bool grain_due(const struct physics_context *context);
double grain_dt(const struct physics_context *context);

/* True if the fluid moves particle i: a grain that it resolves and that no group holds. */
bool grain_moves(const struct physics_context *context, size_t i);

/* The volume that a grain displaces, in two dimensions an area. */
double grain_displaced(const struct physics_context *context, double radius);

/* The added mass of a grain alone in a fluid without viscosity: half of the mass that it displaces, of a disc all of it. */
double grain_added(const struct physics_context *context, double radius);

/* Fills the field of loads of all grains, of the present flow. Collective. */
void grain_load(const struct physics_context *context);

/* Buoyancy of grain i, and the push of what drives the fluid. */
void grain_push(const struct physics_context *context, size_t i, double push[3]);

/* Adds a push and a torque to the force of contacts on owned grain i, and counts their work and that of the jump of its velocity. */
void grain_add(const struct physics_context *context, size_t i, const double push[3], const double torque[3]);

/* The jumps of velocities have been counted. */
struct fluid;
void grain_jumped(struct fluid *fluid);

/* Once in each step of the grains, when their contacts have been summed: load and push are added to the forces on the owned grains. */
void grain_apply(const struct physics_context *context);

#endif
