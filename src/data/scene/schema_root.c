/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: the top level, box, step, index, classes, ghosts, domain, guards. */
#include "data/scene/scene.h"
#include "data/scene/schema_root.h"
#include "data/scene/schema_sections.h"
#include "data/scene/schema_output.h"
#include "data/scene/schema_particles.h"

/* One row a key, packed to the line: */
/* clang-format off */

static const struct schema_name units_names[] = {
    {"si", SCENE_UNITS_SI,
     "numbers are in m, kg, s; another unit may follow a number: 5 mm, 2 GPa"},
    {"none", SCENE_UNITS_NONE, "dimensionless: a unit after a number is an error"},
    {0}};
static const struct schema_name leave_names[] = {{"keep", BOX_KEEP, "the particle flies on outside"},
                                                 {"delete", BOX_DELETE, "the particle is removed"},
                                                 {"error", BOX_ERROR, "the run stops with a message"},
                                                 {0}};

static const struct schema_row leave_rows[] = {
    {.key = "all", .type = SCHEMA_NAME, .names = leave_names, .fallback = "keep", AT(struct scene, leave_all),
     .help = "all open sides without a key of their own", .example = "delete"},
    {.key = "x_lower", .type = SCHEMA_NAME, .names = leave_names, AT(struct scene, leave_side[0][0]),
     .help = "the side at the lower end of x"},
    {.key = "x_upper", .type = SCHEMA_NAME, .names = leave_names, AT(struct scene, leave_side[0][1]),
     .help = "the side at the upper end of x"},
    {.key = "y_lower", .type = SCHEMA_NAME, .names = leave_names, AT(struct scene, leave_side[1][0]),
     .help = "the side at the lower end of y"},
    {.key = "y_upper", .type = SCHEMA_NAME, .names = leave_names, AT(struct scene, leave_side[1][1]),
     .help = "the side at the upper end of y"},
    {.key = "z_lower", .type = SCHEMA_NAME, .names = leave_names, AT(struct scene, leave_side[2][0]),
     .help = "the side at the lower end of z"},
    {.key = "z_upper", .type = SCHEMA_NAME, .names = leave_names, AT(struct scene, leave_side[2][1]),
     .help = "the side at the upper end of z"},
};
static const struct schema_table leave_table = TABLE(leave_rows);

static const struct schema_name direction_names[] = {{"x", 0, NULL}, {"y", 1, NULL}, {"z", 2, NULL}, {0}};

static const struct schema_row shear_rows[] = {
    {.key = "rate", .type = SCHEMA_REAL, .unit = "1/s", .required = true, AT(struct scene, shear.rate),
     .help = "change of the mean velocity along the gradient; 0 keeps the offset that a checkpoint has. Where box.stress has a target of the shear stress: the rate at the start", .example = "10 1/s"},
    {.key = "flow", .type = SCHEMA_NAME, .names = direction_names, .fallback = "x", AT(struct scene, shear.flow),
     .help = "direction of the mean velocity"},
    {.key = "gradient", .type = SCHEMA_NAME, .names = direction_names, .fallback = "y", AT(struct scene, shear.gradient),
     .help = "direction in which the mean velocity changes"},
    {.key = "offset", .type = SCHEMA_REAL, .unit = "m", .fallback = "0", AT(struct scene, shear.offset),
     .help = "displacement of the image one edge up the gradient along the flow, at the start"},
    {.key = "profile", .type = SCHEMA_BOOL, .fallback = "true", AT(struct scene, shear.profile),
     .help = "particles start with the mean velocity in addition to their own; off: the shear spreads from the boundaries"},
};
static const struct schema_table shear_table = TABLE(shear_rows);

static const struct schema_row strain_rows[] = {
    {.key = "rate", .type = SCHEMA_VECTOR, .unit = "1/s", .required = true, AT(struct scene, strain.rate),
     .help = "change of each edge over its length: negative in compression, equal for an isotropic strain, one alone for a uniaxial "
             "strain; the lower corner stays", .example = "[0, 0, -0.1 1/s]"},
    {.key = "profile", .type = SCHEMA_BOOL, .fallback = "true", AT(struct scene, strain.profile),
     .help = "particles start with the velocity of the mean flow in addition to their own"},
};
static const struct schema_table strain_table = TABLE(strain_rows);

static const struct schema_row stress_rows[] = {
    {.key = "pressure", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", AT(struct scene, stress.pressure),
     .help = "target of the mean normal stress; all edges change alike. In two dimensions a force over a length", .example = "1 kPa"},
    {.key = "xx", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", AT(struct scene, stress.normal[0]),
     .help = "instead of pressure: target of the normal stress along x; the edge along x changes", .example = "1 kPa"},
    {.key = "yy", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", AT(struct scene, stress.normal[1]),
     .help = "the same along y", .example = "1 kPa"},
    {.key = "zz", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", AT(struct scene, stress.normal[2]),
     .help = "the same along z", .example = "1 kPa"},
    {.key = "xy", .type = SCHEMA_REAL, .unit = "Pa", AT(struct scene, stress.shear[0]),
     .help = "target of the shear stress; the box shears along x with the gradient along y, unless box.shear names them the other way "
             "round. A negative stress shears at a positive rate. One of xy, xz, yz; alone, or with pressure or normal stresses", .example = "-200 Pa"},
    {.key = "xz", .type = SCHEMA_REAL, .unit = "Pa", AT(struct scene, stress.shear[1]),
     .help = "the same along x with the gradient along z", .example = "-200 Pa"},
    {.key = "yz", .type = SCHEMA_REAL, .unit = "Pa", AT(struct scene, stress.shear[2]),
     .help = "the same along y with the gradient along z", .example = "-200 Pa"},
    {.key = "inertia", .type = SCHEMA_REAL, .fallback = "0.01", .range = "(0, inf)", AT(struct scene, stress.inertia),
     .help = "bound on the rates of edges and of the shear, times the mean diameter and the root of particle density over target: small numbers "
             "are quasi-static. The bound of the shear takes the mean normal stress, if that is larger than its target"},
};
static const struct schema_table stress_table = TABLE(stress_rows);

static const struct schema_name density_names[] = {
    {"volume", BOX_DENSITY_VOLUME, "mass of a sphere over its volume, in two dimensions too"},
    {"area", BOX_DENSITY_AREA, "in two dimensions: mass over the area pi r2 of a disc, in kg/m2"},
    {0}};

static const struct schema_row box_rows[] = {
    {.key = "dimension", .type = SCHEMA_INT, .fallback = "3", .range = "[2, 3]",
     AT(struct scene, box.dimension),
     .help = "2: centres stay in the middle plane of z, and particles turn about z alone"},
    {.key = "density", .type = SCHEMA_NAME, .names = density_names, .fallback = "volume", AT(struct scene, box.density),
     .help = "what `density` means in materials, sources and insertions"},
    {.key = "lower", .type = SCHEMA_VECTOR, .unit = "m", AT(struct scene, box_lower),
     .help = "lower corner; may be left out, with upper, if the first particle file has a box",
     .example = "[0, 0, 0]"},
    {.key = "upper", .type = SCHEMA_VECTOR, .unit = "m", AT(struct scene, box_upper), .help = "upper corner",
     .example = "[10 cm, 10 cm, 20 cm]"},
    {.key = "periodic", .type = SCHEMA_BOOLS, .fallback = "false", AT(struct scene, box.periodic),
     .help = "periodic directions; the other directions are open. Left out, with lower and upper: the periodic directions of the file",
     .example = "[true, true, false]"},
    {.key = "leave", .type = SCHEMA_SECTION, .sub = &leave_table, .main = "all",
     .help = "treatment of a particle whose centre leaves through an open side"},
    {.key = "shear", .type = SCHEMA_SECTION, .sub = &shear_table, .optional = true, .main = "rate",
     .offset = 0, .count_offset = offsetof(struct scene, shear_given),
     .help = "homogeneous shear across Lees-Edwards boundaries: both directions periodic, no walls, groups, insertions or fluid"},
    {.key = "strain", .type = SCHEMA_SECTION, .sub = &strain_table, .optional = true,
     .offset = 0, .count_offset = offsetof(struct scene, strain_given),
     .help = "edges of periodic directions that grow or shrink at a given rate"},
    {.key = "stress", .type = SCHEMA_SECTION, .sub = &stress_table, .optional = true, .main = "pressure",
     .offset = 0, .count_offset = offsetof(struct scene, stress_given),
     .help = "edges of periodic directions, and the shear, that change until the stress has its target; the program finds the gains"},
};
static const struct schema_table box_table = TABLE(box_rows);

static const struct schema_row step_rows[] = {
    {.key = "dt", .type = SCHEMA_REAL, .unit = "s", .range = "(0, inf)", AT(struct scene_step, dt),
     .help = "time step; refused above the stable step unless step.force is set", .example = "0.5 us"},
    {.key = "fraction", .type = SCHEMA_REAL, .range = "(0, inf)", AT(struct scene_step, fraction),
     .help = "instead of dt: the step as a fraction of the stable step; without dt and fraction, the default fraction that `scree "
             "check` prints", .example = "0.5"},
    {.key = "count", .type = SCHEMA_LONG, .range = "[0, inf)", AT(struct scene_step, count),
     .help = "number of steps, unless duration is given", .example = "1000"},
    {.key = "force", .type = SCHEMA_BOOL, .fallback = "false", AT(struct scene_step, force),
     .help = "run even if the step is above the stable step"},
    {.key = "contacts", .type = SCHEMA_INT, .fallback = "0", .range = "[0, 100]",
     AT(struct scene_step, contacts),
     .help = "contacts at a time of a particle with particles of its own size and material, for the stable step; a larger "
             "particle counts with more contacts; 0: 12, or 6 in two dimensions"},
    {.key = "speed_max", .type = SCHEMA_REAL, .unit = "m/s", .fallback = "0", .range = "[0, inf)",
     AT(struct scene_step, speed_max),
     .help = "largest impact speed expected, for the stable step; 0: the largest speed of the particles at the start, or the "
             "speed of a fall through the box in directions that are not periodic, if that speed is larger"},
    {.key = "fused", .type = SCHEMA_BOOL, .fallback = "true", AT(struct scene_step, fused),
     .help = "move particles just before their first contact, while the particles are in the cache; off: pass after pass, with "
             "the same results"},
    {.key = "rebuild_every", .type = SCHEMA_LONG, .fallback = "0", .range = "[0, inf)",
     AT(struct scene_step, rebuild_every),
     .help = "rebuild the pair list at least every so many steps; 0: only when the skin is used up"},
};
static const struct schema_table step_table = TABLE(step_rows);

static const struct schema_name simd_names[] = {
    {"auto", SCENE_SIMD_AUTO, NULL},
    {"baseline", SCENE_SIMD_BASELINE, "the instructions that every CPU of the architecture has"},
    {"x86-64-v3", SCENE_SIMD_V3, "AVX2"},
    {"x86-64-v4", SCENE_SIMD_V4, "AVX-512"},
    {0}};
static const char *index_choice(int k, const char **help) {
    if (k >= index_registry_count())
        return NULL;
    *help = index_registry_get(k)->summary;
    return index_registry_get(k)->name;
}

static const char *integrator_choice(int k, const char **help) {
    if (k >= integrator_count())
        return NULL;
    *help = integrator_get(k)->summary;
    return integrator_get(k)->name;
}

static const struct schema_name cross_names[] = {
    {"auto", INDEX_CROSS_AUTO, "the side that costs less, level by level"},
    {"smaller", INDEX_CROSS_SMALLER, "each smaller particle searches among the larger ones"},
    {"larger", INDEX_CROSS_LARGER, "each larger particle searches among the smaller ones"},
    {0}};
static const struct schema_row index_rows[] = {
    {.key = "name", .type = SCHEMA_CHOICE, .choice = index_choice, .fallback = "auto",
     AT(struct scene_index, name), .help = "method of the search for pairs; all methods find the same pairs"},
    {.key = "cell_factor", .type = SCHEMA_REAL, .range = "[0, 1000]", .fallback = "0",
     AT(struct scene_index, params.cell_factor),
     .help = "cell edge as a multiple of the cut-off that the index builds on; 0: the default of the index",
     .example = "0.5"},
    {.key = "cross_search", .type = SCHEMA_NAME, .names = cross_names, .fallback = "auto",
     AT(struct scene_index, params.cross_search),
     .help = "the side that searches for pairs of different levels; the pairs are the same"},
    {.key = "measure", .type = SCHEMA_BOOL, .fallback = "no", .when = "name=auto", AT(struct scene_index, measure),
     .help = "yes: the first rebuilds measure the time of variants of the choice, and auto keeps the fastest; then no two runs "
             "are bitwise equal"},
    {.key = "levels", .type = SCHEMA_INT, .range = "[0, 32]", .fallback = "0", .when = "name=hgrid",
     AT(struct scene_index, params.levels), .help = "number of levels; 0: one for each size class"},
    {.key = "level_cells", .type = SCHEMA_REALS, .unit = "m", .range = "[0, inf)", .when = "name=hgrid",
     ARRAY_AT(struct scene_index, params.level_cell, level_cells),
     .help = "cell edge of each level, from small to large; 0: by cell_factor", .example = "[2 mm, 20 mm]"},
};
static const struct schema_table index_table = TABLE(index_rows);

static const struct schema_name classes_names[] = {
    {"auto", CLASSES_AUTO, "the classes with which the search costs least; sizes that differ by a factor of 1.5 have classes of their own"},
    {"one", CLASSES_ONE, "all sizes in one class"},
    {"cuts", CLASSES_CUTS, "classes between the radii in classes.cuts"},
    {"quantiles", CLASSES_QUANTILES, "classes.count classes with equal numbers of particles"},
    {"geometric", CLASSES_GEOMETRIC, "classes.count classes with a constant ratio of radii"},
    {0}};
static const struct schema_row classes_rows[] = {
    {.key = "method", .type = SCHEMA_NAME, .names = classes_names, .fallback = "auto",
     AT(struct classes_options, method),
     .help = "division of the particles into size classes; materials play no part"},
    {.key = "count", .type = SCHEMA_INT, .range = "[1, 32]", .required = true,
     .when = "method=quantiles|geometric", AT(struct classes_options, count), .help = "number of classes",
     .example = "4"},
    {.key = "cuts", .type = SCHEMA_REALS, .unit = "m", .range = "(0, inf)", .required = true,
     .when = "method=cuts", .offset = offsetof(struct classes_options, cut), .size = sizeof(double),
     .max = CLASS_MAX - 1, .count_offset = offsetof(struct classes_options, cut_count),
     .help = "radii that separate the classes, increasing", .example = "[1.5 mm, 6 mm]"},
};
static const struct schema_table classes_table = TABLE(classes_rows);

static const struct schema_row skin_rows[] = {
    {.key = "relative", .type = SCHEMA_REAL, .range = "(0, 10]", .fallback = "0.3",
     AT(struct classes_options, skin_relative),
     .help = "skin of a pair of classes as a multiple of the smaller class's smallest radius"},
    {.key = "length", .type = SCHEMA_REAL, .unit = "m", .range = "[0, inf)", AT(struct classes_options, skin),
     .help = "instead of relative: one length for all pairs", .example = "0.3 mm"},
    {.key = "auto", .type = SCHEMA_BOOL, .fallback = "false", AT(struct classes_options, skin_auto),
     .help = "the run multiplies this skin by the factor, 1/16 to 8, with which filtering and finding pairs costs least; `skin: auto` means this, too"},
};
static const struct schema_table skin_table = TABLE(skin_rows);

static const struct schema_name ghosts_names[] = {
    {"auto", SCENE_GHOSTS_AUTO, "reduced with newton: on, else full"},
    {"full", SCENE_GHOSTS_FULL, "every copy that any partner might need"},
    {"reduced", SCENE_GHOSTS_REDUCED, "small particles travel only as far as small partners; needs newton: on"},
    {0}};
static const struct schema_name domain_names[] = {
    {"brick", DOMAIN_BRICK, "equal bricks, in the grid that suits the particles at the start"},
    {"bisection", DOMAIN_BISECTION, "recursive bisection that follows the load, by Zoltan"},
    {0}};
static const struct schema_name weights_names[] = {
    {"pairs", DOMAIN_WEIGHTS_PAIRS, "1, and a half for each pair of the particle"},
    {"time", DOMAIN_WEIGHTS_TIME, "as pairs, scaled by the time that the rank took"},
    {"particles", DOMAIN_WEIGHTS_PARTICLES, "1"},
    {0}};
static const struct schema_row domain_rows[] = {
    {.key = "name", .type = SCHEMA_NAME, .names = domain_names, .fallback = "brick",
     AT(struct scene, domain.kind), .help = "form of the division"},
    {.key = "weights", .type = SCHEMA_NAME, .names = weights_names, .fallback = "pairs", .when = "name=bisection",
     AT(struct scene, domain.weights), .help = "the weight of a particle in its rank's load"},
    {.key = "threshold", .type = SCHEMA_REAL, .range = "[0, inf)", .fallback = "1.1", .when = "name=bisection",
     AT(struct scene, domain.threshold),
     .help = "a rebuild divides the box again if the largest load exceeds the mean load by this factor; 0: never"},
    {.key = "x", .type = SCHEMA_INT, .range = "[0, inf)", .fallback = "0", .when = "name=brick",
     AT(struct scene, domain.grid[0]),
     .help = "ranks along x; 0: the program chooses"},
    {.key = "y", .type = SCHEMA_INT, .range = "[0, inf)", .fallback = "0", .when = "name=brick",
     AT(struct scene, domain.grid[1]),
     .help = "ranks along y; 0: the program chooses"},
    {.key = "z", .type = SCHEMA_INT, .range = "[0, inf)", .fallback = "0", .when = "name=brick",
     AT(struct scene, domain.grid[2]),
     .help = "ranks along z; 0: the program chooses"},
};
static const struct schema_table domain_table = TABLE(domain_rows);
static const struct schema_name sync_names[] = {
    {"auto", GHOSTS_AUTO, "neighbours if every particle fits, else shadow; the report shows the choice and the reason"},
    {"neighbours", GHOSTS_NEIGHBOURS,
     "copies go to neighbouring subdomains alone; the program refuses a particle that reaches farther"},
    {"shadow", GHOSTS_SHADOW, "copies spread from neighbour to neighbour: no limit on the size of a particle"},
    {0}};

static const struct schema_name guard_names[] = {
    {"stop", SCENE_GUARD_STOP, "stop, after a checkpoint for inspection"},
    {"warn", SCENE_GUARD_WARN, "one warning, then the run goes on"},
    {"off", SCENE_GUARD_OFF, NULL},
    {0}};
static const struct schema_name energy_names[] = {
    {"auto", SCENE_GUARD_AUTO,
     "stop if kinetic + elastic + gravity - work of walls has grown by ten times energy_bound, checked every 100 steps; "
             "no check if a group has motion: moving"},
    {"stop", SCENE_GUARD_STOP, "stop, after a checkpoint for inspection; checked every 20 steps, dissipation included"},
    {"warn", SCENE_GUARD_WARN, "one warning, then the run goes on; checked like stop"},
    {"off", SCENE_GUARD_OFF, NULL},
    {0}};
static const struct schema_name nan_names[] = {
    {"stop", SCENE_GUARD_STOP, "always, because no search is possible with such places"}, {0}};
static const struct schema_row guards_rows[] = {
    {.key = "overlap", .type = SCHEMA_NAME, .names = guard_names, .fallback = "stop",
     AT(struct scene_guards, overlap), .help = "an overlap beyond guards.overlap_bound"},
    {.key = "overlap_bound", .type = SCHEMA_REAL, .range = "(0, 2]", .fallback = "0.5",
     AT(struct scene_guards, overlap_bound),
     .help = "largest overlap allowed, as a part of the smaller radius"},
    {.key = "nan", .type = SCHEMA_NAME, .names = nan_names, .fallback = "stop",
     AT(struct scene_guards, nan), .help = "a position, velocity, spin, temperature, energy or force that is not finite"},
    {.key = "speed", .type = SCHEMA_NAME, .names = guard_names, .fallback = "stop",
     AT(struct scene_guards, speed),
     .help = "a particle that moves by more than the smallest radius in a step: such a particle may pass through others unseen"},
    {.key = "step", .type = SCHEMA_NAME, .names = guard_names, .fallback = "warn",
     AT(struct scene_guards, step),
     .help = "contacts so many or so stiff that the step is more than 0.9 of the step that is surely stable, checked every 500 "
             "steps; a step given as a fraction is then shortened, unless this guard is off"},
    {.key = "energy", .type = SCHEMA_NAME, .names = energy_names, .fallback = "auto",
     AT(struct scene_guards, energy),
     .help = "growth of energy without cause: kinetic + elastic + gravity + dissipated - work of walls, without the energy of "
             "particles that came or went; stop and warn cost the energy sums at each step"},
    {.key = "energy_bound", .type = SCHEMA_REAL, .range = "(0, inf)", .fallback = "0.05",
     AT(struct scene_guards, energy_bound),
     .help = "largest growth allowed, as a part of the largest energy in play"},
    {.key = "residual", .type = SCHEMA_NAME, .names = guard_names, .fallback = "warn",
     AT(struct scene_guards, residual),
     .help = "a solve for a fluid, or for contacts, whose residual is above ten times its tolerance; a solver of a fluid that "
             "does not converge always stops the run"},
};
static const struct schema_table guards_table = TABLE(guards_rows);

static const struct schema_row root_rows[] = {
    {.key = "title", .type = SCHEMA_TEXT, .fallback = "", AT(struct scene, title),
     .help = "a title for people; trajectory.h5 and checkpoints hold the title, in their copy of the scene",
     .example = "ball into glass beads"},
    {.key = "units", .type = SCHEMA_NAME, .names = units_names, .fallback = "si", AT(struct scene, units),
     .help = "meaning of the numbers"},
    {.key = "seed", .type = SCHEMA_SEED, .fallback = "1", AT(struct scene, seed),
     .help = "seed of all random numbers"},
    {.key = "box", .type = SCHEMA_SECTION, .sub = &box_table, .help = "the simulation box"},
    {.key = "gravity", .type = SCHEMA_VECTOR, .unit = "m/s2", .fallback = "[0, 0, 0]",
     AT(struct scene, gravity), .help = "acceleration of free particles", .example = "[0, 0, -9.81]"},
    {.key = "duration", .type = SCHEMA_REAL, .unit = "s", .range = "[0, inf]", AT(struct scene, duration),
     .help = "time to simulate; .inf: until a signal ends the run; overrides step.count", .example = "0.1 s"},
    {.key = "stages", .type = SCHEMA_LIST, .sub = &schema_stages, ARRAY_AT(struct scene, stage, stages),
     .help = "phases of the run, one after another, each with an end and with changes of the scene; instead of duration and "
             "step.count. Each end writes a checkpoint"},
    {.key = "step", .type = SCHEMA_SECTION, .sub = &step_table, .offset = offsetof(struct scene, step),
     .help = "the time step"},
    {.key = "integrator", .type = SCHEMA_CHOICE, .choice = integrator_choice,
     .fallback = "synchronised_verlet", AT(struct scene, integrator), .help = "the scheme that integrates the motion"},
    {.key = "threads", .type = SCHEMA_INT, .range = "[0, 255]", .fallback = "0", AT(struct scene, threads),
     .help = "threads of a rank; 0: OMP_NUM_THREADS, or the rank's share of the cores that the ranks of its machine may use; then "
             "fewer threads work at a time if other programs use the cores (with the same results)"},
    {.key = "simd", .type = SCHEMA_NAME, .names = simd_names, .fallback = "auto", AT(struct scene, simd),
     .help = "vector instructions of search and forces; auto: the widest that the CPU has. Pairs and forces are the same"},
    {.key = "contact", .type = SCHEMA_SECTION, .sub = &schema_contact, .main = "law",
     .offset = offsetof(struct scene, law), .help = "the contact law, of walls too"},
    {.key = "materials", .type = SCHEMA_LIST, .sub = &schema_material,
     ARRAY_AT(struct scene, material, materials),
     .help = "materials of particles and walls; may be left out if the scene has another physics: then nothing touches"},
    {.key = "material_pairs", .type = SCHEMA_LIST, .sub = &schema_pair,
     LIST_AT(struct scene, pair, pairs, SCENE_PAIRS_MAX),
     .help = "coefficients of each pair of materials that may meet, a material with itself included"},
    {.key = "groups", .type = SCHEMA_LIST, .sub = &schema_group, .first = 1,
     ARRAY_AT(struct scene, group, groups),
     .help = "particles that do not move freely; the group `free` always exists"},
    {.key = "walls", .type = SCHEMA_LIST, .sub = &schema_wall, LIST_AT(struct scene, wall, walls, WALLS_MAX),
     .help = "planes, cylinders and triangle meshes"},
    {.key = "particles", .type = SCHEMA_SECTION, .sub = &schema_particles,
     .help = "the sources of the particles; the keys of a single source may stand here directly"},
    {.key = "insertions", .type = SCHEMA_LIST, .sub = &schema_insertion,
     LIST_AT(struct scene, insertion, insertions, INSERTIONS_MAX),
     .help = "regions in which particles appear during the run"},
    {.key = "deletions", .type = SCHEMA_LIST, .sub = &schema_deletion,
     LIST_AT(struct scene, deletion, deletions, DELETIONS_MAX), .help = "regions in which particles disappear"},
    {.key = "index", .type = SCHEMA_SECTION, .sub = &index_table, .main = "name",
     .offset = offsetof(struct scene, index), .help = "the search for pairs"},
    {.key = "classes", .type = SCHEMA_SECTION, .sub = &classes_table, .main = "method",
     .offset = offsetof(struct scene, classes), .help = "size classes"},
    {.key = "skin", .type = SCHEMA_SECTION, .sub = &skin_table, .main = "length", .flag = "auto",
     .offset = offsetof(struct scene, classes),
     .help = "distance beyond the range up to which pairs are kept, so that the search need not run at every step"},
    {.key = "newton", .type = SCHEMA_BOOL, .fallback = "true", AT(struct scene, ghosts.newton),
     .help = "on: a pair across ranks is computed once, and its force sent back; off: the pair is computed on both sides"},
    {.key = "ghosts", .type = SCHEMA_NAME, .names = ghosts_names, .fallback = "auto",
     AT(struct scene, ghosts_name), .help = "the copies that a rank gets"},
    {.key = "reproducible", .type = SCHEMA_BOOL, .fallback = "false", AT(struct scene, reproducible),
     .help = "the same bits on any index, ranks, threads, domain and sync: forces are summed in the order of the partner's id, "
             "and pairs across ranks are computed on both sides (as with newton: off and ghosts: full, whatever these keys say)"},
    {.key = "domain", .type = SCHEMA_SECTION, .sub = &domain_table, .main = "name",
     .help = "the division of the box among ranks"},
    {.key = "sync", .type = SCHEMA_NAME, .names = sync_names, .fallback = "auto",
     AT(struct scene, ghosts.sync), .help = "the way by which copies reach the ranks that need copies"},
    {.key = "guards", .type = SCHEMA_SECTION, .sub = &guards_table, .offset = offsetof(struct scene, guards),
     .help = "reactions to physical nonsense"},
    {.key = "output", .type = SCHEMA_SECTION, .sub = &schema_output, .offset = offsetof(struct scene, output),
     .help = "files that the run writes, into the folder of -o"},
    {.key = "observables", .type = SCHEMA_SECTION, .sub = &schema_observables,
     .offset = offsetof(struct scene, output.observables),
     .help = "numbers about the run, a row at a time, in observables.csv"},
#define PHYSICS_SECTION(name, section, whose, summary)                                                           \
    {.key = #section, .type = SCHEMA_SECTION, .sub = &name##_schema, .optional = true,                       \
     .offset = offsetof(struct scene, physics[PHYSICS_##name]),                                              \
     .count_offset = offsetof(struct scene, physics_given[PHYSICS_##name]), .help = summary},
    PHYSICS_SECTION_TABLE(PHYSICS_SECTION)
#undef PHYSICS_SECTION
};
const struct schema_table schema_root = TABLE(root_rows);

const char *scene_simd_name(enum scene_simd simd) {
    return simd_names[simd].name;
}
