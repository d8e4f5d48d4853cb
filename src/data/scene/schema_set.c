/* SPDX-License-Identifier: BSD-3-Clause */
/* Puts a value at a full key of the tree: settings of the command line, and those of a stage. Read schema_read.h
 * first. */
#include "base/memory.h"
#include "data/scene/schema_normalise.h"
#include "data/scene/schema_read.h"
#include "data/scene/schema_root.h"
#include "data/scene/schema_unknown.h"

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

/* An element of a list as a key names it. */
struct place {
    size_t number;             /* from 0; the length of the list: a new element */
    char name[SCHEMA_KEY_MAX]; /* as given; "": by number, or the elements have no names */
};

/* True if `text` (`length` bytes) names an element: by its name, or by the materials between which it holds, as in
 * "glass, steel". */
static bool is_called(const struct tree_node *element, const char *text, size_t length) {
    const struct tree_node *name = element->kind == TREE_MAP ? tree_get(element, "name") : NULL;
    const struct tree_node *between = element->kind == TREE_MAP ? tree_get(element, "between") : NULL;
    if (name && name->kind == TREE_SCALAR)
        return strlen(name->text) == length && memcmp(name->text, text, length) == 0;
    if (!between || between->kind != TREE_LIST || between->children != 2 ||
        between->child[0]->kind != TREE_SCALAR || between->child[1]->kind != TREE_SCALAR)
        return false;
    for (int turned = 0; turned < 2; turned++) {
        char both[SCHEMA_KEY_MAX];
        int used = snprintf(both, sizeof(both), "%.100s, %.100s", between->child[turned]->text,
                            between->child[1 - turned]->text);
        if ((size_t)used == length && memcmp(both, text, length) == 0)
            return true;
    }
    return false;
}

/* True if the elements of a list hold between two materials, and `name` names two. */
static bool names_pair(const struct schema_table *table, const char *name, size_t length) {
    return schema_row_find(table, "between", 7) && memchr(name, ',', length);
}

/* Writes what names an element in brackets: its name, its two materials, or its number. */
static void label_of(const struct tree_node *element, size_t number, char *text, size_t room) {
    const struct tree_node *name = element->kind == TREE_MAP ? tree_get(element, "name") : NULL;
    const struct tree_node *between = element->kind == TREE_MAP ? tree_get(element, "between") : NULL;
    bool pair = between && between->kind == TREE_LIST && between->children == 2 && between->child[0]->text &&
                between->child[1]->text;
    if (name && name->kind == TREE_SCALAR)
        snprintf(text, room, "%.100s", name->text);
    else if (pair)
        snprintf(text, room, "'%.100s, %.100s'", between->child[0]->text, between->child[1]->text);
    else
        snprintf(text, room, "%zu", number);
}

/* Refuses a name in brackets that no element has. */
static bool refuse_name(struct descent *descent, const struct schema_table *table,
                        const struct tree_node *list, const char *name, size_t length) {
    char known[512] = "", label[256], remedy[SCHEMA_KEY_MAX + 80] = "";
    for (size_t k = 0; k < list->children; k++) {
        size_t used = strlen(known);
        label_of(list->child[k], k, label, sizeof(label));
        snprintf(known + used, sizeof(known) - used, "%s%s", used ? ", " : "", label);
    }
    if (names_pair(table, name, length) && !descent->out)
        snprintf(remedy, sizeof(remedy),
                 "; %.*s={...} adds an entry, and one without 'between' serves all other pairs",
                 (int)(name + length + 1 - descent->whole), descent->whole);
    return schema_fail(descent->reader, descent->value, descent->whole,
                       "nothing in this list is called '%.*s'; known: %s%s", (int)length, name,
                       known[0] ? known : "nothing", remedy);
}

/* The element in the brackets at *key, which is moved behind the brackets: a number, or a name. A name that no element
 * has is that of a new element, if a whole element is given. */
static bool read_place(struct descent *descent, const struct schema_row *row, const struct tree_node *list,
                       const char **key, struct place *place) {
    char *end;
    const char *name = *key + 1;
    size_t length = strcspn(name, "]");
    *place = (struct place){.number = strtoul(name, &end, 10)};
    if (length == 0 || name[length] != ']' || (end != name + length && !row->sub))
        return schema_fail(descent->reader, descent->value, descent->whole,
                           "the number in brackets is missing");
    *key = name + length + 1;
    if (end == name + length)
        return true;
    bool named = schema_row_find(row->sub, "name", 4) != NULL || names_pair(row->sub, name, length);
    snprintf(place->name, sizeof(place->name), "%.*s", named ? (int)length : 0, name);
    for (size_t k = 0; k < list->children; k++)
        if (is_called(list->child[k], name, length)) {
            place->number = k;
            return true;
        }
    bool whole = **key == '\0' && !descent->out && named;
    place->number = list->children;
    return whole || refuse_name(descent, row->sub, list, name, length);
}

/* A text of the scene that stood in the brackets of a key. */
static struct tree_node *bracket_text(const char *from, size_t length, long line) {
    struct tree_node *text = tree_new(TREE_SCALAR, line);
    text->text = tree_text(from, length);
    text->quoted = true;
    return text;
}

/* Gives an element the name, or the two materials, that stood in the brackets, unless it has them. */
static void name_element(struct tree_node *element, const char *name) {
    const char *comma = strchr(name, ',');
    const char *key = comma ? "between" : "name";
    if (!name[0] || element->kind != TREE_MAP || tree_get(element, key))
        return;
    if (comma) {
        const char *second = comma + 1 + strspn(comma + 1, " ");
        struct tree_node *pair = tree_new(TREE_LIST, element->line);
        tree_append(pair, bracket_text(name, (size_t)(comma - name), element->line));
        tree_append(pair, bracket_text(second, strlen(second), element->line));
        tree_put(element, key, pair);
        return;
    }
    tree_put(element, key, bracket_text(name, strlen(name), element->line));
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

/* Replaces an entry of a list, or takes it out; of a list of sections one more may be appended. */
static bool replace_item(struct descent *descent, const struct schema_row *row, struct tree_node *list,
                         const struct place *place, struct tree_node *value) {
    size_t number = place->number;
    if (!descent->out && row->sub && list->kind == TREE_LIST && number == list->children) {
        name_element(value, place->name);
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
    name_element(value, place->name);
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
        size_t length = strcspn(key, ".[");
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
            struct place place;
            if (!read_place(descent, row, child, &key, &place))
                return false;
            if (*key == '\0')
                return replace_item(descent, row, child, &place, value);
            child = element_of(descent, child, place.number);
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

bool schema_put(struct schema_reader *reader, struct tree_node *root, const char *key,
                struct tree_node *value) {
    struct descent descent = {
        .reader = reader, .table = &schema_root, .node = root, .value = value, .whole = key};
    descent.out = is_empty(value);
    bool good = put_setting(&descent, key, value);
    if (!good || descent.out)
        tree_free(&value);
    return good && schema_normalise(reader, root);
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
    return schema_put(reader, root, key, value);
}
