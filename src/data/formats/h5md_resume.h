/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of the H5MD writer: continues an existing file. */
#ifndef SCREE_FORMATS_H5MD_RESUME_H
#define SCREE_FORMATS_H5MD_RESUME_H

#include "data/formats/h5md_file.h"

/* Fills `h5md` from an existing file, and cuts off data after a step. Collective. */
bool h5md_resume(struct h5md *h5md, int64_t step, struct error *error);

/* Checks that the file fits `varying`: a file made for a fixed set of particles holds their ids only once. */
bool h5md_check_varying(const struct h5md *h5md, const struct h5 *h5, struct error *error);

/* Only fills `h5md` from the existing file. */
bool h5md_recall(struct h5md *h5md, const struct h5 *h5, struct error *error);

#endif
