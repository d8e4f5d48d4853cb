/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: walls and their motions. */
#ifndef SCREE_SCENE_SCHEMA_WALLS_H
#define SCREE_SCENE_SCHEMA_WALLS_H

#include "data/scene/schema_rows.h"

extern const struct schema_table schema_wall;

#endif
