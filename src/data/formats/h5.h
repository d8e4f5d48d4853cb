/* SPDX-License-Identifier: BSD-3-Clause */
/* The few calls of HDF5 that the other files of formats/ need, each checked. HDF5's own printing is off; the
 * program's message names file and object and contains HDF5's innermost message.
 *
 * With a comm, a file is opened by all ranks together and every call on the file is collective. An error of
 * one rank (a failed write) becomes an error of all ranks before the call returns, so that all ranks continue
 * alike. With NULL the file belongs to one rank. A dataset holds one table or, if it grows, one table a
 * frame; `rows` are the rows of a table, and each rank reads and writes consecutive rows. */
#ifndef SCREE_FORMATS_H5_H
#define SCREE_FORMATS_H5_H

#include "kernel/comm/comm.h"
#include "base/error.h"
#include "data/formats/output_options.h"
#include "kernel/particles/fields.h"
#include <hdf5.h>

struct h5 {
    hid_t file;              /* < 0: closed */
    hid_t transfer;          /* transfer list: collective or independent */
    const struct comm *comm; /* borrowed; NULL: one rank alone */
    int folder;              /* handle of the folder if the path is long (file_shorten); -1: none */
    char path[FILE_PATH_MAX];
};

/* A table: `rows` x `width` values, this rank has rows [first, first + count). width 0: one value a row,
 * without a dimension for the width. */
struct h5_table {
    enum field_type type;
    bool single; /* frames of DOUBLE alone: floats, in the file and in the data that are given */
    int deflate; /* h5_make_frames: shuffled and compressed, 1 (fast) to 9 (small); 0: not */
    uint64_t rows, width;
    uint64_t first, count;
};

/* Dimensions of a dataset. */
struct h5_shape {
    int rank;
    hsize_t size[4];
    hsize_t chunk[4]; /* size of a chunk; 0: not chunked */
    H5T_class_t type;
    size_t bytes; /* of one value */
};

/* Names of the objects in a group; owned, memory_free. */
struct h5_names {
    size_t count;
    char (*name)[OUTPUT_NAME_MAX];
};

/* Makes a file (replacing any), with `user_block` bytes (0, or a power of two >= 512) left free at its start.
 */
bool h5_create(struct h5 *h5, const char *path, const struct comm *comm, uint64_t user_block,
               struct error *error);
bool h5_open(struct h5 *h5, const char *path, const struct comm *comm, bool write, struct error *error);
/* Flushes and closes; allowed after an error of the user, and for a closed file. A file with a failed write
 * stays open (output_left_open). */
bool h5_close(struct h5 *h5, struct error *error);

/* Sets an error of this kind: "PATH: OBJECT: WHAT: text of HDF5". Returns false. */
bool h5_fail(const struct h5 *h5, enum error_kind kind, const char *object, const char *what,
             struct error *error);

/* Makes the error of one rank the error of all ranks; true if no rank has an error. */
bool h5_agree(const struct h5 *h5, struct error *error);

bool h5_exists(const struct h5 *h5, const char *object);
bool h5_is_group(const struct h5 *h5, const char *object);

/* Lists the objects of a group by name, in alphabetical order (longer names than OUTPUT_NAME_MAX are left
 * out). */
bool h5_list(const struct h5 *h5, const char *group, struct h5_names *names, struct error *error);

/* Makes a group and all groups above it. */
bool h5_make_group(const struct h5 *h5, const char *group, struct error *error);

/* Removes an object, with all objects below, from the file; a missing object is allowed. The room of the
 * object is not used again. */
bool h5_remove(const struct h5 *h5, const char *object, struct error *error);

/* Gives an object a second name. */
bool h5_link(const struct h5 *h5, const char *present, const char *added, struct error *error);

/* Attributes: a fixed-length string; `n` strings of one length; integers (n = 0: one, scalar); doubles; a
 * reference to an object. */
bool h5_write_text(const struct h5 *h5, const char *object, const char *name, const char *text,
                   struct error *error);
/* As h5_write_text, but a string of variable length, which h5py reads as text, not as bytes. */
bool h5_write_free_text(const struct h5 *h5, const char *object, const char *name, const char *text,
                        struct error *error);
bool h5_write_texts(const struct h5 *h5, const char *object, const char *name, const char *const *text, int n,
                    struct error *error);
bool h5_write_ints(const struct h5 *h5, const char *object, const char *name, const int *value, int n,
                   struct error *error);
bool h5_write_doubles(const struct h5 *h5, const char *object, const char *name, const double *value, int n,
                      struct error *error);
bool h5_write_reference(const struct h5 *h5, const char *object, const char *name, const char *target,
                        struct error *error);

/* Reads attributes: false without an error if the attribute is missing or has another form. */
bool h5_read_texts(const struct h5 *h5, const char *object, const char *name, char (*text)[OUTPUT_NAME_MAX],
                   int n);
bool h5_read_doubles(const struct h5 *h5, const char *object, const char *name, double *value, int n);

/* Makes and writes a dataset of one string. */
bool h5_write_string(const struct h5 *h5, const char *dataset, const char *text, struct error *error);
/* Reads a dataset of one string; memory_free. NULL on failure. */
char *h5_read_string(const struct h5 *h5, const char *dataset, struct error *error);

/* Makes a dataset of one table and writes it. */
bool h5_write_table(const struct h5 *h5, const char *dataset, const struct h5_table *table, const void *data,
                    struct error *error);

/* Makes a growing dataset of one table a frame, without frames at first. chunk_rows: rows stored together.
 * `fill` (one value of the type; NULL: all rows of all frames are always written) is the value of absent
 * rows. */
bool h5_make_frames(const struct h5 *h5, const char *dataset, const struct h5_table *table,
                    uint64_t chunk_rows, const void *fill, struct error *error);

/* Writes frame `frame`; the dataset grows in frames and rows as needed. */
bool h5_write_frame(const struct h5 *h5, const char *dataset, const struct h5_table *table, uint64_t frame,
                    const void *data, struct error *error);

/* Makes, and writes, a dataset of one value a frame; `values` are the same on every rank, and one rank writes
 * the values. */
bool h5_make_series(const struct h5 *h5, const char *dataset, enum field_type type, struct error *error);
bool h5_write_series(const struct h5 *h5, const char *dataset, enum field_type type, uint64_t first,
                     uint64_t count, const void *values, struct error *error);

/* Cuts a growing dataset to `frames` frames. */
bool h5_cut_frames(const struct h5 *h5, const char *dataset, uint64_t frames, struct error *error);

bool h5_get_shape(const struct h5 *h5, const char *dataset, struct h5_shape *shape, struct error *error);

/* Reads a block of a dataset as `type`, from any number type in the file. start and count have the dataset's
 * rank. */
bool h5_read_block(const struct h5 *h5, const char *dataset, enum field_type type, const hsize_t *start,
                   const hsize_t *count, void *data, struct error *error);

/* The fill value of an integer dataset; false if none was set. */
bool h5_read_fill(const struct h5 *h5, const char *dataset, int64_t *fill);

/* Finds the place of the bytes of a dataset of one table in the file. False if the bytes do not lie together,
 * or there are none. */
bool h5_get_place(const struct h5 *h5, const char *dataset, uint64_t *offset, uint64_t *bytes);

/* HDF5's types: in files and in memory. */
hid_t h5_type(enum field_type type);

#endif
