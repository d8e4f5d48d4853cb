/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads particles from any H5MD file, not only from those of this program: elements fixed or time-dependent,
 * any number type, a 2D or 3D box, rows that the id's fill value marks as absent, `species` if there is no
 * `material`. */
#ifndef SCREE_FORMATS_H5MD_READ_H
#define SCREE_FORMATS_H5MD_READ_H

#include "kernel/comm/comm.h"
#include "base/error.h"
#include "data/formats/rows.h"

struct h5md_read_options {
    const char *group; /* below /particles; NULL: "all" if it exists, else the only group */
    int64_t frame;     /* counted from 0, negative from the end (-1: the last) */
};

/* Reads one frame. With a comm each rank gets a slice of the rows (rows.first, rows.total) and all must call;
 * with NULL the caller gets all rows. Position is required, all other columns are optional. Columns with
 * wrong shapes, different lengths, or frames that do not exist are a user's error that names file and object.
 * `rows` is filled (rows_free releases). */
bool h5md_read(const char *path, const struct h5md_read_options *options, const struct comm *comm,
               struct rows *rows, struct error *error);

/* The values of one field in one frame, for all particles of the frame: of a field with several components the component
 * `component`, or with -1 the length of the vector. A field that the file lacks is a user's error that lists the fields.
 * Fills ids, too (from 1 on if the file has none); memory_free releases both. One rank. */
struct h5md_values {
    size_t count;
    int64_t *id;
    double *value;
};
bool h5md_read_values(const char *path, int64_t frame, const char *name, int component,
                      struct h5md_values *values, struct error *error);

/* Sets `has` if the particles (all, or the only group) have a field. One rank. */
bool h5md_has_field(const char *path, const char *name, bool *has, struct error *error);

/* Number of frames of a group (1 if nothing depends on time). One rank. */
bool h5md_read_frames(const char *path, const char *group, uint64_t *frames, struct error *error);

#endif
