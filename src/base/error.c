/* SPDX-License-Identifier: BSD-3-Clause */
/* Fills errors, and ends the program on an error that no caller can handle. Read error.h first. */
#include "base/error.h"

#include "base/log.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Set by error_set_abort and error_set_log, while there is one thread. */
static int fatal_rank = 0;
static void (*fatal_hook)(int status) = NULL;
static struct log fatal_log;

bool error_set(struct error *error, enum error_kind kind, const char *format, ...) {
    if (error->kind == ERROR_NONE) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(error->text, sizeof error->text, format, arguments);
        va_end(arguments);
        error->kind = kind;
    }
    return false;
}

bool error_set_errno(struct error *error, const char *format, ...) {
    int number = errno;
    if (error->kind == ERROR_NONE) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(error->text, sizeof error->text, format, arguments);
        va_end(arguments);
        size_t used = strlen(error->text);
        snprintf(error->text + used, sizeof error->text - used, ": %s", strerror(number));
        error->kind = ERROR_SYSTEM;
    }
    errno = number;
    return false;
}

void error_fatal(const char *format, ...) {
    char text[ERROR_TEXT_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    fflush(stdout);
    log_tell(&fatal_log, "rank %d: %s", fatal_rank, text);
    fflush(stderr);
    if (fatal_hook != NULL) {
        fatal_hook(ERROR_SYSTEM);
    }
    abort();
}

void error_set_abort(int rank, void (*abort_hook)(int status)) {
    fatal_rank = rank;
    fatal_hook = abort_hook;
}

void error_set_log(const struct log *log) {
    fatal_log = log ? *log : (struct log){0};
}
