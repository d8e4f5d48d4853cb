/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes a report, gathers the values of single ranks, and derives speeds. */
#include "data/observe/report.h"

#include "base/memory.h"
#include <stdio.h>

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
    memory_free(report->insertion);
    *report = (struct report){0};
}

/* All ranks have the same stages. */
static void stages_gather(struct report_stage *into, const struct comm *comm, const struct timers *timers) {
    double low[TIMER_STAGES_MAX], mean[TIMER_STAGES_MAX], high[TIMER_STAGES_MAX];
    int stages = timers->stages;
    for (int s = 0; s < stages; s++)
        low[s] = mean[s] = high[s] = timers->stage[s].seconds;
    comm_min(comm, low, stages);
    comm_sum(comm, mean, stages);
    comm_max(comm, high, stages);
    for (int s = 0; s < stages; s++) {
        struct report_stage *stage = &into[s];
        *stage = (struct report_stage){
            .use = timers->stage[s].use, .min = low[s], .mean = mean[s] / comm->size, .max = high[s]};
        snprintf(stage->name, sizeof stage->name, "%s", timers->stage[s].name);
    }
}

double report_stages(const struct report *report, unsigned with, unsigned without) {
    double seconds = 0;
    for (int s = 0; s < report->stages; s++)
        if ((report->stage[s].use & with) == with && (report->stage[s].use & without) == 0)
            seconds += report->stage[s].mean;
    return seconds;
}

void report_gather(struct report *report, const struct comm *comm, const struct report_mine *mine) {
    report->stages = mine->timers->stages;
    stages_gather(report->stage, comm, mine->timers);
    stages_gather(report->setup_stage, comm, mine->timers_setup);
    double largest[3] = {mine->seconds, mine->seconds_setup, (double)memory_peak_resident()};
    comm_max(comm, largest, 3);
    report->seconds = largest[0];
    report->seconds_setup = largest[1];
    report->memory_peak = (uint64_t)largest[2];
    comm_gather_all(comm, &mine->ghosts, sizeof mine->ghosts, report->ghosts);
    comm_gather_all(comm, &mine->messages, sizeof mine->messages, report->messages);
    comm_gather_all(comm, &mine->bytes, sizeof mine->bytes, report->bytes);
    double most = mine->work, sums[3] = {mine->work, mine->waiting, timer_sum(mine->timers, 0, TIMER_START)};
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
