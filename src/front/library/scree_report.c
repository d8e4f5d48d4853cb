/* SPDX-License-Identifier: BSD-3-Clause */
/* The report of a simulation of the library, as text. Read scree_parts.h first. */
#include "front/library/scree_parts.h"
#include "base/memory.h"
#include "data/observe/report_json.h"
#include "engine/run_report.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void scree_report_begin(struct scree_simulation *simulation, double began) {
    simulation->since = timer_now();
    simulation->spent = 0;
    simulation->record.setup = simulation->since - began;
    run_report_begin(&simulation->state->timers, simulation->state->ranks.ghosts,
                     simulation->state->clock.step, &simulation->record);
}

/* Gives all ranks the text of rank 0, which it frees. */
static char *text_share(const struct comm *comm, char *text) {
    uint64_t size = text ? strlen(text) + 1 : 0;
    comm_broadcast(comm, &size, sizeof size);
    char *shared = memory_allocate_zero(size, 1, "report");
    if (text && size > 0)
        memcpy(shared, text, size);
    free(text);
    comm_broadcast(comm, shared, size);
    return shared;
}

static void text_make(struct scree_simulation *simulation, struct error *error) {
    const struct comm *comm = &simulation->comm;
    struct report report;
    char *text = NULL;
    size_t size;
    simulation->record.began = timer_now() - simulation->spent;
    run_report_make(simulation->state, &simulation->record, NULL, &report);
    FILE *file = comm->rank == 0 ? open_memstream(&text, &size) : NULL;
    if (file) {
        report_json(&report, file);
        fclose(file);
    }
    report_destroy(&report);
    if (comm->rank == 0 && text == NULL)
        error_set(error, ERROR_SYSTEM, "there is no memory for the text of the report");
    memory_free(simulation->report);
    simulation->report = text_share(comm, text);
    comm_agree(comm, error);
}

const char *scree_report(struct scree_simulation *simulation, struct scree_error *error) {
    struct error own = {0};
    if (scree_parts_free(simulation, &own)) {
        int threads = scree_parts_enter(simulation);
        text_make(simulation, &own);
        scree_parts_leave(simulation, threads);
    }
    return scree_parts_tell(&own, error) ? simulation->report : NULL;
}
