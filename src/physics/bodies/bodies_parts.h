/* SPDX-License-Identifier: BSD-3-Clause */
/* Parts of the physics of bodies: their motion, and their places at the start. */
#ifndef SCREE_PHYSICS_BODIES_BODIES_PARTS_H
#define SCREE_PHYSICS_BODIES_BODIES_PARTS_H

#include "physics/bodies/bodies.h"

/* The motion of bodies: a step, and their velocities at the full step. bodies.h has the scheme. */

/* Moves the bodies by a step: velocities from half a step before to half a step behind the present, then places.
 * Sets the poses, which members take. Collective. */
void bodies_motion_step(struct bodies *bodies, const struct physics_context *context);

/* Velocities at the present, from the forces of the present: of poses, and of the particles of bodies.
 * Collective. */
void bodies_motion_full_step(struct bodies *bodies, const struct physics_context *context);

/* Sums the forces and torques on each own body: those on its members, and those on its own particle, which a solver of contacts
 * gives. Collective. */
void bodies_motion_gather(struct bodies_links *links, const struct physics_context *context);

/* After that: the sums of own body b. Any thread. */
void bodies_motion_force(const struct bodies_links *links, const struct physics_context *context, int32_t b,
                         double force[3], double torque[3]);

/* The same as the change of velocity and of angular momentum of own body b in a time, by these and by gravity. Any thread. */
void bodies_motion_push(const struct bodies_links *links, const struct physics_context *context, int32_t b,
                        double time, double velocity[3], double spin[3]);

/* Makes bodies of grains. */

/* The entry that a grain becomes a body of: what its source names, else the first that material and radius fit, those of clumps first;
 * -1: none. */
int place_entry(const struct bodies_options *options, const struct physics_grain *grain);

/* The least radius above `radius` that bounds the grains of an entry; INFINITY: there is none. */
double place_edge(const struct bodies_options *options, int material, double radius);

/* The shapes of an entry (-1: none): their number, and that of the first one. */
int place_shapes(const struct bodies_options *options, int entry, int *first);

/* Refuses, by name, insertions, and sources that name a shape, which may not become the bodies that they would. Reads the shapes of `bodies` alone. */
bool place_check(const struct bodies *bodies, const struct physics_context *context, struct error *error);

/* Radii of members x this have together the volume of the body; 0: they have it as they are. */
double place_swell(const struct clump *clump);

/* `part` and `join` of struct physics_maker. */
bool place_part(const struct bodies *bodies, uint64_t seed, const struct physics_grain *grain, int number,
                struct physics_part *part);
void place_join(struct bodies *bodies, const struct physics_context *context, size_t i, int64_t first_id);

/* Refuses (user) a grain that would become a rock too large for the box. */
bool place_admit(const struct bodies *bodies, const struct box *box, const struct physics_grain *grain,
                 struct error *error);

/* Turns the grains of this rank that are to be bodies into bodies and their members: `fill` of struct physics. */
bool place_all(struct bodies *bodies, const struct physics_context *context,
               const struct physics_share *share, struct error *error);

#endif
