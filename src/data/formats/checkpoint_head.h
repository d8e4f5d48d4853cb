/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of checkpoints: writes the small parts. */
#ifndef SCREE_FORMATS_CHECKPOINT_HEAD_H
#define SCREE_FORMATS_CHECKPOINT_HEAD_H

#include "data/formats/checkpoint_put.h"

/* Writes all data except for rows of particles. Collective. */
bool checkpoint_put_head(struct checkpoint_writing *w, struct error *error);

#endif
