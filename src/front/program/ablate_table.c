/* SPDX-License-Identifier: BSD-3-Clause */
/* The tables of `scree ablate`, and the rows that the terminal shows. Read ablate_parts.h first. */
#include "front/program/ablate_parts.h"
#include "front/program/tabular.h"
#include "base/file.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

/* The columns of the table behind index and newton and the keys that vary: name, row of the report, format. */
static const struct {
    const char *name, *row, *format;
} columns[] = {{"ranks", "ranks", "%.0f"},
               {"threads", "threads", "%.0f"},
               {"particles", "particles", "%.0f"},
               {"steps", "steps", "%.0f"},
               {"dt", "dt", "%.9g"},
               {"seconds", "seconds", "%.6g"},
               {"particle_steps_per_second", "particle_steps_per_second", "%.6g"},
               {"pairs", "pairs", "%.0f"},
               {"contacts", "contacts", "%.0f"},
               {"rebuilds", "rebuilds", "%.0f"},
               {"bytes_per_particle", "bytes_per_particle", "%.1f"},
               {"peak_bytes", "memory_counted", "%.0f"}};
enum { COLUMNS = sizeof columns / sizeof columns[0] };

static const char *newton_word(const struct report *r) {
    return report_number(r, "newton") != 0 ? "on" : "off";
}

/* What the solver of contacts did: sweeps a step, the largest residual, and the largest overlap. NAN without a solver. */
struct solved {
    double sweeps, residual, overlap;
};

static struct solved solved_of(const struct report *r) {
    struct solved solved = {NAN, NAN, NAN};
    const struct report_table *solvers = report_list(r, "solvers"), *most = report_list(r, "solved_contacts");
    for (int k = 0; solvers && k < solvers->entries; k++)
        if (strcmp(report_list_text(solvers, k, "name"), "contacts") == 0) {
            solved.sweeps =
                report_list_number(solvers, k, "iterations") / report_list_number(solvers, k, "solves");
            solved.residual = report_list_number(solvers, k, "residual_worst");
        }
    if (most && most->entries > 0)
        solved.overlap = report_list_number(most, 0, "overlap_max");
    return solved;
}

/* The cells of a run; without a report the names alone count. */
static void cells_fill(struct tabular *cells, const struct ablate_tables *tables, const int *at,
                       const struct report *r) {
    const struct report_table *stages = r ? report_list(r, "stages") : NULL;
    const struct solved solved = r ? solved_of(r) : (struct solved){NAN, NAN, NAN};
    char name[TABULAR_NAME_MAX];
    cells->count = 0;
    tabular_word(cells, "index", r ? report_text(r, "index") : "");
    tabular_word(cells, "newton", r ? newton_word(r) : "");
    for (int k = 0; k < tables->axes; k++)
        tabular_word(cells, tables->axis[k].key, at ? tables->axis[k].value[at[k]] : "");
    for (int c = 0; c < COLUMNS; c++)
        tabular_number(cells, columns[c].name, columns[c].format, r ? report_number(r, columns[c].row) : 0.0);
    tabular_number(cells, "sweeps", "%.4g", solved.sweeps);
    tabular_number(cells, "residual", "%.3g", solved.residual);
    tabular_number(cells, "overlap", "%.3g", solved.overlap);
    for (int k = 0; k < tables->timers.stages; k++) {
        snprintf(name, sizeof name, "%s[s]", tables->timers.stage[k].name);
        tabular_number(cells, name, "%.6g", stages ? report_list_number(stages, k, "mean") : 0.0);
    }
}

static void print_row(const struct report *r, const struct tabular *cells, int varied) {
    const struct solved solved = solved_of(r);
    printf("  %-10s %-6s %7.0f %10.4f s %10.2f M/s %12.0f pairs  rebuild %.4f s  %.0f bytes/particle",
           report_text(r, "index"), newton_word(r), report_number(r, "threads"), report_number(r, "seconds"),
           1e-6 * report_number(r, "particle_steps_per_second"), report_number(r, "pairs"),
           report_number(r, "seconds_rebuild"), report_number(r, "bytes_per_particle"));
    if (!isnan(solved.sweeps))
        printf("  %.4g sweeps a step, residual %.2g, overlap %.2g", solved.sweeps, solved.residual,
               solved.overlap);
    for (int k = 2; k < 2 + varied; k++)
        printf("  %s=%s", cells->cell[k].name, cells->cell[k].text);
    printf("\n");
    fflush(stdout);
}

static FILE *table_open(const char *directory, const char *name, struct error *error) {
    char path[FILE_PATH_MAX];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *file = fopen(path, "w");
    if (file == NULL)
        error_set_errno(error, "%s", path);
    return file;
}

bool ablate_tables_open(struct ablate_tables *tables, const char *directory, struct error *error) {
    tables->csv = table_open(directory, "ablate.csv", error);
    tables->json = tables->csv ? table_open(directory, "ablate.jsonl", error) : NULL;
    if (tables->json == NULL)
        return false;
    struct tabular *cells = memory_allocate(1, sizeof *cells, "a row of a table");
    cells_fill(cells, tables, NULL, NULL);
    tabular_head(cells, tables->csv);
    memory_free(cells);
    return true;
}

void ablate_tables_row(const struct ablate_tables *tables, const int *at, const struct report *report) {
    struct tabular *cells = memory_allocate(1, sizeof *cells, "a row of a table");
    cells_fill(cells, tables, at, report);
    tabular_row(cells, tables->csv);
    tabular_json(cells, tables->json);
    print_row(report, cells, tables->axes);
    memory_free(cells);
}

static void table_close(FILE *file, const char *directory, const char *name, struct error *error) {
    if (file && fclose(file) != 0)
        error_set_errno(error, "%s/%s", directory, name);
}

void ablate_tables_close(struct ablate_tables *tables, const char *directory, struct error *error) {
    table_close(tables->csv, directory, "ablate.csv", error);
    table_close(tables->json, directory, "ablate.jsonl", error);
}
