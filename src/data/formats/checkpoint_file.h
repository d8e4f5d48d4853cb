/* SPDX-License-Identifier: BSD-3-Clause */
/* A checkpoint that is open for reading: plain reads at the places of its table, no reads by HDF5. The
 * checksum of the bytes in memory is compared with the table before any code uses the bytes, so neither
 * damage nor a failed read can be mistaken for data.
 *
 * Every rank opens the file by itself, and all ranks agree on errors before the first read and after each
 * read. A file that cannot be opened or read is an error of the system; a file with a wrong checksum is an
 * error of the user. */
#ifndef SCREE_FORMATS_CHECKPOINT_FILE_H
#define SCREE_FORMATS_CHECKPOINT_FILE_H

#include "data/formats/checkpoint_table.h"

struct checkpoint_file {
    const struct comm *comm;                /* borrowed */
    int handle;                             /* -1: closed */
    bool compared[CHECKPOINT_DATASETS_MAX]; /* by entry: the bytes agree with the checksum */
    struct checkpoint_table table;
    char path[FILE_PATH_MAX];
};

/* Opens a file on all ranks, reads the table, and compares all bytes with the table except for those of the
 * large datasets (/particles, /history and /wall_history). The large datasets are compared when they are
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

#endif
