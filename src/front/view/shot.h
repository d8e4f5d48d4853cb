/* SPDX-License-Identifier: BSD-3-Clause */
/* What a page is shown of a simulation: the description of a run, and frames.
 *
 * A frame is SHOT_HEAD bytes of JSON, filled up with spaces, and then a row of SHOT_NUMBERS floats a particle: position (in the
 * user's coordinates), radius, and the value that gives the colour; in a run with rocks SHOT_ROCK_NUMBERS more (shot_rocks.h). "numbers" in the
 * head says how many. Members of bodies are shown, and not the bodies. If there are more than SHOT_MOST particles, a frame has
 * a part of each size class, the same particles in each frame; a class of few particles is there as a whole. */
#ifndef SCREE_VIEW_SHOT_H
#define SCREE_VIEW_SHOT_H

#include "engine/state.h"

enum { SHOT_HEAD = 512, SHOT_NUMBERS = 5, SHOT_MOST = 100000 };

/* The description of a run as JSON: title, box, the fields that can give the colour, in the order of their numbers, and the shapes of rocks;
 * memory_free releases. Any rank. */
char *shot_about(const struct simulation *simulation);

/* A frame, coloured by field number `field` (0 where there is no such field), of `bytes` bytes; memory_free releases. NULL
 * on ranks other than 0. Collective. */
char *shot_take(const struct simulation *simulation, int field, bool paused, size_t *bytes);

#endif
