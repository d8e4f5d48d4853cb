/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of broken bonds, bonds_broken.csv: rank 0 writes the rows of all ranks, in the order of steps and
 * ids. */
#include "physics/bonds/bonds_state.h"
#include "base/memory.h"
#include "base/lines.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const names[BOND_ENDS] = {
    [BOND_TENSION] = "tension", [BOND_SHEARED] = "shear", [BOND_LOST] = "lost"};

static const char header[] = "step,time,id_a,id_b,mode,x,y,z,tensile_stress,shear_stress\n";

void bonds_events_add(struct bonds_events *events, const struct bonds_event *event) {
    if (events->count == events->capacity) {
        events->capacity = 2 * events->capacity + 64;
        events->event = memory_resize(events->event, events->capacity, sizeof *events->event, "broken bonds");
    }
    events->event[events->count++] = *event;
}

/* Cuts a table of an earlier run behind its last row up to a step. */
static bool cut(const char *path, int64_t step, struct error *error) {
    struct lines lines;
    int64_t end = 0;
    if (!lines_open(&lines, path, error))
        return false;
    while (lines_next(&lines) && lines.whole) {
        char *after;
        long long row = strtoll(lines.text, &after, 10);
        if (lines.number > 1 && (*after != ',' || row > step))
            break;
        end = lines_place(&lines);
    }
    lines_close(&lines);
    return truncate(path, end) == 0 || error_set_errno(error, "%s: cannot be cut to go on with it", path);
}

bool bonds_table_open(const struct physics_context *context, const char *directory, int64_t step,
                      struct error *error) {
    struct bonds *bonds = context->self;
    if (!file_join(bonds->path, directory, "bonds_broken.csv", error))
        return false;
    if (context->comm->rank > 0)
        return true;
    bool go_on = step >= 0 && file_size(bonds->path) > 0;
    if (go_on && !cut(bonds->path, step, error))
        return false;
    bonds->file = fopen(bonds->path, go_on ? "a" : "w");
    if (bonds->file == NULL)
        return error_set_errno(error, "%s: cannot be written", bonds->path);
    if (file_size(bonds->path) == 0)
        fputs(header, bonds->file);
    return fflush(bonds->file) == 0 || error_set_errno(error, "%s: cannot be written", bonds->path);
}

static int event_order(const void *a, const void *b) {
    const struct bonds_event *x = a, *y = b;
    if (x->step != y->step)
        return x->step < y->step ? -1 : 1;
    for (int k = 0; k < 2; k++)
        if (x->id[k] != y->id[k])
            return x->id[k] < y->id[k] ? -1 : 1;
    return 0;
}

bool bonds_table_write(const struct physics_context *context, struct error *error) {
    struct bonds *bonds = context->self;
    struct bonds_event *event = NULL;
    if (bonds->path[0] == '\0')
        return true;
    size_t count = comm_gather_varying(context->comm, bonds->events.event,
                                       bonds->events.count * sizeof *event, (void **)&event, NULL) /
                   sizeof *event;
    bonds->events.count = 0;
    if (bonds->file == NULL) {
        memory_free(event);
        return true;
    }
    if (count > 0)
        qsort(event, count, sizeof *event, event_order);
    for (size_t k = 0; k < count; k++) {
        const double *origin = context->box->origin, *x = event[k].x;
        if (k > 0 && event_order(&event[k - 1], &event[k]) == 0) /* both ends have lost each other */
            continue;
        fprintf(bonds->file, "%llu,%.15g,%lld,%lld,%s,%.15g,%.15g,%.15g,%.15g,%.15g\n",
                (unsigned long long)event[k].step, event[k].time, (long long)event[k].id[0],
                (long long)event[k].id[1], names[event[k].end], x[0] + origin[0], x[1] + origin[1],
                x[2] + origin[2], event[k].tensile, event[k].shear);
    }
    memory_free(event);
    return (fflush(bonds->file) == 0 && !ferror(bonds->file)) ||
           error_set_errno(error, "%s: a row cannot be written", bonds->path);
}
