/* SPDX-License-Identifier: BSD-3-Clause */
/* An incompressible fluid as a physics: the section `fluid` of a scene (fluid_rows.c has its keys). */
#ifndef SCREE_FLUID_FLUID_H
#define SCREE_FLUID_FLUID_H

#include "base/file.h"
#include "physics/fluid/operators/weights.h"
#include "data/scene/region.h"

enum fluid_equations { FLUID_STOKES, FLUID_NAVIER_STOKES };
enum fluid_time { FLUID_STEADY, FLUID_TRANSIENT };
enum fluid_arrangement { FLUID_CUBIC, FLUID_BCC, FLUID_FCC, FLUID_HEXAGONAL };
enum fluid_profile { FLUID_UNIFORM, FLUID_TAYLOR_GREEN };
enum fluid_motions { FLUID_FIXED, FLUID_LAGRANGIAN, FLUID_ALE };
enum fluid_shifting { FLUID_SHIFT_LIND, FLUID_SHIFT_NONE };
enum fluid_preconditioner { FLUID_BOOMERAMG, FLUID_GAMG };
enum { FLUID_PETSC_MAX = 512 };

struct fluid_kernel {
    enum kernel_name name;
    double support; /* support radius over spacing; NAN: fluid_support chooses */
};

/* The particles of the fluid. */
struct fluid_fill {
    struct region region; /* the user's coordinates */
    enum fluid_arrangement arrangement;
    double jitter;    /* displacements of up to +- jitter spacing / 2 in each direction */
    double offset[3]; /* of the lattice, length */
};

struct fluid_drive {
    double body_force[3];      /* force/volume on the fluid: minus the mean gradient of pressure */
    double pressure_drop;      /* over the box along `axis`, pressure; NAN: not given */
    double mass_flow;          /* along `axis`, mass/time; NAN: not given */
    int axis;                  /* 0, 1, 2 */
    char table[FILE_PATH_MAX]; /* of time and factor; "": 1 */
    bool repeat;               /* the table begins again after its last time */
};

/* What is given at an open side of the box. */
enum fluid_open_profile { FLUID_PLUG, FLUID_PARABOLIC };
enum { FLUID_OPENS_MAX = 6 };
struct fluid_open {
    int side; /* 2 x direction, 1 more for the upper side */
    enum fluid_open_profile profile;
    double velocity[3]; /* length/time; NAN: not given */
    double pressure;    /* NAN: not given */
};

struct fluid_walls {
    int condition;      /* 1: slip */
    double slip_length; /* length; of slip */
};

struct fluid_initial {
    enum fluid_profile profile;
    double velocity[3]; /* UNIFORM */
    double speed;       /* TAYLOR_GREEN */
};

struct fluid_solver {
    enum fluid_preconditioner preconditioner;
    double
        tolerance; /* STEADY: change of the mean flow; TRANSIENT: relative residual of the pressure; NAN: the
                         scheme's own */
    int reuse;     /* matrices with new values that one preconditioner of the pressure may serve */
    char petsc[FLUID_PETSC_MAX]; /* options handed on to PETSc */
};

/* The largest shift in a step, in spacings. */
#define FLUID_SHIFT_MOST 0.1

/* The motion of the particles (fluid_motion.h). */
struct fluid_motion {
    enum fluid_motions name;
    enum fluid_shifting shifting; /* LAGRANGIAN */
    double strength;              /* of the shift, A */
    double filter;                /* of the pressure, steps */
    double velocity[3], swing[3]; /* ALE: length/time, length */
    double period;                /* of the swing, time */
};

/* Grains in the fluid (grain_coupling.h). */
enum fluid_grains_motion { FLUID_GRAINS_GIVEN, FLUID_GRAINS_FREE };
enum fluid_coupling { FLUID_AUTO, FLUID_MIRROR, FLUID_RIGID }; /* AUTO: fluid_rigid chooses */
struct fluid_grains {
    enum fluid_grains_motion motion;
    enum fluid_coupling coupling;
    int every;          /* steps of the grains in a step of the fluid */
    double unresolved;  /* radius up to which grains are not resolved (unresolved_grains.h); NAN: all are */
    double hydraulic;   /* radius of a grain to the fluid over its own (solid_field.h) */
    double lubrication; /* roughness down to which gaps have lubrication (lubrication.h); NAN: none has */
};

struct fluid_operators {
    enum weights_operators name;
    int order; /* of moving least squares */
};

/* The surface for which a value is given: one of three numbers, the others are -1. */
struct fluid_surface {
    int wall;  /* of a wall */
    int group; /* of a group of grains */
    int side;  /* of an open side of the box: 2 x direction, 1 more for the upper side */
};
enum { FLUID_SURFACES_MAX = 16 };

/* A scalar that the fluid carries. */
enum fluid_advection { FLUID_CENTRAL, FLUID_UPWIND };
enum { FLUID_SCALARS_MAX = 3, FLUID_NAME_MAX = 32 };
struct fluid_value {
    struct fluid_surface at;
    double value;
};
struct fluid_scalar_initial {
    double value, elsewhere; /* in the region, and outside of it */
    struct region region;    /* the user's coordinates */
};
struct fluid_scalar {
    char name[FLUID_NAME_MAX];
    double diffusivity; /* length^2/time */
    enum fluid_advection advection;
    struct fluid_scalar_initial initial;
    int givens;
    struct fluid_value given[FLUID_SURFACES_MAX];
};

/* Ions in the fluid (electrolyte.h), and the charged surfaces around it. */
enum fluid_ions { FLUID_POISSON_BOLTZMANN, FLUID_DEBYE_HUECKEL };
struct fluid_charged {
    struct fluid_surface at;
    double zeta;   /* potential; NAN: not given */
    double charge; /* charge/area; NAN: not given */
    double period; /* > 0: the sign changes after each half of it, along `axis`; NAN: uniform */
    int axis;
};
struct fluid_electrolyte {
    enum fluid_ions equation;
    double permittivity, debye_length, thermal_voltage;
    double field[3]; /* applied, potential/length */
    int surfaces;
    struct fluid_charged surface[FLUID_SURFACES_MAX];
};

/* Lengths, times and masses in the units of the scene. */
struct fluid_options {
    double spacing, density, viscosity; /* dynamic viscosity */
    enum fluid_equations equations;
    enum fluid_time time;
    struct fluid_motion motion;
    struct fluid_grains grains;
    struct fluid_operators operators;
    struct fluid_kernel kernel;
    struct fluid_fill fill;
    struct fluid_drive drive;
    struct fluid_walls walls;
    int opens;
    struct fluid_open open[FLUID_OPENS_MAX];
    struct fluid_initial initial;
    struct fluid_solver solver;
    int scalars;
    struct fluid_scalar scalar[FLUID_SCALARS_MAX];
    int electrolytes; /* 0 or 1 */
    struct fluid_electrolyte electrolyte;
};

/* The support radius, length. */
double fluid_support(const struct fluid_options *options, int dimension);

/* True if grains may move among the particles: boundary particles then ride on them (boundary_motion.h). */
bool fluid_carries(const struct fluid_options *options);

/* True if the fluid fills the whole box, grains included, and is made rigid in them (rigid_step.h). */
bool fluid_rigid(const struct fluid_options *options);

/* The slip length of walls and grains; 0: no slip. */
double fluid_slip(const struct fluid_options *options);

#endif
