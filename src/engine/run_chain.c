/* SPDX-License-Identifier: BSD-3-Clause */
/* Runs a scene: as a whole, or stage after stage. Read run.h and run_stages.h first. */
#include "engine/run.h"
#include "data/scene/scene_read.h"
#include <stdio.h>

/* Runs stages, each from the checkpoint at the end of the stage before. The report is that of the last stage. */
static int run_chain(const struct comm *comm, const struct scene *scene, const struct run_options *options,
                     struct report *report, struct error *error) {
    struct run_chain chain = {0};
    struct run_options own = *options;
    char path[FILE_PATH_MAX];
    int status = 0;
    if (options->directory == NULL)
        error_set(error, ERROR_USER, "%s: stages: stages need a folder for their checkpoints", scene->file);
    else if (run_stages_first(comm, scene, options->resume, &chain.first, error) &&
             chain.first == scene->stages && comm->rank == 0)
        fprintf(stderr, "scree: %s: all %d stages are over; nothing to do: add a stage\n", options->resume,
                scene->stages);
    for (int k = chain.first; k < scene->stages && status == 0 && error->kind == ERROR_NONE; k++) {
        struct scene *stage = scene_stage(scene, k, error);
        chain.number = k;
        chain.over = false;
        if (stage && report && chain.done > 0)
            report_destroy(report);
        if (stage)
            status = run_one(comm, stage, &own, &chain, report, error);
        scene_free(&stage);
        snprintf(path, sizeof path, "%s/checkpoint-%llu.h5", options->directory,
                 (unsigned long long)chain.step);
        own.resume = path;
    }
    return error->kind != ERROR_NONE ? (int)error->kind : status;
}

int run_scene(const struct comm *comm, const struct scene *scene, const struct run_options *options,
              struct report *report, struct error *error) {
    return scene->stages > 0 ? run_chain(comm, scene, options, report, error)
                             : run_one(comm, scene, options, NULL, report, error);
}
