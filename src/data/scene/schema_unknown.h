/* SPDX-License-Identifier: BSD-3-Clause */
/* Keys that the schema does not know: what may be meant, and what is allowed. */
#ifndef SCREE_DATA_SCENE_SCHEMA_UNKNOWN_H
#define SCREE_DATA_SCENE_SCHEMA_UNKNOWN_H

#include "data/scene/schema.h"

/* Writes the nearest known full key to `nearest`; false if none is near. `section` is the prefix in which the
 * key stood ("walls[]."), or "". Looks at the letters alone. */
bool schema_suggest(const char *section, const char *key, char nearest[SCHEMA_KEY_MAX]);

/* Letters by which two words differ, if one may be a typing error of the other; else -1. */
int schema_distance(const char *a, const char *b);

/* Writes the full key that a word of other programs may mean to `meant` and how the two differ to *note (NULL:
 * not at all); false for unknown words. Keys of `table`, which stands at `section`, are nearest; NULL: the
 * top level. */
bool schema_meaning(const struct schema_table *table, const char *section, const char *word,
                    char meant[SCHEMA_KEY_MAX], const char **note);

/* Refuses a key that its section, with the prefix "walls[2]." or "", does not have: with the key that may be
 * meant and, if `lists`, with all keys of the section. `table` NULL: the section has no keys. Returns false. */
bool schema_unknown(struct schema_reader *reader, const struct schema_table *table,
                    const struct tree_node *node, const char *prefix, const char *key, bool lists);

/* Refuses all keys of a section that are none of its table. Returns true if all are known. */
bool schema_known_keys(struct schema_reader *reader, const struct schema_table *table,
                       const struct tree_node *section, const char *prefix);

/* Words of other programs and of papers for keys of a scene. */

struct synonym {
    const char *word;
    const char
        *keys; /* keys that may be meant, nearest first, separated by blanks: the last part of a key, or
                         a full key */
    const char *note; /* how the two differ; NULL: not at all */
};

/* The synonym of a word, capitals and "-" for "_" allowed; NULL: none is known. */
const struct synonym *synonyms_find(const char *word);

/* The k-th synonym, NULL behind the last one. */
const struct synonym *synonyms_get(int k);

#endif
