/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of the lists of a report, with their getters. Read run_report_source.h first. */
#include "engine/run_report_source.h"
#include "engine/sources.h"
#include "engine/tune.h"
#include <math.h>
#include <stdio.h>

/* One getter a line, one row an entry, packed to the line: */
/* clang-format off */

/* The choice of the index. Each rank chooses by itself; the words are those of rank 0. */
int run_report_choices(const struct report_source *of) {
    int choices = of->index.choice[0] != '\0';
    comm_broadcast(of->s->comm, &choices, sizeof choices);
    return choices;
}

TEXT(choice_index, of->index.choice)
COUNT(choice_count, of->index.choices)
TEXT(choice_why, of->index.why)
REAL(choice_predicted, most(of, of->index.predicted))
REAL(choice_measured, most(of, tune_measured(&of->s->search)))

const struct report_row run_report_choice_rows[] = {
    {.name = "index", .unit = "", .text = choice_index,
     .help = "the last choice on the first rank"},
    {.name = "choices", .unit = "1", .count = choice_count, .print = "%.0f",
     .help = "number of choices"},
    {.name = "why", .unit = "", .text = choice_why,
     .help = "the counts of the cost model for this choice"},
    {.name = "predicted_seconds", .unit = "s", .real = choice_predicted, .print = "%.4g", .times = 1e3,
     .help = "predicted time of a rebuild, from sorting to the pair list; slowest rank"},
    {.name = "measured_seconds", .unit = "s", .real = choice_measured, .print = "%.4g", .times = 1e3,
     .help = "measured time of a rebuild"},
    {0}};

/* The levels of the index. Ranks may differ: there are as many as on the rank with most of them, the counts are sums, and
 * bounds and cells are the widest. */
int run_report_levels(const struct report_source *of) {
    return (int)most(of, of->index.levels);
}

static bool has_level(const struct report_source *of, int k) {
    return k < of->index.levels;
}

COUNT(level_cells, count_all(of, has_level(of, k) ? of->index.level[k].cells : 0))
COUNT(level_particles, count_all(of, has_level(of, k) ? of->index.level[k].particles : 0))
REAL(level_cell_size, most(of, has_level(of, k) ? of->index.level[k].cell : -INFINITY))
REAL(level_radius_min, least(of, has_level(of, k) ? of->index.level[k].radius_min : INFINITY))
REAL(level_radius_max, most(of, has_level(of, k) ? of->index.level[k].radius_max : -INFINITY))

const struct report_row run_report_level_rows[] = {
    {.name = "cells", .unit = "1", .count = level_cells,
     .help = "cells of all ranks"},
    {.name = "particles", .unit = "1", .count = level_particles,
     .help = "particles in these cells, copies included"},
    {.name = "cell_size", .unit = "m", .real = level_cell_size, .print = "%.5g",
     .help = "edge of a cell"},
    {.name = "radius_min", .unit = "m", .real = level_radius_min, .print = "%.5g",
     .help = "lower bound of the radii of the level"},
    {.name = "radius_max", .unit = "m", .real = level_radius_max, .print = "%.5g",
     .help = "upper bound of the radii of the level"},
    {0}};

int run_report_classes(const struct report_source *of) {
    return of->s->classes.count;
}

COUNT(class_particles, of->s->classes.population[k])
COUNT(class_ghosts, count_all(of, of->ghosts.ghosts_class[k]))
COUNT(class_bytes, count_all(of, of->ghosts.bytes_class[k]))
REAL(class_radius_min, of->s->classes.radius_min[k])
REAL(class_radius_max, of->s->classes.radius_max[k])
REAL(class_skin, of->s->classes.skin[k][k])

const struct report_row run_report_class_rows[] = {
    {.name = "particles", .unit = "1", .count = class_particles,
     .help = "particles at the last rebuild"},
    {.name = "ghosts", .unit = "1", .count = class_ghosts,
     .help = "copies of these particles"},
    {.name = "bytes", .unit = "B", .count = class_bytes, .print = "%.4g", .times = 1e-6,
     .help = "bytes received for these copies, and sent back"},
    {.name = "radius_min", .unit = "m", .real = class_radius_min,
     .help = "lower bound of the radii of the class"},
    {.name = "radius_max", .unit = "m", .real = class_radius_max,
     .help = "upper bound of the radii of the class"},
    {.name = "skin", .unit = "m", .real = class_skin,
     .help = "skin of the class with itself at the last rebuild"},
    {0}};

int run_report_insertions(const struct report_source *of) {
    return of->s->scene->insertions;
}

static const char *insertion_name(const struct report_source *of, int k, char *buffer, size_t room) {
    const char *name = of->s->scene->insertion[k].name;
    snprintf(buffer, room, "insertions[%d]", k);
    return name[0] ? name : buffer;
}

COUNT(insertion_asked, sources_asked(&of->s->sources, &of->s->clock, k))
COUNT(insertion_placed, of->s->sources.state[k].placed)
COUNT(insertion_lost, of->s->sources.lost[k])

static const char *insertion_note(const struct report_source *of, int k, char *buffer, size_t room) {
    if (insertion_lost(of, k) > 0) {
        snprintf(buffer, room, ": NOTE: %llu of them outside of the box, which deletes them (box.leave)",
                 (unsigned long long)insertion_lost(of, k));
        return buffer;
    }
    return (double)insertion_placed(of, k) < 0.9 * (double)insertion_asked(of, k)
               ? ": NOTE: its region is too full for the rest, or walls stand in it"
               : "";
}

const struct report_row run_report_insertion_rows[] = {
    {.name = "name", .unit = "", .text = insertion_name,
     .help = "name in the scene; without a name `insertions[0]` and so on"},
    {.name = "asked", .unit = "1", .count = insertion_asked,
     .help = "particles that were due at the last look at the region, since the start of the run"},
    {.name = "placed", .unit = "1", .count = insertion_placed,
     .help = "the particles that found a place among these"},
    {.name = "lost", .unit = "1", .count = insertion_lost,
     .help = "the particles among these that this run placed outside of the box, which deletes them (`box.leave`)"},
    {.name = "note", .unit = "", .text = insertion_note, .terminal = true,
     .help = "a note if particles were lost, or more than a tenth of those due found no place"},
    {0}};

int run_report_scene_stages(const struct report_source *of) {
    return of->chain ? of->chain->done : 0;
}

TEXT(scene_stage_name, of->chain->row[k].name)
COUNT(scene_stage_first, of->chain->row[k].first)
COUNT(scene_stage_last, of->chain->row[k].last)
REAL(scene_stage_time, of->chain->row[k].time)
REAL(scene_stage_seconds, of->chain->row[k].seconds)
TEXT(scene_stage_end, of->chain->row[k].end)

const struct report_row run_report_scene_stage_rows[] = {
    {.name = "name", .unit = "", .text = scene_stage_name, .help = "name in the scene"},
    {.name = "first", .unit = "1", .count = scene_stage_first,
     .help = "number of the step before the first step of the stage"},
    {.name = "last", .unit = "1", .count = scene_stage_last,
     .help = "number of its last step"},
    {.name = "time", .unit = "s", .real = scene_stage_time, .print = "%.6g",
     .help = "simulated time at its end"},
    {.name = "seconds", .unit = "s", .real = scene_stage_seconds, .print = "%.3g",
     .help = "wall clock without set-up"},
    {.name = "end", .unit = "", .text = scene_stage_end,
     .help = "`duration`, `conditions`, `duration, before the conditions held`, or `broken off` by a signal or an error"},
    {0}};

/* All ranks have the same stages. */
int run_report_stages(const struct report_source *of) {
    return of->s->timers.stages;
}

TEXT(stage_name, of->s->timers.stage[k].name)
REAL(stage_min, least(of, of->s->timers.stage[k].seconds))
REAL(stage_mean, sum_all(of, of->s->timers.stage[k].seconds) / of->s->comm->size)
REAL(stage_max, most(of, of->s->timers.stage[k].seconds))

/* The share of the stage in all but the set-up. */
static const char *stage_share(const struct report_source *of, int k, char *buffer, size_t room) {
    double all = sum_all(of, timer_sum(&of->s->timers, 0, TIMER_START)) / of->s->comm->size;
    double mean = stage_mean(of, k);
    if ((of->s->timers.stage[k].use & TIMER_START) || all <= 0)
        return "";
    snprintf(buffer, room, "%.1f %%", 100 * mean / all);
    return buffer;
}

const struct report_row run_report_stage_rows[] = {
    {.name = "name", .unit = "", .text = stage_name, .help = "name of the stage"},
    {.name = "min", .unit = "s", .real = stage_min, .print = "%.3f", .help = "least over ranks"},
    {.name = "mean", .unit = "s", .real = stage_mean, .print = "%.3f", .help = "mean over ranks"},
    {.name = "max", .unit = "s", .real = stage_max, .print = "%.3f", .help = "most over ranks"},
    {.name = "share", .unit = "", .text = stage_share, .terminal = true, .help = "share of all seconds"},
    {0}};

TEXT(setup_name, of->run->start.stage[k].name)
REAL(setup_min, least(of, of->run->start.stage[k].seconds))
REAL(setup_mean, sum_all(of, of->run->start.stage[k].seconds) / of->s->comm->size)
REAL(setup_max, most(of, of->run->start.stage[k].seconds))

const struct report_row run_report_setup_rows[] = {
    {.name = "name", .unit = "", .text = setup_name, .help = "name of the stage"},
    {.name = "min", .unit = "s", .real = setup_min, .help = "least over ranks"},
    {.name = "mean", .unit = "s", .real = setup_mean, .help = "mean over ranks"},
    {.name = "max", .unit = "s", .real = setup_max, .help = "most over ranks"},
    {0}};

int run_report_solvers(const struct report_source *of) {
    return of->part.solvers;
}

int run_report_contacts(const struct report_source *of) {
    return of->part.contacts != NULL;
}

REAL(hard_overlap, most(of, of->part.contacts->overlap))
REAL(hard_approach, most(of, of->part.contacts->approach))
REAL(hard_news, of->part.contacts->news)
REAL(hard_fastest, most(of, of->part.contacts->fastest))

const struct report_row run_report_contacts_rows[] = {
    {.name = "overlap_max", .unit = "1", .real = hard_overlap, .print = "%.2g",
     .help = "largest overlap of a step, over the smaller radius"},
    {.name = "approach_max", .unit = "1", .real = hard_approach, .print = "%.2g",
     .help = "largest speed at which two grains that touch still approach after a solve, over g times the step; 0 without gravity"},
    {.name = "news", .unit = "m/s", .real = hard_news, .print = "%.3g",
     .help = "how far news travels in a second: sqrt(kappa) smallest grains a step; 0 for an implicit law"},
    {.name = "fastest", .unit = "m/s", .real = hard_fastest, .print = "%.3g",
     .help = "largest speed of a grain without the contacts of its step"},
    {0}};

TEXT(solver_name, of->part.solver[k].name)
COUNT(solver_rows, of->part.solver[k].rows)
COUNT(solver_entries, of->part.solver[k].entries)
COUNT(solver_solves, of->part.solver[k].solves)
COUNT(solver_iterations, of->part.solver[k].iterations)
COUNT(solver_set_ups, of->part.solver[k].set_ups)
COUNT(solver_kept, of->part.solver[k].kept)
COUNT(solver_doubtful, of->part.solver[k].doubtful)
REAL(solver_residual, of->part.solver[k].residual)
REAL(solver_residual_worst, of->part.solver[k].residual_worst)
REAL(solver_seconds_matrix, most(of, of->part.solver[k].seconds_matrix))
REAL(solver_seconds_set_up, most(of, of->part.solver[k].seconds_set_up))
REAL(solver_seconds_solve, most(of, of->part.solver[k].seconds_solve))
COUNT(solver_products, of->part.solver[k].products)
REAL(solver_seconds_products, most(of, of->part.solver[k].seconds_products))

const struct report_row run_report_solver_rows[] = {
    {.name = "name", .unit = "", .text = solver_name,
     .help = "the unknown: `velocity`, `pressure`, or `steady` for both at once; `contacts` of contact.solver, by sweeps; `newton` its steps by Newton's method, `newton_step` their linear systems"},
    {.name = "rows", .unit = "1", .count = solver_rows,
     .help = "unknowns, all ranks together; of contacts: contacts of the last step that may close"},
    {.name = "entries", .unit = "1", .count = solver_entries,
     .help = "numbers that the matrix holds; 0 without a matrix"},
    {.name = "solves", .unit = "1", .count = solver_solves,
     .help = "systems solved"},
    {.name = "iterations", .unit = "1", .count = solver_iterations,
     .help = "iterations of all solves"},
    {.name = "set_ups", .unit = "1", .count = solver_set_ups,
     .help = "preconditioners made"},
    {.name = "kept", .unit = "1", .count = solver_kept,
     .help = "solves of a matrix with new values for which the old preconditioner was kept"},
    {.name = "doubtful", .unit = "1", .count = solver_doubtful,
     .help = "solves whose true residual was above ten times the tolerance (`guards.residual`); of contacts: above the tolerance"},
    {.name = "residual", .unit = "1", .real = solver_residual, .print = "%.2g",
     .help = "true residual of the last solve, |b - A x| / |b|"},
    {.name = "residual_worst", .unit = "1", .real = solver_residual_worst, .print = "%.2g",
     .help = "the largest true residual of a solve"},
    {.name = "seconds_matrix", .unit = "s", .real = solver_seconds_matrix, .print = "%.3f",
     .help = "wall clock for handing over the matrix and its values; slowest rank"},
    {.name = "seconds_set_up", .unit = "s", .real = solver_seconds_set_up, .print = "%.3f",
     .help = "wall clock of the preconditioners made; slowest rank"},
    {.name = "seconds_solve", .unit = "s", .real = solver_seconds_solve, .print = "%.3f",
     .help = "wall clock of the solves, without that of preconditioners made; slowest rank"},
    {.name = "products", .unit = "1", .count = solver_products,
     .help = "products of the matrix with a vector for the true residuals"},
    {.name = "seconds_products", .unit = "s", .real = solver_seconds_products,
     .help = "wall clock of these products; slowest rank"},
    {0}};

/* clang-format on */
