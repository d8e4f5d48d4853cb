/* SPDX-License-Identifier: BSD-3-Clause */
/* Tables and words of speed against error. */
#include "front/program/tabular.h"
#include "front/program/speed_error.h"
#include "base/memory.h"
#include "base/version.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const struct sample_record *finest(const struct speed_reference *reference) {
    return &reference->fine[SPEED_FINE - 1];
}

static const char *column_of(const struct speed_reference *reference, int column) {
    return column < 0 ? "trajectory" : finest(reference)->name[column];
}

static FILE *file_open(const char *directory, const char *name, char *path, struct error *error) {
    snprintf(path, FILE_PATH_MAX, "%s/%s", directory, name);
    FILE *file = fopen(path, "w");
    if (file == NULL)
        error_set_errno(error, "%s", path);
    return file;
}

static bool file_close(FILE *file, const char *path, struct error *error) {
    return fclose(file) == 0 || error_set_errno(error, "%s", path);
}

static void row_fill(struct tabular *cells, const struct speed_row *r, const struct speed_row *first,
                     const struct speed_reference *reference) {
    char name[TABULAR_NAME_MAX];
    cells->count = 0;
    tabular_word(cells, "group", r->variant.group);
    tabular_word(cells, "settings", r->variant.settings);
    tabular_number(cells, "dt", "%.9g", r->dt);
    tabular_number(cells, "dt_of_stable", "%.4g", r->dt / r->stable);
    tabular_number(cells, "steps", "%.0f", (double)r->steps);
    tabular_number(cells, "seconds", "%.6g", r->seconds);
    tabular_number(cells, "cpu_seconds", "%.6g", r->cpu_seconds);
    tabular_number(cells, "speedup", "%.4g", first->seconds / r->seconds);
    tabular_number(cells, "trajectory_error", "%.6g", r->trajectory);
    tabular_number(cells, "energy_drift", "%.6g", r->drift);
    tabular_number(cells, "momentum_error", "%.6g", r->momentum);
    for (int c = 0; c < finest(reference)->own; c++) {
        snprintf(name, sizeof name, "%s_error", finest(reference)->name[c]);
        tabular_number(cells, name, "%.6g", r->stopped[0] ? NAN : r->error[c]);
    }
    tabular_number(cells, "judged_error", "%.6g", r->judged);
    tabular_number(cells, "on_front", "%.0f", r->on_front);
    tabular_word(cells, "outcome", r->stopped[0] ? r->stopped : "done");
}

static bool rows_write(const struct speed_row *row, int rows, const struct speed_reference *reference,
                       const char *directory, struct error *error) {
    char path[FILE_PATH_MAX], lines[FILE_PATH_MAX];
    FILE *file = file_open(directory, "speed_error.csv", path, error),
         *json = file ? file_open(directory, "speed_error.jsonl", lines, error) : NULL;
    if (json == NULL) {
        if (file)
            fclose(file);
        return false;
    }
    struct tabular *cells = memory_allocate(1, sizeof *cells, "a row of a table");
    for (int k = 0; k < rows; k++) {
        row_fill(cells, &row[k], &row[0], reference);
        if (k == 0)
            tabular_head(cells, file);
        tabular_row(cells, file);
        tabular_json(cells, json);
    }
    memory_free(cells);
    bool closed = file_close(json, lines, error);
    return file_close(file, path, error) && closed;
}

static bool reference_write(const struct speed_reference *reference, const char *directory,
                            struct error *error) {
    const struct sample_record *record = finest(reference);
    char path[FILE_PATH_MAX];
    FILE *file = file_open(directory, "speed_error_reference.csv", path, error);
    if (file == NULL)
        return false;
    fprintf(file, "observable,unit,judged,start,end,scale,reference_error,order,spread\n");
    fprintf(file, "trajectory,smallest radius,%d,0,0,1,%.6g,%.3g,%.6g\n", reference->judge_trajectory,
            reference->trajectory_uncertain, reference->trajectory_order, reference->trajectory_spread);
    for (int c = 0; c < record->own; c++)
        fprintf(file, "%s,%s,%d,%.9g,%.9g,%.6g,%.6g,%.3g,%.6g\n", record->name[c], record->unit[c],
                reference->judged[c], sample_value(record, 0, c),
                sample_value(record, record->samples - 1, c), reference->scale[c], reference->uncertain[c],
                reference->order[c], reference->spread[c]);
    return file_close(file, path, error);
}

/* Says so if other programs kept the machine busy: seconds then count for little. */
static void print_load(int own, FILE *file) {
    double load;
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    if (getloadavg(&load, 1) == 1 && load > fmax((double)cores, own) + 0.5)
        fprintf(file, "the load of this machine is %.1f on %ld core%s: seconds are of a busy machine\n", load,
                cores, cores == 1 ? "" : "s");
}

/* Prints the processor, ranks and threads of the timed runs, and the clock of the seconds. */
static void print_clock(const struct speed_reference *reference, FILE *file) {
    char cpu[128];
    bool lone = reference->ranks == 1 && reference->threads == 1;
    version_cpu(cpu, sizeof cpu);
    fprintf(file, "measured on %s: %d rank%s, %d thread%s each; seconds are %s\n", cpu, reference->ranks,
            reference->ranks == 1 ? "" : "s", reference->threads, reference->threads == 1 ? "" : "s",
            lone ? "the processor's" : "wall clock");
    print_load(reference->ranks * reference->threads, file);
}

static void print_reference(const struct speed_reference *reference, FILE *file) {
    const struct sample_record *record = finest(reference);
    fprintf(
        file,
        "reference: dt = %.4g; error of the reference by the step twice as long, order, spread of %d runs\n",
        reference->dt, reference->members);
    fprintf(file, "  %-26s %10.2g  order %5.2f  spread %.2g  (until t = %.4g, then chaos decides)\n",
            "trajectory", reference->trajectory_uncertain, reference->trajectory_order,
            reference->trajectory_spread, record->time[reference->horizon]);
    for (int c = 0; c < record->own; c++)
        fprintf(file, "  %-26s %10.2g  order %5.2f  spread %.2g%s\n", record->name[c],
                reference->uncertain[c], reference->order[c], reference->spread[c],
                reference->judged[c] ? "" : "  (not judged)");
    if (!isnan(reference->mean_from))
        fprintf(file, "columns are judged by their means from t = %.4g on\n", reference->mean_from);
    fprintf(file, "differences below %.2g cannot be told apart\n\n", reference->floor);
    fprintf(file, "  %-10s %-36s %10s %10s %10s %10s %10s\n", "", "", "seconds", "trajectory", "energy",
            "momentum", "judged");
}

static void print_row(const struct speed_row *row, const struct speed_reference *reference, FILE *file) {
    if (row->stopped[0])
        fprintf(file, "  %-10s %-36s %s\n", row->variant.group, row->variant.settings, row->stopped);
    else
        fprintf(file, "%s %-10s %-36s %10.4f %10.2g %10.2g %10.2g %10.2g  %s\n", row->on_front ? "*" : " ",
                row->variant.group, row->variant.settings, row->seconds, row->trajectory, row->drift,
                row->momentum, row->judged, column_of(reference, row->worst));
}

/* Prints a row in words, compared with the scene as it is. */
static void row_say(const struct speed_report *report, const struct speed_row *r, FILE *file) {
    const struct speed_reference *reference = report->reference;
    const struct speed_row *first = report->row;
    double error = r->worst >= 0 ? r->error[r->worst] : r->trajectory;
    double spread = r->worst >= 0 ? reference->spread[r->worst] : reference->trajectory_spread;
    fprintf(file, "%s, dt = %.3g (%.2g of the stable step",
            r == first ? "the scene as it is" : r->variant.settings, r->dt, r->dt / r->stable);
    if (report->facts->rayleigh > 0 && !variant_scales_step(&r->variant))
        fprintf(file, ", %.2g of Rayleigh's", r->dt / report->facts->rayleigh);
    fprintf(file, ")");
    if (r != first)
        fprintf(file, ": %.2f times as fast as the scene as it is (which is off by %.2g %%)",
                first->seconds / r->seconds, 100 * first->judged);
    fprintf(file, "; %s off by %.2g %%, spread %.2g %%", column_of(reference, r->worst), 100 * error,
            100 * spread);
}

/* Prints the gain and the error of a row, in a line. */
static void offer_say(const struct speed_report *report, const struct speed_row *r, double allowed,
                      FILE *file) {
    fprintf(file, "  %-10s %s: %.2f times as fast, %s off by %.2g %%%s\n", r->variant.group,
            r->variant.settings, report->row[0].seconds / r->seconds, column_of(report->reference, r->worst),
            100 * r->judged, r->judged <= allowed ? "" : ": more than is allowed");
}

/* Prints each row with a different model; of other settings the fastest row within the allowed error, or else
 * the nearest row. */
static void offers_say(const struct speed_report *report, double allowed, FILE *file) {
    for (int k = 1; k < report->rows; k++) {
        const struct speed_row *r = &report->row[k];
        const char *group = r->variant.group;
        bool model =
            strcmp(group, "law") == 0 || strcmp(group, "stiffness") == 0 || strcmp(group, "explicit") == 0;
        if (model && r->stopped[0] == '\0')
            offer_say(report, r, allowed, file);
        if (model || !speed_row_opens_group(report->row, k))
            continue;
        int best = speed_best(report, group, allowed);
        best = best >= 0 ? best : speed_most_exact(report, group);
        if (best >= 0)
            offer_say(report, &report->row[best], allowed, file);
    }
}

static void print_advice(const struct speed_report *report, FILE *file) {
    double allowed = fmax(report->tolerance, report->reference->floor);
    int best = speed_best(report, NULL, allowed);
    fprintf(file, "advice: ");
    if (best < 0) {
        best = speed_most_exact(report, NULL);
        fprintf(file, "nothing tried is within %.2g %%; the nearest is ", 100 * allowed);
    }
    row_say(report, &report->row[best], file);
    fprintf(file, "\neach law, and of other settings the fastest within %.2g %% or else the nearest:\n",
            100 * allowed);
    offers_say(report, allowed, file);
}

void speed_print(const struct speed_report *report, FILE *file) {
    print_clock(report->reference, file);
    print_reference(report->reference, file);
    for (int k = 0; k < report->rows; k++)
        print_row(&report->row[k], report->reference, file);
    fprintf(file, "\n");
    print_advice(report, file);
}

static bool text_write(const struct speed_report *report, const char *directory, struct error *error) {
    char path[FILE_PATH_MAX];
    FILE *file = file_open(directory, "speed_error.txt", path, error);
    if (file == NULL)
        return false;
    speed_print(report, file);
    return file_close(file, path, error);
}

bool speed_write(const struct speed_report *report, const char *directory, struct error *error) {
    if (!rows_write(report->row, report->rows, report->reference, directory, error) ||
        !reference_write(report->reference, directory, error) || !text_write(report, directory, error))
        return false;
    return speed_plot(report, directory, error);
}
