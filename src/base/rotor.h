/* SPDX-License-Identifier: BSD-3-Clause */
/* Rotation of rigid bodies: unit quaternions q = (w, x, y, z) that turn the body's frame, whose axes are the
 * principal axes, to space. Any thread. */
#ifndef SCREE_BASE_ROTOR_H
#define SCREE_BASE_ROTOR_H

/* The rotation matrix of q, row by row: turns a vector of the body's frame to space. */
void rotor_matrix(const double q[4], double turn[9]);

/* `to` = turn v, and the transpose of turn times v. */
void rotor_turn(const double turn[9], const double v[3], double to[3]);
void rotor_turn_back(const double turn[9], const double v[3], double to[3]);

/* The product a b of quaternions. */
void rotor_product(const double a[4], const double b[4], double to[4]);

/* Angular velocity in space of a body with the angular momentum `spin` (space) and principal moments of inertia. */
void rotor_velocity(const double turn[9], const double spin[3], const double inertia[3], double w[3]);

/* Free rotation of a body with the angular momentum `spin` (space) for a time h; moments of inertia from small to
 * large. The energy of rotation is split into that of a spherical top with the middle moment, which turns about
 * `spin`, and two turns about axes of the body:
 *
 *     exp(h/2 A_1) exp(h A_3) exp(h/2 A_1) exp(h S),   A_k: angle h L_k (1/I_k - 1/I_2) about axis k
 *
 * (Touma and Wisdom, Astron. J. 107 (1994) 1189; Dullweber, Leimkuhler and McLachlan, J. Chem. Phys. 107 (1997)
 * 5840; NO_SQUISH of Miller et al., J. Chem. Phys. 116 (2002) 8649 splits into turns about the axes alone). The
 * scheme is symplectic and reversible, of second order; exact where two moments are equal. The angular momentum in
 * space is not touched, and every factor is a rotation: the norm of q stays 1. */
void rotor_advance(double q[4], const double spin[3], const double inertia[3], double h);

/* Rotation with a constant angular velocity w (space) for a time h. */
void rotor_spin(double q[4], const double w[3], double h);

#endif
