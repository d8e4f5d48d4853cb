/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes report.json from the rows of the report. Read report_rows.h first. */
#include "data/observe/report_json.h"
#include "data/observe/report_rows.h"

#include "base/file.h"

#include <inttypes.h>
#include <math.h>

enum { TEXT_ROOM = 256 };

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

static void put_each(FILE *file, const uint64_t *value, int n) {
    fprintf(file, "[");
    for (int k = 0; k < n; k++)
        fprintf(file, "%s%" PRIu64, k ? ", " : "", value[k]);
    fprintf(file, "]");
}

/* A value that has no rows below it. */
static void put_value(FILE *file, const struct report *report, const struct report_row *row,
                      const void *base) {
    char text[TEXT_ROOM];
    switch (row->type) {
    case REPORT_COUNT:
        fprintf(file, "%" PRIu64, report_row_count(row, base));
        break;
    case REPORT_NUMBER:
        fprintf(file, "%d", report_row_number(row, base));
        break;
    case REPORT_REAL:
        put_real(file, report_row_real(row, base));
        break;
    case REPORT_FLAG:
        fprintf(file, "%s", report_row_flag(row, base) ? "true" : "false");
        break;
    case REPORT_TEXT:
        report_json_text(file, report_row_text(row, base, text, sizeof text));
        break;
    default:
        put_each(file, report_row_each(row, base), report->ranks);
    }
}

/* {"cells": 5, "particles": 6} */
static void put_object(FILE *file, const struct report *report, const struct report_row *rows,
                       const void *base) {
    fprintf(file, "{");
    for (const struct report_row *row = rows; row->name; row++) {
        if (row->terminal)
            continue;
        fprintf(file, "%s\"%s\": ", row > rows ? ", " : "", row->name);
        put_value(file, report, row, base);
    }
    fprintf(file, "}");
}

static void put_list(FILE *file, const struct report *report, const struct report_row *row) {
    int entries = report_row_entries(row, report);
    fprintf(file, "[");
    for (int k = 0; k < entries; k++) {
        fprintf(file, "%s\n    ", k ? "," : "");
        put_object(file, report, row->rows, report_row_entry(row, report, k));
    }
    fprintf(file, "%s]", entries ? "\n  " : "");
}

static void put_stages(FILE *file, const struct report *report, const struct report_row *row) {
    const struct report_stage *stage = (const void *)((const char *)report + row->offset);
    fprintf(file, "{");
    for (int s = 0; s < report->stages; s++) {
        fprintf(file, "%s\n    \"%s\": ", s ? "," : "", stage[s].name);
        put_object(file, report, row->rows, &stage[s]);
    }
    fprintf(file, "\n  }");
}

bool report_write_json(const struct report *report, const char *path, struct error *error) {
    struct file_new file;
    if (!file_new_open(&file, path, error))
        return false;
    fprintf(file.stream, "{");
    for (const struct report_row *row = report_rows; row->name; row++) {
        if (row->terminal || (row->shown && !row->shown(report)))
            continue;
        fprintf(file.stream, "%s\n  \"%s\": ", row > report_rows ? "," : "", row->name);
        if (row->type == REPORT_GROUP)
            put_object(file.stream, report, row->rows, report);
        else if (row->type == REPORT_LIST)
            put_list(file.stream, report, row);
        else if (row->type == REPORT_STAGES)
            put_stages(file.stream, report, row);
        else
            put_value(file.stream, report, row, report);
    }
    fprintf(file.stream, "\n}\n");
    return file_new_close(&file, error);
}
