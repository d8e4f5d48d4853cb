/* SPDX-License-Identifier: BSD-3-Clause */
/* One run of a comparison, without files. */
#ifndef SCREE_PROGRAM_ABLATE_RUN_H
#define SCREE_PROGRAM_ABLATE_RUN_H

#include "engine/run.h"

/* Options of a run of a comparison: observer and progress. */
struct ablate_options {
    const struct run_watch *watch;
    const struct progress_series *series;
};

/* Runs a scene without files; members of `options` and `report` may be NULL. With a series progress is shown.
 * A signal that ends the run is an error of kind ERROR_SIGNAL + number. Collective. */
bool ablate_run(const struct comm *comm, const struct scene *scene, const struct ablate_options *options,
                struct report *report, struct error *error);

#endif
