/* SPDX-License-Identifier: BSD-3-Clause */
/* Numbers of a run that a resume needs, by name. The owner of a number lists it once: name, kind, and
 * address. A checkpoint writes the listed numbers, and a resume restores the numbers by their names. */
#ifndef SCREE_FORMATS_RESTART_H
#define SCREE_FORMATS_RESTART_H

#include "base/error.h"
#include "data/formats/output_options.h"
#include <stddef.h>
#include <stdint.h>

enum restart_kind {
    RESTART_INTEGER, /* int64_t or uint64_t, the same on every rank */
    RESTART_REAL,    /* double, the same on every rank */
    RESTART_SUM,     /* double, this rank's part of a sum: on as many ranks each gets its part back, else the
                        first gets the total */
    RESTART_KINDS
};

struct restart_number {
    char name[OUTPUT_NAME_MAX];
    enum restart_kind kind;
    bool optional; /* if a checkpoint lacks the name the number keeps its value; else an error */
    void *value;   /* borrowed; 8 bytes */
};

/* A list of numbers; all zero: empty. restart_free releases the rows, not the numbers that the rows point
 * to. */
struct restart {
    size_t count;
    struct restart_number *row; /* owned */
};

/* Adds a number. The name is made as by printf, cut to OUTPUT_NAME_MAX - 1 characters; no other number of the
 * list may have the same name. */
void restart_add(struct restart *restart, enum restart_kind kind, bool optional, void *value,
                 const char *format, ...) __attribute__((format(printf, 5, 6)));
void restart_free(struct restart *restart);

/* Numbers as they stand in a file: `count[kind]` names, filled up with zeros, and the bits of the values. All owned,
 * restart_values_free. */
struct restart_values {
    size_t count[RESTART_KINDS];
    char (*name[RESTART_KINDS])[OUTPUT_NAME_MAX];
    uint64_t *value[RESTART_KINDS];
};
void restart_values_allocate(struct restart_values *values, enum restart_kind kind, size_t count);
void restart_values_free(struct restart_values *values);

/* Copies names and values, in the order of the list, into `values`, which are all zero before. */
void restart_pack(const struct restart *restart, struct restart_values *values);

/* Copies values read from a file to the addresses in the list. Fails (user, naming `path`) if a number that
 * is not optional is missing. */
bool restart_take(const struct restart *restart, const struct restart_values *values, const char *path,
                  struct error *error);

#endif
