/* SPDX-License-Identifier: BSD-3-Clause */
/* The table at the start of a checkpoint: text in the first CHECKPOINT_BLOCK bytes, which HDF5 leaves free.
 *
 *   scree checkpoint 2
 *   bytes SIZE
 *   dataset NAME OFFSET BYTES ROW_BYTES CHECKSUM     (one line each)
 *   rest CHECKSUM                                    of every byte after the table that is in no dataset
 *   table CHECKSUM                                   of the text above
 *   zeros up to the end of the block
 *
 * So every bit of the file is covered. A dataset's checksum is the sum of the hashes of its rows
 * (base/checksum.h), which the ranks compute together, from memory when a file is written, and from the bytes
 * of the file when it is checked. */
#ifndef SCREE_FORMATS_CHECKPOINT_TABLE_H
#define SCREE_FORMATS_CHECKPOINT_TABLE_H

#include "kernel/comm/comm.h"
#include "base/error.h"
#include "data/formats/output_options.h"

enum { CHECKPOINT_BLOCK = 8192, CHECKPOINT_DATASETS_MAX = 80, CHECKPOINT_VERSION = 2 };

struct checkpoint_entry {
    char name[OUTPUT_NAME_MAX];
    uint64_t offset, bytes, row_bytes; /* bytes 0: empty */
    uint64_t checksum;
};

struct checkpoint_table {
    uint64_t bytes; /* of the file */
    int entries;
    struct checkpoint_entry entry[CHECKPOINT_DATASETS_MAX];
    uint64_t rest;
};

/* Reads and checks the table of a file and its size; the first rank opens the file. Collective. */
bool checkpoint_table_read(struct checkpoint_table *table, const struct comm *comm, const char *path,
                           struct error *error);

/* Fills `bytes` and `rest` from the closed file and writes the table into it. Collective. */
bool checkpoint_table_write(struct checkpoint_table *table, const struct comm *comm, const char *path,
                            struct error *error);

/* The checksum of the bytes behind the table that are in no dataset, from an open file. False if the file
 * cannot be read (errno). One rank. */
bool checkpoint_table_sum_rest(const struct checkpoint_table *table, int handle, uint64_t *sum);

#endif
