/* SPDX-License-Identifier: BSD-3-Clause */
/* Estimates the cost of a run. Read check_parts.h first. */
#include "front/program/check_parts.h"
#include "data/formats/checkpoint_names.h"
#include "data/formats/wall_frames.h"
#include "front/program/trial.h"
#include "physics/grains/grains.h"
#include "engine/outputs.h"
#include "engine/run.h"
#include "engine/index_view.h"
#include "data/formats/frame.h"
#include "data/observe/observables.h"
#include "data/observe/progress.h"
#include "kernel/particles/fields.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TIMED_MOST = 1000, NUMBER_CHARACTERS = 14, CHECKPOINT_HEAD = 30000, XDMF_FRAME = 2800 };

static const double timed_seconds = 0.3;

/* Steps of a run without an end. */
static const uint64_t endless = (uint64_t)1 << 60;

/* Bytes in words. */
static void size_words(double bytes, char *text, size_t room) {
    static const char *const units[] = {"bytes", "kB", "MB", "GB", "TB"};
    int k = 0;
    for (; bytes >= 1000 && k < 4; k++)
        bytes /= 1000;
    snprintf(text, room, k ? "%.3g %s" : "%.0f %s", bytes, units[k]);
}

static void time_words(double seconds, char *text, size_t room) {
    char clock[32];
    progress_duration(seconds, clock, sizeof clock);
    if (seconds < 100)
        snprintf(text, room, "%.2g s", seconds);
    else
        snprintf(text, room, "%s (%s)", clock, seconds < 3600 ? "min:s" : "h:min:s");
}

/* How often an output is written; the start counts. */
static double times(const struct output_interval *every, uint64_t steps, double dt) {
    if (every->steps > 0)
        return 1 + floor((double)steps / (double)every->steps);
    return 1 + floor((double)steps * dt / every->time * (1 + 1e-12));
}

/* Prints a file that a run writes; bytes 0: not known. A line each, or all in one. */
static void file_print(bool all, const char *name, double count, const char *unit, double bytes) {
    char size[32];
    size_words(bytes, size, sizeof size);
    printf(all ? "    %-28s %.0f %s%s" : ", %s %.0f %s%s", name, count, unit, count == 1 ? "" : "s");
    if (bytes > 0)
        printf(", about %s", size);
    if (all)
        printf("\n");
}

/* Bytes of a particle in a frame, or of its text if `characters` is not 0; with the columns that never change, or without. */
static double frame_bytes(const struct output_view *view, const struct output_fields *fields, int characters,
                          bool fixed) {
    struct frame frame;
    double bytes = 0;
    frame_create(&frame, view, fields);
    for (int c = 0; c < frame.columns; c++)
        if (fixed || !frame.column[c].fixed)
            bytes += characters ? (double)characters * frame.column[c].components
                                : (double)frame_column_bytes(&frame.column[c]);
    frame_free(&frame);
    return bytes;
}

static double checkpoint_bytes(const struct particles *particles, uint64_t total) {
    const struct field_list fields = fields_with(particles, FIELD_MIGRATE);
    double each =
        (double)(fields_packed_bytes(particles, &fields) + sizeof(double) * checkpoint_full_width(particles));
    return CHECKPOINT_HEAD + each * (double)total;
}

static void wall_frames_print(const struct walls *walls, const struct output_interval *every, bool all,
                              uint64_t steps, double dt) {
    struct wall_surface surface;
    if (!output_interval_set(every) || walls == NULL)
        return;
    double frames = times(every, steps, dt);
    wall_surface_make(&surface, walls, NULL);
    file_print(all, "walls-STEP.vtp", frames, "frame", frames * wall_frames_bytes((double)surface.triangles));
    wall_surface_free(&surface);
}

static void grids_print(const struct observables_options *options, int dimension, bool all, uint64_t steps,
                        double dt) {
    for (int g = 0; g < options->grids; g++) {
        const struct output_grid *grid = &options->grid[g];
        char name[OUTPUT_NAME_MAX + 16];
        double cells = 1;
        for (int d = 0; d < dimension; d++)
            cells *= (double)grid->cells[d];
        snprintf(name, sizeof name, "grid-%s.csv", grid->name);
        file_print(all, name, cells * times(&grid->every, steps, dt), "row", 0);
    }
}

/* Prints the files that `steps` steps will write. Collective: frames are made to find their columns. */
static void files_print(const struct simulation *s, bool all, uint64_t steps) {
    const struct output_options *output = &s->scene->output;
    const struct trajectory_options *trajectory = &output->trajectory;
    bool told = s->comm->rank == 0, varying = outputs_run(s->scene, &s->box, &s->lineage, NULL).varying;
    const struct output_view view = simulation_view(s);
    double total = (double)s->total, frame = total * frame_bytes(&view, &trajectory->fields, 0, varying),
           first = total * frame_bytes(&view, &trajectory->fields, 0, true),
           line = total * frame_bytes(&view, &output->dump.fields, NUMBER_CHARACTERS, true);
    double frames =
        output_interval_set(&trajectory->every) ? times(&trajectory->every, steps, s->clock.dt) : 0;
    if (!told)
        return;
    printf(all ? "  files in the folder of -o\n" : "  files        report.json");
    if (frames > 0)
        file_print(all, "trajectory.h5", frames, "frame", first - frame + frames * frame);
    if (frames > 0 && trajectory->xdmf)
        file_print(all, "trajectory.xdmf", frames, "frame", frames * XDMF_FRAME);
    if (output_interval_set(&trajectory->contacts))
        file_print(all, "contacts in trajectory.h5", times(&trajectory->contacts, steps, s->clock.dt), "list",
                   0);
    if (output_interval_set(&output->dump.every)) {
        double count = times(&output->dump.every, steps, s->clock.dt);
        file_print(all, "dump.lammpstrj", count, "frame", count * line);
    }
    wall_frames_print(grains_of(&s->physics)->walls, &output->walls.every, all, steps, s->clock.dt);
    if (output_interval_set(&output->contact_problems.every))
        file_print(all, "contact-problem-STEP.hdf5",
                   times(&output->contact_problems.every, steps, s->clock.dt), "file", 0);
    if (output_interval_set(&output->observables.every))
        file_print(all, "observables.csv", times(&output->observables.every, steps, s->clock.dt), "row", 0);
    grids_print(&output->observables, s->scene->box.dimension, all, steps, s->clock.dt);
    double checkpoints = output->checkpoint.at_end ? 1 : 0;
    if (output->checkpoint.every_steps > 0)
        checkpoints += floor((double)steps / (double)output->checkpoint.every_steps);
    checkpoints = output->checkpoint.every_minutes > 0 ? output->checkpoint.keep : checkpoints;
    checkpoints = checkpoints > output->checkpoint.keep ? output->checkpoint.keep : checkpoints;
    if (checkpoints > 0)
        file_print(all, "checkpoint-STEP.h5", checkpoints, "file",
                   checkpoints * checkpoint_bytes(s->particles, s->total));
    printf(all ? "    report.json\n" : "\n");
    if (frames == 0 && !output_interval_set(&trajectory->contacts) &&
        !output_interval_set(&output->dump.every) && !output_interval_set(&output->observables.every) &&
        !output_interval_set(&output->walls.every) && !output_interval_set(&output->contact_problems.every) &&
        output->observables.grids == 0)
        printf("    nothing else will be written: no trajectory, no dump, no observables\n");
    if (s->scene->insertions > 0)
        printf("    (particles that are inserted later come on top)\n");
}

/* Runs some of the first steps. Returns the seconds of a step, the slowest rank's; 0 without steps. Collective. */
static double steps_time(struct simulation *s, uint64_t last, uint64_t *steps) {
    double began = timer_now(), seconds[1] = {0};
    *steps = 0;
    while (s->clock.step < last && *steps < TIMED_MOST && seconds[0] < timed_seconds) {
        trial_step(s);
        ++*steps;
        seconds[0] = timer_now() - began;
        comm_max(s->comm, seconds, 1);
        if (s->agree.signals.error || (s->ranks.alone && s->error.kind != ERROR_NONE))
            break;
    }
    return *steps ? seconds[0] / (double)*steps : 0;
}

static bool has_fluid(const struct physics_set *set) {
    bool found = false;
    for (int k = 0; k < set->count; k++)
        found = found || strcmp(set->active[k].row->name, "fluid") == 0;
    return found;
}

static void time_print(struct simulation *s, bool all, uint64_t last, uint64_t steps) {
    uint64_t timed, rebuilds = s->search.skin->rebuilds;
    char each[64];
    if (has_fluid(&s->physics)) {
        if (s->comm->rank == 0)
            printf("  time         not estimated: a single step of a fluid may take long\n");
        return;
    }
    double seconds = steps_time(s, last, &timed);
    struct error stopped = s->error;
    comm_agree(s->comm, &stopped);
    rebuilds = s->search.skin->rebuilds - rebuilds;
    if (s->comm->rank != 0)
        return;
    if (stopped.kind != ERROR_NONE) {
        printf("  time         the run will stop in step %" PRIu64 ": %s\n", s->clock.step, stopped.text);
        return;
    }
    if (steps < endless) {
        time_words(seconds * (double)steps, each, sizeof each);
        printf("  time         about %s, by the %" PRIu64 " first steps, which were run here as a trial%s\n",
               each, timed, all ? ":" : "");
        if (!all)
            return;
    }
    printf("               %.3g ms a step, with %" PRIu64 " rebuild%s, without output; more contacts, more "
           "particles, or\n               other programs on the cores make it longer\n",
           1e3 * seconds, rebuilds, rebuilds == 1 ? "" : "s");
}

/* The stages of the scene, a line each. */
static void stages_print(const struct scene *scene) {
    if (scene->stages == 0)
        return;
    printf("\nstages, each with a checkpoint at its end\n");
    for (int k = 0; k < scene->stages; k++) {
        const struct scene_stage *stage = &scene->stage[k];
        bool bounded = isfinite(stage->duration);
        printf("  %-12s ", stage->name);
        if (bounded)
            printf("%s%.6g%s", stage->conditions ? "at most " : "", stage->duration,
                   scene->units == SCENE_UNITS_NONE ? "" : " s");
        for (int c = 0; c < stage->conditions; c++) {
            const struct scene_condition *condition = &stage->condition[c];
            const struct observable_request *request = &condition->request;
            printf("%s%s%s%s",
                   c         ? " and "
                   : bounded ? ", until "
                             : "until ",
                   request->name, request->target[0] ? "/" : "", request->target);
            if (!isnan(condition->at_least))
                printf(" >= %.6g", condition->at_least);
            if (!isnan(condition->at_most))
                printf(" <= %.6g", condition->at_most);
        }
        if (stage->after > 0)
            printf(", not before %.6g", stage->after);
        printf("%s%s\n", stage->set[0] ? "; sets " : "", stage->set);
    }
}

void run_cost_print(struct simulation *s, bool all) {
    uint64_t last = run_last_step(s->scene, &s->stage, &s->clock),
             steps = last > s->clock.step ? last - s->clock.step : 0;
    if (s->comm->rank == 0) {
        stages_print(s->scene);
        printf("\nwhat a run%s will cost\n", s->scene->stages > 0 ? " of the first stage" : "");
        if (steps < endless)
            printf("  steps        %" PRIu64 " of %.4g%s\n", steps, s->clock.dt,
                   s->scene->units == SCENE_UNITS_NONE ? "" : " s");
        else
            printf("  steps        without end: the run goes on until %s\n",
                   s->scene->stages > 0 ? "the conditions of the stage hold" : "a signal ends it");
    }
    files_print(s, all, steps);
    time_print(s, all, last, steps);
    if (s->comm->rank == 0)
        fflush(stdout);
}
