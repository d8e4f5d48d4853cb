/* SPDX-License-Identifier: BSD-3-Clause */
/* Packings of two sizes. */
#ifndef SCREE_PACK_BIDISPERSE_H
#define SCREE_PACK_BIDISPERSE_H

#include "front/pack/work.h"

/* The recipe of Stratford, Shire and Hanley. Large spheres are of material 1. */
bool bidisperse_make(struct pack_work *work, struct error *error);

#endif
