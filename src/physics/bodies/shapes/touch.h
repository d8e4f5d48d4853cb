/* SPDX-License-Identifier: BSD-3-Clause */
/* The contact of two rounded solids.
 *
 * The features of a contact are the corners of either solid above the other one, and pairs of edges, as far as they are nearer
 * than both roundings together. Feature k overlaps by d_k: the sum of the roundings less its distance from the other core, or of two edges
 * the distance of the edges. The contact has one overlap,
 *
 *     d = sum d_k^3 / sum d_k^2
 *
 * which is d_k where all are equal, and that of the deepest feature where the others are small. With the energy E(d) of a law of spheres the
 * forces are its slopes: feature k pushes along its own normal n_k by
 *
 *     g_k E'(d),   g_k = d d / d d_k = s_k (3 - 2 d / d_k),   s_k = d_k^2 / sum d^2
 *
 * Each d_k is a smooth function of the places of both solids, and comes and goes at 0. So no impact makes or loses
 * energy, whatever tilts or slides; nothing jumps where faces meet; and a contact of faces is as stiff as one of corners,
 * at which two spheres of the radii of the roundings touch. A feature far above the deepest one pulls a little (g_k < 0), as the deepest one
 * then has more than all. Two edges that are parallel have no nearest points: the d_k of edges has a factor, which falls from 1 to 0 where their
 * angle falls below TOUCH_PARALLEL, with its slope as a torque; the corners at their ends stay.
 *
 * Friction and dampers act at up to eight points: features whose places are nearer than half of the smaller rounding are one point, with
 * their shares s_k together.
 *
 * Cores that overlap have one feature, the least translation that parts them (deep.h).
 *
 * A sphere is a solid with one corner, whose rounding is its radius. */
#ifndef SCREE_SHAPES_TOUCH_H
#define SCREE_SHAPES_TOUCH_H

#include "physics/bodies/shapes/gjk.h"
#include "physics/bodies/shapes/posed.h"
#include "physics/bodies/shapes/touch_point.h"

/* Finds the contact of A with B, whose centre lies at `apart` from that of A. `simplex`: see gjk.h. False: they do not
 * touch. Any thread. */
bool touch_find(const struct posed *a, const struct posed *b, const double apart[3],
                struct gjk_simplex *simplex, struct touch *touch);

/* The contact of A with a half-space, whose inward normal is a unit vector and whose plane passes at `height` below the
 * centre of A; the features are the corners of A. False: they do not touch. Any thread. */
bool touch_plane(const struct posed *a, const double inward[3], double height, struct touch *touch);

#endif
