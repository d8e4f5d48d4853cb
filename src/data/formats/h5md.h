/* SPDX-License-Identifier: BSD-3-Clause */
/* DIR/trajectory.h5: H5MD 1.1 by parallel HDF5, with DIR/trajectory.xdmf beside it for ParaView.
 *
 * The file is open only while data are added, so a run that crashes leaves a complete file. All elements of a
 * frame share step and time by hard links. While the number of particles is fixed, id, radius, mass and
 * material are fixed datasets; if particles come and go (`varying`), these datasets depend on time too,
 * absent rows have id -1, and /parameters/frames/rows counts the rows of each frame that are particles. */
#ifndef SCREE_FORMATS_H5MD_H
#define SCREE_FORMATS_H5MD_H

#include "data/formats/h5md_parts.h"
#include "data/formats/h5md_observables.h"
#include "data/formats/lineage.h"

struct h5md;

/* The data for the head of the file. */
struct h5md_head {
    const struct lineage *lineage;      /* for /parameters/runs; borrowed; NULL: none */
    const struct output_shapes *shapes; /* for /parameters/shapes; borrowed; NULL: none */
    bool dimensionless;                 /* no units are written */
    bool varying;
    bool xdmf;
    bool single; /* values of each frame are floats, not doubles */
    int deflate; /* compression of the frames, 1 to 9; 0: none */
    uint64_t seed;
};

/* True if a run can go on with the trajectory at `path`, which is there; `varying`: its particles may come and go. Changes
 * nothing. Collective. */
bool h5md_suits(const struct comm *comm, const char *path, bool varying, struct error *error);

/* Prepares a writer for `path` (which ends in .h5). resume_step < 0: the first frame makes a new file. Else
 * frames after that step are cut off, new frames follow, and missing parts are made; a file made for a fixed
 * number of particles is refused (user), and stays unchanged, if the number now varies. Collective. */
bool h5md_open(struct h5md **h5md, const struct comm *comm, const char *path, const struct h5md_head *head,
               int64_t resume_step, struct error *error);

/* Writes the waiting rows of observables, if the file exists. Collective. */
bool h5md_flush(struct h5md *h5md, struct error *error);

/* Writes the waiting rows and the final XDMF file, and frees. Collective. */
bool h5md_close(struct h5md **h5md, struct error *error);

/* Writes an XDMF file for a trajectory that this program wrote. comm is that of one rank. */
bool h5md_write_xdmf(const char *path, const char *xdmf_path, const struct comm *comm, struct error *error);

#endif
