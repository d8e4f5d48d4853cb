/* SPDX-License-Identifier: BSD-3-Clause */
/* The laws that a user names to `scree pack`, and their keys. A law stands for a scene (recipe.h); most keys are keys of its packed
 * source. */
#ifndef SCREE_PACK_LAWS_H
#define SCREE_PACK_LAWS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

struct laws_key {
    const char *name;
    const char *path; /* of the same key in a scene; NULL: none */
    const char *help; /* NULL: that of the scene's key */
    bool list;        /* several numbers, as in 1,2,4 */
};

/* A law: its keys are those of `defaults`, which lists KEY=VALUE, those of `more`, which have none, and those
 * of all. */
struct laws_row {
    const char *name, *summary, *defaults, *more, *text;
    bool cube_only; /* without the keys of other containers */
};

/* The law of this name, and the k-th key; NULL: none. */
const struct laws_row *laws_find(const char *name);
const struct laws_key *laws_key(int k);

/* True if the law has a key of this name (of `length` letters). */
bool laws_has(const struct laws_row *law, const char *name, size_t length);

/* Writes the default of a key; false if it has none. */
bool laws_default(const struct laws_row *law, const char *name, char *value, size_t size);

/* Lists the laws, or describes one law in full; false if no law has that name. */
bool pack_help(FILE *out, const char *law);

#endif
