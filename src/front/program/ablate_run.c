/* SPDX-License-Identifier: BSD-3-Clause */
/* Runs a scene of a comparison and makes an error of a signal that ends it. */
#include "front/program/ablate_parts.h"
#include "base/memory.h"

bool ablate_run(const struct comm *comm, const struct scene *scene, const struct ablate_options *looks,
                struct report *report, struct error *error) {
    struct run_options options = {.quiet = true, .watch = looks->watch, .series = looks->series};
    memory_peak_reset();
    int status = run_scene(comm, scene, &options, report, error);
    if (status > ERROR_SIGNAL) {
        error_set(error, (enum error_kind)status, "ended by signal %d", status - ERROR_SIGNAL);
        if (report)
            report_destroy(report);
    }
    return status == 0;
}
