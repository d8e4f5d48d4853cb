/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: particle sources, size laws, regions, groups, insertion and deletion. */
#include "data/scene/scene.h"
#include "data/scene/schema_particles.h"

/* One row a key, packed to the line: */
/* clang-format off */

static const struct schema_name region_names[] = {
    {"all", REGION_ALL, "the whole box"},
    {"box", REGION_BOX, NULL},
    {"sphere", REGION_SPHERE, NULL},
    {"cylinder", REGION_CYLINDER, NULL},
    {0}};
static const struct schema_row region_rows[] = {
    {.key = "shape", .type = SCHEMA_NAME, .names = region_names, .fallback = "all", AT(struct region, shape),
     .help = "the shape"},
    {.key = "lower", .type = SCHEMA_VECTOR, .unit = "m", .when = "shape=box", .required = true,
     AT(struct region, lower), .help = "lower corner", .example = "[0, 0, 10 mm]"},
    {.key = "upper", .type = SCHEMA_VECTOR, .unit = "m", .when = "shape=box", .required = true,
     AT(struct region, upper), .help = "upper corner", .example = "[5 cm, 5 cm, 10 cm]"},
    {.key = "centre", .type = SCHEMA_VECTOR, .unit = "m", .when = "shape=sphere|cylinder", .required = true,
     AT(struct region, centre), .help = "centre of the sphere; middle of the cylinder's axis",
     .example = "[0, 0, 5 cm]"},
    {.key = "axis", .type = SCHEMA_VECTOR, .when = "shape=cylinder", .fallback = "[0, 0, 1]",
     AT(struct region, axis), .help = "direction of the axis; in two dimensions z"},
    {.key = "radius", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "shape=sphere|cylinder",
     .required = true, AT(struct region, radius), .help = "radius", .example = "2 cm"},
    {.key = "length", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "shape=cylinder",
     .required = true, AT(struct region, length), .help = "whole length along the axis", .example = "10 cm"},
};
const struct schema_table schema_region = TABLE(region_rows);

static const struct schema_name sizes_names[] = {
    {"fixed", SIZES_FIXED, "one radius"},
    {"uniform", SIZES_UNIFORM, "all radii in [min, max] equally likely"},
    {"normal", SIZES_NORMAL, "normal with mean and sigma, cut to [min, max]"},
    {"lognormal", SIZES_LOGNORMAL, "ln r normal about ln mean with width, cut to [min, max]"},
    {"power", SIZES_POWER, "number density of radii proportional to r^exponent in [min, max]"},
    {"table", SIZES_TABLE, "a sieve curve: radii, diameters or a file, and what passes"},
    {"discrete", SIZES_DISCRETE, "a few sizes with weights"},
    {0}};
static const struct schema_name by_names[] = {
    {"number", SIZES_BY_NUMBER, NULL}, {"mass", SIZES_BY_MASS, NULL}, {0}};
static const struct schema_row sizes_rows[] = {
    {.key = "law", .type = SCHEMA_NAME, .names = sizes_names, .fallback = "fixed",
     AT(struct sizes_options, law), .help = "the distribution of radii"},
    {.key = "radius", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "law=fixed",
     .required = true, AT(struct sizes_options, radius), .help = "the radius", .example = "1 mm"},
    {.key = "min", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)",
     .when = "law=uniform|normal|lognormal|power", .required = true, AT(struct sizes_options, min),
     .help = "smallest radius", .example = "0.5 mm"},
    {.key = "max", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)",
     .when = "law=uniform|normal|lognormal|power", .required = true, AT(struct sizes_options, max),
     .help = "largest radius", .example = "2 mm"},
    {.key = "mean", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "law=normal|lognormal",
     .required = true, AT(struct sizes_options, mean),
     .help = "mean radius of the normal law, median of the lognormal", .example = "1 mm"},
    {.key = "sigma", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "law=normal",
     .required = true, AT(struct sizes_options, sigma), .help = "standard deviation of the radius",
     .example = "0.1 mm"},
    {.key = "width", .type = SCHEMA_REAL, .range = "(0, inf)", .when = "law=lognormal", .required = true,
     AT(struct sizes_options, width), .help = "standard deviation of ln r", .example = "0.3"},
    {.key = "exponent", .type = SCHEMA_REAL, .when = "law=power", .required = true,
     AT(struct sizes_options, exponent),
     .help = "exponent of the number density; -3 gives equal volumes to equal ranges of radius",
     .example = "-3"},
    {.key = "by", .type = SCHEMA_NAME, .names = by_names, .fallback = "mass", .when = "law=table|discrete",
     AT(struct sizes_options, by), .help = "the quantity that passing and weights count"},
    {.key = "radii", .type = SCHEMA_REALS, .unit = "m", .range = "(0, inf)", .when = "law=table|discrete",
     ARRAY_AT(struct sizes_options, radii, points),
     .help = "half of the sieves' openings, increasing; or the sizes themselves",
     .example = "[0.5 mm, 1 mm, 2 mm]"},
    {.key = "diameters", .type = SCHEMA_REALS, .unit = "m", .range = "(0, inf)", .when = "law=table|discrete",
     ARRAY_AT(struct sizes_options, diameter, diameters),
     .help = "instead of radii: the sieves' openings, increasing; or the sizes themselves",
     .example = "[1 mm, 2 mm, 4 mm]"},
    {.key = "passing", .type = SCHEMA_REALS, .range = "[0, 100]", .when = "law=table",
     ARRAY_AT(struct sizes_options, share, values),
     .help = "part below each size, rising from 0 to 1, or to 100 (per cent)", .example = "[0, 0.4, 1]"},
    {.key = "weights", .type = SCHEMA_REALS, .range = "[0, inf)", .when = "law=discrete",
     ARRAY_AT(struct sizes_options, share, values), .help = "share of each size, normalised to their sum",
     .example = "[9, 1]"},
    {.key = "file", .type = SCHEMA_PATH, .when = "law=table|discrete", AT(struct sizes_options, file),
     .help = "instead of the lists: a file with one line for each size, of two numbers: the diameter (or the radius, "
             "if the first line reads 'radius passing' or 'radius weight') and what passes, or the weight; # begins a comment",
     .example = "gravel.txt"},
    {.key = "file_unit", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .fallback = "1",
     .when = "law=table|discrete", AT(struct sizes_options, file_unit), .help = "length of one in the file",
     .example = "1 mm"},
};
const struct schema_table schema_sizes = TABLE(sizes_rows);

static const struct schema_name kind_names[] = {
    {"file", SOURCE_FILE, "read from a file"},
    {"lattice", SOURCE_LATTICE, "on a lattice"},
    {"random", SOURCE_RANDOM, "at random places without overlap, clear of walls (random sequential addition, largest first)"},
    {"packed", SOURCE_PACKED, "at random places, then moved apart until none overlap, clear of walls: denser than random places alone"},
    {"single", SOURCE_SINGLE, "one particle"},
    {0}};
static const struct schema_name format_names[] = {
    {"lammps-data", SOURCE_LAMMPS_DATA, "LAMMPS data file, atom_style sphere"},
    {"table", SOURCE_TABLE, "numbers in columns"},
    {"h5md", SOURCE_H5MD, "H5MD, in the form that this program writes"},
    {0}};
static const struct schema_name meets_names[] = {
    {"push", SOURCE_PUSHES, "they are packed together with all other sources that push; those of a file, a lattice or a single one stay"},
    {"yield", SOURCE_YIELDS, "they are packed by themselves, and those that overlap others are then taken out; volume_fraction is that before, count that after"},
    {0}};
static const struct schema_name ids_names[] = {
    {"file", SOURCE_IDS_FILE, "the ids of the file stand; an id that another source has, too, is refused"},
    {"new", SOURCE_IDS_NEW, "new ids"},
    {0}};
static const struct schema_name lattice_names[] = {
    {"sc", SOURCE_SC, "simple cubic"},
    {"fcc", SOURCE_FCC, "face-centred cubic"},
    {"hcp", SOURCE_HCP, "hexagonal close-packed"},
    {"square", SOURCE_SQUARE, "two dimensions"},
    {"hexagonal", SOURCE_HEXAGONAL, "two dimensions"},
    {0}};

#define SOURCE(member) AT(struct source_options, member)

static const char shape_help[] =
    "name of an entry of bodies.clumps or bodies.shapes: all these particles become such bodies, whatever their material and radius; the entry's `size` says what the radii of "
    "the source are: as a rule those of spheres of the same volume. The source places the balls around the bodies, and volume_fraction counts the volume of the bodies. Left out: "
    "materials and radii choose, or the file that tells the shapes of its particles (a trajectory of bodies, a table with a column `shape`)";

static const struct schema_row source_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .fallback = "", SOURCE(name), .help = "name for messages",
     .example = "bed"},
    {.key = "from", .type = SCHEMA_NAME, .names = kind_names, .fallback = "file", SOURCE(kind),
     .help = "origin of the particles"},
    {.key = "file", .type = SCHEMA_PATH, .when = "from=file", .required = true, SOURCE(file),
     .help = "the file", .example = "packing.data"},
    {.key = "format", .type = SCHEMA_NAME, .names = format_names, .when = "from=file", .required = true,
     SOURCE(format), .help = "format of the file", .example = "table"},
    {.key = "columns", .type = SCHEMA_TEXTS, .when = "format=table",
     ARRAY_AT(struct source_options, column, column_count),
     .help = "content of the columns: id radius diameter density x y z vx vy vz omega_x omega_y omega_z material shape qw qx qy qz skip; a unit may "
             "follow, as in radius(mm), else the unit of the header counts; shape: name of an entry of bodies, - of a sphere; qw qx qy qz: orientation of a "
             "body, a quaternion as bodies.shapes[].quaternion; left out: as in the header line", .example = "[radius, x, y, z]"},
    {.key = "skip_rows", .type = SCHEMA_LONG, .range = "[0, inf)", .fallback = "0", .when = "format=table",
     SOURCE(skip_rows), .help = "rows left out after the header"},
    {.key = "rows", .type = SCHEMA_LONG, .range = "[0, inf)", .fallback = "0", .when = "format=table",
     SOURCE(rows), .help = "number of rows to read; later rows are ignored; 0: all", .example = "25000"},
    {.key = "frame", .type = SCHEMA_LONG, .fallback = "-1", .when = "format=h5md", SOURCE(frame),
     .help = "number of the stored frame, from 0; negative: from the end"},
    {.key = "scale", .type = SCHEMA_REAL, .range = "(0, inf)", .fallback = "1", .when = "from=file",
     SOURCE(scale), .help = "factor for lengths in the file"},
    {.key = "offset", .type = SCHEMA_VECTOR, .unit = "m", .fallback = "[0, 0, 0]", .when = "from=file",
     SOURCE(offset), .help = "added to positions, after scaling"},
    {.key = "ids", .type = SCHEMA_NAME, .names = ids_names, .fallback = "file", .when = "from=file",
     SOURCE(ids), .help = "ids of the particles; those of a file without ids are new, see `id`"},
    {.key = "types", .type = SCHEMA_REFS, .target = "materials", .when = "from=file",
     ARRAY_AT(struct source_options, type_material, type_count),
     .help = "materials of type 1, 2, ... of the file; left out: type t is material number t of the scene",
     .example = "[glass, steel]"},
    {.key = "radius_above", .type = SCHEMA_REAL, .unit = "m", .range = "[0, inf)", .fallback = "0",
     .when = "from=file", SOURCE(radius_above),
     .help = "only particles of larger radius are taken from the file", .example = "1.5 mm"},
    {.key = "radius_upto", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf]", .fallback = ".inf",
     .when = "from=file", SOURCE(radius_upto),
     .help = "only particles of this radius or less are taken from the file", .example = "1.5 mm"},
    {.key = "lattice", .type = SCHEMA_NAME, .names = lattice_names, .when = "from=lattice", .required = true,
     SOURCE(lattice), .help = "the lattice", .example = "hcp"},
    {.key = "spacing", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "from=lattice",
     .required = true, SOURCE(spacing), .help = "distance of nearest neighbours", .example = "2.1 mm"},
    {.key = "jitter", .type = SCHEMA_REAL, .range = "[0, 1]", .fallback = "0", .when = "from=lattice",
     SOURCE(jitter),
     .help = "random displacement, as a fraction of the largest displacement without overlaps of neighbours"},
    {.key = "region", .type = SCHEMA_SECTION, .sub = &schema_region, .when = "from=lattice|random|packed",
     .offset = offsetof(struct source_options, region), .help = "region of the particles; spheres lie wholly inside"},
    {.key = "sizes", .type = SCHEMA_SECTION, .sub = &schema_sizes, .when = "from=lattice|random|packed",
     .main = "radius", .offset = offsetof(struct source_options, sizes),
     .help = "radii of the particles; a bare length is one radius for all"},
    {.key = "count", .type = SCHEMA_LONG, .range = "[0, inf)", .fallback = "0", .when = "from=lattice|random|packed",
     SOURCE(count), .help = "number of particles; 0: as many as the lattice has places, or by volume_fraction",
     .example = "10000"},
    {.key = "volume_fraction", .type = SCHEMA_REAL, .range = "[0, 0.74]", .fallback = "0",
     .when = "from=random", SOURCE(volume_fraction),
     .help = "instead of count: solid volume (area in two dimensions) over the volume of the region; random places allow about "
             "0.38 with equal spheres (0.54 with discs), and more with wide size laws", .example = "0.3"},
    {.key = "volume_fraction", .type = SCHEMA_REAL, .range = "[0, 0.9]", .fallback = "0",
     .when = "from=packed", SOURCE(volume_fraction),
     .help = "instead of count: solid volume (area in two dimensions) over the volume of the region. Together with count, if the scene gives no "
             "box: the box is then the cube (square) from the origin that has this fraction", .example = "0.6"},
    {.key = "meets", .type = SCHEMA_NAME, .names = meets_names, .fallback = "push", .when = "from=packed", SOURCE(meets),
     .help = "what happens where the spheres meet those of other sources"},
    {.key = "gap", .type = SCHEMA_REAL, .range = "[1e-6, 0.1]", .fallback = "0.001", .when = "from=packed", SOURCE(gap),
     .help = "distance that neighbours are moved apart to, as part of the sum of their radii; of sources packed together the largest counts"},
    {.key = "overlap", .type = SCHEMA_REAL, .range = "[0, 0.5]", .fallback = "0", .when = "from=packed", SOURCE(overlap),
     .help = "largest overlap that may be left, as part of the smaller radius; of sources packed together the smallest counts"},
    {.key = "sweeps", .type = SCHEMA_LONG, .range = "[1, 1e9]", .fallback = "20000", .when = "from=packed", SOURCE(sweeps),
     .help = "gives up after so many sweeps over all spheres; of sources packed together the largest counts"},
    {.key = "attempts", .type = SCHEMA_LONG, .range = "[1, inf)", .fallback = "20000", .when = "from=random",
     SOURCE(attempts), .help = "places tried for one sphere before giving up"},
    {.key = "position", .type = SCHEMA_VECTOR, .unit = "m", .when = "from=single", .required = true,
     SOURCE(position), .help = "centre of the particle", .example = "[0, 0, 6 cm]"},
    {.key = "radius", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "from=single",
     .required = true, SOURCE(radius), .help = "radius of the particle", .example = "1 cm"},
    {.key = "id", .type = SCHEMA_LONG, .range = "[0, inf)", .fallback = "0", .when = "from=single",
     SOURCE(id),
     .help = "id of the particle; 0: a new one. New ids count from 1 in the order of the sources, without those that files or other sources name"},
    {.key = "material", .type = SCHEMA_REF, .target = "materials", SOURCE(material),
     .help = "the material, whatever the file says; may be left out if there is only one material or the file has types", .example = "glass"},
    {.key = "shape", .type = SCHEMA_TEXT, .fallback = "", SOURCE(shape), .help = shape_help, .example = "ballast"},
    {.key = "group", .type = SCHEMA_REF, .target = "groups", SOURCE(group),
     .help = "the group; left out: the group that selects the particle", .example = "frozen_floor"},
    {.key = "velocity", .type = SCHEMA_VECTOR, .unit = "m/s", .fallback = "[0, 0, 0]", SOURCE(velocity),
     .help = "velocity, added to the velocities of the file", .example = "[0, 0, -5]"},
    {.key = "velocity_sigma", .type = SCHEMA_REAL, .unit = "m/s", .range = "[0, inf)", .fallback = "0",
     SOURCE(velocity_sigma), .help = "standard deviation of each component of a random velocity, added too; the mean over the free particles of the source, weighted by mass, is taken off, so that it adds no momentum, in any box (but for a particle alone)"},
    {.key = "omega", .type = SCHEMA_VECTOR, .unit = "rad/s", .fallback = "[0, 0, 0]", SOURCE(omega),
     .help = "angular velocity, added to the angular velocities of the file"},
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m3", .when = "/box.density=volume", .range = "[0, inf)", .fallback = "0",
     SOURCE(density), .help = "density of these particles; 0: the density of the file (1 in a packing by `scree pack` without density=), else the "
             "density of the material"},
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m2", .when = "/box.density=area", .range = "[0, inf)", .fallback = "0",
     SOURCE(density), .help = "mass of a disc over its area; 0: the mass of the file, else the density of the material"},
    {.key = "temperature", .type = SCHEMA_REAL, .unit = "K", .range = "[0, inf)", SOURCE(temperature),
     .help = "temperature of these particles at the start; left out: heat.temperature; needs heat", .example = "400 K"},
};
static const struct schema_table source_table = TABLE(source_rows);

static const struct schema_row particles_rows[] = {
    {.key = "sources", .type = SCHEMA_LIST, .sub = &source_table, .short_form = true,
     LIST_AT(struct scene, source, sources, SOURCES_MAX), .help = "files and generators, one after the other"},
};
const struct schema_table schema_particles = TABLE(particles_rows);

static const struct schema_name group_names[] = {
    {"free", SCENE_FREE, "forces move the particles"},
    {"frozen", SCENE_FROZEN, "the particles stay in place"},
    {"moving", SCENE_MOVING, "the particles move with the given velocity and spin, whatever the forces"},
    {0}};
static const struct schema_row select_rows[] = {
    {.key = "material", .type = SCHEMA_REF, .target = "materials", AT(struct scene_group, material),
     .help = "particles of this material", .example = "steel"},
    {.key = "ids", .type = SCHEMA_LONGS, .range = "[1, inf)", ARRAY_AT(struct scene_group, id, id_count),
     .help = "particles with these ids", .example = "[1, 2, 17]"},
    {.key = "radius_above", .type = SCHEMA_REAL, .unit = "m", .range = "[0, inf)",
     AT(struct scene_group, radius_above), .help = "particles of larger radius", .example = "1.5 mm"},
    {.key = "radius_upto", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)",
     AT(struct scene_group, radius_upto), .help = "particles of this radius or less", .example = "1.5 mm"},
    {.key = "region", .type = SCHEMA_SECTION, .sub = &schema_region,
     .offset = offsetof(struct scene_group, region), .help = "particles with centres in this region at the start"},
};
static const struct schema_table select_table = TABLE(select_rows);
static const struct schema_row group_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .required = true, .in_column = SCHEMA_COLUMN_NAME, AT(struct scene_group, name),
     .help = "name of the group for sources", .example = "floor"},
    {.key = "motion", .type = SCHEMA_NAME, .names = group_names, .fallback = "free",
     AT(struct scene_group, motion), .help = "motion of the particles"},
    {.key = "velocity", .type = SCHEMA_VECTOR, .unit = "m/s", .fallback = "[0, 0, 0]",
     .when = "motion=moving", AT(struct scene_group, velocity), .help = "velocity of the particles",
     .example = "[1 cm/s, 0, 0]"},
    {.key = "omega", .type = SCHEMA_VECTOR, .unit = "rad/s", .fallback = "[0, 0, 0]", .when = "motion=moving",
     AT(struct scene_group, omega), .help = "spin of each particle about its own centre"},
    {.key = "select", .type = SCHEMA_SECTION, .sub = &select_table,
     .help = "particles that belong to the group at the start: those that meet all conditions given here"},
};
const struct schema_table schema_group = TABLE(group_rows);

#define INSERTION(member) AT(struct insertion_options, member)

static const struct schema_row insertion_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .fallback = "", INSERTION(name), .help = "name for messages",
     .example = "feed"},
    {.key = "region", .type = SCHEMA_SECTION, .sub = &schema_region,
     .offset = offsetof(struct insertion_options, region),
     .help = "region of the new particles; spheres lie wholly inside, and touch neither walls nor other particles"},
    {.key = "sizes", .type = SCHEMA_SECTION, .sub = &schema_sizes, .main = "radius",
     .offset = offsetof(struct insertion_options, sizes),
     .help = "radii of the particles; a bare length is one radius for all"},
    {.key = "rate", .type = SCHEMA_REAL, .unit = "1/s", .range = "[0, inf)", .fallback = "0", INSERTION(rate),
     .help = "particles per time unit", .example = "1000"},
    {.key = "mass_rate", .type = SCHEMA_REAL, .unit = "kg/s", .range = "[0, inf)", .fallback = "0",
     INSERTION(mass_rate), .help = "instead of rate: mass per time unit, on average", .example = "1 g/s"},
    {.key = "start", .type = SCHEMA_REAL, .unit = "s", .fallback = "0", INSERTION(start),
     .help = "time of the beginning"},
    {.key = "stop", .type = SCHEMA_REAL, .unit = "s", .fallback = ".inf", .range = "[-inf, inf]",
     INSERTION(stop), .help = "time of the end"},
    {.key = "count", .type = SCHEMA_LONG, .range = "[0, inf)", .fallback = "0", INSERTION(count),
     .help = "largest number of particles in all; 0: no bound"},
    {.key = "attempts", .type = SCHEMA_LONG, .range = "[1, 1000]", .fallback = "10", INSERTION(attempts),
     .help = "places tried for a particle at one step"},
    {.key = "velocity", .type = SCHEMA_VECTOR, .unit = "m/s", .fallback = "[0, 0, 0]", INSERTION(velocity),
     .help = "velocity of the particles", .example = "[0, 0, -1]"},
    {.key = "velocity_sigma", .type = SCHEMA_REAL, .unit = "m/s", .range = "[0, inf)", .fallback = "0",
     INSERTION(velocity_sigma), .help = "standard deviation of each component of a random velocity, added; with a mean that is 0 only in the long run, as particles come one by one"},
    {.key = "omega", .type = SCHEMA_VECTOR, .unit = "rad/s", .fallback = "[0, 0, 0]", INSERTION(omega),
     .help = "angular velocity of the particles"},
    {.key = "material", .type = SCHEMA_REF, .target = "materials", INSERTION(material),
     .help = "the material; may be left out if there is only one material", .example = "glass"},
    {.key = "shape", .type = SCHEMA_TEXT, .fallback = "", INSERTION(shape), .help = shape_help, .example = "ballast"},
    {.key = "group", .type = SCHEMA_REF, .target = "groups", INSERTION(group),
     .help = "the group; left out: free"},
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m3", .when = "/box.density=volume", .range = "[0, inf)", .fallback = "0",
     INSERTION(density), .help = "density; 0: the density of the material"},
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m2", .when = "/box.density=area", .range = "[0, inf)", .fallback = "0",
     INSERTION(density), .help = "mass of a disc over its area; 0: the density of the material"},
    {.key = "temperature", .type = SCHEMA_REAL, .unit = "K", .range = "[0, inf)", INSERTION(temperature),
     .help = "temperature of the particles as they come; left out: heat.temperature; needs heat", .example = "400 K"},
};
const struct schema_table schema_insertion = TABLE(insertion_rows);

#define DELETION(member) AT(struct deletion_options, member)

static const struct schema_row deletion_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .fallback = "", DELETION(name), .help = "name for messages",
     .example = "outlet"},
    {.key = "region", .type = SCHEMA_SECTION, .sub = &schema_region,
     .offset = offsetof(struct deletion_options, region), .help = "region in which particles disappear; the centre of a particle counts"},
    {.key = "start", .type = SCHEMA_REAL, .unit = "s", .fallback = "0", DELETION(start),
     .help = "time of the beginning"},
    {.key = "stop", .type = SCHEMA_REAL, .unit = "s", .fallback = ".inf", .range = "[-inf, inf]",
     DELETION(stop), .help = "time of the end"},
    {.key = "every", .type = SCHEMA_LONG, .range = "[1, inf)", .fallback = "100", DELETION(every),
     .help = "number of steps between two looks at the region"},
};
const struct schema_table schema_deletion = TABLE(deletion_rows);
