/* SPDX-License-Identifier: BSD-3-Clause */
/* Words of other programs and of papers for keys of a scene. */
#ifndef SCREE_SCENE_SYNONYMS_H
#define SCREE_SCENE_SYNONYMS_H

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
