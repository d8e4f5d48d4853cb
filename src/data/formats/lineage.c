/* SPDX-License-Identifier: BSD-3-Clause */
/* Adds a run to a lineage. Read lineage.h first. */
#include "data/formats/lineage.h"

#include "base/memory.h"
#include "base/version.h"

#include <stdio.h>
#include <string.h>

void lineage_add(struct lineage *lineage, uint64_t step, const char *version, const char *revision,
                 const char *scene) {
    lineage->run = memory_resize(lineage->run, lineage->count + 1, sizeof *lineage->run, "runs of a state");
    struct lineage_run *run = &lineage->run[lineage->count++];
    *run = (struct lineage_run){.step = step};
    snprintf(run->version, sizeof run->version, "%s", version);
    snprintf(run->revision, sizeof run->revision, "%s", revision);
    run->scene = memory_allocate(strlen(scene) + 1, 1, "scene text");
    strcpy(run->scene, scene);
}

void lineage_go_on(struct lineage *lineage, uint64_t step, const char *scene) {
    if (lineage->count > 0) {
        const struct lineage_run *last = &lineage->run[lineage->count - 1];
        if (strcmp(last->version, version_number()) == 0 && strcmp(last->revision, version_revision()) == 0 &&
            strcmp(last->scene, scene) == 0)
            return;
    }
    lineage_add(lineage, step, version_number(), version_revision(), scene);
}

void lineage_free(struct lineage *lineage) {
    for (size_t k = 0; k < lineage->count; k++)
        memory_free(lineage->run[k].scene);
    memory_free(lineage->run);
    *lineage = (struct lineage){0};
}
