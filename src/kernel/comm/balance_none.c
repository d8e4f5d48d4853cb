/* SPDX-License-Identifier: BSD-3-Clause */
/* The functions of balance.h for a program built without Zoltan: there is no division by load. Read balance.h
 * first. */
#include "kernel/comm/balance.h"

bool balance_available(struct error *error) {
    return error_set(error, ERROR_USER,
                     "bisection needs Zoltan, without which this scree was built; allowed: brick");
}

bool balance_divide(struct domain *domain, const struct comm *comm, const struct box *box,
                    const struct balance_load *load) {
    (void)domain, (void)comm, (void)box, (void)load;
    error_fatal("the domain cannot be divided again: built without Zoltan");
}
