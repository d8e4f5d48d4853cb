/* SPDX-License-Identifier: BSD-3-Clause */
/* The ends of stages: by duration, or by conditions on observables. Read run_stages.h first. */
#include "engine/run_stages.h"
#include "data/formats/checkpoint.h"
#include <assert.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* One condition as an observable; needs one column. */
static bool condition_open(struct run_stages *stages, const struct scene *scene,
                           const struct output_view *view, const struct output_run *run, int k,
                           struct error *error) {
    struct observables_options options = scene->output.observables;
    char key[64];
    struct error plain = {0};
    options.count = 1;
    options.request[0] = stages->stage->condition[k].request;
    snprintf(key, sizeof key, "stages[%d].until[%d]", (int)(stages->stage - scene->stage), k);
    if (!observables_create(&stages->condition[k], &options, view, run, &plain))
        return scene_fail(scene, error, key, "stage '%s': %s", stages->stage->name, plain.text);
    stages->conditions = k + 1;
    return observables_columns(stages->condition[k]) == 1 ||
           scene_fail(scene, error, key, "stage '%s': the condition has %d columns; needed: one",
                      stages->stage->name, observables_columns(stages->condition[k]));
}

bool run_stages_open(struct run_stages *stages, const struct scene *scene, const struct stage_place *place,
                     const struct output_view *view, const struct output_run *run, struct error *error) {
    *stages = (struct run_stages){.first = view->step};
    if (scene->stages == 0)
        return true;
    stages->stage = &scene->stage[place->number];
    for (int k = 0; k < stages->stage->conditions; k++)
        if (!condition_open(stages, scene, view, run, k, error))
            return false;
    return true;
}

void run_stages_close(struct run_stages *stages) {
    for (int k = 0; k < stages->conditions; k++)
        observables_destroy(&stages->condition[k]);
    stages->conditions = 0;
}

bool run_stages_due(const struct run_stages *stages, const struct stage_place *place, uint64_t step) {
    return stages->conditions > 0 && place->last == 0 && step % (uint64_t)stages->stage->every == 0;
}

bool run_stages_need_sums(const struct run_stages *stages) {
    bool needed = false;
    for (int k = 0; k < stages->conditions; k++)
        needed = needed || observables_need_sums(stages->condition[k]);
    return needed;
}

bool run_stages_need_work(const struct run_stages *stages) {
    bool needed = false;
    for (int k = 0; k < stages->conditions; k++)
        needed = needed || observables_need_work(stages->condition[k]);
    return needed;
}

void run_stages_look(struct run_stages *stages, const struct output_view *view, struct stage_place *place,
                     struct error *error) {
    int64_t missed = view->time - place->began < stages->stage->after * (1 - 1e-12);
    for (int k = 0; k < stages->conditions; k++) {
        const struct scene_condition *condition = &stages->stage->condition[k];
        if (!observables_write(stages->condition[k], view, error))
            return;
        double value = observables_values(stages->condition[k])[0];
        bool low = !isnan(condition->at_least) && !(value >= condition->at_least);
        bool high = !isnan(condition->at_most) && !(value <= condition->at_most);
        missed += low || high;
    }
    comm_max_int(view->comm, &missed, 1);
    if (missed == 0) {
        place->last = view->step + 1;
        stages->met = true;
    }
}

uint64_t run_stages_last(const struct scene *scene, const struct stage_place *place,
                         const struct clock *clock, uint64_t most) {
    const struct scene_stage *stage = &scene->stage[place->number];
    double left = ceil((place->began + stage->duration - clock->time) / clock->dt - 1e-6);
    uint64_t last = most;
    if (left < (double)(most - clock->step))
        last = left > 0 ? clock->step + (uint64_t)left : clock->step;
    return place->last > 0 && place->last < last ? place->last : last;
}

void run_stages_end(struct stage_place *place, const struct clock *clock) {
    *place = (struct stage_place){.number = place->number + 1, .began = clock->time};
}

void run_stages_add(const struct run_stages *stages, const struct clock *clock, struct run_chain *chain,
                    double seconds) {
    const char *end = "broken off";
    if (chain->over && stages->met)
        end = "conditions";
    else if (chain->over)
        end = stages->conditions > 0 ? "duration, before the conditions held" : "duration";
    struct run_stage *row = &chain->row[chain->done++];
    *row = (struct run_stage){
        .first = stages->first, .last = clock->step, .time = clock->time, .seconds = seconds, .end = end};
    snprintf(row->name, sizeof row->name, "%s", stages->stage->name);
    chain->step = clock->step;
}

bool run_stages_first(const struct comm *comm, const struct scene *scene, const char *resume, int *first,
                      struct error *error) {
    struct checkpoint_loaded loaded = {0};
    struct restart list = {0};
    uint64_t number = 0;
    *first = 0;
    if (resume == NULL)
        return true;
    if (!checkpoint_read_head(comm, resume, &loaded, error))
        return false;
    restart_add(&list, RESTART_INTEGER, true, &number, "stage: number");
    bool good = restart_take(&list, &loaded.restart, resume, error);
    restart_free(&list);
    checkpoint_loaded_free(&loaded);
    if (good && number > (uint64_t)scene->stages)
        error_set(error, ERROR_USER, "%s: it was written in stage %d of a scene; this scene has %d stages",
                  resume, (int)number + 1, scene->stages);
    *first = good ? (int)number : 0;
    return comm_agree(comm, error) && good;
}

void run_stages_title(const struct scene *scene, const struct stage_place *place, const struct clock *clock,
                      char *text, size_t size) {
    snprintf(text, size, "stage '%s' (%d of %d) from step %" PRIu64 ", t = %.9g",
             scene->stage[place->number].name, (int)place->number + 1, scene->stages, clock->step,
             clock->time);
}
