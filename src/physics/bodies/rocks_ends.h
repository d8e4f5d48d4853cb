/* SPDX-License-Identifier: BSD-3-Clause */
/* The two ends of a contact of rocks as they stand, and its features: what forces and stability both ask for. */
#ifndef SCREE_BODIES_ROCKS_ENDS_H
#define SCREE_BODIES_ROCKS_ENDS_H

#include "physics/bodies/rocks_state.h"
#include "physics/bodies/shapes/feature.h"
#include "physics/grains/laws/law_kernel.h"
#include "physics/grains/walls/wall.h"

/* What all contacts of an evaluation share. */
struct rocks_scene {
    const struct physics_context *context;
    const struct rocks *rocks;
    const struct particles *particles;
    const struct pairlist *list;
    const struct walls *walls;
    const struct law *law;
    struct law_case law_case;
    struct law_step step;
    const double (*omega)[4];
    const uint8_t *material;
    double reach; /* largest gap of features that count; 0: of those that touch */
};

/* Both ends of a contact. */
struct rocks_ends {
    struct posed posed[2];
    double apart[3], centre[3]; /* centre: of the first end; of a wall in its image */
    double mass, radius;        /* effective */
    double ball;                /* the smaller radius of both balls */
    double inner;               /* the smaller radius of both inside: of a sphere its own (clump.h) */
    const struct law_coefficients *coefficients;
    const struct law_extra *extra;
    double turn[9]; /* of the first end */
};

/* Fills what contacts share, without a reach, and brings all rocks to their orientations. Opens its own team. */
void rocks_scene_make(struct rocks *rocks, const struct physics_context *context, struct rocks_scene *scene);

/* Fills both ends; false: they are out of reach, another physics stands for their contact, or nothing moves them. Any thread. */
bool rocks_ends_make(const struct rocks_scene *scene, const struct rocks_pair *pair, struct rocks_ends *ends);

/* Finds the features of a pair's contacts, group by group; returns their number. Any thread, once a pair, with a probe of the
 * thread's own. */
int rocks_features(const struct rocks_scene *scene, struct rocks_pair *pair, const struct rocks_ends *ends,
                   struct walls_probe *probe, struct features *features);

/* The features of a group, from `from` on, which is not the end: their number. */
int rocks_group(const struct features *features, int from);

/* Those of the first end with a wall: each corner as a sphere, the edges of the rock with those of the wall, and vertices of the
 * wall with the rock. Each feature is a group, but those with a plane or an endless cylinder, which are one: where a corner goes from
 * one feature of a wall to the next, no other one may change with it. */
void rocks_wall_features(const struct rocks_scene *scene, const struct rocks_pair *pair,
                         const struct rocks_ends *ends, struct walls_probe *probe, struct features *features);

/* The normal springs of the law at an overlap. Any thread. */
struct law_springs rocks_springs(const struct rocks_scene *scene, const struct rocks_ends *ends,
                                 double overlap);

#endif
