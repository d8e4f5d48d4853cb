/* SPDX-License-Identifier: BSD-3-Clause */
/* What guards have in common: they stop or warn, name particles, and know finite numbers. */
#ifndef SCREE_ENGINE_TRIP_H
#define SCREE_ENGINE_TRIP_H

#include "base/error.h"
#include "base/log.h"
#include "kernel/particles/box.h"
#include "kernel/particles/particles.h"
#include "data/scene/scene.h"

/* Stops the run by filling `error`, or warns, if that has not been done (`warned`), as the guard's setting says. */
void trip(enum scene_guard guard, const char *text, struct error *error, const struct log *log, bool *warned);

/* "particle 5 at (1, 2, 3)" in the user's coordinates. */
enum { TRIP_NAME_MAX = 160 };
void trip_name(const struct particles *particles, const struct box *box, size_t k, char text[TRIP_NAME_MAX]);

/* True if all of these numbers are finite, and so is their sum. Any thread. */
bool trip_finite(const double *value, int count);

#endif
