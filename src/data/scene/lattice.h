/* SPDX-License-Identifier: BSD-3-Clause */
/* Spheres on a lattice. */
#ifndef SCREE_SCENE_LATTICE_H
#define SCREE_SCENE_LATTICE_H

#include "data/scene/source_batch.h"

/* Places spheres on a lattice, cell by cell, into an empty batch. Fails (user) where they
 * are too many or too few. */
bool lattice_make(const struct scene *scene, int source, struct source_batch *batch, struct error *error);

#endif
