/* SPDX-License-Identifier: BSD-3-Clause */
/* A packing as the cost model sees it, and the events of one rebuild, counted by the search itself: what the model
 * predicts, without a clock. */
#ifndef SCREE_TESTS_INDEX_BENCH_EVENTS_H
#define SCREE_TESTS_INDEX_BENCH_EVENTS_H

#include "index/choose/cost.h"
#include "tests/index/bench_scene.h"

/* The packing in the form of the cost model; margins are `skin` times the smallest radius. */
void bench_describe(const struct index_view *view, double skin, struct cost_scene *scene);

/* Classes of the packing, one for each level of the plan, and their margins. */
void bench_classes(struct bench_scene *packing, const struct cost_scene *scene, const struct cost_plan *plan,
                   double skin);

/* Sorts and builds the packing, which has these classes, with the plan's cells, searches it and counts the events.
 * The particles change their order. One thread. */
void bench_events(struct bench_scene *packing, const struct cost_plan *plan, double count[COST_TERMS]);

#endif
