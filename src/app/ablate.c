/* `scree ablate`: one scene over indexes, threads and newton settings; a table of stage times, pairs and
 * memory. */
#include "app/ablate.h"
#include "comm/cores.h"
#include "core/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
};

/* Machines of different size would list different threads: those of rank 0 hold for all. Collective. */
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

static void table_head(FILE *table) {
    fprintf(table, "index,newton,ranks,threads,particles,steps,seconds,particle_steps_per_second,pairs,"
                   "contacts,rebuilds,bytes_per_particle,peak_bytes");
    for (int k = 0; k < TIMER_STAGES; k++)
        fprintf(table, ",%s[s]", timer_stage_name(k));
    fprintf(table, "\n");
}

static void table_row(FILE *table, const struct report *r) {
    fprintf(table, "%s,%s,%d,%d,%llu,%llu,%.6g,%.6g,%llu,%llu,%llu,%.1f,%llu", r->index,
            r->newton ? "on" : "off", r->ranks, r->threads, (unsigned long long)r->particles,
            (unsigned long long)r->steps, r->seconds, report_speed(r), (unsigned long long)r->pairs,
            (unsigned long long)r->contacts, (unsigned long long)r->rebuilds, r->bytes_per_particle,
            (unsigned long long)(r->bytes_per_particle * (double)r->particles));
    for (int k = 0; k < TIMER_STAGES; k++)
        fprintf(table, ",%.6g", r->stage[k].mean);
    fprintf(table, "\n");
    fflush(table);
}

static void print_row(const struct report *r) {
    double rebuild = 0;
    for (int k = TIMER_MIGRATE; k <= TIMER_HISTORY; k++)
        rebuild += r->stage[k].mean;
    printf("  %-10s %-6s %7d %10.4f s %10.2f M/s %12llu pairs  rebuild %.4f s  %.0f bytes/particle\n",
           r->index, r->newton ? "on" : "off", r->threads, r->seconds, report_speed(r) * 1e-6,
           (unsigned long long)r->pairs, rebuild, r->bytes_per_particle);
    fflush(stdout);
}

bool ablate_run(const struct comm *comm, const struct scene *scene, const struct run_watch *watch,
                struct report *report, struct error *error) {
    struct run_options options = {.quiet = true, .watch = watch};
    memory_peak_reset();
    int status = run_scene(comm, scene, &options, report, error);
    if (status > ERROR_SIGNAL) {
        error_set(error, (enum error_kind)status, "ended by signal %d", status - ERROR_SIGNAL);
        if (report)
            report_destroy(report);
    }
    return status == 0;
}

/* One run of the scene with these settings. */
static bool variant_run(const struct comm *comm, const struct command_line *line, const char *const *setting,
                        int settings, struct report *report, struct error *error) {
    struct scene_setting extra[8];
    for (int k = 0; k < settings; k++)
        extra[k].text = setting[k];
    struct scene *scene = command_scene(comm, line, extra, settings, error);
    if (scene == NULL)
        return false;
    bool good = ablate_run(comm, scene, NULL, report, error);
    scene_free(&scene);
    return good;
}

static bool variants_run(const struct comm *comm, const struct command_line *line, const struct variants *v,
                         FILE *table, struct error *error) {
    char index[WORD_MAX + 32], threads[WORD_MAX + 32], newton[WORD_MAX + 32], steps[WORD_MAX + 32];
    const char *setting[] = {index, threads, newton, "duration=0", steps};
    snprintf(steps, sizeof steps, "step.count=%s", v->steps);
    int total = v->index.count * v->newton.count * v->threads.count;
    for (int k = 0; k < total; k++) {
        int i = k / (v->newton.count * v->threads.count), n = k / v->threads.count % v->newton.count,
            t = k % v->threads.count;
        struct report report;
        struct error why = {0};
        snprintf(index, sizeof index, "index.name=%s", v->index.word[i]);
        snprintf(threads, sizeof threads, "threads=%s", v->threads.word[t]);
        snprintf(newton, sizeof newton, "newton=%s", v->newton.word[n]);
        if (!variant_run(comm, line, setting, v->steps[0] ? 5 : 3, &report, &why)) {
            bool unsuitable = why.kind == ERROR_USER && strstr(why.text, "cannot serve") != NULL;
            if (!unsuitable) {
                *error = why;
                return false;
            }
            if (comm->rank == 0)
                printf("  %-10s %-6s %7s left out: %s\n", v->index.word[i], v->newton.word[n],
                       v->threads.word[t], why.text);
            continue;
        }
        if (comm->rank == 0) {
            table_row(table, &report);
            print_row(&report);
        }
        report_destroy(&report);
    }
    return true;
}

static bool table_make(const struct comm *comm, const struct command_line *line, const struct variants *v,
                       struct error *error) {
    char path[FILE_PATH_MAX];
    FILE *table = NULL;
    snprintf(path, sizeof path, "%s/ablate.csv", line->directory);
    if (comm->rank == 0 && (table = fopen(path, "w")) == NULL)
        error_set_errno(error, "%s", path);
    if (comm_agree(comm, error)) {
        if (table)
            table_head(table);
        variants_run(comm, line, v, table, error);
    }
    if (table && fclose(table) != 0)
        error_set_errno(error, "%s", path);
    return error->kind == ERROR_NONE;
}

/* Flags that belong to the other of the two kinds of table. */
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
    struct variants *v = memory_allocate(1, sizeof *v, "variants");
    if (line->directory == NULL)
        error_set(error, ERROR_USER, "command line: scree ablate needs -o DIR for its table");
    if (error->kind == ERROR_NONE && flags_fit(line, error) && variants_read(comm, v, line, error) &&
        run_directory(comm, &options, error)) {
        if (line->errors)
            ablate_error(comm, line, error);
        else
            table_make(comm, line, v, error);
    }
    memory_free(v);
    return error->kind;
}
