/* SPDX-License-Identifier: BSD-3-Clause */
/* Lets the spheres of a packing fall and come to rest in their container. */
#ifndef SCREE_PROGRAM_PACK_SETTLE_H
#define SCREE_PROGRAM_PACK_SETTLE_H

#include "base/error.h"
#include "data/formats/rows.h"
#include "front/pack/pack.h"

/* The state of spheres that settle; `unbalanced` is nan without contacts. */
struct settle_state {
    double time;         /* in fall times: of a free fall over the height of the container */
    double speed;        /* speed of the mean kinetic energy, over that of a fall by the smallest diameter */
    double unbalanced;   /* mean force on a sphere over that of a contact */
    double coordination; /* contacts a sphere, walls included */
    double overlap;      /* the largest, over the smaller radius */
    uint64_t steps;
    bool rests;
};

struct settle_hook {
    void (*show)(void *context, const struct settle_state *state);
    void *context;
};

/* Runs a scene of these rows under gravity along -z between the walls of the container, with Hertz's law, a restitution of 0.2, the recipe's
 * friction, a rolling friction of 0.01, and a stiffness at which the weight of the bed presses spheres into each other by about half a percent of a
 * radius; ends when the speed and the unbalanced force are small, or after 100 fall times (`rests` of the state is then false). Changes the
 * positions, and fills the report's overlap and bed; needs its smallest radius and fraction. `hook` NULL: nobody is told. The spheres pass
 * to the scene by a temporary file in $TMPDIR or /tmp. Fails (system) if that file cannot be written, and as the scene does. One process, with the threads of the recipe; the same bits for any number of them. */
bool pack_settle(const struct recipe *recipe, const struct settle_hook *hook, struct rows *rows,
                 struct pack_report *report, struct settle_state *state, struct error *error);

#endif
