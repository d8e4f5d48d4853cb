/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: stages. */
#ifndef SCREE_SCENE_SCHEMA_STAGE_H
#define SCREE_SCENE_SCHEMA_STAGE_H

#include "data/scene/schema_rows.h"

extern const struct schema_table schema_stages;

#endif
