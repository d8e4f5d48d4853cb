/* SPDX-License-Identifier: BSD-3-Clause */
/* The entries of a run report, a row each, in the order of report.json. Read report_rows.h first. */
#include "data/observe/report_rows.h"

#include "base/version.h"
#include "data/observe/progress.h"

#include <string.h>

static double mega(double value) {
    return value / 1e6;
}

static double milli(double value) {
    return 1e3 * value;
}

static double percent(double value) {
    return 100 * value;
}

static double threads_working(const struct report *report) {
    return report->threads_working > 0 ? report->threads_working : report->threads;
}

static const char *duration(const void *report, char *text, size_t room) {
    progress_duration(((const struct report *)report)->seconds, text, room);
    return text;
}

static const char *unit_of_length(const void *report, char *text, size_t room) {
    (void)text;
    (void)room;
    return ((const struct report *)report)->dimensionless ? "" : " [m]";
}

static const char *version(const void *report, char *text, size_t room) {
    (void)report;
    (void)text;
    (void)room;
    return version_number();
}

static const char *revision(const void *report, char *text, size_t room) {
    (void)report;
    (void)text;
    (void)room;
    return version_revision();
}

static const char *compiler(const void *report, char *text, size_t room) {
    (void)report;
    (void)text;
    (void)room;
    return version_compiler();
}

static const char *flags(const void *report, char *text, size_t room) {
    (void)report;
    (void)text;
    (void)room;
    return version_flags();
}

static const char *host(const void *report, char *text, size_t room) {
    (void)report;
    version_host(text, room);
    return text;
}

static const char *cpu(const void *report, char *text, size_t room) {
    (void)report;
    version_cpu(text, room);
    return text;
}

static const char *insertion_note(const void *base, char *text, size_t room) {
    const struct report_insertion *insertion = base;
    if (insertion->lost > 0) {
        snprintf(text, room, ": NOTE: %llu of them outside of the box, which deletes them (box.leave)",
                 (unsigned long long)insertion->lost);
        return text;
    }
    return (double)insertion->placed < 0.9 * (double)insertion->asked
               ? ": NOTE: its region is too full for the rest, or walls stand in it"
               : "";
}

static bool chosen(const struct report *report) {
    return report->choice[0] != '\0';
}

/* The place of a member; the place of a list of structs, and of the member that counts its entries. */
#define AT(type, member) .offset = offsetof(type, member)
#define LIST(member, counter)                                                                                \
    AT(struct report, member), .size = sizeof(((struct report *)0)->member[0]),                              \
                               .count_offset = offsetof(struct report, counter)

/* One row an entry, packed to the line: */
/* clang-format off */

static const struct report_row choice_rows[] = {
    {.name = "index", .unit = "", .type = REPORT_TEXT, AT(struct report, choice),
     .help = "the last choice on the first rank"},
    {.name = "choices", .unit = "1", .type = REPORT_COUNT, AT(struct report, choices), .print = "%.0f",
     .help = "number of choices"},
    {.name = "why", .unit = "", .type = REPORT_TEXT, AT(struct report, choice_why),
     .help = "the counts of the cost model for this choice"},
    {.name = "predicted_seconds", .unit = "s", .type = REPORT_REAL, AT(struct report, choice_predicted), .print = "%.4g", .seen = milli,
     .help = "predicted time of a rebuild, from sorting to the pair list; slowest rank"},
    {.name = "measured_seconds", .unit = "s", .type = REPORT_REAL, AT(struct report, choice_measured), .print = "%.4g", .seen = milli,
     .help = "measured time of a rebuild"},
    {0}};

static const struct report_row level_rows[] = {
    {.name = "cells", .unit = "1", .type = REPORT_COUNT, AT(struct report_level, cells),
     .help = "cells of all ranks"},
    {.name = "particles", .unit = "1", .type = REPORT_COUNT, AT(struct report_level, particles),
     .help = "particles in these cells, copies included"},
    {.name = "cell_size", .unit = "m", .type = REPORT_REAL, AT(struct report_level, cell), .print = "%.5g",
     .help = "edge of a cell"},
    {.name = "radius_min", .unit = "m", .type = REPORT_REAL, AT(struct report_level, radius_min), .print = "%.5g",
     .help = "lower bound of the radii of the level"},
    {.name = "radius_max", .unit = "m", .type = REPORT_REAL, AT(struct report_level, radius_max), .print = "%.5g",
     .help = "upper bound of the radii of the level"},
    {0}};

static const struct report_row class_rows[] = {
    {.name = "particles", .unit = "1", .type = REPORT_COUNT, AT(struct report_class, particles),
     .help = "particles at the last rebuild"},
    {.name = "ghosts", .unit = "1", .type = REPORT_COUNT, AT(struct report_class, ghosts),
     .help = "copies of these particles"},
    {.name = "bytes", .unit = "B", .type = REPORT_COUNT, AT(struct report_class, bytes), .print = "%.4g", .seen = mega,
     .help = "bytes received for these copies, and sent back"},
    {.name = "radius_min", .unit = "m", .type = REPORT_REAL, AT(struct report_class, radius_min),
     .help = "lower bound of the radii of the class"},
    {.name = "radius_max", .unit = "m", .type = REPORT_REAL, AT(struct report_class, radius_max),
     .help = "upper bound of the radii of the class"},
    {.name = "skin", .unit = "m", .type = REPORT_REAL, AT(struct report_class, skin),
     .help = "skin of the class with itself at the last rebuild"},
    {0}};

static const struct report_row scene_stage_rows[] = {
    {.name = "name", .unit = "", .type = REPORT_TEXT, AT(struct report_scene_stage, name), .help = "name in the scene"},
    {.name = "first", .unit = "1", .type = REPORT_COUNT, AT(struct report_scene_stage, first),
     .help = "number of the step before the first step of the stage"},
    {.name = "last", .unit = "1", .type = REPORT_COUNT, AT(struct report_scene_stage, last),
     .help = "number of its last step"},
    {.name = "time", .unit = "s", .type = REPORT_REAL, AT(struct report_scene_stage, time), .print = "%.6g",
     .help = "simulated time at its end"},
    {.name = "seconds", .unit = "s", .type = REPORT_REAL, AT(struct report_scene_stage, seconds), .print = "%.3g",
     .help = "wall clock without set-up"},
    {.name = "end", .unit = "", .type = REPORT_TEXT, AT(struct report_scene_stage, end),
     .help = "`duration`, `conditions`, `duration, before the conditions held`, or `broken off` by a signal or an error"},
    {0}};

static const struct report_row insertion_rows[] = {
    {.name = "name", .unit = "", .type = REPORT_TEXT, AT(struct report_insertion, name),
     .help = "name in the scene; without a name `insertions[0]` and so on"},
    {.name = "asked", .unit = "1", .type = REPORT_COUNT, AT(struct report_insertion, asked),
     .help = "particles that were due at the last look at the region, since the start of the run"},
    {.name = "placed", .unit = "1", .type = REPORT_COUNT, AT(struct report_insertion, placed),
     .help = "the particles that found a place among these"},
    {.name = "lost", .unit = "1", .type = REPORT_COUNT, AT(struct report_insertion, lost),
     .help = "the particles among these that this run placed outside of the box, which deletes them (`box.leave`)"},
    {.name = "note", .unit = "", .type = REPORT_TEXT, .text = insertion_note, .terminal = true,
     .help = "a note if particles were lost, or more than a tenth of those due found no place"},
    {0}};

static const struct report_row stage_rows[] = {
    {.name = "min", .unit = "s", .type = REPORT_REAL, AT(struct report_stage, min), .print = "%.3f",
     .help = "least over ranks"},
    {.name = "mean", .unit = "s", .type = REPORT_REAL, AT(struct report_stage, mean), .print = "%.3f",
     .help = "mean over ranks"},
    {.name = "max", .unit = "s", .type = REPORT_REAL, AT(struct report_stage, max), .print = "%.3f",
     .help = "most over ranks"},
    {0}};

static const struct report_row solver_rows[] = {
    {.name = "name", .unit = "", .type = REPORT_TEXT, AT(struct report_solver, name),
     .help = "the unknown: `velocity`, `pressure`, or `steady` for both at once; `contacts` of contact.solver"},
    {.name = "rows", .unit = "1", .type = REPORT_COUNT, AT(struct report_solver, rows),
     .help = "unknowns, all ranks together; of contacts: contacts of the last step that may close"},
    {.name = "entries", .unit = "1", .type = REPORT_COUNT, AT(struct report_solver, entries),
     .help = "numbers that the matrix holds; 0 without a matrix"},
    {.name = "solves", .unit = "1", .type = REPORT_COUNT, AT(struct report_solver, solves),
     .help = "systems solved"},
    {.name = "iterations", .unit = "1", .type = REPORT_COUNT, AT(struct report_solver, iterations),
     .help = "iterations of all solves"},
    {.name = "set_ups", .unit = "1", .type = REPORT_COUNT, AT(struct report_solver, set_ups),
     .help = "preconditioners made"},
    {.name = "kept", .unit = "1", .type = REPORT_COUNT, AT(struct report_solver, kept),
     .help = "solves of a matrix with new values for which the old preconditioner was kept"},
    {.name = "doubtful", .unit = "1", .type = REPORT_COUNT, AT(struct report_solver, doubtful),
     .help = "solves whose true residual was above ten times the tolerance (`guards.residual`); of contacts: above the tolerance"},
    {.name = "residual", .unit = "1", .type = REPORT_REAL, AT(struct report_solver, residual), .print = "%.2g",
     .help = "true residual of the last solve, |b - A x| / |b|"},
    {.name = "residual_worst", .unit = "1", .type = REPORT_REAL, AT(struct report_solver, residual_worst), .print = "%.2g",
     .help = "the largest true residual of a solve"},
    {.name = "seconds_matrix", .unit = "s", .type = REPORT_REAL, AT(struct report_solver, seconds_matrix), .print = "%.3f",
     .help = "wall clock for handing over the matrix and its values; slowest rank"},
    {.name = "seconds_set_up", .unit = "s", .type = REPORT_REAL, AT(struct report_solver, seconds_set_up), .print = "%.3f",
     .help = "wall clock of the preconditioners made; slowest rank"},
    {.name = "seconds_solve", .unit = "s", .type = REPORT_REAL, AT(struct report_solver, seconds_solve), .print = "%.3f",
     .help = "wall clock of the solves, without that of preconditioners made; slowest rank"},
    {.name = "products", .unit = "1", .type = REPORT_COUNT, AT(struct report_solver, products),
     .help = "products of the matrix with a vector for the true residuals"},
    {.name = "seconds_products", .unit = "s", .type = REPORT_REAL, AT(struct report_solver, seconds_products),
     .help = "wall clock of these products; slowest rank"},
    {0}};

static bool has_stages(const struct report *report) {
    return report->scene_stages > 0;
}

static bool has_solvers(const struct report *report) {
    return report->solvers > 0;
}

const struct report_row report_rows[] = {
    {.name = "steps", .unit = "1", .type = REPORT_COUNT, AT(struct report, steps),
     .help = "steps done by this program"},
    {.name = "last_step", .unit = "1", .type = REPORT_COUNT, AT(struct report, step_last), .print = "%.0f",
     .help = "number of the last step of the run"},
    {.name = "time", .unit = "s", .type = REPORT_REAL, AT(struct report, time),
     .help = "simulated time at the end"},
    {.name = "dt", .unit = "s", .type = REPORT_REAL, AT(struct report, dt),
     .help = "time step"},
    {.name = "particles", .unit = "1", .type = REPORT_COUNT, AT(struct report, particles),
     .help = "number of particles at the end"},
    {.name = "ranks", .unit = "1", .type = REPORT_NUMBER, AT(struct report, ranks), .print = "rank|ranks",
     .help = "MPI ranks"},
    {.name = "threads", .unit = "1", .type = REPORT_NUMBER, AT(struct report, threads), .print = "thread|threads",
     .help = "threads of a rank"},
    {.name = "threads_working", .unit = "1", .type = REPORT_REAL, .real = threads_working, .print = "%.1f",
     .help = "threads that worked at a time, mean over the run (rank 0); fewer than `threads` if other programs used the cores"},
    {.name = "index", .unit = "", .type = REPORT_TEXT, AT(struct report, index),
     .help = "the index of the scene"},
    {.name = "law", .unit = "", .type = REPORT_TEXT, AT(struct report, law),
     .help = "normal contact law, `hooke` or `hertz`"},
    {.name = "integrator", .unit = "", .type = REPORT_TEXT, AT(struct report, integrator),
     .help = "the integrator"},
    {.name = "newton", .unit = "", .type = REPORT_FLAG, AT(struct report, newton), .print = "on|off",
     .help = "whether a pair that crosses ranks is computed on one rank only"},
    {.name = "reduced_ghosts", .unit = "", .type = REPORT_FLAG, AT(struct report, reduced),
     .help = "whether copies of small particles travel only as far as small partners"},
    {.name = "simd", .unit = "", .type = REPORT_TEXT, AT(struct report, simd),
     .help = "instruction set of the force loop"},
    {.name = "reproducible", .unit = "", .type = REPORT_FLAG, AT(struct report, reproducible), .print = ", reproducible|",
     .help = "whether results are the same to the last bit on every layout"},
    {.name = "particle_steps_per_second", .unit = "1/s", .type = REPORT_REAL, .real = report_speed, .print = "%.4g",
     .help = "particles times steps, over `seconds`"},
    {.name = "seconds", .unit = "s", .type = REPORT_REAL, AT(struct report, seconds), .print = "%.2f",
     .help = "wall clock of the steps and of the output between steps, slowest rank; without set-up"},
    {.name = "duration", .unit = "", .type = REPORT_TEXT, .text = duration, .terminal = true,
     .help = "the same as days, hours, minutes, seconds"},
    {.name = "seconds_setup", .unit = "s", .type = REPORT_REAL, AT(struct report, seconds_setup),
     .help = "wall clock before the first step, slowest rank"},
    {.name = "pairs", .unit = "1", .type = REPORT_COUNT, AT(struct report, pairs),
     .help = "pairs in the last pair list"},
    {.name = "contacts", .unit = "1", .type = REPORT_COUNT, AT(struct report, contacts),
     .help = "number of contacts at the end, with walls"},
    {.name = "skin_factor", .unit = "1", .type = REPORT_REAL, AT(struct report, skin_factor), .print = "%.3g",
     .help = "factor on the skins of the scene at the end; 1 without `skin: auto`"},
    {.name = "skin_changes", .unit = "1", .type = REPORT_COUNT, AT(struct report, skin_changes), .print = "%.0f",
     .help = "how often `skin: auto` changed the factor"},
    {.name = "rebuilds", .unit = "1", .type = REPORT_COUNT, AT(struct report, rebuilds),
     .help = "number of rebuilds"},
    {.name = "sorts", .unit = "1", .type = REPORT_COUNT, AT(struct report, sorts),
     .help = "number of rebuilds that sorted the particles into the order of the index; others left them as they lay"},
    {.name = "bytes_per_particle", .unit = "B", .type = REPORT_REAL, AT(struct report, bytes_per_particle), .print = "%.0f",
     .help = "largest memory of the arrays, all ranks together, over `particles`"},
    {.name = "memory_peak", .unit = "B", .type = REPORT_COUNT, AT(struct report, memory_peak), .print = "%.1f", .seen = mega,
     .help = "largest resident memory of a rank"},
    {.name = "memory_held", .unit = "B", .type = REPORT_COUNT, AT(struct report, memory_held),
     .help = "memory of the arrays at the end, all ranks together"},
    {.name = "inserted", .unit = "1", .type = REPORT_COUNT, AT(struct report, inserted),
     .help = "particles inserted since the start of the run"},
    {.name = "deleted", .unit = "1", .type = REPORT_COUNT, AT(struct report, deleted),
     .help = "particles deleted since the start of the run"},
    {.name = "seed", .unit = "", .type = REPORT_COUNT, AT(struct report, seed),
     .help = "seed of the scene"},
    {.name = "stopped", .unit = "", .type = REPORT_TEXT, AT(struct report, stopped),
     .help = "`signal 15` or another signal if a signal ended the run; else empty"},
    {.name = "ghosts", .unit = "1", .type = REPORT_EACH, AT(struct report, ghosts),
     .help = "copies of other ranks' particles at the end, a number for each rank"},
    {.name = "messages", .unit = "1", .type = REPORT_EACH, AT(struct report, messages), .print = "%.1f",
     .help = "messages sent in the steps, a number for each rank"},
    {.name = "bytes", .unit = "B", .type = REPORT_EACH, AT(struct report, bytes), .print = "%.4g",
     .help = "bytes in these messages, a number for each rank"},
    {.name = "rebuild_messages", .unit = "1", .type = REPORT_COUNT, AT(struct report, rebuild_messages),
     .help = "the messages at rebuilds among these messages; all ranks together"},
    {.name = "rebuild_bytes", .unit = "B", .type = REPORT_COUNT, AT(struct report, rebuild_bytes),
     .help = "bytes in the messages at rebuilds"},
    {.name = "pupcs", .unit = "1/s", .type = REPORT_REAL, .real = report_pupcs, .print = "%.3g",
     .help = "particle updates per core and second: `particle_steps_per_second` over ranks times threads (Eibl and Rüde)"},
    {.name = "imbalance", .unit = "1", .type = REPORT_REAL, AT(struct report, imbalance), .print = "%.3f",
     .help = "largest over mean seconds of work of the ranks"},
    {.name = "sync_share", .unit = "1", .type = REPORT_REAL, AT(struct report, sync_share), .print = "%.1f", .seen = percent,
     .help = "share of communication and waiting in all seconds"},
    {.name = "sync", .unit = "", .type = REPORT_TEXT, AT(struct report, sync),
     .help = "the way by which copies spread, and the reason"},
    {.name = "domain", .unit = "", .type = REPORT_TEXT, AT(struct report, domain),
     .help = "the division of the box among ranks, `brick` or `bisection`"},
    {.name = "divisions", .unit = "1", .type = REPORT_COUNT, AT(struct report, divisions),
     .help = "number of later divisions of the box"},
    {.name = "version", .unit = "", .type = REPORT_TEXT, .text = version,
     .help = "version of the program"},
    {.name = "git_revision", .unit = "", .type = REPORT_TEXT, .text = revision,
     .help = "revision of the source of the program"},
    {.name = "compiler", .unit = "", .type = REPORT_TEXT, .text = compiler,
     .help = "compiler of the program"},
    {.name = "flags", .unit = "", .type = REPORT_TEXT, .text = flags,
     .help = "flags of the compiler"},
    {.name = "host", .unit = "", .type = REPORT_TEXT, .text = host,
     .help = "machine of the first rank"},
    {.name = "cpu", .unit = "", .type = REPORT_TEXT, .text = cpu,
     .help = "processor of this machine"},
    {.name = "unit_of_length", .unit = "", .type = REPORT_TEXT, .text = unit_of_length, .terminal = true,
     .help = "behind the heading of radii"},
    {.name = "index_choice", .unit = "", .type = REPORT_GROUP, .rows = choice_rows, .shown = chosen,
     .help = "the choice of an index that chooses (`auto`); absent for other indexes"},
    {.name = "levels", .unit = "", .type = REPORT_LIST, LIST(level, levels), .rows = level_rows,
     .help = "grids of the index, from small to large; empty without grids"},
    {.name = "classes", .unit = "", .type = REPORT_LIST, LIST(size_class, classes), .rows = class_rows,
     .help = "size classes, from small to large"},
    {.name = "insertions", .unit = "", .type = REPORT_LIST, LIST(insertion, insertions), .apart = true, .rows = insertion_rows,
     .help = "regions of the scene's `insertions`, in the order of the scene"},
    {.name = "scene_stages", .unit = "", .type = REPORT_LIST, LIST(scene_stage, scene_stages), .rows = scene_stage_rows,
     .shown = has_stages,
     .help = "stages of the scene's `stages` that this program has run; absent without. All other entries are of the last of them"},
    {.name = "stages", .unit = "s", .type = REPORT_STAGES, AT(struct report, stage), .rows = stage_rows,
     .help = "wall clock of each stage, exclusive of the others: `min`, `mean` and `max` over ranks"},
    {.name = "setup_stages", .unit = "s", .type = REPORT_STAGES, AT(struct report, setup_stage), .rows = stage_rows,
     .help = "the same of the time before the first step, stage by stage"},
    {.name = "solvers", .unit = "", .type = REPORT_LIST, LIST(solver, solvers), .rows = solver_rows, .shown = has_solvers,
     .help = "linear solvers of a fluid, and the solver of contacts; absent without these"},
    {0}};

/* clang-format on */

const struct report_row *report_row_find(const struct report_row *rows, const char *name, size_t length) {
    size_t part = 0;
    while (part < length && name[part] != '.')
        part++;
    for (const struct report_row *row = rows; row->name; row++) {
        if (strlen(row->name) != part || memcmp(row->name, name, part) != 0)
            continue;
        return part == length ? row : report_row_find(row->rows, name + part + 1, length - part - 1);
    }
    return NULL;
}

int report_row_entries(const struct report_row *row, const struct report *report) {
    return *(const int *)((const char *)report + row->count_offset);
}

const void *report_row_entry(const struct report_row *row, const struct report *report, int k) {
    const char *first = (const char *)report + row->offset;
    if (row->apart)
        first = *(const char *const *)(const void *)first;
    return first + (size_t)k * row->size;
}

uint64_t report_row_count(const struct report_row *row, const void *base) {
    return *(const uint64_t *)((const char *)base + row->offset);
}

int report_row_number(const struct report_row *row, const void *base) {
    return *(const int *)((const char *)base + row->offset);
}

double report_row_real(const struct report_row *row, const void *base) {
    return row->real ? row->real(base) : *(const double *)((const char *)base + row->offset);
}

bool report_row_flag(const struct report_row *row, const void *base) {
    return *(const bool *)((const char *)base + row->offset);
}

const uint64_t *report_row_each(const struct report_row *row, const void *base) {
    return *(uint64_t *const *)((const char *)base + row->offset);
}

const char *report_row_text(const struct report_row *row, const void *base, char *text, size_t room) {
    return row->text ? row->text(base, text, room) : (const char *)base + row->offset;
}
