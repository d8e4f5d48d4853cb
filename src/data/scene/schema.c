/* SPDX-License-Identifier: BSD-3-Clause */
/* Looks into the rows of the schema: finds, walks, suggests, names the allowed values. Read schema_rows.h
 * first. */
#include "data/scene/schema.h"
#include "data/scene/mistakes.h"
#include "data/scene/schema_root.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static bool is_word(const char *word, const char *text, size_t length) {
    return strlen(word) == length && memcmp(word, text, length) == 0;
}

const struct schema_row *schema_row_find(const struct schema_table *table, const char *key, size_t length) {
    for (int k = 0; k < table->count; k++)
        if (is_word(table->rows[k].key, key, length) ||
            (table->rows[k].alias && is_word(table->rows[k].alias, key, length)))
            return &table->rows[k];
    return NULL;
}

const struct schema_row *schema_short_list(const struct schema_table *table) {
    for (int k = 0; k < table->count; k++)
        if (table->rows[k].short_form)
            return &table->rows[k];
    return NULL;
}

/* Appends one key to a full key. */
static void lengthen(char full[SCHEMA_KEY_MAX], const struct schema_row *row) {
    size_t length = strlen(full);
    snprintf(full + length, SCHEMA_KEY_MAX - length, "%s%s%s", length ? "." : "", row->key,
             row->type == SCHEMA_LIST ? "[]" : "");
}

const struct schema_row *schema_find(const char *key, char full[SCHEMA_KEY_MAX]) {
    const struct schema_table *table = &schema_root;
    full[0] = '\0';
    for (;;) {
        size_t length = strcspn(key, ".[");
        const struct schema_row *row = schema_row_find(table, key, length);
        const struct schema_row *list = row ? NULL : schema_short_list(table);
        if (list) {
            row = schema_row_find(list->sub, key, length);
            lengthen(full, list);
        }
        if (!row)
            return NULL;
        lengthen(full, row);
        key += length;
        if (*key == '[')
            key += strcspn(key, "]") + (strchr(key, ']') != NULL);
        if (*key == '\0')
            return row;
        if (*key != '.' || !row->sub)
            return NULL;
        table = row->sub;
        key++;
    }
}

static void walk_table(const struct schema_table *table, const char *prefix, int depth,
                       void (*visit)(void *context, const struct schema_row *row, const char *key, int depth),
                       void *context) {
    for (int k = 0; k < table->count; k++) {
        char key[SCHEMA_KEY_MAX];
        snprintf(key, sizeof(key), "%.200s", prefix);
        lengthen(key, &table->rows[k]);
        visit(context, &table->rows[k], key, depth);
        if (table->rows[k].sub)
            walk_table(table->rows[k].sub, key, depth + 1, visit, context);
    }
}

void schema_walk(void (*visit)(void *context, const struct schema_row *row, const char *key, int depth),
                 void *context) {
    walk_table(&schema_root, "", 0, visit, context);
}

bool schema_fail(struct schema_reader *reader, const struct tree_node *node, const char *key,
                 const char *format, ...) {
    char place[1200], text[1024];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof(text), format, list);
    va_end(list);
    tree_place(node, reader->file, place, sizeof(place));
    char line[ERROR_TEXT_MAX];
    snprintf(line, sizeof(line), "%.700s: %.200s%s%s", place, key, key[0] ? ": " : "", text);
    return mistakes_add(reader->error, line);
}

/* Ranges. */

struct interval {
    double low, high;
    bool with_low, with_high;
};

static struct interval range_of(const struct schema_row *row) {
    if (!row->range)
        return (struct interval){-INFINITY, INFINITY, false, false};
    char *end;
    struct interval range = {.with_low = row->range[0] == '['};
    range.low = strtod(row->range + 1, &end);
    range.high = strtod(end + 1, &end);
    range.with_high = *end == ']';
    return range;
}

bool schema_in_range(const struct schema_row *row, double value) {
    struct interval range = range_of(row);
    return (value > range.low || (range.with_low && value == range.low)) &&
           (value < range.high || (range.with_high && value == range.high));
}

static void range_words(const struct schema_row *row, char *text, size_t room) {
    struct interval range = range_of(row);
    if (isinf(range.low) && isinf(range.high))
        text[0] = '\0';
    else if (isinf(range.high))
        snprintf(text, room, " %s %g", range.with_low ? ">=" : ">", range.low);
    else
        snprintf(text, room, " from %g%s to %g%s", range.low, range.with_low ? "" : " (excluded)", range.high,
                 range.with_high ? "" : " (excluded)");
}

/* Conditions. */

static bool name_is(const struct schema_row *row, const char *value, const char *alternatives,
                    size_t length) {
    const char *name = NULL;
    if (row->type == SCHEMA_CHOICE)
        name = value;
    for (int k = 0; row->type == SCHEMA_NAME && row->names[k].name; k++)
        if (row->names[k].value == *(const int *)value)
            name = row->names[k].name;
    while (name && length > 0) {
        size_t one = strcspn(alternatives, "| ");
        one = one < length ? one : length;
        if (strlen(name) == one && memcmp(name, alternatives, one) == 0)
            return true;
        size_t skip = one < length ? one + 1 : length;
        alternatives += skip;
        length -= skip;
    }
    return false;
}

/* True if the value of a row has a trait. */
static bool trait_is(const struct schema_row *row, int value, const char *trait, size_t length) {
    for (const char *t = row->traits && value >= 0 ? row->traits(value) : ""; *t; t += strspn(t, " ")) {
        size_t word = strcspn(t, " ");
        if (word == length && memcmp(t, trait, length) == 0)
            return true;
        t += word;
    }
    return false;
}

/* One condition "key=a|b" or "key:trait" of `length` bytes. */
static bool holds(const char *condition, size_t length, const struct schema_table *table, const char *base,
                  const char *root) {
    if (*condition == '/') {
        table = &schema_root;
        base = root;
        condition++;
        length--;
    }
    for (;;) {
        size_t part = strcspn(condition, ".=:");
        const struct schema_row *row = schema_row_find(table, condition, part);
        if (!row)
            return false;
        char mark = condition[part];
        condition += part + 1;
        length -= part + 1;
        base += row->offset;
        if (mark == '=')
            return name_is(row, base, condition, length);
        if (mark == ':')
            return trait_is(row, *(const int *)base, condition, length);
        table = row->sub;
    }
}

bool schema_applies(const struct schema_row *row, const struct schema_table *table, const char *base,
                    const char *root) {
    const char *condition = row->when;
    while (condition) {
        const char *end = strstr(condition, " & ");
        if (!holds(condition, end ? (size_t)(end - condition) : strlen(condition), table, base, root))
            return false;
        condition = end ? end + 3 : NULL;
    }
    return true;
}

/* Appends one condition of `length` bytes to a text: a trait as the names that have it. */
static void condition_words(const char *condition, size_t length, char *text, size_t room) {
    const struct schema_table *table = &schema_root;
    const struct schema_row *row = NULL;
    if (*condition == '/') {
        condition++;
        length--;
    }
    const char *colon = memchr(condition, ':', length), *separator = "=";
    size_t used = strlen(text), key = colon ? (size_t)(colon - condition) : length;
    snprintf(text + used, room - used, "%.*s", (int)key, condition);
    for (const char *part = condition; colon && part < colon; part += strcspn(part, ".:") + 1) {
        row = schema_row_find(table, part, strcspn(part, ".:"));
        table = row->sub;
    }
    for (int k = 0; row && row->names[k].name; k++) {
        if (!trait_is(row, row->names[k].value, colon + 1, length - key - 1))
            continue;
        used = strlen(text);
        snprintf(text + used, room - used, "%s%s", separator, row->names[k].name);
        separator = "|";
    }
}

void schema_condition(const struct schema_row *row, char *text, size_t room) {
    const char *condition = row->when;
    text[0] = '\0';
    while (condition) {
        const char *end = strstr(condition, " & ");
        condition_words(condition, end ? (size_t)(end - condition) : strlen(condition), text, room);
        size_t used = strlen(text);
        snprintf(text + used, room - used, "%s", end ? " & " : "");
        condition = end ? end + 3 : NULL;
    }
}

const char *schema_target_name(const char *root, const char *target, int k) {
    const struct schema_row *list = schema_row_find(&schema_root, target, strlen(target));
    const struct schema_row *name = schema_row_find(list->sub, "name", 4);
    if (k < 0 || k >= *(const int *)(root + list->count_offset))
        return NULL;
    return schema_elements(list, root) + (size_t)k * list->size + name->offset;
}

/* The allowed values, in words. */

const char *schema_value_name(const struct schema_row *row, int k) {
    const char *help;
    if (row->type == SCHEMA_CHOICE)
        return row->choice(k, &help);
    return row->type == SCHEMA_NAME ? row->names[k].name : NULL;
}

static void append_word(char *text, size_t room, const char *separator, const char *word) {
    size_t length = strlen(text);
    snprintf(text + length, room - length, "%s%s", separator, word);
}

static void name_words(const struct schema_row *row, char *text, size_t room) {
    snprintf(text, room, "one of");
    for (int k = 0; row->type == SCHEMA_NAME && row->names[k].name; k++)
        append_word(text, room, k ? ", " : " ", row->names[k].name);
    const char *help;
    for (int k = 0; row->type == SCHEMA_CHOICE && row->choice(k, &help); k++)
        append_word(text, room, k ? ", " : " ", row->choice(k, &help));
}

void schema_allowed(const struct schema_row *row, char *text, size_t room) {
    static const char *const words[] = {
        [SCHEMA_REAL] = "a number",
        [SCHEMA_VECTOR] = "three numbers [x, y, z]",
        [SCHEMA_REALS] = "a list of numbers",
        [SCHEMA_INT] = "a whole number",
        [SCHEMA_LONG] = "a whole number",
        [SCHEMA_LONGS] = "a list of whole numbers",
        [SCHEMA_SEED] = "a whole number from 0 to 2^64 - 1",
        [SCHEMA_BOOL] = "true or false (on, off, yes, no)",
        [SCHEMA_BOOLS] = "true or false, or three of them [x, y, z]",
        [SCHEMA_TEXT] = "text",
        [SCHEMA_TEXTS] = "a list of names",
        [SCHEMA_PATH] = "a path, relative to the scene file",
        [SCHEMA_REF] = "a name out of",
        [SCHEMA_REFS] = "a list of names out of",
        [SCHEMA_KEYS] = "keys of the scene, each with a value",
        [SCHEMA_SECTION] = "a section with keys of its own",
        [SCHEMA_LIST] = "a list of sections (`- key: value`)",
    };
    if (row->type == SCHEMA_NAME || row->type == SCHEMA_CHOICE) {
        name_words(row, text, room);
        return;
    }
    snprintf(text, room, "%s", words[row->type]);
    if (row->target)
        append_word(text, room, " ", row->target);
    if (row->in_column)
        append_word(text, room, " ",
                    row->in_column == SCHEMA_COLUMN_NAME
                        ? "without comma, double quote, square bracket, slash or control character"
                        : "without comma, double quote, square bracket or control character");
    char range[80] = "";
    if (row->type != SCHEMA_SEED)
        range_words(row, range, sizeof(range));
    append_word(text, room, "", range);
    if (row->type == SCHEMA_LIST) {
        snprintf(range, sizeof(range), ", up to %d", row->max - row->first);
        append_word(text, room, "", range);
    }
    if (row->unit && row->unit[0])
        append_word(text, room, ", in ", row->unit);
}
