/* SPDX-License-Identifier: BSD-3-Clause */
/* A cloud on all ranks with the copies that its scene demands, and the rule for copies in its plain form. */
#ifndef SCREE_TESTS_MPI_FIXTURE_H
#define SCREE_TESTS_MPI_FIXTURE_H

#include "cloud.h"
#include "kernel/comm/ghosts.h"
#include "team.h"

enum { FIXTURE_STAMP = 3 }; /* the stamp of the values that fields have at first */

struct scene {
    struct box box;
    enum cloud_radii radii;
    bool newton, reduced;
    bool slabs; /* a grid of ranks along x alone */
};

/* The scenes; some are named here for tests that need their properties. From SCENE_UNWANTED on some
 * class pairs are not wanted, and the last class meets no class. Scene BRICKS + k is scene k with the box
 * divided by an uneven bisection. */
enum {
    SCENE_EQUAL = 0,
    SCENE_BIDISPERSE = 1,
    SCENE_BOULDERS = 6,
    SCENE_BOULDERS_SLABS = 7,
    SCENE_UNWANTED = 19,
    BRICKS = 23
};
enum { SCENES = 2 * BRICKS };
extern const struct scene fixture_scenes[BRICKS];

struct fixture {
    struct team *team;
    const struct scene *scene;
    struct cloud cloud;
    struct domain *domain;
    struct ghosts *ghosts;
    struct particles *particles;
};

/* Makes the cloud of `n` particles, dealt out to the ranks in turn (not yet to their owners). */
void fixture_make(struct fixture *fixture, struct team *team, int scene, size_t n);
void fixture_free(struct fixture *fixture);

/* Moves all particles to their places in the cloud: drops copies, migrates, makes copies. Collective. */
void fixture_rebuild(struct fixture *fixture);

/* True if direction d is wrapped by the index. */
bool fixture_wraps(const struct fixture *fixture, int d);

/* The rule: does a rank need a copy of particle k under an image? */
bool fixture_needs(const struct fixture *fixture, int rank, size_t k, const int image[3]);

/* Goes through all images that copies may have: turns 0 ... 26, those that exist here. */
bool fixture_image(const struct fixture *fixture, int turn, int image[3]);

#endif
