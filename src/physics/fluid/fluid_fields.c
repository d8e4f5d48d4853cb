/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of a fluid, and its observables. Read fluid_fields.h first. */
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/coupling/unresolved_grains.h"
#include "physics/fluid/observe_flow.h"
#include "physics/fluid/fluid_state.h"
#include "data/observe/observables_kinds.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include "physics_table.h"
#include <math.h>

/* clang-format off */
#define OF_FLUID .kinds = 1u << KIND_FLUID, .needed_for = "fluid"
static const struct field
    pressure = {.name = "pressure", .type = FIELD_DOUBLE, .components = 1, .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT,
                .unit = "Pa", OF_FLUID, .help = "pressure of the fluid, of mean 0 and without what drives the flow"},
    divergence = {.name = "divergence", .type = FIELD_DOUBLE, .components = 1, .use = FIELD_OUTPUT | FIELD_ASKED,
                  .unit = "s-1", OF_FLUID, .help = "divergence of the velocity, as the scheme computes it"},
    drag = {.name = "drag", .type = FIELD_DOUBLE, .components = 3, .use = FIELD_OUTPUT | FIELD_ASKED, .unit = "N",
            .kinds = 1u << KIND_GRAIN | 1u << KIND_FLUID, .needed_for = "fluid",
            .help = "force of the fluid on a grain; of a fluid particle, that of viscosity on its cell of the lattice"},
    advection = {.name = "fluid_advection", .type = FIELD_DOUBLE, .components = 3, .use = FIELD_TRAVELS, .unit = "m s-2",
                 OF_FLUID, .help = "inertia of the step before, (u . grad) u + 1/2 (div u) u"},
    /* within a step, the velocity before the pressure makes it free of divergence */
    predicted = {.name = "vorticity", .type = FIELD_DOUBLE, .components = 3, .use = FIELD_OUTPUT | FIELD_ASKED,
                 .unit = "s-1", OF_FLUID, .help = "curl of the velocity"},
    increment = {.name = "fluid_increment", .type = FIELD_DOUBLE, .components = 1, .unit = "Pa", OF_FLUID,
                 .help = "change of the pressure in a step"},
    row = {.name = "fluid_row", .type = FIELD_INT64, .components = 1, OF_FLUID, .help = "row of the matrices"},
    region = {.name = "fluid_region", .type = FIELD_INT32, .components = 1,
              .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED | FIELD_FIXED, OF_FLUID,
              .help = "number of the connected region of fluid, from the largest one, 0, on"},
    body = {.name = "fluid_body", .type = FIELD_INT64, .components = 1,
            .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED | FIELD_FIXED,
            .kinds = 1u << KIND_BOUNDARY, .needed_for = "fluid",
            .help = "of a boundary particle: id of its grain, or -1 - number of its wall; 0: a closed pocket"},
    condition = {.name = "condition", .type = FIELD_DOUBLE, .components = 1, .use = FIELD_OUTPUT | FIELD_ASKED, OF_FLUID,
                 .help = "condition number of the correction G of the gradient, 1 on a lattice; 0: standard operators"},
    /* of particles that move, and of volumes that differ: there where a scene has them */
    volume = {.name = "fluid_volume", .type = FIELD_DOUBLE, .components = 1, .needed_for = "fluid",
              .kinds = 1u << KIND_FLUID | 1u << KIND_BOUNDARY, .help = "volume of a particle"},
    arm = {.name = "fluid_arm", .type = FIELD_DOUBLE, .components = 3, .use = FIELD_TRAVELS, .unit = "m", .fill = NAN,
           .kinds = 1u << KIND_BOUNDARY, .needed_for = "fluid", .help = "of a boundary particle: its place in its grain"},
    load = {.name = "fluid_load", .type = FIELD_DOUBLE, .components = 6, .use = FIELD_TRAVELS, .fill = NAN,
            .kinds = 1u << KIND_GRAIN | 1u << KIND_BODY, .needed_for = "fluid.grains: free", .help = "force (N) and torque (N m) of the fluid on a grain in its last step"},
    push = {.name = "fluid_push", .type = FIELD_DOUBLE, .components = 6, .use = FIELD_TRAVELS,
            .kinds = 1u << KIND_GRAIN | 1u << KIND_BODY, .needed_for = "fluid.grains: free",
            .help = "force (N) and torque (N m) on a grain by fluid and buoyancy in the last step"},
    velocity_before = {.name = "fluid_velocity_before", .type = FIELD_DOUBLE, .components = 3, .use = FIELD_TRAVELS,
                       .unit = "m s-1", OF_FLUID, .help = "velocity of the step before"},
    drift = {.name = "fluid_drift", .type = FIELD_DOUBLE, .components = 3, .use = FIELD_TRAVELS, .unit = "m s-1",
             OF_FLUID, .help = "velocity of the particle less that of the fluid"},
    drift_advection = {.name = "fluid_drift_advection", .type = FIELD_DOUBLE, .components = 3, .use = FIELD_TRAVELS,
                       .unit = "m s-2", OF_FLUID, .help = "(drift . grad) u"},
    gradient = {.name = "fluid_gradient", .type = FIELD_DOUBLE, .components = 3, .unit = "Pa m-1", OF_FLUID,
                .help = "gradient of the pressure within a step"},
    mobility = {.name = "fluid_mobility", .type = FIELD_DOUBLE, .components = 1, OF_FLUID, .fill = 1,
                .help = "what grains that are not resolved leave of the answer to a gradient of the pressure"},
    /* of open sides */
    whole = {.name = "fluid_whole", .type = FIELD_DOUBLE, .components = 9, OF_FLUID,
             .help = "what makes the gradient of a pressure whole beside walls and grains"};
/* clang-format on */

void fluid_fields(struct particles *particles) {
    fields_register(particles, &pressure);
    fields_register(particles, &divergence);
    fields_register(particles, &drag);
    fields_register(particles, &advection);
    fields_register(particles, &predicted);
    fields_register(particles, &increment);
    fields_register(particles, &row);
    fields_register(particles, &region);
    fields_register(particles, &body);
    fields_register(particles, &condition);
}

void fluid_fields_volumes(struct particles *particles) {
    fields_register(particles, &volume);
}

void fluid_fields_open(struct particles *particles) {
    fields_register(particles, &whole);
}

void fluid_fields_mobility(struct particles *particles) {
    fields_register(particles, &mobility);
}

double *fluid_mobility(const struct particles *particles) {
    return fields_values(particles, &mobility);
}

void fluid_fields_riding(struct particles *particles) {
    fields_register(particles, &arm);
}

void fluid_fields_free(struct particles *particles) {
    fields_register(particles, &load);
    fields_register(particles, &push);
}

double (*fluid_load(const struct particles *particles))[6] {
    return fields_values(particles, &load);
}

int fluid_load_handle(const struct particles *particles) {
    return fields_handle(particles, &load);
}

double (*fluid_push(const struct particles *particles))[6] {
    return fields_values(particles, &push);
}

void fluid_fields_moving(struct particles *particles) {
    fields_register(particles, &velocity_before);
    fields_register(particles, &drift);
    fields_register(particles, &drift_advection);
    fields_register(particles, &gradient);
}

int fluid_handle(const struct particles *particles, enum flow_array array) {
    static const struct field *const fields[] = {
        [FLOW_PRESSURE] = &pressure, [FLOW_PREDICTED] = &predicted, [FLOW_INCREMENT] = &increment,
        [FLOW_ROW] = &row,           [FLOW_GRADIENT] = &gradient,   [FLOW_VOLUME] = &volume,
        [FLOW_WHOLE] = &whole,       [FLOW_MOBILITY] = &mobility};
    return array == FLOW_VELOCITY ? FIELD_VELOCITY : fields_handle(particles, fields[array]);
}

double *fluid_pressure(const struct particles *particles) {
    return fields_values(particles, &pressure);
}

double *fluid_divergence(const struct particles *particles) {
    return fields_values(particles, &divergence);
}

double *fluid_drag(const struct particles *particles) {
    return fields_values(particles, &drag);
}

int fluid_drag_handle(const struct particles *particles) {
    return fields_handle(particles, &drag);
}

double *fluid_advection(const struct particles *particles) {
    return fields_values(particles, &advection);
}

double *fluid_condition(const struct particles *particles) {
    return fields_values(particles, &condition);
}

double *fluid_volume(const struct particles *particles) {
    return fields_values(particles, &volume);
}

double (*fluid_whole(const struct particles *particles))[9] {
    return fields_values(particles, &whole);
}

double (*fluid_arm(const struct particles *particles))[3] {
    return fields_values(particles, &arm);
}

double *fluid_velocity_before(const struct particles *particles) {
    return fields_values(particles, &velocity_before);
}

double *fluid_drift(const struct particles *particles) {
    return fields_values(particles, &drift);
}

double *fluid_drift_advection(const struct particles *particles) {
    return fields_values(particles, &drift_advection);
}

double *fluid_gradient(const struct particles *particles) {
    return fields_values(particles, &gradient);
}

int32_t *fluid_region(const struct particles *particles) {
    return fields_values(particles, &region);
}

int64_t *fluid_body(const struct particles *particles) {
    return fields_values(particles, &body);
}

static bool known(const struct output_view *view) {
    return fluid_pressure(view->particles) != NULL;
}

/* The volume of a fluid particle of the lattice, less what grains fill; 0 of other particles. */
static double volume_of(const struct output_view *view, size_t i) {
    const uint8_t *kind = kinds_of(view->particles);
    const struct fluid *fluid = view->own[PHYSICS_fluid];
    bool known = fluid != NULL && kind != NULL && kind[i] == KIND_FLUID;
    return known ? fluid->lattice.volume * rigid_fields_free(view->particles, i) : 0;
}

static double box_volume(const struct output_view *view) {
    double volume = 1;
    for (int d = 0; d < view->box->dimension; d++)
        volume *= view->box->edge[d];
    return volume;
}

static void take_velocity(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    (void)item;
    for (size_t i = 0; i < context->view->particles->owned; i++)
        for (int d = 0; d < 3; d++)
            part[d] += volume_of(context->view, i) * context->view->particles->state[i].v[d];
}

static void take_momentum(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    const struct fluid *fluid = context->view->own[PHYSICS_fluid];
    double flow[3];
    (void)item;
    for (size_t i = 0; i < context->view->particles->owned && fluid != NULL; i++) {
        double mass = fluid->options->density * volume_of(context->view, i);
        if (mass > 0)
            unresolved_flow(context->view->particles, i, flow);
        for (int d = 0; d < 3 && mass > 0; d++)
            part[d] += mass * flow[d];
    }
}

static void divide_velocity(const struct output_view *view, const struct observable_item *item,
                            double *part) {
    (void)item;
    for (int d = 0; d < 3; d++)
        part[d] /= box_volume(view);
}

static void take_porosity(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    (void)item;
    for (size_t i = 0; i < context->view->particles->owned; i++)
        part[0] += volume_of(context->view, i) / box_volume(context->view);
}

/* Half of the square of the velocity: times the density of the fluid the energy. */
static void take_square(const struct observable_context *context, struct observable_item *item,
                        double *part) {
    (void)item;
    for (size_t i = 0; i < context->view->particles->owned; i++) {
        const double *v = context->view->particles->state[i].v;
        part[0] += 0.5 * volume_of(context->view, i) * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    part[0] /= box_volume(context->view);
}

static void take_speed(const struct observable_context *context, struct observable_item *item, double *part) {
    (void)item;
    for (size_t i = 0; i < context->view->particles->owned; i++) {
        const double *v = context->view->particles->state[i].v;
        if (volume_of(context->view, i) > 0)
            part[0] = fmax(part[0], sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    }
}

static void take_divergence(const struct observable_context *context, struct observable_item *item,
                            double *part) {
    const double *value = fluid_divergence(context->view->particles);
    (void)item;
    for (size_t i = 0; value && i < context->view->particles->owned; i++)
        if (volume_of(context->view, i) > 0)
            part[0] = fmax(part[0], fabs(value[i]));
}

static void take_drag(const struct observable_context *context, struct observable_item *item, double *part) {
    const double *value = fluid_drag(context->view->particles);
    const uint8_t *kind = kinds_of(context->view->particles);
    for (size_t i = 0; value && i < context->view->particles->owned; i++)
        for (int d = 0; d < 3 && kind[i] == KIND_GRAIN && observables_item_counts(context->view, item, i);
             d++)
            part[d] += value[3 * i + (size_t)d];
}

#define FORCE(name)                                                                                          \
    {name "x", NULL, NULL}, {name "y", NULL, NULL}, {                                                        \
        name "z", NULL, NULL                                                                                 \
    }
#define TORQUE(axis)                                                                                         \
    { "torque_" axis, "N m", "N" }
static const struct observable_component drag_components[] = {
    FORCE(""), FORCE("viscous_"), FORCE("pressure_"), TORQUE("x"), TORQUE("y"), TORQUE("z")};

#define INFO(word, unit, text, components)                                                                   \
    .info = {"fluid_" word, "fluid", unit, text, OBSERVABLE_OF_ALL, components, unit}, .parts = components,  \
    .relevant = known
#define SCALAR(number, is)                                                                                   \
    {.info = {"scalar_" number "_mean", "scalar", "1", "mean of scalar " number " over the fluid",           \
              OBSERVABLE_OF_ALL_OR_REGION, 1, "1"},                                                          \
     .parts = 2,                                                                                             \
     .relevant = is,                                                                                         \
     .of_rank = observe_scalar_mean,                                                                         \
     .finish = observe_scalar_mean_finish},                                                                  \
        {.info = {"scalar_" number "_flux", "scalar", "m3/s",                                                \
                  "flux of scalar " number                                                                   \
                  " along each direction, by flow and diffusion, through a section of the box; of a region " \
                  "that is a box, through a section of it",                                                  \
                  OBSERVABLE_OF_ALL_OR_REGION, 3, "m2/s"},                                                   \
         .parts = 3,                                                                                         \
         .relevant = is,                                                                                     \
         .of_rank = observe_scalar_flux},                                                                    \
    {                                                                                                        \
        .info = {"scalar_" number "_carried",                                                                \
                 "scalar",                                                                                   \
                 "1",                                                                                        \
                 "mean of scalar " number                                                                    \
                 " weighted by the flow along its mean: at an outlet the breakthrough curve",                \
                 OBSERVABLE_OF_ALL_OR_REGION,                                                                \
                 1,                                                                                          \
                 "1"},                                                                                       \
        .parts = 6, .relevant = is, .of_rank = observe_scalar_carried,                                       \
        .finish = observe_scalar_carried_finish                                                              \
    }
static const struct observable_kind kinds[] = {
    {INFO("velocity", "m/s",
          "superficial velocity: sum of velocity x volume of the fluid over the volume of the box", 3),
     .of_rank = take_velocity, .finish = divide_velocity},
    {INFO("porosity", "1", "volume of the fluid over that of the box", 1), .of_rank = take_porosity},
    {INFO("energy", "m2/s2", "kinetic energy over the fluid's density and the volume of the box", 1),
     .of_rank = take_square},
    {.info = {"fluid_drag", "fluid", "N", "force of the fluid on grains", OBSERVABLE_OF_ALL_OR_REGION, 3,
              "N/m"},
     .parts = 3,
     .relevant = known,
     .of_rank = take_drag},
    {.info = {"drag", "", "N",
              "force of the fluid on a wall or a group of grains, its viscous part, its pressure part, and "
              "its torque (N m; of "
              "a wall about its centre, of a group the sum of those on its grains about their centres)",
              OBSERVABLE_OF_BODY, 12, "N/m"},
     .component = drag_components,
     .parts = 12,
     .of_rank = observe_drag},
    {.info = {"flow_rate", "fluid", "kg/s", "mass of the fluid that flows along each direction",
              OBSERVABLE_OF_ALL, 3, "kg/(m s)"},
     .parts = 3,
     .relevant = known,
     .of_rank = observe_flow_rate},
    {.info = {"pressure_drop", "fluid", "Pa",
              "drop over the box of the pressure that drives the fluid, or from one open side to the "
              "opposite one",
              OBSERVABLE_OF_ALL, 3, "Pa"},
     .parts = 12,
     .relevant = known,
     .of_rank = observe_pressure_drop,
     .finish = observe_pressure_drop_finish},
    {.info = {"permeability", "fluid", "m2", "viscosity x superficial velocity / driving force (Darcy)",
              OBSERVABLE_OF_ALL, 1, "m2"},
     .parts = 2,
     .relevant = known,
     .of_rank = observe_permeability,
     .finish = observe_permeability_finish},
    {INFO("iterations", "1", "iterations of the last solve for the pressure, or for the steady flow", 1),
     .of_rank = observe_iterations},
    {INFO("residual", "1", "true relative residual of the last solves", 1), .of_rank = observe_residual},
    {INFO("speed", "m/s", "largest speed", 1), .of_rank = take_speed, .combine = OBSERVABLE_MAX},
    {INFO("divergence", "1/s", "largest divergence of the velocity", 1), .of_rank = take_divergence,
     .combine = OBSERVABLE_MAX},
    {.info = {"fluid_charge", "fluid", "C", "charge of the ions of an electrolyte", OBSERVABLE_OF_ALL, 1,
              "C/m"},
     .parts = 1,
     .relevant = observe_charged,
     .of_rank = observe_charge},
    {.info = {"fluid_momentum", "fluid", "N s",
              "momentum of the fluid: of grains that it does not resolve without their room",
              OBSERVABLE_OF_ALL, 3, "N s/m"},
     .parts = 3,
     .relevant = known,
     .of_rank = take_momentum},
    SCALAR("1", observe_scalar_1),
    SCALAR("2", observe_scalar_2),
    SCALAR("3", observe_scalar_3)};
const struct observable_table fluid_observables = {kinds, sizeof kinds / sizeof kinds[0]};
