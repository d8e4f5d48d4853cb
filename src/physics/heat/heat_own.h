/* SPDX-License-Identifier: BSD-3-Clause */
/* What the observables of heat ask of its own data (output_view.own). */
#ifndef SCREE_HEAT_HEAT_OWN_H
#define SCREE_HEAT_HEAT_OWN_H

#include <stddef.h>

struct heat;

/* The power from a wall into the grains of this rank in the last step, W. One thread. */
double heat_wall_power(const struct heat *heat, int wall);

/* m c T of grain i, with the heat of the last step, which the temperature takes in the next: energy. Any thread. */
double heat_energy(const struct heat *heat, size_t i);

#endif
