/* SPDX-License-Identifier: BSD-3-Clause */
/* Files that tell which bodies their particles are. */
#ifndef SCREE_SCENE_SOURCE_BODIES_H
#define SCREE_SCENE_SOURCE_BODIES_H

#include "data/scene/scene.h"

/* Sets `told` if a source is a file that tells shapes of bodies: a trajectory of bodies, or a table with a column of shapes. Reads the
 * head of the file. False, with a user's error, where it cannot be read. */
bool source_bodies_told(const struct scene *scene, int source, bool *told, struct error *error);

#endif
