/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls that move through a fluid whose flow is rigid in grains (rigid_step.h): a paddle, a stirrer, the shell of a mixer. Their solids belong to the field `solid` (solid_field.h) as those
 * of grains do, and have the velocities of their motions as given. They are closed meshes whose normals point out of the solid, and cylinders with particles outside. A wall whose solid fills all space beyond it
 * (a plane, a bore) bounds the fluid, and so does a cylinder that only turns about its axis: their mirrors are more accurate than an edge of two spacings.
 *
 * The force of the fluid on a wall is what the forcing takes from the fluid, and what the fluid in the solid takes to follow, of mass m, first moment s and inertia J about the centre of the wall:
 *
 *   F dt = rho sum g V v - (m_g U + omega x s_g) + d(m U + omega x s),   T dt = rho sum g V r x v - (s_g x U + J_g omega) + s x dU + d(J omega)
 *
 * with ds/dt = omega x s. m, s and J are sums of rho phi V, those with an index of rho g V. */
#ifndef SCREE_COUPLING_RIGID_WALLS_H
#define SCREE_COUPLING_RIGID_WALLS_H

#include "data/formats/restart.h"
#include "engine/physics.h"
#include "physics/fluid/coupling/rigid_grains.h"
#include "physics/fluid/coupling/solid_field.h"
#include "physics/fluid/fluid.h"

struct rigid_wall {
    int64_t body;     /* 1: it moves through the fluid; 0: the other members are not read */
    double motion[6]; /* velocity of its centre (struct wall_pose) and spin, at the end of the step */
    double before[6]; /* those of the step before */
    double load
        [6]; /* force and torque about its centre in the last step, without that of the drive on the fluid in it; of all ranks */
    struct rigid_grains_sums sums, whole; /* of rho g V, and of rho phi V; of this rank */
    double momenta[6];                    /* of v, with the weight rho g V; of this rank */
};

/* All owned. All zero: no walls. */
struct rigid_walls {
    int count, bodies;
    struct rigid_wall *wall; /* [count], by number of the scene */
    bool found;              /* which are bodies is known */
    size_t parts, room;
    struct solid_part *part; /* at the present places; by row, their share is phi */
};

/* True if a fluid takes a wall as a solid that moves through it: in two dimensions meshes at rest, too. Any thread. */
bool rigid_walls_through(const struct physics_context *context, const struct wall_options *wall);

/* True if a wall bounds the lattice of a fluid: it is neither permeable nor a solid that moves through the fluid. Any thread. */
bool rigid_walls_bounds(const struct physics_context *context, const struct wall_options *wall);

/* True if a wall that does so can be one: it has no servo, its normals point out of it, and in two dimensions a section stands for all of it; else a user's error with the key. */
bool rigid_walls_suit(const struct physics_context *context, int wall, struct error *error);

/* Memory for the walls of a scene; they are at rest. rigid_walls_free releases. */
void rigid_walls_create(struct rigid_walls *walls, const struct scene *scene);
void rigid_walls_free(struct rigid_walls *walls);

/* The numbers that a resume needs. */
void rigid_walls_restart(struct rigid_walls *walls, const struct scene *scene, struct restart *list);

/* After the first rebuild: finds the bodies. Of a fluid that this run has filled they are those of rigid_walls_through; in a resume or a later stage they are those of the start, whether they still move or not. Opens
 * its own team. */
void rigid_walls_find(struct rigid_walls *walls, const struct physics_context *context, bool filled);

/* Finds the parts at the present places, of the fluid particles [first, first + rows). Opens its own team. */
void rigid_walls_place(struct rigid_walls *walls, const struct physics_context *context, size_t first,
                       size_t rows);

/* Takes the motions at the end of this step. In the `first` step of a fluid they are those of the step before, too. */
void rigid_walls_move(struct rigid_walls *walls, const struct physics_context *context, bool first);

/* Sets the sums of all bodies to 0; the momenta alone. */
void rigid_walls_clear(struct rigid_walls *walls);
void rigid_walls_clear_momenta(struct rigid_walls *walls);

/* The loads of a step of the length dt, from the sums and the momenta; force[3]: what drives the fluid, force/volume. Collective. */
void rigid_walls_loads(struct rigid_walls *walls, const struct physics_context *context, double dt,
                       const double force[3]);

/* Writes what `scree check` says of them. */
void rigid_walls_print(const struct rigid_walls *walls, const struct scene *scene, FILE *file);

#endif
