/* SPDX-License-Identifier: BSD-3-Clause */
/* What a particle beside a body stands for, where nothing goes through the body and neighbours behind it drop out.
 *
 * Fluid particles lie at any distance from a surface, so that their number times their volume is the room before it up to half a spacing alone:
 * a staircase. With a weight t(d) of the distance d, in spacings, the sum over particles is that of the room itself, for each place of a plane
 * wall on the lattice, if t = 0 behind the wall and
 *
 *   t(d) = a S(d - p) + (1 - a) S(d - q),   p = (1 + w) / 2,   a = q / (q - p)
 *
 * S the step from 0 to 1, averaged over a length of 1 (so that a sum over the planes of a lattice is an integral) and once more over one of w =
 * LAYER_BLUR (so that it nearly is on planes at an angle, too); a makes up for the shift of both steps into the fluid. t rises from 0 at the wall to 1.7
 * at one spacing and is 1 from LAYER_REACH on. In a gap of width g both walls count, t(d) + t(g - d) - 1, and w and q are as small as they
 * must be for this to be 0 at both; in gaps of less than one spacing t = 1. */
#ifndef SCREE_CARRIED_LAYER_H
#define SCREE_CARRIED_LAYER_H

#define LAYER_BLUR 0.5
#define LAYER_SHIFT 1.2                                    /* q */
#define LAYER_REACH (LAYER_SHIFT + 0.5 + 0.5 * LAYER_BLUR) /* in spacings; supports are longer */

/* t of a particle at a distance >= 0 from a surface, in a gap of this width between it and another one, INFINITY without
 * one; both in spacings. At least LAYER_LEAST. Any thread. */
#define LAYER_LEAST 0.05
double layer_part(double distance, double gap);

#endif
