/* SPDX-License-Identifier: BSD-3-Clause */
/* The guard on the true residual. */
#include "fluid/residual.h"

bool residual_check(const struct solve_report *report, const char *system, struct error *error) {
    if (report->residual <= RESIDUAL_MOST) /* false for NaN */
        return true;
    return error_set(
        error, ERROR_PHYSICS,
        "the solver for the %s of the fluid ended with a residual of %.2g of its right-hand side after "
        "%d iterations (%s): a shorter step, another fluid.solver.preconditioner or a finer "
        "spacing may help",
        system, report->residual, report->iterations, report->reason);
}
