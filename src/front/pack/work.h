/* SPDX-License-Identifier: BSD-3-Clause */
/* A packing on its way, and the steps that all laws share. */
#ifndef SCREE_PACK_WORK_H
#define SCREE_PACK_WORK_H

#include "front/pack/container.h"
#include "front/pack/pack_report.h"

struct pack_work {
    const struct pack_options *options;
    const struct pack_hook *hook;
    struct pack_report *report;
    int threads;
    struct pack_container container;
    struct particles *particles; /* ids 1 ... owned when done, in any order */
};

/* Adds a sphere with this id, without a place. */
void work_add(struct pack_work *work, int64_t id, double radius);

/* Gives random places in the container to all spheres. Fails (user) if a mesh has no place for one of them. Opens its own thread team. */
bool work_place(struct pack_work *work, struct error *error);

/* Relaxes all spheres of the work; the hook receives `what`. */
bool work_relax(struct pack_work *work, const char *what, struct error *error);

#endif
