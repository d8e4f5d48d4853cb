/* SPDX-License-Identifier: BSD-3-Clause */
/* The queries of the schema (schema_rows.h): rows by key, conditions, allowed values, messages. */
#ifndef SCREE_SCENE_SCHEMA_H
#define SCREE_SCENE_SCHEMA_H

#include "base/error.h"
#include "data/scene/schema_rows.h"
#include "data/scene/tree.h"
#include <stdbool.h>
#include <stdio.h>

/* The state of a read; messages need this struct, too. */
struct schema_reader {
    const char *file;     /* for messages */
    const char *folder;   /* relative paths start here */
    char *root;           /* the struct that schema_root describes */
    bool units;           /* units may be given */
    const int *dimension; /* 2: vectors may have two components */
    char *note;           /* SCHEMA_NOTE_MAX bytes: note to the user of an older name; "" if none */
    bool doubtful;        /* a value that conditions or references ask for was refused: what is missing or
                             misplaced then may follow from it, and is not told */
    struct error *error;
};

/* Bytes that a full key ("walls[12].motion[3].direction") may have. */
enum { SCHEMA_KEY_MAX = 256, SCHEMA_NOTE_MAX = 256 };

/* Adds a mistake to the reader's error: "PLACE: KEY: TEXT". Returns false. */
bool schema_fail(struct schema_reader *reader, const struct tree_node *node, const char *key,
                 const char *format, ...) __attribute__((format(printf, 4, 5)));

/* The bounds of a row's range and whether they belong to it; without one: all finite numbers. True if `value`
 * lies within. */
bool schema_in_range(const struct schema_row *row, double value);

/* Name of entry k of a list at the top level (a target of REF rows), NULL beyond its end. */
const char *schema_target_name(const char *root, const char *target, int k);

/* True if the row exists with the present values: its `when` holds. `base` is the struct of its section. */
bool schema_applies(const struct schema_row *row, const struct schema_table *table, const char *base,
                    const char *root);

/* The condition of a row in words: "contact.law=hertz & contact.damping=restitution"; empty without. */
void schema_condition(const struct schema_row *row, char *text, size_t room);

/* The first row of a key, or of its alias, in a table, or NULL; `length` bytes of `key` count. */
const struct schema_row *schema_row_find(const struct schema_table *table, const char *key, size_t length);

/* The list whose element a section may hold directly (`short_form`), or NULL. */
const struct schema_row *schema_short_list(const struct schema_table *table);

/* The row of a full key, list numbers ignored ("walls[3].radius", "walls[].radius" and "walls.radius" alike,
 * short forms understood), and its key in the form "walls[].radius"; or NULL. */
const struct schema_row *schema_find(const char *key, char full[SCHEMA_KEY_MAX]);

/* Calls `visit` for every row, depth first, with the full key ("walls[].radius") and its depth. */
void schema_walk(void (*visit)(void *context, const struct schema_row *row, const char *key, int depth),
                 void *context);

/* The k-th name that a row of type NAME or CHOICE allows; NULL behind the last, and for other rows. */
const char *schema_value_name(const struct schema_row *row, int k);

/* The allowed values, in words: "a number > 0 with a unit of length (m)", "one of a, b, c". */
void schema_allowed(const struct schema_row *row, char *text, size_t room);

#endif
