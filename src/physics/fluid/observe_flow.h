/* SPDX-License-Identifier: BSD-3-Clause */
/* The functions of the observables of a flow as a whole and of its solvers (fluid_fields.c has their rows). */
#ifndef SCREE_FLUID_OBSERVE_FLOW_H
#define SCREE_FLUID_OBSERVE_FLOW_H

#include "data/observe/observables_kinds.h"

/* Mass flow along x, y and z: density x velocity x volume, summed, over the box's edge. */
void observe_flow_rate(const struct observable_context *context, struct observable_item *item, double *part);

/* The driving force times the box's edge, and what the mean pressure at the open side below has more than that at the one above, along x, y and
 * z. In twelve parts. */
void observe_pressure_drop(const struct observable_context *context, struct observable_item *item,
                           double *part);
void observe_pressure_drop_finish(const struct output_view *view, const struct observable_item *item,
                                  double *part);

/* Viscosity x superficial velocity along the driving force / force: Darcy's law. In two parts. */
void observe_permeability(const struct observable_context *context, struct observable_item *item,
                          double *part);
void observe_permeability_finish(const struct output_view *view, const struct observable_item *item,
                                 double *part);

/* Force of the fluid on a wall or a group, its viscous part, its pressure part, and its torque (of a wall about its
 * centre; of a group the sum of those on its grains about their centres), as of the last look: twelve parts. Of a wall that moves through the fluid (rigid_walls.h), as of a group in which the flow is rigid, both parts are NAN. */
void observe_drag(const struct observable_context *context, struct observable_item *item, double *part);

/* Iterations of the last solve for the pressure, or for the steady flow. */
void observe_iterations(const struct observable_context *context, struct observable_item *item, double *part);

/* Of the scalar whose number the row's name has ("scalar_1_mean"): the mean over the fluid; the flux along x, y and z; the mean
 * weighted by the flow. In two, three and six parts. */
void observe_scalar_mean(const struct observable_context *context, struct observable_item *item,
                         double *part);
void observe_scalar_mean_finish(const struct output_view *view, const struct observable_item *item,
                                double *part);
void observe_scalar_flux(const struct observable_context *context, struct observable_item *item,
                         double *part);
void observe_scalar_carried(const struct observable_context *context, struct observable_item *item,
                            double *part);
void observe_scalar_carried_finish(const struct output_view *view, const struct observable_item *item,
                                   double *part);

/* Charge of the ions of an electrolyte; true if the scene has one. */
void observe_charge(const struct observable_context *context, struct observable_item *item, double *part);
bool observe_charged(const struct output_view *view);

/* True if the scene has scalar 1, 2 or 3. */
bool observe_scalar_1(const struct output_view *view);
bool observe_scalar_2(const struct output_view *view);
bool observe_scalar_3(const struct output_view *view);

/* The larger of the true relative residuals of velocity and pressure; of a steady flow that of the momentum. */
void observe_residual(const struct observable_context *context, struct observable_item *item, double *part);

#endif
