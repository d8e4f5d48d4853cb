#include "output/lines.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

bool lines_open(struct lines *lines, const char *path, struct error *error) {
    *lines = (struct lines){.path = path};
    lines->file = fopen(path, "r");
    return lines->file || error_set(error, ERROR_USER, "%s: cannot be opened: %s", path, strerror(errno));
}

void lines_close(struct lines *lines) {
    if (lines->file)
        fclose(lines->file);
    free(lines->text);
    *lines = (struct lines){0};
}

bool lines_next(struct lines *lines) {
    ssize_t length = getline(&lines->text, &lines->room, lines->file);
    if (length < 0)
        return false;
    lines->number++;
    lines->whole = length > 0 && lines->text[length - 1] == '\n';
    while (length > 0 && isspace((unsigned char)lines->text[length - 1]))
        lines->text[--length] = '\0';
    return true;
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
    for (char *next; n < most && (next = strtok_r(rest, " \t\r", &rest)) != NULL;)
        word[n++] = next;
    return n;
}

bool lines_refuse(const struct lines *lines, struct error *error, const char *format, ...) {
    char text[ERROR_TEXT_MAX];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return error_set(error, ERROR_USER, "%s:%llu: %s", lines->path, (unsigned long long)lines->number, text);
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
