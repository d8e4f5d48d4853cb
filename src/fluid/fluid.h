/* SPDX-License-Identifier: BSD-3-Clause */
/* An incompressible fluid as a physics: the section `fluid` of a scene (fluid_rows.c has its keys). */
#ifndef SCREE_FLUID_FLUID_H
#define SCREE_FLUID_FLUID_H

#include "fluid/kernel.h"
#include "scene/region.h"

enum fluid_equations { FLUID_STOKES, FLUID_NAVIER_STOKES };
enum fluid_time { FLUID_STEADY, FLUID_TRANSIENT };
enum fluid_arrangement { FLUID_CUBIC, FLUID_BODY_CENTRED, FLUID_HEXAGONAL };
enum fluid_profile { FLUID_UNIFORM, FLUID_TAYLOR_GREEN };
enum fluid_preconditioner { FLUID_BOOMERAMG, FLUID_GAMG };
enum { FLUID_PETSC_MAX = 512 };

/* The particles of the fluid. */
struct fluid_fill {
    struct region region; /* the user's coordinates */
    enum fluid_arrangement arrangement;
    double jitter;    /* displacements of up to +- jitter spacing / 2 in each direction */
    double offset[3]; /* of the lattice, length */
};

struct fluid_drive {
    double body_force[3]; /* force/volume on the fluid: minus the mean gradient of pressure */
};

struct fluid_walls {
    double slip_length; /* length; 0: no slip */
};

struct fluid_initial {
    enum fluid_profile profile;
    double velocity[3]; /* UNIFORM: that of all; TAYLOR_GREEN: amplitude in velocity[0] */
};

struct fluid_solver {
    enum fluid_preconditioner preconditioner;
    double tolerance; /* STEADY: change of the flow rate; TRANSIENT: of the pressure, relative residual */
    char petsc[FLUID_PETSC_MAX]; /* options handed on to PETSc */
};

/* Lengths, times and masses in the units of the scene. */
struct fluid_options {
    double spacing, density, viscosity; /* dynamic viscosity */
    enum fluid_equations equations;
    enum fluid_time time;
    enum kernel_name kernel;
    double support; /* support radius over spacing */
    struct fluid_fill fill;
    struct fluid_drive drive;
    struct fluid_walls walls;
    struct fluid_initial initial;
    struct fluid_solver solver;
};

#endif
