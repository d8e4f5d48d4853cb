/* SPDX-License-Identifier: BSD-3-Clause */
/* The motion of a grain that is one with the fluid in it: closed forms. With the sums over the nodes of the grain, weighed by its share g of
 * the gain, m = rho sum g V, s = rho sum g V r, J = rho sum g V (r^2 1 - r r^T), velocity U and spin omega solve
 *
 *   (m + M_e) U + omega x s = rho sum g V v + M_e U_n + (M - rho V) g dt + I
 *   s x U + (J + J_e) omega = rho sum g V r x v + J_e omega_n + T
 *
 * with impulse I and torque T of its contacts. M_e, J_e are what the grain has more than the fluid in it: M - rho V where that is heavier, else, and where the grain is smaller to the fluid (`hydraulic`), M less the mean of m over
 * all lattices, so that the whole inertia stays M.
 *
 * Where these are negative, half of them acts with the acceleration of the step before. For a fluid that a step of viscosity leaves the part a of the momentum m U, with b = -M_e / m, and the part c of m late,
 * a step is (1 - b + c) U_n+1 = (a - b + 2 c) U_n - c U_n-1. That decays for any a in 0 ... 1 and b < 1 if c > (2 b - 1 - a) / 4, so with c = b / 2; with c = 0 it swings up if b > (1 + a) / 2, and a is near 0 in long steps. */
#ifndef SCREE_COUPLING_RIGID_GRAINS_H
#define SCREE_COUPLING_RIGID_GRAINS_H

#include <stdbool.h>

/* m, s, and xx, yy, zz, yz, xz, xy of J. */
struct rigid_grains_sums {
    double mass, first[3], second[6];
};

/* Adds a node of the mass rho g V. */
void rigid_grains_add(struct rigid_grains_sums *sums, double mass, const double arm[3]);

/* What goes with a grain. */
struct rigid_grains_own {
    double mass, inertia[6];           /* M_e, J_e as `second` above; half of them where they are negative */
    double late_mass, late_inertia[6]; /* the other half, with the accelerations of the step before; else 0 */
    int dimension;
    bool turns; /* else omega is 0 */
};

/* motion = U, omega of the right-hand side `momentum`: six numbers each. */
void rigid_grains_solve(const struct rigid_grains_sums *sums, const struct rigid_grains_own *own,
                        const double momentum[6], double motion[6]);

/* spin = J omega, J as `second`. */
void rigid_grains_spin(const double inertia[6], const double omega[3], double spin[3]);

/* m U + omega x s, s x U + J omega of a motion. */
void rigid_grains_momentum(const struct rigid_grains_sums *sums, const double motion[6], double momentum[6]);

/* velocity = U + omega x arm. */
static inline void rigid_grains_velocity(const double motion[6], const double arm[3], double velocity[3]) {
    const double *w = motion + 3;
    velocity[0] = motion[0] + w[1] * arm[2] - w[2] * arm[1];
    velocity[1] = motion[1] + w[2] * arm[0] - w[0] * arm[2];
    velocity[2] = motion[2] + w[0] * arm[1] - w[1] * arm[0];
}

#endif
