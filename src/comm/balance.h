/* SPDX-License-Identifier: BSD-3-Clause */
/* Divides the box again so that all ranks get like loads: recursive coordinate bisection by Zoltan. Without
 * that library (balance_none.c) there are only bricks. */
#ifndef SCREE_COMM_BALANCE_H
#define SCREE_COMM_BALANCE_H

#include "comm/domain.h"
#include "core/error.h"

/* What a rank brings: `count` positions (box-relative, wrapped) with weights > 0. Borrowed. */
struct balance_load {
    size_t count;
    const double (*x)[3];
    const double *weight;
};

/* False, with a user's error, where the program was built without Zoltan. */
bool balance_available(struct error *error);

/* Divides a bisection so that the sums of weights are alike on all ranks, as far as planes can; nothing moves
 * yet. False, and all stays as it is, where that is no division of the box, as with fewer particles than
 * ranks. Takes memory of the length of the rank count while it works. Collective, with one answer. */
bool balance_divide(struct domain *domain, const struct comm *comm, const struct box *box,
                    const struct balance_load *load);

#endif
