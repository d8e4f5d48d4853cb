/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of the H5MD writer: makes the file, without particles. */
#ifndef SCREE_FORMATS_H5MD_HEAD_H
#define SCREE_FORMATS_H5MD_HEAD_H

#include "data/formats/h5md_file.h"

/* Makes the file with all parts but particles. Collective. */
bool h5md_make_file(struct h5md *h5md, const struct box *box, struct error *error);

/* For a box that moves, where edges of the head would be wrong: makes the element /particles/all/box/edges, a
 * matrix a frame whose rows are the edge vectors, and writes those of the next frame. Nothing for a box at rest.
 * Collective. */
bool h5md_make_edges(const struct h5md *h5md, const struct h5 *h5, const struct box *box,
                     const char *linked_to, struct error *error);
bool h5md_write_edges(const struct h5md *h5md, const struct h5 *h5, const struct box *box,
                      struct error *error);

/* Writes the runs that led to this state, /parameters/runs/STEP/scene with version and revision, in place of
 * the runs in the file, and links /parameters/scene to the scene of the last run. Collective. */
bool h5md_write_runs(const struct h5md *h5md, const struct h5 *h5, struct error *error);

#endif
