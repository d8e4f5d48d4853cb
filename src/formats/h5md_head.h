/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the H5MD writer: the file when it is made, with all but particles. */
#ifndef SCREE_FORMATS_H5MD_HEAD_H
#define SCREE_FORMATS_H5MD_HEAD_H

#include "formats/h5md_file.h"

/* Makes the file with all but particles. Collective. */
bool h5md_make_file(struct h5md *h5md, const struct box *box, struct error *error);

/* Writes the runs that led here, /parameters/runs/STEP/scene with version and revision, in place of those
 * that are there, and links /parameters/scene to the last one's. Collective. */
bool h5md_write_runs(const struct h5md *h5md, const struct h5 *h5, struct error *error);

#endif
