/* SPDX-License-Identifier: BSD-3-Clause */
/* Rigid bodies of spheres (physics/bodies) in the contact problem of a step. A body is the body of its own particle; its members
 * touch, and their contacts have levers about its centre of mass. The forces of the contacts go to its particle, and the
 * mover of bodies takes them from there. */
#ifndef SCREE_HARD_CLUMPS_H
#define SCREE_HARD_CLUMPS_H

#include "physics/hard/problem.h"
#include <stdint.h>

struct bodies_links;
struct physics_context;

struct hard_clumps {
    const struct physics_context *context; /* borrowed */
    const struct bodies_links *links; /* borrowed until the next rebuild; NULL: the scene has no bodies */
    double (*turn)[HARD_TENSOR];      /* inverse inertia of each body and copy in space, at the present */
    struct hard_body *free;           /* of own bodies: without contacts */
    double duration;                  /* of the impulses of the step */
    size_t room;
};

void hard_clumps_free(struct hard_clumps *clumps);

/* Takes the bodies after a rebuild. */
void hard_clumps_link(struct hard_clumps *clumps, const struct physics_context *context);

/* The number of the particle that stands for the body of particle i; i itself where that is none's member. */
uint32_t hard_clumps_carrier(const struct hard_clumps *clumps, uint32_t i);
bool hard_clumps_carries(const struct hard_clumps *clumps, uint32_t i);

/* From the centre of mass of the body of member i to the centre of i. */
void hard_clumps_lever(const struct hard_clumps *clumps, uint32_t i, double lever[3]);

/* The inverse inertia of that body, over its `swing`. */
const double *hard_clumps_turn(const struct hard_clumps *clumps, uint32_t i);

/* The number of bodies and copies; the inverse inertia of number b over its `swing`, and its particle. */
int32_t hard_clumps_count(const struct hard_clumps *clumps);
const double *hard_clumps_at(const struct hard_clumps *clumps, int32_t b, uint32_t *particle);

/* Finds the velocities of own bodies at the end of the step without contacts. Collective. */
void hard_clumps_begin(struct hard_clumps *clumps, double duration);

/* Sets the bodies of the problem: own ones with these velocities, copies without any. Returns the largest speed of a
 * member, and of `pull` at least the largest acceleration. */
double hard_clumps_set(const struct hard_clumps *clumps, struct hard_problem *problem, double *pull);

/* Adds the forces of the contacts to the particles of own bodies. `gathered`: impulse and moment of a body whose motion is
 * prescribed, by the number of its particle; called for these alone. Returns the energy that the bodies lost. */
double hard_clumps_give(const struct hard_clumps *clumps, const struct hard_problem *problem,
                        const double *(*gathered)(const void *context, size_t k), const void *of);

#endif
