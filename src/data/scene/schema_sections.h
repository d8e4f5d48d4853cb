/* SPDX-License-Identifier: BSD-3-Clause */
/* Sections of a scene that have a table of keys of their own, for schema_root.c. */
#ifndef SCREE_DATA_SCENE_SCHEMA_SECTIONS_H
#define SCREE_DATA_SCENE_SCHEMA_SECTIONS_H

#include "data/scene/schema_rows.h"

/* Rows of the schema: materials, their pairs, the contact law. */

extern const struct schema_table schema_material, schema_pair, schema_contact;

/* Rows of the schema: stages. */

extern const struct schema_table schema_stages;

/* Rows of the schema: walls and their motions. */

extern const struct schema_table schema_wall;

#endif
