/* SPDX-License-Identifier: BSD-3-Clause */
/* The runs that led to a state, the first one first: from which step on, by which program, with which scene.
 * Files carry it, so that what was computed with what stays known after a resume. */
#ifndef SCREE_FORMATS_LINEAGE_H
#define SCREE_FORMATS_LINEAGE_H

#include "formats/output_options.h"
#include <stddef.h>
#include <stdint.h>

struct lineage_run {
    uint64_t step; /* the state it began from: what comes after it is this run's */
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

/* Adds a run of this program, but not where the last one is of the same version, revision and scene. */
void lineage_go_on(struct lineage *lineage, uint64_t step, const char *scene);

void lineage_free(struct lineage *lineage);

#endif
