/* SPDX-License-Identifier: BSD-3-Clause */
/* The files that a scene names. */
#ifndef SCREE_SCENE_SCENE_FILES_H
#define SCREE_SCENE_SCENE_FILES_H

#include "data/scene/scene.h"

/* True if this process can open all files that the scene names. Else adds a user's mistake for each, with the
 * place in the scene and the name of the file. */
bool scene_files_open(const struct scene *scene, struct error *error);

/* Brings the size laws of all sources and insertions to radii and parts, and reads the files that hold sieve
 * curves. Fails (user) with the place in the scene, or in the file. */
bool scene_files_sizes(struct scene *scene, struct error *error);

#endif
