/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: materials, their pairs, the contact law. */
#ifndef SCREE_SCENE_SCHEMA_CONTACT_H
#define SCREE_SCENE_SCHEMA_CONTACT_H

#include "data/scene/schema_rows.h"

extern const struct schema_table schema_material, schema_pair, schema_contact;

#endif
