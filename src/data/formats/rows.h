/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles of a file: plain arrays, in the user's coordinates. Columns that the file lacks are NULL.
 *
 * How to add a column: a bit, a pointer in struct rows, and a row of rows_kinds (rows.c). Readers of text name its columns, too (dump_read.c). */
#ifndef SCREE_FORMATS_ROWS_H
#define SCREE_FORMATS_ROWS_H

#include "kernel/particles/fields.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum rows_column {
    ROWS_POSITION = 1,
    ROWS_VELOCITY = 2,
    ROWS_ANGULAR_VELOCITY = 4,
    ROWS_RADIUS = 8,
    ROWS_MASS = 16,
    ROWS_ID = 32,
    ROWS_MATERIAL = 64,
    ROWS_IMAGE = 128,
    ROWS_ALL = 255, /* all data of a sphere */
    ROWS_LINE = 256,
    /* of rigid bodies, as this program writes them */
    ROWS_KIND = 512,
    ROWS_BODY = 1024,
    ROWS_BODY_PART = 2048,
    ROWS_BODY_MASS = 4096,
    ROWS_ORIENTATION = 8192,
    ROWS_ROCK_SHAPE = 16384,
    ROWS_ROCK_ORIENTATION = 32768
};

struct rows {
    size_t count;          /* rows held here */
    uint64_t first, total; /* number of row 0 among all rows of the file; count of all rows */
    double (*position)[3]; /* length unit */
    double (*velocity)[3];
    double (*angular_velocity)[3]; /* rad/time */
    double *radius;
    double *mass;
    int64_t *id;
    int32_t *material; /* number from 0 (LAMMPS: type - 1) */
    int32_t (*image)[3];
    uint32_t *line;     /* line of each row in its file; a text file has it */
    int32_t *kind;      /* enum kind (kernel/particles/kinds.h) */
    int64_t *body;      /* id of the body that carries the particle; -1: none */
    int32_t *body_part; /* of a body: number of its shape */
    double *body_mass;
    double (*orientation)[4]; /* of a body: quaternion w x y z */
    int32_t *rock_shape;      /* of the ball around a rock: number of its shape; -1: no such ball */
    double (*rock_orientation)[4];
    int dimension; /* 2 (z and z components are 0) or 3 */
    bool box_given, periodic_given;
    double lower[3], upper[3]; /* of the box */
    /* A sheared box: an image one edge up the direction `gradient` lies at `offset` along `flow`; 0: no tilt. */
    struct rows_tilt {
        int flow, gradient;
        double offset;
    } tilt;
    bool periodic[3];
    uint64_t step;
    double time; /* 0 if the file does not give the time */
};

/* What a column is. */
struct rows_kind {
    unsigned bit;     /* enum rows_column */
    const char *name; /* of its field in files; NULL: it is no field */
    enum field_type type;
    int components;
    bool fixed;   /* a file with a fixed set of particles holds it once */
    size_t place; /* of its pointer in struct rows */
};
enum { ROWS_KINDS = 16 };
extern const struct rows_kind rows_kinds[ROWS_KINDS]; /* the id first */

/* The array of a column, NULL: it is not there; sets it; bytes of a row of it. */
void *rows_values(const struct rows *rows, const struct rows_kind *kind);
void rows_set(struct rows *rows, const struct rows_kind *kind, void *values);
size_t rows_bytes(const struct rows_kind *kind);

/* Copies row `from` to row `to`, in all columns. */
void rows_move(struct rows *rows, size_t from, size_t to);

/* Allocates the named columns (bits of enum rows_column) for `count` rows, zeroed, all rows held here; the
 * rest of the struct is zeroed, dimension 3. */
void rows_create(struct rows *rows, size_t count, unsigned columns);

/* Frees the arrays and zeroes the struct. */
void rows_free(struct rows *rows);

/* The tilt of a box by its numbers xy, xz, yz, as LAMMPS names them. False if more than one is not 0. */
bool rows_tilt_of(const double tilt[3], struct rows_tilt *out);

/* The columns that are present, as bits of enum rows_column. */
unsigned rows_columns(const struct rows *rows);

#endif
