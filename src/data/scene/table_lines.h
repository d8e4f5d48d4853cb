/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of scene/: the lines of a plain table and their words, whatever their lengths. */
#ifndef SCREE_SCENE_TABLE_LINES_H
#define SCREE_SCENE_TABLE_LINES_H

#include <stdbool.h>

/* A walk over the lines of a text. A copy of the struct walks on its own in `at` and `number`, but shares the
 * three buffers. */
struct table_lines {
    const char *at; /* the rest of the text; borrowed */
    long number;    /* of the line last taken, from 1; 0: none yet */
    char *line;     /* the line last taken, without comment; owned, as are the next two */
    char *comment;  /* the last comment that stood alone and was kept; "" before */
    char *words;    /* of table_lines_words */
};

/* Begins at the start of a text, which must live until table_lines_close. */
void table_lines_open(struct table_lines *lines, const char *text);
void table_lines_close(struct table_lines *lines);

/* Takes the next line with something on it; false at the end of the text. Comments (# to the end) are cut
 * off; one that stands alone is kept in `comment` if `keep_comment`. */
bool table_lines_next(struct table_lines *lines, bool keep_comment);

/* A copy of one of the lines, good until the next call, to be cut by table_lines_word. */
char *table_lines_words(const struct table_lines *lines, const char *line);

/* Cuts the next word off a line (blanks, tabs, commas and semicolons stand between words); NULL at its end.
 */
char *table_lines_word(char **line);

/* Number of words on a line. */
int table_lines_count(const char *line);

#endif
