/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of checkpoints: a checkpoint that is being written or read. The parts of a checkpoint (checkpoint_head.h,
 * checkpoint_rows.h) hand their tables to the functions here, which either write or read them; so a part states its names,
 * shapes and order once, for both.
 *
 * The bytes still take two ways. All ranks write by HDF5: other programs can open the file, and MPI knows how several
 * ranks write into one file on each file system. Each rank reads by plain reads: HDF5 would take a failed read, or a
 * damaged byte, for data, or wait for ever (h5_watch.h); a plain read tells of it, and the checksum of the bytes in
 * memory is compared before any code uses the bytes. */
#ifndef SCREE_FORMATS_CHECKPOINT_IO_H
#define SCREE_FORMATS_CHECKPOINT_IO_H

#include "kernel/comm/comm.h"
#include "data/formats/checkpoint_file.h"
#include "data/formats/checkpoint_state.h"
#include "data/formats/h5.h"

struct checkpoint_io {
    const struct comm *comm;
    const struct checkpoint *written; /* its source; NULL: the checkpoint is read */
    struct h5 h5;                     /* open for writing */
    struct checkpoint_file file;      /* open for reading; when writing its table is filled */
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

#endif
