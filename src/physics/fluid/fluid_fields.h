/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of a fluid, by particle number; pointers as of fields_values (kernel/particles/fields.h). */
#ifndef SCREE_FLUID_FLUID_FIELDS_H
#define SCREE_FLUID_FLUID_FIELDS_H

#include "physics/fluid/schemes/flow.h"
#include "kernel/particles/particles.h"

/* The handle of an array of a flow. */
int fluid_handle(const struct particles *particles, enum flow_array array);

/* Pressure, and divergence of the velocity, which is made before output; of the fluid particles. */
double *fluid_pressure(const struct particles *particles);
double *fluid_divergence(const struct particles *particles);

/* Force of the fluid on a grain, three components, made before output; of the grains. */
double *fluid_drag(const struct particles *particles);
int fluid_drag_handle(const struct particles *particles);

/* (u . grad) u of the step before, three components; of the fluid particles. */
double *fluid_advection(const struct particles *particles);

/* Condition number of the gradient's correction, made before output; of the fluid particles. */
double *fluid_condition(const struct particles *particles);

/* Adds the field of volumes, for scenes in which they differ; the values, of fluid and boundary particles, or NULL. */
void fluid_fields_volumes(struct particles *particles);
double *fluid_volume(const struct particles *particles);

/* Adds the field of steady flows between open sides: C of gradient_correction.h, or NULL. */
void fluid_fields_open(struct particles *particles);
double (*fluid_whole(const struct particles *particles))[9];

/* Adds the field of grains that are not resolved: k of projection.h, or NULL. */
void fluid_fields_mobility(struct particles *particles);
double *fluid_mobility(const struct particles *particles);

/* Adds the field of boundary particles that ride on grains; the arm from the grain's centre, NAN where not known yet. */
void fluid_fields_riding(struct particles *particles);
double (*fluid_arm(const struct particles *particles))[3];

/* Adds the fields of grains that the fluid moves (grain_coupling.h): force and torque of the fluid; velocity, acceleration, and those of the spin, as of
 * its last step; the force that grain_apply added last. */
void fluid_fields_free(struct particles *particles);
double (*fluid_load(const struct particles *particles))[6];
int fluid_load_handle(const struct particles *particles);
double (*fluid_push(const struct particles *particles))[6];

/* Adds the fields of fluid particles that move; the arrays of struct flow of these names, or NULL. */
void fluid_fields_moving(struct particles *particles);
double *fluid_velocity_before(const struct particles *particles);
double *fluid_drift(const struct particles *particles);
double *fluid_drift_advection(const struct particles *particles);
double *fluid_gradient(const struct particles *particles);

/* Number of the connected region, 0 ...; of the fluid particles. */
int32_t *fluid_region(const struct particles *particles);

/* Number of the body (body_surfaces.h); of the boundary particles. */
int64_t *fluid_body(const struct particles *particles);

#endif
