/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows that bonds add to tables: their section of a scene and their observables. */
#include "physics/bonds/bonds.h"
#include "physics/bonds/bonds_state.h"
#include "data/observe/observables_kinds.h"
#include "data/scene/schema_rows.h"

/* One row a key, packed to the line: */
/* clang-format off */
static const struct schema_row law_rows[] = {
    {.key = "between", .type = SCHEMA_REFS, .target = "materials", ARRAY_AT(struct bonds_entry, material, materials),
     .help = "the material of both grains, or the two materials; left out: any", .example = "[glass, steel]"},
    {.key = "groups", .type = SCHEMA_REFS, .target = "groups", ARRAY_AT(struct bonds_entry, group, groups),
     .help = "the group of both grains, or the two groups; left out: any", .example = "[stone]"},
    {.key = "k_n", .type = SCHEMA_REAL, .unit = "Pa/m", .range = "(0, inf)", AT(struct bonds_entry, k_n),
     .help = "normal stiffness of an area of the bond", .example = "1e12"},
    {.key = "k_s", .type = SCHEMA_REAL, .unit = "Pa/m", .range = "(0, inf)", AT(struct bonds_entry, k_s),
     .help = "shear stiffness of an area of the bond", .example = "4e11"},
    {.key = "modulus", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", AT(struct bonds_entry, modulus),
     .help = "instead of k_n and k_s: Young's modulus of the bond, k_n = modulus / (r_i + r_j)", .example = "1 GPa"},
    {.key = "stiffness_ratio", .type = SCHEMA_REAL, .range = "(0, inf)", AT(struct bonds_entry, ratio),
     .help = "k_n / k_s, with modulus", .example = "2.5"},
    {.key = "radius", .type = SCHEMA_REAL, .range = "(0, inf)", .fallback = "1", AT(struct bonds_entry, radius),
     .help = "radius of the bond over that of the smaller grain", .example = "0.8"},
    {.key = "tensile_strength", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", AT(struct bonds_entry, tensile),
     .help = "the bond breaks where the tensile stress at its rim reaches this; left out: never", .example = "10 MPa"},
    {.key = "shear_strength", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", AT(struct bonds_entry, shear),
     .help = "the bond breaks where the shear stress at its rim reaches this; left out: never", .example = "10 MPa"},
    {.key = "damping", .type = SCHEMA_REAL, .range = "[0, inf)", .fallback = "0", AT(struct bonds_entry, damping),
     .help = "share of critical damping of each motion of the two grains alone: apart, sliding, bending, twisting"},
};
static const struct schema_table law_table = TABLE(law_rows);

static const struct schema_name when_names[] = {
    {"start", BONDS_AT_START, "at the start of the run (or of a resume from a checkpoint without bonds)"},
    {"time", BONDS_AT_TIME, "at the given time"},
    {0}};

static const struct schema_row section[] = {
    {.key = "when", .type = SCHEMA_NAME, .names = when_names, .fallback = "start", AT(struct bonds_options, when),
     .help = "when the bonds are made, once a run"},
    {.key = "time", .type = SCHEMA_REAL, .unit = "s", .range = "[0, inf)", .when = "when=time", .required = true,
     AT(struct bonds_options, time), .help = "time at which the bonds are made", .example = "0.1 s"},
    {.key = "gap", .type = SCHEMA_REAL, .unit = "m", .range = "[0, inf)", .fallback = "0", AT(struct bonds_options, gap),
     .help = "grains whose surfaces are at most so far apart are bonded; 0: those that touch", .example = "20 um"},
    {.key = "list", .type = SCHEMA_PATH, AT(struct bonds_options, list),
     .help = "instead: a table of the ids of two grains, a line a bond, however far apart they are", .example = "bonds.txt"},
    {.key = "contacts", .type = SCHEMA_BOOL, .fallback = "true", AT(struct bonds_options, contacts),
     .help = "contacts of bonded grains act beside their bonds; false: only once the bond has broken"},
    {.key = "laws", .type = SCHEMA_LIST, .sub = &law_table, .required = true,
     ARRAY_AT(struct bonds_options, entry, entries),
     .help = "stiffness and strength of bonds; the first that fits two grains serves them, and grains that none fits "
             "are not bonded"},
};
const struct schema_table bonds_schema = TABLE(section);
/* clang-format on */

_Static_assert(sizeof(struct bonds_options) <= PHYSICS_OPTIONS_MAX * sizeof(double), "room in struct scene");

static const struct bonds *bonds_of(const struct observable_context *context) {
    return context->view->own[PHYSICS_bonds];
}

static bool known(const struct output_view *view) {
    return view->own[PHYSICS_bonds] != NULL;
}

static void whole(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct bonds *bonds = bonds_of(context);
    (void)item;
    for (size_t k = 0; bonds && k < bonds->rows.count; k++)
        part[0] += bonds->link[k].end == BOND_WHOLE ? 0.5 : 0.0;
}

static void by_tension(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct bonds *bonds = bonds_of(context);
    (void)item;
    part[0] = bonds ? bonds->broken[BOND_TENSION] : 0.0;
}

static void by_shear(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct bonds *bonds = bonds_of(context);
    (void)item;
    part[0] = bonds ? bonds->broken[BOND_SHEARED] : 0.0;
}

static void stored(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct bonds *bonds = bonds_of(context);
    (void)item;
    part[0] = bonds ? bonds->stored : 0.0;
}

static void taken(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct bonds *bonds = bonds_of(context);
    (void)item;
    part[0] = bonds ? bonds->taken : 0.0;
}

#define INFO(name, family, unit, text)                                                                       \
    .info = {name, family, unit, text, OBSERVABLE_OF_ALL, 1, unit}, .parts = 1, .relevant = known
static const struct observable_kind kinds[] = {
    {INFO("bonds_whole", "bonds", "1", "number of bonds"), .of_rank = whole},
    {INFO("bonds_broken_tension", "bonds", "1", "number of bonds that tension has broken"),
     .of_rank = by_tension},
    {INFO("bonds_broken_shear", "bonds", "1", "number of bonds that shear has broken"), .of_rank = by_shear},
    {INFO("energy_bonds", "bonds", "J", "energy stored in bonds"), .of_rank = stored},
    {INFO("energy_bonds_taken", "bonds", "J", "energy taken by dampers of bonds and by bonds that broke"),
     .of_rank = taken}};
const struct observable_table bonds_observables = {kinds, sizeof kinds / sizeof kinds[0]};
