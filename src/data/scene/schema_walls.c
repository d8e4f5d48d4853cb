/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: walls, their motions, and what makes them free. */
#include "data/scene/scene.h"
#include "data/scene/schema_sections.h"

/* One row a key, packed to the line: */
/* clang-format off */

static const struct schema_name motion_names[] = {
    {"translate", WALL_TRANSLATE, "constant velocity"},
    {"rotate", WALL_ROTATE, "constant rate about an axis"},
    {"oscillate", WALL_OSCILLATE, "a sine along a direction"},
    {"oscillate_rotation", WALL_OSCILLATE_ROTATION, "a sine of the angle about an axis"},
    {"table", WALL_TABLE, "pose against time from a file"},
    {"servo", WALL_SERVO, "along a direction, until the particles push with a given force or pressure"},
    {0}};

static const struct schema_row motion_rows[] = {
    {.key = "kind", .type = SCHEMA_NAME, .names = motion_names, .required = true,
     AT(struct wall_motion, kind), .help = "the kind of motion", .example = "rotate"},
    {.key = "start", .type = SCHEMA_REAL, .unit = "s", .fallback = "0", AT(struct wall_motion, start),
     .help = "time of the beginning of the motion"},
    {.key = "stop", .type = SCHEMA_REAL, .unit = "s", .fallback = ".inf", .range = "[-inf, inf]",
     AT(struct wall_motion, stop), .help = "time of the end"},
    {.key = "surface", .type = SCHEMA_BOOL, .fallback = "false", .when = "kind=translate|rotate|oscillate|oscillate_rotation|table",
     AT(struct wall_motion, surface),
     .help = "true: the wall stays, and its surface alone moves, as that of a belt; a contact takes the part of the velocity along the "
             "surface"},
    {.key = "velocity", .type = SCHEMA_VECTOR, .unit = "m/s", .when = "kind=translate", .required = true,
     AT(struct wall_motion, velocity), .help = "velocity", .example = "[0, 0, -1 mm/s]"},
    {.key = "direction", .type = SCHEMA_VECTOR, .when = "kind=rotate|oscillate|oscillate_rotation|servo",
     .required = true, AT(struct wall_motion, direction),
     .help = "axis of a rotation, direction of a displacement; any length; later motions turn the direction, too",
     .example = "[0, 1, 0]"},
    {.key = "point", .type = SCHEMA_VECTOR, .unit = "m", .fallback = "[0, 0, 0]",
     .when = "kind=rotate|oscillate_rotation", AT(struct wall_motion, point), .help = "a point of the axis"},
    {.key = "rate", .type = SCHEMA_REAL, .unit = "rad/s", .when = "kind=rotate", .required = true,
     AT(struct wall_motion, rate), .help = "angular velocity, right-handed about direction",
     .example = "20 rpm"},
    {.key = "amplitude", .type = SCHEMA_REAL, .unit = "m", .when = "kind=oscillate", .required = true,
     AT(struct wall_motion, amplitude),
     .help = "amplitude of the displacement amplitude x sin(2 pi frequency t + phase); t is the time of the run, cut to start and "
             "stop: if the sine is not 0 at start, the wall is displaced also before start", .example = "2 mm"},
    {.key = "angle", .type = SCHEMA_REAL, .unit = "rad", .when = "kind=oscillate_rotation", .required = true,
     AT(struct wall_motion, amplitude), .help = "amplitude of the angle", .example = "5 deg"},
    {.key = "frequency", .type = SCHEMA_REAL, .unit = "1/s", .range = "[0, inf)",
     .when = "kind=oscillate|oscillate_rotation", .required = true, AT(struct wall_motion, frequency),
     .help = "cycles per time unit", .example = "50 Hz"},
    {.key = "phase", .type = SCHEMA_REAL, .unit = "rad", .fallback = "0",
     .when = "kind=oscillate|oscillate_rotation", AT(struct wall_motion, phase), .help = "phase at t = 0"},
    {.key = "file", .type = SCHEMA_PATH, .when = "kind=table", .required = true,
     AT(struct wall_motion, table),
     .help = "rows `t x y z a b c`: time of the run, displacement, rotation vector about the origin; linear between rows, "
             "constant before the first and after the last row",
     .example = "shake.txt"},
    {.key = "force", .type = SCHEMA_REAL, .unit = "N", .when = "kind=servo", AT(struct wall_motion, force),
     .help = "target, not 0, for the force of the particles on the wall along direction; with a positive target direction points "
             "away from the particles: [0, 0, 1] for a lid on a bed", .example = "10 N"},
    {.key = "pressure", .type = SCHEMA_REAL, .unit = "Pa", .range = "(0, inf)", .when = "kind=servo",
     AT(struct wall_motion, pressure),
     .help = "instead of force: the target is pressure x area, and direction points away from the particles. In two dimensions a force "
             "over a length", .example = "1 kPa"},
    {.key = "area", .type = SCHEMA_REAL, .unit = "m2", .range = "(0, inf)", .when = "kind=servo", AT(struct wall_motion, area),
     .help = "with pressure: the area across direction on which the particles push; in two dimensions a length. Left out: of a plane "
             "across an edge of the box the section of the box, of a mesh the area as seen along direction; other walls need the key",
     .example = "4 cm2"},
    {.key = "speed_max", .type = SCHEMA_REAL, .unit = "m/s", .range = "(0, inf)", .when = "kind=servo",
     .required = true, AT(struct wall_motion, speed_max), .help = "bound on the speed", .example = "1 cm/s"},
    {.key = "gain", .type = SCHEMA_REAL, .unit = "m/s", .range = "[0, inf)", .fallback = "0",
     .when = "kind=servo", AT(struct wall_motion, gain),
     .help = "speed if the force differs from its target by the size of the target; the wall takes up the speed over 50 steps; 0: the "
             "program finds the gain: the wall resists as the grains that touch it do"},
};
static const struct schema_table motion_table = TABLE(motion_rows);

static const struct schema_name freedom_names[] = {
    {"all", WALL_FREE_ALL, "moves in all directions, and turns"},
    {"shift", WALL_FREE_SHIFT, "moves in all directions, without turning"},
    {"along", WALL_FREE_ALONG, "moves along `direction` alone: a lid, a piston"},
    {"about", WALL_FREE_ABOUT, "turns about an axis alone: a paddle, a door, a roller"},
    {0}};

static const struct schema_row free_rows[] = {
    {.key = "freedom", .type = SCHEMA_NAME, .names = freedom_names, .fallback = "all", AT(struct wall_options, free.freedom),
     .help = "how the wall may move", .example = "about"},
    {.key = "mass", .type = SCHEMA_REAL, .unit = "kg", .range = "(0, inf)", AT(struct wall_options, free.mass),
     .help = "mass of the wall; of a closed mesh, a box, or a cylinder with particles outside that of the solid, else of a thin sheet",
     .example = "2 kg"},
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m3", .range = "(0, inf)", AT(struct wall_options, free.density),
     .help = "instead of mass, of shapes that are solids", .example = "2400 kg/m3"},
    {.key = "centre", .type = SCHEMA_REALS, .unit = "m", ARRAY_AT(struct wall_options, free.centre, free.centre_given),
     .help = "centre of mass at rest; left out: by the shape; a wall that turns needs inertia, too", .example = "[0, 0, 1 cm]"},
    {.key = "inertia", .type = SCHEMA_REALS, ARRAY_AT(struct wall_options, free.inertia, free.inertia_given),
     .help = "moments of inertia about the centre of mass xx yy zz xy xz yz, in kg m2; left out: by the shape",
     .example = "[2e-3, 2e-3, 1e-3, 0, 0, 0]"},
    {.key = "direction", .type = SCHEMA_VECTOR, .when = "freedom=along|about", .required = true, AT(struct wall_options, free.direction),
     .help = "the direction, or that of the axis; any length", .example = "[0, 0, 1]"},
    {.key = "point", .type = SCHEMA_VECTOR, .unit = "m", .when = "freedom=about", .required = true, AT(struct wall_options, free.point),
     .help = "a point of the axis", .example = "[0, 0, 0]"},
    {.key = "velocity", .type = SCHEMA_REALS, .unit = "m/s", .when = "freedom=all|shift",
     ARRAY_AT(struct wall_options, free.velocity, free.velocity_given),
     .help = "velocity of the centre of mass where the wall becomes free; left out: 0. A stage or a resume with another one than before "
             "gives it to a wall that is free already",
     .example = "[0, 0, -1 m/s]"},
    {.key = "angular_velocity", .type = SCHEMA_REALS, .unit = "rad/s", .when = "freedom=all",
     ARRAY_AT(struct wall_options, free.omega, free.omega_given), .help = "the same of the angular velocity", .example = "[0, 0, 2]"},
    {.key = "speed", .type = SCHEMA_REAL, .unit = "m/s", .when = "freedom=along", AT(struct wall_options, free.speed),
     .help = "the same of the speed along direction", .example = "1 cm/s"},
    {.key = "rate", .type = SCHEMA_REAL, .unit = "rad/s", .when = "freedom=about", AT(struct wall_options, free.speed),
     .help = "the same of the angular velocity about direction, right-handed", .example = "2"},
    {.key = "force", .type = SCHEMA_REAL, .unit = "N", .fallback = "0", .when = "freedom=along", AT(struct wall_options, free.load),
     .help = "force on the wall along direction, beside gravity and the particles"},
    {.key = "torque", .type = SCHEMA_REAL, .unit = "N m", .fallback = "0", .when = "freedom=about", AT(struct wall_options, free.load),
     .help = "torque on the wall about the axis, beside gravity and the particles"},
    {.key = "spring", .type = SCHEMA_REAL, .unit = "N/m", .range = "[0, inf)", .fallback = "0", .when = "freedom=along",
     AT(struct wall_options, free.spring), .help = "stiffness of a spring that pulls the wall back to where it became free"},
    {.key = "spring", .type = SCHEMA_REAL, .unit = "N m/rad", .range = "[0, inf)", .fallback = "0", .when = "freedom=about",
     AT(struct wall_options, free.spring), .help = "stiffness of a spring that turns the wall back to where it became free"},
    {.key = "damper", .type = SCHEMA_REAL, .unit = "N s/m", .range = "[0, inf)", .fallback = "0", .when = "freedom=along",
     AT(struct wall_options, free.damper), .help = "force against the speed, over the speed"},
    {.key = "damper", .type = SCHEMA_REAL, .unit = "N m s/rad", .range = "[0, inf)", .fallback = "0", .when = "freedom=about",
     AT(struct wall_options, free.damper), .help = "torque against the rate, over the rate"},
};
static const struct schema_table free_table = TABLE(free_rows);

static const struct schema_name shape_names[] = {{"plane", WALL_PLANE, "infinite, one-sided"},
                                                 {"cylinder", WALL_CYLINDER, "around an axis, one-sided, with open ends if a length is given"},
                                                 {"mesh", WALL_MESH, "triangles from a file, two-sided, with corners in any order"},
                                                 {"rectangle", WALL_RECTANGLE, "with edges, two-sided; exact"},
                                                 {"box", WALL_BOX, "the six faces, two-sided; exact"},
                                                 {"disc", WALL_DISC, "flat, two-sided, of `segments` corners; with a hole if one is given"},
                                                 {"cone", WALL_CONE, "with open ends, two-sided, of `segments` plane sides: a funnel, or with its tip"},
                                                 {0}};

static const char *mesh_format_choice(int k, const char **help) {
    static const char *const names[][2] = {{"auto", "by content"},
                                           {"stl", "STL, ASCII or binary"},
                                           {"obj", "Wavefront OBJ"},
                                           {"ply", "PLY, ASCII or binary"},
                                           {"table", "nine numbers a row: three corners"}};
    if (k >= (int)(sizeof(names) / sizeof(names[0])))
        return NULL;
    *help = names[k][1];
    return names[k][0];
}

static const struct schema_row wall_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .fallback = "", .in_column = SCHEMA_COLUMN_NAME, AT(struct wall_options, name),
     .help = "name of the wall for observables; left out: wall1, wall2, ...", .example = "floor"},
    {.key = "shape", .type = SCHEMA_NAME, .names = shape_names, .required = true,
     AT(struct wall_options, shape), .help = "the shape", .example = "plane"},
    {.key = "material", .type = SCHEMA_REF, .target = "materials", AT(struct wall_options, material),
     .help = "material of the wall; may be left out if there is only one material", .example = "steel"},
    {.key = "point", .type = SCHEMA_VECTOR, .unit = "m", .when = "shape=plane|cylinder|rectangle|disc|cone", .required = true,
     AT(struct wall_options, point), .help = "a point of the plane; the middle of the cylinder's axis, or of the disc; a corner of the rectangle; the middle of the "
             "cone's first end",
     .example = "[0, 0, 0]"},
    {.key = "normal", .type = SCHEMA_VECTOR, .when = "shape=plane|disc", .required = true,
     AT(struct wall_options, normal), .help = "direction towards the particles, of a disc to either side; any length", .example = "[0, 0, 1]"},
    {.key = "axis", .type = SCHEMA_VECTOR, .when = "shape=cylinder|cone", .required = true,
     AT(struct wall_options, axis), .help = "direction of the axis, of a cone from the first end to the second one; any length", .example = "[0, 1, 0]"},
    {.key = "radius", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "shape=cylinder|disc|cone",
     .required = true, AT(struct wall_options, radius), .help = "radius, of a cone at its first end", .example = "10 cm"},
    {.key = "length", .type = SCHEMA_REAL, .unit = "m", .range = "[0, inf)", .fallback = "0",
     .when = "shape=cylinder", AT(struct wall_options, length),
     .help = "whole length along the axis; 0: infinite"},
    {.key = "length", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "shape=cone", .required = true,
     AT(struct wall_options, length), .help = "distance of the cone's ends along the axis", .example = "10 cm"},
    {.key = "radius_end", .type = SCHEMA_REAL, .unit = "m", .range = "[0, inf)", .fallback = "0", .when = "shape=cone",
     AT(struct wall_options, radius_end), .help = "radius of the cone's second end; 0: the cone ends in a tip", .example = "2 cm"},
    {.key = "hole", .type = SCHEMA_REAL, .unit = "m", .range = "[0, inf)", .fallback = "0", .when = "shape=disc",
     AT(struct wall_options, hole), .help = "radius of a round hole in the middle; 0: none"},
    {.key = "segments", .type = SCHEMA_INT, .range = "[3, 100000]", .fallback = "96", .when = "shape=disc|cone",
     AT(struct wall_options, segments),
     .help = "corners on each circle; the walls lie inside of it by up to radius x (1 - cos(pi / segments)), 0.0005 of the radius for "
             "96. A cone of 42 or more acts on a sphere as one smooth surface; fewer are plane sides with edges"},
    {.key = "along", .type = SCHEMA_VECTOR, .unit = "m", .when = "shape=rectangle", .required = true,
     AT(struct wall_options, along), .help = "one side of the rectangle, from the corner", .example = "[4 cm, 0, 0]"},
    {.key = "across", .type = SCHEMA_VECTOR, .unit = "m", .when = "shape=rectangle", .required = true,
     AT(struct wall_options, across), .help = "the other side; not at right angles: a parallelogram", .example = "[0, 2 cm, 0]"},
    {.key = "lower", .type = SCHEMA_VECTOR, .unit = "m", .when = "shape=box", .required = true,
     AT(struct wall_options, lower), .help = "lower corner of the box", .example = "[0, 0, 0]"},
    {.key = "upper", .type = SCHEMA_VECTOR, .unit = "m", .when = "shape=box", .required = true,
     AT(struct wall_options, upper), .help = "upper corner of the box", .example = "[4 cm, 2 cm, 1 cm]"},
    {.key = "inside", .type = SCHEMA_BOOL, .fallback = "true", .when = "shape=cylinder",
     AT(struct wall_options, inside), .help = "true: the particles are inside; false: outside"},
    {.key = "file", .type = SCHEMA_PATH, .when = "shape=mesh", .required = true,
     AT(struct wall_options, file), .help = "the triangles", .example = "hopper.stl"},
    {.key = "format", .type = SCHEMA_CHOICE, .choice = mesh_format_choice, .fallback = "auto",
     .when = "shape=mesh", AT(struct wall_options, format), .help = "format of the file"},
    {.key = "scale", .type = SCHEMA_REAL, .range = "(0, inf)", .fallback = "1", .when = "shape=mesh",
     AT(struct wall_options, scale),
     .help = "factor for lengths in the file: 0.001 for a mesh in millimetres"},
    {.key = "offset", .type = SCHEMA_VECTOR, .unit = "m", .fallback = "[0, 0, 0]", .when = "shape=mesh",
     AT(struct wall_options, offset), .help = "vector added to all corners, after scaling"},
    {.key = "field", .type = SCHEMA_BOOL, .fallback = "false", .when = "shape=mesh", AT(struct wall_options, field),
     .help = "true: the mesh, a closed surface, is felt by signed distances at the nodes of a grid near it: smooth over its facets, at a "
             "cost that does not depend on their number, with one contact a grain; `scree check` tells the error. Three dimensions"},
    {.key = "field_spacing", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "shape=mesh", AT(struct wall_options, field_spacing),
     .help = "spacing of the nodes of a field; left out: a 128th of the longest side of the mesh", .example = "0.5 mm"},
    {.key = "permeable", .type = SCHEMA_BOOL, .fallback = "false", AT(struct wall_options, permeable),
     .help = "true: the wall holds grains alone, and the fluid of the section fluid goes through it: the plate at the bottom of a fluidised bed, beside an "
             "open side; a sieve"},
    {.key = "motion", .type = SCHEMA_LIST, .sub = &motion_table,
     ARRAY_AT(struct wall_options, motion, motions),
     .help = "motions, the first applied first; none: the wall is at rest, or free"},
    {.key = "free", .type = SCHEMA_SECTION, .sub = &free_table, .optional = true, .offset = 0,
     .count_offset = offsetof(struct wall_options, free.given),
     .help = "the wall is free: gravity and particles push, turn and carry it; of other walls those do that wall_contacts names"},
};
const struct schema_table schema_wall = TABLE(wall_rows);
