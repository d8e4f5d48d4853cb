/* SPDX-License-Identifier: BSD-3-Clause */
/* Rigid bodies: of spheres (clumps), or convex with flat faces (rocks; rocks.h has their contacts). Grains of a source become bodies: a grain stands for the ball around its body,
 * so that all sources of a scene place bodies, without overlap and with any law of sizes.
 *
 * A body is a particle of the kind `body` (kernel/particles/kinds.h) at its centre of mass, with the radius of the ball
 * around its members; its members are grains like others, which touch by the contact law of the scene. The body's
 * particle meets nobody, has no mass of its own, and has the state of the motion: orientation q, velocity V and
 * angular momentum L (in space) of the last half step. So a body migrates, is written and is resumed as any
 * particle; and as copies of a particle reach every rank that its ball touches (kernel/comm/ghosts.h), each rank that owns
 * members has the body or a copy of it, however large the body is.
 *
 * A step, before all other motion (bodies_motion.c):
 *
 *     1. each rank adds the forces on its members, and their torques about the centre of mass, to its copy of the
 *        body; the sums of copies go back to the owner (kernel/comm/ghosts.h): one message a neighbour, 6 numbers a copy
 *     2. the owner moves the body: V += dt (F/M + g), L += dt torque, x += dt V, q by a free rotation with L
 *        (rotor.h): a scheme of second order that conserves L exactly without torque
 *     3. the new poses go to the copies: one message a neighbour, 13 numbers a copy
 *     4. members then take their places and velocities from the pose, where other grains are kicked and drift
 *        (physics/grains/motion/carried.h)
 *
 * Bodies that lie inside one subdomain send nothing. In reproducible runs the sums are of whole numbers (sums.h),
 * so that their order does not matter.
 *
 * A member has its share of the body's mass (clump.h), as a sphere of its own: contacts take their damping and the
 * stable time step from it. The shares have the body's mass and centre of mass, so sums over grains are those over
 * bodies: momentum, kinetic energy, energy in gravity. Where members overlap, the body adds the rest of the energy
 * of rotation and of the angular momentum. */
#ifndef SCREE_BODIES_BODIES_H
#define SCREE_BODIES_BODIES_H

#include "physics/bodies/rock.h"
#include "engine/physics.h"
#include "physics/grains/motion/carried.h"

/* The section `bodies` of a scene. */
struct bodies_options {
    int clumps;
    struct clump_options clump[CLUMPS_MAX];
    int rocks;
    struct rock_options rock[ROCKS_MAX];
};

struct bodies_links;
struct rocks;

/* The shapes of an entry. */
static inline int bodies_variants(const struct rock_options *options) {
    return options->random ? options->draw.variants : 1;
}

/* The entries, those of clumps first. */
static inline int bodies_entries(const struct bodies_options *options) {
    return options->clumps + options->rocks;
}

static inline const struct clump_entry *bodies_entry(const struct bodies_options *options, int k) {
    return k < options->clumps ? &options->clump[k].entry : &options->rock[k - options->clumps].entry;
}

/* The data of a run. */
struct bodies {
    const struct bodies_options *options;
    int shapes;
    struct clump
        *clump; /* shapes by number, those of clumps first; a rock entry has `variants` of them. Owned */
    const struct clump_entry **entry; /* of each shape; borrowed from the options */
    double before;                    /* length of the step that led here; 0: none yet */
    struct bodies_links *links;       /* bodies_links.h; NULL before the first rebuild */
    struct carried carried;
    struct rocks *rocks; /* the contacts of rocks; NULL: there are none */
};

/* The bodies of a run; NULL if it has none. */
struct bodies *bodies_of(const struct physics_set *set);

#endif
