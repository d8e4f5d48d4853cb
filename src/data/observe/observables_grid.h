/* SPDX-License-Identifier: BSD-3-Clause */
/* Fields on a grid: density, velocity, stress and others, coarse-grained, in DIR/grid-NAME.csv. A grid with one cell in
 * two directions is a profile. With a kernel phi of integral 1 (Goldhirsch, Granular Matter 12 (2010) 239):
 *
 *     density      rho(r) = sum over particles of m phi(r - r_i)
 *     velocity     V(r) = sum of m v_i phi(r - r_i) / rho
 *     stress       sum of m phi (v_i - V)(v_i - V)  +  sum over contacts of f l times the mean of phi along l
 *
 * l leads from one centre to the other, or to the wall, and f is the force along it, so that pressure is positive, as for
 * the observable `stress`. The kernel `cells` is 1/volume in the cell of a point, so that sums over all cells are those of
 * all particles in the grid; `gauss` is a product of Gaussians, cut at four widths. Along a direction with one cell both
 * are 1/length. Prescribed particles count for the contacts alone. */
#ifndef SCREE_OBSERVE_OBSERVABLES_GRID_H
#define SCREE_OBSERVE_OBSERVABLES_GRID_H

#include "data/formats/output.h"

/* A grid with its file. */
struct grid;

/* True if the file of a grid in `directory` has its columns, or is not there or empty. Changes nothing; one rank. */
bool observables_grid_suits(const struct output_grid *options, const char *directory, struct error *error);

/* Checks a grid and opens its file in `directory`; on a resume (`resume_time` >= 0) rows after that time are cut off.
 * `options` is borrowed. Fails (user) on a file with other columns. Collective. */
bool observables_grid_open(struct grid **grid, const struct output_grid *options,
                           const struct output_view *view, const char *directory, double resume_time,
                           struct error *error);

/* Writes a row for each cell. Collective. */
bool observables_grid_write(struct grid *grid, const struct output_view *view, struct error *error);

void observables_grid_close(struct grid **grid);

#endif
