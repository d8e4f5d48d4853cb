/* SPDX-License-Identifier: BSD-3-Clause */
/* The electrolyte of a fluid in a scene. */
#include "physics/fluid/carried/electrolyte_rows.h"
#include "physics/fluid/fluid.h"
#include "physics/fluid/carried/scalars_rows.h"

/* One row a key, packed to the line: */
/* clang-format off */
static const struct schema_name equation_names[] = {
    {"poisson_boltzmann", FLUID_POISSON_BOLTZMANN, "nonlinear, for potentials of any size"},
    {"debye_hueckel", FLUID_DEBYE_HUECKEL, "linear, for potentials below the thermal voltage"},
    {0}};
static const struct schema_name axis_names[] = {{"x", 0, NULL}, {"y", 1, NULL}, {"z", 2, NULL}, {0}};

static const struct schema_row surface_rows[] = {
    {.key = "wall", .type = SCHEMA_REF, .target = "walls", AT(struct fluid_charged, at.wall), .help = "name of a wall"},
    {.key = "group", .type = SCHEMA_REF, .target = "groups", AT(struct fluid_charged, at.group), .help = "instead: name of a group of grains"},
    {.key = "side", .type = SCHEMA_NAME, .names = scalars_sides, AT(struct fluid_charged, at.side),
     .help = "instead: an open side of the box (fluid.open)", .example = "x_lower"},
    {.key = "zeta", .type = SCHEMA_REAL, .unit = "V", AT(struct fluid_charged, zeta), .help = "potential of the surface", .example = "-50 mV"},
    {.key = "charge", .type = SCHEMA_REAL, .unit = "C/m2", AT(struct fluid_charged, charge), .help = "instead: charge of an area of the surface",
     .example = "-0.01"},
    {.key = "period", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", AT(struct fluid_charged, period),
     .help = "the sign changes after each half of this length, from 0 on; left out: uniform", .example = "20 um"},
    {.key = "axis", .type = SCHEMA_NAME, .names = axis_names, .fallback = "x", AT(struct fluid_charged, axis),
     .help = "direction along which it changes"},
};
static const struct schema_table surface_table = TABLE(surface_rows);

static const struct schema_row section[] = {
    {.key = "permittivity", .type = SCHEMA_REAL, .unit = "F/m", .range = "(0, inf)", .required = true,
     AT(struct fluid_electrolyte, permittivity), .help = "permittivity of the fluid", .example = "6.95e-10"},
    {.key = "debye_length", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .required = true,
     AT(struct fluid_electrolyte, debye_length),
     .help = "sqrt(permittivity k T / (2 z^2 e^2 n)) for n ions of each sign and charge z e in a volume", .example = "1 um"},
    {.key = "thermal_voltage", .type = SCHEMA_REAL, .unit = "V", .range = "(0, inf)", .required = true,
     AT(struct fluid_electrolyte, thermal_voltage), .help = "k T / (z e)", .example = "25.7 mV"},
    {.key = "equation", .type = SCHEMA_NAME, .names = equation_names, .fallback = "poisson_boltzmann",
     AT(struct fluid_electrolyte, equation), .help = "the equation of the potential"},
    {.key = "field", .type = SCHEMA_VECTOR, .unit = "V/m", .fallback = "[0, 0, 0]", AT(struct fluid_electrolyte, field),
     .help = "applied field; walls and grains insulate", .example = "[1 kV/m, 0, 0]"},
    {.key = "surfaces", .type = SCHEMA_LIST, .sub = &surface_table, ARRAY_AT(struct fluid_electrolyte, surface, surfaces),
     .help = "charged walls, grains and sides; the others have no charge"},
};
const struct schema_table electrolyte_table = TABLE(section);
/* clang-format on */
