/* SPDX-License-Identifier: BSD-3-Clause */
/* A YAML text as a tree of nodes that know their lines. An alias (*name) becomes a copy of what has its anchor
 * (&name), with the lines of the anchor, and '<<' takes in the keys of other mappings, where the mapping does
 * not give them itself. Tags and several documents are refused. Duplicate keys are refused here. */
#ifndef SCREE_SCENE_TREE_H
#define SCREE_SCENE_TREE_H

#include "base/error.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum tree_kind { TREE_SCALAR, TREE_LIST, TREE_MAP };

struct tree_node {
    enum tree_kind kind;
    char *text;   /* SCALAR: owned */
    bool quoted;  /* SCALAR: was in quotes */
    bool implied; /* LIST: stands for the keys of its section (see schema.h, short_form) */
    long line;    /* from 1; 0: from the command line */
    size_t children;
    struct tree_node **child; /* LIST, MAP: owned */
    char **key;               /* MAP: owned */
};

/* Parses `text`; `file` is for messages, `line` the line number of its start (0: the text comes from the
 * command line, and so do all nodes). An empty text gives an empty mapping. NULL with a user's error. */
struct tree_node *tree_parse(const char *file, const char *text, long line, struct error *error);
void tree_free(struct tree_node **node);

/* The child of a mapping, or NULL. */
struct tree_node *tree_get(const struct tree_node *map, const char *key);

/* A new empty node. */
struct tree_node *tree_new(enum tree_kind kind, long line);

/* A copy of a node and of all below it. */
struct tree_node *tree_copy(const struct tree_node *node);

/* A copy of `length` bytes of a text, for a node or a key (memory_free). */
char *tree_text(const char *text, size_t length);

/* Adds an entry (`key`, made by tree_text, and `child` taken over) to a mapping that has no such key. */
void tree_add(struct tree_node *map, char *key, struct tree_node *child);

/* Puts `child` (taken over) under `key` of a mapping, replacing the old entry. */
void tree_put(struct tree_node *map, const char *key, struct tree_node *child);

/* Appends `child` (taken over) to a list. */
void tree_append(struct tree_node *list, struct tree_node *child);

/* Moves all entries of a mapping whose keys `moves` names to the end of another one, which has none of these
 * keys; the order stays. Takes time proportional to the number of entries. */
void tree_move(struct tree_node *from, struct tree_node *to,
               bool (*moves)(const void *context, const char *key), const void *context);

/* Takes entry `k` out of a mapping or list and hands it over. */
struct tree_node *tree_take(struct tree_node *node, size_t k);

/* Turns any node into an empty one of another kind; its line stays. */
void tree_clear(struct tree_node *node, enum tree_kind kind);

/* The node of a full key, or the deepest one on the way to it. */
const struct tree_node *tree_nearest(const struct tree_node *root, const char *key);

/* Writes a node as YAML in one line that reads back to the same tree; only the lines are lost. */
void tree_write(FILE *out, const struct tree_node *node);

/* "FILE:LINE" or "command line". Returns `place`. */
const char *tree_place(const struct tree_node *node, const char *file, char *place, size_t room);

#endif
