/* SPDX-License-Identifier: BSD-3-Clause */
/* Text files that hold a table of numbers: one row a line, separated by blanks, commas or semicolons. Empty
 * lines and lines that begin with # are skipped, carriage returns are tolerated, and the first line is a
 * header if its first word is no number. */
#ifndef SCREE_BASE_NUMBERS_H
#define SCREE_BASE_NUMBERS_H

#include "base/error.h"
#include <stddef.h>
#include <stdint.h>

/* A table in memory. */
struct numbers {
    size_t rows;
    int columns;
    double *value;  /* rows x columns, row by row; all finite */
    uint32_t *line; /* of each row in the file, from 1 */
};

/* Reads a table of exactly `columns` numbers a row from a file. Fails (user, with file and line) if the file
 * cannot be read, a row has another number of words, or a word is no finite number. An empty table is no
 * error here. numbers_free releases. One thread. */
bool numbers_read(struct numbers *numbers, const char *path, int columns, struct error *error);

/* The same from a text in memory, which is changed; `path` is for messages. */
bool numbers_parse(struct numbers *numbers, char *text, const char *path, int columns, struct error *error);
void numbers_free(struct numbers *numbers);

/* Fails (user, with file and line) unless the first numbers of the rows, times, increase and there is a row; `row_text`
 * says what a row is ("t T"). */
bool numbers_check_times(const struct numbers *numbers, const char *path, const char *row_text,
                         struct error *error);

/* The last row whose time is not after t; the last but one at most, 0 at least. Needs numbers_check_times. Any thread. */
size_t numbers_row(const struct numbers *numbers, double t);

/* The numbers behind the time, columns - 1, at time t: linear between rows, constant before the first and after the
 * last. Needs numbers_check_times. Any thread. */
void numbers_at(const struct numbers *numbers, double t, double *value);

/* Reads a whole file; a zero byte follows the contents. NULL with an error (user) if the file cannot be read.
 * memory_free releases. */
char *numbers_load(const char *path, size_t *size, struct error *error);

/* Cuts the next line off a text: ends the line with a zero byte (also at a carriage return), moves *text
 * behind the line, and returns the start of the line; NULL at the end of the text. */
char *numbers_line(char **text);

/* Reads one number at *at and moves *at behind the number; false if no number stands there or other letters
 * follow the number. The value may be infinite or not a number. */
bool numbers_word(char **at, double *value);

#endif
