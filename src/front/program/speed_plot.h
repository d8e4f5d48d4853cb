/* SPDX-License-Identifier: BSD-3-Clause */
/* The picture of speed against error. This code places the labels, as gnuplot would print labels on top of
 * each other. */
#ifndef SCREE_PROGRAM_SPEED_PLOT_H
#define SCREE_PROGRAM_SPEED_PLOT_H

#include "front/program/speed_error.h"

/* Writes DIR/speed_error.gp, and DIR/speed_error.svg by gnuplot (a warning if gnuplot is not found). Errors
 * below the floor are drawn on the floor. Each point of the front has a label; other points have one if there
 * is room. Only rank 0. Fails (system) if the script cannot be written. */
bool speed_plot(const struct speed_report *report, const char *directory, struct error *error);

#endif
