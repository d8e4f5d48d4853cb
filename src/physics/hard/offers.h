/* SPDX-License-Identifier: BSD-3-Clause */
/* Rocks (physics/bodies/rocks.h) in the contact problem of a step: a pair with a rock offers several points, each of which is a row of
 * its own, and so do a rock and a wall.
 *
 * A point remembers the forces of the last step by its pair, and in the pair by its feature; where a feature gives way to another
 * one, by the nearest place on the particle with the lower id. Over rebuilds and in checkpoints these are rows beside those of spheres (pairs.h),
 * which end with place and feature. */
#ifndef SCREE_HARD_OFFERS_H
#define SCREE_HARD_OFFERS_H

#include "physics/grains/walls/wall.h"
#include "physics/hard/pairs.h"

struct physics_context;
struct rocks;

/* Two surfaces where they are nearest: of spheres, or a point of a rock. */
struct hard_touch {
    double normal[3], gap;
    double lever[2]; /* along the normal, from the centres of the particles to the contact; of a rock 0 */
    const double (*arm)
        [3]; /* of a rock: the same as vectors; of a wall that of the particle alone. NULL: along the normal */
    double radius[2]; /* of the surfaces; INFINITY: a wall's */
    double
        size; /* the smaller one of both: radius of a sphere, or of the largest one about the centre of a rock in it */
};

/* A point that a pair offers in the step. */
struct hard_offer {
    struct hard_touch touch; /* without `arm`, which are those below */
    double arm[2][3], place[3];
    uint32_t key; /* of the feature */
    struct hard_memory memory;
    struct hard_couple couple;
};

/* The same of a rock and a wall; place.feature is that of the point. */
struct hard_wall_offer {
    struct wall_place place;
    struct hard_offer offer;
};

/* What a point remembers of the last step. */
struct hard_past {
    uint32_t pair, key; /* number in struct hard_pairs, and the feature */
    double place[3];
    struct hard_memory memory;
    struct hard_couple couple;
};

struct hard_rocks {
    const struct physics_context *context; /* borrowed */
    struct rocks *rocks;                   /* borrowed; NULL: the scene has none */
    int threads;
    size_t pairs, walls; /* pairs with a rock that this rank solves; rocks with a wall nearby */
    struct hard_rocks_pair {
        uint32_t pair, rock; /* numbers in struct hard_pairs, increasing, and in struct rocks */
    } * pair;                /* those with walls behind the others, with UINT32_MAX for a pair */
    int32_t *of;             /* of each pair of struct hard_pairs: its number here; -1: of spheres */
    size_t *first;           /* pairs + 1: offers of pair n are offer[first[n]] ... [first[n + 1]) */
    size_t offers, room;
    struct hard_offer *offer;
    struct hard_found {
        size_t count, room;
        struct hard_offer *offer;
        size_t walls, wall_room;
        struct hard_wall_offer *wall;
    } * found; /* by thread; what walls are offered stays here, in the order of the particles */
    size_t pasts, past_room;
    struct hard_past *past; /* in the order of the pairs */
};

/* Borrows the context, whose bodies are there. hard_rocks_free releases. */
void hard_rocks_create(struct hard_rocks *rocks, const struct physics_context *context);
void hard_rocks_free(struct hard_rocks *rocks);

/* After a rebuild: finds the rocks among the pairs, and gives their points what the rows of `pairs` remember of them. */
void hard_rocks_link(struct hard_rocks *rocks, struct hard_pairs *pairs);

/* The number of pair m among those with a rock; -1: it has spheres alone. */
static inline int32_t hard_rocks_of(const struct hard_rocks *rocks, size_t m) {
    return rocks->of ? rocks->of[m] : -1;
}

/* Doubles of a row beside those of a contact of spheres. */
enum { HARD_ROCK_ROW = 4 };

/* True if particle i is the ball around a rock. */
bool hard_rocks_is(const struct hard_rocks *rocks, uint32_t i);

/* Brings rocks to their places, and finds what their pairs, with what the points remember, and they and walls offer up to this gap.
 * Opens its own team. */
void hard_rocks_find(struct hard_rocks *rocks, const struct hard_pairs *pairs, double near);

/* Forgets all points; a point remembers. In the order of the pairs. */
void hard_rocks_forget(struct hard_rocks *rocks);
void hard_rocks_remember(struct hard_rocks *rocks, const struct hard_past *past);

/* Turns what points remember into rows by owned particle, of both ends that are owned; allocates. Where there are rocks. */
void hard_rocks_detach(const struct hard_rocks *rocks, const struct hard_pairs *pairs,
                       struct history_rows *rows);

#endif
