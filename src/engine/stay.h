/* SPDX-License-Identifier: BSD-3-Clause */
/* Rebuilds in which no particle changes its place in memory or its rank. */
#ifndef SCREE_ENGINE_STAY_H
#define SCREE_ENGINE_STAY_H

#include "engine/rebuild_rows.h"

/* The pass of the rebuild that decides whether particles stay as they lie, on their ranks and in the order of the last
 * build of the index: rows->stays. Collective. */
void stay_decide(struct simulation *simulation, struct rebuild_rows *rows);

#endif
