/* SPDX-License-Identifier: BSD-3-Clause */
/* What `scree ablate` varies: keys of the scene, each with a list of values. A run has one value of each; all runs together
 * have every combination. */
#ifndef SCREE_PROGRAM_AXIS_H
#define SCREE_PROGRAM_AXIS_H

#include "base/error.h"
#include <stddef.h>

enum { AXES_MAX = 11, AXIS_VALUES_MAX = 32, AXIS_TEXT_MAX = 128, AXIS_SETTING_MAX = 2 * AXIS_TEXT_MAX };

struct axis {
    char key[AXIS_TEXT_MAX]; /* as in --set KEY=VALUE */
    int count;               /* 0: the scene's own value alone */
    char value[AXIS_VALUES_MAX][AXIS_TEXT_MAX];
};

/* Cuts `list` at its commas, those in brackets, braces and quotation marks left out. Fails (user) at an empty or too long value
 * or list; `flag` is what the message names. */
bool axis_cut(struct axis *axis, const char *key, const char *list, const char *flag, struct error *error);

/* The same of "KEY=A,B,...". */
bool axis_cut_setting(struct axis *axis, const char *text, const char *flag, struct error *error);

/* The number of combinations of some axes. */
int axis_runs(const struct axis *axis, int axes);

/* The values of combination `run`: their numbers; the last axis changes first. An axis without values has -1. */
void axis_places(const struct axis *axis, int axes, int run, int at[AXES_MAX]);

/* Writes "KEY=VALUE" of one value. */
void axis_setting(const struct axis *axis, int at, char text[AXIS_SETTING_MAX]);

#endif
