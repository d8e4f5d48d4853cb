/* SPDX-License-Identifier: BSD-3-Clause */
/* Short forms in the tree of a scene become full forms, so that the rest sees full forms only:
 *
 *     index: hgrid               ->  index: {name: hgrid}
 *     skin: auto                 ->  skin: {auto: true}                         (rows with a flag)
 *     particles: {file: a.txt}   ->  particles: {sources: [{file: a.txt}]}      (the list is marked `implied`)
 *     walls:                     ->  walls: []
 *     law: {file: a.c}           ->  law: custom, law_file: a.c                 (rows with a file_key)
 */
#include "data/scene/schema_normalise.h"
#include "base/memory.h"
#include "data/scene/schema_root.h"

#include <stdlib.h>
#include <string.h>

static bool is_empty(const struct tree_node *node) {
    return node->kind == TREE_SCALAR && !node->quoted &&
           (!node->text[0] || strcmp(node->text, "~") == 0 || strcmp(node->text, "null") == 0);
}

/* Wraps a scalar into a mapping with one key. */
static void wrap_scalar(struct tree_node *node, const char *key) {
    struct tree_node *value = tree_new(TREE_SCALAR, node->line);
    value->text = node->text;
    value->quoted = node->quoted;
    node->text = NULL;
    tree_clear(node, TREE_MAP);
    tree_put(node, key, value);
}

/* True if a key is none of its section (the context, a schema_table). */
static bool belongs_elsewhere(const void *table, const char *key) {
    return schema_row_find(table, key, strlen(key)) == NULL;
}

/* Moves the keys of a section that belong to a single element into that element. */
static bool fold_short_form(struct schema_reader *reader, const struct schema_table *table,
                            struct tree_node *node, const char *key) {
    const struct schema_row *list_row = schema_short_list(table);
    if (!list_row || node->kind != TREE_MAP)
        return true;
    size_t first = 0;
    while (first < node->children && !belongs_elsewhere(table, node->key[first]))
        first++;
    if (first == node->children)
        return true;
    if (tree_get(node, list_row->key))
        return schema_fail(reader, node->child[first], key,
                           "'%.80s' beside '%s': either one source directly here, or a list of %s",
                           node->key[first], list_row->key, list_row->key);
    struct tree_node *element = tree_new(TREE_MAP, node->line), *list = tree_new(TREE_LIST, node->line);
    tree_move(node, element, belongs_elsewhere, table);
    list->implied = true;
    tree_append(list, element);
    tree_put(node, list_row->key, list);
    return true;
}

/* Makes a mapping from a scalar that names a key: the key is true. */
static void set_flag(struct tree_node *node, const char *key) {
    wrap_scalar(node, key);
    struct tree_node *value = node->child[0];
    memory_free(value->text);
    value->text = tree_text("true", 4);
}

static bool normalise_table(struct schema_reader *reader, const struct schema_table *table,
                            struct tree_node *node, const char *prefix);

static bool normalise_row(struct schema_reader *reader, const struct schema_row *row, struct tree_node *node,
                          const char *key) {
    if (row->type == SCHEMA_SECTION) {
        if (is_empty(node))
            tree_clear(node, TREE_MAP);
        else if (node->kind == TREE_SCALAR && row->flag && strcmp(node->text, row->flag) == 0)
            set_flag(node, row->flag);
        else if (node->kind == TREE_SCALAR && row->main)
            wrap_scalar(node, row->main);
        return fold_short_form(reader, row->sub, node, key) && normalise_table(reader, row->sub, node, key);
    }
    if (row->type != SCHEMA_LIST)
        return true;
    if (is_empty(node))
        tree_clear(node, TREE_LIST);
    for (size_t k = 0; node->kind == TREE_LIST && k < node->children; k++)
        if (!normalise_table(reader, row->sub, node->child[k], key))
            return false;
    return true;
}

/* Gives child k, which stands under an older name, the name of its row. */
static bool rename_key(struct schema_reader *reader, const struct schema_row *row, struct tree_node *node,
                       size_t k, const char *key) {
    if (tree_get(node, row->key))
        return schema_fail(reader, node->child[k], key, "is an older name of %s, which is given, too",
                           row->key);
    snprintf(reader->note, SCHEMA_NOTE_MAX, "%.120s is an older name of %.60s", key, row->key);
    char *name = memory_allocate(strlen(row->key) + 1, 1, "key of a scene");
    strcpy(name, row->key);
    memory_free(node->key[k]);
    node->key[k] = name;
    return true;
}

static char *text_of(const char *text) {
    char *copy = memory_allocate(strlen(text) + 1, 1, "value of a scene");
    return strcpy(copy, text);
}

/* Takes {file: PATH}, child k, apart. */
static bool unfold_file(struct schema_reader *reader, const struct schema_row *row, struct tree_node *node,
                        size_t k, const char *key) {
    struct tree_node *child = node->child[k];
    const struct tree_node *given = child->children == 1 ? tree_get(child, "file") : NULL;
    if (given == NULL || given->kind != TREE_SCALAR)
        return schema_fail(reader, child, key, "is a name, or {file: PATH}");
    if (tree_get(node, row->file_key))
        return schema_fail(reader, child, key, "names a file, and %s is given, too", row->file_key);
    struct tree_node *path = tree_new(TREE_SCALAR, given->line);
    path->text = text_of(given->text);
    path->quoted = given->quoted;
    tree_clear(child, TREE_SCALAR);
    child->text = text_of(row->file_name);
    tree_put(node, row->file_key, path);
    return true;
}

static bool normalise_table(struct schema_reader *reader, const struct schema_table *table,
                            struct tree_node *node, const char *prefix) {
    for (size_t k = 0; node->kind == TREE_MAP && k < node->children; k++) {
        const struct schema_row *row = schema_row_find(table, node->key[k], strlen(node->key[k]));
        char key[SCHEMA_KEY_MAX];
        snprintf(key, sizeof(key), "%.120s%s%.120s", prefix, prefix[0] ? "." : "", node->key[k]);
        if (row && strcmp(row->key, node->key[k]) != 0 && !rename_key(reader, row, node, k, key))
            return false;
        if (row && row->file_key && node->child[k]->kind == TREE_MAP &&
            !unfold_file(reader, row, node, k, key))
            return false;
        if (row && !normalise_row(reader, row, node->child[k], key))
            return false;
    }
    return true;
}

bool schema_normalise(struct schema_reader *reader, struct tree_node *root) {
    if (root->kind == TREE_SCALAR && is_empty(root))
        tree_clear(root, TREE_MAP);
    return normalise_table(reader, &schema_root, root, "");
}

/* Settings of the command line. */
