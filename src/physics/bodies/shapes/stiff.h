/* SPDX-License-Identifier: BSD-3-Clause */
/* How stiff a contact is against small motions of one of its solids, the other one held fixed: the second slopes of the energy of
 * touch.h. With J_k the slope of d_k in the six motions of a solid, E' and E'' those of the law at the overlap, and
 * q = E' / (d E''), which is 1 for springs and 2/3 for Hertz,
 *
 *     E'' sum over k, l of  J_k J_l^T ((1 - 5 q) s_k s_l + 5 q s_k^(4/5) [k = l])
 *
 * What the normals turn is left out: it is smaller by the overlap over the rounding. So a face on a plane resists a tilt
 * more than one feature resists a push. Dampers along the normals, and springs and dampers across
 * them, have the share s_k of each feature. */
#ifndef SCREE_SHAPES_STIFF_H
#define SCREE_SHAPES_STIFF_H

#include "physics/bodies/shapes/feature.h"

/* A solid of a contact: its arm, and what it weighs against turning. */
struct stiff_side {
    bool second;        /* B of the contact */
    double apart[3];    /* of its centre from that of A */
    const double *turn; /* rotation from its frame to space */
    double gyration[3]; /* principal moments of inertia over mass, length^2 */
};

/* The matrices of the springs along the normals, over E'', of the dampers along them, over that of the law, and of both across
 * them; over 1/mass, row by row, in the frame of the solid: translations, and rotations x sqrt(gyration). */
enum { STIFF_ALONG, STIFF_DAMPED, STIFF_ACROSS, STIFF_KINDS };
struct stiff {
    double matrix[STIFF_KINDS][36];
};

/* Fills all. Any thread. */
void stiff_find(const struct feature *all, int count, const struct stiff_side *side, double q,
                struct stiff *stiff);

/* The largest eigenvalue of the sum of the matrices, each x its weight. Any thread. */
double stiff_largest(const struct stiff *stiff, const double weight[STIFF_KINDS]);

/* How far a push on a solid's corner moves it, over a push on its centre: the largest 1 + (c x n)^2 / gyration over corners c
 * and directions n. Lengths of the core. */
double stiff_corner(const struct solid *core, const double gyration[3]);

/* The largest eigenvalues of the matrices, each alone, of the solid's contacts with planes that it touches with faces and
 * edges. At least stiff_corner. Springs (q = 1). */
void stiff_seat(const struct solid *core, double rounding, const double gyration[3],
                double seat[STIFF_KINDS]);

#endif
