/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws of sizes as size laws of a scene, and the published systems. */
#ifndef SCREE_PACK_RECIPE_SIZES_H
#define SCREE_PACK_RECIPE_SIZES_H

#include "front/pack/recipe_work.h"

/* The size law of the source, its keys of a scene left out. */
bool recipe_sizes(struct recipe_work *work);

/* Count and edge of the published cube where the user gives none. */
bool recipe_published(struct recipe_work *work);

/* The two sources of the law bidisperse, and their cube. */
bool recipe_bidisperse(struct recipe_work *work);

#endif
