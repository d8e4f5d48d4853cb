/* SPDX-License-Identifier: BSD-3-Clause */
/* From the tree, whose short forms are resolved (schema_normalise.h), to the struct. Rows that do not apply are
 * left as they are (the struct comes zeroed): two keys may share a place. */
#include "scene/schema_read.h"
#include "core/memory.h"
#include "scene/mistakes.h"
#include "scene/schema_normalise.h"
#include "scene/schema_root.h"
#include "scene/schema_unknown.h"
#include "scene/schema_value.h"

#include <stdlib.h>
#include <string.h>

static bool is_empty(const struct tree_node *node) {
    return node->kind == TREE_SCALAR && !node->quoted &&
           (!node->text[0] || strcmp(node->text, "~") == 0 || strcmp(node->text, "null") == 0);
}

/* The place of a setting on its way down the tree. */
struct descent {
    struct schema_reader *reader;
    const struct schema_table *table; /* NULL: below a list of plain values */
    struct tree_node *node;           /* the section */
    const struct tree_node *value;    /* the value to set; names the place in messages */
    const char *whole;
    bool out; /* the value is null: the present entry is taken out */
};

/* The number in "[3]" at *key, which is moved behind it. */
static bool read_number(struct descent *descent, const char **key, size_t *number) {
    char *end;
    *number = strtoul(*key + 1, &end, 10);
    if (*end != ']' || end == *key + 1)
        return schema_fail(descent->reader, descent->value, descent->whole,
                           "the number in brackets is missing");
    *key = end + 1;
    return true;
}

/* The child under `name`, made if it is not there. */
static struct tree_node *child_or_new(struct tree_node *node, const char *name, enum tree_kind kind,
                                      long line) {
    if (!tree_get(node, name))
        tree_put(node, name, tree_new(kind, line));
    return tree_get(node, name);
}

/* Element `number` of a list, or a new one at its end. */
static struct tree_node *element_of(struct descent *descent, struct tree_node *list, size_t number) {
    if (!descent->out && list->kind == TREE_LIST && number == list->children)
        tree_append(list, tree_new(TREE_MAP, 0));
    if (list->kind == TREE_LIST && number < list->children)
        return list->child[number];
    schema_fail(descent->reader, descent->value, descent->whole,
                "there is no such number: the list has %zu, counted from 0", list->children);
    return NULL;
}

/* Frees entry `k` of a mapping or list. */
static void drop(struct tree_node *node, size_t k) {
    struct tree_node *child = tree_take(node, k);
    tree_free(&child);
}

static void drop_key(struct tree_node *map, const char *name) {
    for (size_t k = map->children; k-- > 0;)
        if (strcmp(map->key[k], name) == 0)
            drop(map, k);
}

/* Replaces entry `number` of a list, or takes it out; of a list of sections one more may be appended. */
static bool replace_item(struct descent *descent, const struct schema_row *row, struct tree_node *list,
                         size_t number, struct tree_node *value) {
    if (!descent->out && row->sub && list->kind == TREE_LIST && number == list->children) {
        tree_append(list, value);
        return true;
    }
    if (list->kind != TREE_LIST || number >= list->children)
        return schema_fail(descent->reader, value, descent->whole,
                           "there is no such number in the scene's list, counted from 0");
    if (descent->out) {
        drop(list, number);
        return true;
    }
    tree_free(&list->child[number]);
    list->child[number] = value;
    return true;
}

/* A key that is to be taken out and is not there: nothing to do, if the key could be there. */
static bool absent(struct descent *descent) {
    char full[SCHEMA_KEY_MAX];
    return schema_find(descent->whole, full) ||
           schema_fail(descent->reader, descent->value, descent->whole, "not a key; `scree help` lists all");
}

/* Steps into the section's short-form list, where `name` is a key of its elements. */
static bool step_into_short_form(struct descent *descent, const char *name, size_t length) {
    const struct schema_row *list_row = schema_short_list(descent->table);
    if (!list_row || schema_row_find(descent->table, name, length) ||
        !schema_row_find(list_row->sub, name, length))
        return true;
    struct tree_node *list = child_or_new(descent->node, list_row->key, TREE_LIST, 0);
    if (list->kind == TREE_LIST && list->children == 0)
        list->implied = true;
    if (list->children > 1)
        return schema_fail(descent->reader, descent->value, descent->whole,
                           "there are %zu %s: name one, as in %s[0]", list->children, list_row->key,
                           list_row->key);
    descent->node = element_of(descent, list, 0);
    descent->table = list_row->sub;
    return descent->node != NULL;
}

/* Puts `value` (taken over on success) at the place of `key`, or takes out the entry there (`value` stays the
 * caller's). */
static bool put_setting(struct descent *descent, const char *key, struct tree_node *value) {
    for (;;) {
        size_t length = strcspn(key, ".["), number;
        if (!step_into_short_form(descent, key, length))
            return false;
        const struct schema_row *row = schema_row_find(descent->table, key, length);
        char name[SCHEMA_KEY_MAX];
        snprintf(name, sizeof(name), "%.*s", (int)length, key);
        if (row && strcmp(row->key, name) != 0) {
            snprintf(descent->reader->note, SCHEMA_NOTE_MAX, "%.120s is an older name of %.60s",
                     descent->whole, row->key);
            snprintf(name, sizeof(name), "%s", row->key);
        }
        if (!row || descent->node->kind != TREE_MAP) {
            char section[SCHEMA_KEY_MAX];
            snprintf(section, sizeof(section), "%.*s", (int)(key - descent->whole), descent->whole);
            return schema_unknown(descent->reader, descent->node->kind == TREE_MAP ? descent->table : NULL,
                                  value, section, name, true);
        }
        if (descent->out && !tree_get(descent->node, name))
            return absent(descent);
        key += length;
        if (*key == '\0') {
            bool named =
                value->kind == TREE_SCALAR && row->file_key && strcmp(value->text, row->file_name) == 0;
            if (row->file_key && !named && tree_get(descent->node, row->file_key))
                drop_key(descent->node, row->file_key); /* another name, or another file */
            if (descent->out)
                drop_key(descent->node, name);
            else
                tree_put(descent->node, name, value);
            return true;
        }
        enum tree_kind kind = row->type == SCHEMA_SECTION ? TREE_MAP : TREE_LIST;
        struct tree_node *child = child_or_new(descent->node, name, kind, 0);
        if (*key == '[') {
            if (!read_number(descent, &key, &number))
                return false;
            if (*key == '\0')
                return replace_item(descent, row, child, number, value);
            child = element_of(descent, child, number);
        }
        if (!child)
            return false;
        if (*key != '.' || !row->sub)
            return schema_fail(descent->reader, value, descent->whole, "not a key; `scree help` lists all");
        key++;
        descent->node = child;
        descent->table = row->sub;
    }
}

bool schema_set(struct schema_reader *reader, struct tree_node *root, const char *text) {
    const char *equals = strchr(text, '=');
    if (!equals || equals == text || equals - text >= SCHEMA_KEY_MAX)
        return error_set(reader->error, ERROR_USER, "command line: --set %.200s: write it as --set key=value",
                         text);
    char key[SCHEMA_KEY_MAX];
    snprintf(key, sizeof(key), "%.*s", (int)(equals - text), text);
    struct tree_node *value = tree_parse(reader->file, equals[1] ? equals + 1 : "''", 0, reader->error);
    if (!value)
        return false;
    struct descent descent = {
        .reader = reader, .table = &schema_root, .node = root, .value = value, .whole = key};
    descent.out = is_empty(value);
    bool good = put_setting(&descent, key, value);
    if (!good || descent.out)
        tree_free(&value);
    return good && schema_normalise(reader, root);
}

/* Reading. */

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
    bool good = true;
    for (size_t k = 0; k < node->children && !mistakes_full(reader->error); k++) {
        char prefix[SCHEMA_KEY_MAX];
        if (node->implied) /* named as the user wrote it: particles.file */
            snprintf(prefix, sizeof(prefix), "%.*s", (int)(strlen(key) - strlen(row->key)), key);
        else
            snprintf(prefix, sizeof(prefix), "%.200s[%zu].", key, k);
        good = read_table(reader, row->sub, node->child[k], prefix,
                          base + row->offset + (size_t)count * row->size) &&
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
