/* SPDX-License-Identifier: BSD-3-Clause */
/* A guard stops or warns. Read trip.h first. */
#include "engine/trip.h"
#include <math.h>
#include <stdio.h>

void trip(enum scene_guard guard, const char *text, struct error *error, const struct log *log,
          bool *warned) {
    if (guard == SCENE_GUARD_STOP) {
        error_set(error, ERROR_PHYSICS, "%s", text);
    } else if (guard == SCENE_GUARD_WARN && !*warned) {
        *warned = true;
        log_tell(log, "warning: %s (said once)", text);
    }
}

void trip_name(const struct particles *particles, const struct box *box, size_t k, char text[TRIP_NAME_MAX]) {
    const double *x = particles->state[k].x, *origin = box->origin;
    snprintf(text, TRIP_NAME_MAX, "particle %lld at (%.6g, %.6g, %.6g)", (long long)particles->id[k],
             x[0] + origin[0], x[1] + origin[1], x[2] + origin[2]);
}

bool trip_finite(const double *value, int count) {
    double sum = 0;
    for (int k = 0; k < count; k++)
        sum += value[k];
    return isfinite(sum);
}
