/* SPDX-License-Identifier: BSD-3-Clause */
/* Blocks and their contacts, for the files of this folder. Read blocks.h first. */
#ifndef SCREE_BLOCKS_BLOCKS_STATE_H
#define SCREE_BLOCKS_BLOCKS_STATE_H

#include "engine/physics.h"
#include "physics/blocks/blocks.h"
#include "physics/bodies/shapes/recall.h"
#include "physics/bodies/shapes/touch.h"
#include "physics/grains/walls/wall.h"

enum block_kind { BLOCK_NONE, BLOCK_PLANE, BLOCK_SOLID, BLOCK_ROUND };

/* A wall as a block. Places and lengths are those of the wall's own image. */
struct block {
    enum block_kind kind;
    struct solid
        core; /* about the centre, in the frame of the wall at rest; of a cylinder its axis, an edge; none of a plane */
    double centre[3];    /* in that frame */
    double rounding;     /* length */
    double merge;        /* features that are nearer to each other are one point */
    double extent;       /* distance of the surface from the centre, at most */
    double turn[9];      /* now */
    double place[3];     /* of the centre, now */
    double (*corner)[3]; /* now, about the centre */
};

/* A pair of walls; a plane is the second one. */
struct blocks_pair {
    int wall[2];
    double points;
    struct touch_memory point[TOUCH_POINTS_MAX];
    /* Of the last evaluation: the overlap, the energies stored, and the work taken. */
    double overlap, normal, tangential, taken;
};

struct blocks {
    const struct blocks_options *options;
    int walls, pairs;
    struct block *block; /* of each wall of the scene */
    struct blocks_pair pair[BLOCKS_PAIRS_MAX];
    bool warned; /* of an overlap */
};

/* Makes the blocks of all pairs from the walls as they stand. False, with a user's error, where a wall cannot be one.
 * blocks_free releases, also then. */
bool blocks_make(struct blocks *blocks, const struct physics_context *context, struct error *error);
void blocks_free(struct blocks *blocks);

/* Brings all blocks to the poses of their walls. */
void blocks_stand(struct blocks *blocks, const struct physics_context *context);

/* Finds the features of a pair, at most FEATURES_MAX, and the vector from the first centre to the second one, 0 to a plane. Returns
 * the number of features. */
int blocks_features(const struct blocks *blocks, const struct physics_context *context,
                    const struct blocks_pair *pair, double apart[3], struct features *features);

/* The effective radius R* of a pair, and the length over which an overlap counts for guards. */
double blocks_radius(const struct blocks *blocks, const struct blocks_pair *pair);
double blocks_size(const struct blocks *blocks, const struct blocks_pair *pair);

/* The forces of all contacts of an evaluation. */
void blocks_act(struct blocks *blocks, const struct physics_context *context);

/* Their part in the stability of the present contacts (physics/grains/motion/stability.h): each pair counts as if it touched, so that
 * contacts to come are among them; and the largest L_i + L_j of a pair. */
struct stability;
void blocks_stiffen(const struct blocks *blocks, const struct physics_context *context,
                    struct stability *stability);
double blocks_stiffest(const struct blocks *blocks, const struct stability *stability);

#endif
