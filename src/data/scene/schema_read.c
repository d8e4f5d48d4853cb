/* SPDX-License-Identifier: BSD-3-Clause */
/* From the tree, whose short forms are resolved (schema_normalise.h), to the struct. Rows that do not apply are
 * left as they are (the struct comes zeroed): two keys may share a place. */
#include "data/scene/schema_read.h"
#include "base/memory.h"
#include "data/scene/mistakes.h"
#include "data/scene/schema_root.h"
#include "data/scene/schema_unknown.h"
#include "data/scene/schema_value.h"

#include <stdlib.h>
#include <string.h>

static bool is_empty(const struct tree_node *node) {
    return node->kind == TREE_SCALAR && !node->quoted &&
           (!node->text[0] || strcmp(node->text, "~") == 0 || strcmp(node->text, "null") == 0);
}

static bool read_table(struct schema_reader *reader, const struct schema_table *table,
                       const struct tree_node *node, const char *prefix, char *base);

static bool read_list(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, char *base) {
    int count = row->first;
    memcpy(base + row->count_offset, &count, sizeof(count));
    if (node->kind != TREE_LIST)
        return schema_fail(reader, node, key, "must be a list of sections, each beginning with '- '");
    if (node->children == 0 && row->required)
        return schema_fail(reader, node, key, "the list is empty; at least one is needed");
    if (node->children > (size_t)(row->max - row->first))
        return schema_fail(reader, node, key, "%zu entries; at most %d are possible", node->children,
                           row->max - row->first);
    if (row->apart) {
        void *elements = memory_allocate_zero(node->children, row->size, "a list of a scene");
        memcpy(base + row->offset, &elements, sizeof(elements));
    }
    bool good = true;
    for (size_t k = 0; k < node->children && !mistakes_full(reader->error); k++) {
        char prefix[SCHEMA_KEY_MAX];
        if (node->implied) /* named as the user wrote it: particles.file */
            snprintf(prefix, sizeof(prefix), "%.*s", (int)(strlen(key) - strlen(row->key)), key);
        else
            snprintf(prefix, sizeof(prefix), "%.200s[%zu].", key, k);
        good = read_table(reader, row->sub, node->child[k], prefix,
                          schema_elements(row, base) + (size_t)count * row->size) &&
               good;
        count++;
        memcpy(base + row->count_offset, &count, sizeof(count));
    }
    return good;
}

/* A row that the scene does not name: its default. */
static bool read_default(struct schema_reader *reader, const struct schema_row *row,
                         const struct tree_node *section, const char *key, char *base) {
    if (row->required && reader->doubtful)
        return false;
    if (row->required) {
        char allowed[2048];
        schema_allowed(row, allowed, sizeof(allowed));
        return schema_fail(reader, section, key, "is missing; needed: %s", allowed);
    }
    schema_unset(row, base);
    if (!row->fallback)
        return true;
    struct tree_node *node =
        tree_parse("(default)", row->fallback[0] ? row->fallback : "''", 1, reader->error);
    bool good = node && schema_value(reader, row, node, key, base);
    tree_free(&node);
    return good;
}

static bool read_row(struct schema_reader *reader, const struct schema_row *row,
                     const struct tree_node *section, const struct tree_node *node, const char *key,
                     char *base) {
    static const struct tree_node nothing = {.kind = TREE_MAP};
    char below[SCHEMA_KEY_MAX];
    if (row->type == SCHEMA_SECTION) {
        struct tree_node empty = nothing;
        empty.line = section->line;
        snprintf(below, sizeof(below), "%.*s.", (int)sizeof(below) - 2, key);
        if (row->optional && !node)
            return true;
        if (row->optional)
            *(int *)(base + row->count_offset) = 1;
        return read_table(reader, row->sub, node ? node : &empty, below, base + row->offset);
    }
    if (!node && row->type == SCHEMA_LIST && !row->required) {
        memcpy(base + row->count_offset, &row->first, sizeof(int));
        return true;
    }
    if (!node)
        return read_default(reader, row, section, key, base);
    if (row->type == SCHEMA_LIST)
        return read_list(reader, row, node, key, base);
    return schema_value(reader, row, node, key, base);
}

/* True if any row of this row's key exists. */
static bool key_applies(const struct schema_row *row, const struct schema_table *table, const char *base,
                        const char *root) {
    for (int k = 0; k < table->count; k++)
        if (strcmp(table->rows[k].key, row->key) == 0 && schema_applies(&table->rows[k], table, base, root))
            return true;
    return false;
}

/* Refuses a key no row of which exists. */
static bool misplaced(struct schema_reader *reader, const struct schema_row *row,
                      const struct schema_table *table, const struct tree_node *node, const char *key) {
    if (reader->doubtful)
        return false;
    char conditions[512] = "";
    for (int k = 0; k < table->count; k++) {
        if (strcmp(table->rows[k].key, row->key) != 0)
            continue;
        size_t used = strlen(conditions);
        snprintf(conditions + used, sizeof(conditions) - used, "%s", used ? ", or with " : "");
        schema_condition(&table->rows[k], conditions + strlen(conditions),
                         sizeof(conditions) - strlen(conditions));
    }
    return schema_fail(reader, node, key, "exists only with %s (--set %s=~ takes it out)", conditions, key);
}

/* True if conditions or references of other rows may ask for the value of a row. */
static bool decides(const struct schema_row *row) {
    return row->type == SCHEMA_NAME || row->type == SCHEMA_CHOICE || row->type == SCHEMA_LIST ||
           row->type == SCHEMA_SECTION;
}

/* Gives a row whose value was refused a value that the rest of the reading can bear: its default. */
static void refused(const struct schema_row *row, char *base) {
    struct error unused = {0};
    struct schema_reader reader = {.file = "", .folder = "", .root = base, .units = true, .error = &unused};
    struct schema_row optional = *row;
    optional.required = false;
    if (row->type != SCHEMA_SECTION && row->type != SCHEMA_LIST)
        read_default(&reader, &optional, NULL, "", base);
}

static bool read_table(struct schema_reader *reader, const struct schema_table *table,
                       const struct tree_node *node, const char *prefix, char *base) {
    if (node->kind != TREE_MAP) {
        char key[SCHEMA_KEY_MAX];
        snprintf(key, sizeof(key), "%.*s", (int)(prefix[0] ? strlen(prefix) - 1 : 0), prefix);
        bool named = node->kind == TREE_SCALAR && schema_row_find(table, "name", 4) && !is_empty(node);
        return named ? schema_fail(reader, node, key,
                                   "must be a section with keys (`key: value`); write {name: %.80s}",
                                   node->text)
                     : schema_fail(reader, node, key, "must be a section with keys (`key: value`)");
    }
    bool doubtful = reader->doubtful, good = schema_known_keys(reader, table, node, prefix);
    reader->doubtful = doubtful || !good; /* a key that seems to be missing may be among the unknown ones */
    for (int k = 0; k < table->count; k++) {
        const struct schema_row *row = &table->rows[k];
        char key[SCHEMA_KEY_MAX];
        snprintf(key, sizeof(key), "%.160s%s", prefix, row->key);
        const struct tree_node *child = tree_get(node, row->key);
        if (schema_applies(row, table, base, reader->root)) {
            if (!read_row(reader, row, node, child, key, base)) {
                refused(row, base);
                doubtful = doubtful || decides(row);
                reader->doubtful = reader->doubtful || doubtful;
                good = false;
            }
        } else if (child && schema_row_find(table, row->key, strlen(row->key)) == row &&
                   !key_applies(row, table, base, reader->root)) {
            good = misplaced(reader, row, table, child, key) && good;
        }
    }
    reader->doubtful = doubtful;
    return good;
}

bool schema_read(struct schema_reader *reader, const struct tree_node *root) {
    return read_table(reader, &schema_root, root, "", reader->root);
}
