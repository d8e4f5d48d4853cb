/* SPDX-License-Identifier: BSD-3-Clause */
/* Contacts of walls with walls: a free plate on a floor, a sleeper on a rail, a drum on rollers (wall_contacts in a scene).
 *
 * A scene names the pairs of walls that touch; all others go through each other. A contact needs a free wall; its partner may be
 * free, moved or at rest. A wall of a pair is a *block*:
 *
 *   plane                     a half-space
 *   box, closed convex mesh   a convex solid whose faces stay, and whose edges and corners are rounded, as those of rocks are
 *   cylinder                  all that is nearer to its axis than its radius, from outside, also of a tube with grains inside. Its
 *                             ends are flat: the features of the axis end at the rim, so that a cylinder lies, rolls and is
 *                             carried; on an end it rests on the middle alone
 *
 * The contact of a pair is that of two rocks (physics/bodies/shapes/touch.h): features, one overlap, and at most eight points, each of
 * which goes through the law of the scene as a contact of two spheres of the radii of the roundings, with the mass that both walls
 * have against a push there. The force acts on both walls, as that of grains does (walls_push), and so on what moves, shows and
 * resumes walls. Two walls touch through their nearest periodic images alone.
 *
 * Every rank has all walls and finds all contacts alike; rank 0 gives their forces. */
#ifndef SCREE_BLOCKS_BLOCKS_H
#define SCREE_BLOCKS_BLOCKS_H

enum { BLOCKS_PAIRS_MAX = 64 };

struct blocks_pair_options {
    int walls, wall[2]; /* numbers in the scene; walls: numbers given */
};

struct blocks_options { /* the section `wall_contacts` of a scene */
    double rounding;    /* of boxes and meshes, length; NAN: not given */
    int pairs;
    struct blocks_pair_options pair[BLOCKS_PAIRS_MAX];
};

#endif
