/* SPDX-License-Identifier: BSD-3-Clause */
/* The force that drives a flow. Read drive.h first. */
#include "fluid/drive.h"
#include "grains/grains.h"

#include <math.h>

static bool has_flow(const struct fluid_options *options) {
    return !isnan(options->drive.mass_flow);
}

bool drive_suits(const struct physics_context *context, struct error *error) {
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
    return true;
}

struct drive drive_begin(const struct fluid_options *options, const struct box *box) {
    struct drive drive = {
        .force = {options->drive.body_force[0], options->drive.body_force[1], options->drive.body_force[2]}};
    int axis = options->drive.axis;
    if (!isnan(options->drive.pressure_drop))
        drive.force[axis] = options->drive.pressure_drop / box->edge[axis];
    else if (has_flow(options) && options->time == FLUID_STEADY)
        drive.force[axis] = options->viscosity / (options->spacing * options->spacing);
    return drive;
}

/* The mean velocity of the fluid along the axis, and the one that gives the mass flow. */
static void compare(const struct fluid_options *options, const struct box *box, const struct flow *flow,
                    double *mean, double *goal) {
    double velocity[3], volume;
    flow_mean(flow, flow_velocity(flow), velocity, &volume);
    *mean = velocity[options->drive.axis];
    *goal = options->drive.mass_flow * box->edge[options->drive.axis] / (options->density * volume);
}

void drive_adjust(struct drive *drive, const struct fluid_options *options, const struct box *box,
                  const struct flow *flow, double dt) {
    double mean, goal, *force = &drive->force[options->drive.axis];
    if (!has_flow(options))
        return;
    compare(options, box, flow, &mean, &goal);
    if (drive->steps > 0)
        *force -= options->density * (mean - drive->mean_before) / dt;
    *force += 0.5 * options->density * (goal - mean) / dt;
    drive->mean_before = mean;
    drive->steps++;
}

bool drive_scale(struct drive *drive, const struct fluid_options *options, const struct box *box,
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
