/* SPDX-License-Identifier: BSD-3-Clause */
/* The stable time step of the leapfrog scheme, from the contacts' frequencies and dampers, beside Rayleigh's
 * time. Formulas with their sources in docs/physics.md; in short:
 *
 *   A spring k and a damper c on a mass m, with w = sqrt(k/m) and zeta = c/(2 m w), are stable in the
 *   leapfrog scheme whose damper sees the velocity of the last half step up to
 *   dt = 2 (sqrt(1 + zeta^2) - zeta) / w, for any zeta (overdamped: dt -> 2 m/c).
 *
 *   Each particle has a local stiffness L: the largest eigenvalue of the springs that hold it, over its mass
 * and inertia, its partners being fixed. No frequency of an assembly has a square above the largest L_i + L_j
 * of two particles that touch, and the same for dampers (docs/physics.md derives it). Here L is that of an
 * assumed number of contacts with like partners; stability.h finds it for the contacts that there are.
 *
 *   A law that stiffens counts with its tangent stiffness at the overlap that the expected speed reaches, or at
 * the stated one, whichever is larger. */
#ifndef SCREE_MOTION_TIMESTEP_H
#define SCREE_MOTION_TIMESTEP_H

#include "physics/grains/laws/law.h"

/* What sets a particle of a rigid body apart from a sphere of its radius and mass. */
struct timestep_body {
    double ease;   /* its stiffness over mass and inertia, as a sphere, counts x this; at least 1 */
    double curved; /* radius of its surface at contacts over its own */
    double seat
        [3]; /* a contact along its faces: largest eigenvalues over k_n/m, c_n/m, and k_t/m or c_t/m; 0: it has none */
};

/* That of a sphere. */
#define TIMESTEP_SPHERE ((struct timestep_body){1, 1, {0, 0, 0}})

/* How a free wall gives way: zeros of other walls. */
struct timestep_yield {
    double one; /* the largest inverse mass against a push at one place */
    double all; /* inverse mass against pushes that are spread over the wall, over their number */
    double
        area; /* of its surface, both sides of a sheet; in two dimensions a length. 0: one contact at a time */
};

/* One kind of particle present: its material and the range of radii; or a wall (or prescribed particles),
 * which has no radius that counts, and no mass to move unless it is free. */
struct timestep_kind {
    int material;
    bool wall;                     /* true: of the other members only `yield` is read */
    double radius_min, radius_max; /* of free particles of this material, length */
    double mass_min;               /* of the smallest; others scale with radius^3: where densities differ, the
                                      least density x its volume */
    struct timestep_body body;     /* the worst of its particles */
    struct timestep_yield yield;   /* of a wall */
};

struct timestep_input {
    const struct law *law;
    int kinds;
    const struct timestep_kind *kind;
    const struct law_material *material;
    double speed_max;        /* largest impact speed expected, length/time */
    double overlap_relative; /* overlap counted with at least, relative to the smaller radius; 0:
                                default (0.001) */
    int contacts;            /* N, simultaneous contacts counted on a particle with its like; 0: default, 12,
                                or 6 in two dimensions */
    int dimension;           /* 2, or else 3 */
};

struct timestep_limits {
    double stable; /* largest stable step, damping included, also when overdamped; time; infinite without
                      kinds */
    double contact_time;  /* duration of the shortest elastic contact */
    double rayleigh;      /* smallest Rayleigh time over the materials; 0 where the law takes no moduli */
    double frequency;     /* sqrt(k_n/m*) of the one contact that sets the limit, rad/time */
    double damping_ratio; /* zeta of its normal mode, for one contact */
    int material_a, material_b; /* its materials */
};

/* The default step as a fraction of `stable`, used when the scene gives none: 0.15, 20 steps a contact at
 * least. Single impacts by any law, with moderate cohesion, are then off by up to 1 % of their speed (docs/speed-error.md). */
double timestep_default_fraction(void);

/* The stability bound above for stiffness k, damper c and inverse mass. Infinite if all are 0. */
double timestep_bound(double stiffness, double damping, double inverse_mass);

/* The springs and dampers of a contact of materials a and b with effective mass and radius at an overlap, as
 * they act on small changes: normal, tangential, rolling and twisting ones; a spring that the pair lacks is 0. */
struct timestep_springs {
    double k_n, k_t, k_r; /* force/length */
    double c_n, c_t, c_r; /* force time/length */
    double k_w, c_w;      /* against twisting: torque/rad, torque time/rad */
};
struct timestep_springs timestep_springs(const struct law *law, int a, int b, double mass, double radius,
                                         double overlap);

/* The inertia of a solid sphere over m r^2. */
#define TIMESTEP_INERTIA 0.4

/* Finds the limits. One thread. */
void timestep_limits(struct timestep_limits *limits, const struct timestep_input *input);

#endif
