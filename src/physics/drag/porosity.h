/* SPDX-License-Identifier: BSD-3-Clause */
/* The porosity around each grain i, from the volumes V of the grains within the support h of Wendland's C2 kernel W
 * (physics/density/density.h has the formula):
 *
 *   porosity = 1 - s / C,   s = sum over j other than i of V_j W(|x_i - x_j|) + V_i W(0) (1 - S(s / C))
 *
 * C is the part of the kernel before the walls, the product over walls of the part on this side of a plane through the
 * nearest point of the wall. A sum at the place of a grain is not a sum at any place: on the average the grain itself adds
 * V W(0) S too much, with the structure factor S at long waves (to the order of d / h); that of hard spheres at the solid
 * fraction f is S = (1 - f)^4 / (1 + 4 f + 4 f^2 - 4 f^3 + f^4) (Carnahan, Starling, J. Chem. Phys. 51 (1969) 635). A
 * grain alone has porosity 1; in a packing the grain itself counts in full. */
#ifndef SCREE_DRAG_POROSITY_H
#define SCREE_DRAG_POROSITY_H

#include "physics/drag/drag.h"
#include "engine/physics.h"

/* The least support, in radii: below, the equation for s has no single solution. */
#define POROSITY_SUPPORT_LEAST 5.0

/* The largest solid fraction, as the laws know no denser bed. */
#define POROSITY_SOLID_MOST 0.9

struct porosity;

/* Makes the sums of a run; the context is borrowed. */
struct porosity *porosity_create(const struct physics_context *context);
void porosity_destroy(struct porosity **porosity);

/* After each rebuild. One thread. */
void porosity_rebuilt(struct porosity *porosity);

/* Computes the porosity of all owned grains at their present places. Collective; opens its own team. */
void porosity_sum(struct porosity *porosity);

/* The part of the kernel in front of a plane at the distance `distance` >= 0 from its middle, in supports. Any thread. */
double porosity_front(double distance);

/* Volume of a grain. */
double porosity_volume(double radius);

#endif
