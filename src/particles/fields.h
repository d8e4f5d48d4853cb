/* The field table: every field of a particle, once. Allocation, growth, reorder, packing for MPI, HDF5 files,
 * restart and the docs all walk it. */
#ifndef SCREE_PARTICLES_FIELDS_H
#define SCREE_PARTICLES_FIELDS_H

#include "particles/particles.h"

enum field_type { FIELD_DOUBLE, FIELD_INT64, FIELD_INT32, FIELD_UINT8 };

/* Where a field travels. Bits of `use`. */
enum field_use {
    FIELD_GHOST = 1,   /* set in a copy when it is made */
    FIELD_FORWARD = 2, /* sent to copies every step */
    FIELD_REVERSE = 4, /* sent back from copies and added, newton on */
    FIELD_MIGRATE = 8, /* travels with a particle that changes ranks */
    FIELD_RESTART = 16 /* written to a checkpoint */
};

struct field {
    const char *name; /* as in H5MD: position, velocity, angular_velocity, force, torque, radius, mass, ... */
    enum field_type type;
    int components;   /* 1 or 3 */
    unsigned needs;   /* feature bit that brings it, 0 = always */
    unsigned use;     /* bits of enum field_use */
    const char *unit; /* H5MD unit string in SI, "" where it has none */
    const char *help; /* one line */
};

/* Number of rows, and row `f` of the table. */
int fields_count(void);
const struct field *fields_get(int f);

/* The row with this name, or -1. */
int fields_find(const char *name);

/* True if the set holds this field. */
bool fields_present(const struct particles *particles, int f);

/* First byte of the field of particle 0 and the bytes from one particle to the next. The field must be
 * present. */
void *fields_base(const struct particles *particles, int f, size_t *stride);

/* Bytes of one particle's value of a field (components x size of the type). */
size_t fields_bytes(int f);

/* Bytes that fields_pack writes a particle for all present fields with any of the bits in `use`. */
size_t fields_packed_bytes(const struct particles *particles, unsigned use);

/* Copies the present fields with any of the bits in `use` of the `n` particles list[0..n) to `buffer`,
 * particle after particle, without padding. Returns the end of what was written. One thread; may run at the
 * same time on other parts. */
char *fields_pack(const struct particles *particles, unsigned use, const uint32_t *list, size_t n,
                  char *buffer);

/* The opposite: fills `n` particles from number `first` on. Returns the end of what was read. */
const char *fields_unpack(struct particles *particles, unsigned use, size_t first, size_t n,
                          const char *buffer);

/* Adds the packed REVERSE fields in `buffer` to the `n` particles list[0..n). Returns the end of what was
 * read. */
const char *fields_unpack_add(struct particles *particles, const uint32_t *list, size_t n,
                              const char *buffer);

#endif
