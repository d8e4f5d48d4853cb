/* SPDX-License-Identifier: BSD-3-Clause */
/* The contacts of rocks (rock.h).
 *
 * A rock is a body with one member: the ball around it, a grain that index, ranks, walls and sources see as any other, with
 * all of the mass. The contact law leaves pairs with such a ball, and its contacts with walls, to this physics. Each step looks
 * at these pairs for contacts of the rocks inside (physics/bodies/shapes/touch.h), takes each point of a contact through the law of
 * the scene as a contact of two spheres with the radii of the roundings, and gives force and torque to the balls; a
 * body then moves by the force on its member (bodies.h). A grain that is no rock is a rock of one corner.
 *
 *   overlap     that of the contact; the elastic force goes along the slopes of its energy, friction, dampers and energies of
 *               a point are its share
 *   normal      of each point
 *   R*          r_a r_b / (r_a + r_b) of the roundings; of a wall the rounding
 *   mass        of both bodies as they are, without their rotation
 *   velocity    that of the two surfaces at the point, of the last half step
 *   springs     of each point, found again by its features, else by its place on the rock with the lower id
 *
 * Members know their shape and orientation, which their copies on other ranks get in each step. A rank has the contacts of the pairs
 * in its list: with newton on it sends the force on a copy back, with newton off both ranks compute it. */
#ifndef SCREE_BODIES_ROCKS_H
#define SCREE_BODIES_ROCKS_H

#include "physics/bodies/bodies.h"

/* Refuses, by name, what rocks do not go with. Right where the scene has none. */
bool rocks_check(const struct physics_context *context, struct error *error);

/* Makes the contacts, and registers the fields of members. rocks_free releases. */
struct rocks *rocks_create(const struct physics_context *context);
void rocks_free(struct rocks **rocks);

/* Sets what member m knows: the number of its shape, -1 of a sphere, and the orientation of its body. */
void rocks_member(const struct particles *particles, size_t m, int shape, const double orientation[4]);

/* The number of the shape of a rock, if a particle, owned or a copy, is the ball around one; else -1. */
int rocks_shape(const struct particles *particles, size_t i);

/* The radius of the largest sphere about the centre of a particle in what it stands for: its own, but of the ball around a rock. `bodies`
 * may be NULL. */
double rocks_inner(const struct bodies *bodies, const struct particles *particles, size_t i);

/* Their part in the stability of the present contacts (physics/grains/motion/stability.h): each end of a contact counts with the
 * largest eigenvalue of the contact (physics/bodies/shapes/stiff.h), whatever its direction; and the largest L_i + L_j. */
struct stability;
void rocks_stiffen(struct bodies *bodies, const struct physics_context *context, struct stability *stability);
double rocks_stiffest(const struct bodies *bodies, const struct physics_context *context,
                      const struct stability *stability);

/* After a step of bodies: members take the orientations of their bodies. */
void rocks_turn(const struct bodies *bodies, const struct particles *particles);

/* Takes the pairs and walls of a new list, with what contacts remember. */
void rocks_rebuilt(struct bodies *bodies, const struct physics_context *context);

/* Adds the forces of all contacts; their sums, once those of other contacts are known. */
void rocks_act(struct bodies *bodies, const struct physics_context *context);
void rocks_sum(struct bodies *bodies, const struct physics_context *context);

/* What contacts remember, by owned particle: a row a point. */
enum { ROCKS_COMPONENTS = 10 };
struct history_rows *rocks_rows(struct bodies *bodies, const struct physics_context *context);

#endif
