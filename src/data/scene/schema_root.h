/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of a whole scene. */
#ifndef SCREE_SCENE_SCHEMA_ROOT_H
#define SCREE_SCENE_SCHEMA_ROOT_H

#include "data/scene/schema_rows.h"

/* The keys of a scene. */
extern const struct schema_table schema_root;

#endif
