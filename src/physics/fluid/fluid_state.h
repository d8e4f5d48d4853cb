/* SPDX-License-Identifier: BSD-3-Clause */
/* The state of a fluid between its passes: `self` of fluid_physics. */
#ifndef SCREE_FLUID_FLUID_STATE_H
#define SCREE_FLUID_FLUID_STATE_H

#include "physics/fluid/lattice/arrangement.h"
#include "physics/fluid/schemes/flow_drive.h"
#include "physics/fluid/fluid.h"
#include "physics/fluid/operators/surface_forces.h"
#include "physics/fluid/schemes/projection.h"
#include "physics/fluid/schemes/steady.h"

struct rigid;
struct lubrication_pairs;
struct scalars;
struct electrolyte;
struct unresolved;

struct fluid {
    const struct fluid_options *options; /* borrowed */
    double support;                      /* radius, length */
    struct arrangement lattice;
    double volume; /* of a particle on the lattice, length^dimension; 0: they differ */
    struct weights weights;
    struct weights_input input;   /* of the weights; what it borrows lives until the next rebuild */
    struct weights_options weigh; /* their options */
    struct pair_rows pairs;       /* of the last rebuild; kept where particles move */
    bool riding;                  /* boundary particles follow grains that move (boundary_motion.h) */
    uint64_t followed;            /* the last step in which particles of this rank followed the flow */
    uint64_t placed;              /* the step for whose places the weights are */
    double
        rows[4]; /* of all ranks: fluid particles, those without the operators asked for, those behind a body;
                       feet of particles on grains and meshes */
    size_t lost; /* wall neighbours without a body */
    bool filled; /* its particles were made by this run, not by an earlier stage or the run of a checkpoint */
    uint64_t layout; /* checksum of the particles for which the matrices were made; 0: none */
    int regions;     /* connected regions */
    struct flow flow;
    struct solve *solve;           /* NULL: not begun */
    bool first;                    /* this is rank 0 */
    const struct log *log;         /* of warnings; borrowed */
    bool renew;                    /* a checkpoint was written since the last step */
    int64_t doubtful;              /* solves so far with a residual far above the tolerance */
    int leaking;                   /* steps up to now in which water got lost (flow_loss.h) */
    bool leaked;                   /* that was told */
    struct projection *projection; /* NULL: no matrices yet */
    struct projection_past past;
    struct drive drive;
    struct forces forces;  /* of the last look */
    struct steady *steady; /* of a steady flow; NULL: no matrices yet */
    struct steady_report report;
    int64_t solved;                  /* 1: the steady flow is there */
    struct scalars *scalars;         /* scalars.h; NULL: none */
    struct electrolyte *electrolyte; /* electrolyte.h; NULL: none */
    uint64_t done;                   /* the last step that was made */
    struct gaps *gaps;               /* narrow_gaps.h; NULL: not looked for */
    struct unresolved *dust; /* of grains that are not resolved (unresolved_grains.h); NULL: none yet */
    double (*jump)
        [6]; /* by particle number: by how much the fluid has changed velocity and spin of grains in this step; NULL: not */
    struct rigid *rigid; /* of grains in which the flow is rigid (rigid_step.h); NULL: mirrors */
    struct lubrication_pairs *lubrication; /* lubrication_pairs.h; NULL: not wanted */
    bool apart;         /* it was told that forces and velocities of grains do not agree (coupled_solve.h) */
    double work;        /* on grains that the fluid moves, since the start; energy */
    struct error error; /* until the guard takes it */
};

#endif
