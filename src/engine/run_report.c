/* SPDX-License-Identifier: BSD-3-Clause */
/* Fills the report of a run (data/observe/report.h) from the simulation. Read run_report.h first. */
#include "engine/run_report.h"
#include "engine/tune.h"
#include "engine/sources.h"
#include "engine/load_balance.h"
#include "engine/index_view.h"
#include "base/memory.h"
#include <math.h>
#include <stdio.h>

/* The level table and the choice of the index. Each rank chooses by itself, so ranks may differ in both. The
 * table has as many levels as the rank with most levels; the counts are sums, the bounds and cells are the
 * widest, and the words of a choice are those of rank 0. */
static void report_levels(const struct simulation *s, struct report *report) {
    struct index_description description;
    int64_t counts[REPORT_LEVELS_MAX][2] = {0}, levels;
    double widest[REPORT_LEVELS_MAX][3]; /* cell, largest radius, minus the smallest */
    index_describe(s->search.index, &description);
    int mine = description.levels < REPORT_LEVELS_MAX ? description.levels : REPORT_LEVELS_MAX;
    for (int l = 0; l < REPORT_LEVELS_MAX; l++) {
        const struct index_level *level = &description.level[l];
        widest[l][0] = widest[l][1] = widest[l][2] = -INFINITY;
        if (l >= mine)
            continue;
        counts[l][0] = (int64_t)level->cells;
        counts[l][1] = (int64_t)level->particles;
        widest[l][0] = level->cell;
        widest[l][1] = level->radius_max;
        widest[l][2] = -level->radius_min;
    }
    levels = mine;
    comm_max_int(s->comm, &levels, 1);
    comm_sum_int(s->comm, counts[0], 2 * (int)levels);
    comm_max(s->comm, widest[0], 3 * (int)levels);
    report->levels = (int)levels;
    for (int l = 0; l < report->levels; l++)
        report->level[l] = (struct report_level){.cell = widest[l][0],
                                                 .cells = (uint64_t)counts[l][0],
                                                 .particles = (uint64_t)counts[l][1],
                                                 .radius_min = -widest[l][2],
                                                 .radius_max = widest[l][1]};
    snprintf(report->choice, sizeof report->choice, "%s", description.choice);
    snprintf(report->choice_why, sizeof report->choice_why, "%s", description.why);
    report->choices = description.choices;
    double seconds[2] = {description.predicted, tune_measured(s)};
    comm_max(s->comm, seconds, 2);
    report->choice_predicted = seconds[0];
    report->choice_measured = seconds[1];
}

/* Reports the way that copies spread, and the reason. */
static void report_sync(const struct simulation *s, const struct ghosts_counts *ghosts,
                        struct report *report) {
    static const char *const asked[] = {
        [GHOSTS_AUTO] = "auto: ", [GHOSTS_NEIGHBOURS] = "", [GHOSTS_SHADOW] = "shadow: "};
    double farthest[2] = {ghosts->reach, -ghosts->clearance};
    comm_max(s->comm, farthest, 2);
    const char *words = asked[s->scene->ghosts.sync];
    if (s->ranks.alone)
        snprintf(report->sync, sizeof report->sync, "%sone rank, no copies", words);
    else if (ghosts->rounds <= 1)
        snprintf(report->sync, sizeof report->sync,
                 "%sneighbours (no particle must be known beyond them: what is no neighbour is %.4g away)",
                 words, -farthest[1]);
    else
        snprintf(report->sync, sizeof report->sync,
                 "%sshadow (a particle must be known up to %.4g away; what is no neighbour begins at %.4g), "
                 "%d rounds",
                 words, farthest[0], -farthest[1], ghosts->rounds);
}

static void report_classes(const struct simulation *s, const struct ghosts_counts *ghosts,
                           struct report *report) {
    int64_t sums[2 * CLASS_MAX];
    report->classes = s->classes.count;
    for (int c = 0; c < CLASS_MAX; c++) {
        sums[c] = (int64_t)ghosts->ghosts_class[c];
        sums[CLASS_MAX + c] = (int64_t)ghosts->bytes_class[c];
    }
    comm_sum_int(s->comm, sums, 2 * CLASS_MAX);
    for (int c = 0; c < report->classes; c++)
        report->size_class[c] = (struct report_class){.radius_min = s->classes.radius_min[c],
                                                      .radius_max = s->classes.radius_max[c],
                                                      .particles = s->classes.population[c],
                                                      .skin = s->classes.skin[c][c],
                                                      .ghosts = (uint64_t)sums[c],
                                                      .bytes = (uint64_t)sums[CLASS_MAX + c]};
}

static void report_insertions(const struct simulation *s, struct report *report) {
    report->insertions = s->scene->insertions;
    report->insertion = memory_allocate_zero((size_t)report->insertions, sizeof *report->insertion, "report");
    for (int k = 0; k < report->insertions; k++) {
        const char *name = s->scene->insertion[k].name;
        struct report_insertion *row = &report->insertion[k];
        if (name[0])
            snprintf(row->name, sizeof row->name, "%s", name);
        else
            snprintf(row->name, sizeof row->name, "insertions[%d]", k);
        row->asked = sources_asked(s, k);
        row->placed = s->sources.state[k].placed;
        row->lost = s->sources.lost[k];
    }
}

/* Those of the set-up do not count. */
static void report_rebuilds(const struct simulation *s, struct report *report) {
    report->rebuilds = s->search.skin->rebuilds > 0 ? s->search.skin->rebuilds - 1 : 0;
    report->sorts = s->search.sorted > 0 ? s->search.sorted - 1 : 0;
}

static void report_physics(const struct simulation *s, struct report *report) {
    report->solvers = 0;
    PHYSICS_EACH (active, &s->physics, shown) {
        if (active->row->shown->report)
            active->row->shown->report(&active->context, report);
    }
}

void run_report_fill(const struct simulation *s, const struct run_record *run, struct report *report) {
    struct ghosts_counts ghosts;
    ghosts_count(s->ranks.ghosts, &ghosts);
    int64_t sums[6] = {pairlist_sides(s->search.list),
                       simulation_contact_sides(s),
                       (int64_t)memory_peak(),
                       (int64_t)memory_in_use(),
                       (int64_t)(ghosts.rebuild_messages - run->before.rebuild_messages),
                       (int64_t)(ghosts.rebuild_bytes - run->before.rebuild_bytes)};
    comm_sum_int(s->comm, sums, 6);
    report->steps = s->clock.step - run->first;
    report->particle_steps = run->particle_steps;
    report->step_last = s->clock.step;
    report->time = s->clock.time;
    report->dt = s->clock.dt;
    report->particles = s->total;
    report->ranks = s->comm->size;
    report->threads = s->threads;
    report->threads_working = team_mean(&s->team);
    report->newton = s->scene->ghosts.newton;
    report->reduced = s->scene->ghosts.reduced;
    report->reproducible = s->scene->reproducible;
    snprintf(report->index, sizeof report->index, "%s", s->scene->index.name);
    snprintf(report->integrator, sizeof report->integrator, "%s", s->scene->integrator);
    report_levels(s, report);
    report_rebuilds(s, report);
    report_sync(s, &ghosts, report);
    report_classes(s, &ghosts, report);
    report_insertions(s, report);
    snprintf(report->domain, sizeof report->domain, "%s",
             domain_bisects(s->ranks.domain) ? "bisection" : "brick");
    report->divisions = s->ranks.load.divisions;
    report->pairs = (uint64_t)sums[0] / 2;
    report->contacts = (uint64_t)sums[1] / 2;
    report->bytes_per_particle = s->total ? (double)sums[2] / (double)s->total : 0;
    report->memory_held = (uint64_t)sums[3];
    report->rebuild_messages = (uint64_t)sums[4];
    report->rebuild_bytes = (uint64_t)sums[5];
    report->inserted = s->sources.inserted;
    report->deleted = s->sources.deleted;
    report->skin_factor = skin_choice_factor(s->search.choice.octaves);
    report->skin_changes = s->search.choice.changes;
    report->skin_auto = s->scene->classes.skin_auto;
    report->seed = s->scene->seed;
    report->dimensionless = s->scene->units == SCENE_UNITS_NONE;
    if (run->stopped)
        snprintf(report->stopped, sizeof report->stopped, "signal %d", run->stopped);
    report_physics(s, report);
    struct report_mine mine = {.timers = &s->timers,
                               .timers_setup = &run->start,
                               .ghosts = ghosts.ghosts,
                               .messages = ghosts.messages - run->before.messages,
                               .bytes = ghosts.bytes - run->before.bytes,
                               .work = timer_sum(&s->timers, TIMER_WORK, 0),
                               .waiting = timer_sum(&s->timers, TIMER_WAIT, 0),
                               .seconds = timer_now() - run->began,
                               .seconds_setup = run->setup};
    report_gather(report, s->comm, &mine);
}
