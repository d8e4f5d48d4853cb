/* SPDX-License-Identifier: BSD-3-Clause */
/* The echo: the effective values as YAML that reads back to the same scene. A value that its own row would
 * refuse stands for "not given" and is left out, as are empty texts and lists. */
#include "data/scene/schema_output.h"
#include "data/scene/schema.h"
#include "data/scene/schema_root.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct writer {
    FILE *out;
    const char *root, *working;
};

/* The shortest decimal form that reads back to the same double. */
static void write_number(FILE *out, double value) {
    if (isinf(value)) {
        fprintf(out, "%s.inf", value < 0 ? "-" : "");
        return;
    }
    char text[32];
    for (int digits = 6; digits <= 17; digits++) {
        snprintf(text, sizeof(text), "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    fprintf(out, "%s", text);
}

/* Text in double quotes, so that no YAML reader takes it for anything else. */
static void write_quoted(FILE *out, const char *prefix, const char *text) {
    fprintf(out, "\"");
    for (int part = 0; part < 2; part++)
        for (const char *c = part ? text : prefix; *c; c++) {
            if (*c == '"' || *c == '\\')
                fprintf(out, "\\%c", *c);
            else if ((unsigned char)*c < 0x20 || *c == 0x7f)
                fprintf(out, "\\x%02x", (unsigned char)*c);
            else
                fputc(*c, out);
        }
    fprintf(out, "\"");
}

static const char *name_of(const struct schema_row *row, const char *value) {
    int number;
    memcpy(&number, value, sizeof(number));
    for (int k = 0; row->names[k].name; k++)
        if (row->names[k].value == number)
            return row->names[k].name;
    return NULL;
}

static int count_of(const struct schema_row *row, const char *base) {
    int count;
    memcpy(&count, base + row->count_offset, sizeof(count));
    return count;
}

/* True if the value at hand is one that a scene could have given. */
static bool is_given(const struct schema_row *row, const char *base) {
    const char *value = base + row->offset;
    switch (row->type) {
    case SCHEMA_REAL:
        return schema_in_range(row, *(const double *)value);
    case SCHEMA_VECTOR:
        return schema_in_range(row, *(const double *)value);
    case SCHEMA_INT:
        return schema_in_range(row, *(const int *)value);
    case SCHEMA_LONG:
        return schema_in_range(row, (double)*(const int64_t *)value);
    case SCHEMA_SEED:
    case SCHEMA_BOOL:
    case SCHEMA_BOOLS:
        return true;
    case SCHEMA_NAME:
        return name_of(row, value) != NULL;
    case SCHEMA_REF:
        return *(const int *)value >= 0;
    case SCHEMA_CHOICE:
    case SCHEMA_TEXT:
    case SCHEMA_PATH:
    case SCHEMA_KEYS:
        return value[0] != '\0';
    default:
        return count_of(row, base) > 0;
    }
}

static void write_items(const struct writer *writer, const struct schema_row *row, const char *base) {
    fprintf(writer->out, "[");
    for (int k = 0; k < count_of(row, base); k++) {
        const char *value = base + row->offset + (size_t)k * row->size;
        if (k)
            fprintf(writer->out, ", ");
        if (row->type == SCHEMA_REALS)
            write_number(writer->out, *(const double *)value);
        else if (row->type == SCHEMA_LONGS)
            fprintf(writer->out, "%lld", (long long)*(const int64_t *)value);
        else if (row->type == SCHEMA_TEXTS)
            write_quoted(writer->out, "", value);
        else
            write_quoted(writer->out, "", schema_target_name(writer->root, row->target, *(const int *)value));
    }
    fprintf(writer->out, "]");
}

static void write_triple(const struct writer *writer, const struct schema_row *row, const char *value) {
    for (int d = 0; d < 3; d++) {
        fprintf(writer->out, d ? ", " : "[");
        if (row->type == SCHEMA_VECTOR)
            write_number(writer->out, ((const double *)value)[d]);
        else
            fprintf(writer->out, "%s", ((const bool *)value)[d] ? "true" : "false");
    }
    fprintf(writer->out, "]");
}

static void write_value(const struct writer *writer, const struct schema_row *row, const char *base) {
    const char *value = base + row->offset;
    FILE *out = writer->out;
    switch (row->type) {
    case SCHEMA_REAL:
        write_number(out, *(const double *)value);
        break;
    case SCHEMA_VECTOR:
    case SCHEMA_BOOLS:
        write_triple(writer, row, value);
        break;
    case SCHEMA_INT:
        fprintf(out, "%d", *(const int *)value);
        break;
    case SCHEMA_LONG:
        fprintf(out, "%lld", (long long)*(const int64_t *)value);
        break;
    case SCHEMA_SEED:
        fprintf(out, "%llu", (unsigned long long)*(const uint64_t *)value);
        break;
    case SCHEMA_BOOL:
        fprintf(out, "%s", *(const bool *)value ? "true" : "false");
        break;
    case SCHEMA_NAME:
        fprintf(out, "%s", name_of(row, value));
        break;
    case SCHEMA_CHOICE:
    case SCHEMA_KEYS:
        fprintf(out, "%s", value);
        break;
    case SCHEMA_TEXT:
        write_quoted(out, "", value);
        break;
    case SCHEMA_PATH:
        write_quoted(out, value[0] == '/' ? "" : writer->working, value);
        break;
    case SCHEMA_REF:
        write_quoted(out, "", schema_target_name(writer->root, row->target, *(const int *)value));
        break;
    default:
        write_items(writer, row, base);
    }
}

/* True if anything below this row would be written. */
static bool has_content(const struct writer *writer, const struct schema_row *row,
                        const struct schema_table *table, const char *base) {
    if (!schema_applies(row, table, base, writer->root))
        return false;
    if (row->type == SCHEMA_LIST)
        return count_of(row, base) > row->first;
    if (row->type != SCHEMA_SECTION)
        return is_given(row, base);
    if (row->optional && *(const int *)(base + row->count_offset) == 0)
        return false;
    for (int k = 0; k < row->sub->count; k++)
        if (has_content(writer, &row->sub->rows[k], row->sub, base + row->offset))
            return true;
    return false;
}

/* Writes a section; the first line of a list's element begins with "- ". */
static void write_table(const struct writer *writer, const struct schema_table *table, const char *base,
                        int indent, bool dash) {
    for (int k = 0; k < table->count; k++) {
        const struct schema_row *row = &table->rows[k];
        if (!has_content(writer, row, table, base))
            continue;
        fprintf(writer->out, "%*s%s%s:", dash ? indent - 2 : indent, "", dash ? "- " : "", row->key);
        dash = false;
        if (row->type == SCHEMA_SECTION) {
            fprintf(writer->out, "\n");
            write_table(writer, row->sub, base + row->offset, indent + 2, false);
        } else if (row->type == SCHEMA_LIST) {
            fprintf(writer->out, "\n");
            for (int e = row->first; e < count_of(row, base); e++)
                write_table(writer, row->sub, schema_elements(row, base) + (size_t)e * row->size, indent + 4,
                            true);
        } else {
            fprintf(writer->out, " ");
            write_value(writer, row, base);
            fprintf(writer->out, "\n");
        }
    }
}

void schema_write(FILE *out, const void *root, const char *working) {
    struct writer writer = {.out = out, .root = root, .working = working};
    write_table(&writer, &schema_root, root, 0, false);
}
