/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of grains in which the flow is rigid (rigid_step.h), by particle number. */
#ifndef SCREE_COUPLING_RIGID_FIELDS_H
#define SCREE_COUPLING_RIGID_FIELDS_H

#include "engine/physics.h"

/* Adds the fields of grains in which the flow is rigid (rigid_step.h). By fluid particle: the part that grains fill; the forcing and the change of the
 * pressure of the last step. By grain: velocity and spin at the end of the last step of the fluid, NAN before the first, and their changes in it; momentum and angular momentum of contacts
 * since; force and torque of the fluid in the grain's own steps (rigid_motion.h), NAN before the first; motions within a step, six numbers. fluid_load is there, too. */
void rigid_fields_add(struct particles *particles);
double *rigid_fields_solid(const struct particles *particles);
void rigid_fields_solid_forward(
    const struct physics_context *context); /* brings its copies up to date; collective */
double (*rigid_fields_forcing(const struct particles *particles))[3];
double *rigid_fields_potential(const struct particles *particles);
double (*rigid_fields_motion(const struct particles *particles))[12];
double (*rigid_fields_impulse(const struct particles *particles))[6];
double (*rigid_fields_held(const struct particles *particles))[6];
double (*rigid_fields_found(const struct particles *particles))[6];
int rigid_fields_found_handle(const struct particles *particles);

/* The part of a fluid particle that no grain fills: 1 where a scene has no rigid grains. Any thread. */
double rigid_fields_free(const struct particles *particles, size_t i);

#endif
