/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of checkpoints: reads the small parts. */
#ifndef SCREE_FORMATS_CHECKPOINT_READ_HEAD_H
#define SCREE_FORMATS_CHECKPOINT_READ_HEAD_H

#include "kernel/comm/comm.h"
#include "data/formats/checkpoint_file.h"
#include "data/formats/checkpoint_state.h"

/* A checkpoint that is being read. */
struct checkpoint_reading {
    const struct comm *comm;
    struct checkpoint_file file;
    struct checkpoint_loaded *loaded;
    uint64_t first, count; /* particles of this rank */
};

/* Reads a table that every rank gets whole: `rows` rows of `width` values (width 0: one value). Collective,
 * as the next function. */
bool checkpoint_get_common(struct checkpoint_reading *r, const char *name, enum field_type type,
                           uint64_t rows, uint64_t width, void *data, struct error *error);

/* Reads all data except for rows of particles. */
bool checkpoint_get_head(struct checkpoint_reading *r, struct error *error);

#endif
