/* SPDX-License-Identifier: BSD-3-Clause */
/* What is rigid in a fluid (rigid_step.h): single grains, and rigid bodies (physics/bodies). A body is the particle of its own; its
 * members, which are grains, find the nodes that it fills, and have no motion of their own. The surface of a clump is that of the union of its spheres, that of a rock
 * its flat faces (edges are sharp, as its mass has it). */
#ifndef SCREE_COUPLING_RIGID_BODIES_H
#define SCREE_COUPLING_RIGID_BODIES_H

#include "engine/physics.h"
#include "kernel/particles/kinds.h"

/* Owned grains and bodies; members of bodies are among them. */
struct kind_span rigid_bodies_span(const struct physics_context *context);

/* True if grain i, owned or a copy, is a member of a body. Any thread. */
bool rigid_bodies_member(const struct particles *particles, size_t i);

/* For member i, owned or a copy: the number of the particle of its body, or its copy. arm, from the centre of the member to a place, becomes that from the
 * centre of mass of the body; the distance of the place from the surface of the body, or of this member of it. Any thread. */
uint32_t rigid_bodies_carrier(const struct physics_context *context, size_t i, double arm[3],
                              double *distance);

/* Mass and moments of inertia of an owned grain or body, and of the fluid in its place; xx, yy, zz, yz, xz, xy about its centre of mass, in space. */
struct rigid_inertia {
    bool body, moves; /* moves: the fluid moves it */
    bool turns;
    double mass, displaced, own[6], fluid[6];
};

/* By shape of a body of two dimensions: area, and second moment about the centre of mass, as drawn. Allocates (memory_free); NULL without bodies. */
double (*rigid_bodies_sections(const struct physics_context *context))[2];

struct rigid_inertia rigid_bodies_inertia(const struct physics_context *context, const double (*section)[2],
                                          size_t i);

/* The force and the torque of contacts on owned grain or body i at the present; that of bodies is what bodies_motion_gather has summed. */
void rigid_bodies_contact(const struct physics_context *context, size_t i, double force[6]);

/* The change of its spin by a torque in a time. */
void rigid_bodies_turn(const struct physics_context *context, size_t i, const double torque[3], double time,
                       double change[3]);

/* Velocity and spin of owned i at the last half step; sets them. */
void rigid_bodies_motion(const struct physics_context *context, size_t i, double motion[6]);
void rigid_bodies_set(const struct physics_context *context, size_t i, const double motion[6]);

/* The given motion of one that the fluid does not move. */
void rigid_bodies_given(const struct physics_context *context, size_t i, double motion[6]);

#endif
