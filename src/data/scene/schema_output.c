/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: output and observables. */
#include "data/observe/observables.h"
#include "data/formats/output_options.h"
#include "data/scene/schema_output.h"

#include <string.h>

/* One row a key, packed to the line: */
/* clang-format off */

static const struct schema_row every_rows[] = {
    {.key = "steps", .type = SCHEMA_LONG, .range = "[0, inf)", .fallback = "0",
     AT(struct output_interval, steps), .help = "every so many steps; 0: by time", .example = "1000"},
    {.key = "time", .type = SCHEMA_REAL, .unit = "s", .range = "[0, inf)", .fallback = "0",
     AT(struct output_interval, time), .help = "at multiples of this time; 0: by steps", .example = "0.5 ms"},
};
static const struct schema_table every_table = TABLE(every_rows);

#define EVERY(owner, member)                                                                                 \
    .type = SCHEMA_SECTION, .sub = &every_table, .main = "steps", .offset = offsetof(owner, member)

static const struct schema_name precision_names[] = {
    {"double", OUTPUT_DOUBLE, "float64"},
    {"single", OUTPUT_SINGLE, "float32, half as large; numbers keep seven digits"},
    {0}};
static const struct schema_row trajectory_rows[] = {
    {.key = "every", EVERY(struct trajectory_options, every),
     .help = "interval of the frames; a bare number counts steps, {time: ...} is simulated time"},
    {.key = "fields", .type = SCHEMA_TEXTS, ARRAY_AT(struct trajectory_options, fields.name, fields.count),
     .help = "particle fields; id, position and radius are always written; left out: all fields of the scene; `force` is the "
             "force of contacts and walls, without gravity",
     .example = "[position, velocity, radius]"},
    {.key = "xdmf", .type = SCHEMA_BOOL, .fallback = "true", AT(struct trajectory_options, xdmf),
     .help = "whether trajectory.xdmf is written, too, for ParaView"},
    {.key = "precision", .type = SCHEMA_NAME, .names = precision_names, .fallback = "double",
     AT(struct trajectory_options, precision), .help = "numbers of the fields of each frame; checkpoints have all digits"},
    {.key = "compression", .type = SCHEMA_LONG, .range = "[0, 9]", .fallback = "0", AT(struct trajectory_options, deflate),
     .help = "HDF5's shuffle and deflate filters for the fields of each frame: 1 is fast, 9 small; 0: none", .example = "4"},
    {.key = "units", .type = SCHEMA_BOOL, .fallback = "true", AT(struct trajectory_options, units),
     .help = "whether the file names the units; readers that know none but molecular units (MDAnalysis) need a file without"},
    {.key = "contacts", EVERY(struct trajectory_options, contacts),
     .help = "interval of the contact lists (force chains)"},
};
static const struct schema_table trajectory_table = TABLE(trajectory_rows);

static const struct schema_row dump_rows[] = {
    {.key = "every", EVERY(struct dump_options, every), .help = "interval of the frames"},
    {.key = "fields", .type = SCHEMA_TEXTS, ARRAY_AT(struct dump_options, fields.name, fields.count),
     .help = "particle fields; left out: all fields that a dump can show, others are refused; `force` is the force of contacts and walls, without gravity",
     .example = "[position, velocity, radius]"},
};
static const struct schema_table dump_table = TABLE(dump_rows);

static const struct schema_row wall_frames_rows[] = {
    {.key = "every", EVERY(struct wall_frames_options, every),
     .help = "interval of the frames; a bare number counts steps, {time: ...} is simulated time"},
};
static const struct schema_table wall_frames_table = TABLE(wall_frames_rows);

static const struct schema_row contact_problems_rows[] = {
    {.key = "every", EVERY(struct contact_problems_options, every),
     .help = "interval of the files; a bare number counts steps, {time: ...} is simulated time"},
};
static const struct schema_table contact_problems_table = TABLE(contact_problems_rows);

static const struct schema_row checkpoint_rows[] = {
    {.key = "every", .type = SCHEMA_LONG, .range = "[0, inf)", .fallback = "0",
     AT(struct checkpoint_options, every_steps), .help = "steps between checkpoints; 0: none",
     .example = "10000"},
    {.key = "minutes", .type = SCHEMA_REAL, .range = "[0, inf)", .fallback = "0",
     AT(struct checkpoint_options, every_minutes),
     .help = "minutes of wall clock between checkpoints; 0: none", .example = "30"},
    {.key = "keep", .type = SCHEMA_INT, .range = "[1, 1000]", .fallback = "2",
     AT(struct checkpoint_options, keep), .help = "number of checkpoints to keep"},
    {.key = "at_end", .type = SCHEMA_BOOL, .fallback = "true", AT(struct checkpoint_options, at_end),
     .help = "whether a checkpoint is written after the last step"},
};
static const struct schema_table checkpoint_table = TABLE(checkpoint_rows);

static const struct schema_name progress_names[] = {
    {"auto", PROGRESS_AUTO,
     "a bar on a terminal; elsewhere a line every five seconds, after 100 seconds more rarely, down to one line a minute"},
    {"bar", PROGRESS_BAR, NULL},
    {"lines", PROGRESS_LINES, "lines as elsewhere with auto, and one at each tenth of the run"},
    {"off", PROGRESS_OFF, NULL},
    {0}};

static const struct schema_row output_rows[] = {
    {.key = "trajectory", .type = SCHEMA_SECTION, .sub = &trajectory_table,
     .offset = offsetof(struct output_options, trajectory), .help = "the file trajectory.h5, H5MD by parallel HDF5"},
    {.key = "dump", .type = SCHEMA_SECTION, .sub = &dump_table,
     .offset = offsetof(struct output_options, dump), .help = "the file dump.lammpstrj, in LAMMPS's text format"},
    {.key = "walls", .type = SCHEMA_SECTION, .sub = &wall_frames_table,
     .offset = offsetof(struct output_options, walls),
     .help = "the files walls-STEP.vtp, walls.pvd and walls.xdmf: the walls as triangles, with force and pressure, for ParaView"},
    {.key = "contact_problems", .type = SCHEMA_SECTION, .sub = &contact_problems_table,
     .offset = offsetof(struct output_options, contact_problems),
     .help = "the files contact-problem-STEP.hdf5: the problem that contact.solver has solved, in FCLIB's format, for other solvers; rank 0 holds all of it. A step without contacts has none"},
    {.key = "checkpoint", .type = SCHEMA_SECTION, .sub = &checkpoint_table,
     .offset = offsetof(struct output_options, checkpoint), .help = "the files checkpoint-STEP.h5, from which a run can resume"},
    {.key = "progress", .type = SCHEMA_NAME, .names = progress_names, .fallback = "auto",
     AT(struct output_options, progress.mode), .help = "display of the progress on the terminal"},
};
const struct schema_table schema_output = TABLE(output_rows);

/* Rows of the registry and their families, each name once. */
const char *schema_observable_choice(int k, const char **help) {
    for (int row = 0; row < observables_count(); row++) {
        const struct observable_info *info = observables_get(row);
        bool new_family = info->family[0] != '\0';
        for (int other = 0; new_family && other < row; other++)
            new_family = strcmp(observables_get(other)->family, info->family) != 0;
        if (new_family && k-- == 0) {
            *help = "several at once";
            return info->family;
        }
        if (k-- == 0) {
            *help = info->help;
            return info->name;
        }
    }
    return NULL;
}

const struct schema_name schema_components[] = {
    {"all", 0, NULL}, {"x", 1, NULL},  {"y", 2, NULL},  {"z", 4, NULL},
    {"xy", 3, NULL},  {"xz", 5, NULL}, {"yz", 6, NULL}, {0}};

static const struct schema_row request_rows[] = {
    {.key = "name", .type = SCHEMA_CHOICE, .choice = schema_observable_choice, .required = true,
     .with_target = true, AT(struct observable_request, name), .help = "the observable; NAME/TARGET gives its target, too", .example = "position"},
    {.key = "label", .type = SCHEMA_TEXT, .fallback = "", .in_column = SCHEMA_COLUMN_NAME, AT(struct observable_request, label),
     .help = "first part of the column's name; left out: the target's name", .example = "ball"},
    {.key = "target", .type = SCHEMA_TEXT, .fallback = "", AT(struct observable_request, target),
     .help = "wall, region, plane or group, `region/material` for one material; left out: all of them, for stress the whole box",
     .example = "floor"},
    {.key = "id", .type = SCHEMA_LONG, .range = "[0, inf)", .fallback = "0",
     AT(struct observable_request, id), .help = "id of the observed particle", .example = "25001"},
    {.key = "of", .type = SCHEMA_TEXT, .fallback = "", AT(struct observable_request, of),
     .help = "for sum, mean, largest, least: an expression in the syntax of muParser over t, x, y, z, vx, vy, vz, fx, fy, fz (force "
             "of contacts and walls), wx, wy, wz, radius, mass, id, material, group (numbers from 0), and the scene's further "
             "fields of one number, in base units", .example = "0.5*mass*(vx^2+vy^2+vz^2)"},
    {.key = "where", .type = SCHEMA_TEXT, .fallback = "", AT(struct observable_request, where),
     .help = "an expression that is not 0 for the particles that count; left out: all", .example = "z > 0.1 && material == 1"},
    {.key = "unit", .type = SCHEMA_TEXT, .fallback = "", .in_column = SCHEMA_COLUMN_UNIT, AT(struct observable_request, unit),
     .help = "unit of the expression, for the head of the column; left out: 1", .example = "J"},
    {.key = "cells", .type = SCHEMA_LONGS, .range = "[1, 100000]", ARRAY_AT(struct observable_request, cells, directions),
     .help = "for lacey: cells of the box along x, y and z", .example = "[10, 1, 20]"},
    {.key = "components", .type = SCHEMA_NAME, .names = schema_components, .fallback = "all",
     AT(struct observable_request, components), .help = "components of a vector", .example = "z"},
};
static const struct schema_table request_table = TABLE(request_rows);

static const struct schema_name region_shape_names[] = {{"box", OUTPUT_REGION_BOX, NULL},
                                                        {"sphere", OUTPUT_REGION_SPHERE, NULL},
                                                        {"cylinder", OUTPUT_REGION_CYLINDER, NULL},
                                                        {0}};
static const struct schema_row region_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .required = true, .in_column = SCHEMA_COLUMN_NAME, AT(struct output_region, name),
     .help = "name of the region for observables", .example = "upper_right"},
    {.key = "shape", .type = SCHEMA_NAME, .names = region_shape_names, .required = true,
     AT(struct output_region, shape), .help = "the shape", .example = "box"},
    {.key = "lower", .type = SCHEMA_VECTOR, .unit = "m", .range = "[-inf, inf]",
     .fallback = "[-.inf, -.inf, -.inf]", .when = "shape=box", AT(struct output_region, lower),
     .help = "lower corner; -.inf leaves a side open", .example = "[0, -.inf, 0]"},
    {.key = "upper", .type = SCHEMA_VECTOR, .unit = "m", .range = "[-inf, inf]",
     .fallback = "[.inf, .inf, .inf]", .when = "shape=box", AT(struct output_region, upper),
     .help = "upper corner; .inf leaves a side open"},
    {.key = "centre", .type = SCHEMA_VECTOR, .unit = "m", .when = "shape=sphere|cylinder", .required = true,
     AT(struct output_region, centre), .help = "centre of the sphere; middle of the cylinder's axis",
     .example = "[0, 0, 5 cm]"},
    {.key = "axis", .type = SCHEMA_VECTOR, .when = "shape=cylinder", .required = true,
     AT(struct output_region, axis), .help = "direction of the axis", .example = "[0, 0, 1]"},
    {.key = "radius", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "shape=sphere|cylinder",
     .required = true, AT(struct output_region, radius), .help = "radius", .example = "2 cm"},
    {.key = "length", .type = SCHEMA_REAL, .unit = "m", .range = "[0, inf)", .fallback = "0",
     .when = "shape=cylinder", AT(struct output_region, length),
     .help = "whole length along the axis; 0: infinite"},
};
static const struct schema_table region_table = TABLE(region_rows);

static const struct schema_row plane_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .required = true, .in_column = SCHEMA_COLUMN_NAME, AT(struct output_plane, name),
     .help = "name of the plane for observables", .example = "outlet"},
    {.key = "point", .type = SCHEMA_VECTOR, .unit = "m", .required = true, AT(struct output_plane, point),
     .help = "a point of the plane", .example = "[0, 0, 0]"},
    {.key = "normal", .type = SCHEMA_VECTOR, .required = true, AT(struct output_plane, normal),
     .help = "direction in which crossings count as positive; any length; along a periodic direction, or across all of them",
     .example = "[0, 0, -1]"},
};
static const struct schema_table plane_table = TABLE(plane_rows);

static const struct schema_name kernel_names[] = {
    {"cells", OUTPUT_KERNEL_CELLS, "a particle counts in the cell of its centre; sums over the cells are exact"},
    {"gauss", OUTPUT_KERNEL_GAUSS, "a Gaussian around each centre, cut at four widths: smooth fields"},
    {0}};
static const struct schema_row grid_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .required = true, .in_column = SCHEMA_COLUMN_NAME, AT(struct output_grid, name),
     .help = "the file is grid-NAME.csv", .example = "height"},
    {.key = "every", EVERY(struct output_grid, every), .help = "interval; left out: that of the observables"},
    {.key = "cells", .type = SCHEMA_LONGS, .range = "[1, 100000]", .required = true,
     ARRAY_AT(struct output_grid, cells, directions),
     .help = "cells along x, y and z; with 1 along two directions the grid is a profile along the third", .example = "[1, 1, 50]"},
    {.key = "lower", .type = SCHEMA_VECTOR, .unit = "m", AT(struct output_grid, lower),
     .help = "lower corner; left out, with upper: the box, also where the box moves", .example = "[0, 0, 0]"},
    {.key = "upper", .type = SCHEMA_VECTOR, .unit = "m", AT(struct output_grid, upper), .help = "upper corner",
     .example = "[5 cm, 5 cm, 10 cm]"},
    {.key = "kernel", .type = SCHEMA_NAME, .names = kernel_names, .fallback = "cells", AT(struct output_grid, kernel),
     .help = "how particles and contacts are spread over the grid"},
    {.key = "width", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "kernel=gauss", .required = true,
     AT(struct output_grid, width), .help = "standard deviation of the Gaussian; about a diameter is usual", .example = "3 mm"},
};
static const struct schema_table grid_table = TABLE(grid_rows);

static const struct schema_row observables_rows[] = {
    {.key = "every", EVERY(struct observables_options, every),
     .help = "interval of the rows; a bare number counts steps, {time: ...} is simulated time"},
    {.key = "regions", .type = SCHEMA_LIST, .sub = &region_table,
     ARRAY_AT(struct observables_options, region, regions),
     .help = "regions in which particles are counted by their centres; lower faces belong to a region"},
    {.key = "planes", .type = SCHEMA_LIST, .sub = &plane_table,
     ARRAY_AT(struct observables_options, plane, planes),
     .help = "planes that particles cross, for crossed and crossed_mass"},
    {.key = "grids", .type = SCHEMA_LIST, .sub = &grid_table,
     ARRAY_AT(struct observables_options, grid, grids),
     .help = "profiles and coarse-grained fields (coarse-graining by the kernel of Goldhirsch): density, velocity, granular temperature, stress in cells"},
    {.key = "list", .type = SCHEMA_LIST, .sub = &request_table,
     ARRAY_AT(struct observables_options, request, count),
     .help = "the observables; left out: energies, momentum, contacts"},
};
const struct schema_table schema_observables = TABLE(observables_rows);
