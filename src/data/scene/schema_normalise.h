/* SPDX-License-Identifier: BSD-3-Clause */
/* Short forms in the tree of a scene. */
#ifndef SCREE_SCENE_SCHEMA_NORMALISE_H
#define SCREE_SCENE_SCHEMA_NORMALISE_H

#include "data/scene/schema.h"

/* Puts short forms into their full form: a bare value into its section's main key, `particles.file` into
 * particles.sources[0].file. */
bool schema_normalise(struct schema_reader *reader, struct tree_node *root);

#endif
