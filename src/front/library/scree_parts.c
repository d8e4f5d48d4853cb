/* SPDX-License-Identifier: BSD-3-Clause */
/* What each function of the library begins and ends with. Read scree_parts.h first. */
#include "front/library/scree_parts.h"
#include <omp.h>
#include <stdio.h>

bool scree_parts_free(const struct scree_simulation *simulation, struct error *error) {
    if (simulation == NULL || simulation->state == NULL)
        return error_set(error, ERROR_USER, "there is no simulation, or it is still being made");
    return !simulation->busy ||
           error_set(
               error, ERROR_USER,
               "a function that the simulation calls, as `force`, may not run, observe, save or end it");
}

bool scree_parts_tell(const struct error *own, struct scree_error *error) {
    if (error) {
        error->status = (enum scree_status)own->kind;
        snprintf(error->text, sizeof error->text, "%s", own->text);
    }
    return own->kind == ERROR_NONE;
}

int scree_parts_enter(struct scree_simulation *simulation) {
    int threads = omp_get_max_threads();
    simulation->busy = true;
    if (simulation->state)
        omp_set_num_threads(simulation->state->team.size);
    return threads;
}

void scree_parts_leave(struct scree_simulation *simulation, int threads) {
    if (simulation)
        simulation->busy = false;
    omp_set_num_threads(threads);
}
