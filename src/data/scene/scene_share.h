/* SPDX-License-Identifier: BSD-3-Clause */
/* The distribution of the particles of a scene among ranks. */
#ifndef SCREE_SCENE_SCENE_SHARE_H
#define SCREE_SCENE_SCENE_SHARE_H

#include <stdbool.h>

struct packed_report;

/* Selects the particles that this rank keeps: those with mine(context, x) true (x box-relative, wrapped), or,
 * if `mine` is NULL, an equal share: blocks of the stream, dealt out in turn, at any place. Spheres that are
 * placed at random, or packed, do not touch the places that taken(context, x, radius) reports, on all ranks the same
 * (NULL: none; any thread asks). While spheres are placed at random, `progress` is called now and then with the part that is
 * done, 0 to 1, on every rank. `packed`, if not
 * NULL, tells how the packed sources went, also while they are made. */
struct scene_share {
    int rank, size;
    bool (*mine)(void *context, const double x[3]);
    bool (*taken)(void *context, const double x[3], double radius);
    void *context;
    void (*progress)(void *context, const char *what, double part); /* NULL: no calls */
    struct packed_report *packed;
};

#endif
