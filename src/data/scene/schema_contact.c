/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: materials, their pairs, the contact law. */
#include "data/scene/scene.h"
#include "data/scene/schema_sections.h"

/* One row a key, packed to the line: */
/* clang-format off */

static const struct schema_row material_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .required = true, .in_column = SCHEMA_COLUMN_NAME, AT(struct law_material, name),
     .help = "name of the material for other keys", .example = "glass"},
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m3", .when = "/box.density=volume", .range = "(0, inf)", .required = true,
     AT(struct law_material, density), .help = "mass of a sphere over its volume, in two dimensions too (box.density: area changes that)",
     .example = "2500"},
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m2", .when = "/box.density=area", .range = "(0, inf)", .required = true,
     AT(struct law_material, density), .help = "mass of a disc over its area", .example = "5"},
    {.key = "young", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", .when = "/contact.law:moduli & /contact.damping:scaled",
     .required = true, AT(struct law_material, young), .help = "Young's modulus", .example = "70 GPa"},
    {.key = "poisson", .type = SCHEMA_REAL, .range = "(-1, 0.5]", .when = "/contact.law:moduli & /contact.damping:scaled",
     .required = true, AT(struct law_material, poisson), .help = "Poisson's ratio", .example = "0.2"},
};
const struct schema_table schema_material = TABLE(material_rows);

/* The keys of the parts of a law, each with its own (physics/grains/laws/law_part.h) */
#define PART_KEY(condition, place, member, range_, ...) \
    {.key = #member, .type = SCHEMA_REAL, .when = condition, .range = range_, AT(struct scene_pair, extra.place.member), __VA_ARGS__},
#define COHESION_KEY(part, member, ...) PART_KEY("/contact.cohesion.law=" #part, cohesion_##part, member, __VA_ARGS__)
#define COHESION_KEYS(NAME, name, with, summary) COHESION_##NAME##_KEYS(COHESION_KEY)
#define DAMPING_KEY(part, member, ...) PART_KEY("/contact.damping=" #part, damping_##part, member, __VA_ARGS__)
#define DAMPING_KEYS(NAME, name, with, summary) DAMPING_##NAME##_KEYS(DAMPING_KEY)
#define ROLLING_KEY(part, member, ...) PART_KEY("/contact.rolling=" #part, rolling_##part, member, __VA_ARGS__)
#define ROLLING_KEYS(NAME, name, with, summary) ROLLING_##NAME##_KEYS(ROLLING_KEY)
#define TWISTING_KEY(part, member, ...) PART_KEY("/contact.twisting=" #part, twisting_##part, member, __VA_ARGS__)
#define TWISTING_KEYS(NAME, name, with, summary) TWISTING_##NAME##_KEYS(TWISTING_KEY)

static const struct schema_row pair_rows[] = {
    {.key = "between", .type = SCHEMA_REFS, .target = "materials",
     ARRAY_AT(struct scene_pair, material, between_count),
     .help = "the two materials; left out: the values of every pair without an entry of its own",
     .example = "[glass, steel]"},
    {.key = "restitution", .type = SCHEMA_REAL, .range = "[0, 1]", .when = "/contact.damping:restitution",
     .required = true, AT(struct scene_pair, restitution),
     .help = "coefficient of restitution, normal, at any size and speed", .example = "0.5"},
    {.key = "friction", .type = SCHEMA_REAL, .range = "[0, inf)", .when = "/contact.tangential:friction",
     .fallback = "0", AT(struct scene_pair, friction), .help = "Coulomb's coefficient of friction",
     .example = "0.3"},
    {.key = "rolling_friction", .type = SCHEMA_REAL, .range = "[0, inf)", .when = "/contact.rolling:resists",
     .fallback = "0", AT(struct scene_pair, rolling_friction), .help = "coefficient of rolling friction",
     .example = "0.01"},
    {.key = "k_n", .type = SCHEMA_REAL, .unit = "N/m", .range = "(0, inf)", .when = "/contact.law:stiffness",
     .required = true, AT(struct scene_pair, k_n), .help = "normal stiffness", .example = "1e5"},
    {.key = "k_n", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)",
     .when = "/contact.law:moduli & /contact.damping:given", .required = true, AT(struct scene_pair, k_n),
     .help = "normal stiffness over the contact radius sqrt(R* overlap): 4/3 E*", .example = "1e9"},
    {.key = "k_t", .type = SCHEMA_REAL, .unit = "N/m", .range = "(0, inf)",
     .when = "/contact.law:stiffness & /contact.tangential:friction", AT(struct scene_pair, k_t),
     .help = "tangential stiffness; left out: 2/7 of k_n", .example = "2.857e4"},
    {.key = "k_t", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)",
     .when = "/contact.law:moduli & /contact.damping:given & /contact.tangential:friction",
     AT(struct scene_pair, k_t),
     .help = "tangential stiffness over the contact radius: 8 G*; left out: 2/7 of k_n", .example = "2.857e8"},
    {.key = "gamma_n", .type = SCHEMA_REAL, .unit = "1/s", .range = "[0, inf)",
     .when = "/contact.law:stiffness & /contact.damping:given", .required = true,
     AT(struct scene_pair, gamma_n), .help = "normal damping per unit of effective mass", .example = "50"},
    {.key = "gamma_n", .type = SCHEMA_REAL, .unit = "1/s/m", .range = "[0, inf)",
     .when = "/contact.law:moduli & /contact.damping:given", .required = true,
     AT(struct scene_pair, gamma_n), .help = "normal damping per unit of effective mass and of contact radius",
     .example = "5e5"},
    {.key = "gamma_t", .type = SCHEMA_REAL, .unit = "1/s", .range = "[0, inf)",
     .when = "/contact.law:stiffness & /contact.damping:given & /contact.tangential:friction",
     AT(struct scene_pair, gamma_t),
     .help = "tangential damping per unit of effective mass; left out: half of gamma_n", .example = "25"},
    {.key = "gamma_t", .type = SCHEMA_REAL, .unit = "1/s/m", .range = "[0, inf)",
     .when = "/contact.law:moduli & /contact.damping:given & /contact.tangential:friction",
     AT(struct scene_pair, gamma_t),
     .help = "tangential damping per unit of effective mass and of contact radius; left out: half of gamma_n",
     .example = "2.5e5"},
    {.key = "k_2", .type = SCHEMA_REAL, .unit = "N/m", .range = "(0, inf)", .when = "/contact.law:hysteresis", .required = true,
     AT(struct scene_pair, extra.k_2), .help = "stiffness of the unloading branch, more than k_n", .example = "5e5"},
    {.key = "k_c", .type = SCHEMA_REAL, .unit = "N/m", .range = "[0, inf)", .when = "/contact.law:hysteresis", .fallback = "0",
     AT(struct scene_pair, extra.k_c), .help = "slope of the adhesive branch", .example = "1e5"},
    {.key = "parameters", .type = SCHEMA_REALS, .when = "/contact.law:file", ARRAY_AT(struct scene_pair, extra.parameter, extra.parameters),
     .help = "numbers that a law of your own takes, in the scene's units", .example = "[1e9, 0.5]"},
    {.key = "yield_pressure", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", .when = "/contact.law:yield", .required = true,
     AT(struct scene_pair, extra.yield_pressure), .help = "pressure in the middle of the contact at which it flows", .example = "100 MPa"},
    {.key = "plasticity_ratio", .type = SCHEMA_REAL, .range = "[0, 1)", .when = "/contact.law:compaction", .required = true,
     AT(struct scene_pair, extra.plasticity_ratio), .help = "lambda_p = 1 - k_1/k_2: 0 is elastic, near 1 nearly all of the overlap stays", .example = "0.5"},
    {.key = "adhesion_energy", .type = SCHEMA_REAL, .unit = "J/m2", .range = "[0, inf)", .when = "/contact.law:compaction", .fallback = "0",
     AT(struct scene_pair, extra.adhesion_energy), .help = "delta gamma: the pull of a pressed contact is up to 3/2 pi delta gamma times the radius of its dent", .example = "1 J/m2"},
    {.key = "adhesion_exponent", .type = SCHEMA_REAL, .range = "(0, inf)", .when = "/contact.law:compaction", .fallback = "1.5",
     AT(struct scene_pair, extra.adhesion_exponent), .help = "chi: how fast the pull falls as the contact is pulled apart", .example = "5"},
    {.key = "pull_off", .type = SCHEMA_REAL, .unit = "N", .range = "[0, inf)", .when = "/contact.law:compaction", .fallback = "0",
     AT(struct scene_pair, extra.pull_off), .help = "constant pull while the surfaces touch", .example = "1e-6"},
    {.key = "plasticity_depth", .type = SCHEMA_REAL, .range = "[0, inf)", .when = "/contact.law:hysteresis", .fallback = "0",
     AT(struct scene_pair, extra.plasticity_depth),
     .help = "sets the overlap from which the unloading branch is as steep as k_2, over 2 R*; 0: any overlap", .example = "0.05"},
    {.key = "static_friction", .type = SCHEMA_REAL, .range = "[0, inf)", .when = "/contact.tangential:friction",
     .fallback = "0", AT(struct scene_pair, extra.static_friction),
     .help = "coefficient of friction of a contact that sticks; at most `friction`: the same as that", .example = "0.5"},
    LAW_DAMPING_TABLE(DAMPING_KEYS) LAW_COHESION_PARTS(COHESION_KEYS) LAW_ROLLING_PARTS(ROLLING_KEYS) LAW_TWISTING_PARTS(TWISTING_KEYS)
};
const struct schema_table schema_pair = TABLE(pair_rows);

#define LAW_SCHEMA_NAME(NAME, name, traits, summary) {#name, LAW_##NAME, summary " [" traits "]"},
static const struct schema_name law_names[] = {LAW_TABLE(LAW_SCHEMA_NAME) {0}};
#undef LAW_SCHEMA_NAME

static const char *law_traits(int law) {
    return law_row_get((enum law_normal)law)->traits;
}

/* Names of the parts of a law, and with laws of which traits they combine. */
#define PART_COHESION(NAME, name, with, summary) {#name, LAW_COHESION_##NAME, summary " [" with "]"},
static const struct schema_name cohesion_names[] = {LAW_COHESION_TABLE(PART_COHESION) {0}};
#define PART_DAMPING(NAME, name, with, summary) {#name, LAW_DAMPING_##NAME, summary " [" with "]"},
static const struct schema_name damping_names[] = {LAW_DAMPING_TABLE(PART_DAMPING) {0}};
#define PART_TANGENTIAL(NAME, name, with, summary) {#name, LAW_TANGENTIAL_##NAME, summary " [" with "]"},
static const struct schema_name tangential_names[] = {LAW_TANGENTIAL_TABLE(PART_TANGENTIAL) {0}};
#define PART_ROLLING(NAME, name, with, summary) {#name, LAW_ROLLING_##NAME, summary " [" with "]"},
static const struct schema_name rolling_names[] = {LAW_ROLLING_TABLE(PART_ROLLING) {0}};
#define PART_TWISTING(NAME, name, with, summary) {#name, LAW_TWISTING_##NAME, summary " [" with "]"},
static const struct schema_name twisting_names[] = {LAW_TWISTING_TABLE(PART_TWISTING) {0}};

static const char *tangential_traits(int tangential) {
    return tangential == LAW_TANGENTIAL_NONE ? "" : "friction";
}

static const char *rolling_traits(int rolling) {
    return rolling == LAW_ROLLING_NONE ? "" : "resists";
}

static const char *damping_traits(int damping) {
    const struct law_damping_form *form = law_damping_form_of((enum law_damping)damping);
    return form->given ? "given" : form->restitution ? "scaled restitution" : "scaled";
}

static const struct schema_name jkr_end_names[] = {
    {"distance", LAW_JKR_END_DISTANCE, "at the pull-off distance, where no equilibrium is left"},
    {"force", LAW_JKR_END_FORCE, "at the largest pull, as in LAMMPS"},
    {0}};

static const struct schema_row cohesion_rows[] = {
    {.key = "law", .type = SCHEMA_NAME, .names = cohesion_names, .fallback = "none",
     AT(struct law_options, cohesion), .help = "the cohesive force"},
    {.key = "end", .type = SCHEMA_NAME, .names = jkr_end_names, .fallback = "distance",
     .when = "/contact.cohesion.law=jkr", AT(struct law_options, jkr_end),
     .help = "where a contact breaks as it is pulled apart"},
};
static const struct schema_table cohesion_table = TABLE(cohesion_rows);

static const struct schema_name end_names[] = {
    {"overlap", LAW_END_OVERLAP,
     "when the surfaces part: the damper pulls just before, and friction counts this pull, too, as in LAMMPS"},
    {"force", LAW_END_FORCE, "when the force would pull: dampers never attract"},
    {0}};
static const struct schema_name sliding_names[] = {
    {"series", LAW_SLIDING_SERIES, "the change of the spring alone: slider in series, no energy from nothing"},
    {"total", LAW_SLIDING_TOTAL, "all of the slip; the spring takes the rest of the limit, as in LAMMPS"},
    {0}};
static const struct schema_row contact_rows[] = {
    {.key = "law", .type = SCHEMA_NAME, .names = law_names, .fallback = LAW_NORMAL_DEFAULT_NAME,
     .traits = law_traits, .file_key = "law_file", .file_name = LAW_GIVEN_NAME, AT(struct law_options, normal), .help = "the normal force, or {file: PATH} for a law of your own; in brackets its traits, which parts of a law ask for"},
    {.key = "law_file", .type = SCHEMA_PATH, .when = "/contact.law:file", .required = true, AT(struct law_options, file),
     .help = "the C file of a law of your own (docs/user-law.md); `law: {file: mylaw.c}` is the short form", .example = "mylaw.c"},
#define PHYSICS_SECTION(name, section, whose, summary)                                                           \
    {.key = "solver", .type = SCHEMA_SECTION, .sub = &name##_schema, .optional = true, .main = "name",           \
     .offset = offsetof(struct scene, physics[PHYSICS_##name]) - offsetof(struct scene, law),                \
     .count_offset = offsetof(struct scene, physics_given[PHYSICS_##name]) - offsetof(struct scene, law), .help = summary},
    PHYSICS_CONTACT_TABLE(PHYSICS_SECTION)
#undef PHYSICS_SECTION
    {.key = "damping", .type = SCHEMA_NAME, .names = damping_names, .fallback = LAW_DAMPING_DEFAULT_NAME, .traits = damping_traits,
     AT(struct law_options, damping), .help = "source of the damping"},
    {.key = "end", .type = SCHEMA_NAME, .names = end_names, .fallback = "force",
     AT(struct law_options, end), .help = "the end of a contact; both ends give the given restitution; left out beside lammps_history or lammps_granular: overlap"},
    {.key = "tangential", .type = SCHEMA_NAME, .names = tangential_names, .fallback = "history", .traits = tangential_traits,
     AT(struct law_options, tangential), .help = "the tangential force"},
    {.key = "sliding", .type = SCHEMA_NAME, .names = sliding_names, .fallback = "series",
     .when = "/contact.tangential:friction", AT(struct law_options, sliding),
     .help = "the slip that the tangential damper sees while a contact slides"},
    {.key = "rolling", .type = SCHEMA_NAME, .names = rolling_names, .fallback = "none", .traits = rolling_traits,
     .when = "/contact.tangential:friction", AT(struct law_options, rolling), .help = "resistance to rolling"},
    {.key = "twisting", .type = SCHEMA_NAME, .names = twisting_names, .fallback = "none",
     .when = "/contact.tangential:friction", AT(struct law_options, twisting),
     .help = "resistance to turning about the normal"},
    {.key = "cohesion", .type = SCHEMA_SECTION, .sub = &cohesion_table, .main = "law",
     .help = "what pulls particles together, and in brackets with laws of which traits it combines; friction's limit then counts what presses the surfaces, without the pull (docs/physics.md)"},
    {.key = "tangential_damping_ratio", .type = SCHEMA_REAL, .range = "[0, inf)", .fallback = "1",
     .when = "/contact.damping:scaled & /contact.tangential:friction", AT(struct law_options, tangential_damping_ratio),
     .help = "tangential damping; 1: the same damping ratio as that of the normal spring"},
    {.key = "tangential_damping_equal", .type = SCHEMA_BOOL, .fallback = "false",
     .when = "/contact.damping:scaled & /contact.tangential:friction", AT(struct law_options, tangential_damping_equal),
     .help = "the tangential damping coefficient equals the normal one, as in LAMMPS's pair_style granular"},
    {.key = "lammps_history", .alias = "lammps_hooke", .type = SCHEMA_BOOL, .fallback = "false",
     AT(struct law_options, lammps_history),
     .help = "exactly gran/hooke/history or gran/hertz/history of LAMMPS, for comparisons; the lever is then the radius; takes end: overlap; needs "
             "damping: coefficient, rolling: none and integrator: velocity_verlet"},
    {.key = "lammps_granular", .type = SCHEMA_BOOL, .fallback = "false", AT(struct law_options, lammps_granular),
     .help = "exactly pair_style granular of LAMMPS, and wall/gran granular at walls, for comparisons; the lever of the slip is the radius, at walls that of the torque, too; takes end: overlap; needs integrator: velocity_verlet"},
};
const struct schema_table schema_contact = TABLE(contact_rows);
/* clang-format on */
