/* SPDX-License-Identifier: BSD-3-Clause */
/* Dampers from restitutions (law_restitution.h; docs/physics.md). */
#include "physics/grains/laws/law_restitution.h"
#include <float.h>
#include <math.h>

/* Restitution of a linear spring-dashpot that ends at zero force (Schwager and Poeschel 2007, their three
 * cases written as one with acos and acosh). */
static double law_restitution_end_force(double zeta) {
    if (zeta < 1.0)
        return exp(-2.0 * zeta * acos(zeta) / sqrt(1.0 - zeta * zeta));
    if (zeta > 1.0)
        return exp(-2.0 * zeta * acosh(zeta) / sqrt(zeta * zeta - 1.0));
    return exp(-2.0);
}

double law_damping_ratio(double restitution, enum law_end end) {
    if (end == LAW_END_OVERLAP) {
        double logarithm = log(restitution);
        return restitution > 0.0 ? -logarithm / hypot(M_PI, logarithm) : 1.0;
    }
    double target = fmax(restitution, LAW_RESTITUTION_LEAST);
    double low = 0.0, high = 100.0;
    while (high - low > 4.0 * DBL_EPSILON * high) {
        double middle = 0.5 * (low + high);
        if (law_restitution_end_force(middle) > target)
            low = middle;
        else
            high = middle;
    }
    return restitution >= 1.0 ? 0.0 : 0.5 * (low + high);
}

double law_end_friction(double restitution, enum law_end end) {
    if (end == LAW_END_FORCE)
        return 0.0;
    double left = law_restitution_end_force(law_damping_ratio(restitution, LAW_END_OVERLAP));
    return 2.0 * (left - restitution) / (1.0 + restitution);
}
