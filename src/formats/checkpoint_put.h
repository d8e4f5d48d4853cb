/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of checkpoints: tables of rows on their way into the file. */
#ifndef SCREE_FORMATS_CHECKPOINT_PUT_H
#define SCREE_FORMATS_CHECKPOINT_PUT_H

#include "comm/comm.h"
#include "formats/checkpoint_state.h"
#include "formats/checkpoint_table.h"
#include "formats/h5.h"

/* A checkpoint on its way. */
struct checkpoint_writing {
    const struct comm *comm;
    const struct checkpoint *checkpoint;
    struct h5 h5;
    struct checkpoint_table table;
    uint64_t first, total; /* particles before this rank's, and of all */
};

/* Enters a dataset, just written, into the table. Collective, as all that follow. */
bool checkpoint_enter(struct checkpoint_writing *w, const char *name, const struct h5_table *rows,
                      size_t row_bytes, const void *data, struct error *error);

/* Writes a table, each rank its rows, and enters it. */
bool checkpoint_put(struct checkpoint_writing *w, const char *name, const struct h5_table *rows,
                    const void *data, struct error *error);

/* Writes a table that every rank has: the first writes it. */
bool checkpoint_put_common(struct checkpoint_writing *w, const char *name, enum field_type type,
                           uint64_t rows, uint64_t width, const void *data, struct error *error);

/* Writes one row of every rank. */
bool checkpoint_put_of_ranks(struct checkpoint_writing *w, const char *name, enum field_type type,
                             uint64_t width, const void *data, struct error *error);

#endif
