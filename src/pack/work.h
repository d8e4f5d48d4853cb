/* SPDX-License-Identifier: BSD-3-Clause */
/* A packing on its way, and the steps that all laws share. */
#ifndef SCREE_PACK_WORK_H
#define SCREE_PACK_WORK_H

#include "pack/options.h"
#include "pack/report.h"

struct pack_work {
    const struct pack_options *options;
    const struct pack_hook *hook;
    struct pack_report *report;
    int threads;
    struct box box;
    struct particles *particles; /* ids 1 ... owned when done, in any order */
};

/* Adds a sphere with this id at a random place of the cube. */
void work_add(struct pack_work *work, int64_t id, double radius);

/* Relaxes all spheres of the work; the hook receives `what`. */
bool work_relax(struct pack_work *work, const char *what, struct error *error);

#endif
