/* SPDX-License-Identifier: BSD-3-Clause */
/* A set of grids, each with the particles of some classes, and the searches of the rows of each class: the
 * common body of linkcell, multi, bytype and hgrid, which differ in the distribution of the classes and in
 * the size of the cells.
 *
 * The searches of a row of class c (i the row, own = the grid of its class):
 *
 *   table                            which pairs are kept                                      rule
 *   owned of its own grid            partners in later slots: each pair once, for any image    half
 *   owned of grids of larger classes all: the smaller looks up the larger                      full
 *   owned of grids of smaller        none; or all, at the build, where that costs less         full
 *   ghosts of its own grid           newton on: those whose home is i; off: all                home, full
 *   ghosts of grids of larger        all: the smaller is the home                              full
 *   ghosts of grids of smaller       newton on: none; off: all                                 none, full
 *
 * Tables without a partner of the row's class (index_wanted) are left out. A class without any partner class
 * has no table: its grid is idle.
 *
 * If the larger particles are few, they look up the smaller ones at the build instead (cross.h), and no row
 * of the smaller particles searches the table of the larger ones. */
#ifndef SCREE_INDEX_LEVELS_LEVELS_H
#define SCREE_INDEX_LEVELS_LEVELS_H

#include "index/grids/levels_parts.h"

/* The number of cells of a grid with this edge in y and z over a volume (2D: an area); true if the grid is
 * kept sparse, as the cells are too many for the number of particles. */
double levels_cells(double volume, double edge, int dimension);
bool levels_too_many_cells(double cells, double particles);

/* The factor, 1 ... 2.5, by which the edge of so many cells in `directions` directions grows to keep the grid dense. */
double levels_growth(double cells, double particles, int directions);

void levels_start(struct levels *levels, const struct index_params *params);
void levels_free(struct levels *levels);

/* Back to what levels_start left. */
void levels_release(struct levels *levels);

/* The operations of the contract, for a plan made from the same view (levels_plan_apart ends it). */
bool levels_stays(struct levels *levels, const struct levels_plan *plan, const struct index_view *view);
void levels_order(struct levels *levels, const struct levels_plan *plan, const struct index_view *view,
                  uint32_t *order);
void levels_build(struct levels *levels, const struct levels_plan *plan, const struct index_view *view);
void levels_visit(const struct levels *levels, const struct index_view *view, size_t first, size_t last,
                  struct index_sink *sink);
bool levels_check(const struct levels *levels, const struct index_view *view, char why[INDEX_WHY_MAX]);
void levels_describe(const struct levels *levels, struct index_description *description);
size_t levels_memory(const struct levels *levels);

#endif
