/* SPDX-License-Identifier: BSD-3-Clause */
/* Divides the box again so that all ranks get like loads: recursive coordinate bisection by Zoltan. Without
 * Zoltan (balance_none.c) the box is divided into bricks only. */
#ifndef SCREE_COMM_BALANCE_H
#define SCREE_COMM_BALANCE_H

#include "kernel/comm/domain.h"
#include "base/error.h"

/* The load of a rank: `count` positions (box-relative, wrapped) with weights > 0. Borrowed. */
struct balance_load {
    size_t count;
    const double (*x)[3];
    const double *weight;
};

/* False, with a user's error, if the program was built without Zoltan. */
bool balance_available(struct error *error);

/* Divides a bisection so that the sums of weights are alike on all ranks, as far as planes can; no particle
 * moves yet. Returns false and changes nothing if Zoltan's parts do not divide the box, for example with
 * fewer particles than ranks. During the call the function needs memory in proportion to the number of ranks.
 * Collective; returns the same on all ranks. */
bool balance_divide(struct domain *domain, const struct comm *comm, const struct box *box,
                    const struct balance_load *load);

#endif
