/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of the H5MD writer: the present file, and the functions that all writing parts share. These
 * parts are h5md_head.h (the head), h5md_frame.h, h5md_contacts.h, h5md_observables.h (data added),
 * h5md_resume.h, and h5md.h (open, flush, close). */
#ifndef SCREE_FORMATS_H5MD_FILE_H
#define SCREE_FORMATS_H5MD_FILE_H

#include "data/formats/h5.h"
#include "data/formats/lineage.h"
#include "data/formats/xdmf.h"

struct output_shapes; /* output_shapes.h */

/* An element of /particles/all in the file. */
struct h5md_element {
    struct xdmf_column shown; /* name and dataset point into the texts below */
    char name[OUTPUT_NAME_MAX];
    char dataset[2 * OUTPUT_NAME_MAX]; /* "/particles/all/velocity/value" */
    char unit[OUTPUT_NAME_MAX];
    enum field_type type;
    bool single; /* of DOUBLE: floats in the file */
};

struct h5md {
    const struct comm *comm; /* borrowed */
    char path[FILE_PATH_MAX], xdmf_path[FILE_PATH_MAX];
    bool dimensionless, varying, xdmf;
    bool single; /* elements that this run makes */
    int deflate;
    uint64_t seed;
    const struct lineage *lineage;      /* borrowed; NULL: none */
    const struct output_shapes *shapes; /* borrowed; NULL: none */
    bool made;                          /* the file exists */

    int elements;
    struct h5md_element element[XDMF_COLUMNS_MAX];
    uint64_t rows;  /* of the tables in the file */
    uint64_t chunk; /* rows of a table that are stored together */
    uint64_t frames, frame_room;
    struct xdmf_frame *frame; /* owned */
    uint64_t xdmf_frames;     /* frames in the XDMF file on disk */

    uint64_t lists, list_rows[2]; /* contact lists in the file; rows of the widest: of particles, of walls */

    int observables;                                             /* columns; 0: no row came yet */
    const char *const *observable_name, *const *observable_unit; /* borrowed */
    uint64_t observed;                                           /* rows of observables in the file */
    uint64_t kept, kept_room;                                    /* waiting rows; room for rows */
    uint64_t *kept_step;                                         /* owned, as kept_time and kept_value */
    double *kept_time, *kept_value;
};

/* Reserves room for so many more bytes on the disk. Collective. */
bool h5md_reserve(const struct h5md *h5md, uint64_t bytes, struct error *error);

/* The storage of a dataset of one table a frame in the file. */
struct h5md_stored {
    uint64_t frames, rows; /* tables; rows of the widest */
    uint64_t chunk;        /* rows stored together */
    uint64_t row_bytes;
};

/* Bytes for h5md_reserve: the most that such a dataset needs for one more table, of `rows` rows. Chunks are
 * stored whole. If the new table has more rows than all earlier ones, the earlier tables get chunks, too. */
uint64_t h5md_room(const struct h5md_stored *stored, uint64_t rows);

/* Room for a dataset without its values, and for all other data of a frame. */
enum { H5MD_ROOM_DATASET = 1 << 13, H5MD_ROOM_FRAME = 1 << 17 };

/* Makes the group of a time-dependent element ("/observables/x") with step and time: new datasets, or hard
 * links to step and time of another group. */
bool h5md_make_element(const struct h5md *h5md, const struct h5 *h5, const char *group, const char *linked_to,
                       struct error *error);

/* Writes the unit of a dataset, if it has one. Accepts both "m/s" and "m s-1". */
bool h5md_write_unit(const struct h5md *h5md, const struct h5 *h5, const char *dataset, const char *unit,
                     struct error *error);

/* Adds an element behind the others, in the order of the file. */
struct h5md_element *h5md_add_element(struct h5md *h5md, const char *name, enum field_type type,
                                      int components, bool frames);

/* Adds a frame to the list of frames. */
void h5md_remember(struct h5md *h5md, const struct xdmf_frame *frame);

/* Writes the XDMF file if it is due or, at the end, if it lacks frames. */
bool h5md_update_xdmf(struct h5md *h5md, bool last, struct error *error);

#endif
