/* SPDX-License-Identifier: BSD-3-Clause */
/* The life of a run, or of one of its stages: folder, simulation, loop, signals, checkpoints, report. Read run.h
 * first. */
#include "engine/run.h"
#include "engine/simulation.h"
#include "engine/stages.h"
#include "engine/checked.h"
#include "engine/resume_check.h"
#include "engine/step.h"
#include "engine/folder.h"
#include "engine/index_view.h"
#include "engine/load_balance.h"
#include "engine/notes.h"
#include "engine/outputs.h"
#include "engine/resume.h"
#include "engine/run_report.h"
#include "engine/run_stages.h"
#include "base/log.h"
#include "base/memory.h"
#include "data/formats/checkpoint.h"
#include "data/observe/progress.h"
#include "data/observe/report_json.h"
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

/* The only variable that the signal handler changes. */
static volatile sig_atomic_t run_signal;

static void on_signal(int number) {
    run_signal = number;
}

/* A signal that came after an earlier run is kept: this signal ends the present run. */
void run_signals_catch(void) {
    struct sigaction action = {.sa_handler = on_signal};
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGINT, &action, NULL);
}

int run_signalled(void) {
    return run_signal;
}

/* A run in progress. */
struct run {
    struct simulation *s;
    struct outputs *outputs; /* NULL: no files */
    struct output_run output;
    const struct run_options *options;
    struct progress progress;
    uint64_t last; /* number of the last step */
    struct run_record record;
    double checkpoint_last; /* seconds: the last checkpoint by wall clock */
    bool checkpoint_due;    /* decided in the previous step */
    int lock;               /* handle of the folder's lock */
    bool crowd_told;        /* the message that other programs use the cores was printed */
    struct run_stages stages;
    struct run_chain *chain; /* borrowed; NULL: the scene has no stages */
};

/* The largest number of steps of a run: a run of infinite or huge duration ends here, or by a signal. */
static const uint64_t steps_most = (uint64_t)1 << 62;

uint64_t run_last_step(const struct scene *scene, const struct stage_place *stage,
                       const struct clock *clock) {
    if (scene->stages > 0)
        return run_stages_last(scene, stage, clock, steps_most);
    if (scene->duration > 0) {
        double left = ceil((scene->duration - clock->time) / clock->dt - 1e-6);
        if (left >= (double)(steps_most - clock->step))
            return steps_most;
        return left > 0 ? clock->step + (uint64_t)left : clock->step;
    }
    return scene->step.count > 0 ? (uint64_t)scene->step.count : 0;
}

static bool checkpoint_step(const struct run *run, uint64_t step) {
    uint64_t every = run->s->scene->output.checkpoint.every_steps;
    return run->options->directory &&
           (run->checkpoint_due || (every > 0 && step % every == 0) ||
            (step == run->last && (run->chain || run->s->scene->output.checkpoint.at_end)));
}

/* Sets the signals of this rank before the step; decide then sends the signals to all ranks. */
static void signals_ask(struct run *run) {
    double minutes = run->s->scene->output.checkpoint.every_minutes;
    run->s->agree.signals = (struct step_signals){
        .stop = run_signal != 0,
        .checkpoint = minutes > 0 && timer_now() - run->checkpoint_last > 60 * minutes,
        .error = run->s->error.kind != ERROR_NONE,
    };
}

/* Writes a regular checkpoint, unless a guard has stopped the run in the present step: such a state must not
 * be resumed from, and must not replace an older checkpoint. */
static bool checkpoint_regular(struct run *run, struct error *error) {
    struct error condemned = run->s->error;
    if (!comm_agree(run->s->comm, &condemned))
        return true;
    run->checkpoint_last = timer_now();
    if (run->chain && run->s->clock.step == run->last) {
        run_stages_end(&run->s->stage, &run->s->clock);
        run->chain->over = true;
    }
    return (run->outputs == NULL || outputs_flush(run->outputs, &run->s->physics, run->s->comm, error)) &&
           resume_write(run->s, &run->output, "", error);
}

/* Warns once that other programs use the cores. */
static void crowd_tell(struct run *run) {
    const struct simulation *s = run->s;
    char text[400];
    if (run->crowd_told || run->options->quiet || s->comm->rank != 0 || !team_crowded(&s->team))
        return;
    run->crowd_told = true;
    team_describe(&s->team, text, sizeof text);
    fprintf(stderr, "%sscree: warning: %s (said once)\n",
            run->progress.mode == PROGRESS_BAR ? "\r\033[K" : "", text);
}

/* Looks at the conditions of the stage; the step after the present one may become the last. */
static bool stage_look(struct run *run, struct error *error) {
    const struct output_view view = simulation_view(run->s);
    run_stages_look(&run->stages, &view, &run->s->stage, error);
    run->last = run_last_step(run->s->scene, &run->s->stage, &run->s->clock);
    return error->kind == ERROR_NONE;
}

/* Writes what is due at the present step. */
static bool outputs_now(const struct run *run, struct error *error) {
    const struct output_view view = simulation_view(run->s);
    return outputs_write(run->outputs, &view, &run->s->physics, &run->s->clock, error);
}

static bool step_once(struct run *run, struct error *error) {
    struct simulation *s = run->s;
    double dt = s->clock.dt;
    bool checkpoint = checkpoint_step(run, s->clock.step + 1);
    const struct run_watch *watch = run->options->watch;
    bool watched = watch && watch->due(watch->context, s->clock.step + 1);
    bool looked = run_stages_due(&run->stages, &s->stage, s->clock.step + 1);
    bool seen = watched || looked || checkpoint || s->clock.step + 1 >= run->last ||
                (run->outputs && outputs_due(run->outputs, &s->clock, s->clock.step + 1));
    signals_ask(run);
    checked_step(s,
                 (watched && !watch->without_sums) || (looked && run_stages_need_sums(&run->stages)) ||
                     (run->outputs && outputs_want_sums(run->outputs, &s->clock, s->clock.step + 1)),
                 checkpoint, seen);
    if (s->clock.dt != dt) /* a shortened time step needs more steps to the end */
        run->last = run_last_step(s->scene, &s->stage, &s->clock);
    crowd_tell(run);
    run->record.particle_steps += (double)s->total;
    int stage = stages_find(&s->timers, "output");
    timer_start(&s->timers, stage);
    bool due = run->outputs && outputs_due(run->outputs, &s->clock, s->clock.step);
    if (watched || looked || due)
        physics_look(&s->physics);
    bool good = !due || outputs_now(run, error);
    if (good && watched)
        good = watch->look(watch->context, s, error);
    if (good && looked)
        good = stage_look(run, error);
    if (good && checkpoint)
        good = checkpoint_regular(run, error);
    run->checkpoint_due = s->agree.signals.stop || (s->agree.signals.checkpoint && !checkpoint);
    run->progress.last = run->last; /* conditions, or a shorter step, may have moved the end */
    progress_update(&run->progress, s->clock.step, s->total, s->clock.time);
    timer_stop(&s->timers, stage);
    return good;
}

/* Runs steps until the end, an error or a signal. All ranks see a signal in the same step, and the next step
 * writes the checkpoint. */
static bool steps(struct run *run, struct error *error) {
    struct simulation *s = run->s;
    bool stopping = false;
    while (s->clock.step < run->last) {
        if (!step_once(run, error))
            return false;
        if (s->agree.signals.error || (s->ranks.alone && s->error.kind != ERROR_NONE))
            return false;
        if (stopping) {
            int64_t number = run_signal;
            comm_max_int(s->comm, &number, 1); /* the signal may have reached only one rank */
            run->record.stopped = (int)number;
            return true;
        }
        stopping = s->agree.signals.stop;
    }
    return true;
}

static bool report_out(const struct run *run, const struct report *report, bool shown, struct error *error) {
    if (run->s->comm->rank != 0)
        return true;
    if (shown && !run->options->quiet)
        report_print(report, run_report_lines, stdout);
    if (run->options->directory == NULL)
        return true;
    char path[FILE_PATH_MAX];
    snprintf(path, sizeof path, "%s/report.json", run->options->directory);
    return report_write_json(report, path, error);
}

/* Writes the state of a run that a guard stopped, for inspection. */
static void stopped_checkpoint(struct run *run, const struct error *why) {
    struct error second = {0};
    if (run->options->directory == NULL || why->kind != ERROR_PHYSICS)
        return;
    if (!resume_write(run->s, &run->output, CHECKPOINT_STOPPED, &second) && run->s->comm->rank == 0)
        fprintf(stderr, "scree: the state at the stop could not be written: %s\n", second.text);
}

/* Deletes files of an earlier run that could be mistaken for files of this run. A run that goes on first looks
 * whether it can go on with the files in its folder. */
static bool folder_prepare(const struct run *run, struct error *error) {
    const struct comm *comm = run->s->comm;
    const char *directory = run->options->directory;
    if (run->options->resume == NULL)
        return folder_clear(comm, directory, error);
    return folder_suits(comm, directory, run->output.lineage, error) &&
           outputs_go_on(run->outputs, comm, error) &&
           folder_rewind(comm, directory, run->s->clock.step, error);
}

/* Prepares the conditions of the present stage. */
static bool stages_open(struct run *run, struct error *error) {
    const struct output_view view = simulation_view(run->s);
    bool good = run_stages_open(&run->stages, run->s->scene, &run->s->stage, &view, &run->output, error);
    run->s->sums_each_step = run->s->sums_each_step || run_stages_need_work(&run->stages);
    return good;
}

static bool run_open(struct run *run, struct error *error) {
    struct simulation *s = run->s;
    if (run->options->directory == NULL)
        return true;
    if (!outputs_create(&run->outputs, s, &run->output, error) ||
        !run_directory(s->comm, run->options, error) ||
        !folder_lock(s->comm, run->options->directory, &run->lock, error) || !folder_prepare(run, error))
        return false;
    const struct output_view view = simulation_view(s);
    if (!outputs_open(run->outputs, &view, &s->physics, run->options->resume != NULL, error))
        return false;
    s->sums_each_step = s->sums_each_step || outputs_sum_each_step(run->outputs);
    if (run->options->resume != NULL)
        return true;
    physics_look(&s->physics);
    return outputs_now(run, error);
}

static bool watch_begin(const struct run *run, struct error *error) {
    const struct run_watch *watch = run->options->watch;
    return watch == NULL || watch->begin(watch->context, run->s, error);
}

static void run_loop(struct run *run, struct error *error) {
    struct simulation *s = run->s;
    struct progress_options progress = s->scene->output.progress;
    run->last = run_last_step(s->scene, &s->stage, &s->clock);
    s->ranks.load.seconds = 0;
    int stage = stages_find(&s->timers, "other");
    run_report_begin(&s->timers, s->ranks.ghosts, s->clock.step, &run->record);
    timer_start(&s->timers, stage);
    run->checkpoint_last = run->record.began;
    if ((run->options->quiet && run->options->series == NULL) || s->comm->rank != 0)
        progress.mode = PROGRESS_OFF;
    progress_start(&run->progress, &progress, run->options->series, stderr, run->record.first, run->last);
    run->progress.last_values = outputs_last_values;
    run->progress.context = run->outputs;
    steps(run, error);
    progress_finish(&run->progress);
    timer_stop(&s->timers, stage);
    if (error->kind == ERROR_NONE)
        *error = s->error; /* also an error of the last step, not checked yet */
    if (!comm_agree(s->comm, error))
        stopped_checkpoint(run, error);
}

/* Prints the notes that `scree check` prints for the scene, or at the end of a run what it has seen. */
static void notes_tell(const struct run *run, bool seen) {
    if (run->options->quiet)
        return;
    struct notes *notes = memory_allocate_zero(1, sizeof *notes, "notes");
    if (seen)
        notes_seen(&run->s->physics, run->record.first, notes);
    else
        notes_take(run->s, notes);
    if (run->s->comm->rank == 0)
        notes_print(notes, "scree: ", stderr);
    memory_free(notes);
}

/* True, with a message, if a resumed run is already at its end; then no file is written. */
static bool over_already(const struct scene *scene, const struct stage_place *stage,
                         const struct clock *clock, const struct comm *comm, const char *resume) {
    if (resume == NULL || run_last_step(scene, stage, clock) > clock->step)
        return false;
    if (comm->rank == 0)
        fprintf(stderr,
                "scree: %s is already at step %llu, time %.9g; nothing to do: give a longer duration%s\n",
                resume, (unsigned long long)clock->step, clock->time,
                scene->duration > 0 ? "" : " or a larger step.count");
    return true;
}

/* Writes the rows that still wait of the tables of physics. */
static void tables_end(const struct run *run, struct error *error) {
    struct error own = {0};
    if (run->outputs == NULL || error->kind == ERROR_SYSTEM)
        return;
    outputs_tables(&run->s->physics, run->s->comm, &own);
    if (error->kind == ERROR_NONE)
        *error = own;
}

/* Makes and writes the report; between two stages the terminal gets none. */
static void report_end(struct run *run, struct report *report, struct error *error) {
    const struct run_chain *chain = run->chain;
    struct error unwritten = {0};
    run_report_make(run->s, &run->record, chain, report);
    outputs_close(&run->outputs, run->s->comm, error);
    bool more =
        chain && chain->over && chain->number + 1 < run->s->scene->stages && error->kind == ERROR_NONE;
    if (!report_out(run, report, !more, &unwritten) && error->kind == ERROR_NONE)
        *error = unwritten;
}

/* Tells of the start: what a resume changes, and which stage begins. */
static void start_tell(const struct run *run) {
    const struct simulation *s = run->s;
    const char *resume = run->options->resume;
    char label[2 * OUTPUT_NAME_MAX], title[RUN_STAGES_TITLE_MAX];
    if (s->comm->rank != 0 || run->options->quiet)
        return;
    if (run->chain) {
        run_stages_title(s->scene, &s->stage, &s->clock, title, sizeof title);
        log_text(NULL, title);
    }
    if (run->chain && run->chain->done > 0) {
        snprintf(label, sizeof label, "scree: stage '%s'", s->scene->stage[s->stage.number].name);
        resume = label;
    }
    if (resume)
        resume_print(&s->resumed, s->clock.step, resume, stderr);
}

int run_one(const struct comm *comm, const struct scene *scene, const struct run_options *options,
            struct run_chain *chain, struct report *report, struct error *error) {
    struct run run = {.options = options, .lock = -1, .chain = chain};
    struct report own;
    double start = timer_now();
    if (!run_directory_suits(comm, options, error))
        return error->kind;
    struct simulation_caller caller = {.quiet = options->quiet && options->series == NULL};
    run.s = simulation_create_for(&caller, comm, scene, options->resume, error);
    if (run.s == NULL ||
        (chain == NULL && over_already(scene, &run.s->stage, &run.s->clock, comm, options->resume))) {
        simulation_destroy(&run.s);
        return error->kind;
    }
    run.output = outputs_run(scene, &run.s->box, &run.s->lineage, options->directory);
    start_tell(&run);
    run_signals_catch();
    if (stages_open(&run, error) && run_open(&run, error) && watch_begin(&run, error)) {
        notes_tell(&run, false);
        run.record.setup = timer_now() - start;
        run_loop(&run, error);
        tables_end(&run, error);
        if (chain)
            run_stages_add(&run.stages, &run.s->clock, chain, timer_now() - run.record.began);
        report_end(&run, &own, error);
        if (report)
            *report = own;
        else
            report_destroy(&own);
        notes_tell(&run, true);
    }
    comm_agree(comm, error);
    outputs_close(&run.outputs, comm, error);
    run_stages_close(&run.stages);
    folder_unlock(&run.lock);
    simulation_destroy(&run.s);
    if (error->kind != ERROR_NONE)
        return error->kind;
    return run.record.stopped ? ERROR_SIGNAL + run.record.stopped : 0;
}
