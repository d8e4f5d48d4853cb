/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of checkpoints: writes tables of rows to the file. */
#ifndef SCREE_FORMATS_CHECKPOINT_PUT_H
#define SCREE_FORMATS_CHECKPOINT_PUT_H

#include "kernel/comm/comm.h"
#include "data/formats/checkpoint_state.h"
#include "data/formats/checkpoint_table.h"
#include "data/formats/h5.h"

/* A checkpoint that is being written. */
struct checkpoint_writing {
    const struct comm *comm;
    const struct checkpoint *checkpoint;
    struct h5 h5;
    struct checkpoint_table table;
    uint64_t first, total; /* particles on the ranks before this one; particles of all ranks */
};

/* Enters a dataset, just written, into the table. This function and all that follow are collective. */
bool checkpoint_enter(struct checkpoint_writing *w, const char *name, const struct h5_table *rows,
                      size_t row_bytes, const void *data, struct error *error);

/* Writes a table, each rank its own rows, and enters the table. */
bool checkpoint_put(struct checkpoint_writing *w, const char *name, const struct h5_table *rows,
                    const void *data, struct error *error);

/* Writes a table that every rank holds; the first rank writes. */
bool checkpoint_put_common(struct checkpoint_writing *w, const char *name, enum field_type type,
                           uint64_t rows, uint64_t width, const void *data, struct error *error);

/* Writes one row of every rank. */
bool checkpoint_put_of_ranks(struct checkpoint_writing *w, const char *name, enum field_type type,
                             uint64_t width, const void *data, struct error *error);

#endif
