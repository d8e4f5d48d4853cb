/* SPDX-License-Identifier: BSD-3-Clause */
/* Hands messages to their receiver. Read log.h first. */
#include "base/log.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { LINE_MAX_BYTES = 2048 };

void log_tell(const struct log *log, const char *format, ...) {
    char line[LINE_MAX_BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    if (log && log->tell)
        log->tell(log->context, line);
    else
        fprintf(stderr, "scree: %s\n", line);
}

void log_text(const struct log *log, const char *text) {
    while (text && *text) {
        size_t length = strcspn(text, "\n");
        if (length > 0)
            log_tell(log, "%.*s", (int)length, text);
        text += length + (text[length] == '\n');
    }
}
