/* SPDX-License-Identifier: BSD-3-Clause */
/* A frame in the H5MD file. */
#ifndef SCREE_FORMATS_H5MD_FRAME_H
#define SCREE_FORMATS_H5MD_FRAME_H

#include "data/formats/frame.h"

struct h5md;

/* Appends a frame; does nothing if the file already holds that step. Collective. */
bool h5md_write_frame(struct h5md *h5md, const struct frame *frame, struct error *error);

#endif
