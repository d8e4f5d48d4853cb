/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows that drag adds to tables: its section of a scene and its observables. */
#include "physics/drag/drag.h"
#include "physics/drag/drag_own.h"
#include "physics/drag/drag_fields.h"
#include "physics/drag/porosity.h"
#include "kernel/particles/groups.h"
#include "data/observe/observables_kinds.h"
#include "physics_table.h"
#include "data/scene/schema_rows.h"
#include <math.h>

/* One row a key, packed to the line: */
/* clang-format off */
static const struct schema_name law_names[] = {
    {"stokes", DRAG_STOKES, "a sphere alone in creeping flow"},
    {"schiller_naumann", DRAG_SCHILLER_NAUMANN, "a sphere alone"},
    {"di_felice", DRAG_DI_FELICE, "spheres at any porosity (Di Felice 1994)"},
    {"gidaspow", DRAG_GIDASPOW, "Ergun's law up to a porosity of 0.8, Wen and Yu's beyond (Gidaspow 1994)"},
    {0}};

static const struct schema_row fluid_rows[] = {
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m3", .range = "(0, inf)", .required = true,
     AT(struct drag_fluid, density), .help = "mass of a volume", .example = "1.2"},
    {.key = "viscosity", .type = SCHEMA_REAL, .unit = "Pa s", .range = "(0, inf)", .required = true,
     AT(struct drag_fluid, viscosity), .help = "dynamic viscosity", .example = "1.8e-5"},
    {.key = "velocity", .type = SCHEMA_VECTOR, .unit = "m/s", .fallback = "[0, 0, 0]", AT(struct drag_fluid, velocity),
     .help = "superficial velocity, the volume flow over the cross-section, at time 0", .example = "[0, 0, 0.5]"},
    {.key = "acceleration", .type = SCHEMA_VECTOR, .unit = "m/s2", .fallback = "[0, 0, 0]",
     AT(struct drag_fluid, acceleration), .help = "change of that velocity in time", .example = "[0, 0, 0.1]"},
};
static const struct schema_table fluid_table = TABLE(fluid_rows);

static const struct schema_row porosity_rows[] = {
    {.key = "support", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .required = true,
     AT(struct drag_porosity, support),
     .help = "distance from a grain up to which others count; 5 of the largest radii or more", .example = "6 mm"},
    {.key = "every", .type = SCHEMA_INT, .range = "[1, 1000000]", .fallback = "1", AT(struct drag_porosity, every),
     .help = "steps after which the porosity is summed again", .example = "20"},
};
static const struct schema_table porosity_table = TABLE(porosity_rows);

static const struct schema_row section[] = {
    {.key = "law", .type = SCHEMA_NAME, .names = law_names, .fallback = "di_felice", AT(struct drag_options, law),
     .help = "the drag of a grain"},
    {.key = "fluid", .type = SCHEMA_SECTION, .sub = &fluid_table, .optional = true, .offset = offsetof(struct drag_options, fluid),
     .count_offset = offsetof(struct drag_options, fluids),
     .help = "the fluid, which flows as given; left out with fluid.grains.unresolved: the fluid of the section fluid, which loses what grains gain"},
    {.key = "porosity", .type = SCHEMA_SECTION, .sub = &porosity_table, .when = "law=di_felice|gidaspow",
     .offset = offsetof(struct drag_options, porosity), .help = "the share of the fluid in the space around a grain"},
    {.key = "largest", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", AT(struct drag_options, largest),
     .help = "radius up to which grains feel drag and count in the porosity; left out: all", .example = "1 mm"},
};
const struct schema_table drag_schema = TABLE(section);
/* clang-format on */

_Static_assert(sizeof(struct drag_options) <= PHYSICS_OPTIONS_MAX * sizeof(double), "room in struct scene");

static bool known(const struct output_view *view) {
    return drag_force(view->particles) != NULL;
}

static void take_force(const struct output_view *view, const struct observable_item *item, size_t i,
                       double *part) {
    const double *force = drag_force(view->particles);
    bool counts = force && observables_item_counts(view, item, i);
    for (size_t d = 0; counts && d < 3; d++)
        part[d] += force[3 * i + d];
}

/* Drag against gravity, and weight less buoyancy. */
static void take_ratio(const struct output_view *view, const struct observable_item *item, size_t i,
                       double *part) {
    const struct drag *drag = view->own[PHYSICS_drag];
    const struct particles *p = view->particles;
    const double *force = drag_force(p), *gravity = view->motion->gravity;
    double size = sqrt(gravity[0] * gravity[0] + gravity[1] * gravity[1] + gravity[2] * gravity[2]);
    if (drag == NULL || size == 0 || p->state[i].radius > drag_reach(drag) ||
        !observables_item_counts(view, item, i))
        return;
    for (size_t d = 0; d < 3; d++)
        part[0] -= force[3 * i + d] * gravity[d] / size;
    part[1] += size * (groups_mass(p, i) -
                       drag_density(drag) * porosity_volume(carried_solid_radius(p, carried_solid(p), i)));
}

static void take_porosity(const struct output_view *view, const struct observable_item *item, size_t i,
                          double *part) {
    const struct drag *drag = view->own[PHYSICS_drag];
    const double *porosity = drag_porosity(view->particles);
    if (drag == NULL || porosity == NULL || !observables_item_counts(view, item, i) ||
        view->particles->state[i].radius > drag_reach(drag))
        return;
    double volume = porosity_volume(view->particles->state[i].radius);
    part[0] += volume * porosity[i];
    part[1] += volume;
}

static void divide(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0 ? part[0] / part[1] : NAN;
}

static void take_velocity(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    const struct drag *drag = context->view->own[PHYSICS_drag];
    (void)item;
    if (drag != NULL && context->view->comm->rank == 0)
        drag_velocity(drag, context->view->time, part);
}

static void take_work(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct drag *drag = context->view->own[PHYSICS_drag];
    (void)item;
    part[0] = drag ? drag_work(drag) : 0;
}

#define INFO(name, unit, text, target, components)                                                           \
    .info = {name, "drag_law", unit, text, target, components, unit}, .relevant = known
static const struct observable_kind kinds[] = {
    {INFO("grain_drag", "N", "force of the drag law on grains", OBSERVABLE_OF_ALL_OR_REGION, 3), .parts = 3,
     .of_particle = take_force},
    {INFO("drag_over_weight", "1",
          "drag against gravity over the weight less buoyancy: of a bed, its pressure drop over what "
          "fluidises it",
          OBSERVABLE_OF_ALL_OR_REGION, 1),
     .parts = 2, .of_particle = take_ratio, .finish = divide},
    {INFO("porosity_mean", "1", "mean of the porosity at grains, weighted by their volumes",
          OBSERVABLE_OF_ALL_OR_REGION, 1),
     .parts = 2, .of_particle = take_porosity, .finish = divide},
    {INFO("superficial_velocity", "m/s", "of the fluid of drag", OBSERVABLE_OF_ALL, 3), .parts = 3,
     .of_rank = take_velocity},
    {INFO("work_drag", "J", "work of drag and buoyancy on grains since the start", OBSERVABLE_OF_ALL, 1),
     .parts = 1, .of_rank = take_work}};
const struct observable_table drag_observables = {kinds, sizeof kinds / sizeof kinds[0]};
