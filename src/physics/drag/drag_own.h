/* SPDX-License-Identifier: BSD-3-Clause */
/* Data of drag that its observables read (output_view.own). */
#ifndef SCREE_DRAG_DRAG_OWN_H
#define SCREE_DRAG_DRAG_OWN_H

#include "physics/drag/drag.h"

struct drag;

/* Density and radius up to which grains take part. */
double drag_density(const struct drag *drag);
double drag_reach(const struct drag *drag);

/* The superficial velocity of the fluid at a time; NAN of one that the section `fluid` resolves. */
void drag_velocity(const struct drag *drag, double time, double velocity[3]);

/* Work of drag and buoyancy on the grains of this rank since the start; energy. One thread. */
double drag_work(const struct drag *drag);

#endif
