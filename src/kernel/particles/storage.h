/* SPDX-License-Identifier: BSD-3-Clause */
/* The arrays behind the fields, for particles.c and fields.c alone: several fields may share one array (the
 * hot record, the force record), and memory is handled array by array. */
#ifndef SCREE_PARTICLES_STORAGE_H
#define SCREE_PARTICLES_STORAGE_H

#include "kernel/particles/fields.h"

/* The arrays that each set has. */
enum storage_first { STORAGE_STATE, STORAGE_FORCE, STORAGE_ID, STORAGE_CLASS, STORAGE_FIRST_COUNT };

struct storage_array {
    char *base;
    size_t stride; /* bytes a particle */
};

/* The place of a field. */
struct storage_place {
    const struct field *field;
    int array;
    size_t offset; /* bytes from the particle's start in the array */
};

struct storage {
    int arrays, fields;
    bool filled; /* there is a field whose fill is not 0 */
    struct storage_array array[FIELDS_MAX];
    struct storage_place place[FIELDS_MAX];
};

/* The first arrays and fields of an empty set, without memory. */
void storage_begin(struct storage *storage);

/* Sets the pointers of the set to its first arrays, after one of these changed. */
void storage_publish(struct particles *particles);

/* Sets the fields of the `n` particles from number `first` on, whose memory is 0, to their fill. */
void storage_fill(const struct particles *particles, size_t first, size_t n);

#endif
