/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: materials, their pairs, the contact law. */
#include "scene/scene.h"
#include "scene/schema_contact.h"

/* One row a key, packed to the line: */
/* clang-format off */

static const struct schema_row material_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .required = true, .in_column = true, AT(struct law_material, name),
     .help = "name of the material for other keys", .example = "glass"},
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m3", .range = "(0, inf)", .required = true,
     AT(struct law_material, density), .help = "mass of a sphere over its volume, in two dimensions too",
     .example = "2500"},
    {.key = "young", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", .when = "/contact.law:moduli & /contact.damping=restitution",
     .required = true, AT(struct law_material, young), .help = "Young's modulus", .example = "70 GPa"},
    {.key = "poisson", .type = SCHEMA_REAL, .range = "(-1, 0.5]", .when = "/contact.law:moduli & /contact.damping=restitution",
     .required = true, AT(struct law_material, poisson), .help = "Poisson's ratio", .example = "0.2"},
};
const struct schema_table schema_material = TABLE(material_rows);

static const struct schema_row pair_rows[] = {
    {.key = "between", .type = SCHEMA_REFS, .target = "materials",
     ARRAY_AT(struct scene_pair, material, between_count),
     .help = "the two materials; left out: the values of every pair without an entry of its own",
     .example = "[glass, steel]"},
    {.key = "restitution", .type = SCHEMA_REAL, .range = "[0, 1]", .when = "/contact.damping=restitution",
     .required = true, AT(struct scene_pair, restitution),
     .help = "coefficient of restitution, normal, at any size and speed", .example = "0.5"},
    {.key = "friction", .type = SCHEMA_REAL, .range = "[0, inf)", .when = "/contact.tangential=history",
     .fallback = "0", AT(struct scene_pair, friction), .help = "Coulomb's coefficient of friction",
     .example = "0.3"},
    {.key = "rolling_friction", .type = SCHEMA_REAL, .range = "[0, inf)", .when = "/contact.rolling=spring",
     .fallback = "0", AT(struct scene_pair, rolling_friction), .help = "coefficient of rolling friction",
     .example = "0.01"},
    {.key = "k_n", .type = SCHEMA_REAL, .unit = "N/m", .range = "(0, inf)", .when = "/contact.law:stiffness",
     .required = true, AT(struct scene_pair, k_n), .help = "normal stiffness", .example = "1e5"},
    {.key = "k_n", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)",
     .when = "/contact.law:moduli & /contact.damping=coefficient", .required = true, AT(struct scene_pair, k_n),
     .help = "normal stiffness over the contact radius sqrt(R* overlap): 4/3 E*", .example = "1e9"},
    {.key = "k_t", .type = SCHEMA_REAL, .unit = "N/m", .range = "(0, inf)",
     .when = "/contact.law:stiffness & /contact.tangential=history", AT(struct scene_pair, k_t),
     .help = "tangential stiffness; left out: 2/7 of k_n", .example = "2.857e4"},
    {.key = "k_t", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)",
     .when = "/contact.law:moduli & /contact.damping=coefficient & /contact.tangential=history",
     AT(struct scene_pair, k_t),
     .help = "tangential stiffness over the contact radius: 8 G*; left out: 2/7 of k_n", .example = "2.857e8"},
    {.key = "gamma_n", .type = SCHEMA_REAL, .unit = "1/s", .range = "[0, inf)",
     .when = "/contact.law:stiffness & /contact.damping=coefficient", .required = true,
     AT(struct scene_pair, gamma_n), .help = "normal damping per unit of effective mass", .example = "50"},
    {.key = "gamma_n", .type = SCHEMA_REAL, .unit = "1/s/m", .range = "[0, inf)",
     .when = "/contact.law:moduli & /contact.damping=coefficient", .required = true,
     AT(struct scene_pair, gamma_n), .help = "normal damping per unit of effective mass and of contact radius",
     .example = "5e5"},
    {.key = "gamma_t", .type = SCHEMA_REAL, .unit = "1/s", .range = "[0, inf)",
     .when = "/contact.law:stiffness & /contact.damping=coefficient & /contact.tangential=history",
     AT(struct scene_pair, gamma_t),
     .help = "tangential damping per unit of effective mass; left out: half of gamma_n", .example = "25"},
    {.key = "gamma_t", .type = SCHEMA_REAL, .unit = "1/s/m", .range = "[0, inf)",
     .when = "/contact.law:moduli & /contact.damping=coefficient & /contact.tangential=history",
     AT(struct scene_pair, gamma_t),
     .help = "tangential damping per unit of effective mass and of contact radius; left out: half of gamma_n",
     .example = "2.5e5"},
};
const struct schema_table schema_pair = TABLE(pair_rows);

#define LAW_SCHEMA_NAME(NAME, name, traits, summary) {#name, LAW_##NAME, summary},
static const struct schema_name law_names[] = {LAW_TABLE(LAW_SCHEMA_NAME) {0}};
#undef LAW_SCHEMA_NAME

static const char *law_traits(int law) {
    return law_row_get((enum law_normal)law)->traits;
}

static const struct schema_name damping_names[] = {
    {"restitution", LAW_DAMPING_RESTITUTION, "from the given restitution"},
    {"coefficient", LAW_DAMPING_COEFFICIENT,
     "from gamma_n and gamma_t, per unit of effective mass, as in LAMMPS"},
    {0}};
static const struct schema_name end_names[] = {
    {"overlap", LAW_END_OVERLAP,
     "when the surfaces part: the damper pulls just before, and friction counts this pull, too, as in LAMMPS"},
    {"force", LAW_END_FORCE, "when the force would pull: grains never attract"},
    {0}};
static const struct schema_name tangential_names[] = {
    {"none", LAW_FRICTIONLESS, "no friction: no spin, no torque, no history anywhere"},
    {"history", LAW_TANGENTIAL_HISTORY, "a spring with history, up to Coulomb's limit"},
    {0}};
static const struct schema_name sliding_names[] = {
    {"series", LAW_SLIDING_SERIES, "the change of the spring alone: slider in series, no energy from nothing"},
    {"total", LAW_SLIDING_TOTAL, "all of the slip; the spring takes the rest of the limit, as in LAMMPS"},
    {0}};
static const struct schema_name rolling_names[] = {
    {"none", LAW_ROLLING_NONE, NULL},
    {"spring", LAW_ROLLING_SPRING, "a spring and dashpot against rolling, up to a limit"},
    {0}};

static const struct schema_row contact_rows[] = {
    {.key = "law", .type = SCHEMA_NAME, .names = law_names, .fallback = LAW_NORMAL_DEFAULT_NAME,
     .traits = law_traits, AT(struct law_options, normal), .help = "the normal force"},
    {.key = "damping", .type = SCHEMA_NAME, .names = damping_names, .fallback = "restitution",
     AT(struct law_options, damping), .help = "source of the damping"},
    {.key = "end", .type = SCHEMA_NAME, .names = end_names, .fallback = "force",
     AT(struct law_options, end), .help = "the end of a contact; both ends give the given restitution"},
    {.key = "tangential", .type = SCHEMA_NAME, .names = tangential_names, .fallback = "history",
     AT(struct law_options, tangential), .help = "the tangential force"},
    {.key = "sliding", .type = SCHEMA_NAME, .names = sliding_names, .fallback = "series",
     .when = "tangential=history", AT(struct law_options, sliding),
     .help = "the slip that the tangential damper sees while a contact slides"},
    {.key = "rolling", .type = SCHEMA_NAME, .names = rolling_names, .fallback = "none",
     .when = "tangential=history", AT(struct law_options, rolling), .help = "resistance to rolling"},
    {.key = "tangential_damping_ratio", .type = SCHEMA_REAL, .range = "[0, inf)", .fallback = "1",
     .when = "damping=restitution & tangential=history", AT(struct law_options, tangential_damping_ratio),
     .help = "tangential damping; 1: the same damping ratio as that of the normal spring"},
    {.key = "tangential_damping_equal", .type = SCHEMA_BOOL, .fallback = "false",
     .when = "damping=restitution & tangential=history", AT(struct law_options, tangential_damping_equal),
     .help = "the tangential damping coefficient equals the normal one, as in LAMMPS's pair_style granular"},
    {.key = "lammps_history", .alias = "lammps_hooke", .type = SCHEMA_BOOL, .fallback = "false",
     AT(struct law_options, lammps_history),
     .help = "exactly gran/hooke/history or gran/hertz/history of LAMMPS, for comparisons; the lever is then the radius; needs "
             "damping: coefficient, end: overlap, rolling: none and integrator: velocity_verlet"},
};
const struct schema_table schema_contact = TABLE(contact_rows);
/* clang-format on */
