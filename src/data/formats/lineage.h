/* SPDX-License-Identifier: BSD-3-Clause */
/* The runs that led to a state, in order: first step, program and scene of each. Files contain the lineage,
 * so that program and scene of each part stay known after a resume. */
#ifndef SCREE_FORMATS_LINEAGE_H
#define SCREE_FORMATS_LINEAGE_H

#include "data/formats/output_options.h"
#include <stddef.h>
#include <stdint.h>

struct lineage_run {
    uint64_t step; /* the step of the state from which the run began; later steps are of this run */
    char version[OUTPUT_NAME_MAX], revision[OUTPUT_NAME_MAX];
    char *scene; /* owned: text of the effective scene */
};

/* All zero: no run. */
struct lineage {
    size_t count;
    struct lineage_run *run; /* owned */
};

/* Adds a run; the texts are copied. */
void lineage_add(struct lineage *lineage, uint64_t step, const char *version, const char *revision,
                 const char *scene);

/* Adds a run of this program, unless the last run has the same version, revision and scene. */
void lineage_go_on(struct lineage *lineage, uint64_t step, const char *scene);

void lineage_free(struct lineage *lineage);

#endif
