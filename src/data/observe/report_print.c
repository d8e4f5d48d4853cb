/* SPDX-License-Identifier: BSD-3-Clause */
/* The report on the terminal: lines of text with the values of rows in them. Read report_print.h first. */
#include "data/observe/report_print.h"

#include <assert.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_ROOM = 256 };

/* "1,234,567" */
static void group_digits(uint64_t value, char text[TEXT_ROOM]) {
    char digits[24];
    int length = snprintf(digits, sizeof digits, "%" PRIu64, value), used = 0;
    for (int k = 0; k < length; k++) {
        if (k > 0 && (length - k) % 3 == 0)
            text[used++] = ',';
        text[used++] = digits[k];
    }
    text[used] = '\0';
}

/* The first of two words, "one|other", or the second. */
static void choose_word(const char *words, bool first, char text[TEXT_ROOM]) {
    const char *bar = strchr(words, '|');
    if (first)
        snprintf(text, TEXT_ROOM, "%.*s", (int)(bar - words), words);
    else
        snprintf(text, TEXT_ROOM, "%s", bar + 1);
}

/* The text of a value in the form of its row: `text` or another string. */
static const char *show(const struct report_row *row, union report_value value, char text[TEXT_ROOM]) {
    char word[TEXT_ROOM];
    if (row->text)
        return value.text;
    if (row->flag) {
        choose_word(row->print, value.count != 0, text);
    } else if (row->print && strchr(row->print, '|')) {
        choose_word(row->print, value.count == 1, word);
        snprintf(text, TEXT_ROOM, "%" PRIu64 " %.200s", value.count, word);
    } else if (row->print) {
        double number = row->real ? value.real : (double)value.count;
        snprintf(text, TEXT_ROOM, row->print, row->times != 0 ? row->times * number : number);
    } else {
        group_digits(value.count, text);
    }
    return text;
}

/* Prints a text with the values of entry `k` of a table. */
static void print_text(const struct report_table *table, int k, const char *text, FILE *file) {
    char buffer[TEXT_ROOM];
    while (*text) {
        size_t plain = strcspn(text, "{");
        fprintf(file, "%.*s", (int)plain, text);
        text += plain;
        if (*text == '\0')
            break;
        size_t length = strcspn(++text, ":}");
        int width = text[length] == ':' ? atoi(text + length + 1) : 0;
        const char *value = buffer;
        if (*text == '#') {
            snprintf(buffer, sizeof buffer, "%d", k);
        } else {
            const struct report_column *column;
            const struct report_row *row = report_find(table, text, length, &column);
            assert(row);
            value = show(row, column->value[k], buffer);
        }
        fprintf(file, "%*s", width, value);
        text = strchr(text, '}') + 1;
    }
}

static void print_list(const struct report *report, const struct report_line *line, FILE *file) {
    const struct report_table *list = report_list(report, line->list);
    for (int k = 0; k < list->entries; k++) {
        if (k == 0 && line->heading)
            print_text(&report->table, 0, line->heading, file);
        if (line->only == NULL || report_holds(list, k, line->only))
            print_text(list, k, line->text, file);
    }
}

void report_print(const struct report *report, const struct report_line *lines, FILE *file) {
    for (const struct report_line *line = lines; line->text; line++) {
        if (line->when && !report_holds(&report->table, 0, line->when))
            continue;
        if (line->list)
            print_list(report, line, file);
        else
            print_text(&report->table, 0, line->text, file);
    }
}
