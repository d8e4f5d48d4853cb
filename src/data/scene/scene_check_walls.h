/* SPDX-License-Identifier: BSD-3-Clause */
/* The check of the walls of a scene. */
#ifndef SCREE_SCENE_SCENE_CHECK_WALLS_H
#define SCREE_SCENE_SCENE_CHECK_WALLS_H

#include "data/scene/scene.h"

/* Refuses walls that a periodic box would cut, and motions that cannot be. Fails (user) on the first. */
bool scene_check_walls(const struct scene *scene, struct error *error);

#endif
