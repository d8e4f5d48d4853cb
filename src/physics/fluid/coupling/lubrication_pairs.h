/* SPDX-License-Identifier: BSD-3-Clause */
/* Lubrication (lubrication.h) of all grains that are near each other or near walls: `fluid.grains.lubrication`. Its forces are part of those of contacts in the grains' own steps
 * (rigid_motion.h), and the fluid gets their momentum with that of contacts. Members of bodies are spheres that touch others, not each other. */
#ifndef SCREE_COUPLING_LUBRICATION_PAIRS_H
#define SCREE_COUPLING_LUBRICATION_PAIRS_H

#include "engine/physics.h"
#include "kernel/pairs/interaction.h"

/* Pairs that may be near until the next rebuild; all owned. */
struct lubrication_pairs {
    size_t count, room;
    struct lubrication_near {
        uint32_t grain, partner; /* number of an owned grain; number and image code, as in a pair list */
    } * near;                    /* by grain */
};

/* True if a scene wants it. */
bool lubrication_wanted(const struct physics_context *context);

/* After a rebuild, of a scene that wants it: takes the pairs of grains from rows of all pairs. */
void lubrication_pairs_take(const struct physics_context *context, const struct pair_rows *rows);

/* Adds the forces to those of owned grains and of walls, and their work to that of the fluid. Opens its own team. */
void lubrication_pairs_add(const struct physics_context *context);

void lubrication_pairs_destroy(struct lubrication_pairs **pairs);

#endif
