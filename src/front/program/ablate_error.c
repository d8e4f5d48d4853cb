/* SPDX-License-Identifier: BSD-3-Clause */
/* `scree ablate --error`: the time and the error of settings, for one scene.
 *
 *     probe       the scene's step and its limits
 *     reference   three runs at ever finer steps; the last is the reference, the others say how good it is. Of a scene with
 *                 contact.solver they are explicit runs at the largest modulus that is known
 *     spread      runs that differ by a tiny displacement at the start
 *     errors      each variant once, observed at the times of the reference
 *     combined    all settings that save time without error, together, with each step
 *     times       each variant again, unwatched, in turn, as often as asked for
 *
 * All runs share their sample times: steps are shortened so that a whole number of them lies between. */
#include "front/program/ablate_parts.h"
#include "front/program/speed_error.h"
#include "front/program/trial.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES_DEFAULT = 40, REPEAT_DEFAULT = 2, MEMBERS_DEFAULT = 3 };

#define PERTURBATION 1e-6      /* of a radius */
#define TOLERANCE_DEFAULT 0.01 /* of the judged error */

struct study {
    const struct comm *comm;
    const struct command_line *line;
    struct variant_facts facts;
    struct variant true_run; /* whose fine steps are the reference */
    double true_dt;          /* its step */
    double duration;
    int samples, repeat, members;
    double tolerance, young; /* young: of --young; 0: not given */
    struct speed_reference reference;
    struct speed_row *row;
    int rows;
    int run, runs; /* number of the present run; number of all runs */
    double steps, steps_all;
};

/* The scene with the keys that a variant sets. */
static struct scene *variant_scene(const struct study *study, const struct variant *variant,
                                   struct error *error) {
    struct scene_setting setting[VARIANT_SETTINGS_MAX];
    char text[VARIANT_SET_MAX];
    int settings = variant_settings(variant, setting, text);
    return command_scene(study->comm, study->line, setting, settings, error);
}

/* The scene with a variant's settings and a step, cut to the study's span. */
static struct scene *study_scene(const struct study *study, const struct variant *variant, double dt,
                                 uint64_t *steps_each, struct error *error) {
    struct scene *scene = variant_scene(study, variant, error);
    if (scene == NULL)
        return NULL;
    double factor = variant_apply(variant, &study->facts, scene), interval = study->duration / study->samples;
    *steps_each = (uint64_t)fmax(1, ceil(interval / (dt * factor) - 1e-9));
    scene->step.dt = interval / (double)*steps_each;
    scene->step.count = (int64_t)*steps_each * study->samples;
    scene->duration = 0;
    return scene;
}

/* The position of the next run among all planned runs. */
static struct progress_series study_next(struct study *study, const char *name, int64_t steps) {
    double after = study->steps_all - study->steps - (double)steps;
    study->steps += (double)steps;
    study->run++;
    study->runs = study->run > study->runs ? study->run : study->runs;
    return (struct progress_series){
        .name = name, .number = study->run, .runs = study->runs, .after = fmax(0, after / (double)steps)};
}

/* An observed run: its record, its time step, and the seconds of its report. */
struct look {
    const struct variant *variant;
    double dt; /* before the variant's own factor */
    double perturbation;
    uint64_t seed;
};

static bool study_look(struct study *study, const struct look *look, struct sample_record *record, double *dt,
                       uint64_t *steps, struct error *error) {
    uint64_t steps_each;
    struct scene *scene = study_scene(study, look->variant, look->dt, &steps_each, error);
    if (scene == NULL)
        return false;
    struct sampler sampler;
    sample_create(&sampler, record, steps_each, study->samples);
    sampler.perturbation = look->perturbation;
    sampler.seed = look->seed;
    *dt = scene->step.dt;
    *steps = (uint64_t)scene->step.count;
    struct progress_series series = study_next(study, look->variant->settings, scene->step.count);
    struct ablate_options looks = {&sampler.watch, &series};
    bool good = ablate_run(study->comm, scene, &looks, NULL, error);
    sample_destroy(&sampler);
    scene_free(&scene);
    return good;
}

static const struct variant as_it_is = {.group = "scene", .settings = "as it is"};

static bool study_reference(struct study *study, struct error *error) {
    struct speed_reference *reference = &study->reference;
    uint64_t steps;
    for (int k = 0; k < SPEED_FINE; k++) {
        struct look look = {.variant = &study->true_run, .dt = study->true_dt / (2 << k)};
        if (study->comm->rank == 0)
            fprintf(stderr, "scree: reference %d of %d: %s, dt = %.4g\n", k + 1, SPEED_FINE,
                    study->true_run.settings, look.dt);
        if (!study_look(study, &look, &reference->fine[k], &reference->dt, &steps, error) ||
            (k == 0 && !speed_judge(reference, study->line->list[ABLATE_JUDGE], error)))
            return false;
    }
    study->facts.speed = reference->fine[SPEED_FINE - 1].speed_max;
    if (study->comm->rank == 0)
        speed_reference_make(reference);
    return true;
}

static bool study_spread(struct study *study, struct error *error) {
    struct sample_record member[SPEED_MEMBERS_MAX] = {{0}};
    bool good = true;
    double dt;
    uint64_t steps;
    for (int m = 0; m < study->members && good; m++) {
        struct look look = {.variant = &as_it_is,
                            .dt = study->facts.dt,
                            .perturbation = PERTURBATION,
                            .seed = (uint64_t)m + 1};
        good = study_look(study, &look, &member[m], &dt, &steps, error);
    }
    if (good && study->comm->rank == 0)
        speed_spread(&study->reference, member, study->members);
    for (int m = 0; m < SPEED_MEMBERS_MAX; m++)
        sample_free(&member[m]);
    return good;
}

/* Notes a variant without a result, which the scene refused or a guard stopped; this is no error of the
 * study. */
static bool stopped_note(struct speed_row *row, const struct error *why, struct error *error) {
    if (why->kind != ERROR_USER && why->kind != ERROR_PHYSICS) {
        *error = *why;
        return false;
    }
    snprintf(row->stopped, sizeof row->stopped, "%s: %.*s",
             why->kind == ERROR_PHYSICS ? "stopped" : "refused", (int)sizeof row->stopped - 12, why->text);
    for (char *c = row->stopped; *c; c++) /* a table must not contain commas and quotes */
        *c = *c == '"' ? '\'' : *c == ',' ? ';' : *c;
    row->seconds = row->cpu_seconds = row->trajectory = row->drift = row->momentum = row->judged = NAN;
    return true;
}

/* The time step of a variant before its own factor, and the stable step. With other keys it is that of the scene with them; if
 * else the stable step changes, the time step stays the same part of it. NAN: error filled. */
static double step_of(const struct study *study, const struct variant *variant, double *stable,
                      struct error *error) {
    *stable = study->facts.stable;
    if (!variant_scales_step(variant))
        return study->facts.dt;
    struct scene *scene = variant_scene(study, variant, error);
    if (scene == NULL)
        return NAN;
    struct variant_facts facts = {0};
    variant_apply(variant, &study->facts, scene);
    if (variant->set[0] == '\0') {
        scene->step.dt = 0;
        scene->step.fraction = study->facts.dt / study->facts.stable;
    }
    bool good = variant_probe(study->comm, scene, &facts, error);
    scene_free(&scene);
    double dt = good ? facts.dt : NAN;
    *stable = good ? facts.stable : NAN;
    variant_forget(&facts);
    return dt;
}

static bool row_errors(struct study *study, struct speed_row *row, struct error *error) {
    struct sample_record record = {0};
    struct error why = {0};
    struct look look = {.variant = &row->variant};
    row->seconds = row->cpu_seconds = INFINITY;
    look.dt = row->dt = step_of(study, &row->variant, &row->stable, &why);
    bool good = why.kind == ERROR_NONE && study_look(study, &look, &record, &row->dt, &row->steps, &why);
    if (good && study->comm->rank == 0)
        speed_row_measure(row, &record, &study->reference);
    sample_free(&record);
    return good || stopped_note(row, &why, error);
}

/* Seconds of a run: with a single thread the processor's time, which other programs disturb least; else wall
 * clock. */
static bool row_time(struct study *study, struct speed_row *row, struct error *error) {
    struct report report;
    uint64_t steps_each;
    if (row->stopped[0])
        return true;
    struct scene *scene = study_scene(study, &row->variant, row->dt, &steps_each, error);
    if (scene == NULL)
        return false;
    scene->step.dt = row->dt;
    scene->step.count = (int64_t)row->steps;
    struct stopwatch stopwatch;
    sample_clock_create(&stopwatch);
    struct progress_series series = study_next(study, row->variant.settings, scene->step.count);
    struct ablate_options looks = {&stopwatch.watch, &series};
    bool good = ablate_run(study->comm, scene, &looks, &report, error);
    scene_free(&scene);
    if (!good)
        return false;
    int ranks = report.ranks, threads = (int)report_number(&report, "threads");
    bool lone = ranks == 1 && threads == 1;
    double spent = sample_clock_read(&stopwatch);
    comm_sum(study->comm, &spent, 1);
    row->cpu_seconds = fmin(row->cpu_seconds, spent);
    row->seconds = fmin(row->seconds, lone ? spent : report_number(&report, "seconds"));
    study->reference.ranks = ranks;
    study->reference.threads = threads;
    report_destroy(&report);
    return true;
}

static bool rows_time(struct study *study, int first, int repeat, struct error *error) {
    for (int r = 0; r < repeat; r++)
        for (int k = first; k < study->rows; k++)
            if (!row_time(study, &study->row[k], error))
                return false;
    return true;
}

/* The variant with all settings that save time without error: the fastest of each group. */
static struct variant study_fastest(const struct study *study) {
    struct variant fastest = {.group = "combined"};
    for (int k = 1; k < study->rows; k++) {
        const struct speed_row *row = &study->row[k];
        bool best = !row->stopped[0] && variant_is_exact(&row->variant) &&
                    row->seconds < 0.97 * study->row[0].seconds;
        for (int other = 1; other < study->rows && best; other++)
            best = other == k || strcmp(study->row[other].variant.group, row->variant.group) != 0 ||
                   !(study->row[other].seconds < row->seconds);
        if (best)
            variant_add(&fastest, &row->variant);
    }
    return fastest;
}

static bool study_combine(struct study *study, struct error *error) {
    struct variant fastest = {0};
    int before = study->rows;
    if (study->comm->rank == 0)
        fastest = study_fastest(study);
    comm_broadcast(study->comm, &fastest, sizeof fastest);
    fastest.group = "combined"; /* a pointer of another rank is not valid here */
    if (fastest.changes == 0)
        return true;
    for (int k = 0; k < before && study->rows < VARIANTS_MAX; k++) {
        const struct variant *step = &study->row[k].variant;
        if (k > 0 && strcmp(step->group, "step") != 0)
            continue;
        struct speed_row *row = &study->row[study->rows++];
        *row = (struct speed_row){.variant = fastest};
        if (k > 0)
            variant_add(&row->variant, step);
        if (!row_errors(study, row, error))
            return false;
    }
    return rows_time(study, before, study->repeat, error);
}

static void study_tell(const struct study *study, struct error *error) {
    struct speed_report report = {study->row, study->rows, &study->reference, &study->facts,
                                  study->tolerance};
    if (study->comm->rank != 0)
        return;
    speed_front(study->row, study->rows, &study->reference);
    speed_print(&report, stdout);
    speed_write(&report, study->line->directory, error);
}

/* True if the interval of the samples gives the same time step as an earlier row. */
static bool step_again(const struct study *study, const struct speed_row *row) {
    for (int k = 0; k < study->rows; k++)
        if (strcmp(row->variant.group, "step") == 0 && study->row[k].steps == row->steps)
            return true;
    return false;
}

/* Lists the variants, and chooses the reference. Returns their number; 0: error filled. */
static int study_list(struct study *study, const struct scene *scene, struct variant *variant,
                      struct error *error) {
    double stable;
    int first = variant_list(variant, scene, &study->facts),
        variants = variant_put_explicit(variant, first, scene, study->young);
    study->true_run = variants > first ? variant[variants - 1] : as_it_is;
    study->true_dt = step_of(study, &study->true_run, &stable, error);
    if (variants > first) /* steps of 0.3, 0.15 and 0.075 of the stable one */
        study->true_dt *= 4;
    variants = error->kind == ERROR_NONE
                   ? variant_keep(variant, variants, study->line->list[ABLATE_ONLY], error)
                   : 0;
    return variants > 0 && variant_vary(study->line, variant, &variants, error) ? variants : 0;
}

/* Counts the runs and their steps: three runs for the reference, the members of the spread, each variant once
 * observed and then timed, and likewise the combined variant with each time step. */
static void study_count(struct study *study, const struct variant *variant, int variants) {
    double steps = ceil(study->duration / study->facts.dt), each = 1 + study->repeat;
    study->runs = SPEED_FINE + study->members;
    study->steps_all =
        ((2 << SPEED_FINE) - 2) * ceil(study->duration / study->true_dt) + study->members * steps;
    for (int k = 0; k < variants; k++) {
        bool step = strcmp(variant[k].group, "step") == 0;
        double factor = step ? variant[k].change[0].value : 1, combined = k == 0 || step ? 2 : 1, stable;
        struct error why = {0}; /* a variant that the scene refuses costs nothing */
        if (variant[k].set[0])
            factor = step_of(study, &variant[k], &stable, &why) / study->facts.dt;
        study->runs += (int)(each * combined);
        study->steps_all += why.kind == ERROR_NONE ? each * combined * steps / factor : 0;
    }
}

/* Prints the plan, and its duration by a trial; refuses a study that would compare nothing. */
static bool study_plan(struct study *study, const struct variant *variant, int variants,
                       struct error *error) {
    uint64_t steps_each;
    char flag[64], all[32];
    struct trial trial = {0};
    struct scene *scene = study_scene(study, &as_it_is, study->facts.dt, &steps_each, error);
    bool good = scene && trial_run(study->comm, scene, &trial, error);
    scene_free(&scene);
    snprintf(flag, sizeof flag, "%s%.4g",
             study->line->list[ABLATE_DURATION] ? "--duration " : "a duration of ", study->duration);
    if (!good || !trial_suffices(&trial, trial.last, flag, error))
        return false;
    study_count(study, variant, variants);
    progress_duration(trial.seconds / (double)trial.steps * study->steps_all, all, sizeof all);
    if (study->comm->rank == 0)
        fprintf(
            stderr,
            "scree: %d runs of %d settings, %.3g steps of %llu particles in all: about %s (as the first %llu "
            "steps took %.2g s)\n",
            study->runs, variants, study->steps_all, (unsigned long long)trial.particles, all,
            (unsigned long long)trial.steps, trial.seconds);
    return true;
}

static bool study_run(struct study *study, struct error *error) {
    struct variant *variant = memory_allocate_zero(VARIANTS_MAX, sizeof *variant, "variants");
    struct scene *scene = command_scene(study->comm, study->line, NULL, 0, error);
    bool good = scene && variant_probe(study->comm, scene, &study->facts, error);
    int variants = good ? study_list(study, scene, variant, error) : 0;
    good = variants > 0 && study_plan(study, variant, variants, error) && study_reference(study, error) &&
           study_spread(study, error);
    for (int k = 0; k < variants && good; k++) {
        struct speed_row *row = &study->row[study->rows];
        *row = (struct speed_row){.variant = variant[k]};
        if (study->comm->rank == 0)
            fprintf(stderr, "scree: variant %d of %d: %s\n", k + 1, variants, variant[k].settings);
        good = row_errors(study, row, error);
        study->rows += !step_again(study, row);
    }
    if (good && study->row[0].stopped[0])
        good = error_set(error, ERROR_USER, "the scene as it is has no result: %s", study->row[0].stopped);
    good = good && rows_time(study, 0, study->repeat, error) && study_combine(study, error);
    if (good)
        study_tell(study, error);
    variant_forget(&study->facts);
    memory_free(variant);
    scene_free(&scene);
    return comm_agree(study->comm, error);
}

static bool number_read(const char *text, const char *flag, double least, double most, double *value,
                        struct error *error) {
    char *end;
    if (text == NULL)
        return true;
    *value = strtod(text, &end);
    if (end == text || *end || !(*value >= least && *value <= most))
        return error_set(error, ERROR_USER, "command line: --%s %s: allowed: numbers from %g to %g", flag,
                         text, least, most);
    return true;
}

/* Reads the options. The span is that of the command line, else that of the scene. */
static bool study_options(struct study *study, struct error *error) {
    const char *const *list = study->line->list;
    double samples = SAMPLES_DEFAULT, repeat = REPEAT_DEFAULT, members = MEMBERS_DEFAULT;
    study->tolerance = TOLERANCE_DEFAULT;
    study->reference.mean_from = NAN;
    struct scene *scene = command_scene(study->comm, study->line, NULL, 0, error);
    if (scene == NULL)
        return false;
    study->duration = scene->duration > 0 ? scene->duration : (double)scene->step.count * scene->step.dt;
    if (isinf(study->duration))
        study->duration = 0; /* the scene has no end: the command line must give one */
    scene_free(&scene);
    if (!number_read(list[ABLATE_DURATION], "duration", 1e-300, 1e300, &study->duration, error) ||
        !number_read(list[ABLATE_SAMPLES], "samples", 2, 10000, &samples, error) ||
        !number_read(list[ABLATE_REPEAT], "repeat", 1, 100, &repeat, error) ||
        !number_read(list[ABLATE_MEMBERS], "members", 2, SPEED_MEMBERS_MAX, &members, error) ||
        !number_read(list[ABLATE_TOLERANCE], "tolerance", 0, 1, &study->tolerance, error) ||
        !number_read(list[ABLATE_YOUNG], "young", 1e-300, 1e300, &study->young, error) ||
        !number_read(list[ABLATE_MEAN_FROM], "mean-from", 0, study->duration, &study->reference.mean_from,
                     error))
        return false;
    study->samples = (int)samples;
    study->repeat = (int)repeat;
    study->members = (int)members;
    return study->duration > 0 || error_set(error, ERROR_USER,
                                            "command line: --duration is needed: the scene has no end, or "
                                            "gives its length in steps of no stated length");
}

bool ablate_error(const struct comm *comm, const struct command_line *line, struct error *error) {
    struct study *study = memory_allocate_zero(1, sizeof *study, "study");
    study->comm = comm;
    study->line = line;
    study->row = memory_allocate_zero(VARIANTS_MAX, sizeof *study->row, "study");
    bool good = study_options(study, error) && study_run(study, error);
    speed_reference_free(&study->reference);
    memory_free(study->row);
    memory_free(study);
    return good;
}
