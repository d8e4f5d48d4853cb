/* SPDX-License-Identifier: BSD-3-Clause */
/* The common declarations of the files of pack_make. */
#ifndef SCREE_PACK_PARTS_H
#define SCREE_PACK_PARTS_H

#include "pack/pack.h"

/* A packing on its way. */
struct pack_work {
    const struct pack_options *options;
    const struct pack_hook *hook;
    struct pack_report *report;
    int threads;
    struct box box;
    struct particles *particles; /* ids 1 ... owned when done, in any order */
};

/* Adds a sphere with this id at a random place of the cube. */
void pack_add(struct pack_work *work, int64_t id, double radius);

/* Relaxes all spheres of the work; the hook receives `what`. */
bool pack_relax(struct pack_work *work, const char *what, struct error *error);

/* The recipe of Stratford, Shire and Hanley. Large spheres are of material 1. */
bool pack_bidisperse(struct pack_work *work, struct error *error);

#endif
