/* SPDX-License-Identifier: BSD-3-Clause */
/* The check of a box in motion. */
#ifndef SCREE_SCENE_SCENE_CHECK_BOX_H
#define SCREE_SCENE_SCENE_CHECK_BOX_H

#include "data/scene/scene.h"

/* Refuses directions that are not periodic, and sections that do not go with a box in motion. Fails (user) on
 * the first. */
bool scene_check_box(const struct scene *scene, struct error *error);

#endif
