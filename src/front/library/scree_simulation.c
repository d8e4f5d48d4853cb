/* SPDX-License-Identifier: BSD-3-Clause */
/* A simulation in another program: made, stepped, ended. Read scree.h first. */
#include "front/library/scree_parts.h"
#include "base/memory.h"
#include "engine/checked.h"
#include "engine/outputs.h"
#include "engine/run.h"
#include "data/scene/scene_files.h"
#include "data/scene/scene_read.h"
#include "data/scene/scene_text.h"
#include <omp.h>
#include <stdio.h>
#include <string.h>

/* Hands a line to the caller. */
static void tell(void *context, const char *line) {
    const struct scree_simulation *simulation = context;
    if (simulation->log)
        simulation->log(simulation->log_context, line);
}

/* The force of the caller; in the first evaluation the state is still unknown to the library. */
static void force(void *context, struct simulation *state) {
    struct scree_simulation *simulation = context;
    simulation->state = state;
    simulation->force(simulation->force_context, simulation);
}

/* Reads the scene. NULL with an error. Collective. */
static struct scene *scene_make(const struct comm *comm, const char *file, const char *text,
                                const struct scree_options *options, struct error *error) {
    struct scene *scene = NULL;
    char *read = NULL;
    struct scene_setting *set =
        memory_allocate((size_t)(options->sets > 0 ? options->sets : 0), sizeof *set, "settings");
    for (int k = 0; k < options->sets; k++) {
        set[k].text = options->set ? options->set[k] : NULL;
        if (set[k].text == NULL || strchr(set[k].text, '=') == NULL)
            error_set(error, ERROR_USER, "set %s: must read KEY=VALUE",
                      set[k].text ? set[k].text : "(nothing)");
    }
    if (options->folder && strlen(options->folder) >= sizeof((struct scree_simulation *)0)->folder)
        error_set(error, ERROR_USER, "the name of the folder for checkpoints is too long");
    if (error->kind == ERROR_NONE && file == NULL && text == NULL)
        error_set(error, ERROR_USER, "there is neither a file nor a text of a scene");
    if (error->kind == ERROR_NONE && text == NULL && scene_read_text(file, &read, NULL, error))
        text = read;
    if (error->kind == ERROR_NONE)
        scene = scene_parse(file ? file : "scene", text, set, options->sets, error);
    if (scene)
        scene_files_open(scene, error);
    memory_free(read);
    memory_free(set);
    if (!comm_agree(comm, error))
        scene_free(&scene);
    return scene;
}

/* Makes the parts of a simulation whose ranks are known. Collective. */
static bool fill(struct scree_simulation *simulation, const char *file, const char *text,
                 const struct scree_options *options, struct error *error) {
    double began = timer_now();
    const struct simulation_caller caller = {.log = {.tell = tell, .context = simulation},
                                             .force = options->force ? force : NULL,
                                             .context = simulation};
    error_set_log(&caller.log);
    simulation->scene = scene_make(&simulation->comm, file, text, options, error);
    if (simulation->scene == NULL)
        return false;
    if (simulation->scene->note[0] && simulation->comm.rank == 0)
        log_text(&caller.log, simulation->scene->note);
    if (!scree_stages_first(simulation, options->resume, error))
        return false;
    simulation->scene->output.progress.mode = PROGRESS_OFF;
    simulation->state =
        simulation_create_for(&caller, &simulation->comm, simulation->scene, options->resume, error);
    if (!simulation->state || !scree_observe_begin(simulation, options->resume != NULL, error) ||
        !scree_stages_begin(simulation, error))
        return false;
    scree_report_begin(simulation, began);
    return true;
}

struct scree_simulation *scree_create(const char *file, const char *text, const struct scree_options *options,
                                      struct scree_error *error) {
    static const struct scree_options none;
    struct error own = {0};
    int threads = omp_get_max_threads();
    options = options ? options : &none;
    struct scree_simulation *simulation = memory_allocate_zero(1, sizeof *simulation, "simulation");
    simulation->log = options->log;
    simulation->log_context = options->log_context;
    simulation->force = options->force;
    simulation->force_context = options->force_context;
    if (options->folder)
        snprintf(simulation->folder, sizeof simulation->folder, "%s", options->folder);
    simulation->busy = true;
    bool joined = comm_join(&simulation->comm, options->communicator, &own);
    bool good = joined && fill(simulation, file, text, options, &own);
    simulation->busy = false;
    if (joined && !good)
        scree_destroy(&simulation);
    if (!joined) {
        memory_free(simulation);
        simulation = NULL;
    }
    scree_parts_leave(simulation, threads);
    scree_parts_tell(&own, error);
    return simulation;
}

void scree_destroy(struct scree_simulation **simulation) {
    struct scree_simulation *s = simulation ? *simulation : NULL;
    if (s == NULL || s->busy)
        return;
    int threads = scree_parts_enter(s);
    scree_observe_end(s);
    scree_observe_drop(s);
    run_stages_close(&s->stages);
    simulation_destroy(&s->state);
    scene_free(&s->scene);
    scene_free(&s->before);
    comm_leave(&s->comm);
    error_set_log(NULL);
    memory_free(s->row);
    memory_free(s->report);
    memory_free(s);
    *simulation = NULL;
    scree_parts_leave(NULL, threads);
}

/* One step, with its row if one is due. `last`: the sums of observables are wanted whatever the scene says. False if
 * the simulation must end. */
static bool step(struct scree_simulation *simulation, bool last, struct error *error) {
    struct simulation *s = simulation->state;
    uint64_t next = s->clock.step + 1;
    double time = clock_time(&s->clock, next);
    s->agree.signals = (struct step_signals){.error = s->error.kind != ERROR_NONE};
    bool ends = scree_stages_last(simulation, next), rebuild = simulation->changed || ends;
    bool sums =
        last || ends || scree_observe_due(simulation, next, time) || scree_stages_want_sums(simulation, next);
    bool seen = sums || run_stages_due(&simulation->stages, &s->stage, next);
    simulation->since = timer_now();
    simulation->changed = false; /* a force of the caller may change something again */
    checked_step(s, sums, rebuild, seen);
    scree_observe_drop(simulation);
    simulation->record.particle_steps += (double)s->total;
    if (s->agree.signals.error || (s->ranks.alone && s->error.kind != ERROR_NONE))
        return false;
    bool good = (!scree_observe_due(simulation, s->clock.step, s->clock.time) ||
                 scree_observe_record(simulation, error)) &&
                scree_stages_advance(simulation, error);
    simulation->spent += timer_now() - simulation->since;
    return good;
}

bool scree_step(struct scree_simulation *simulation, uint64_t steps, struct scree_error *error) {
    struct error refusal = {0};
    if (!scree_parts_free(simulation, &refusal))
        return scree_parts_tell(&refusal, error);
    struct error *own = &simulation->error;
    int threads = scree_parts_enter(simulation);
    bool good = own->kind == ERROR_NONE;
    for (uint64_t k = 0; good && k < steps && !scree_stages_over(simulation); k++)
        good = step(simulation, k + 1 == steps, own);
    if (own->kind == ERROR_NONE)
        *own = simulation->state->error;
    comm_agree(&simulation->comm, own);
    scree_parts_leave(simulation, threads);
    return scree_parts_tell(own, error);
}

/* True if there is a state; a simulation that is being made has none yet. */
static bool is_made(const struct scree_simulation *simulation) {
    return simulation && simulation->state;
}

/* The clock of the state; zeros where there is none. */
static struct clock clock_of(const struct scree_simulation *simulation) {
    return is_made(simulation) ? simulation->state->clock : (struct clock){0};
}

uint64_t scree_steps_left(const struct scree_simulation *simulation) {
    const struct clock clock = clock_of(simulation);
    if (!is_made(simulation) || scree_stages_over(simulation))
        return 0;
    uint64_t last = run_last_step(simulation->state->scene, &simulation->state->stage, &clock);
    return last > clock.step ? last - clock.step : 0;
}

uint64_t scree_step_number(const struct scree_simulation *simulation) {
    return clock_of(simulation).step;
}

double scree_time(const struct scree_simulation *simulation) {
    return clock_of(simulation).time;
}

double scree_time_step(const struct scree_simulation *simulation) {
    return clock_of(simulation).dt;
}

uint64_t scree_particles(const struct scree_simulation *simulation) {
    return is_made(simulation) ? simulation->state->total : 0;
}

const char *scree_scene(const struct scree_simulation *simulation) {
    return simulation && simulation->run.scene ? simulation->run.scene : "";
}
