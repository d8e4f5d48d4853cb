/* SPDX-License-Identifier: BSD-3-Clause */
/* The guard on residuals: what goes on, and what stops with a message. */
#include "tests/test.h"

#include <math.h>
#include <string.h>

#include "physics/fluid/schemes/residual.h"

static bool goes_on(bool converged, double residual, double tolerance, struct error *error) {
    const struct solve_report report = {.iterations = 9,
                                        .converged = converged,
                                        .reason = "its",
                                        .residual = residual,
                                        .tolerance = tolerance};
    *error = (struct error){0};
    return residual_check(&report, "pressure", error);
}

static void the_true_residual_decides(void **state) {
    struct error error;
    (void)state;
    assert_true(goes_on(true, 1e-9, 1e-8, &error));
    assert_true(goes_on(true, RESIDUAL_MOST, 1e-8, &error));
    assert_true(goes_on(false, SOLVE_DOUBT * 1e-8, 1e-8, &error));
    assert_false(goes_on(false, 1.01 * SOLVE_DOUBT * 1e-8, 1e-8, &error));
    assert_false(goes_on(true, 1.01 * RESIDUAL_MOST, 1e-8, &error));
    assert_false(goes_on(false, 0.2, 1, &error));
    assert_int_equal(error.kind, ERROR_PHYSICS);
    assert_non_null(strstr(error.text, "the pressure of the fluid"));
    assert_non_null(strstr(error.text, "after 9 iterations (its) the residual is 0.2"));
    assert_false(goes_on(true, NAN, 1e-8, &error));
}

TEST_MAIN(fluid_residual, cmocka_unit_test(the_true_residual_decides))
