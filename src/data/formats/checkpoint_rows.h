/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of checkpoints: the fields of particles, and the rows of contacts. */
#ifndef SCREE_FORMATS_CHECKPOINT_ROWS_H
#define SCREE_FORMATS_CHECKPOINT_ROWS_H

#include "data/formats/checkpoint_io.h"

/* Writes the rows of this rank's particles, from the particles and `state`, or reads them, into particles that are made,
 * and `state`. Collective. */
bool checkpoint_rows(struct checkpoint_io *io, struct particles *particles, struct checkpoint_loaded *state,
                     struct error *error);

#endif
