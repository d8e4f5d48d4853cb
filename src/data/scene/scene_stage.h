/* SPDX-License-Identifier: BSD-3-Clause */
/* Stages: phases of one run, each with changes of the scene and an end. The scene itself is the scene of the first
 * stage. The scene of a later stage is the text of the file with the settings of the command line, then with the keys
 * that each stage up to it sets (scene_stage in scene_read.h). */
#ifndef SCREE_SCENE_SCENE_STAGE_H
#define SCREE_SCENE_SCENE_STAGE_H

#include "data/scene/scene.h"

struct tree_node;

/* Derived values: a stage with conditions and without a duration has no end of its own. */
void scene_stages_finish(struct scene *scene);

/* Checks what one scene alone tells of its stages: ends, conditions. Fails (user) with place, stage and key. */
bool scene_stages_check(const struct scene *scene, struct error *error);

/* Checks the scene of stage `number` beside that of the stage before: what a stage sets must be able to change, the
 * targets of its conditions must exist. Fails (user) with place, stage and key. */
bool scene_stage_check(const struct scene *before, const struct scene *scene, int number,
                       struct error *error);

/* The keys that stage `number` sets, as a mapping of the tree; NULL: none. */
const struct tree_node *scene_stage_keys(const struct tree_node *root, int number);

#endif
