/* SPDX-License-Identifier: BSD-3-Clause */
/* A frame: the particles at one moment, as a file holds them. Columns are in the user's terms (positions with
 * the box's origin, velocities of the full step, the force of contacts and walls without gravity, mass), rows
 * are sorted by id over all ranks, and each rank holds one slab. So row k is the same particle in every frame
 * as long as no particle is deleted (new particles have larger ids), and the file does not depend on the
 * layout of ranks. */
#ifndef SCREE_FORMATS_FRAME_H
#define SCREE_FORMATS_FRAME_H

#include "data/formats/output.h"
#include "data/formats/rows.h"
#include "kernel/particles/fields.h"

struct frame_column {
    const char *name;     /* as in H5MD */
    const char *unit;     /* SI; "": no unit */
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

/* Checks a list of names against the fields of the particles; an empty list means all fields. Unknown names,
 * and fields that the scene does not have, are a user's error; the message lists the existing fields. */
bool frame_check_fields(const struct output_fields *fields, const struct particles *particles,
                        struct error *error);

/* Makes a frame. Collective. frame_free releases the frame. */
void frame_create(struct frame *frame, const struct output_view *view, const struct output_fields *fields);

/* Makes a frame of rows of a file. The frame borrows the arrays of `rows` and must not be used after they are
 * freed. One rank. */
void frame_from_rows(struct frame *frame, const struct rows *rows);

void frame_free(struct frame *frame);

/* Registers every field that any scene can have: for the documentation, for help, and for files whose fields
 * are unknown before reading. */
void frame_register_all(struct particles *particles);

/* The output form of a field, for the documentation. */
struct frame_field {
    const char *name, *unit, *help; /* as in H5MD */
    enum field_type type;           /* DOUBLE, INT64 or INT32 */
    int components;
    bool spatial, fixed;    /* as in a frame_column */
    bool asked_only;        /* left out unless a list of fields names the field */
    const char *needed_for; /* the setting that brings the field; NULL: all scenes have the field */
};
struct frame_field frame_field_get(const struct field *field);

/* The column of a name, or NULL. */
const struct frame_column *frame_find(const struct frame *frame, const char *name);

/* Bytes of one value of a column (components x size). */
size_t frame_column_bytes(const struct frame_column *column);

#endif
