/* SPDX-License-Identifier: BSD-3-Clause */
/* Looks for a word in the schema: keys, values, words of other programs, and help texts. */
#ifndef SCREE_SCENE_SCHEMA_SEARCH_H
#define SCREE_SCENE_SCHEMA_SEARCH_H

#include "data/scene/schema.h"

/* Prints a line for each key whose last part is the word, each value that is the word with the keys that exist
 * only with the value, and the key that the word means in other programs; without any of these, for each key
 * whose name, value or help has the word in it. Returns the number of lines; if this is one line with a key,
 * `only` becomes the key, and nothing is printed; else `only` is "". */
int schema_search(FILE *out, const char *word, char only[SCHEMA_KEY_MAX]);

#endif
