/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads the lines of a plain table and cuts them into words. Read source_makers.h first. */
#include "data/scene/source_makers.h"

#include "base/memory.h"

#include <string.h>

/* Characters between words. */
static const char between[] = " \t\r,;";

/* Bytes of the longest line, with a zero at its end. */
static size_t longest_line(const char *text) {
    size_t longest = 0;
    while (*text) {
        size_t length = strcspn(text, "\n");
        longest = length > longest ? length : longest;
        text += length + (text[length] == '\n');
    }
    return longest + 1;
}

void table_lines_open(struct table_lines *lines, const char *text) {
    size_t room = longest_line(text);
    *lines = (struct table_lines){.at = text,
                                  .line = memory_allocate_zero(room, 1, "a line of a table"),
                                  .comment = memory_allocate_zero(room, 1, "a line of a table"),
                                  .words = memory_allocate_zero(room, 1, "a line of a table")};
}

void table_lines_close(struct table_lines *lines) {
    memory_free(lines->line);
    memory_free(lines->comment);
    memory_free(lines->words);
    *lines = (struct table_lines){0};
}

bool table_lines_next(struct table_lines *lines, bool keep_comment) {
    char *line = lines->line;
    while (*lines->at) {
        size_t length = strcspn(lines->at, "\n");
        memcpy(line, lines->at, length);
        line[length] = '\0';
        lines->at += length + (lines->at[length] == '\n');
        lines->number++;
        char *hash = strchr(line, '#');
        bool alone = hash && strspn(line, " \t\r") == (size_t)(hash - line);
        if (alone && keep_comment)
            memcpy(lines->comment, hash + 1, strlen(hash + 1) + 1);
        if (hash)
            *hash = '\0';
        if (line[strspn(line, between)])
            return true;
    }
    return false;
}

char *table_lines_words(const struct table_lines *lines, const char *line) {
    memcpy(lines->words, line, strlen(line) + 1);
    return lines->words;
}

char *table_lines_word(char **line) {
    char *word = *line + strspn(*line, between);
    if (*word == '\0')
        return NULL;
    *line = word + strcspn(word, between);
    if (**line)
        *(*line)++ = '\0';
    return word;
}

int table_lines_count(const char *line) {
    int count = 0;
    for (line += strspn(line, between); *line; line += strspn(line, between)) {
        line += strcspn(line, between);
        count++;
    }
    return count;
}
