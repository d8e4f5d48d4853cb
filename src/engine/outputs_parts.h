/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the outputs of a run. */
#ifndef SCREE_ENGINE_OUTPUTS_PARTS_H
#define SCREE_ENGINE_OUTPUTS_PARTS_H

#include "engine/outputs.h"
#include "data/formats/dump.h"
#include "data/formats/h5md.h"
#include "data/formats/output_shapes.h"
#include "data/formats/wall_frames.h"
#include "data/observe/observables_grid.h"

struct outputs {
    const struct output_options *options; /* borrowed from the scene */
    const struct output_run *run;         /* borrowed */
    struct observables *observables;      /* NULL: not asked for */
    bool row_written;                     /* of the observables */
    struct h5md *h5md;
    struct output_shapes shapes; /* for it */
    struct dump *dump;
    struct wall_frames *walls;
    struct grid *grid[OUTPUT_GRIDS_MAX];
};

#endif
