/* SPDX-License-Identifier: BSD-3-Clause */
/* Data of drag that its observables read (output_view.own). */
#ifndef SCREE_DRAG_DRAG_OWN_H
#define SCREE_DRAG_DRAG_OWN_H

#include "drag/drag.h"

struct drag;

const struct drag_options *drag_options_of(const struct drag *drag);

/* Work of drag and buoyancy on the grains of this rank since the start; energy. One thread. */
double drag_work(const struct drag *drag);

#endif
