/* SPDX-License-Identifier: BSD-3-Clause */
/* The operations of the contract for an index made of levels: an index of this kind supplies its plan alone.
 */
#ifndef SCREE_INDEX_LEVELS_LEVELS_INDEX_H
#define SCREE_INDEX_LEVELS_LEVELS_INDEX_H

#include "index/levels/levels.h"

/* Decides the grids for a view. `plan` comes zeroed, with `fixed` set everywhere if the user gave
 * cell_factor. */
typedef void levels_planner(const struct index_params *params, const struct index_view *view,
                            struct levels_plan *plan);

struct index *levels_index_create(const struct index_params *params, levels_planner *planner);

/* Operations, for the table of the index. */
void levels_index_destroy(struct index *self);
bool levels_index_stays(struct index *self, const struct index_view *view);
void levels_index_order(struct index *self, const struct index_view *view, uint32_t *order);
void levels_index_build(struct index *self, const struct index_view *view);
void levels_index_visit(const struct index *self, const struct index_view *view, size_t first, size_t last,
                        struct index_sink *sink);
bool levels_index_check(const struct index *self, const struct index_view *view, char why[INDEX_WHY_MAX]);
void levels_index_describe(const struct index *self, struct index_description *description);
size_t levels_index_memory(const struct index *self);
void levels_index_release(struct index *self);

/* All of them, in the initialiser of the table; name, summary and `create` are the index's own. */
#define LEVELS_INDEX_OPERATIONS                                                                              \
    .destroy = levels_index_destroy, .stays = levels_index_stays, .order = levels_index_order,               \
    .build = levels_index_build, .visit = levels_index_visit, .check = levels_index_check,                   \
    .describe = levels_index_describe, .memory = levels_index_memory, .release = levels_index_release

/* The user's cell factor, or the default. */
double levels_index_factor(const struct index_params *params, double fallback);

#endif
