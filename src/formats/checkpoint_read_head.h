/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of checkpoints: reading what is small. */
#ifndef SCREE_FORMATS_CHECKPOINT_READ_HEAD_H
#define SCREE_FORMATS_CHECKPOINT_READ_HEAD_H

#include "comm/comm.h"
#include "formats/checkpoint_file.h"
#include "formats/checkpoint_state.h"

/* A checkpoint that is being read. */
struct checkpoint_reading {
    const struct comm *comm;
    struct checkpoint_file file;
    struct checkpoint_loaded *loaded;
    uint64_t first, count; /* particles of this rank */
};

/* Reads a table that every rank gets whole: `rows` of `width` values (0: one). Collective, as the next one.
 */
bool checkpoint_get_common(struct checkpoint_reading *r, const char *name, enum field_type type,
                           uint64_t rows, uint64_t width, void *data, struct error *error);

/* Reads all that is not a row of a particle. */
bool checkpoint_get_head(struct checkpoint_reading *r, struct error *error);

#endif
