/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of checkpoints: writing what is small. */
#ifndef SCREE_FORMATS_CHECKPOINT_HEAD_H
#define SCREE_FORMATS_CHECKPOINT_HEAD_H

#include "formats/checkpoint_put.h"

/* Writes all that is not a row of a particle. Collective. */
bool checkpoint_put_head(struct checkpoint_writing *w, struct error *error);

#endif
