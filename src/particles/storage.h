/* The arrays behind the fields, for particles.c and fields.c alone: several fields may share one array (the
 * hot record, the force record), and memory is handled array by array. */
#ifndef SCREE_PARTICLES_STORAGE_H
#define SCREE_PARTICLES_STORAGE_H

#include "particles/particles.h"

enum storage_array {
    STORAGE_STATE,
    STORAGE_OMEGA,
    STORAGE_FORCE,
    STORAGE_ID,
    STORAGE_CLASS,
    STORAGE_MATERIAL,
    STORAGE_GROUP,
    STORAGE_DENSITY,
    STORAGE_IMAGE,
    STORAGE_ARRAYS
};

/* True if a set with these features has the array. */
bool storage_present(enum storage_array array, unsigned features);

/* Bytes a particle takes in the array. */
size_t storage_stride(enum storage_array array, unsigned features);

/* The array's pointer now, and setting it. */
void *storage_get(const struct particles *particles, enum storage_array array);
void storage_set(struct particles *particles, enum storage_array array, void *pointer);

#endif
