/* SPDX-License-Identifier: BSD-3-Clause */
/* The one exact test of the contract, in double precision: every index decides with it, so that all of them
 * find the same set of pairs to the last bit. The separation is formed as (x_j - x_i) + shift, whose rounding
 * is the same whichever of the two is the row. (The build switches off fused multiply-adds, which would break
 * that.) */
#ifndef SCREE_INDEX_EXACT_H
#define SCREE_INDEX_EXACT_H

#include "index/index.h"

/* True if j, shifted by the image vector, lies within the cut-off of i. Never true for classes that are not
 * wanted, as their cut-off is -infinity. */
static inline bool exact_near(const struct index_view *view, size_t i, size_t j, const int image[3]) {
    const double *xi = view->position + i * view->stride;
    const double *xj = view->position + j * view->stride;
    double dx = (xj[0] - xi[0]) + image[0] * view->edge[0];
    double dy = (xj[1] - xi[1]) + image[1] * view->edge[1];
    double dz = (xj[2] - xi[2]) + image[2] * view->edge[2];
    double cutoff = (view->radius[i * view->stride] + view->radius[j * view->stride]) +
                    view->margin[view->size_class[i]][view->size_class[j]];
    return cutoff >= 0 && dx * dx + dy * dy + dz * dz <= cutoff * cutoff;
}

/* True if i is the home of its pair with the ghost j. */
static inline bool exact_home(const struct index_view *view, size_t i, size_t j) {
    return index_pair_home(view->radius[i * view->stride], view->id[i], view->radius[j * view->stride],
                           view->id[j]);
}

#endif
