/* SPDX-License-Identifier: BSD-3-Clause */
/* Private parts of checkpoints: a file that is read without HDF5; a checkpoint that is being written or read; its parts, one
 * function each for writing and for reading. */
#ifndef SCREE_DATA_FORMATS_CHECKPOINT_PARTS_H
#define SCREE_DATA_FORMATS_CHECKPOINT_PARTS_H

#include "data/formats/checkpoint_table.h"
#include "kernel/comm/comm.h"
#include "data/formats/checkpoint_state.h"
#include "data/formats/h5.h"

/* A checkpoint that is open for reading: plain reads at the places of its table, no reads by HDF5. The
 * checksum of the bytes in memory is compared with the table before any code uses the bytes, so neither
 * damage nor a failed read can be mistaken for data.
 *
 * Every rank opens the file by itself, and all ranks agree on errors before the first read and after each
 * read. A file that cannot be opened or read is an error of the system; a file with a wrong checksum is an
 * error of the user. */

struct checkpoint_file {
    const struct comm *comm;                /* borrowed */
    int handle;                             /* -1: closed */
    bool compared[CHECKPOINT_DATASETS_MAX]; /* by entry: the bytes agree with the checksum */
    struct checkpoint_table table;
    char path[FILE_PATH_MAX];
};

/* Opens a file on all ranks, reads the table, and compares all bytes with the table except for those of the
 * large datasets (/particles, /full_step, /history and /wall_history). The large datasets are compared when they are
 * read, or by checkpoint_file_compare. After an error no file stays open. Collective. */
bool checkpoint_file_open(struct checkpoint_file *file, const struct comm *comm, const char *path,
                          struct error *error);
void checkpoint_file_close(struct checkpoint_file *file);

/* Compares the datasets that have not been read yet. Collective. */
bool checkpoint_file_compare(struct checkpoint_file *file, struct error *error);

/* The entry of a dataset, or NULL. */
const struct checkpoint_entry *checkpoint_file_find(const struct checkpoint_file *file, const char *dataset);

/* Rows of a dataset, each of `row_bytes` bytes. */
struct checkpoint_rows {
    const char *dataset;
    size_t row_bytes;
    uint64_t rows;         /* of the dataset */
    uint64_t first, count; /* of this rank: each row belongs to exactly one rank */
};

/* Reads this rank's rows into `data` (count x row_bytes). Collective. */
bool checkpoint_file_read(struct checkpoint_file *file, const struct checkpoint_rows *rows, void *data,
                          struct error *error);

/* A checkpoint that is being written or read. The parts of a checkpoint (checkpoint_head.c,
 * checkpoint_rows.c) hand their tables to the functions here, which either write or read them; so a part states its names,
 * shapes and order once, for both.
 *
 * The bytes still take two ways. All ranks write by HDF5: other programs can open the file, and MPI knows how several
 * ranks write into one file on each file system. Each rank reads by plain reads: HDF5 would take a failed read, or a
 * damaged byte, for data, or wait for ever (h5_watch.h); a plain read tells of it, and the checksum of the bytes in
 * memory is compared before any code uses the bytes. */

struct checkpoint_io {
    const struct comm *comm;
    const struct checkpoint *written; /* its source; NULL: the checkpoint is read */
    struct h5 h5;                     /* open for writing */
    struct checkpoint_file file;      /* open for reading; when writing its table is filled */
    bool full;                        /* velocities are read at the full step */
    uint64_t first, count, total;     /* particles: this rank's rows, among those of all ranks */
};

/* Writes or reads this rank's rows of a table. This function and all that follow are collective, but for the two that
 * find datasets. */
bool checkpoint_io_rows(struct checkpoint_io *io, const char *name, const struct h5_table *rows, void *data,
                        struct error *error);

/* The same of a table that every rank holds: `rows` rows of `width` values (width 0: one value). */
bool checkpoint_io_common(struct checkpoint_io *io, const char *name, enum field_type type, uint64_t rows,
                          uint64_t width, void *data, struct error *error);

/* The same of a table with a row for each of `ranks` ranks. Each rank writes its own row, and reads all of them. */
bool checkpoint_io_of_ranks(struct checkpoint_io *io, const char *name, enum field_type type, int ranks,
                            uint64_t width, void *data, struct error *error);

/* The same of a text; when read, it is made, and belongs to the caller (memory_free). */
bool checkpoint_io_text(struct checkpoint_io *io, const char *name, char **text, struct error *error);

/* True if the file that is read has a dataset. */
bool checkpoint_io_has(const struct checkpoint_io *io, const char *name);

/* The number of rows of a dataset with `row_bytes` bytes a row, 0 without it; of one that is written, `written`. */
uint64_t checkpoint_io_count(const struct checkpoint_io *io, const char *name, size_t row_bytes,
                             uint64_t written);

/* The small parts, which every rank holds. */

/* Writes the small parts from `state`, or reads them into it; also the share of this rank in the particles when read.
 * Collective. */
bool checkpoint_head(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error);

/* The fields of particles, and the rows of contacts. */

/* Writes the rows of this rank's particles, from the particles and `state`, or reads them, into particles that are made,
 * and `state`. Collective. */
bool checkpoint_rows(struct checkpoint_io *io, struct particles *particles, struct checkpoint_loaded *state,
                     struct error *error);

#endif
