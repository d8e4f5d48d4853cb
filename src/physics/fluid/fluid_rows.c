/* SPDX-License-Identifier: BSD-3-Clause */
/* The section of a fluid in a scene. */
#include "physics/fluid/fluid.h"
#include "physics/fluid/carried/electrolyte_rows.h"
#include "physics/fluid/carried/scalars_rows.h"
#include "physics_table.h"
#include "data/scene/scene.h"
#include "data/scene/schema_rows.h"
#include "data/scene/schema_particles.h"

/* One row a key, packed to the line: */
/* clang-format off */
static const struct schema_name equations_names[] = {
    {"stokes", FLUID_STOKES, "no inertia"},
    {"navier_stokes", FLUID_NAVIER_STOKES, "with inertia"},
    {0}};
static const struct schema_name time_names[] = {
    {"steady", FLUID_STEADY, "the flow that no longer changes, solved for directly"},
    {"transient", FLUID_TRANSIENT, "step after step"},
    {0}};
static const struct schema_name motion_names[] = {
    {"fixed", FLUID_FIXED, "the particles stay, and the fluid flows through them"},
    {"lagrangian", FLUID_LAGRANGIAN, "the particles move with the fluid"},
    {"ale", FLUID_ALE, "the particles are points with a velocity of their own"},
    {0}};
static const struct schema_name shifting_names[] = {
    {"lind", FLUID_SHIFT_LIND, "against the gradient of their concentration (Lind et al. 2012)"},
    {"none", FLUID_SHIFT_NONE, "for comparison: particles gather and leave gaps"},
    {0}};
static const struct schema_name operators_names[] = {
    {"corrected", WEIGHTS_CORRECTED, "of second order on any arrangement"},
    {"standard", WEIGHTS_STANDARD, "without corrections: for comparison, on lattices"},
    {"mls", WEIGHTS_MLS, "moving least squares: polynomials fitted to neighbours"},
    {0}};
static const struct schema_name kernel_names[] = {
    {"wendland_c2", KERNEL_WENDLAND_C2, NULL}, {"wendland_c4", KERNEL_WENDLAND_C4, NULL},
    {"wendland_c6", KERNEL_WENDLAND_C6, NULL}, {"quintic", KERNEL_QUINTIC, "spline"}, {0}};
static const struct schema_name arrangement_names[] = {
    {"cubic", FLUID_CUBIC, "simple cubic, in two dimensions square"},
    {"bcc", FLUID_BCC, "body-centred cubic, in three dimensions"},
    {"fcc", FLUID_FCC, "face-centred cubic, twelve neighbours each, in three dimensions"},
    {"hexagonal", FLUID_HEXAGONAL, "six neighbours each, in two dimensions"},
    {0}};
static const struct schema_name profile_names[] = {
    {"uniform", FLUID_UNIFORM, "the same velocity everywhere"},
    {"taylor_green", FLUID_TAYLOR_GREEN, "vortices of a periodic box, one wave an edge: u = U sin kx cos ky, v = -U cos kx sin ky"},
    {0}};
static const struct schema_name wall_names[] = {
    {"no_slip", 0, "the fluid sticks to walls and grains"}, {"slip", 1, "Navier's condition, with a slip length"}, {0}};
static const struct schema_name preconditioner_names[] = {
    {"boomeramg", FLUID_BOOMERAMG, "algebraic multigrid of hypre"},
    {"gamg", FLUID_GAMG, "algebraic multigrid of PETSc itself"},
    {0}};

static const struct schema_row motion_rows[] = {
    {.key = "name", .type = SCHEMA_NAME, .names = motion_names, .fallback = "fixed", AT(struct fluid_motion, name),
     .help = "the motion"},
    {.key = "shifting", .type = SCHEMA_NAME, .names = shifting_names, .fallback = "lind", .when = "name=lagrangian",
     AT(struct fluid_motion, shifting), .help = "a small velocity that keeps particles apart"},
    {.key = "strength", .type = SCHEMA_REAL, .range = "(0, 20]", .fallback = "2", .when = "name=lagrangian & shifting=lind",
     AT(struct fluid_motion, strength), .help = "A of the shift -A spacing U grad C, U the largest speed"},
    {.key = "filter", .type = SCHEMA_REAL, .range = "[0, 2]", .fallback = "0.5", .when = "name=lagrangian|ale",
     AT(struct fluid_motion, filter), .help = "time, in steps, of the filter against pressures that alternate between neighbours; 0: none"},
    {.key = "velocity", .type = SCHEMA_VECTOR, .unit = "m/s", .fallback = "[0, 0, 0]", .when = "name=ale",
     AT(struct fluid_motion, velocity), .help = "velocity of all points, along periodic directions"},
    {.key = "swing", .type = SCHEMA_VECTOR, .unit = "m", .fallback = "[0, 0, 0]", .when = "name=ale", AT(struct fluid_motion, swing),
     .help = "amplitude of a standing wave of the points, one wave an edge (half a wave where the box is not periodic)"},
    {.key = "period", .type = SCHEMA_REAL, .unit = "s", .range = "(0, inf)", .fallback = "1", .when = "name=ale",
     AT(struct fluid_motion, period), .help = "period of the swing", .example = "0.5 s"},
};
static const struct schema_table motion_table = TABLE(motion_rows);

static const struct schema_name grains_names[] = {
    {"given", FLUID_GRAINS_GIVEN, "stand still, or move as their group says"},
    {"free", FLUID_GRAINS_FREE, "the fluid moves them, too: its force and torque, and buoyancy"},
    {0}};
static const struct schema_name coupling_names[] = {
    {"auto", FLUID_AUTO, "rigid where the fluid moves grains (motion: free) and its particles stay, else mirror"},
    {"mirror", FLUID_MIRROR, "grains are holes in the fluid, with boundary particles behind their surfaces"},
    {"rigid", FLUID_RIGID, "the fluid fills the whole box, on particles at rest, and is made rigid inside of grains: grains may touch"},
    {0}};
static const struct schema_row grains_rows[] = {
    {.key = "motion", .type = SCHEMA_NAME, .names = grains_names, .fallback = "given", AT(struct fluid_grains, motion),
     .help = "the motion of grains in the fluid"},
    {.key = "coupling", .type = SCHEMA_NAME, .names = coupling_names, .fallback = "auto", AT(struct fluid_grains, coupling),
     .help = "the way in which fluid and grains act on each other"},
    {.key = "every", .type = SCHEMA_INT, .range = "[1, 1000000]", .fallback = "1",
     AT(struct fluid_grains, every), .help = "steps of grains that the fluid moves in one of the fluid, whose force or velocity is held meanwhile", .example = "20"},
    {.key = "unresolved", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", AT(struct fluid_grains, unresolved),
     .help = "radius up to which grains are not resolved: the law of the section drag moves them, and the fluid loses what they gain; left out: none",
     .example = "50 um"},
    {.key = "hydraulic", .type = SCHEMA_REAL, .range = "[0.5, 1]", .fallback = "1", AT(struct fluid_grains, hydraulic),
     .help = "radius of a grain to the fluid over that of its contacts, with coupling: rigid: in two dimensions 0.8 leaves open the pores between discs that touch"},
    {.key = "lubrication", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", AT(struct fluid_grains, lubrication),
     .help = "the roughness: gaps from two spacings down to it have the part of lubrication that the spacing does not resolve; with coupling: rigid; left out: no gap has",
     .example = "1 um"},
};
static const struct schema_table grains_table = TABLE(grains_rows);

static const struct schema_row operators_rows[] = {
    {.key = "name", .type = SCHEMA_NAME, .names = operators_names, .fallback = "corrected",
     AT(struct fluid_operators, name), .help = "the operators"},
    {.key = "order", .type = SCHEMA_INT, .range = "[1, 4]", .fallback = "2", .when = "name=mls", AT(struct fluid_operators, order),
     .help = "order of the polynomials; 1 has the Laplacian of the corrected operators. In time 1; without walls, grains and open sides also 2 and 4"},
};
static const struct schema_table operators_table = TABLE(operators_rows);

static const struct schema_row kernel_rows[] = {
    {.key = "name", .type = SCHEMA_NAME, .names = kernel_names, .fallback = "wendland_c2",
     AT(struct fluid_kernel, name), .help = "the smoothing kernel"},
    {.key = "support", .type = SCHEMA_REAL, .range = "(1.42, 6]", AT(struct fluid_kernel, support),
     .help = "support radius over spacing; left out: on lattices 2.2, bcc 1.95, fcc 2.1, in two dimensions 2.3, hexagonal 2.4; with jitter 2.8 (3.1)",
     .example = "2.2"},
};
static const struct schema_table kernel_table = TABLE(kernel_rows);

static const struct schema_row fill_rows[] = {
    {.key = "region", .type = SCHEMA_SECTION, .sub = &schema_region, .offset = offsetof(struct fluid_fill, region),
     .help = "the region that the fluid fills, except for grains and for the space behind walls"},
    {.key = "arrangement", .type = SCHEMA_NAME, .names = arrangement_names, .fallback = "cubic",
     AT(struct fluid_fill, arrangement), .help = "the lattice; those other than cubic are stretched by up to a tenth in each direction to fit the box"},
    {.key = "jitter", .type = SCHEMA_REAL, .range = "[0, 0.8]", .fallback = "0", AT(struct fluid_fill, jitter),
     .help = "displaces each particle at random, by up to half of this times the spacing in each direction"},
    {.key = "offset", .type = SCHEMA_VECTOR, .unit = "m", .fallback = "[0, 0, 0]", AT(struct fluid_fill, offset),
     .help = "shifts the lattice, whose cells else begin at the lower corner of the box"},
};
static const struct schema_table fill_table = TABLE(fill_rows);

static const struct schema_name axis_names[] = {{"x", 0, NULL}, {"y", 1, NULL}, {"z", 2, NULL}, {0}};

static const struct schema_row drive_rows[] = {
    {.key = "body_force", .type = SCHEMA_VECTOR, .unit = "N/m3", .fallback = "[0, 0, 0]",
     AT(struct fluid_drive, body_force),
     .help = "force on a volume of fluid: in a periodic direction minus the mean gradient of pressure",
     .example = "[0, 0, 1000 Pa/m]"},
    {.key = "pressure_drop", .type = SCHEMA_REAL, .unit = "Pa", AT(struct fluid_drive, pressure_drop),
     .help = "instead: drop of the pressure over the box along the axis", .example = "14 Pa"},
    {.key = "mass_flow", .type = SCHEMA_REAL, .unit = "kg/s", AT(struct fluid_drive, mass_flow),
     .help = "instead: mass that flows along the axis, to which the force is fitted (in two dimensions a mass per depth)",
     .example = "2.771e-5"},
    {.key = "axis", .type = SCHEMA_NAME, .names = axis_names, .fallback = "x", AT(struct fluid_drive, axis),
     .help = "direction of pressure_drop and mass_flow, in which the box must be periodic"},
    {.key = "table", .type = SCHEMA_PATH, AT(struct fluid_drive, table),
     .help = "a table of time and of a factor of body_force or pressure_drop, a row a line, linear between rows; before the first and after "
             "the last row their factors", .example = "pulse.txt"},
    {.key = "repeat", .type = SCHEMA_BOOL, .fallback = "false", AT(struct fluid_drive, repeat),
     .help = "the table begins again after its last row: a pulse"},
};
static const struct schema_table drive_table = TABLE(drive_rows);

static const struct schema_row walls_rows[] = {
    {.key = "velocity", .type = SCHEMA_NAME, .names = wall_names, .fallback = "no_slip", AT(struct fluid_walls, condition),
     .help = "the condition at walls and grains"},
    {.key = "slip_length", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .when = "velocity=slip", .required = true,
     AT(struct fluid_walls, slip_length), .help = "depth behind the wall at which the velocity would reach that of the wall",
     .example = "1 um"},
};
static const struct schema_table walls_table = TABLE(walls_rows);

static const struct schema_name open_profile_names[] = {
    {"plug", FLUID_PLUG, "the same all over the side"},
    {"parabolic", FLUID_PARABOLIC, "that of a channel as wide as the box: times 4 s (1 - s) along each direction of the side that "
                                   "is not periodic, s = 0 ... 1 from face to face"},
    {0}};
static const struct schema_row open_rows[] = {
    {.key = "side", .type = SCHEMA_NAME, .names = scalars_sides, .required = true, AT(struct fluid_open, side),
     .help = "side of the box", .example = "x_lower"},
    {.key = "velocity", .type = SCHEMA_VECTOR, .unit = "m/s", AT(struct fluid_open, velocity),
     .help = "velocity that is given there", .example = "[1, 0, 0]"},
    {.key = "profile", .type = SCHEMA_NAME, .names = open_profile_names, .fallback = "plug", AT(struct fluid_open, profile),
     .help = "the velocity over the side"},
    {.key = "pressure", .type = SCHEMA_REAL, .unit = "Pa", AT(struct fluid_open, pressure),
     .help = "instead: pressure that is given there; the velocity does not change along the normal", .example = "0"},
};
static const struct schema_table open_table = TABLE(open_rows);

static const struct schema_row initial_rows[] = {
    {.key = "flow", .type = SCHEMA_NAME, .names = profile_names, .fallback = "uniform", AT(struct fluid_initial, profile),
     .help = "the flow at the start"},
    {.key = "velocity", .type = SCHEMA_VECTOR, .unit = "m/s", .fallback = "[0, 0, 0]", .when = "flow=uniform",
     AT(struct fluid_initial, velocity), .help = "velocity at the start"},
    {.key = "speed", .type = SCHEMA_REAL, .unit = "m/s", .required = true, .when = "flow=taylor_green",
     AT(struct fluid_initial, speed), .help = "largest speed", .example = "1"},
};
static const struct schema_table initial_table = TABLE(initial_rows);

static const struct schema_row solver_rows[] = {
    {.key = "preconditioner", .type = SCHEMA_NAME, .names = preconditioner_names, .fallback = "boomeramg",
     AT(struct fluid_solver, preconditioner), .help = "of the pressure, and of the velocity where steps are long"},
    {.key = "tolerance", .type = SCHEMA_REAL, .range = "(0, 1)", AT(struct fluid_solver, tolerance),
     .help = "steady: change of the mean flow at which the solver ends, 1e-3 if left out; transient: relative residual of the "
             "pressure, else 1e-5"},
    {.key = "reuse", .type = SCHEMA_INT, .range = "[0, 1000]", .fallback = "5", AT(struct fluid_solver, reuse),
     .help = "how often the preconditioner of the pressure is kept for a matrix with new values, as particles that move make them; it is made "
             "again sooner if a solve takes more than half as many iterations again as the first one with it"},
    {.key = "petsc", .type = SCHEMA_TEXT, .fallback = "", AT(struct fluid_solver, petsc),
     .help = "options for PETSc, as on a command line; prefixes fluid_u_, fluid_p_, fluid_s_, of scalars fluid_c_, fluid_f_, of an electrolyte fluid_e_",
     .example = "-fluid_p_ksp_monitor"},
};
static const struct schema_table solver_table = TABLE(solver_rows);

static const struct schema_row section[] = {
    {.key = "spacing", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .required = true,
     AT(struct fluid_options, spacing), .help = "edge of the cube (in two dimensions the square) that is a fluid particle's; on the cubic lattice the distance of neighbours",
     .example = "60 um"},
    {.key = "density", .type = SCHEMA_REAL, .unit = "kg/m3", .range = "(0, inf)", .required = true,
     AT(struct fluid_options, density), .help = "mass of a volume", .example = "997.561"},
    {.key = "viscosity", .type = SCHEMA_REAL, .unit = "Pa s", .range = "(0, inf)", .required = true,
     AT(struct fluid_options, viscosity), .help = "dynamic viscosity", .example = "8.887e-4"},
    {.key = "equations", .type = SCHEMA_NAME, .names = equations_names, .fallback = "navier_stokes",
     AT(struct fluid_options, equations), .help = "the equations of the flow"},
    {.key = "time", .type = SCHEMA_NAME, .names = time_names, .fallback = "transient", AT(struct fluid_options, time),
     .help = "a flow in time, or the steady one (of stokes)"},
    {.key = "motion", .type = SCHEMA_SECTION, .sub = &motion_table, .main = "name", .offset = offsetof(struct fluid_options, motion),
     .help = "the motion of the particles of the fluid"},
    {.key = "grains", .type = SCHEMA_SECTION, .sub = &grains_table, .main = "motion", .offset = offsetof(struct fluid_options, grains),
     .help = "the motion of grains in the fluid"},
    {.key = "operators", .type = SCHEMA_SECTION, .sub = &operators_table, .main = "name",
     .offset = offsetof(struct fluid_options, operators), .help = "gradient, divergence and Laplacian"},
    {.key = "kernel", .type = SCHEMA_SECTION, .sub = &kernel_table, .main = "name",
     .offset = offsetof(struct fluid_options, kernel), .help = "the kernel and its support"},
    {.key = "fill", .type = SCHEMA_SECTION, .sub = &fill_table, .offset = offsetof(struct fluid_options, fill),
     .help = "places of the particles of the fluid"},
    {.key = "drive", .type = SCHEMA_SECTION, .sub = &drive_table, .offset = offsetof(struct fluid_options, drive),
     .help = "the drive of the flow, besides moving walls"},
    {.key = "walls", .type = SCHEMA_SECTION, .sub = &walls_table, .main = "velocity",
     .offset = offsetof(struct fluid_options, walls), .help = "conditions at walls and grains"},
    {.key = "open", .type = SCHEMA_LIST, .sub = &open_table, ARRAY_AT(struct fluid_options, open, opens),
     .help = "open sides of the box, where fluid comes and goes"},
    {.key = "initial", .type = SCHEMA_SECTION, .sub = &initial_table, .main = "flow",
     .offset = offsetof(struct fluid_options, initial), .help = "the fluid at the start"},
    {.key = "solver", .type = SCHEMA_SECTION, .sub = &solver_table, .offset = offsetof(struct fluid_options, solver),
     .help = "linear algebra, by PETSc"},
    {.key = "scalars", .type = SCHEMA_LIST, .sub = &scalars_table, ARRAY_AT(struct fluid_options, scalar, scalars),
     .help = "concentrations or temperatures that the fluid carries, and that do not act on the flow"},
    {.key = "electrolyte", .type = SCHEMA_SECTION, .sub = &electrolyte_table, .optional = true,
     .offset = offsetof(struct fluid_options, electrolyte), .count_offset = offsetof(struct fluid_options, electrolytes),
     .help = "ions in the fluid, charged walls and grains, and an applied field that drives the ions and with them the fluid"},
};
const struct schema_table fluid_schema = TABLE(section);

/* clang-format on */

_Static_assert(sizeof(struct fluid_options) <= PHYSICS_OPTIONS_MAX * sizeof(double), "room in struct scene");
