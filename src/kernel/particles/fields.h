/* SPDX-License-Identifier: BSD-3-Clause */
/* Fields: the data of a particle. The file that needs a field registers the field in the set of particles
 * that has it; there is no list of all fields. Allocation, growth, reorder, packing for MPI, H5MD, restart,
 * the docs and `scree check` walk the table of the set.
 *
 * How to add a field, in five steps:
 *   1. Describe the field in one row, `static const struct field temperature = {.name = "temperature",
 *      .type = FIELD_DOUBLE, .components = 1, .use = ..., .unit = "K", .help = "..."}`, in the file of its
 *      owner. `use` says where the values travel: FIELD_TRAVELS | FIELD_OUTPUT for what a particle remembers
 *      and files show. A particle begins with `fill`; a pass changes the values (engine/physics.h).
 *   2. Write the owner's function that calls `fields_register(particles, &temperature)`. A field of grains
 *      then has one row in src/fields_table.h: the function, and the scenes that need the field. A physics
 *      registers its fields in NAME_fields (physics_table.h).
 *   3. Take the values from fields_values (or a function of the owner that calls it) before a loop, never
 *      inside; they are NULL where the scene has no such field. Pointers become invalid when the set grows:
 *      at rebuilds, and when particles or fields are added.
 *   4. Values of copies: a FORWARD field comes with every exchange of the step, a REVERSE field is summed
 *      back with the forces; a pass of its own sends any list of fields (kernel/comm/ghosts.h).
 *   5. `make pages` writes the row of docs/output.md.
 * `src/kernel/particles/spin.c` is an example of grains, src/physics/density of a physics.
 *
 * Every set begins with the fields of enum field_first: the hot record of a cache line, the force, the id
 * and the size class; struct particles has pointers to these. */
#ifndef SCREE_PARTICLES_FIELDS_H
#define SCREE_PARTICLES_FIELDS_H

#include "kernel/particles/particles.h"

enum field_type { FIELD_DOUBLE, FIELD_INT64, FIELD_INT32, FIELD_UINT8 };

/* The uses of a field: bits of `use`. */
enum field_use {
    FIELD_GHOST = 1,     /* set in a copy when it is made; else a copy's value is not defined */
    FIELD_FORWARD = 2,   /* sent to copies every step */
    FIELD_REVERSE = 4,   /* 0 in a copy when it is made; sent back from copies and added, newton on */
    FIELD_MIGRATE = 8,   /* travels with a particle that changes ranks; else set to `fill` there */
    FIELD_RESTART = 16,  /* written to a checkpoint */
    FIELD_OUTPUT = 32,   /* shown in files */
    FIELD_ASKED = 64,    /* in files only where a list of fields names it */
    FIELD_SPATIAL = 128, /* in files: as many components as the box has dimensions */
    FIELD_FIXED = 256,   /* never changes for a particle: files hold it once */
    FIELD_FLOWS = 512, /* a velocity of three doubles: follows the mean flow of a box that moves, as v does */
    FIELD_TRAVELS = FIELD_MIGRATE | FIELD_RESTART
};

/* One field, borrowed by the sets that have it: static data of its owner. */
struct field {
    const char *name; /* as in H5MD: angular_velocity, temperature ...; unique in a set */
    enum field_type type;
    int components;   /* 1 ... FIELD_COMPONENTS_MAX */
    int room;         /* components that memory holds (the others are 0); 0: no more than `components` */
    unsigned use;     /* bits of enum field_use */
    unsigned kinds;   /* bits 1 << kind (kinds.h) of the kinds with the field; 0: all. Others hold `fill` */
    double fill;      /* the value of particles that are added */
    const char *unit; /* H5MD unit string in SI, "" or NULL where it has none */
    const char *needed_for; /* the part of a scene that needs the field; NULL: every scene has the field */
    const char *help;       /* one line */
};

enum { FIELDS_MAX = 64, FIELD_COMPONENTS_MAX = 16 };

/* The handles of the fields that each set has from the start. */
enum field_first {
    FIELD_POSITION,
    FIELD_VELOCITY,
    FIELD_RADIUS,
    FIELD_INVERSE_MASS,
    FIELD_FORCE,
    FIELD_ID,
    FIELD_SIZE_CLASS,
    FIELD_FIRST_COUNT
};

/* Adds a field to a set, `fill` in all its particles, and returns its handle; a row that is there already
 * only gives its handle. Two rows of one name are a programmer's mistake. Pointers into the arrays become
 * invalid. One thread; on all ranks alike. */
int fields_register(struct particles *particles, const struct field *field);

/* fields_register for a field of doubles that lies in one record with the force, behind the force, and is
 * cleared together with the force (the torque). */
int fields_register_with_force(struct particles *particles, const struct field *field);

/* Number of fields of a set, and the row of handle `f`. */
int fields_count(const struct particles *particles);
const struct field *fields_get(const struct particles *particles, int f);

/* The handle of a row, or of a name; -1 if the set has no such field. */
int fields_handle(const struct particles *particles, const struct field *field);
int fields_find(const struct particles *particles, const char *name);

/* First byte of the field of particle 0 and the bytes from one particle to the next; O(1). `stride` may be
 * NULL. */
void *fields_base(const struct particles *particles, int f, size_t *stride);

/* The values of a row's field in a set, NULL if the set has no such field. */
void *fields_values(const struct particles *particles, const struct field *field);

/* The values of a field of one double a particle, by its name; NULL if the set has no such field. */
double *fields_numbers(const struct particles *particles, const char *name);

/* Component k, as a double, of the value of one particle, which begins at `at`. */
double fields_component(const struct field *field, const void *at, int k);

/* Bytes of one particle's value of a field (components x size of the type). */
size_t fields_bytes(const struct field *field);

/* Fields that travel together, by handle. */
struct field_list {
    int count;
    int field[FIELDS_MAX];
};

/* All fields of a set that have any of the bits in `use`; a list of one field. */
struct field_list fields_with(const struct particles *particles, unsigned use);
struct field_list fields_one(int f);

/* The values of the FIELD_FLOWS fields of a set; returns their number. Those of other kinds stay `fill`. */
struct fields_flow {
    double (*value)[3];
    unsigned kinds; /* bits 1 << kind; 0: all */
};
int fields_flowing(const struct particles *particles, struct fields_flow flow[FIELDS_MAX]);

/* True if a list has a field. */
bool fields_listed(const struct field_list *list, int f);

/* Bytes that fields_pack writes a particle. */
size_t fields_packed_bytes(const struct particles *particles, const struct field_list *fields);

/* Copies the listed fields of the `n` particles list[0..n) to `buffer`, particle after particle, without
 * padding. Returns the end of the written data. One thread; may run at the same time on other parts. */
char *fields_pack(const struct particles *particles, const struct field_list *fields, const uint32_t *list,
                  size_t n, char *buffer);

/* The opposite of fields_pack: fills `n` particles from number `first` on. Returns the end of the data
 * read. */
const char *fields_unpack(struct particles *particles, const struct field_list *fields, size_t first,
                          size_t n, const char *buffer);

/* The same for the `n` particles list[0..n). */
const char *fields_unpack_list(struct particles *particles, const struct field_list *fields,
                               const uint32_t *list, size_t n, const char *buffer);

/* Adds packed fields of doubles in `buffer` to the `n` particles list[0..n). Returns the end of the data
 * read. */
const char *fields_unpack_add(struct particles *particles, const struct field_list *fields,
                              const uint32_t *list, size_t n, const char *buffer);

/* Sets the REVERSE fields, padding included, of the `n` particles from number `first` on to 0. */
void fields_clear_reverse(struct particles *particles, size_t first, size_t n);

#endif
