/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads one value from a node into the place that the row gives. */
#ifndef SCREE_SCENE_SCHEMA_VALUE_H
#define SCREE_SCENE_SCHEMA_VALUE_H

#include "data/scene/schema.h"

/* Reads one value (no section, no list of sections) from a node and stores it in the section's struct at
 * `base`. */
bool schema_value(struct schema_reader *reader, const struct schema_row *row, const struct tree_node *node,
                  const char *key, char *base);

/* Stores the value of a row without default whose key is left out: NAN, -1, empty. */
void schema_unset(const struct schema_row *row, char *base);

/* A number with an optional unit: "5 mm" where the row's unit is "m". False with one line in `why`. */
bool schema_number(const char *text, const char *unit, bool units_allowed, double *value, char *why,
                   size_t room);

#endif
