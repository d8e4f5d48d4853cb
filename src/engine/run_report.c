/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of the report of a run, with their getters, and its lines on the terminal. Read run_report.h first. */
#include "engine/run_report.h"
#include "engine/run_report_source.h"
#include "engine/index_view.h"
#include "base/memory.h"
#include "base/version.h"
#include "data/observe/progress.h"
#include <math.h>
#include <stdio.h>

void run_report_begin(struct timers *timers, const struct ghosts *ghosts, uint64_t step,
                      struct run_record *run) {
    *run = (struct run_record){.first = step, .setup = run->setup, .start = *timers};
    ghosts_count(ghosts, &run->before);
    timer_clear(timers);
    run->began = timer_now();
}

void run_report_make(const struct simulation *s, const struct run_record *run, const struct run_chain *chain,
                     struct report *report) {
    struct report_source source = {.s = s,
                                   .run = run,
                                   .chain = chain,
                                   .seconds = timer_now() - run->began,
                                   .memory = memory_in_use(),
                                   .memory_most = memory_peak()};
    ghosts_count(s->ranks.ghosts, &source.ghosts);
    index_describe(s->search.index, &source.index);
    PHYSICS_EACH (active, &s->physics, shown) {
        if (active->row->shown->report)
            active->row->shown->report(&active->context, &source.part);
    }
    report_make(report, run_report_rows, s->comm, &source);
}

static double speed(const struct report_source *of, int k) {
    double steps = (double)(of->s->clock.step - of->run->first), work = of->run->particle_steps;
    double seconds = most(of, of->seconds);
    (void)k;
    if (work <= 0)
        work = steps * (double)of->s->total;
    return seconds > 0 ? work / seconds : 0;
}

static const char *duration(const struct report_source *of, int k, char *buffer, size_t room) {
    (void)k;
    progress_duration(most(of, of->seconds), buffer, room);
    return buffer;
}

/* The way that copies spread, and the reason. */
static const char *sync_why(const struct report_source *of, int k, char *buffer, size_t room) {
    static const char *const asked[] = {
        [GHOSTS_AUTO] = "auto: ", [GHOSTS_NEIGHBOURS] = "", [GHOSTS_SHADOW] = "shadow: "};
    const char *words = asked[of->s->scene->ghosts.sync];
    double reach = most(of, of->ghosts.reach), clearance = least(of, of->ghosts.clearance);
    (void)k;
    if (of->s->ranks.alone)
        snprintf(buffer, room, "%sone rank, no copies", words);
    else if (of->ghosts.rounds <= 1)
        snprintf(buffer, room,
                 "%sneighbours (no particle must be known beyond them: what is no neighbour is %.4g away)",
                 words, clearance);
    else
        snprintf(buffer, room,
                 "%sshadow (a particle must be known up to %.4g away; what is no neighbour begins at %.4g), "
                 "%d rounds",
                 words, reach, clearance, of->ghosts.rounds);
    return buffer;
}

static double imbalance(const struct report_source *of, int k) {
    double work = timer_sum(&of->s->timers, TIMER_WORK, 0), all = sum_all(of, work);
    (void)k;
    work = most(of, work);
    return all > 0 ? work * of->s->comm->size / all : 1;
}

static double sync_share(const struct report_source *of, int k) {
    double waiting = sum_all(of, timer_sum(&of->s->timers, TIMER_WAIT, 0));
    double all = sum_all(of, timer_sum(&of->s->timers, 0, TIMER_START));
    (void)k;
    return all > 0 ? waiting / all : 0;
}

static const char *stopped(const struct report_source *of, int k, char *buffer, size_t room) {
    (void)k;
    snprintf(buffer, room, "signal %d", of->run->stopped);
    return of->run->stopped ? buffer : "";
}

static const char *host(const struct report_source *of, int k, char *buffer, size_t room) {
    (void)of;
    (void)k;
    version_host(buffer, room);
    return buffer;
}

static const char *cpu(const struct report_source *of, int k, char *buffer, size_t room) {
    (void)of;
    (void)k;
    version_cpu(buffer, room);
    return buffer;
}

/* A mean over ranks and steps. */
static double mean_each(const struct report_source *of, uint64_t mine) {
    double steps = (double)(of->s->clock.step - of->run->first), all = (double)count_all(of, mine);
    return steps > 0 ? all / (steps * of->s->comm->size) : 0;
}

static double working(const struct report_source *of) {
    double mean = team_mean(&of->s->team);
    return mean > 0 ? mean : of->s->threads;
}

/* One getter a line, one row an entry, packed to the line: */
/* clang-format off */

COUNT(steps, of->s->clock.step - of->run->first)
COUNT(last_step, of->s->clock.step)
REAL(time_at_end, of->s->clock.time)
REAL(time_step, of->s->clock.dt)
COUNT(particles, of->s->total)
COUNT(ranks, of->s->comm->size)
COUNT(threads, of->s->threads)
REAL(threads_working, working(of))
FLAG(threads_disturbed, working(of) < 0.95 * of->s->threads)
TEXT(index_name, of->s->scene->index.name)
TEXT(law, of->part.law ? of->part.law : "")
TEXT(integrator, of->s->scene->integrator)
FLAG(newton, of->s->scene->ghosts.newton)
FLAG(reduced, of->s->scene->ghosts.reduced)
TEXT(simd, of->part.simd ? of->part.simd : "")
FLAG(reproducible, of->s->scene->reproducible)
REAL(seconds, most(of, of->seconds))
REAL(seconds_setup, most(of, of->run->setup))
REAL(seconds_rebuild, sum_all(of, timer_sum(&of->s->timers, TIMER_REBUILD, 0)) / of->s->comm->size)
COUNT(pairs, count_all(of, (uint64_t)pairlist_sides(of->s->search.list)) / 2)
COUNT(contacts, count_all(of, (uint64_t)physics_contact_sides(&of->s->physics)) / 2)
FLAG(skin_auto, of->s->scene->classes.skin_auto)
REAL(skin_factor, skin_choice_factor(of->s->search.choice.octaves))
COUNT(skin_changes, of->s->search.choice.changes)
COUNT(rebuilds, of->s->search.skin->rebuilds > 0 ? of->s->search.skin->rebuilds - 1 : 0) /* those of the set-up do not count */
COUNT(sorts, of->s->search.sorted > 0 ? of->s->search.sorted - 1 : 0)
COUNT(memory_counted, count_all(of, of->memory_most))
REAL(bytes_per_particle, of->s->total ? (double)memory_counted(of, k) / (double)of->s->total : 0)
COUNT(memory_resident, most(of, (double)memory_peak_resident()))
COUNT(memory_held, count_all(of, of->memory))
COUNT(inserted, of->s->sources.inserted)
COUNT(deleted, of->s->sources.deleted)
COUNT(seed, of->s->scene->seed)
COUNT(ghosts, of->ghosts.ghosts)
COUNT(ghosts_all, count_all(of, of->ghosts.ghosts))
COUNT(messages, of->ghosts.messages - of->run->before.messages)
REAL(messages_each, mean_each(of, messages(of, k)))
COUNT(bytes, of->ghosts.bytes - of->run->before.bytes)
REAL(bytes_each, mean_each(of, bytes(of, k)))
COUNT(rebuild_messages, count_all(of, of->ghosts.rebuild_messages - of->run->before.rebuild_messages))
COUNT(rebuild_bytes, count_all(of, of->ghosts.rebuild_bytes - of->run->before.rebuild_bytes))
REAL(pupcs, speed(of, k) / (of->s->comm->size * (of->s->threads > 0 ? of->s->threads : 1)))
TEXT(domain, domain_bisects(of->s->ranks.domain) ? "bisection" : "brick")
COUNT(divisions, of->s->ranks.load.divisions)
TEXT(version, version_number())
TEXT(revision, version_revision())
TEXT(compiler, version_compiler())
TEXT(flags, version_flags())
TEXT(unit_of_length, of->s->scene->units == SCENE_UNITS_NONE ? "" : " [m]")
FLAG(many_ranks, of->s->comm->size > 1)
FLAG(index_chosen, run_report_levels(of) > 0 && of->index.choice[0] != '\0')

const struct report_row run_report_rows[] = {
    {.name = "steps", .unit = "1", .count = steps,
     .help = "steps done by this program"},
    {.name = "last_step", .unit = "1", .count = last_step, .print = "%.0f",
     .help = "number of the last step of the run"},
    {.name = "time", .unit = "s", .real = time_at_end,
     .help = "simulated time at the end"},
    {.name = "dt", .unit = "s", .real = time_step,
     .help = "time step"},
    {.name = "particles", .unit = "1", .count = particles,
     .help = "number of particles at the end"},
    {.name = "ranks", .unit = "1", .count = ranks, .print = "rank|ranks",
     .help = "MPI ranks"},
    {.name = "threads", .unit = "1", .count = threads, .print = "thread|threads",
     .help = "threads of a rank"},
    {.name = "threads_working", .unit = "1", .real = threads_working, .print = "%.1f",
     .help = "threads that worked at a time, mean over the run (rank 0); fewer than `threads` if other programs used the cores"},
    {.name = "threads_disturbed", .unit = "", .flag = threads_disturbed, .terminal = true,
     .help = "whether clearly fewer threads worked than there are"},
    {.name = "index", .unit = "", .text = index_name,
     .help = "the index of the scene"},
    {.name = "law", .unit = "", .text = law,
     .help = "normal contact law, `hooke` or `hertz`"},
    {.name = "integrator", .unit = "", .text = integrator,
     .help = "the integrator"},
    {.name = "newton", .unit = "", .flag = newton, .print = "on|off",
     .help = "whether a pair that crosses ranks is computed on one rank only"},
    {.name = "reduced_ghosts", .unit = "", .flag = reduced,
     .help = "whether copies of small particles travel only as far as small partners"},
    {.name = "simd", .unit = "", .text = simd,
     .help = "instruction set of the force loop"},
    {.name = "reproducible", .unit = "", .flag = reproducible, .print = ", reproducible|",
     .help = "whether results are the same to the last bit on every layout"},
    {.name = "particle_steps_per_second", .unit = "1/s", .real = speed, .print = "%.4g",
     .help = "particles times steps, over `seconds`"},
    {.name = "seconds", .unit = "s", .real = seconds, .print = "%.2f",
     .help = "wall clock of the steps and of the output between steps, slowest rank; without set-up"},
    {.name = "duration", .unit = "", .text = duration, .terminal = true,
     .help = "the same as days, hours, minutes, seconds"},
    {.name = "seconds_setup", .unit = "s", .real = seconds_setup,
     .help = "wall clock before the first step, slowest rank"},
    {.name = "seconds_rebuild", .unit = "s", .real = seconds_rebuild, .terminal = true,
     .help = "wall clock of rebuilds, mean over ranks"},
    {.name = "pairs", .unit = "1", .count = pairs,
     .help = "pairs in the last pair list"},
    {.name = "contacts", .unit = "1", .count = contacts,
     .help = "number of contacts at the end, with walls"},
    {.name = "skin_auto", .unit = "", .flag = skin_auto, .terminal = true,
     .help = "whether the run chooses its skin"},
    {.name = "skin_factor", .unit = "1", .real = skin_factor, .print = "%.3g",
     .help = "factor on the skins of the scene at the end; 1 without `skin: auto`"},
    {.name = "skin_changes", .unit = "1", .count = skin_changes, .print = "%.0f",
     .help = "how often `skin: auto` changed the factor"},
    {.name = "rebuilds", .unit = "1", .count = rebuilds,
     .help = "number of rebuilds"},
    {.name = "sorts", .unit = "1", .count = sorts,
     .help = "number of rebuilds that sorted the particles into the order of the index; others left them as they lay"},
    {.name = "bytes_per_particle", .unit = "B", .real = bytes_per_particle, .print = "%.0f",
     .help = "largest memory of the arrays, all ranks together, over `particles`"},
    {.name = "memory_counted", .unit = "B", .count = memory_counted, .terminal = true,
     .help = "largest memory of the arrays, all ranks together"},
    {.name = "memory_peak", .unit = "B", .count = memory_resident, .print = "%.1f", .times = 1e-6,
     .help = "largest resident memory of a rank"},
    {.name = "memory_held", .unit = "B", .count = memory_held,
     .help = "memory of the arrays at the end, all ranks together"},
    {.name = "inserted", .unit = "1", .count = inserted,
     .help = "particles inserted since the start of the run; a body counts once"},
    {.name = "deleted", .unit = "1", .count = deleted,
     .help = "particles deleted since the start of the run; a body counts once"},
    {.name = "seed", .unit = "", .count = seed,
     .help = "seed of the scene"},
    {.name = "stopped", .unit = "", .text = stopped,
     .help = "`signal 15` or another signal if a signal ended the run; else empty"},
    {.name = "ghosts", .unit = "1", .each = ghosts,
     .help = "copies of other ranks' particles at the end, a number for each rank"},
    {.name = "ghosts_all", .unit = "1", .count = ghosts_all, .terminal = true,
     .help = "these copies, all ranks together"},
    {.name = "messages", .unit = "1", .each = messages,
     .help = "messages sent in the steps, a number for each rank"},
    {.name = "messages_each", .unit = "1", .real = messages_each, .print = "%.1f", .terminal = true,
     .help = "messages that a rank sends in a step, mean"},
    {.name = "bytes", .unit = "B", .each = bytes,
     .help = "bytes in these messages, a number for each rank"},
    {.name = "bytes_each", .unit = "B", .real = bytes_each, .print = "%.4g", .terminal = true,
     .help = "bytes that a rank sends in a step, mean"},
    {.name = "rebuild_messages", .unit = "1", .count = rebuild_messages,
     .help = "the messages at rebuilds among these messages; all ranks together"},
    {.name = "rebuild_bytes", .unit = "B", .count = rebuild_bytes,
     .help = "bytes in the messages at rebuilds"},
    {.name = "pupcs", .unit = "1/s", .real = pupcs, .print = "%.3g",
     .help = "particle updates per core and second: `particle_steps_per_second` over ranks times threads (Eibl and Rüde)"},
    {.name = "imbalance", .unit = "1", .real = imbalance, .print = "%.3f",
     .help = "largest over mean seconds of work of the ranks"},
    {.name = "sync_share", .unit = "1", .real = sync_share, .print = "%.1f", .times = 100,
     .help = "share of communication and waiting in all seconds"},
    {.name = "sync", .unit = "", .text = sync_why,
     .help = "the way by which copies spread, and the reason"},
    {.name = "domain", .unit = "", .text = domain,
     .help = "the division of the box among ranks, `brick` or `bisection`"},
    {.name = "divisions", .unit = "1", .count = divisions,
     .help = "number of later divisions of the box"},
    {.name = "version", .unit = "", .text = version,
     .help = "version of the program"},
    {.name = "git_revision", .unit = "", .text = revision,
     .help = "revision of the source of the program"},
    {.name = "compiler", .unit = "", .text = compiler,
     .help = "compiler of the program"},
    {.name = "flags", .unit = "", .text = flags,
     .help = "flags of the compiler"},
    {.name = "host", .unit = "", .text = host,
     .help = "machine of the first rank"},
    {.name = "cpu", .unit = "", .text = cpu,
     .help = "processor of this machine"},
    {.name = "unit_of_length", .unit = "", .text = unit_of_length, .terminal = true,
     .help = "behind the heading of radii"},
    {.name = "many_ranks", .unit = "", .flag = many_ranks, .terminal = true,
     .help = "whether there are several ranks"},
    {.name = "index_chosen", .unit = "", .flag = index_chosen, .terminal = true,
     .help = "whether the index has chosen one with levels"},
    {.name = "index_choice", .unit = "", .shape = REPORT_GROUP, .entries = run_report_choices, .optional = true, .rows = run_report_choice_rows,
     .help = "the choice of an index that chooses (`auto`); absent for other indexes"},
    {.name = "levels", .unit = "", .shape = REPORT_LIST, .entries = run_report_levels, .rows = run_report_level_rows,
     .help = "grids of the index, from small to large; empty without grids"},
    {.name = "classes", .unit = "", .shape = REPORT_LIST, .entries = run_report_classes, .rows = run_report_class_rows,
     .help = "size classes, from small to large"},
    {.name = "insertions", .unit = "", .shape = REPORT_LIST, .entries = run_report_insertions, .rows = run_report_insertion_rows,
     .help = "regions of the scene's `insertions`, in the order of the scene"},
    {.name = "scene_stages", .unit = "", .shape = REPORT_LIST, .entries = run_report_scene_stages, .optional = true, .rows = run_report_scene_stage_rows,
     .help = "stages of the scene's `stages` that this program has run; absent without. All other entries are of the last of them"},
    {.name = "stages", .unit = "s", .shape = REPORT_STAGES, .entries = run_report_stages, .rows = run_report_stage_rows,
     .help = "wall clock of each stage, exclusive of the others: `min`, `mean` and `max` over ranks"},
    {.name = "setup_stages", .unit = "s", .shape = REPORT_STAGES, .entries = run_report_stages, .rows = run_report_setup_rows,
     .help = "the same of the time before the first step, stage by stage"},
    {.name = "solvers", .unit = "", .shape = REPORT_LIST, .entries = run_report_solvers, .optional = true, .rows = run_report_solver_rows,
     .help = "linear solvers of a fluid, and the solver of contacts; absent without these"},
    {.name = "solved_contacts", .unit = "", .shape = REPORT_LIST, .entries = run_report_contacts, .optional = true, .rows = run_report_contacts_rows,
     .help = "what contact.solver has seen since this program began, one entry; absent without it"},
    {0}};

/* clang-format on */

const struct report_line run_report_lines[] = {
    {.text = "{steps} steps of {particles} particles in {seconds} s ({duration}): "
             "{particle_steps_per_second} particle-steps/s\n"},
    {.text = "  stopped early at step {last_step}: {stopped}\n", .when = "stopped"},
    {.text = "  index {index}, law {law}, integrator {integrator}, newton {newton}{reproducible}, {ranks} x "
             "{threads}\n"},
    {.text = "  {threads_working} threads at work on average: other programs used the cores\n",
     .when = "threads_disturbed"},
    {.text = "  {pairs} pairs, {contacts} contacts, {rebuilds} rebuilds\n"},
    {.text = "  skin: {skin_factor} times that of the scene, {skin_changes} changes\n", .when = "skin_auto"},
    {.text = "  {bytes_per_particle} bytes a particle, peak memory of a rank {memory_peak} MB\n"},
    {.text = "  {ghosts_all} ghosts; a rank and step sends {messages_each} messages, {bytes_each} bytes; "
             "{pupcs} particle updates/core/s\n"
             "  domain {domain}, imbalance {imbalance}, {sync_share} % of the time for other ranks\n"
             "  sync {sync}\n",
     .when = "many_ranks"},
    {.text = "  class {#}: {ghosts} ghosts, {bytes} MB for them\n", .list = "classes", .when = "many_ranks"},
    {.text = "\n  index chosen: {index_choice.index} (choice {index_choice.choices}); predicted "
             "{index_choice.predicted_seconds} ms a rebuild, measured {index_choice.measured_seconds} ms\n"
             "  {index_choice.why}\n",
     .when = "index_chosen"},
    {.text = "  {#:-5} {particles:12} {cells:14} {cell_size:14}   {radius_min} ... {radius_max}\n",
     .list = "levels",
     .heading = "\n  level    particles          cells      cell size   radii{unit_of_length}\n"},
    {.text = "  {name:-10} {min:10} {mean:10} {max:10} {share:7}\n",
     .list = "stages",
     .only = "max",
     .heading = "\n  seconds           min       mean        max   share\n"},
    {.text = "  {name:-10} {solves:8} {iterations:10} {set_ups:8} {kept:6} {doubtful:8} {residual_worst:9}\n",
     .list = "solvers",
     .heading = "\n  solver       solves iterations  set-ups   kept doubtful  residual\n"},
    {.text = "  contacts     overlap up to {overlap_max} of the smaller radius, approach up to "
             "{approach_max} g dt; news at {news}, grains up "
             "to {fastest}\n",
     .list = "solved_contacts"},
    {.text = "\n  scree {version} ({git_revision}), {compiler}\n  {flags}\n  {host}, {cpu}\n"},
    {.text = "  insertion {name}: {placed} of the {asked} particles due are placed{note}\n",
     .list = "insertions",
     .heading = "\n"},
    {.text =
         "  stage {name:-12} steps {first:12} ... {last:12}   t = {time:-10} {seconds:8} s, ended by {end}\n",
     .list = "scene_stages",
     .heading = "\n"},
    {0}};
