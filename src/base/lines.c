/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads lines, packed by gzip or not, and keeps count of them. Read lines.h first. */
#include "base/lines.h"

#include "base/memory.h"
#include "base/file.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

bool lines_open(struct lines *lines, const char *path, struct error *error) {
    *lines = (struct lines){.path = path};
    const char *waits = file_waits(path);
    if (waits)
        return error_set(error, ERROR_USER, "%s: %s", path, waits);
    lines->file = gzopen(path, "rb");
    return lines->file || error_set(error, ERROR_USER, "%s: cannot be opened: %s", path, strerror(errno));
}

void lines_close(struct lines *lines) {
    if (lines->file)
        gzclose(lines->file);
    memory_free(lines->text);
    *lines = (struct lines){0};
}

bool lines_next(struct lines *lines) {
    size_t length = 0;
    int character = -1, status = Z_OK;
    do {
        if (length + 1 >= lines->room) {
            lines->room = 2 * lines->room + 256;
            lines->text = memory_resize(lines->text, lines->room, 1, "a line of a file");
        }
        character = gzgetc(lines->file);
        if (character >= 0)
            lines->text[length++] = (char)character;
    } while (character >= 0 && character != '\n');
    if (character < 0)
        gzerror(lines->file, &status);
    lines->damaged = lines->damaged || status != Z_OK;
    lines->whole = character == '\n';
    if (length == 0)
        return false;
    lines->number++;
    while (length > 0 && isspace((unsigned char)lines->text[length - 1]))
        length--;
    lines->text[length] = '\0';
    return true;
}

int64_t lines_place(const struct lines *lines) {
    return (int64_t)gztell(lines->file);
}

int64_t lines_bytes_most(const struct lines *lines) {
    enum { DEFLATE_MOST = 1032 }; /* largest ratio of unpacked to packed bytes */
    return file_size(lines->path) * (gzdirect(lines->file) ? 1 : DEFLATE_MOST);
}

bool lines_next_filled(struct lines *lines) {
    while (lines_next(lines)) {
        char *comment = strchr(lines->text, '#');
        if (comment)
            *comment = '\0';
        if (lines->text[strspn(lines->text, " \t\r")] != '\0')
            return true;
    }
    return false;
}

int lines_numbers(const struct lines *lines, double *value, int most) {
    const char *place = lines->text;
    for (int n = 0;; n++) {
        place += strspn(place, " \t\r");
        if (*place == '\0')
            return n;
        if (n == most)
            return n + 1;
        char *end;
        value[n] = strtod(place, &end);
        if (end == place || (*end && !isspace((unsigned char)*end)) || !isfinite(value[n]))
            return -1;
        place = end;
    }
}

int lines_words(struct lines *lines, char **word, int most) {
    int n = 0;
    char *rest = lines->text;
    for (char *next; n <= most && (next = strtok_r(rest, " \t\r", &rest)) != NULL; n++)
        if (n < most)
            word[n] = next;
    return n;
}

bool lines_refuse(const struct lines *lines, struct error *error, const char *format, ...) {
    char text[ERROR_TEXT_MAX];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return error_set(error, ERROR_USER, "%s:%llu: %s%s", lines->path, (unsigned long long)lines->number, text,
                     lines->damaged ? "; the file cannot be unpacked further: it is cut off or damaged" : "");
}

bool lines_integer(const char *word, int64_t *value) {
    char *end;
    errno = 0;
    *value = strtoll(word, &end, 10);
    return end != word && *end == '\0' && errno == 0;
}

bool lines_real(const char *word, double *value) {
    char *end;
    *value = strtod(word, &end);
    return end != word && *end == '\0' && isfinite(*value);
}

bool lines_whole(double value, int64_t least, int64_t most, int64_t *whole) {
    if (!(value >= (double)least && value <= (double)most && value == nearbyint(value)))
        return false;
    *whole = (int64_t)value;
    return true;
}
