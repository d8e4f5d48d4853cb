/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: particle sources, size laws, regions, groups, insertion and deletion. */
#ifndef SCREE_SCENE_SCHEMA_PARTICLES_H
#define SCREE_SCENE_SCHEMA_PARTICLES_H

#include "data/scene/schema_rows.h"

extern const struct schema_table schema_region, schema_sizes, schema_particles, schema_insertion,
    schema_deletion, schema_group;

#endif
