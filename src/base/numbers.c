/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads a table of numbers. Read numbers.h first. */
#include "base/numbers.h"
#include "base/memory.h"
#include "base/file.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char numbers_separators[] = " \t\v\f\r,;";

char *numbers_load(const char *path, size_t *size, struct error *error) {
    const char *waits = file_waits(path);
    if (waits) {
        error_set(error, ERROR_USER, "%s: %s", path, waits);
        return NULL;
    }
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        error_set(error, ERROR_USER, "%s: cannot be opened: %s", path, strerror(errno));
        return NULL;
    }
    size_t capacity = 1 << 16, got;
    char *text = memory_allocate(capacity, 1, "text of a file");
    *size = 0;
    while ((got = fread(text + *size, 1, capacity - 1 - *size, file)) > 0) {
        *size += got;
        if (*size == capacity - 1)
            text = memory_resize(text, capacity *= 2, 1, "text of a file");
    }
    text[*size] = '\0';
    if (ferror(file)) {
        error_set(error, ERROR_USER, "%s: cannot be read: %s", path, strerror(errno));
        memory_free(text);
        text = NULL;
    }
    fclose(file);
    return text;
}

char *numbers_line(char **text) {
    char *line = *text;
    if (*line == '\0')
        return NULL;
    size_t length = strcspn(line, "\n");
    *text = line + length + (line[length] == '\n');
    line[length] = '\0';
    if (length > 0 && line[length - 1] == '\r')
        line[length - 1] = '\0';
    return line;
}

bool numbers_word(char **at, double *value) {
    char *end;
    *value = strtod(*at, &end);
    if (end == *at || (*end != '\0' && strchr(numbers_separators, *end) == NULL))
        return false;
    *at = end;
    return true;
}

/* Reports the fault of a row; always returns false. */
static bool row_complain(const char *path, size_t line, const char *why, const char *at,
                         struct error *error) {
    return error_set(error, ERROR_USER, "%s:%zu: %s '%.*s'", path, line, why,
                     (int)strcspn(at, numbers_separators), at);
}

/* Reads the numbers of one line, which is not empty. */
static bool row_parse(double *value, int columns, char *line, const char *path, size_t number,
                      struct error *error) {
    char *at = line;
    int count = 0;
    while (*(at += strspn(at, numbers_separators)) != '\0') {
        char *word = at;
        double x;
        if (!numbers_word(&at, &x))
            return row_complain(path, number, "not a number:", word, error);
        if (!isfinite(x))
            return row_complain(path, number, "not a finite number:", word, error);
        if (count < columns)
            value[count] = x;
        count++;
    }
    return count == columns ||
           error_set(error, ERROR_USER, "%s:%zu: %d numbers, %d are needed", path, number, count, columns);
}

/* True if the line begins with something that is no number. */
static bool line_is_header(char *line) {
    double x;
    return !numbers_word(&line, &x);
}

bool numbers_parse(struct numbers *numbers, char *text, const char *path, int columns, struct error *error) {
    size_t capacity = 0, number = 0;
    bool first = true, good = true;
    char *line;
    *numbers = (struct numbers){.columns = columns};
    while (good && (line = numbers_line(&text)) != NULL) {
        number++;
        line += strspn(line, numbers_separators);
        if (*line == '\0' || *line == '#')
            continue;
        bool header = first && line_is_header(line);
        first = false;
        if (header)
            continue;
        if (numbers->rows == capacity) {
            capacity = capacity ? 2 * capacity : 64;
            numbers->value = memory_resize(numbers->value, capacity * (size_t)columns, sizeof *numbers->value,
                                           "numbers of a file");
            numbers->line =
                memory_resize(numbers->line, capacity, sizeof *numbers->line, "numbers of a file");
        }
        double *row = numbers->value + numbers->rows * (size_t)columns;
        good = row_parse(row, columns, line, path, number, error);
        numbers->line[numbers->rows++] = (uint32_t)number;
    }
    if (!good)
        numbers_free(numbers);
    return good;
}

bool numbers_read(struct numbers *numbers, const char *path, int columns, struct error *error) {
    size_t size;
    char *text = numbers_load(path, &size, error);
    *numbers = (struct numbers){0};
    if (text == NULL)
        return false;
    bool good = strlen(text) == size ||
                error_set(error, ERROR_USER, "%s: not a text file: byte %zu is zero", path, strlen(text));
    good = good && numbers_parse(numbers, text, path, columns, error);
    memory_free(text);
    return good;
}

bool numbers_check_times(const struct numbers *numbers, const char *path, const char *row_text,
                         struct error *error) {
    if (numbers->rows == 0)
        return error_set(error, ERROR_USER, "%s: no row of %s", path, row_text);
    for (size_t row = 1; row < numbers->rows; row++) {
        const double *after = numbers->value + row * (size_t)numbers->columns,
                     *before = after - numbers->columns;
        if (!(*after > *before))
            return error_set(error, ERROR_USER, "%s:%u: time %g does not increase (%g before)", path,
                             numbers->line[row], *after, *before);
    }
    return true;
}

size_t numbers_row(const struct numbers *numbers, double t) {
    size_t low = 0, high = numbers->rows - 1;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (numbers->value[middle * (size_t)numbers->columns] <= t)
            low = middle;
        else
            high = middle;
    }
    return low;
}

void numbers_at(const struct numbers *numbers, double t, double *value) {
    const double *a = numbers->value + numbers_row(numbers, t) * (size_t)numbers->columns;
    const double *b = numbers->rows > 1 ? a + numbers->columns : a;
    double part = b > a ? (t - a[0]) / (b[0] - a[0]) : 0.0;
    part = part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part;
    for (int k = 1; k < numbers->columns; k++)
        value[k - 1] = (1.0 - part) * a[k] + part * b[k];
}

void numbers_free(struct numbers *numbers) {
    memory_free(numbers->value);
    memory_free(numbers->line);
    *numbers = (struct numbers){0};
}
