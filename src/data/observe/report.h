/* SPDX-License-Identifier: BSD-3-Clause */
/* A report: one row an entry. A row has the name, the unit and the meaning of an entry, and the getter of its value.
 * report_make calls the getters and keeps the values. report_print.h prints the report on the terminal, report_json.h
 * writes DIR/report.json, and describe.h writes the description of the rows in docs/output.md.
 *
 * A new entry is a row with its getter (engine/run_report.c) and, if the terminal shows it, its name in a line there. */
#ifndef SCREE_OBSERVE_REPORT_H
#define SCREE_OBSERVE_REPORT_H

#include "kernel/comm/comm.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What the getters read; the owner of the rows defines it. */
struct report_source;

enum report_shape {
    REPORT_VALUE, /* one value */
    REPORT_GROUP, /* values under one name: `rows` */
    REPORT_LIST,  /* entries, each with the values of `rows` */
    REPORT_STAGES /* the same, each under its name, which is the first of the rows */
};

struct report_row {
    const char *name; /* key in report.json; NULL behind the last row */
    const char *unit; /* in SI; "1" for a pure number, "" for an entry without a number */
    const char *help; /* for docs/output.md */
    /* The getter of a value: one of these. `k` is the number of the entry in a list, else 0. All ranks call all getters in
     * the order of the rows, outside parallel regions, so a getter may be collective. Rank 0 writes its own value. */
    uint64_t (*count)(const struct report_source *source, int k);
    double (*real)(const struct report_source *source, int k);
    bool (*flag)(const struct report_source *source, int k);
    const char *(*text)(const struct report_source *source, int k, char *buffer, size_t room);
    uint64_t (*each)(const struct report_source *source, int k); /* this rank's; the report has one a rank */
    /* Of other shapes: their rows, and the number of entries, the same on all ranks; NULL: 1. */
    enum report_shape shape;
    const struct report_row *rows;
    int (*entries)(const struct report_source *source);
    bool optional; /* not in report.json if it has no entries */
    /* The form on the terminal. A format for a double; without one a count has its digits in groups of three. "rank|ranks":
     * the count and the word behind 1 or behind others. Of a flag: "on|off". */
    const char *print;
    double times;  /* the terminal shows so many times the value; 0: the value itself */
    bool terminal; /* on the terminal alone, not in report.json */
};

union report_value {
    uint64_t count; /* also a flag, and a value a rank */
    double real;
    char *text; /* owned */
};

struct report_table;

/* The values of one row. */
struct report_column {
    union report_value *value;  /* one an entry; of `each` one a rank. Owned, as the next */
    struct report_table *table; /* of another shape than a value; else NULL */
};

struct report_table {
    const struct report_row *rows; /* borrowed */
    int entries;                   /* of a list; else 1, or 0 if it is absent */
    struct report_column *column;  /* one a row; owned */
};

struct report {
    int ranks;
    struct report_table table;
};

/* Makes a report of these rows by their getters; report_destroy frees it. Collective. */
void report_make(struct report *report, const struct report_row *rows, const struct comm *comm,
                 const struct report_source *source);
void report_destroy(struct report *report);

/* The row of a name, of which `length` bytes count, in a table, and the column of its values. "choice.why" is a row of the
 * group "choice". NULL if there is none. */
const struct report_row *report_find(const struct report_table *table, const char *name, size_t length,
                                     const struct report_column **column);

/* The list of a name in a report. */
const struct report_table *report_list(const struct report *report, const char *name);

/* The value of a row, which must exist, in entry `k` of a table: a number (a flag is 0 or 1), a text. */
double report_list_number(const struct report_table *table, int k, const char *name);
const char *report_list_text(const struct report_table *table, int k, const char *name);

/* The same of the report itself. */
double report_number(const struct report *report, const char *name);
const char *report_text(const struct report *report, const char *name);

/* True if a value of entry `k` is not 0, a text is not empty, or a list has entries. */
bool report_holds(const struct report_table *table, int k, const char *name);

#endif
