/* SPDX-License-Identifier: BSD-3-Clause */
/* The particle set of one rank: owned particles first (0 ... owned-1), then ghosts (owned ...
 * owned+ghosts-1).
 *
 * The hot state is one record of a cache line a particle, because the force loop gathers it; everything else
 * lies in arrays of its own, and exists only if it is registered (fields.h). The table of fields drives
 * allocation, growth, reorder, packing for MPI, HDF5 and the docs.
 *
 * Velocity is that of the last half step, v(n-1/2): it led to the present positions. Full-step values are
 * made for output from v + dt/2 f/m (physics/grains/motion/integrator.h). Forces are those at the present positions. */
#ifndef SCREE_PARTICLES_PARTICLES_H
#define SCREE_PARTICLES_PARTICLES_H

#include "kernel/particles/box.h"
#include "kernel/particles/classes.h"
#include <stddef.h>
#include <stdint.h>

/* The hot record. */
struct particle_state {
    double x[3];         /* centre, box-relative, length unit */
    double radius;       /* length unit */
    double v[3];         /* velocity at the last half step, length/time */
    double inverse_mass; /* 1/mass; 0 for particles whose motion is prescribed (frozen or moving groups) */
} __attribute__((aligned(64)));

/* Local number of a particle. Pair lists give 27 bits to it (pairlist.h). */
enum { PARTICLE_INDEX_BITS = 27 };

struct particles {
    size_t owned, ghosts; /* particles of this rank, copies of others */
    size_t capacity;      /* records allocated */
    uint64_t revision;    /* bumped whenever particles are added, removed or renumbered */
    bool force_clear; /* every force is zero (between a drift and the next force evaluation): reorder need not
                         move them */
    /* The fields that each set has, for the passes that use these all the time; others: fields.h */
    struct particle_state *state;
    double *force;       /* force_stride doubles a particle: fx fy fz 0, then the fields registered with it */
    int force_stride;    /* 4, or more */
    int64_t *id;         /* unique over all ranks, >= 1 */
    uint8_t *size_class; /* see classes.h */
    struct storage *storage; /* the table of fields and their arrays (fields.h) */
};

struct storage;

/* Makes an empty set with room for `capacity` particles and the first fields (fields.h). Destroy frees it and
 * nulls the pointer. One thread. */
struct particles *particles_create(size_t capacity);
void particles_destroy(struct particles **particles);

/* Makes room for `capacity` records at least, keeping the contents. Pointers into the arrays become
 * invalid. */
void particles_reserve(struct particles *particles, size_t capacity);

/* Appends one owned particle, its fields at their fill (0 for most), and returns its number; only while
 * ghosts == 0. The caller fills its fields. */
size_t particles_append(struct particles *particles);

/* Removes the owned particles whose entry in `remove[owned]` is non-zero, keeping the order of the rest; only
 * while ghosts == 0. Returns the number of removed particles. */
size_t particles_remove(struct particles *particles, const uint8_t *remove);

/* Finds the new places of the owned particles if those with a non-zero entry in `leaves[owned]` leave and the
 * last particles take their places, in order, so that the other particles do not move. place[owned] is the
 * caller's; a particle that leaves has the place PARTICLE_LEFT. Returns the number of particles that stay. */
size_t particles_places(const uint8_t *leaves, size_t owned, uint32_t *place);
#define PARTICLE_LEFT UINT32_MAX

/* Moves the owned particles to place[owned] of particles_places, which returned `stay`; the particles that
 * leave are lost. For few particles that leave many. Only while ghosts == 0. */
void particles_vacate(struct particles *particles, const uint32_t *place, size_t stay);

/* Reorders the owned particles: the new particle k is the old order[k]. `order` has `owned` entries, a
 * permutation. Only while ghosts == 0. Every field of the field table follows (forces included). Opens its
 * own thread team. */
void particles_reorder(struct particles *particles, const uint32_t *order);

/* Copies each array to fresh memory by all threads, each its part: the system puts a page near the thread that writes to
 * the page first, and one thread alone makes the particles. Gives kept memory back to the system. Only while
 * ghosts == 0; opens its own thread team. */
void particles_spread(struct particles *particles);

/* Sets size_class of the owned particles from their radii and kinds. Opens its own thread team. */
void particles_classify(struct particles *particles, const struct size_classes *classes);

/* The same for particle number `first` and all behind. */
void particles_classify_from(struct particles *particles, const struct size_classes *classes, size_t first);

/* Registers the field `image`, int32 x 3: how often a particle crossed the box; unwrapped position = x +
 * image * edge (box_unwrap). For boxes with a periodic direction. particles_images gives the values, NULL
 * without. */
void particles_count_images(struct particles *particles);
int32_t (*particles_images(const struct particles *particles))[3];

/* Wraps owned particles into the box in the periodic directions (and counts crossings where images are kept).
 * In a box that moves, a particle takes the velocity of its image over.
 * False if there are positions that are no numbers, or coordinates whose crossings 32 bits do not count;
 * these are left as they are. Opens its own thread team. */
bool particles_wrap(struct particles *particles, const struct box *box);

/* Mass of a sphere of a density, mass over volume. */
double particles_sphere_mass(double radius, double density);

/* Mass over volume of a sphere of a density as the scene gives it (enum box_density): of a disc of the density s
 * pi r^2 s / (4/3 pi r^3). */
double particles_density(const struct box *box, double radius, double density);

/* Bytes that one particle takes in all allocated fields. */
size_t particles_bytes_each(const struct particles *particles);

/* True if there is room for all particles, and each has a finite position and velocity, a radius above 0, no
 * negative mass and a positive id; whether ids are unique is not looked at. Else `why` gets one line. Tests
 * call it. */
bool particles_valid(const struct particles *particles, char *why, size_t why_size);

#endif
