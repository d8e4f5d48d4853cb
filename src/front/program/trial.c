/* SPDX-License-Identifier: BSD-3-Clause */
/* Runs the first steps of a scene and records rebuilds and contacts in these steps. Read trial.h first. */
#include "front/program/trial.h"
#include "engine/simulation.h"
#include "physics/grains/grains.h"
#include "engine/step.h"
#include "engine/run.h"
#include "engine/index_view.h"
#include "data/observe/progress.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { LOOK_EVERY = 16, BRUTE_PAIRS = 1000000 };

static const double seconds_least = 0.5;

void trial_step(struct simulation *s) {
    int64_t every = s->scene->step.rebuild_every;
    s->agree.signals =
        (struct step_signals){.stop = run_signalled() != 0, .error = s->error.kind != ERROR_NONE};
    s->evaluation.virial = s->servo.on;
    s->evaluation.sums = s->sums_each_step || s->servo.on;
    step_run(s, every > 0 && (s->clock.step + 1) % (uint64_t)every == 0);
}

/* Joins the observations of all ranks. Collective. */
static void agree(const struct comm *comm, struct trial *trial, double began) {
    int64_t first[1] = {trial->touched ? -(int64_t)trial->contact_first : INT64_MIN};
    double seconds = timer_now() - began;
    comm_max_int(comm, first, 1);
    comm_max(comm, &seconds, 1);
    trial->touched = first[0] != INT64_MIN;
    trial->contact_first = trial->touched ? (uint64_t)-first[0] : 0;
    trial->seconds = seconds;
}

/* Notes the first step, of number `step`, after which there are contacts, or the lists were made again. */
static void notice(struct trial *trial, uint64_t step, bool touches, bool rebuilt) {
    if (!trial->touched && touches) {
        trial->touched = true;
        trial->contact_first = step;
    }
    if (!trial->rebuilt && rebuilt) {
        trial->rebuilt = true;
        trial->rebuild_first = step;
    }
}

/* Runs the steps of the trial. Returns the signal that ended the trial, or 0. */
static int steps_run(struct simulation *s, struct progress *progress, struct trial *trial) {
    const struct force_sums *sums = &grains_of(&s->physics)->sums;
    uint64_t rebuilds = s->search.skin->rebuilds;
    double began = timer_now();
    notice(trial, s->clock.step, sums->contact_sides > 0, false);
    agree(s->comm, trial, began);
    while (s->clock.step < trial->last) {
        trial_step(s);
        trial->steps++;
        notice(trial, s->clock.step, sums->contact_sides > 0, s->search.skin->rebuilds > rebuilds);
        progress_update(progress, s->clock.step, s->total, s->clock.time);
        if (s->agree.signals.error || (s->ranks.alone && s->error.kind != ERROR_NONE))
            break;
        if (s->agree.signals.stop) {
            int64_t number = run_signalled();
            comm_max_int(s->comm, &number, 1);
            return (int)number;
        }
        if (trial->steps % LOOK_EVERY != 0)
            continue;
        agree(s->comm, trial, began);
        if (trial->rebuilt && trial->touched && trial->seconds > seconds_least)
            break;
    }
    agree(s->comm, trial, began);
    return 0;
}

/* Times brute force on some rows of the present particles; the slowest rank counts. Collective. */
static double brute_time(const struct index_view *view, const struct comm *comm) {
    const struct index_params params = {0};
    struct index_sink sink = {0};
    struct error error = {0};
    struct index *brute = index_create("brute", &params, &error);
    index_build(brute, view);
    size_t rows = view->total ? 1 + BRUTE_PAIRS / view->total : 0, pairs;
    rows = rows < view->owned ? rows : view->owned;
    pairs = rows * view->total - rows * (rows + 1) / 2;
    double began = timer_now(), seconds;
    index_visit(brute, view, 0, rows, &sink);
    seconds = pairs ? (timer_now() - began) / (double)pairs : 0;
    index_destroy(&brute);
    comm_max(comm, &seconds, 1);
    return seconds;
}

bool trial_run(const struct comm *comm, const struct scene *scene, struct trial *trial, struct error *error) {
    static const struct progress_series series = {.name = "a trial", .number = 1, .runs = 1};
    struct progress_options options = scene->output.progress;
    struct progress progress;
    *trial = (struct trial){0};
    if (scene->stages > 0)
        return error_set(
            error, ERROR_USER,
            "%s: stages: scree ablate compares runs without stages (--set 'stages=~' --set duration=...)",
            scene->file);
    struct simulation *s = simulation_create(comm, scene, NULL, error);
    if (s == NULL)
        return false;
    run_signals_catch();
    trial->last = run_last_step(s->scene, &s->stage, &s->clock);
    trial->particles = s->total;
    if (comm->rank != 0)
        options.mode = PROGRESS_OFF;
    progress_start(&progress, &options, &series, stderr, s->clock.step, trial->last);
    int number = steps_run(s, &progress, trial);
    progress_finish(&progress);
    trial->timers = s->timers;
    *error = s->error;
    if (comm_agree(comm, error)) {
        struct index_view view;
        simulation_index_view(s, &view);
        trial->brute_pair = brute_time(&view, comm);
    }
    if (error->kind == ERROR_NONE && number)
        error_set(error, (enum error_kind)(ERROR_SIGNAL + number), "ended by signal %d", number);
    simulation_destroy(&s);
    return error->kind == ERROR_NONE;
}

/* Adds "WHAT (the first time is at step 12)" to a list. */
static void lack(char *text, size_t room, const char *what, bool met, uint64_t first) {
    size_t used = strlen(text);
    char when[48] = "never in the whole run";
    if (met)
        snprintf(when, sizeof when, "the first time is at step %" PRIu64, first);
    snprintf(text + used, room - used, "%s%s (%s)", used ? " and " : "", what, when);
}

bool trial_suffices(const struct trial *trial, uint64_t steps, const char *flag, struct error *error) {
    bool rebuilt = trial->rebuilt && trial->rebuild_first <= steps,
         touched = trial->touched && trial->contact_first <= steps;
    char lacks[256] = "", advice[96] = "give a longer duration, or let particles meet sooner";
    uint64_t needed =
        trial->rebuild_first > trial->contact_first ? trial->rebuild_first : trial->contact_first;
    if (!rebuilt)
        lack(lacks, sizeof lacks, "no list of pairs is made again", trial->rebuilt, trial->rebuild_first);
    if (!touched)
        lack(lacks, sizeof lacks, "nothing touches", trial->touched, trial->contact_first);
    if (trial->rebuilt && trial->touched)
        snprintf(advice, sizeof advice, "needed: %" PRIu64 " steps or more, better ten times as many",
                 needed);
    return (rebuilt && touched) ||
           error_set(error, ERROR_USER,
                     "command line: %s: a comparison of %" PRIu64
                     " steps would say nothing of what indexes and laws cost, as in them %s; %s",
                     flag, steps, lacks, advice);
}
