/* SPDX-License-Identifier: BSD-3-Clause */
/* The input of all writers: a view of the run at one full step, and the data that stay the same during a run.
 * engine/ fills both, and the writers borrow both for a call. Only formats/ uses HDF5. All ranks together
 * write HDF5 files, rank 0 writes text files. */
#ifndef SCREE_FORMATS_OUTPUT_H
#define SCREE_FORMATS_OUTPUT_H

#include "kernel/comm/comm.h"
#include "physics/grains/walls/wall.h"
#include "base/error.h"
#include "physics/grains/motion/integrator.h"
#include "data/formats/lineage.h"
#include "data/formats/output_options.h"
#include "physics_table.h"

/* Data that stay the same during a run. */
struct output_run {
    const char *directory;
    const char *scene;             /* text of the effective scene */
    const struct lineage *lineage; /* this run and those before */
    bool dimensionless;            /* no unit strings */
    bool varying;                  /* particles are inserted or deleted: all elements are time-dependent */
    uint64_t seed;
    int groups;                               /* of the scene; 0: none are known */
    const char *group[INTEGRATOR_GROUPS_MAX]; /* their names */
    int materials;
    const struct law_material *material; /* `materials` rows: names */
};

/* The communication of this rank, for observables. A resume starts the sums again. */
struct output_load {
    uint64_t ghosts;          /* copies held now */
    uint64_t messages, bytes; /* sent to other ranks since this program began */
    double work, waiting;     /* seconds of work, and in communication, since the program's first step */
};

/* Particles that have come and gone since the start of the run, over resumes. */
struct output_turnover {
    uint64_t inserted, deleted;
    double inserted_mass;
    double deleted_mass; /* this rank's part */
};

/* Net crossings of a plane since the start, without the part that the particles of the moment tell (data/observe/crossing.h);
 * this rank's part. */
struct output_crossing {
    double particles, mass;
};

/* The run at the end of a step: positions and forces of this moment, velocities of half a step before. */
struct output_view {
    const struct comm *comm;
    const struct particles *particles; /* ghosts are ignored */
    const struct box *box;
    const struct integrator_context *motion; /* makes full-step velocities: dt, gravity, groups */
    const struct walls *walls;               /* NULL: none */
    const struct force_context *contact;     /* NULL: no particle contacts (contact lists) */
    const struct force_sums *sums;           /* of the last evaluation, this rank's part; NULL: zeros */
    double taken;                            /* sum of force_sums.taken since the start, this rank's part */
    double held,
        gone; /* energy that other physics than grains hold, and have taken for good less that which they gave, this rank's
               * part */
    uint64_t step;
    double time;
    bool
        staged; /* the scene has stages, which may bring gravity and walls: their columns are there from the start */
    struct output_load load;
    struct output_turnover turnover;
    const struct output_crossing *crossing; /* by plane of the observables */
    const void
        *own[PHYSICS_COUNT]; /* the own data of the physics, for their observables; NULL: not in the run */
};

/* True if an HDF5 file is still open because a write or the closing failed, for example on a full disk. HDF5
 * would try again in MPI_Finalize, and crash or wait for ever (HDF5 1.10), so the program must end by
 * comm_abort. */
bool output_left_open(void);

#endif
