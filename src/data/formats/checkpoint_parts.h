/* SPDX-License-Identifier: BSD-3-Clause */
/* Parts of a checkpoint, one function each for writing and for reading: the head, and the rows. */
#ifndef SCREE_DATA_FORMATS_CHECKPOINT_PARTS_H
#define SCREE_DATA_FORMATS_CHECKPOINT_PARTS_H

#include "data/formats/checkpoint_io.h"

/* Private part of checkpoints: the small parts, which every rank holds. */

/* Writes the small parts from `state`, or reads them into it; also the share of this rank in the particles when read.
 * Collective. */
bool checkpoint_head(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error);

/* Private part of checkpoints: the fields of particles, and the rows of contacts. */

/* Writes the rows of this rank's particles, from the particles and `state`, or reads them, into particles that are made,
 * and `state`. Collective. */
bool checkpoint_rows(struct checkpoint_io *io, struct particles *particles, struct checkpoint_loaded *state,
                     struct error *error);

#endif
