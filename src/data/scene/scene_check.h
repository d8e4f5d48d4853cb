/* SPDX-License-Identifier: BSD-3-Clause */
/* The checks of a scene: its walls, its box in motion, its output, and what goes together. */
#ifndef SCREE_DATA_SCENE_SCENE_CHECK_H
#define SCREE_DATA_SCENE_SCENE_CHECK_H

#include "data/scene/scene.h"

/* Combinations that cannot be. Fails (user) on the first. */
bool scene_check(const struct scene *scene, struct error *error);

/* The check of a box in motion. */

/* Refuses directions that are not periodic, and sections that do not go with a box in motion. Fails (user) on
 * the first. */
bool scene_check_box(const struct scene *scene, struct error *error);

/* Checks of scene_check.h: output and observables. */

/* Refuses intervals in both forms, and regions and grids without a volume. */
bool scene_check_output(const struct scene *scene, struct error *error);

/* The check of the walls of a scene. */

/* Refuses walls that a periodic box would cut, and motions that cannot be. Fails (user) on the first. */
bool scene_check_walls(const struct scene *scene, struct error *error);

#endif
