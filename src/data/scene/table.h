/* SPDX-License-Identifier: BSD-3-Clause */
/* Plain tables of particles. */
#ifndef SCREE_SCENE_TABLE_H
#define SCREE_SCENE_TABLE_H

#include "data/scene/source_batch.h"

/* Reads the table of a source of kind SOURCE_FILE into an empty batch. Fails with file, line, column. */
bool table_read(const struct scene *scene, int source, struct source_batch *batch, struct error *error);

#endif
