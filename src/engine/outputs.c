/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes into the files of a run when they are due. Read outputs.h first. */
#include "engine/outputs_parts.h"
#include "engine/index_view.h"
#include "data/formats/contact_list.h"
#include "data/formats/frame.h"
#include <stdio.h>
#include <string.h>

bool outputs_want_sums(const struct outputs *o, const struct clock *clock, uint64_t step) {
    double time = clock_time(clock, step);
    return o->observables && observables_need_sums(o->observables) &&
           output_interval_due(&o->options->observables.every, step, time, clock->dt);
}

bool outputs_sum_each_step(const struct outputs *o) {
    return o->observables && observables_need_work(o->observables);
}

static bool row_write(struct outputs *o, const struct output_view *view, struct error *error) {
    if (!observables_write(o->observables, view, error))
        return false;
    o->row_written = true;
    if (o->h5md) {
        struct h5md_observables row;
        observables_row(o->observables, view, &row);
        h5md_add_observables(o->h5md, &row);
    }
    return true;
}

void outputs_last_values(const void *outputs, char *text, size_t room) {
    enum { SHOWN = 3 };
    const struct outputs *o = outputs;
    size_t used = 0;
    text[0] = '\0';
    if (o == NULL || !o->row_written)
        return;
    int columns = observables_columns(o->observables);
    for (int c = 0; c < columns && c < SHOWN && used < room; c++) {
        const char *unit = observables_column_unit(o->observables, c);
        unit = strcmp(unit, "1") == 0 ? "" : unit;
        used += (size_t)snprintf(text + used, room - used, ", %s %.4g%s%s",
                                 observables_column_name(o->observables, c),
                                 observables_values(o->observables)[c], unit[0] ? " " : "", unit);
    }
}

static bool frame_write(struct outputs *o, const struct output_view *view, bool trajectory,
                        struct error *error) {
    struct frame frame;
    frame_create(&frame, view, trajectory ? &o->options->trajectory.fields : &o->options->dump.fields);
    bool good = trajectory ? h5md_write_frame(o->h5md, &frame, error) : dump_write(o->dump, &frame, error);
    frame_free(&frame);
    return good;
}

static bool contacts_write(struct outputs *o, const struct output_view *view, struct error *error) {
    struct contact_list list;
    contact_list_create(&list, view);
    bool good = h5md_write_contacts(o->h5md, &list, view->box, error);
    contact_list_free(&list);
    return good;
}

const struct output_interval *outputs_grid_every(const struct output_options *options, int grid) {
    const struct output_interval *own = &options->observables.grid[grid].every;
    return output_interval_set(own) ? own : &options->observables.every;
}

static bool interval_due(const struct output_interval *every, const struct clock *clock, uint64_t step) {
    double time = clock_time(clock, step);
    return output_interval_due(every, step, step == clock->step ? clock->time : time, clock->dt);
}

static bool grid_due(const struct outputs *o, const struct clock *clock, uint64_t step, int k) {
    return interval_due(outputs_grid_every(o->options, k), clock, step);
}

bool outputs_due(const struct outputs *o, const struct clock *clock, uint64_t step) {
    const struct output_interval *every[] = {
        &o->options->observables.every, &o->options->trajectory.every, &o->options->trajectory.contacts,
        &o->options->dump.every,        &o->options->walls.every,      &o->options->contact_problems.every};
    for (size_t k = 0; k < sizeof every / sizeof every[0]; k++)
        if (interval_due(every[k], clock, step))
            return true;
    for (int k = 0; k < o->options->observables.grids; k++)
        if (grid_due(o, clock, step, k))
            return true;
    return false;
}

bool outputs_write(struct outputs *o, const struct output_view *view, const struct physics_set *set,
                   const struct clock *clock, struct error *error) {
    const struct output_options *options = o->options;
    bool good = true;
    if (o->observables &&
        output_interval_due(&options->observables.every, clock->step, clock->time, clock->dt))
        good = row_write(o, view, error);
    if (good && o->h5md &&
        output_interval_due(&options->trajectory.every, clock->step, clock->time, clock->dt))
        good = frame_write(o, view, true, error);
    if (good && o->h5md &&
        output_interval_due(&options->trajectory.contacts, clock->step, clock->time, clock->dt))
        good = contacts_write(o, view, error);
    if (good && o->dump && output_interval_due(&options->dump.every, clock->step, clock->time, clock->dt))
        good = frame_write(o, view, false, error);
    if (good && o->walls && output_interval_due(&options->walls.every, clock->step, clock->time, clock->dt))
        good = wall_frames_write(o->walls, view, error);
    for (int k = 0; good && k < options->observables.grids; k++)
        if (grid_due(o, clock, clock->step, k))
            good = observables_grid_write(o->grid[k], view, error);
    return good && (!outputs_due(o, clock, clock->step) || outputs_tables(set, view->comm, error));
}

bool outputs_tables(const struct physics_set *set, const struct comm *comm, struct error *error) {
    bool has = false;
    PHYSICS_EACH (active, set, table) {
        has = true;
        active->row->table->write(&active->context, error);
    }
    return !has || comm_agree(comm, error);
}

bool outputs_flush(struct outputs *o, const struct physics_set *set, const struct comm *comm,
                   struct error *error) {
    return outputs_tables(set, comm, error) && (o->h5md == NULL || h5md_flush(o->h5md, error));
}
