/* SPDX-License-Identifier: BSD-3-Clause */
/* The way of a message to people: warnings and notes of a running simulation, a line each. */
#ifndef SCREE_BASE_LOG_H
#define SCREE_BASE_LOG_H

/* The receiver of messages. All zero: standard error. */
struct log {
    void (*tell)(void *context, const char *line); /* gets a line without its end; NULL: standard error */
    void *context;
};

/* Tells one printf-style line ("warning: ..."); on standard error the line gets "scree: " in front. `log` NULL:
 * standard error. Main thread. */
void log_tell(const struct log *log, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Tells each line of a text. Main thread. */
void log_text(const struct log *log, const char *text);

#endif
