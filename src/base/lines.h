/* SPDX-License-Identifier: BSD-3-Clause */
/* Text files line by line, with the line number for messages. Files packed by gzip are unpacked on the
 * way. */
#ifndef SCREE_BASE_LINES_H
#define SCREE_BASE_LINES_H

#include "base/error.h"
#include <stdint.h>
#include <zlib.h>

struct lines {
    const char *path; /* borrowed */
    gzFile file;
    char *text; /* the line, without its end; owned by lines */
    size_t room;
    uint64_t number; /* number of the line, from 1 */
    bool whole;      /* the line ended with a newline */
    bool damaged;    /* the file could not be read, or not unpacked, to its end */
};

bool lines_open(struct lines *lines, const char *path, struct error *error);
void lines_close(struct lines *lines);

/* Reads the next line; false at the end of the file. */
bool lines_next(struct lines *lines);

/* Bytes of text up to the end of this line. */
int64_t lines_place(const struct lines *lines);

/* The most bytes of text that a file of this size can hold. */
int64_t lines_bytes_most(const struct lines *lines);

/* The next line that holds more than blanks and a comment (# to the end, cut off). */
bool lines_next_filled(struct lines *lines);

/* Reads up to `most` numbers from the line; returns the count of numbers up to the end of the line, or -1 if
 * a word is no (finite) number. */
int lines_numbers(const struct lines *lines, double *value, int most);

/* Splits the line into words, in place. Returns the number of words, or `most` + 1 if the line has more than
 * `most` words; then the first `most` words are stored. Other entries of `word` stay unset. */
int lines_words(struct lines *lines, char **word, int most);

/* Sets a user's error "PATH:LINE: ..."; returns false. */
bool lines_refuse(const struct lines *lines, struct error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Reads a word as a whole number; false if the word is none. */
bool lines_integer(const char *word, int64_t *value);

/* Reads a word as a finite number; false if the word is none. */
bool lines_real(const char *word, double *value);

/* Largest id or count that a column of numbers can give: doubles hold whole numbers exactly up to here. */
#define LINES_WHOLE_MAX ((int64_t)1 << 53)

/* Writes `value`, if `value` is a whole number, to *whole. Returns false and leaves *whole untouched if
 * `value` has a fraction or is below `least` or above `most` (neither beyond LINES_WHOLE_MAX in size). */
bool lines_whole(double value, int64_t least, int64_t most, int64_t *whole);

#endif
