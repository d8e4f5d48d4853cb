/* SPDX-License-Identifier: BSD-3-Clause */
/* How the particles of a scene are shared out among ranks. */
#ifndef SCREE_SCENE_SCENE_SHARE_H
#define SCREE_SCENE_SCENE_SHARE_H

#include <stdbool.h>

/* Which particles this rank keeps: those with mine(context, x) true (x box-relative, wrapped), or, where
 * `mine` is NULL, an equal share: blocks of the stream dealt out in turn, wherever they lie. Spheres that are
 * placed at random keep clear of what taken(context, x, radius) says, on all ranks the same (NULL: nothing).
 * While spheres are placed at random, `progress` is called now and then with the part that is done, 0 to 1, on
 * every rank. */
struct scene_share {
    int rank, size;
    bool (*mine)(void *context, const double x[3]);
    bool (*taken)(void *context, const double x[3], double radius);
    void *context;
    void (*progress)(void *context, const char *what, double part); /* NULL: nobody is told */
};

#endif
