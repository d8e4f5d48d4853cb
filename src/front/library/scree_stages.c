/* SPDX-License-Identifier: BSD-3-Clause */
/* A simulation goes from stage to stage as a run does: by a checkpoint, from which the simulation of the next stage begins.
 * Read scree_parts.h first. */
#include "front/library/scree_parts.h"
#include "engine/index_view.h"
#include "engine/resume.h"
#include "base/file.h"
#include "data/scene/scene_files.h"
#include "data/scene/scene_read.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Replaces the scene by that of stage `number`. */
static bool take_scene(struct scree_simulation *simulation, int number, struct error *error) {
    struct scene *scene = scene_stage(simulation->scene, number, error);
    if (scene)
        scene_files_open(scene, error);
    if (!comm_agree(&simulation->comm, error)) {
        scene_free(&scene);
        return false;
    }
    scene->output.progress.mode = PROGRESS_OFF;
    simulation->before = simulation->scene;
    simulation->scene = scene;
    return true;
}

bool scree_stages_first(struct scree_simulation *simulation, const char *resume, struct error *error) {
    int first = 0, stages = simulation->scene->stages;
    if (stages == 0)
        return true;
    if (!run_stages_first(&simulation->comm, simulation->scene, resume, &first, error))
        return false;
    if (first == stages)
        return error_set(error, ERROR_USER, "%s: all %d stages are over; add a stage", resume, stages);
    bool good = take_scene(simulation, first, error);
    scene_free(&simulation->before);
    return good;
}

bool scree_stages_begin(struct scree_simulation *simulation, struct error *error) {
    char title[RUN_STAGES_TITLE_MAX];
    struct simulation *s = simulation->state;
    const struct output_view view = simulation_view(s);
    run_stages_open(&simulation->stages, s->scene, &s->stage, &view, &simulation->run, error);
    s->sums_each_step = s->sums_each_step || run_stages_need_work(&simulation->stages);
    if (!comm_agree(&simulation->comm, error))
        return false;
    if (simulation->scene->stages > 0 && simulation->comm.rank == 0) {
        run_stages_title(s->scene, &s->stage, &s->clock, title, sizeof title);
        log_text(&s->caller.log, title);
    }
    return true;
}

bool scree_stages_over(const struct scree_simulation *simulation) {
    const struct scene *scene = simulation->state->scene;
    return scene->stages > 0 && simulation->state->stage.number >= (uint64_t)scene->stages;
}

bool scree_stages_want_sums(const struct scree_simulation *simulation, uint64_t number) {
    return run_stages_due(&simulation->stages, &simulation->state->stage, number) &&
           run_stages_need_sums(&simulation->stages);
}

bool scree_stages_last(const struct scree_simulation *simulation, uint64_t number) {
    return simulation->scene->stages > 0 && run_last_step(simulation->state->scene, &simulation->state->stage,
                                                          &simulation->state->clock) <= number;
}

/* Makes a folder of a name of its own where programs put what they need for a while. Collective. */
static bool folder_create(const struct comm *comm, char *path, struct error *error) {
    const char *place = getenv("TMPDIR");
    if (comm->rank == 0) {
        snprintf(path, FILE_PATH_MAX, "%.900s/scree-XXXXXX", place && place[0] ? place : "/tmp");
        if (mkdtemp(path) == NULL)
            error_set(error, ERROR_SYSTEM,
                      "%s: a folder for the checkpoint between two stages cannot be made: %s", path,
                      strerror(errno));
    }
    comm_broadcast(comm, path, FILE_PATH_MAX);
    return comm_agree(comm, error);
}

/* Makes the simulation of the next stage from the checkpoint `path`. The present one stays where this fails. */
static bool go_on(struct scree_simulation *simulation, const char *path, struct error *error) {
    struct simulation *s = simulation->state;
    double began = timer_now();
    if (!take_scene(simulation, (int)s->stage.number, error))
        return false;
    struct simulation *next =
        simulation_create_for(&s->caller, &simulation->comm, simulation->scene, path, error);
    if (next == NULL) {
        scene_free(&simulation->scene);
        simulation->scene = simulation->before;
        simulation->before = NULL;
        return false;
    }
    next->sources.given = s->sources.given; /* what a force of the caller gave in the last step */
    s->sources.given = (struct given){0};
    scree_observe_end(simulation);
    run_stages_close(&simulation->stages);
    simulation_destroy(&s);
    scene_free(&simulation->before);
    simulation->state = next;
    if (!scree_observe_begin(simulation, true, error) || !scree_stages_begin(simulation, error))
        return false;
    scree_report_begin(simulation, began);
    return true;
}

/* Ends the present stage: a checkpoint, which is deleted unless the caller gave a folder, then the next stage. */
static bool end(struct scree_simulation *simulation, struct error *error) {
    struct simulation *s = simulation->state;
    char folder[FILE_PATH_MAX] = "", path[FILE_PATH_MAX + 40];
    bool kept = simulation->folder[0] != '\0';
    run_stages_end(&s->stage, &s->clock);
    if (scree_stages_over(simulation) && !kept)
        return true;
    if (kept)
        memcpy(folder, simulation->folder, sizeof folder);
    else if (!folder_create(&simulation->comm, folder, error))
        return false;
    snprintf(path, sizeof path, "%s/checkpoint-%llu.h5", folder, (unsigned long long)s->clock.step);
    simulation->run.directory = folder;
    bool good = resume_write(s, &simulation->run, "", error);
    simulation->run.directory = NULL;
    good = good && (scree_stages_over(simulation) || go_on(simulation, path, error));
    if (!kept && simulation->comm.rank == 0) {
        unlink(path);
        rmdir(folder);
    }
    return good;
}

bool scree_stages_advance(struct scree_simulation *simulation, struct error *error) {
    struct simulation *s = simulation->state;
    if (s->scene->stages == 0)
        return true;
    bool last = scree_stages_last(simulation, s->clock.step);
    if (run_stages_due(&simulation->stages, &s->stage, s->clock.step)) {
        physics_look(&s->physics);
        const struct output_view view = simulation_view(s);
        run_stages_look(&simulation->stages, &view, &s->stage, error);
        if (!comm_agree(&simulation->comm, error))
            return false;
    }
    return !last || (scree_observe_keep(simulation, error) && end(simulation, error));
}

const char *scree_stage(const struct scree_simulation *simulation) {
    const struct scene *scene = simulation ? simulation->scene : NULL;
    if (scene == NULL || simulation->state == NULL || scene->stages == 0 || scree_stages_over(simulation))
        return "";
    return scene->stage[simulation->state->stage.number].name;
}
