/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads one value from a node into the place that the row gives. */
#include "data/scene/schema_value.h"
#include "data/scene/decimal.h"
#include "data/scene/schema_unknown.h"
#include "data/scene/units.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* True for "0,2", "1,5e-6" and "2,5 mm". */
static bool decimal_comma(const char *text) {
    static const char digits[] = "0123456789";
    size_t whole = strspn(text, "+-0123456789");
    return whole > 0 && text[whole] == ',' && strspn(text + whole + 1, digits) > 0 &&
           !strchr(text + whole + 1, ',');
}

bool schema_number(const char *text, const char *unit, bool units_allowed, double *value, char *why,
                   size_t room) {
    const char *end, *behind;
    if (decimal_comma(text)) {
        snprintf(why, room, "'%.80s' has a decimal comma; write a decimal point", text);
        return false;
    }
    if (!decimal_read(text, &end, value)) {
        snprintf(why, room, "'%.80s' is not a number", text);
        return false;
    }
    behind = end;
    end += strspn(end, " ");
    if (*end == '\0')
        return true;
    struct units_dimension wanted, given;
    struct units_scale scale, base;
    if (!units_parse(end, &scale, &given)) {
        char known[80] = "";
        units_symbols(unit ? unit : "", known, sizeof(known));
        snprintf(why, room, "'%.80s': '%.40s' is not a unit%s%s%s", text, end, known[0] ? "; those of " : "",
                 known[0] ? units_name(unit) : "", known[0] ? ": " : "");
        strncat(why, known, room - strlen(why) - 1);
        return false;
    }
    if (!units_allowed) {
        snprintf(why, room, "'%.80s': no units in a dimensionless scene (units: none)", text);
        return false;
    }
    units_parse(unit ? unit : "", &base, &wanted);
    if (!units_same(&given, &wanted)) {
        if (unit && unit[0])
            snprintf(why, room, "'%.80s': '%.40s' is not a unit of %s", text, end, units_name(unit));
        else
            snprintf(why, room, "'%.80s': a pure number has no unit", text);
        return false;
    }
    *value = isfinite(*value) ? decimal_shift(text, behind, scale.decimal) * scale.factor : *value;
    return true;
}

static bool is_null(const struct tree_node *node) {
    return node->kind == TREE_SCALAR && !node->quoted &&
           (!node->text[0] || strcmp(node->text, "~") == 0 || strcmp(node->text, "null") == 0);
}

/* Fails with `why` and the allowed values. */
static bool refuse(struct schema_reader *reader, const struct schema_row *row, const struct tree_node *node,
                   const char *key, const char *why) {
    char allowed[2048];
    struct schema_row shown = *row;
    shown.unit = reader->units ? row->unit : NULL;
    schema_allowed(&shown, allowed, sizeof(allowed));
    return schema_fail(reader, node, key, "%s; allowed: %s", why, allowed);
}

/* The node must be a scalar with a value. */
static bool want_scalar(struct schema_reader *reader, const struct schema_row *row,
                        const struct tree_node *node, const char *key) {
    if (node->kind == TREE_SCALAR && !is_null(node))
        return true;
    static const char *const kinds[] = {[TREE_SCALAR] = "no value is given",
                                        [TREE_LIST] = "a list stands here",
                                        [TREE_MAP] = "a section stands here"};
    return refuse(reader, row, node, key, kinds[node->kind]);
}

static bool read_real(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, double *value) {
    char why[256];
    if (!want_scalar(reader, row, node, key))
        return false;
    if (!schema_number(node->text, row->unit, reader->units, value, why, sizeof(why)))
        return refuse(reader, row, node, key, why);
    if (schema_in_range(row, *value))
        return true;
    snprintf(why, sizeof(why), "'%.80s' is out of range", node->text);
    return refuse(reader, row, node, key, why);
}

/* A whole number; 1e6 is one. */
static bool read_long(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, int64_t *value) {
    if (!want_scalar(reader, row, node, key))
        return false;
    char why[256];
    bool fits;
    snprintf(why, sizeof(why), "'%.80s' is not a whole number", node->text);
    double time;
    char unused[256];
    if (strcmp(row->key, "steps") == 0 && !decimal_whole(node->text, value, &fits) && reader->units &&
        schema_number(node->text, "s", true, &time, unused, sizeof(unused)))
        return schema_fail(reader, node, key, "'%.80s' is a time, not a number of steps; write {time: %.80s}",
                           node->text, node->text);
    if (!decimal_whole(node->text, value, &fits))
        return refuse(reader, row, node, key, why);
    snprintf(why, sizeof(why), "'%.80s' is out of range", node->text);
    bool narrow = row->type == SCHEMA_INT;
    return (fits && schema_in_range(row, (double)*value) &&
            (!narrow || (*value >= -INT32_MAX && *value <= INT32_MAX))) ||
           refuse(reader, row, node, key, why);
}

static bool read_seed(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, uint64_t *value) {
    if (!want_scalar(reader, row, node, key))
        return false;
    char *end;
    errno = 0;
    *value = strtoull(node->text, &end, 10);
    if (errno == 0 && *end == '\0' && node->text[0] >= '0' && node->text[0] <= '9')
        return true;
    char why[256];
    snprintf(why, sizeof(why), "'%.80s' is no seed", node->text);
    return refuse(reader, row, node, key, why);
}

static bool read_bool(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, bool *value) {
    static const char *const words[] = {"false", "true", "off", "on", "no", "yes"};
    if (!want_scalar(reader, row, node, key))
        return false;
    for (int k = 0; k < 6; k++)
        if (strcmp(node->text, words[k]) == 0) {
            *value = k % 2;
            return true;
        }
    char why[256];
    snprintf(why, sizeof(why), "'%.80s' is neither true nor false", node->text);
    return refuse(reader, row, node, key, why);
}

/* True if a text does not break a line of observables.csv, nor hide where a column's unit begins; a name no path, either. */
static bool fits_column(const char *text, enum schema_column use) {
    bool name = use == SCHEMA_COLUMN_NAME;
    if (name && (strcmp(text, ".") == 0 || strcmp(text, "..") == 0))
        return false;
    for (; *text; text++)
        if ((unsigned char)*text < ' ' || *text == 127 || strchr(",\"[]", *text) || (name && *text == '/'))
            return false;
    return true;
}

static bool read_text(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, char *value) {
    if (!want_scalar(reader, row, node, key))
        return false;
    if (row->required && !node->text[0])
        return refuse(reader, row, node, key, "the text is empty");
    if (row->in_column && !fits_column(node->text, row->in_column))
        return refuse(reader, row, node, key, "cannot be part of a column's name");
    if (strlen(node->text) >= row->size) {
        char why[80];
        snprintf(why, sizeof(why), "longer than %zu bytes", row->size - 1);
        return refuse(reader, row, node, key, why);
    }
    strcpy(value, node->text);
    return true;
}

static bool read_path(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, char *value) {
    if (!want_scalar(reader, row, node, key))
        return false;
    bool relative = node->text[0] != '/';
    int length = snprintf(value, row->size, "%s%s", relative ? reader->folder : "", node->text);
    return (node->text[0] && (size_t)length < row->size) ||
           refuse(reader, row, node, key, node->text[0] ? "the path is too long" : "the path is empty");
}

static bool read_name(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, char *value) {
    if (!want_scalar(reader, row, node, key))
        return false;
    const char *name, *near = NULL;
    int nearest = 1000;
    for (int k = 0; (name = schema_value_name(row, k)); k++) {
        size_t length = row->with_target ? strcspn(node->text, "/") : strlen(node->text);
        if (row->type == SCHEMA_CHOICE && strlen(name) == length && strncmp(node->text, name, length) == 0)
            return read_text(reader, row, node, key, value);
        if (strcmp(node->text, name) == 0) {
            memcpy(value, &row->names[k].value, sizeof(int));
            return true;
        }
        int distance = schema_distance(node->text, name);
        if (distance >= 0 && distance < nearest) {
            nearest = distance;
            near = name;
        }
    }
    char why[256];
    snprintf(why, sizeof(why), "'%.80s' is unknown%s%s%s", node->text, near ? " (did you mean '" : "",
             near ? near : "", near ? "'?)" : "");
    return refuse(reader, row, node, key, why);
}

static bool read_reference(struct schema_reader *reader, const struct schema_row *row,
                           const struct tree_node *node, const char *key, int *value) {
    if (!want_scalar(reader, row, node, key))
        return false;
    const char *name;
    char known[512] = "";
    for (int k = 0; (name = schema_target_name(reader->root, row->target, k)); k++) {
        if (strcmp(name, node->text) == 0) {
            *value = k;
            return true;
        }
        size_t length = strlen(known);
        snprintf(known + length, sizeof(known) - length, "%s%s", k ? ", " : "", name);
    }
    if (reader->doubtful) /* the list itself was refused, or is incomplete */
        return false;
    return schema_fail(reader, node, key, "'%.80s' is not one of the %s; known: %s", node->text, row->target,
                       known[0] ? known : "none");
}

/* Lists: the items of a list, or one bare value. */

static size_t item_count(const struct tree_node *node) {
    return node->kind == TREE_LIST ? node->children : 1;
}

static const struct tree_node *item_of(const struct tree_node *node, size_t k) {
    return node->kind == TREE_LIST ? node->child[k] : node;
}

static bool read_item(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, char *value) {
    switch (row->type) {
    case SCHEMA_REALS:
        return read_real(reader, row, node, key, (double *)value);
    case SCHEMA_LONGS:
        return read_long(reader, row, node, key, (int64_t *)value);
    case SCHEMA_TEXTS:
        return read_text(reader, row, node, key, value);
    default:
        return read_reference(reader, row, node, key, (int *)value);
    }
}

static bool read_items(struct schema_reader *reader, const struct schema_row *row,
                       const struct tree_node *node, const char *key, char *base) {
    size_t count = item_count(node);
    char why[80];
    snprintf(why, sizeof(why), "more than %d values", row->max);
    if (count > (size_t)row->max)
        return refuse(reader, row, node, key, why);
    if (count == 0 && row->required)
        return refuse(reader, row, node, key, "the list is empty");
    for (size_t k = 0; k < count; k++) {
        char name[SCHEMA_KEY_MAX];
        snprintf(name, sizeof(name), "%.200s[%zu]", key, k);
        if (!read_item(reader, row, item_of(node, k), node->kind == TREE_LIST ? name : key,
                       base + row->offset + k * row->size))
            return false;
    }
    int stored = (int)count;
    memcpy(base + row->count_offset, &stored, sizeof(stored));
    return true;
}

static bool read_vector(struct schema_reader *reader, const struct schema_row *row,
                        const struct tree_node *node, const char *key, double *value) {
    bool planar = reader->dimension && *reader->dimension == 2;
    if (node->kind != TREE_LIST || (node->children != 3 && !(planar && node->children == 2)))
        return refuse(reader, row, node, key, "not three numbers in brackets");
    value[2] = 0;
    for (size_t k = 0; k < node->children; k++)
        if (!read_real(reader, row, node->child[k], key, &value[k]))
            return false;
    return true;
}

static bool read_bools(struct schema_reader *reader, const struct schema_row *row,
                       const struct tree_node *node, const char *key, bool *value) {
    bool planar = reader->dimension && *reader->dimension == 2;
    if (node->kind == TREE_LIST && node->children != 3 && !(planar && node->children == 2))
        return refuse(reader, row, node, key, "not three values");
    value[2] = false;
    size_t count = node->kind == TREE_LIST ? node->children : planar ? 2 : 3;
    for (size_t k = 0; k < count; k++)
        if (!read_bool(reader, row, item_of(node, k), key, &value[k]))
            return false;
    return true;
}

/* A mapping, kept as text. */
static bool read_keys(struct schema_reader *reader, const struct schema_row *row,
                      const struct tree_node *node, const char *key, char *value) {
    if (is_null(node)) {
        value[0] = '\0';
        return true;
    }
    if (node->kind != TREE_MAP)
        return refuse(reader, row, node, key, "not a section with keys (`key: value`)");
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        error_fatal("out of memory while reading the scene");
    tree_write(out, node);
    fclose(out);
    bool fits = size < row->size;
    if (fits)
        memcpy(value, text, size + 1);
    free(text);
    return fits || refuse(reader, row, node, key, "too many keys");
}

bool schema_value(struct schema_reader *reader, const struct schema_row *row, const struct tree_node *node,
                  const char *key, char *base) {
    char *value = base + row->offset;
    int64_t number;
    switch (row->type) {
    case SCHEMA_REAL:
        return read_real(reader, row, node, key, (double *)value);
    case SCHEMA_VECTOR:
        return read_vector(reader, row, node, key, (double *)value);
    case SCHEMA_INT:
        if (!read_long(reader, row, node, key, &number))
            return false;
        *(int *)value = (int)number;
        return true;
    case SCHEMA_LONG:
        return read_long(reader, row, node, key, (int64_t *)value);
    case SCHEMA_SEED:
        return read_seed(reader, row, node, key, (uint64_t *)value);
    case SCHEMA_BOOL:
        return read_bool(reader, row, node, key, (bool *)value);
    case SCHEMA_BOOLS:
        return read_bools(reader, row, node, key, (bool *)value);
    case SCHEMA_NAME:
    case SCHEMA_CHOICE:
        return read_name(reader, row, node, key, value);
    case SCHEMA_TEXT:
        return read_text(reader, row, node, key, value);
    case SCHEMA_PATH:
        return read_path(reader, row, node, key, value);
    case SCHEMA_REF:
        return read_reference(reader, row, node, key, (int *)value);
    case SCHEMA_KEYS:
        return read_keys(reader, row, node, key, value);
    default:
        return read_items(reader, row, node, key, base);
    }
}

void schema_unset(const struct schema_row *row, char *base) {
    char *value = base + row->offset;
    int minus = -1, zero = 0;
    int64_t long_minus = -1;
    double nan_vector[3] = {NAN, NAN, NAN};
    switch (row->type) {
    case SCHEMA_REAL:
        memcpy(value, nan_vector, sizeof(double));
        break;
    case SCHEMA_VECTOR:
        memcpy(value, nan_vector, sizeof(nan_vector));
        break;
    case SCHEMA_INT:
    case SCHEMA_NAME:
    case SCHEMA_REF:
        memcpy(value, &minus, sizeof(minus));
        break;
    case SCHEMA_LONG:
        memcpy(value, &long_minus, sizeof(long_minus));
        break;
    case SCHEMA_REALS:
    case SCHEMA_LONGS:
    case SCHEMA_TEXTS:
    case SCHEMA_REFS:
    case SCHEMA_LIST:
        memcpy(base + row->count_offset, &zero, sizeof(zero));
        break;
    default:
        value[0] = '\0';
    }
}
