/* SPDX-License-Identifier: BSD-3-Clause */
/* The errors that examples/step-fraction.sh has found. Read check_parts.h first. */
#include "front/program/check_parts.h"
#include "physics/grains/laws/law_parts.h"
#include "physics/grains/laws/law_table.h"
#include <math.h>
#include <string.h>

static const double part[LAW_STEPS_STUDIED] = {0.05, 0.1, 0.15, 0.3, 0.5, 0.7, 0.9};

/* A cohesion, of spheres with Hertz's springs, and its errors at these parts of the stable step. */
struct step_row {
    const char *name;
    double error[LAW_STEPS_STUDIED];
};

/* The errors of the law and of its cohesion; false: one of them is not studied. */
static bool errors_find(const struct law_options *options, const double *found[2]) {
    found[0] = law_row_get(options->normal)->form->step_error;
    found[1] = options->cohesion == LAW_COHESION_NONE ? found[0]
                                                      : law_cohesion_form_of(options->cohesion)->step_error;
    return found[0][0] > 0 && found[1][0] > 0;
}

static double error_at(const double *error, double fraction) {
    const int last = LAW_STEPS_STUDIED - 1;
    int k = 0;
    if (fraction <= part[0])
        return error[0] * fraction / part[0];
    if (fraction >= part[last])
        return error[last] * fraction / part[last];
    while (fraction > part[k + 1])
        k++;
    double along = log(fraction / part[k]) / log(part[k + 1] / part[k]);
    return error[k] * pow(error[k + 1] / error[k], along);
}

double step_study_error(const struct law_options *options, double fraction) {
    const double *error[2];
    return errors_find(options, error) ? fmax(error_at(error[0], fraction), error_at(error[1], fraction))
                                       : NAN;
}

double step_study_longest(const struct law_options *options, double tolerance) {
    double longest = 0;
    for (int k = 0; k < LAW_STEPS_STUDIED && step_study_error(options, part[k]) <= tolerance; k++)
        longest = part[k];
    return longest;
}
