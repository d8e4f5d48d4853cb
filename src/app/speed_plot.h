/* SPDX-License-Identifier: BSD-3-Clause */
/* The picture of speed against error. Labels are placed here, as gnuplot would print one over the other. */
#ifndef SCREE_APP_SPEED_PLOT_H
#define SCREE_APP_SPEED_PLOT_H

#include "app/speed_error.h"

/* Writes DIR/speed_error.gp, and DIR/speed_error.svg by gnuplot, if it is found (a warning where not). Errors
 * below the floor stand on it. Each point of the front has a label; others have one where there is room. Rank
 * 0 alone. Fails (system) where the script cannot be written. */
bool speed_plot(const struct speed_report *report, const char *directory, struct error *error);

#endif
