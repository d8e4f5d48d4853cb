/* SPDX-License-Identifier: BSD-3-Clause */
/* The schema for people. */
#ifndef SCREE_DATA_SCENE_SCHEMA_HELP_H
#define SCREE_DATA_SCENE_SCHEMA_HELP_H

#include "data/scene/schema.h"

#include <stdbool.h>
#include <stdio.h>

/* Text of `scree help`: all keys in one line each (`key` NULL), a section, or one key at length. False if
 * there is no such key; then the nearest is named in `out` too. */
bool scene_help(FILE *out, const char *key);

/* docs/scene.md. */
void scene_document(FILE *out);

/* Looks for a word in the schema: keys, values, words of other programs, and help texts. */

/* Prints a line for each key whose last part is the word, each value that is the word with the keys that exist
 * only with the value, and the key that the word means in other programs; without any of these, for each key
 * whose name, value or help has the word in it. Returns the number of lines; if this is one line with a key,
 * `only` becomes the key, and nothing is printed; else `only` is "". */
int schema_search(FILE *out, const char *word, char only[SCHEMA_KEY_MAX]);

#endif
