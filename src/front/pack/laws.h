/* SPDX-License-Identifier: BSD-3-Clause */
/* The tables of the laws and of their keys. */
#ifndef SCREE_PACK_LAWS_H
#define SCREE_PACK_LAWS_H

#include "front/pack/options.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum law_key_type { LAW_REAL, LAW_WHOLE, LAW_TEXT, LAW_NAME, LAW_EDGES };

struct law_key {
    const char *name;
    enum law_key_type type;
    size_t offset; /* in struct pack_options */
    double least, most;
    const char *const *names; /* NAME: those of the values of the enum */
    const char *help;
};

/* A law: its keys are those of `defaults`, which lists KEY=VALUE, those of `more`, which have none, and those
 * of all. */
struct laws_row {
    const char *name, *summary, *defaults, *more, *text;
    bool cube_only; /* without the keys of other containers */
};

/* The k-th law (an enum pack_law) and key; NULL after the last. */
const struct laws_row *laws_get(int k);
const struct law_key *laws_key(int k);

/* The keys of all laws with their defaults. */
const char *laws_common(void);

/* The keys of containers with their defaults; laws that are `cube_only` have none of them. */
const char *laws_container(void);

/* True if the law has a key of this name (of `length` letters). */
bool laws_has(const struct laws_row *law, const char *name, size_t length);

/* The name of a law. */
const char *pack_law_name(enum pack_law law);

/* Lists the laws, or describes one law in full; false if no law has that name. */
bool pack_help(FILE *out, const char *law);

#endif
