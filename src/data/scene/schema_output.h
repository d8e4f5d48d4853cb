/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: output and observables. */
#ifndef SCREE_DATA_SCENE_SCHEMA_OUTPUT_H
#define SCREE_DATA_SCENE_SCHEMA_OUTPUT_H

#include "data/scene/schema_rows.h"

#include <stdio.h>

extern const struct schema_table schema_output, schema_observables;

/* The names of observables and their families; the names of components. */
const char *schema_observable_choice(int k, const char **help);
extern const struct schema_name schema_components[];

/* From the struct to text. */

/* Writes all values as YAML (see scene_echo). `working` is put before relative paths. */
void schema_write(FILE *out, const void *root, const char *working);

#endif
