/* SPDX-License-Identifier: BSD-3-Clause */
/* `scree ablate`: one scene over indexes, threads, newton settings and values of any of its keys; a table of stage times,
 * pairs, memory, and of what the solver of contacts did. */
#include "front/program/commands.h"
#include "front/program/ablate_parts.h"
#include "front/program/trial.h"
#include "kernel/comm/cores.h"
#include "base/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The axes; those of --vary stand behind. */
enum { INDEX, NEWTON, THREADS, VARIED };

struct variants {
    int axes;
    struct axis axis[AXES_MAX];
    char steps[AXIS_TEXT_MAX];
    uint64_t count;           /* steps of each run */
    int runs, done, taken;    /* runs of all variants; those begun, and those with a result */
    bool brute_asked;         /* the command line names brute force, so brute force runs at any cost */
    double slowest, rebuilds; /* of the runs so far: seconds, and rebuilds of the last */
    double brute_pair;        /* seconds of brute force for a pair, from the trial */
};

/* Brute force is left out if a run would take longer than brute_times the slowest other run, and longer than
 * brute_seconds. */
static const double brute_times = 5, brute_seconds = 60;

static bool is_brute(const char *index) {
    return strcmp(index, "brute") == 0;
}

/* Puts brute force last in the list, so that the other runs predict its cost. */
static void brute_last(struct axis *index) {
    int kept = 0, brutes = 0;
    for (int k = 0; k < index->count; k++) {
        if (is_brute(index->value[k]))
            brutes++;
        else if (kept++ < k)
            memcpy(index->value[kept - 1], index->value[k], AXIS_TEXT_MAX);
    }
    for (int k = 0; k < brutes; k++)
        strcpy(index->value[kept + k], "brute");
}

/* The values of the first axes where neither their flags nor --vary are given. Machines of different size would list different
 * threads, so all ranks use the list of rank 0. Collective. */
static void variants_default(const struct comm *comm, struct variants *v) {
    struct axis *index = &v->axis[INDEX], *threads = &v->axis[THREADS], *newton = &v->axis[NEWTON];
    int most = cores_threads(comm);
    comm_broadcast(comm, &most, sizeof most);
    for (int k = 0; k < index_registry_count() && k < AXIS_VALUES_MAX; k++)
        snprintf(index->value[index->count++], AXIS_TEXT_MAX, "%s", index_registry_get(k)->name);
    for (int t = 1; t <= most && threads->count < AXIS_VALUES_MAX; t *= 2)
        snprintf(threads->value[threads->count++], AXIS_TEXT_MAX, "%d", t);
    strcpy(newton->value[newton->count++], "on");
    strcpy(newton->value[newton->count++], "off");
}

static bool index_known(const struct axis *index, struct error *error) {
    for (int k = 0; k < index->count; k++)
        if (index_registry_find(index->value[k]) == NULL)
            return error_set(
                error, ERROR_USER,
                "command line: --index: there is no index '%s' (scree help index.name lists them)",
                index->value[k]);
    return true;
}

/* Reads the variants. Collective. */
static bool variants_read(const struct comm *comm, struct variants *v, const struct command_line *line,
                          struct error *error) {
    static const struct {
        const char *key, *flag;
        int list;
    } first[VARIED] = {[INDEX] = {"index.name", "index", ABLATE_INDEX},
                       [NEWTON] = {"newton", "newton", ABLATE_NEWTON},
                       [THREADS] = {"threads", "threads", ABLATE_THREADS}};
    *v = (struct variants){.axes = VARIED + line->varied};
    if (line->varied == 0)
        variants_default(comm, v);
    for (int k = 0; k < VARIED; k++) {
        snprintf(v->axis[k].key, sizeof v->axis[k].key, "%s", first[k].key);
        const char *list = line->list[first[k].list];
        if (list && !axis_cut(&v->axis[k], first[k].key, list, first[k].flag, error))
            return false;
    }
    for (int k = 0; k < line->varied; k++)
        if (!axis_cut_setting(&v->axis[VARIED + k], line->vary[k], "vary", error))
            return false;
    brute_last(&v->axis[INDEX]);
    v->brute_asked = line->list[ABLATE_INDEX] != NULL;
    v->runs = axis_runs(v->axis, v->axes);
    if (line->list[ABLATE_STEPS])
        snprintf(v->steps, sizeof v->steps, "%s", line->list[ABLATE_STEPS]);
    return index_known(&v->axis[INDEX], error);
}

/* One run of the scene with these settings. */
static bool variant_run(const struct comm *comm, const struct command_line *line, const char *const *setting,
                        int settings, const struct progress_series *series, struct report *report,
                        struct error *error) {
    struct scene_setting extra[AXES_MAX + 2];
    struct ablate_options options = {.series = series};
    for (int k = 0; k < settings; k++)
        extra[k].text = setting[k];
    struct scene *scene = command_scene(comm, line, extra, settings, error);
    if (scene == NULL)
        return false;
    bool good = ablate_run(comm, scene, &options, report, error);
    scene_free(&scene);
    return good;
}

/* Predicted seconds of a run by brute force, from the trial and the runs of other indexes; 0: no data. A
 * rebuild goes through all pairs once; only where the list outgrows its memory twice. */
static double brute_foreseen(const struct variants *v, uint64_t particles, int threads) {
    double n = (double)particles;
    return v->rebuilds > 0 ? v->slowest + v->rebuilds * n * n / 2 * v->brute_pair / threads : 0;
}

/* True, with a message, if brute force would take too long. The same on all ranks. */
static bool brute_skipped(const struct comm *comm, const struct variants *v, uint64_t particles,
                          const char *newton, const char *threads) {
    char duration[32];
    double seconds = brute_foreseen(v, particles, atoi(threads) * comm->size);
    comm_broadcast(comm, &seconds, sizeof seconds);
    if (v->brute_asked || seconds < brute_seconds || seconds < brute_times * v->slowest)
        return false;
    progress_duration(seconds, duration, sizeof duration);
    if (comm->rank == 0)
        printf("  %-10s %-6s %7s left out: it would take about %s; --index brute runs it all the same\n",
               "brute", newton, threads, duration);
    return true;
}

static void row_take(const struct comm *comm, struct variants *v, const int at[AXES_MAX],
                     struct report *report, const struct ablate_tables *tables) {
    if (comm->rank == 0)
        ablate_tables_row(tables, at + VARIED, report);
    double seconds = report_number(report, "seconds");
    v->slowest = seconds > v->slowest ? seconds : v->slowest;
    v->rebuilds = report_number(report, "rebuilds");
    v->taken++;
    report_destroy(report);
}

/* The settings of a run, and their words for people. */
struct variant_settings {
    int count;
    const char *setting[AXES_MAX + 2];
    char text[AXES_MAX + 1][AXIS_SETTING_MAX];
    char name[AXES_MAX * AXIS_SETTING_MAX];
};

static void settings_make(const struct variants *v, const int at[AXES_MAX], struct variant_settings *s) {
    s->count = 0;
    s->name[0] = '\0';
    for (int k = 0; k < v->axes; k++) {
        size_t used = strlen(s->name);
        if (at[k] < 0)
            continue;
        axis_setting(&v->axis[k], at[k], s->text[k]);
        s->setting[s->count++] = s->text[k];
        snprintf(s->name + used, sizeof s->name - used, "%s%s %s", used ? ", " : "", v->axis[k].key,
                 v->axis[k].value[at[k]]);
    }
    if (v->steps[0] == '\0')
        return;
    snprintf(s->text[v->axes], AXIS_SETTING_MAX, "step.count=%s", v->steps);
    s->setting[s->count++] = "duration=0";
    s->setting[s->count++] = s->text[v->axes];
}

/* True if a run without a result is no error of the whole: an index that cannot serve the scene, or a value of --vary that the
 * scene refuses or a guard stops. */
static bool left_out(const struct variants *v, const struct error *why) {
    return v->axes > VARIED ? why->kind == ERROR_USER || why->kind == ERROR_PHYSICS
                            : why->kind == ERROR_USER && strstr(why->text, "cannot serve") != NULL;
}

/* A run with these values of the axes. */
static bool variant_take(const struct comm *comm, const struct command_line *line, struct variants *v,
                         const int at[AXES_MAX], const struct ablate_tables *tables, struct error *error) {
    struct variant_settings s;
    struct report report;
    struct error why = {0};
    settings_make(v, at, &s);
    struct progress_series series = {
        .name = s.name, .number = v->done, .runs = v->runs, .after = v->runs - v->done};
    if (variant_run(comm, line, s.setting, s.count, &series, &report, &why)) {
        row_take(comm, v, at, &report, tables);
        return true;
    }
    if (!left_out(v, &why) || (v->done == v->runs && v->taken == 0)) {
        *error = why;
        return false;
    }
    if (comm->rank == 0)
        printf("  %s: left out: %s\n", s.name, why.text);
    return true;
}

static bool variants_run(const struct comm *comm, const struct command_line *line, struct variants *v,
                         uint64_t particles, const struct ablate_tables *tables, struct error *error) {
    for (int k = 0; k < v->runs; k++) {
        int at[AXES_MAX];
        axis_places(v->axis, v->axes, k, at);
        v->done = k + 1;
        if (at[INDEX] >= 0 && is_brute(v->axis[INDEX].value[at[INDEX]]) &&
            brute_skipped(comm, v, particles, at[NEWTON] >= 0 ? v->axis[NEWTON].value[at[NEWTON]] : "",
                          at[THREADS] >= 0 ? v->axis[THREADS].value[at[THREADS]] : "1"))
            continue;
        if (!variant_take(comm, line, v, at, tables, error))
            return false;
    }
    return true;
}

/* Prints the planned runs and their number, before the first run. */
static void variants_print(const struct variants *v) {
    printf("%d runs", v->runs);
    for (int k = 0; k < v->axes; k++) {
        const struct axis *axis = &v->axis[k];
        if (axis->count > 0)
            printf("; %s", k == INDEX ? "index" : axis->key);
        for (int n = 0; n < axis->count; n++)
            printf("%s %s", n ? "," : "", axis->value[n]);
    }
    printf("\n");
    fflush(stdout);
}

/* Estimates the time of all runs by a trial, and checks that the comparison is useful. */
static bool plan_try(const struct comm *comm, const struct command_line *line, struct variants *v,
                     struct trial *trial, struct error *error) {
    char flag[AXIS_TEXT_MAX + 16] = "the scene's own length", each[32], all[32];
    struct scene *scene = command_scene(comm, line, NULL, 0, error);
    bool good = scene && trial_run(comm, scene, trial, error);
    scene_free(&scene);
    if (!good)
        return false;
    v->brute_pair = trial->brute_pair;
    char *end = v->steps;
    v->count = v->steps[0] ? strtoull(v->steps, &end, 10) : trial->last;
    if (*end != '\0')
        return true; /* the reader of the scene reports the error */
    if (v->steps[0])
        snprintf(flag, sizeof flag, "--steps %s", v->steps);
    if (!trial_suffices(trial, v->count, flag, error))
        return false;
    double seconds = trial->seconds / (double)trial->steps * (double)v->count;
    progress_duration(seconds, each, sizeof each);
    progress_duration(seconds * v->runs, all, sizeof all);
    if (comm->rank == 0)
        printf("  %llu particles, %llu steps each: about %s a run, %s in all (as the first %llu steps of the "
               "scene as it is took %.2g s)\n",
               (unsigned long long)trial->particles, (unsigned long long)v->count, each, all,
               (unsigned long long)trial->steps, trial->seconds);
    fflush(stdout);
    return true;
}

static bool table_make(const struct comm *comm, const struct command_line *line, struct variants *v,
                       struct error *error) {
    struct ablate_tables tables = {.axis = v->axis + VARIED, .axes = v->axes - VARIED};
    struct trial trial;
    if (comm->rank == 0)
        variants_print(v);
    if (!plan_try(comm, line, v, &trial, error))
        return false;
    tables.timers = trial.timers;
    if (comm->rank == 0)
        ablate_tables_open(&tables, line->directory, error);
    if (comm_agree(comm, error))
        variants_run(comm, line, v, trial.particles, &tables, error);
    ablate_tables_close(&tables, line->directory, error);
    return error->kind == ERROR_NONE;
}

/* Refuses flags of the other kind of table. */
static bool flags_fit(const struct command_line *line, struct error *error) {
    for (int k = 0; k < ABLATE_FLAGS; k++)
        if (line->list[k] && line->errors != (k >= ABLATE_DURATION))
            return error_set(error, ERROR_USER,
                             "command line: scree ablate %s --error does not take '%s' (scree help ablate)",
                             line->errors ? "with" : "without", line->list[k]);
    return true;
}

int command_ablate(const struct comm *comm, const struct command_line *line, struct error *error) {
    struct run_options options = {.directory = line->directory, .overwrite = line->overwrite};
    bool there = line->directory && access(line->directory, F_OK) == 0;
    struct variants *v = memory_allocate(1, sizeof *v, "variants");
    if (line->directory == NULL)
        error_set(error, ERROR_USER, "command line: scree ablate needs -o DIR for its table");
    if (error->kind == ERROR_NONE && flags_fit(line, error) && variants_read(comm, v, line, error) &&
        run_directory(comm, &options, error)) {
        if (line->errors)
            ablate_error(comm, line, error);
        else
            table_make(comm, line, v, error);
        if (error->kind != ERROR_NONE && comm->rank == 0 && !there)
            rmdir(line->directory); /* only if the directory stayed empty */
    }
    memory_free(v);
    return error->kind;
}
