/* SPDX-License-Identifier: BSD-3-Clause */
/* The contact of two rounded solids.
 *
 * The features of a contact are the corners of either solid above the other one, and pairs of edges, as far as they are nearer
 * than both roundings together. Feature k overlaps by d_k: the sum of the roundings less its distance from the other core, or of two edges
 * the distance of the edges. The contact has one overlap, a norm of theirs:
 *
 *     d = (sum d_k^6)^(1/6)
 *
 * With the energy E(d) of a law of spheres the forces are its slopes: feature k pushes along its own normal by
 *
 *     s_k E'(d),   s_k = d d / d d_k = (d_k / d)^5
 *
 * A contact with one feature, as that of most impacts, is that of two spheres of the radii of the roundings. n features that overlap
 * alike are n^(1/3) times as stiff as one by a linear law: four corners on a plane 1.6 times. Each d_k is a smooth
 * function of the places of both solids, and comes and goes at 0: so no impact makes or loses energy, whatever tilts
 * or slides, no feature pulls, and nothing jumps where faces meet. Two edges that are parallel have no nearest points: the d_k
 * of edges has a factor, which falls from 1 to 0 where their angle falls below TOUCH_PARALLEL, with its slope as a torque; the corners
 * at their ends stay.
 *
 * Friction and dampers act at up to eight points: features whose places are nearer than half of the smaller rounding are one point, with
 * their shares s_k together.
 *
 * Cores that overlap have one feature, the least translation that parts them (deep.h).
 *
 * A sphere is a solid with one corner, whose rounding is its radius. */
#ifndef SCREE_SHAPES_TOUCH_H
#define SCREE_SHAPES_TOUCH_H

#include "physics/bodies/shapes/feature.h"
#include "physics/bodies/shapes/gjk.h"

/* Finds the features of the contact of A with B, whose centre lies at `apart` from that of A, and the normal of the nearest
 * points, a unit vector from A to B; feature_sum (feature.h) adds them up. `simplex`: see gjk.h. False: they do not touch. Any
 * thread. */
bool touch_find(const struct posed *a, const struct posed *b, const double apart[3],
                struct gjk_simplex *simplex, struct features *features, double normal[3]);

/* The same with the features up to a gap of features->reach, which the caller sets: false if there are none. */
bool touch_near(const struct posed *a, const struct posed *b, const double apart[3],
                struct gjk_simplex *simplex, struct features *features, double normal[3]);

/* touch_find of A with a half-space, whose inward normal is a unit vector and whose plane passes at `height` below the
 * centre of A; the features are the corners of A. Any thread. */
bool touch_plane(const struct posed *a, const double inward[3], double height, struct features *features);

#endif
