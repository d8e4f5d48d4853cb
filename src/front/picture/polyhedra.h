/* SPDX-License-Identifier: BSD-3-Clause */
/* The rocks of a run as polygons for ParaView (data/formats/vtp.h): faces, and edges and corners cut flat. */
#ifndef SCREE_PICTURE_POLYHEDRA_H
#define SCREE_PICTURE_POLYHEDRA_H

#include "base/error.h"
#include "kernel/comm/comm.h"

struct polyhedra_options {
    const char *frame; /* its number as text; NULL: the last, or all in a list */
    bool overwrite;    /* false: an existing output is refused */
};

/* True if a name ends in .vtp or .pvd. */
bool polyhedra_named(const char *out);

/* Writes the rocks of `in`, a file or a folder of a run: to NAME.vtp one frame; to NAME.pvd the list of the files NAME-STEP.vtp of all
 * frames, or of one. A polygon has the values of its rock: id, shape, radius of the ball, material, velocity, angular velocity, as far as the
 * file has them. One rank. Errors: a user's where there are no rocks, or no orientations. */
bool polyhedra_write(const struct comm *comm, const char *in, const char *out,
                     const struct polyhedra_options *options, struct error *error);

#endif
