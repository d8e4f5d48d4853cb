/* SPDX-License-Identifier: BSD-3-Clause */
/* The guard on the true residual. */
#include "physics/fluid/schemes/residual.h"

bool residual_check(const struct solve_report *report, const char *system, struct error *error) {
    bool converged = report->converged || report->residual <= SOLVE_DOUBT * report->tolerance;
    if (converged && report->residual <= RESIDUAL_MOST) /* false for NaN */
        return true;
    return error_set(error, ERROR_PHYSICS,
                     "the solver for the %s of the fluid did not converge: after %d iterations (%s) the "
                     "residual is %.2g of the "
                     "right-hand side, and the tolerance %.2g; a shorter step, another "
                     "fluid.solver.preconditioner or a finer "
                     "spacing may help",
                     system, report->iterations, report->reason, report->residual, report->tolerance);
}
