#include "observe/report.h"

#include "core/version.h"
#include "files/file.h"

#include <inttypes.h>
#include <math.h>

/* Writes a JSON string. */
static void put_text(FILE *file, const char *text) {
    fputc('"', file);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\')
            fprintf(file, "\\%c", *c);
        else if (*c < 0x20)
            fprintf(file, "\\u%04x", *c);
        else
            fputc(*c, file);
    }
    fputc('"', file);
}

/* JSON has no infinities and no NaN. */
static void put_real(FILE *file, double value) {
    if (isfinite(value))
        fprintf(file, "%.9g", value);
    else
        fprintf(file, "null");
}

static void key_text(FILE *file, const char *key, const char *text) {
    fprintf(file, "  \"%s\": ", key);
    put_text(file, text);
    fprintf(file, ",\n");
}

static void key_count(FILE *file, const char *key, uint64_t value) {
    fprintf(file, "  \"%s\": %" PRIu64 ",\n", key, value);
}

static void key_real(FILE *file, const char *key, double value) {
    fprintf(file, "  \"%s\": ", key);
    put_real(file, value);
    fprintf(file, ",\n");
}

static void key_flag(FILE *file, const char *key, bool value) {
    fprintf(file, "  \"%s\": %s,\n", key, value ? "true" : "false");
}

static void key_counts(FILE *file, const char *key, const uint64_t *value, int n) {
    fprintf(file, "  \"%s\": [", key);
    for (int k = 0; k < n; k++)
        fprintf(file, "%s%" PRIu64, k ? ", " : "", value[k]);
    fprintf(file, "],\n");
}

static void put_levels(FILE *file, const struct report *report) {
    if (report->choice[0]) {
        fprintf(file, "  \"index_choice\": {\"index\": \"%s\", \"choices\": %" PRIu64 ", \"why\": \"%s\", ",
                report->choice, report->choices, report->choice_why);
        fprintf(file, "\"predicted_seconds\": ");
        put_real(file, report->choice_predicted);
        fprintf(file, ", \"measured_seconds\": ");
        put_real(file, report->choice_measured);
        fprintf(file, "},\n");
    }
    fprintf(file, "  \"levels\": [");
    for (int l = 0; l < report->levels; l++) {
        const struct report_level *level = &report->level[l];
        fprintf(file,
                "%s\n    {\"cells\": %" PRIu64 ", \"particles\": %" PRIu64 ", \"cell_size\": ", l ? "," : "",
                level->cells, level->particles);
        put_real(file, level->cell);
        fprintf(file, ", \"radius_min\": ");
        put_real(file, level->radius_min);
        fprintf(file, ", \"radius_max\": ");
        put_real(file, level->radius_max);
        fprintf(file, "}");
    }
    fprintf(file, "\n  ],\n");
}

static void put_classes(FILE *file, const struct report *report) {
    fprintf(file, "  \"classes\": [");
    for (int c = 0; c < report->classes; c++) {
        const struct report_class *row = &report->size_class[c];
        fprintf(file,
                "%s\n    {\"particles\": %" PRIu64 ", \"ghosts\": %" PRIu64 ", \"bytes\": %" PRIu64
                ", \"radius_min\": ",
                c ? "," : "", row->particles, row->ghosts, row->bytes);
        put_real(file, row->radius_min);
        fprintf(file, ", \"radius_max\": ");
        put_real(file, row->radius_max);
        fprintf(file, "}");
    }
    fprintf(file, "\n  ],\n");
}

static void put_insertions(FILE *file, const struct report *report) {
    fprintf(file, "  \"insertions\": [");
    for (int k = 0; k < report->insertions; k++) {
        const struct report_insertion *row = &report->insertion[k];
        fprintf(file, "%s\n    {\"name\": ", k ? "," : "");
        put_text(file, row->name);
        fprintf(file, ", \"asked\": %" PRIu64 ", \"placed\": %" PRIu64 "}", row->asked, row->placed);
    }
    fprintf(file, "%s],\n", report->insertions ? "\n  " : "");
}

static void put_stages(FILE *file, const struct report *report) {
    fprintf(file, "  \"stages\": {");
    for (int s = 0; s < TIMER_STAGES; s++) {
        const struct report_stage *stage = &report->stage[s];
        fprintf(file, "%s\n    \"%s\": {\"min\": ", s ? "," : "", timer_stage_name((enum timer_stage)s));
        put_real(file, stage->min);
        fprintf(file, ", \"mean\": ");
        put_real(file, stage->mean);
        fprintf(file, ", \"max\": ");
        put_real(file, stage->max);
        fprintf(file, "}");
    }
    fprintf(file, "\n  }\n");
}

static void put_origin(FILE *file) {
    char host[256], cpu[256];
    version_host(host, sizeof host);
    version_cpu(cpu, sizeof cpu);
    key_text(file, "version", version_number());
    key_text(file, "git_revision", version_revision());
    key_text(file, "compiler", version_compiler());
    key_text(file, "flags", version_flags());
    key_text(file, "host", host);
    key_text(file, "cpu", cpu);
}

static void put_counts(FILE *file, const struct report *report) {
    key_count(file, "steps", report->steps);
    key_count(file, "last_step", report->step_last);
    key_real(file, "time", report->time);
    key_real(file, "dt", report->dt);
    key_count(file, "particles", report->particles);
    key_count(file, "ranks", (uint64_t)report->ranks);
    key_count(file, "threads", (uint64_t)report->threads);
    key_real(file, "threads_working",
             report->threads_working > 0 ? report->threads_working : report->threads);
    key_text(file, "index", report->index);
    key_text(file, "law", report->law);
    key_text(file, "integrator", report->integrator);
    key_flag(file, "newton", report->newton);
    key_flag(file, "reduced_ghosts", report->reduced);
    key_text(file, "simd", report->simd);
    key_flag(file, "reproducible", report->reproducible);
    key_real(file, "particle_steps_per_second", report_speed(report));
    key_real(file, "seconds", report->seconds);
    key_real(file, "seconds_setup", report->seconds_setup);
    key_count(file, "pairs", report->pairs);
    key_count(file, "contacts", report->contacts);
    key_count(file, "rebuilds", report->rebuilds);
    key_real(file, "bytes_per_particle", report->bytes_per_particle);
    key_count(file, "memory_peak", report->memory_peak);
    key_count(file, "memory_held", report->memory_held);
    key_count(file, "inserted", report->inserted);
    key_count(file, "deleted", report->deleted);
    key_count(file, "seed", report->seed);
    key_text(file, "stopped", report->stopped);
    key_counts(file, "ghosts", report->ghosts, report->ranks);
    key_counts(file, "messages", report->messages, report->ranks);
    key_counts(file, "bytes", report->bytes, report->ranks);
    key_count(file, "rebuild_messages", report->rebuild_messages);
    key_count(file, "rebuild_bytes", report->rebuild_bytes);
    key_real(file, "pupcs", report_pupcs(report));
    key_real(file, "imbalance", report->imbalance);
    key_real(file, "sync_share", report->sync_share);
    key_text(file, "sync", report->sync);
    key_text(file, "domain", report->domain);
    key_count(file, "divisions", report->divisions);
}

bool report_write_json(const struct report *report, const char *path, struct error *error) {
    struct file_new file;
    if (!file_new_open(&file, path, error))
        return false;
    fprintf(file.stream, "{\n");
    put_counts(file.stream, report);
    put_origin(file.stream);
    put_levels(file.stream, report);
    put_classes(file.stream, report);
    put_insertions(file.stream, report);
    put_stages(file.stream, report);
    fprintf(file.stream, "}\n");
    return file_new_close(&file, error);
}
