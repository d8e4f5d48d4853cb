/* SPDX-License-Identifier: BSD-3-Clause */
/* A row of a table that is written twice: as a line of a file with commas, and as a line of JSON. */
#ifndef SCREE_PROGRAM_TABULAR_H
#define SCREE_PROGRAM_TABULAR_H

#include <stdbool.h>
#include <stdio.h>

enum { TABULAR_CELLS_MAX = 384, TABULAR_NAME_MAX = 136, TABULAR_TEXT_MAX = 208 };

struct tabular {
    int count;
    struct {
        char name[TABULAR_NAME_MAX], text[TABULAR_TEXT_MAX];
        bool word; /* text, not a number */
    } cell[TABULAR_CELLS_MAX];
};

/* Each adds a cell; what has no room is left out. A number that is not finite has no value in JSON (null). */
void tabular_word(struct tabular *cells, const char *name, const char *text);
void tabular_number(struct tabular *cells, const char *name, const char *format, double value);

/* Write the names, the values with commas between, and the object of JSON; each ends its line, and flushes the file. */
void tabular_head(const struct tabular *cells, FILE *file);
void tabular_row(const struct tabular *cells, FILE *file);
void tabular_json(const struct tabular *cells, FILE *file);

#endif
