/* SPDX-License-Identifier: BSD-3-Clause */
/* The entries of a run report: one row an entry. The report on the terminal (report_print.c), report.json
 * (report_json.c) and their description in docs/output.md (describe.c) are written from these rows. A new entry is
 * a member of struct report, a line that fills it in engine/run_report.c, a row here and, if the terminal shows it,
 * its name in one of the lines of report_print.c. */
#ifndef SCREE_OBSERVE_REPORT_ROWS_H
#define SCREE_OBSERVE_REPORT_ROWS_H

#include "data/observe/report.h"
#include <stddef.h>

enum report_type {
    REPORT_COUNT,  /* uint64_t */
    REPORT_NUMBER, /* int */
    REPORT_REAL,   /* double */
    REPORT_FLAG,   /* bool */
    REPORT_TEXT,   /* char[] */
    REPORT_EACH,   /* uint64_t *: one a rank */
    REPORT_GROUP,  /* entries of the report under one name: `rows` */
    REPORT_LIST,   /* structs that `rows` describe */
    REPORT_STAGES  /* such structs, one a stage of timer.h, by its name */
};

struct report_row {
    const char *name; /* key in report.json; NULL behind the last row */
    const char *unit; /* in SI; "1" for a pure number, "" for an entry without a number */
    const char *help; /* for docs/output.md */
    enum report_type type;
    size_t offset; /* of the value in `struct report`, or in the struct of a list */
    double (*real)(const struct report *report); /* REAL: instead of a member; NULL: none */
    const char *(*text)(const void *base, char *buffer,
                        size_t room); /* TEXT: instead of a member; NULL: none */
    /* How the terminal shows it. REAL and COUNT: a format for a double; without one a COUNT has its digits in
     * groups of three. EACH: a format for the mean over ranks and steps; without one the sum. NUMBER: "rank|ranks",
     * the word behind 1 and behind others. FLAG: "on|off". */
    const char *print;
    double (*seen)(double value); /* the number that the terminal shows; NULL: the value itself */
    bool terminal;                /* on the terminal alone, not in report.json */
    bool (*shown)(const struct report *report); /* in report.json only if true; NULL: always */
    const struct report_row *rows;              /* GROUP, LIST, STAGES */
    size_t size, count_offset; /* LIST: bytes of a struct; offset of the int that counts the structs */
    bool apart;                /* LIST: at the offset is a pointer to the structs */
};

/* All entries, in the order of report.json; a row without a name ends them. */
extern const struct report_row report_rows[];

/* The row of a name ("steps", "index_choice.why"), of which `length` bytes count; NULL if there is none. */
const struct report_row *report_row_find(const struct report_row *rows, const char *name, size_t length);

/* The structs of a LIST: how many there are, and the k-th. */
int report_row_entries(const struct report_row *row, const struct report *report);
const void *report_row_entry(const struct report_row *row, const struct report *report, int k);

/* The value of a row of that type. `base` is the report, or the struct of a list. A text may be written into
 * `buffer`. */
uint64_t report_row_count(const struct report_row *row, const void *base);
int report_row_number(const struct report_row *row, const void *base);
double report_row_real(const struct report_row *row, const void *base);
bool report_row_flag(const struct report_row *row, const void *base);
const uint64_t *report_row_each(const struct report_row *row, const void *base);
const char *report_row_text(const struct report_row *row, const void *base, char *buffer, size_t room);

#endif
