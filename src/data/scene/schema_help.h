/* SPDX-License-Identifier: BSD-3-Clause */
/* The schema for people. */
#ifndef SCREE_SCENE_SCHEMA_HELP_H
#define SCREE_SCENE_SCHEMA_HELP_H

#include <stdbool.h>
#include <stdio.h>

/* Text of `scree help`: all keys in one line each (`key` NULL), a section, or one key at length. False if
 * there is no such key; then the nearest is named in `out` too. */
bool scene_help(FILE *out, const char *key);

/* docs/scene.md. */
void scene_document(FILE *out);

#endif
