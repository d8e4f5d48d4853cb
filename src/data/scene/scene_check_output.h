/* SPDX-License-Identifier: BSD-3-Clause */
/* Checks of scene_check.h: output and observables. */
#ifndef SCREE_SCENE_SCENE_CHECK_OUTPUT_H
#define SCREE_SCENE_SCENE_CHECK_OUTPUT_H

#include "data/scene/scene.h"

/* Refuses intervals in both forms, and regions and grids without a volume. */
bool scene_check_output(const struct scene *scene, struct error *error);

#endif
