/* SPDX-License-Identifier: BSD-3-Clause */
/* The check of a scene. */
#ifndef SCREE_SCENE_SCENE_CHECK_H
#define SCREE_SCENE_SCENE_CHECK_H

#include "data/scene/scene.h"

/* Combinations that cannot be. Fails (user) on the first. */
bool scene_check(const struct scene *scene, struct error *error);

#endif
