/* SPDX-License-Identifier: BSD-3-Clause */
/* `scree ablate`: one scene over indexes, threads and newton settings; a table of stage times, pairs and
 * memory. */
#include "front/program/commands.h"
#include "front/program/ablate_error.h"
#include "front/program/ablate_run.h"
#include "front/program/trial.h"
#include "kernel/comm/cores.h"
#include "base/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WORDS_MAX = 32, WORD_MAX = 64 };

/* A comma-separated list, cut into words. */
struct words {
    int count;
    char word[WORDS_MAX][WORD_MAX];
};

static bool words_cut(struct words *words, const char *text, const char *flag, struct error *error) {
    words->count = 0;
    while (*text) {
        size_t length = strcspn(text, ",");
        if (length == 0 || length >= WORD_MAX || words->count == WORDS_MAX)
            return error_set(error, ERROR_USER,
                             "command line: --%s: '%s' is no list of words separated by commas", flag, text);
        snprintf(words->word[words->count++], WORD_MAX, "%.*s", (int)length, text);
        text += length;
        text += *text == ',';
    }
    return words->count > 0 || error_set(error, ERROR_USER, "command line: --%s: an empty list", flag);
}

struct variants {
    struct words index, threads, newton;
    char steps[WORD_MAX];
    uint64_t count;           /* steps of each run */
    int runs, done;           /* runs of all variants */
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
static void brute_last(struct words *index) {
    int kept = 0, brutes = 0;
    for (int k = 0; k < index->count; k++) {
        if (is_brute(index->word[k]))
            brutes++;
        else if (kept++ < k)
            memcpy(index->word[kept - 1], index->word[k], WORD_MAX);
    }
    for (int k = 0; k < brutes; k++)
        strcpy(index->word[kept + k], "brute");
}

/* Reads the variants. Machines of different size would list different threads, so all ranks use the list of
 * rank 0. Collective. */
static bool variants_read(const struct comm *comm, struct variants *v, const struct command_line *line,
                          struct error *error) {
    int threads_most = cores_threads(comm);
    comm_broadcast(comm, &threads_most, sizeof threads_most);
    *v = (struct variants){0};
    for (int k = 0; k < index_registry_count() && k < WORDS_MAX; k++)
        snprintf(v->index.word[v->index.count++], WORD_MAX, "%s", index_registry_get(k)->name);
    for (int t = 1; t <= threads_most && v->threads.count < WORDS_MAX; t *= 2)
        snprintf(v->threads.word[v->threads.count++], WORD_MAX, "%d", t);
    strcpy(v->newton.word[v->newton.count++], "on");
    strcpy(v->newton.word[v->newton.count++], "off");
    if ((line->list[ABLATE_INDEX] && !words_cut(&v->index, line->list[ABLATE_INDEX], "index", error)) ||
        (line->list[ABLATE_THREADS] &&
         !words_cut(&v->threads, line->list[ABLATE_THREADS], "threads", error)) ||
        (line->list[ABLATE_NEWTON] && !words_cut(&v->newton, line->list[ABLATE_NEWTON], "newton", error)))
        return false;
    brute_last(&v->index);
    v->brute_asked = line->list[ABLATE_INDEX] != NULL;
    v->runs = v->index.count * v->newton.count * v->threads.count;
    for (int k = 0; k < v->index.count; k++)
        if (index_registry_find(v->index.word[k]) == NULL)
            return error_set(
                error, ERROR_USER,
                "command line: --index: there is no index '%s' (scree help index.name lists them)",
                v->index.word[k]);
    if (line->list[ABLATE_STEPS])
        snprintf(v->steps, sizeof v->steps, "%s", line->list[ABLATE_STEPS]);
    return true;
}

/* The columns of the table behind index and newton: name, row of the report, format. */
static const struct {
    const char *name, *row, *format;
} columns[] = {{"ranks", "ranks", ",%.0f"},
               {"threads", "threads", ",%.0f"},
               {"particles", "particles", ",%.0f"},
               {"steps", "steps", ",%.0f"},
               {"seconds", "seconds", ",%.6g"},
               {"particle_steps_per_second", "particle_steps_per_second", ",%.6g"},
               {"pairs", "pairs", ",%.0f"},
               {"contacts", "contacts", ",%.0f"},
               {"rebuilds", "rebuilds", ",%.0f"},
               {"bytes_per_particle", "bytes_per_particle", ",%.1f"},
               {"peak_bytes", "memory_counted", ",%.0f"}};
enum { COLUMNS = sizeof columns / sizeof columns[0] };

static void table_head(FILE *table, const struct timers *timers) {
    fprintf(table, "index,newton");
    for (int c = 0; c < COLUMNS; c++)
        fprintf(table, ",%s", columns[c].name);
    for (int k = 0; k < timers->stages; k++)
        fprintf(table, ",%s[s]", timers->stage[k].name);
    fprintf(table, "\n");
    fflush(table);
}

static const char *newton_word(const struct report *r) {
    return report_number(r, "newton") != 0 ? "on" : "off";
}

static void table_row(FILE *table, const struct report *r) {
    const struct report_table *stages = report_list(r, "stages");
    fprintf(table, "%s,%s", report_text(r, "index"), newton_word(r));
    for (int c = 0; c < COLUMNS; c++)
        fprintf(table, columns[c].format, report_number(r, columns[c].row));
    for (int k = 0; k < stages->entries; k++)
        fprintf(table, ",%.6g", report_list_number(stages, k, "mean"));
    fprintf(table, "\n");
    fflush(table);
}

static void print_row(const struct report *r) {
    printf("  %-10s %-6s %7.0f %10.4f s %10.2f M/s %12.0f pairs  rebuild %.4f s  %.0f bytes/particle\n",
           report_text(r, "index"), newton_word(r), report_number(r, "threads"), report_number(r, "seconds"),
           1e-6 * report_number(r, "particle_steps_per_second"), report_number(r, "pairs"),
           report_number(r, "seconds_rebuild"), report_number(r, "bytes_per_particle"));
    fflush(stdout);
}

/* One run of the scene with these settings. */
static bool variant_run(const struct comm *comm, const struct command_line *line, const char *const *setting,
                        int settings, const struct progress_series *series, struct report *report,
                        struct error *error) {
    struct scene_setting extra[8];
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

static void row_take(const struct comm *comm, struct variants *v, struct report *report, FILE *table) {
    if (comm->rank == 0) {
        table_row(table, report);
        print_row(report);
    }
    double seconds = report_number(report, "seconds");
    v->slowest = seconds > v->slowest ? seconds : v->slowest;
    v->rebuilds = report_number(report, "rebuilds");
    report_destroy(report);
}

/* A run of index i, newton setting n and thread count t. An index that cannot serve the scene is left out. */
static bool variant_take(const struct comm *comm, const struct command_line *line, struct variants *v,
                         const int at[3], FILE *table, struct error *error) {
    const char *index = v->index.word[at[0]], *newton = v->newton.word[at[1]],
               *threads = v->threads.word[at[2]];
    char text[4][WORD_MAX + 32], name[3 * WORD_MAX];
    const char *setting[] = {text[0], text[1], text[2], "duration=0", text[3]};
    struct progress_series series = {
        .name = name, .number = v->done, .runs = v->runs, .after = v->runs - v->done};
    struct report report;
    struct error why = {0};
    snprintf(text[0], sizeof text[0], "index.name=%s", index);
    snprintf(text[1], sizeof text[1], "threads=%s", threads);
    snprintf(text[2], sizeof text[2], "newton=%s", newton);
    snprintf(text[3], sizeof text[3], "step.count=%s", v->steps);
    snprintf(name, sizeof name, "%s, newton %s, threads %s", index, newton, threads);
    if (variant_run(comm, line, setting, v->steps[0] ? 5 : 3, &series, &report, &why)) {
        row_take(comm, v, &report, table);
        return true;
    }
    if (why.kind != ERROR_USER || strstr(why.text, "cannot serve") == NULL) {
        *error = why;
        return false;
    }
    if (comm->rank == 0)
        printf("  %-10s %-6s %7s left out: %s\n", index, newton, threads, why.text);
    return true;
}

static bool variants_run(const struct comm *comm, const struct command_line *line, struct variants *v,
                         uint64_t particles, FILE *table, struct error *error) {
    for (int k = 0; k < v->runs; k++) {
        int at[3] = {k / (v->newton.count * v->threads.count), k / v->threads.count % v->newton.count,
                     k % v->threads.count};
        v->done = k + 1;
        if (is_brute(v->index.word[at[0]]) &&
            brute_skipped(comm, v, particles, v->newton.word[at[1]], v->threads.word[at[2]]))
            continue;
        if (!variant_take(comm, line, v, at, table, error))
            return false;
    }
    return true;
}

static void words_print(const char *what, const struct words *words) {
    printf("; %s", what);
    for (int k = 0; k < words->count; k++)
        printf("%s %s", k ? "," : "", words->word[k]);
}

/* Prints the planned runs and their number, before the first run. */
static void variants_print(const struct variants *v) {
    printf("%d runs", v->runs);
    words_print("index", &v->index);
    words_print("newton", &v->newton);
    words_print("threads", &v->threads);
    printf("\n");
    fflush(stdout);
}

/* Estimates the time of all runs by a trial, and checks that the comparison is useful. */
static bool plan_try(const struct comm *comm, const struct command_line *line, struct variants *v,
                     struct trial *trial, struct error *error) {
    char flag[WORD_MAX + 16] = "the scene's own length", each[32], all[32];
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
    char path[FILE_PATH_MAX];
    FILE *table = NULL;
    struct trial trial;
    if (comm->rank == 0)
        variants_print(v);
    if (!plan_try(comm, line, v, &trial, error))
        return false;
    snprintf(path, sizeof path, "%s/ablate.csv", line->directory);
    if (comm->rank == 0 && (table = fopen(path, "w")) == NULL)
        error_set_errno(error, "%s", path);
    if (comm_agree(comm, error)) {
        if (table)
            table_head(table, &trial.timers);
        variants_run(comm, line, v, trial.particles, table, error);
    }
    if (table && fclose(table) != 0)
        error_set_errno(error, "%s", path);
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
