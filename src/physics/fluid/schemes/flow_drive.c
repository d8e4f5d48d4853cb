/* SPDX-License-Identifier: BSD-3-Clause */
/* The force that drives a flow. Read flow_drive.h first. */
#include "physics/fluid/schemes/flow_drive.h"
#include "physics/grains/grains.h"

#include <math.h>

static bool has_flow(const struct fluid_options *options) {
    return !isnan(options->drive.mass_flow);
}

/* Reads the table: times that increase, and factors. */
static bool table_read(const struct fluid_drive *drive, struct numbers *table, struct error *error) {
    if (!drive->table[0])
        return true;
    if (!numbers_read(table, drive->table, 2, error) ||
        !numbers_check_times(table, drive->table, "t factor", error))
        return false;
    return !drive->repeat || table->rows > 1 ||
           error_set(error, ERROR_USER, "%s: a table that repeats needs two or more rows of t factor",
                     drive->table);
}

/* True if the table goes with the other keys, and is one. */
static bool table_suits(const struct physics_context *context, bool force, bool drop, struct error *error) {
    const struct fluid_options *options = context->options;
    struct numbers table = {0};
    if (!options->drive.table[0])
        return true;
    if (!force && !drop)
        return scene_fail(context->scene, error, "fluid.drive.table",
                          "is a factor of body_force or pressure_drop; needed: one of them");
    if (options->time == FLUID_STEADY)
        return scene_fail(context->scene, error, "fluid.drive.table",
                          "a steady flow does not change; allowed: fluid.time: transient");
    bool good = table_read(&options->drive, &table, error);
    numbers_free(&table);
    return good;
}

bool flow_drive_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    const struct fluid_drive *drive = &options->drive;
    bool force = drive->body_force[0] != 0 || drive->body_force[1] != 0 || drive->body_force[2] != 0;
    bool drop = !isnan(drive->pressure_drop), flow = has_flow(options);
    const char *key = flow ? "fluid.drive.mass_flow" : "fluid.drive.pressure_drop";
    if (force + drop + flow > 1)
        return scene_fail(context->scene, error, key,
                          "body_force, pressure_drop and mass_flow exclude each other; allowed: one of them");
    if ((drop || flow) && (drive->axis >= context->box->dimension || !context->box->periodic[drive->axis]))
        return scene_fail(context->scene, error, key, "the box must be periodic along fluid.drive.axis (%c)",
                          'x' + drive->axis);
    if (flow && options->time == FLUID_STEADY && grains_walls(context) != NULL &&
        walls_move(grains_walls(context)))
        return scene_fail(context->scene, error, key, "a steady flow with a mass_flow needs walls at rest");
    return table_suits(context, force, drop, error);
}

double flow_drive_factor(const struct numbers *table, bool repeat, double time) {
    double factor = 1;
    if (table->rows == 0)
        return factor;
    double first = table->value[0], period = table->value[2 * table->rows - 2] - first;
    if (repeat)
        time -= period * floor((time - first) / period);
    numbers_at(table, time, &factor);
    return factor;
}

/* The force that the scene gives, at a time. */
static void force_at(struct drive *drive, const struct fluid_options *options, const struct box *box,
                     double time) {
    double factor = flow_drive_factor(&drive->table, options->drive.repeat, time);
    for (int d = 0; d < 3; d++)
        drive->force[d] = factor * options->drive.body_force[d];
    if (!isnan(options->drive.pressure_drop))
        drive->force[options->drive.axis] =
            factor * options->drive.pressure_drop / box->edge[options->drive.axis];
}

struct drive flow_drive_begin(const struct fluid_options *options, const struct box *box,
                              struct error *error) {
    struct drive drive = {0};
    if (table_read(&options->drive, &drive.table, error))
        force_at(&drive, options, box, 0);
    if (has_flow(options) && options->time == FLUID_STEADY)
        drive.force[options->drive.axis] = options->viscosity / (options->spacing * options->spacing);
    return drive;
}

void flow_drive_restart(struct drive *drive, const struct fluid_options *options, struct restart *list) {
    if (!has_flow(options) && !options->drive.table[0] && options->time != FLUID_STEADY)
        return;
    for (int d = 0; d < 3; d++)
        restart_add(list, RESTART_REAL, true, &drive->force[d], "fluid: driving force %c", 'x' + d);
    restart_add(list, RESTART_REAL, true, &drive->mean_before, "fluid: mean velocity before");
    restart_add(list, RESTART_INTEGER, true, &drive->steps, "fluid: steps of the drive");
}

void flow_drive_free(struct drive *drive) {
    numbers_free(&drive->table);
}

/* The mean velocity of the fluid along the axis, and the one that gives the mass flow. */
static void compare(const struct fluid_options *options, const struct box *box, const struct flow *flow,
                    double *mean, double *goal) {
    double velocity[3], volume;
    flow_mean(flow, flow_velocity(flow), velocity, &volume);
    *mean = velocity[options->drive.axis];
    *goal = options->drive.mass_flow * box->edge[options->drive.axis] / (options->density * volume);
}

void flow_drive_adjust(struct drive *drive, const struct fluid_options *options, const struct box *box,
                       const struct flow *flow, double time, double dt) {
    double mean, goal, *force = &drive->force[options->drive.axis];
    if (drive->table.rows > 0)
        force_at(drive, options, box, time);
    if (!has_flow(options))
        return;
    compare(options, box, flow, &mean, &goal);
    if (drive->steps > 0)
        *force -= options->density * (mean - drive->mean_before) / dt;
    *force += 0.5 * options->density * (goal - mean) / dt;
    drive->mean_before = mean;
    drive->steps++;
}

bool flow_drive_scale(struct drive *drive, const struct fluid_options *options, const struct box *box,
                      const struct flow *flow, struct error *error) {
    const struct weights *weights = flow->weights;
    double mean, goal;
    if (!has_flow(options))
        return true;
    compare(options, box, flow, &mean, &goal);
    if (mean == 0)
        return error_set(error, ERROR_PHYSICS, "fluid.drive.mass_flow: no fluid flows along the axis");
    double factor = goal / mean;
    for (int d = 0; d < 3; d++)
        drive->force[d] *= factor;
    for (size_t row = 0; row < weights->rows; row++) {
        for (int d = 0; d < 3; d++)
            flow_velocity_of(flow, row)[d] *= factor;
        flow->pressure[weights->first + row] *= factor;
    }
    flow_forward(flow, FLOW_VELOCITY);
    flow_forward(flow, FLOW_PRESSURE);
    return true;
}
