/* SPDX-License-Identifier: BSD-3-Clause */
/* The steps before and after the reading of a scene: names, derived values. */
#ifndef SCREE_SCENE_FINISH_H
#define SCREE_SCENE_FINISH_H

#include "data/scene/scene.h"

struct tree_node;

/* Before reading: creates the entries that no key names (the group "free"). */
void finish_prepare(struct scene *scene);

/* Before the tree `root` is read, as a name that stands twice makes all that refers to it unclear: the names
 * of materials, walls, groups, regions of observables and stages, each list for itself, differ. Fails (user) with the
 * lines of both. */
bool finish_names(const struct scene *scene, const struct tree_node *root, struct error *error);

/* Part of finish_scene: the box, its sides, and what happens to particles that leave through them. Fails (user). */
bool finish_box(struct scene *scene, struct error *error);

/* After reading: derived values. Fails (user) where a value that is needed is missing, or a file with the box
 * cannot be read. */
bool finish_scene(struct scene *scene, struct error *error);

#endif
