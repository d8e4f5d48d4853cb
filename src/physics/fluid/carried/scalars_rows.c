/* SPDX-License-Identifier: BSD-3-Clause */
/* The scalars of a fluid in a scene. */
#include "physics/fluid/carried/scalars_rows.h"
#include "physics/fluid/fluid.h"
#include "data/scene/schema_particles.h"

/* One row a key, packed to the line: */
/* clang-format off */
const struct schema_name scalars_sides[] = {
    {"x_lower", 0, NULL}, {"x_upper", 1, NULL}, {"y_lower", 2, NULL}, {"y_upper", 3, NULL}, {"z_lower", 4, NULL},
    {"z_upper", 5, NULL}, {0}};
static const struct schema_name advection_names[] = {
    {"central", FLUID_CENTRAL, "of second order; may swing beyond the values at the start where a scalar jumps within a spacing"},
    {"upwind", FLUID_UPWIND, "of first order; on a lattice never beyond them"},
    {0}};

static const struct schema_row initial_rows[] = {
    {.key = "value", .type = SCHEMA_REAL, .fallback = "0", AT(struct fluid_scalar_initial, value), .help = "value in the region"},
    {.key = "region", .type = SCHEMA_SECTION, .sub = &schema_region, .offset = offsetof(struct fluid_scalar_initial, region),
     .help = "the region of this value"},
    {.key = "elsewhere", .type = SCHEMA_REAL, .fallback = "0", AT(struct fluid_scalar_initial, elsewhere),
     .help = "value outside of the region"},
};
static const struct schema_table initial_table = TABLE(initial_rows);

static const struct schema_row given_rows[] = {
    {.key = "wall", .type = SCHEMA_REF, .target = "walls", AT(struct fluid_value, at.wall), .help = "name of a wall"},
    {.key = "group", .type = SCHEMA_REF, .target = "groups", AT(struct fluid_value, at.group), .help = "instead: name of a group of grains"},
    {.key = "side", .type = SCHEMA_NAME, .names = scalars_sides, AT(struct fluid_value, at.side),
     .help = "instead: an open side of the box (fluid.open)", .example = "x_lower"},
    {.key = "value", .type = SCHEMA_REAL, .required = true, AT(struct fluid_value, value), .help = "value there", .example = "1"},
};
static const struct schema_table given_table = TABLE(given_rows);

static const struct schema_row section[] = {
    {.key = "name", .type = SCHEMA_TEXT, .fallback = "", AT(struct fluid_scalar, name),
     .help = "for people; fields and observables are scalar_1, scalar_2, scalar_3, by the order of the list", .example = "dye"},
    {.key = "diffusivity", .type = SCHEMA_REAL, .unit = "m2/s", .range = "[0, inf)", .required = true,
     AT(struct fluid_scalar, diffusivity), .help = "diffusivity", .example = "1e-9"},
    {.key = "advection", .type = SCHEMA_NAME, .names = advection_names, .fallback = "central", AT(struct fluid_scalar, advection),
     .help = "differences of the term (u . grad) c"},
    {.key = "initial", .type = SCHEMA_SECTION, .sub = &initial_table, .main = "value", .offset = offsetof(struct fluid_scalar, initial),
     .help = "values at the start"},
    {.key = "given", .type = SCHEMA_LIST, .sub = &given_table, ARRAY_AT(struct fluid_scalar, given, givens),
     .help = "values given at walls, grains and open sides; the others let nothing through, and at open sides the scalar does not "
             "change along the normal"},
};
const struct schema_table scalars_table = TABLE(section);
/* clang-format on */
