/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes a report, gathers the values of single ranks, and derives speeds. */
#include "observe/report.h"

#include "core/memory.h"

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
