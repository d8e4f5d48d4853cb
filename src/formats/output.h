/* SPDX-License-Identifier: BSD-3-Clause */
/* What all writers look at: a view of the run at one full step, and what stays the same during a run. Both
 * are filled by engine/ and borrowed for a call. formats/ alone knows HDF5; files are written by all ranks
 * together, text files by rank 0. */
#ifndef SCREE_FORMATS_OUTPUT_H
#define SCREE_FORMATS_OUTPUT_H

#include "comm/comm.h"
#include "walls/wall.h"
#include "core/error.h"
#include "integrate/integrator.h"
#include "formats/lineage.h"
#include "formats/output_options.h"

/* Fixed during a run. */
struct output_run {
    const char *directory;
    const char *scene;             /* text of the effective scene */
    const struct lineage *lineage; /* this run and those before */
    bool dimensionless;            /* no unit strings */
    bool varying; /* particles are inserted or deleted: everything is written time-dependent */
    uint64_t seed;
    int materials;
    const struct law_material *material; /* `materials` rows: names */
};

/* What communication of this rank amounts to, for observables. Sums begin again with a resume. */
struct output_load {
    uint64_t ghosts;          /* copies held now */
    uint64_t messages, bytes; /* sent to other ranks since this program began */
    double work, waiting;     /* seconds of work, and in communication, since its first step */
};

/* The run at the end of a step: positions and forces of this moment, velocities half a step behind. */
struct output_view {
    const struct comm *comm;
    const struct particles *particles; /* ghosts are ignored */
    const struct box *box;
    const struct integrator_context *motion; /* makes full-step velocities: dt, gravity, groups */
    const struct walls *walls;               /* NULL: none */
    const struct force_context *contact;     /* NULL: no particle contacts (contact lists) */
    const struct force_sums *sums;           /* of the last evaluation, this rank's part; NULL: zeros */
    double taken;                            /* sum of force_sums.taken since the start, this rank's part */
    uint64_t step;
    double time;
    struct output_load load;
};

/* True if a file of HDF5 is still open, because a write or its closing failed, as on a full disk: HDF5 would
 * try again in MPI_Finalize, and crash or wait for ever (HDF5 1.10), so the program must end otherwise
 * (comm_abort). */
bool output_left_open(void);

#endif
