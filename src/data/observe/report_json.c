/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes report.json from the rows of the report. Read report.h first. */
#include "data/observe/report_json.h"

#include "base/file.h"

#include <inttypes.h>
#include <math.h>

void report_json_text(FILE *file, const char *text) {
    fputc('"', file);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\')
            fprintf(file, "\\%c", *c);
        else if (*c < 0x20)
            fprintf(file, "\\u%04x", *c);
        else
            fputc(*c, file);
    }
    fputc('"', file);
}

/* JSON has no infinities and no NaN. */
static void put_real(FILE *file, double value) {
    if (isfinite(value))
        fprintf(file, "%.9g", value);
    else
        fprintf(file, "null");
}

static void put_value(FILE *file, const struct report_row *row, union report_value value) {
    if (row->text)
        report_json_text(file, value.text);
    else if (row->real)
        put_real(file, value.real);
    else if (row->flag)
        fprintf(file, "%s", value.count ? "true" : "false");
    else
        fprintf(file, "%" PRIu64, value.count);
}

static void put_each(FILE *file, const struct report_row *row, const union report_value *value, int n) {
    fprintf(file, "[");
    for (int k = 0; k < n; k++) {
        fprintf(file, "%s", k ? ", " : "");
        put_value(file, row, value[k]);
    }
    fprintf(file, "]");
}

/* {"cells": 5, "particles": 6}: the rows of an entry from number `first` on */
static void put_entry(FILE *file, const struct report_table *table, int first, int k) {
    const char *comma = "";
    fprintf(file, "{");
    for (int r = first; table->rows[r].name; r++) {
        if (table->rows[r].terminal)
            continue;
        fprintf(file, "%s\"%s\": ", comma, table->rows[r].name);
        put_value(file, &table->rows[r], table->column[r].value[k]);
        comma = ", ";
    }
    fprintf(file, "}");
}

static void put_list(FILE *file, const struct report_table *table, bool named) {
    fprintf(file, named ? "{" : "[");
    for (int k = 0; k < table->entries; k++) {
        fprintf(file, "%s\n    ", k ? "," : "");
        if (named)
            fprintf(file, "\"%s\": ", table->column[0].value[k].text);
        put_entry(file, table, named, k);
    }
    fprintf(file, "%s%s", table->entries ? "\n  " : "", named ? "}" : "]");
}

static void put_column(FILE *file, const struct report *report, const struct report_row *row,
                       const struct report_column *column) {
    if (row->each)
        put_each(file, row, column->value, report->ranks);
    else if (row->shape == REPORT_VALUE)
        put_value(file, row, column->value[0]);
    else if (row->shape == REPORT_GROUP)
        put_entry(file, column->table, 0, 0);
    else
        put_list(file, column->table, row->shape == REPORT_STAGES);
}

void report_json(const struct report *report, FILE *file) {
    const char *comma = "";
    fprintf(file, "{");
    for (int r = 0; report->table.rows[r].name; r++) {
        const struct report_row *row = &report->table.rows[r];
        const struct report_column *column = &report->table.column[r];
        if (row->terminal || (row->optional && column->table->entries == 0))
            continue;
        fprintf(file, "%s\n  \"%s\": ", comma, row->name);
        put_column(file, report, row, column);
        comma = ",";
    }
    fprintf(file, "\n}\n");
}

bool report_write_json(const struct report *report, const char *path, struct error *error) {
    struct file_new file;
    if (!file_new_open(&file, path, error))
        return false;
    report_json(report, file.stream);
    return file_new_close(&file, error);
}
