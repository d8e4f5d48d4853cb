/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the H5MD writer: going on with a file that is there. */
#ifndef SCREE_FORMATS_H5MD_RESUME_H
#define SCREE_FORMATS_H5MD_RESUME_H

#include "formats/h5md_file.h"

/* Brings what is known of a present file back and cuts what came after a step. Collective. */
bool h5md_resume(struct h5md *h5md, int64_t step, struct error *error);

/* Only the first half of it. */
bool h5md_recall(struct h5md *h5md, const struct h5 *h5, struct error *error);

#endif
