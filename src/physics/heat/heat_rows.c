/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows that heat adds to tables: its section of a scene and its observables. */
#include "physics/heat/heat_fields.h"
#include "physics/heat/heat.h"
#include "physics/heat/heat_own.h"
#include "kernel/particles/groups.h"
#include "data/observe/observables_kinds.h"
#include "physics_table.h"
#include "data/scene/schema_rows.h"
#include <math.h>

/* One row a key, packed to the line: */
/* clang-format off */
static const struct schema_row material_rows[] = {
    {.key = "material", .type = SCHEMA_REF, .target = "materials", AT(struct heat_material, material),
     .help = "the material; left out: all materials that no other entry names", .example = "glass"},
    {.key = "conductivity", .type = SCHEMA_REAL, .unit = "W/m/K", .range = "(0, inf)", .required = true,
     AT(struct heat_material, conductivity), .help = "thermal conductivity of the solid", .example = "1.1"},
    {.key = "capacity", .type = SCHEMA_REAL, .unit = "J/kg/K", .range = "(0, inf)", .required = true,
     AT(struct heat_material, capacity), .help = "specific heat capacity", .example = "840"},
};
static const struct schema_table material_table = TABLE(material_rows);

static const struct schema_row wall_rows[] = {
    {.key = "wall", .type = SCHEMA_REF, .target = "walls", .required = true, AT(struct heat_wall, wall),
     .help = "the wall; walls that are not named exchange no heat", .example = "floor"},
    {.key = "temperature", .type = SCHEMA_REAL, .unit = "K", .range = "[0, inf)", AT(struct heat_wall, temperature),
     .help = "temperature of the wall", .example = "400 K"},
    {.key = "flux", .type = SCHEMA_REAL, .unit = "W/m2", AT(struct heat_wall, flux),
     .help = "instead: power into each grain that touches, over the cross-section of the grain (pi r2)"},
    {.key = "table", .type = SCHEMA_PATH, AT(struct heat_wall, table),
     .help = "instead: the temperature over time, a file of rows `t T` in seconds and kelvins (numbers alone if units is none); linear between "
             "rows, constant before the first and after the last",
     .example = "oven.txt"},
};
static const struct schema_table wall_table = TABLE(wall_rows);

static const struct schema_row gas_rows[] = {
    {.key = "conductivity", .type = SCHEMA_REAL, .unit = "W/m/K", .range = "[0, inf)", .fallback = "0",
     AT(struct heat_gas, conductivity), .help = "of the gas between grains; 0: the gas conducts no heat", .example = "0.026"},
    {.key = "distance", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", AT(struct heat_gas, distance),
     .help = "gap between surfaces up to which the gas conducts; needed with a gas", .example = "50 um"},
    {.key = "roughness", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", AT(struct heat_gas, roughness),
     .help = "least gap; needed with a gas", .example = "0.5 um"},
};
static const struct schema_table gas_table = TABLE(gas_rows);

static const struct schema_row section[] = {
    {.key = "temperature", .type = SCHEMA_REAL, .unit = "K", .range = "[0, inf)", .fallback = "293.15",
     AT(struct heat_options, temperature), .help = "of all grains at the start, and of those that are inserted, where their source or insertion gives no other"},
    {.key = "dissipation", .type = SCHEMA_REAL, .range = "[0, 1]", .fallback = "0", AT(struct heat_options, dissipation),
     .help = "part of the mechanical energy lost in contacts that becomes heat of the grains: half of it in each of two grains, all of "
             "it in the grain at a wall", .example = "1"},
    {.key = "softening", .type = SCHEMA_REAL, .range = "[1, inf)", .fallback = "1", AT(struct heat_options, softening),
     .help = "Young's modulus of the real grains over that of the scene: contact radii are divided by its cube root, as "
             "if the grains were as hard as the real ones", .example = "1000"},
    {.key = "gas", .type = SCHEMA_SECTION, .sub = &gas_table, .offset = offsetof(struct heat_options, gas),
     .help = "conduction through the gas between grains that nearly touch"},
    {.key = "materials", .type = SCHEMA_LIST, .sub = &material_table, .required = true,
     ARRAY_AT(struct heat_options, material, materials), .help = "how grains and walls conduct and store heat"},
    {.key = "walls", .type = SCHEMA_LIST, .sub = &wall_table, ARRAY_AT(struct heat_options, wall, walls),
     .help = "walls of a given temperature or flux"},
};
const struct schema_table heat_schema = TABLE(section);
/* clang-format on */

_Static_assert(sizeof(struct heat_options) <= PHYSICS_OPTIONS_MAX * sizeof(double), "room in struct scene");

static bool known(const struct output_view *view) {
    return heat_temperature(view->particles) != NULL;
}

/* Calls with the grains of this rank that an item counts. */
static void take(const struct observable_context *context, struct observable_item *item, double *part,
                 void (*one)(double temperature, double *part)) {
    const struct particles *p = context->view->particles;
    const double *temperature = heat_temperature(p);
    for (size_t i = 0; temperature && i < p->owned; i++)
        if (heat_has(p, i) && observables_item_counts(context->view, item, i))
            one(temperature[i], part);
}

static void least(double temperature, double *part) {
    part[0] = part[1] > 0 ? fmax(part[0], -temperature) : -temperature;
    part[1] = 1;
}

static void most(double temperature, double *part) {
    part[0] = fmax(part[0], temperature);
    part[1] = 1;
}

static void sum(double temperature, double *part) {
    part[0] += temperature;
    part[1] += 1;
}

/* Temperatures are not negative: the largest of -T over ranks, of which ranks without grains know nothing,
 * needs a part that is lower than all. */
static void take_least(const struct observable_context *context, struct observable_item *item, double *part) {
    part[0] = -INFINITY;
    take(context, item, part, least);
}

static void take_most(const struct observable_context *context, struct observable_item *item, double *part) {
    take(context, item, part, most);
}

static void take_sum(const struct observable_context *context, struct observable_item *item, double *part) {
    take(context, item, part, sum);
}

static void finish_least(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0 ? -part[0] : NAN;
}

static void finish_most(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0 ? part[0] : NAN;
}

static void finish_mean(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0 ? part[0] / part[1] : NAN;
}

static void take_walls(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct particles *p = context->view->particles;
    const double *flow = heat_wall_flow(p);
    for (size_t i = 0; flow && i < p->owned; i++)
        if (heat_has(p, i) && observables_item_counts(context->view, item, i))
            part[0] += flow[i];
}

static void take_wall(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct heat *heat = context->view->own[PHYSICS_heat];
    if (heat)
        part[0] = heat_wall_power(heat, item->wall);
}

static void take_energy(const struct output_view *view, const struct observable_item *item, size_t i,
                        double *part) {
    const struct heat *heat = view->own[PHYSICS_heat];
    (void)item;
    if (heat && heat_has(view->particles, i))
        part[0] += heat_energy(heat, i);
}

#define INFO(name, family, unit, text)                                                                       \
    .info = {name, family, unit, text, OBSERVABLE_OF_ALL_OR_REGION, 1, unit}, .relevant = known
static const struct observable_kind kinds[] = {
    {INFO("temperature_min", "temperature", "K", "lowest temperature of a grain"), .parts = 2,
     .combine = OBSERVABLE_MAX, .of_rank = take_least, .finish = finish_least},
    {INFO("temperature_mean", "temperature", "K", "mean temperature of grains"), .parts = 2,
     .of_rank = take_sum, .finish = finish_mean},
    {INFO("temperature_max", "temperature", "K", "highest temperature of a grain"), .parts = 2,
     .combine = OBSERVABLE_MAX, .of_rank = take_most, .finish = finish_most},
    {INFO("heat_walls", "", "W", "power from walls into grains"), .parts = 1, .of_rank = take_walls},
    {.info = {"heat_wall", "", "W", "power from one wall into grains", OBSERVABLE_OF_WALL, 1, NULL},
     .symbol = "_heat",
     .parts = 1,
     .of_rank = take_wall,
     .relevant = known},
    {INFO("energy_thermal", "", "J", "m c T of the grains, with the heat that the last step brought"),
     .parts = 1, .of_particle = take_energy}};
const struct observable_table heat_observables = {kinds, sizeof kinds / sizeof kinds[0]};
