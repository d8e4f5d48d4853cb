/* SPDX-License-Identifier: BSD-3-Clause */
/* From the struct to text. */
#ifndef SCREE_SCENE_SCHEMA_WRITE_H
#define SCREE_SCENE_SCHEMA_WRITE_H

#include <stdio.h>

/* Writes all values as YAML (see scene_echo). `working` is put before relative paths. */
void schema_write(FILE *out, const void *root, const char *working);

#endif
