/* SPDX-License-Identifier: BSD-3-Clause */
/* A frame: what a file shows of the particles at one moment. Columns in the user's terms (positions with the
 * box's origin, velocities of the full step, the force of contacts and walls without gravity, mass), rows
 * sorted by id over all ranks, each rank holding one slab. So row k is the same particle in every frame as
 * long as none is deleted (new ones have larger ids), and the file does not depend on the layout of ranks. */
#ifndef SCREE_FORMATS_FRAME_H
#define SCREE_FORMATS_FRAME_H

#include "formats/output.h"
#include "formats/rows.h"
#include "particles/fields.h"

struct frame_column {
    const char *name;     /* as in H5MD */
    const char *unit;     /* SI, "" where it has none */
    enum field_type type; /* DOUBLE, INT64 or INT32 */
    int components;
    bool spatial; /* has as many components as the box has dimensions */
    bool fixed;   /* never changes for a particle */
    void *data;   /* rows x components */
};

struct frame {
    uint64_t step;
    double time;
    size_t rows;           /* of this rank */
    uint64_t first, total; /* place of this rank's slab; rows on all ranks */
    struct box box;
    int columns; /* column 0 is the id */
    struct frame_column column[OUTPUT_FIELDS_MAX];
};

/* Resolves a list of names against the fields that the particles have: marks for frame_create. None: all.
 * Unknown names, and fields that the scene does not have, are a user's error that lists those there are. */
bool frame_check_fields(const struct output_fields *fields, const struct particles *particles,
                        struct error *error);

/* Makes a frame. Collective. frame_free releases it. */
void frame_create(struct frame *frame, const struct output_view *view, const struct output_fields *fields);

/* A frame that shows rows of a file: it borrows the arrays of `rows` and must not be freed before them. One
 * rank. */
void frame_from_rows(struct frame *frame, const struct rows *rows);

void frame_free(struct frame *frame);

/* Registers every field that some scene has: for pages, for help, and for files whose fields are not known
 * before they are read. */
void frame_register_all(struct particles *particles);

/* How a field is shown, for docs. */
struct frame_field {
    const char *name, *unit, *help; /* as in H5MD */
    enum field_type type;           /* DOUBLE, INT64 or INT32 */
    int components;
    bool spatial, fixed;    /* as in a frame_column */
    bool asked_only;        /* left out unless a list of fields names it */
    const char *needed_for; /* what brings it; NULL: all scenes have it */
};
struct frame_field frame_field_get(const struct field *field);

/* The column of a name, or NULL. */
const struct frame_column *frame_find(const struct frame *frame, const char *name);

/* Bytes of one value of a column (components x size). */
size_t frame_column_bytes(const struct frame_column *column);

#endif
