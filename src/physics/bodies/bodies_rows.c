/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows that bodies add to tables: their section of a scene and their observables. */
#include "physics/bodies/bodies.h"
#include "physics/bodies/bodies_fields.h"
#include "data/observe/observables_kinds.h"
#include "kernel/particles/kinds.h"
#include "physics_table.h"
#include "data/scene/schema_rows.h"
#include <math.h>

/* One row a key, packed to the line: */
/* clang-format off */
static const struct schema_row sphere_rows[] = {
    {.key = "centre", .type = SCHEMA_VECTOR, .unit = "m", .required = true, AT(struct clump_sphere, centre),
     .help = "centre in the frame of the body, whose origin is anywhere", .example = "[1 mm, 0, 0]"},
    {.key = "radius", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .required = true, AT(struct clump_sphere, radius),
     .help = "radius", .example = "1 mm"},
};
static const struct schema_table sphere_table = TABLE(sphere_rows);

static const struct schema_name orientation_names[] = {
    {"random", CLUMP_RANDOM, "every orientation alike, by the seed and the id"},
    {"given", CLUMP_GIVEN, "`quaternion`"},
    {0}};

#define VOLUME_HELP "only where sources name the entry by `shape`: the body has the volume of a sphere of the radius that the source gives, and the source places the ball around the body"
#define AUTO_HELP "`volume` where sources name the entry, but `grain` in two dimensions; else `grain`"

static const struct schema_name size_names[] = {
    {"grain", CLUMP_BY_GRAIN, "the body is scaled, so that the ball around it has the radius of its grain"},
    {"drawn", CLUMP_AS_DRAWN, "places and radii of the members are those of the entry; the radius of the grain only keeps it from other grains "
                              "and walls of its source, and chooses the entry"},
    {"volume", CLUMP_BY_VOLUME, VOLUME_HELP},
    {"auto", CLUMP_AUTO, AUTO_HELP},
    {0}};

/* Keys of all entries: which grains become such bodies, and how they begin. */
#define WHICH_ROWS(owner) \
    {.key = "name", .type = SCHEMA_TEXT, .fallback = "body", AT(owner, entry.name), .help = "name, for messages and for the key `shape` of sources", \
     .example = "dumbbell"}, \
    {.key = "material", .type = SCHEMA_REF, .target = "materials", AT(owner, entry.material), \
     .help = "grains of this material become such bodies: each grain stands for the ball around its body, about the centre " \
             "of mass; left out: the only material", .example = "glass"}, \
    {.key = "radius_above", .type = SCHEMA_REAL, .unit = "m", .range = "[0, inf)", .fallback = "0", \
     AT(owner, entry.radius_above), .help = "only grains of a larger radius than this", .example = "0.5 mm"}, \
    {.key = "radius_upto", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf]", .fallback = ".inf", \
     AT(owner, entry.radius_upto), .help = "only grains of this radius or less", .example = "1.5 mm"},
#define HOW_ROWS(owner) \
    {.key = "orientation", .type = SCHEMA_NAME, .names = orientation_names, .fallback = "random", \
     AT(owner, entry.orientation), .help = "at the start"}, \
    {.key = "quaternion", .type = SCHEMA_REALS, .when = "orientation=given", \
     ARRAY_AT(owner, entry.quaternion, entry.quaternion_given), \
     .help = "w x y z of the rotation from the frame of the entry to space; its length does not matter", \
     .example = "[1, 0, 0, 0]"}, \
    {.key = "angular_velocity", .type = SCHEMA_VECTOR, .unit = "rad/s", .fallback = "[0, 0, 0]", \
     AT(owner, entry.angular_velocity), .help = "at the start, added to the omega of the source", \
     .example = "[0, 0, 10]"},

static const struct schema_row clump_rows[] = {
    WHICH_ROWS(struct clump_options)
    {.key = "spheres", .type = SCHEMA_LIST, .sub = &sphere_table, ARRAY_AT(struct clump_options, sphere, spheres),
     .help = "the members; see `size`"},
    {.key = "file", .type = SCHEMA_PATH, AT(struct clump_options, file),
     .help = "instead: a file with one row `x y z radius` a member", .example = "rock.txt"},
    {.key = "mesh", .type = SCHEMA_PATH, AT(struct clump_options, mesh),
     .help = "instead: a closed surface of triangles, STL or nine numbers a row, which is filled with spheres that may overlap, the largest "
             "first; mass, centre and inertia are those of what the surface holds", .example = "rock.stl"},
    {.key = "mesh_spheres", .type = SCHEMA_INT, .range = "[1, 200]", .fallback = "20", AT(struct clump_options, mesh_spheres),
     .help = "number of spheres of a mesh, at most"},
    {.key = "scale", .type = SCHEMA_REAL, .range = "(0, inf)", .fallback = "1", AT(struct clump_options, scale),
     .help = "lengths of the file or mesh x this", .example = "0.001"},
    {.key = "size", .type = SCHEMA_NAME, .names = size_names, .fallback = "auto", AT(struct clump_options, entry.size),
     .help = "size of the body; the centre of mass is at the centre of the grain in any case"},
    {.key = "mass", .type = SCHEMA_REAL, .unit = "kg", .range = "(0, inf)", AT(struct clump_options, entry.mass),
     .help = "mass of the body in the size of the entry; left out: volume of its spheres together x density of its grain",
     .example = "3 g"},
    {.key = "centre", .type = SCHEMA_REALS, .unit = "m", ARRAY_AT(struct clump_options, centre, centre_given),
     .help = "centre of mass; left out: that of a uniform density; needs inertia", .example = "[0, 0, 0.1 mm]"},
    {.key = "inertia", .type = SCHEMA_REALS, ARRAY_AT(struct clump_options, inertia, inertia_given),
     .help = "moments of inertia about the centre of mass xx yy zz xy xz yz, in kg m2; left out: those of a uniform density; "
             "needs mass", .example = "[2e-9, 2e-9, 1e-9, 0, 0, 0]"},
    HOW_ROWS(struct clump_options)
};
static const struct schema_table clump_table = TABLE(clump_rows);

static const struct schema_name rock_size_names[] = {
    {"grain", CLUMP_BY_GRAIN, "the rock is scaled, so that the ball around it has the radius of its grain"},
    {"drawn", CLUMP_AS_DRAWN, "the rock has the size of the entry; the radius of the grain only keeps it from other grains and walls of its "
                              "source, and chooses the entry"},
    {"volume", CLUMP_BY_VOLUME, VOLUME_HELP},
    {"auto", CLUMP_AUTO, AUTO_HELP},
    {0}};

static const struct schema_row random_rows[] = {
    {.key = "corners", .type = SCHEMA_INT, .range = "[6, 64]", .fallback = "20", AT(struct rock_options, draw.corners),
     .help = "corners that are drawn on an ellipsoid, whose hull the rock is"},
    {.key = "variants", .type = SCHEMA_INT, .range = "[1, 64]", .fallback = "8", AT(struct rock_options, draw.variants),
     .help = "number of shapes, each drawn by the seed; a grain takes one by its id"},
    {.key = "elongation", .type = SCHEMA_REAL, .range = "[0.1, 1]", .fallback = "0.8", AT(struct rock_options, draw.elongation),
     .help = "middle axis of the ellipsoid over the longest one"},
    {.key = "flatness", .type = SCHEMA_REAL, .range = "[0.1, 1]", .fallback = "0.8", AT(struct rock_options, draw.flatness),
     .help = "shortest axis of the ellipsoid over the middle one"},
};
static const struct schema_table random_table = TABLE(random_rows);

static const struct schema_row rock_rows[] = {
    WHICH_ROWS(struct rock_options)
    {.key = "vertices", .type = SCHEMA_REALS, .unit = "m", ARRAY_AT(struct rock_options, vertex, numbers),
     .help = "x y z of each corner, one after another; the rock is their convex hull; see `size`",
     .example = "[0, 0, 0, 1 mm, 0, 0, 0, 1 mm, 0, 0, 0, 1 mm]"},
    {.key = "file", .type = SCHEMA_PATH, AT(struct rock_options, file),
     .help = "instead: a closed convex surface of triangles, STL, OBJ, PLY or nine numbers a row", .example = "rock.stl"},
    {.key = "scale", .type = SCHEMA_REAL, .range = "(0, inf)", .fallback = "1", AT(struct rock_options, scale),
     .help = "lengths of the file x this", .example = "0.001"},
    {.key = "hull", .type = SCHEMA_BOOL, .fallback = "false", AT(struct rock_options, hull),
     .help = "the hull of the corners of the file is the rock, be the surface closed and convex or not"},
    {.key = "random", .type = SCHEMA_SECTION, .sub = &random_table, .optional = true, .count_offset = offsetof(struct rock_options, random),
     .help = "instead: a random rock"},
    {.key = "rounding", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", AT(struct rock_options, rounding),
     .help = "radius of edges and corners, in the size of the entry: faces stay, edges and corners are cut; left out: by roundness",
     .example = "0.1 mm"},
    {.key = "roundness", .type = SCHEMA_REAL, .range = "(0, 0.9]", .fallback = "0.1", AT(struct rock_options, draw.roundness),
     .help = "without rounding: its radius over the distance from the centre of mass to the nearest face"},
    {.key = "size", .type = SCHEMA_NAME, .names = rock_size_names, .fallback = "auto", AT(struct rock_options, entry.size),
     .help = "size of the rock; the centre of mass is at the centre of the grain in any case"},
    {.key = "mass", .type = SCHEMA_REAL, .unit = "kg", .range = "(0, inf)", AT(struct rock_options, entry.mass),
     .help = "mass of the body in the size of the entry; left out: volume x density of its grain",
     .example = "3 g"},
    HOW_ROWS(struct rock_options)
};
static const struct schema_table rock_table = TABLE(rock_rows);

static const struct schema_row section[] = {
    {.key = "clumps", .type = SCHEMA_LIST, .sub = &clump_table,
     ARRAY_AT(struct bodies_options, clump, clumps),
     .help = "bodies of spheres; a grain whose source names no shape becomes the first whose material and radii fit, others stay spheres"},
    {.key = "shapes", .type = SCHEMA_LIST, .sub = &rock_table, ARRAY_AT(struct bodies_options, rock, rocks),
     .help = "rocks: convex bodies with flat faces; looked at after clumps"},
};
const struct schema_table bodies_schema = TABLE(section);
/* clang-format on */

_Static_assert(sizeof(struct bodies_options) <= PHYSICS_OPTIONS_MAX * sizeof(double), "room in struct scene");

static bool known(const struct output_view *view) {
    return bodies_orientation(view->particles) != NULL;
}

/* True if particle i is a body that an item counts. */
static bool counts(const struct output_view *view, const struct observable_item *item, size_t i) {
    const uint8_t *kind = kinds_of(view->particles);
    return known(view) && kind && kind[i] == KIND_BODY && observables_item_counts(view, item, i);
}

static void take_count(const struct observable_context *context, struct observable_item *item, double *part) {
    for (size_t i = 0; i < context->view->particles->owned; i++)
        part[0] += counts(context->view, item, i);
}

static void take_norm(const struct observable_context *context, struct observable_item *item, double *part) {
    double(*orientation)[4] = bodies_orientation(context->view->particles);
    for (size_t i = 0; i < context->view->particles->owned; i++) {
        if (!counts(context->view, item, i))
            continue;
        const double *q = orientation[i];
        part[0] = fmax(part[0], fabs(sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) - 1));
    }
}

#define INFO(name, family, unit, text)                                                                       \
    .info = {name, family, unit, text, OBSERVABLE_OF_ALL_OR_REGION, 1, unit}, .relevant = known
static const struct observable_kind kinds[] = {
    {INFO("bodies", "", "", "number of rigid bodies"), .parts = 1, .of_rank = take_count},
    {INFO("bodies_norm", "", "", "largest distance of the norm of an orientation from 1"), .parts = 1,
     .combine = OBSERVABLE_MAX, .of_rank = take_norm}};
const struct observable_table bodies_observables = {kinds, sizeof kinds / sizeof kinds[0]};
