/* SPDX-License-Identifier: BSD-3-Clause */
/* From the tree to the struct. */
#ifndef SCREE_SCENE_SCHEMA_READ_H
#define SCREE_SCENE_SCHEMA_READ_H

#include "data/scene/schema.h"

/* Applies one --set text to a normalised tree; the value ~ (or null) takes the key out. */
bool schema_set(struct schema_reader *reader, struct tree_node *root, const char *text);

/* Puts `value` (taken over, freed on failure) at a full key of a normalised tree; ~ takes the key out. An element of a
 * list is named by its number or by its name: "walls[0].radius", "walls[gate].radius", "material_pairs[glass, steel]".
 * A whole element under a new name is appended, and has this name. */
bool schema_put(struct schema_reader *reader, struct tree_node *root, const char *key,
                struct tree_node *value);

/* Checks every node against the schema and stores all values, defaults included, in reader->root. */
bool schema_read(struct schema_reader *reader, const struct tree_node *root);

#endif
