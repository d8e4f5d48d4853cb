/* SPDX-License-Identifier: BSD-3-Clause */
/* The few calls of HDF5 that the other files of formats/ need, each checked. HDF5's own printing is off; its
 * innermost message goes into ours, which names file and object.
 *
 * With a comm, a file is opened by all ranks together and every call on it is collective; what one rank alone
 * meets (a failed write) is agreed before the call returns, so that ranks never part. With NULL it belongs to
 * one rank. `rows` are always those of the second-slowest place: a dataset holds tables, one or (growing) one
 * a frame, and each rank reads and writes consecutive rows. */
#ifndef SCREE_FORMATS_H5_H
#define SCREE_FORMATS_H5_H

#include "comm/comm.h"
#include "core/error.h"
#include "formats/output_options.h"
#include "particles/fields.h"
#include <hdf5.h>

struct h5 {
    hid_t file;              /* < 0: closed */
    hid_t transfer;          /* how data moves: collective or alone */
    const struct comm *comm; /* borrowed; NULL: one rank alone */
    int folder;              /* handle of its folder where that has a long name (file_shorten); -1: none */
    char path[FILE_PATH_MAX];
};

/* A table: `rows` x `width` values, rows [first, first + count) of it here. width 0: one value a row, and no
 * dimension for it. */
struct h5_table {
    enum field_type type;
    uint64_t rows, width;
    uint64_t first, count;
};

/* Dimensions of a dataset. */
struct h5_shape {
    int rank;
    hsize_t size[4];
    hsize_t chunk[4]; /* what is stored together; 0: all of it */
    H5T_class_t type;
    size_t bytes; /* of one value */
};

/* Names of what is in a group; owned, memory_free. */
struct h5_names {
    size_t count;
    char (*name)[OUTPUT_NAME_MAX];
};

/* Makes a file (replacing any), with `user_block` bytes (0, or a power of two >= 512) left free at its start.
 */
bool h5_create(struct h5 *h5, const char *path, const struct comm *comm, uint64_t user_block,
               struct error *error);
bool h5_open(struct h5 *h5, const char *path, const struct comm *comm, bool write, struct error *error);
/* Flushes and closes; also right after an error of the user. A closed one is fine. A file of which a write
 * failed is left as it is (output_left_open). */
bool h5_close(struct h5 *h5, struct error *error);

/* Sets an error of this kind: "PATH: OBJECT: WHAT: text of HDF5". Returns false. */
bool h5_fail(const struct h5 *h5, enum error_kind kind, const char *object, const char *what,
             struct error *error);

/* Makes one rank's error that of all; true if there is none. */
bool h5_agree(const struct h5 *h5, struct error *error);

bool h5_exists(const struct h5 *h5, const char *object);
bool h5_is_group(const struct h5 *h5, const char *object);

/* Lists the objects of a group by name, in alphabetical order (longer names than OUTPUT_NAME_MAX are left
 * out). */
bool h5_list(const struct h5 *h5, const char *group, struct h5_names *names, struct error *error);

/* Makes a group and those above it. */
bool h5_make_group(const struct h5 *h5, const char *group, struct error *error);

/* Takes an object, with what is below it, out of the file; none is fine. Its room is not used again. */
bool h5_remove(const struct h5 *h5, const char *object, struct error *error);

/* Gives an object a second name. */
bool h5_link(const struct h5 *h5, const char *present, const char *added, struct error *error);

/* Attributes: a fixed-length string; `n` strings of one length; integers (n = 0: one, scalar); doubles; a
 * reference to an object. */
bool h5_write_text(const struct h5 *h5, const char *object, const char *name, const char *text,
                   struct error *error);
bool h5_write_texts(const struct h5 *h5, const char *object, const char *name, const char *const *text, int n,
                    struct error *error);
bool h5_write_ints(const struct h5 *h5, const char *object, const char *name, const int *value, int n,
                   struct error *error);
bool h5_write_doubles(const struct h5 *h5, const char *object, const char *name, const double *value, int n,
                      struct error *error);
bool h5_write_reference(const struct h5 *h5, const char *object, const char *name, const char *target,
                        struct error *error);

/* Reads attributes: false without an error where there is none, or not of this form. */
bool h5_read_texts(const struct h5 *h5, const char *object, const char *name, char (*text)[OUTPUT_NAME_MAX],
                   int n);
bool h5_read_doubles(const struct h5 *h5, const char *object, const char *name, double *value, int n);

/* A dataset of one string. */
bool h5_write_string(const struct h5 *h5, const char *dataset, const char *text, struct error *error);
/* Reads it; memory_free. NULL on failure. */
char *h5_read_string(const struct h5 *h5, const char *dataset, struct error *error);

/* Makes a dataset of one table and writes it. */
bool h5_write_table(const struct h5 *h5, const char *dataset, const struct h5_table *table, const void *data,
                    struct error *error);

/* A dataset of a table a frame, which grows: made with no frame. chunk_rows: rows stored together. `fill`
 * (one value of the type; NULL: all rows of all frames are always written) is what absent rows hold. */
bool h5_make_frames(const struct h5 *h5, const char *dataset, const struct h5_table *table,
                    uint64_t chunk_rows, const void *fill, struct error *error);

/* Writes frame `frame`, growing the dataset in frames and rows where needed. */
bool h5_write_frame(const struct h5 *h5, const char *dataset, const struct h5_table *table, uint64_t frame,
                    const void *data, struct error *error);

/* A dataset of one value a frame; `values` are the same on every rank and one rank writes them. */
bool h5_make_series(const struct h5 *h5, const char *dataset, enum field_type type, struct error *error);
bool h5_write_series(const struct h5 *h5, const char *dataset, enum field_type type, uint64_t first,
                     uint64_t count, const void *values, struct error *error);

/* Cuts a growing dataset to so many frames. */
bool h5_cut_frames(const struct h5 *h5, const char *dataset, uint64_t frames, struct error *error);

bool h5_get_shape(const struct h5 *h5, const char *dataset, struct h5_shape *shape, struct error *error);

/* Reads a block of a dataset as `type`, whatever number type it holds. start and count have the dataset's
 * rank. */
bool h5_read_block(const struct h5 *h5, const char *dataset, enum field_type type, const hsize_t *start,
                   const hsize_t *count, void *data, struct error *error);

/* The fill value of an integer dataset; false if none was set. */
bool h5_read_fill(const struct h5 *h5, const char *dataset, int64_t *fill);

/* Where the bytes of a dataset of one table lie in the file. False if they do not lie together or there are
 * none. */
bool h5_get_place(const struct h5 *h5, const char *dataset, uint64_t *offset, uint64_t *bytes);

/* HDF5's types: in files and in memory. */
hid_t h5_type(enum field_type type);

#endif
