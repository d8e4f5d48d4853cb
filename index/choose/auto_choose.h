/* SPDX-License-Identifier: BSD-3-Clause */
/* Choosing by the cost model (cost.h): cuts between size classes, the classes that share a grid, and the size
 * of the cells. The result depends on the particles alone, not on a clock or a state. So a repeated or
 * resumed run makes the same choice, and a scene that grows is noticed at the next rebuild. */
#ifndef SCREE_INDEX_CHOOSE_AUTO_CHOOSE_H
#define SCREE_INDEX_CHOOSE_AUTO_CHOOSE_H

#include "index/choose/cost.h"

/* A scene's bins from `n` > 0 radii in ascending order, each of which stands for `weight` particles; the
 * caller sets the rest of the scene. */
void auto_bins(struct cost_scene *scene, const double *radii, size_t n, double weight);

/* The levels, with their cells, that cost least; at most `most`. */
void auto_levels(const struct cost_scene *scene, int most, struct cost_plan *plan);

/* Finds the neighbouring bins, each a size class, that share a level at least cost, and the levels' cells. */
void auto_group(const struct cost_scene *scene, struct cost_plan *plan);

/* The best cells for the given levels: sets plan->edge. Returns cost_seconds. */
double auto_edges(const struct cost_scene *scene, struct cost_plan *plan);

/* `levels` levels of equal occupancy, count x cut-off^dimension, as far as the bins allow (fewer if there are
 * fewer bins): the hypothesis of Ogarko and Luding. Edges are the cut-offs. */
void auto_equal(const struct cost_scene *scene, int levels, struct cost_plan *plan);

#endif
