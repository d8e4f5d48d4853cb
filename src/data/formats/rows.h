/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles of a file: plain arrays, in the user's coordinates. Columns that the file lacks are NULL. */
#ifndef SCREE_FORMATS_ROWS_H
#define SCREE_FORMATS_ROWS_H

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
    ROWS_ALL = 255, /* all data of a particle */
    ROWS_LINE = 256
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
    uint32_t *line; /* line of each row in its file; a text file has it */
    int dimension;  /* 2 (z and z components are 0) or 3 */
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
