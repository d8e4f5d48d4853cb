#include "observe/report.h"

#include "core/memory.h"
#include "core/version.h"
#include "observe/progress.h"

#include <inttypes.h>
#include <string.h>

void report_create(struct report *report, int ranks) {
    *report = (struct report){.ranks = ranks};
    report->ghosts = memory_allocate_zero((size_t)ranks, sizeof *report->ghosts, "report");
    report->messages = memory_allocate_zero((size_t)ranks, sizeof *report->messages, "report");
    report->bytes = memory_allocate_zero((size_t)ranks, sizeof *report->bytes, "report");
}

void report_destroy(struct report *report) {
    memory_free(report->ghosts);
    memory_free(report->messages);
    memory_free(report->bytes);
    *report = (struct report){0};
}

void report_gather(struct report *report, const struct comm *comm, const struct report_mine *mine) {
    double low[TIMER_STAGES], mean[TIMER_STAGES], high[TIMER_STAGES];
    for (int s = 0; s < TIMER_STAGES; s++)
        low[s] = mean[s] = high[s] = mine->timers->seconds[s];
    comm_min(comm, low, TIMER_STAGES);
    comm_sum(comm, mean, TIMER_STAGES);
    comm_max(comm, high, TIMER_STAGES);
    for (int s = 0; s < TIMER_STAGES; s++)
        report->stage[s] = (struct report_stage){.min = low[s], .mean = mean[s] / comm->size, .max = high[s]};
    double largest[3] = {mine->seconds, mine->seconds_setup, (double)memory_peak_resident()};
    comm_max(comm, largest, 3);
    report->seconds = largest[0];
    report->seconds_setup = largest[1];
    report->memory_peak = (uint64_t)largest[2];
    comm_gather_all(comm, &mine->ghosts, sizeof mine->ghosts, report->ghosts);
    comm_gather_all(comm, &mine->messages, sizeof mine->messages, report->messages);
    comm_gather_all(comm, &mine->bytes, sizeof mine->bytes, report->bytes);
    double most = mine->work, sums[3] = {mine->work, mine->waiting, 0};
    for (int s = 0; s < TIMER_STAGES; s++)
        sums[2] += s == TIMER_SETUP ? 0 : mine->timers->seconds[s];
    comm_max(comm, &most, 1);
    comm_sum(comm, sums, 3);
    report->imbalance = sums[0] > 0 ? most * comm->size / sums[0] : 1;
    report->sync_share = sums[2] > 0 ? sums[1] / sums[2] : 0;
}

double report_speed(const struct report *report) {
    double work = report->particle_steps;
    if (work <= 0)
        work = (double)report->steps * (double)report->particles;
    return report->seconds > 0 ? work / report->seconds : 0;
}

double report_pupcs(const struct report *report) {
    return report_speed(report) / (report->ranks * (report->threads > 0 ? report->threads : 1));
}

/* "1,234,567" */
static const char *grouped(uint64_t value, char text[32]) {
    char digits[24];
    int length = snprintf(digits, sizeof digits, "%" PRIu64, value), used = 0;
    for (int k = 0; k < length; k++) {
        if (k > 0 && (length - k) % 3 == 0)
            text[used++] = ',';
        text[used++] = digits[k];
    }
    text[used] = '\0';
    return text;
}

static void print_levels(const struct report *report, FILE *file) {
    if (report->levels == 0)
        return;
    if (report->choice[0])
        fprintf(file,
                "\n  index chosen: %s (choice %" PRIu64
                "); predicted %.4g ms a rebuild, measured %.4g ms\n  %s\n",
                report->choice, report->choices, 1e3 * report->choice_predicted,
                1e3 * report->choice_measured, report->choice_why);
    const char *unit = report->dimensionless ? "" : " [m]";
    char particles[32], cells[32];
    fprintf(file, "\n  %-5s %12s %14s %14s   %s%s\n", "level", "particles", "cells", "cell size", "radii",
            unit);
    for (int l = 0; l < report->levels; l++) {
        const struct report_level *level = &report->level[l];
        fprintf(file, "  %-5d %12s %14s %14.5g   %.5g ... %.5g\n", l, grouped(level->particles, particles),
                grouped(level->cells, cells), level->cell, level->radius_min, level->radius_max);
    }
}

static void print_stages(const struct report *report, FILE *file) {
    double total = 0;
    for (int s = 0; s < TIMER_STAGES; s++)
        total += s == TIMER_SETUP ? 0 : report->stage[s].mean;
    fprintf(file, "\n  %-10s %10s %10s %10s %7s\n", "seconds", "min", "mean", "max", "share");
    for (int s = 0; s < TIMER_STAGES; s++) {
        const struct report_stage *stage = &report->stage[s];
        if (stage->max <= 0)
            continue;
        fprintf(file, "  %-10s %10.3f %10.3f %10.3f", timer_stage_name((enum timer_stage)s), stage->min,
                stage->mean, stage->max);
        if (s == TIMER_SETUP || total <= 0)
            fprintf(file, " %7s\n", "");
        else
            fprintf(file, " %5.1f %%\n", 100 * stage->mean / total);
    }
}

static uint64_t sum(const uint64_t *value, int n) {
    uint64_t all = 0;
    for (int k = 0; k < n; k++)
        all += value[k];
    return all;
}

/* Means over ranks. */
static void print_ranks(const struct report *report, FILE *file) {
    double each = report->steps > 0 ? 1 / ((double)report->steps * report->ranks) : 0;
    char a[32];
    fprintf(
        file, "  %s ghosts; a rank and step sends %.1f messages, %.4g bytes; %.3g particle updates/core/s\n",
        grouped(sum(report->ghosts, report->ranks), a), (double)sum(report->messages, report->ranks) * each,
        (double)sum(report->bytes, report->ranks) * each, report_pupcs(report));
    fprintf(file, "  domain %s, imbalance %.3f, %.1f %% of the time for other ranks\n  sync %s\n",
            report->domain, report->imbalance, 100 * report->sync_share, report->sync);
    for (int c = 0; c < report->classes; c++)
        fprintf(file, "  class %d: %s ghosts, %.4g MB for them\n", c,
                grouped(report->size_class[c].ghosts, a), (double)report->size_class[c].bytes / 1e6);
}

/* With a note where more than a tenth of what was due found no place. */
static void print_insertions(const struct report *report, FILE *file) {
    char asked[32], placed[32];
    for (int k = 0; k < report->insertions; k++) {
        const struct report_insertion *row = &report->insertion[k];
        fprintf(file, "%s  insertion %s: %s of the %s particles due are placed%s\n", k ? "" : "\n", row->name,
                grouped(row->placed, placed), grouped(row->asked, asked),
                (double)row->placed < 0.9 * (double)row->asked
                    ? ": NOTE: its region is too full for the rest, or walls stand in it"
                    : "");
    }
}

void report_print(const struct report *report, FILE *file) {
    char a[32], b[32], duration[32];
    progress_duration(report->seconds, duration, sizeof duration);
    fprintf(file, "%s steps of %s particles in %.2f s (%s): %.4g particle-steps/s\n",
            grouped(report->steps, a), grouped(report->particles, b), report->seconds, duration,
            report_speed(report));
    if (report->stopped[0])
        fprintf(file, "  stopped early at step %" PRIu64 ": %s\n", report->step_last, report->stopped);
    fprintf(file, "  index %s, law %s, integrator %s, newton %s%s, %d rank%s x %d thread%s\n", report->index,
            report->law, report->integrator, report->newton ? "on" : "off",
            report->reproducible ? ", reproducible" : "", report->ranks, report->ranks == 1 ? "" : "s",
            report->threads, report->threads == 1 ? "" : "s");
    if (report->threads_working > 0 && report->threads_working < 0.95 * report->threads)
        fprintf(file, "  %.1f threads at work on average: other programs used the cores\n",
                report->threads_working);
    fprintf(file, "  %s pairs, %s contacts", grouped(report->pairs, a), grouped(report->contacts, b));
    fprintf(file, ", %s rebuilds\n", grouped(report->rebuilds, a));
    fprintf(file, "  %.0f bytes a particle, peak memory of a rank %.1f MB\n", report->bytes_per_particle,
            (double)report->memory_peak / 1e6);
    if (report->ranks > 1)
        print_ranks(report, file);
    print_levels(report, file);
    print_stages(report, file);
    char host[REPORT_NAME_MAX], cpu[2 * REPORT_NAME_MAX];
    version_host(host, sizeof host);
    version_cpu(cpu, sizeof cpu);
    fprintf(file, "\n  scree %s (%s), %s\n  %s\n  %s, %s\n", version_number(), version_revision(),
            version_compiler(), version_flags(), host, cpu);
    print_insertions(report, file);
}
