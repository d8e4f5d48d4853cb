/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of checkpoints: the small parts, which every rank holds. */
#ifndef SCREE_FORMATS_CHECKPOINT_HEAD_H
#define SCREE_FORMATS_CHECKPOINT_HEAD_H

#include "data/formats/checkpoint_io.h"

/* Writes the small parts from `state`, or reads them into it; also the share of this rank in the particles when read.
 * Collective. */
bool checkpoint_head(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error);

#endif
