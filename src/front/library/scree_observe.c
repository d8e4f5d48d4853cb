/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables and checkpoints of a simulation in another program. Read scree.h first. */
#include "front/library/scree_parts.h"
#include "base/memory.h"
#include "engine/outputs.h"
#include "engine/rebuild.h"
#include "engine/resume.h"
#include "engine/index_view.h"
#include <assert.h>
#include <string.h>

static size_t row_length(const struct scree_simulation *simulation) {
    return 1 + (size_t)observables_columns(simulation->observables);
}

/* Computes the observables of this moment. Collective. */
static bool compute(struct scree_simulation *simulation, struct error *error) {
    struct simulation *s = simulation->state;
    physics_look(&s->physics);
    struct output_view view = simulation_view(s);
    return observables_write(simulation->observables, &view, error);
}

bool scree_observe_due(const struct scree_simulation *simulation, uint64_t number, double time) {
    const struct output_interval *every = &simulation->scene->output.observables.every;
    return output_interval_due(every, number, time, simulation->state->clock.dt);
}

bool scree_observe_record(struct scree_simulation *simulation, struct error *error) {
    size_t length = row_length(simulation);
    if (!compute(simulation, error))
        return false;
    if (simulation->rows == simulation->room) {
        simulation->room = simulation->room ? 2 * simulation->room : 64;
        simulation->row =
            memory_resize(simulation->row, simulation->room * length, sizeof(double), "rows of observables");
    }
    double *row = simulation->row + simulation->rows++ * length;
    row[0] = simulation->state->clock.time;
    memcpy(row + 1, observables_values(simulation->observables), (length - 1) * sizeof(double));
    return true;
}

bool scree_observe_begin(struct scree_simulation *simulation, bool resumed, struct error *error) {
    struct simulation *s = simulation->state;
    simulation->run = outputs_run(s->scene, &s->box, &s->lineage, NULL);
    struct output_view view = simulation_view(s);
    observables_create(&simulation->observables, &s->scene->output.observables, &view, &simulation->run,
                       error);
    if (!comm_agree(s->comm, error))
        return false;
    assert(simulation->kept == NULL || observables_columns(simulation->observables) == simulation->columns);
    simulation->columns = observables_columns(simulation->observables);
    s->sums_each_step = s->sums_each_step || observables_need_work(simulation->observables);
    return resumed || !scree_observe_due(simulation, s->clock.step, s->clock.time) ||
           scree_observe_record(simulation, error);
}

void scree_observe_end(struct scree_simulation *simulation) {
    observables_destroy(&simulation->observables);
}

bool scree_observe_keep(struct scree_simulation *simulation, struct error *error) {
    size_t columns = row_length(simulation) - 1;
    if (!compute(simulation, error))
        return false;
    simulation->kept = memory_resize(simulation->kept, columns, sizeof(double), "observables of a stage");
    if (columns > 0)
        memcpy(simulation->kept, observables_values(simulation->observables), columns * sizeof(double));
    return true;
}

void scree_observe_drop(struct scree_simulation *simulation) {
    memory_free(simulation->kept);
    simulation->kept = NULL;
}

int scree_columns(const struct scree_simulation *simulation) {
    return simulation && simulation->observables ? observables_columns(simulation->observables) : 0;
}

static bool column_is(const struct scree_simulation *simulation, int column) {
    return column >= 0 && column < scree_columns(simulation);
}

const char *scree_column_name(const struct scree_simulation *simulation, int column) {
    return column_is(simulation, column) ? observables_column_name(simulation->observables, column) : NULL;
}

const char *scree_column_unit(const struct scree_simulation *simulation, int column) {
    return column_is(simulation, column) ? observables_column_unit(simulation->observables, column) : NULL;
}

bool scree_observe(struct scree_simulation *simulation, double *values, struct scree_error *error) {
    struct error own = {0};
    if (!scree_parts_free(simulation, &own))
        return scree_parts_tell(&own, error);
    int threads = scree_parts_enter(simulation);
    if (simulation->kept || compute(simulation, &own))
        memcpy(values, simulation->kept ? simulation->kept : observables_values(simulation->observables),
               (row_length(simulation) - 1) * sizeof(double));
    scree_parts_leave(simulation, threads);
    return scree_parts_tell(&own, error);
}

size_t scree_rows(const struct scree_simulation *simulation) {
    return simulation ? simulation->rows : 0;
}

const double *scree_row(const struct scree_simulation *simulation, size_t row) {
    return row < scree_rows(simulation) ? simulation->row + row * row_length(simulation) : NULL;
}

bool scree_checkpoint(struct scree_simulation *simulation, const char *directory, struct scree_error *error) {
    struct error own = {0};
    if (!scree_parts_free(simulation, &own))
        return scree_parts_tell(&own, error);
    struct simulation *s = simulation->state;
    own = simulation->error;
    if (directory == NULL)
        error_set(&own, ERROR_USER, "a checkpoint needs a folder");
    int threads = scree_parts_enter(simulation);
    if (own.kind == ERROR_NONE) {
        s->sources.last_step = s->clock.step; /* nobody comes or goes here */
        s->search.sorts = true;
        rebuild_run(s);
        simulation->run.directory = directory;
        resume_write(s, &simulation->run, "", &own);
        comm_agree(s->comm, &own);
        simulation->run.directory = NULL;
    }
    scree_parts_leave(simulation, threads);
    return scree_parts_tell(&own, error);
}
