/* SPDX-License-Identifier: BSD-3-Clause */
/* Integrators. Both are leapfrog forms of velocity Verlet: the state holds v(n-1/2), one pass kicks by dt
 * f(n)/m and drifts by dt v(n+1/2); they differ in the contact's history only (law_options.synchronised):
 *
 *     synchronised_verlet  (default) the tangential history advances with half-step velocity and half-step
 *                          normal (Vyas et al., Comput. Phys. Commun. 310 (2025) 109524)
 *     velocity_verlet      plain: half-step velocity with full-step normal, as LAMMPS (29 Sep 2021) does
 *
 * Every pass works on a contiguous range of particles, so that it can be fused with others, block by block.
 */
#ifndef SCREE_MOTION_INTEGRATOR_H
#define SCREE_MOTION_INTEGRATOR_H

#include "physics/grains/motion/carried.h"

struct integrator {
    const char *name;
    const char *summary;
    bool synchronised;
};

/* The table of integrators: their number; the k-th integrator; the integrator of a name, or NULL. */
int integrator_count(void);
const struct integrator *integrator_get(int k);
const struct integrator *integrator_find(const char *name);

enum { INTEGRATOR_GROUPS_MAX = 64 };

/* Motion of a group: free, or prescribed (frozen: both zero). */
struct integrator_motion {
    bool prescribed;
    double velocity[3], omega[3];
};

/* Data of a pass besides the particles. */
struct integrator_context {
    double dt; /* of a step; 0: the stored velocities are those of the full step */
    double gravity[3];
    int dimension;
    const struct carried *carried; /* grains that bodies carry; NULL: none */
    int groups;                    /* 1: only "free" */
    struct integrator_motion motion[INTEGRATOR_GROUPS_MAX];
};

/* Gives the owned particles whose motion is prescribed their velocity and spin, as the passes below do.
 * Called before other code reads particles that no pass has moved yet. Opens its own thread team. */
void integrator_prescribe(struct particles *particles, const struct integrator_context *context);

/* Kicks and drifts the owned particles [first, last): v += dt (f/m + g), omega += dt torque/I, x += dt v;
 * sets their force record to zero; sets prescribed motion, and that of carried grains. In 2D z stays. Returns the largest |v|^2 of the
 * range (speed for the skin), NaN if one, or a spin, is not finite. Any thread, disjoint ranges. */
double integrator_advance(struct particles *particles, const struct integrator_context *context, size_t first,
                          size_t last);

/* Turns the initial full-step velocities into v(-1/2), once the forces at the start are known: v -= dt/2 (f/m
 * + g), omega likewise. Leaves carried grains alone. */
void integrator_stagger(struct particles *particles, const struct integrator_context *context, size_t first,
                        size_t last);

/* Full-step velocity and angular velocity of particle i, from the half-step state and the present force.
 * omega may be NULL; without spin omega must be NULL. */
void integrator_full_step(const struct particles *particles, const struct integrator_context *context,
                          size_t i, double velocity[3], double omega[3]);

/* Adds the kinetic energy, and the energy of rotation, of the free grains among the owned particles [first, last)
 * to energy[0] and energy[1]; at the full step. Of bodies: the part that the masses of their members do not
 * account for. Any thread. */
void integrator_energies(const struct particles *particles, const struct integrator_context *context,
                         size_t first, size_t last, double energy[2]);

#endif
