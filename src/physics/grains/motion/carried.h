/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains that rigid bodies carry: their motion is that of their body, whatever the force on them. A physics
 * that makes bodies (src/physics/bodies) keeps the poses; the integrator reads them. */
#ifndef SCREE_MOTION_CARRIED_H
#define SCREE_MOTION_CARRIED_H

#include "kernel/particles/particles.h"
#include "kernel/particles/box.h"

/* Place and motion of a body. */
struct carried_pose {
    double x[3];                 /* centre of mass, box-relative, as its owner has it */
    double v[3], w[3];           /* velocity and angular velocity at the last half step */
    double turn[9];              /* rotation from the body's frame to space, row by row, at x */
    double middle[9];            /* mean of the rotations before and after the last step */
    double full_v[3], full_w[3]; /* at the full step: brought up to date before they are observed */
    /* The part of the body's spin and energy of rotation that the masses of its members do not account for, at
     * the full step; 0 for members that do not overlap. On the owner of the body alone. */
    double rest[3], energy;
};

/* Poses, and who has which. Borrowed arrays, new at each rebuild. */
struct carried {
    const int32_t *pose_of;    /* of each owned particle: number of its pose; -1: it moves by itself */
    const double (*offset)[3]; /* of each owned particle: place in the body's frame, length */
    const int32_t (
        *image)[3]; /* of each owned particle: image of the body whose member it is, in edges of the box */
    const struct carried_pose *pose;
    const struct box *box;
    const double *solid; /* carried_solid */
};

/* Registers `body`. */
void carried_register(struct particles *particles);

/* The id of the body that carries each particle, -1: none; NULL without bodies. Borrowed until the set grows. */
int64_t *carried_by(const struct particles *particles);

/* For bodies of which the members together have another volume than the body: registers the radii of the spheres that have a
 * member's share of it; and finds these radii, NULL if there are no such bodies, 0 of a grain that has its own volume. */
void carried_register_solid(struct particles *particles);
double *carried_solid(const struct particles *particles);

/* The radius of the sphere with the volume that particle i stands for; `solid`: carried_solid. */
static inline double carried_solid_radius(const struct particles *particles, const double *solid, size_t i) {
    return solid && solid[i] > 0.0 ? solid[i] : particles->state[i].radius;
}

/* Moves the carried particle i with its body by one step that ended at the pose; the box will end it, too. Returns the larger of its
 * squared speed and the square of its displacement over dt. `omega` NULL: particles have no spin. */
double carried_move(const struct carried *carried, size_t i, double dt, bool flat,
                    struct particle_state *state, double *omega);

/* Velocity and angular velocity of the carried particle i at the full step; omega may be NULL. */
void carried_full_step(const struct carried *carried, size_t i, double velocity[3], double *omega);

/* The velocity that the image of its body adds to that of the carried particle i; 0 in a box at rest. */
void carried_drift(const struct carried *carried, size_t i, double drift[3]);

/* What the stress of the carried particle i (six sums of products of length and force, or of mass and velocity, as in
 * observables_stress.c) has beside that of one that moves by itself: the force on it acts at the centre of its body, whose
 * velocity counts. `v`: of the particle, at the full step if `full`. */
void carried_stress(const struct carried *carried, const struct particles *particles, size_t i, bool full,
                    const double v[3], double part[6]);

#endif
