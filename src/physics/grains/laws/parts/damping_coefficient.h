/* SPDX-License-Identifier: BSD-3-Clause */
/* A damper from gamma_n and gamma_t, per unit of effective mass, as in LAMMPS. */
#ifndef SCREE_LAWS_DAMPING_COEFFICIENT_H
#define SCREE_LAWS_DAMPING_COEFFICIENT_H

#include "physics/grains/laws/law_part.h"
#define DAMPING_COEFFICIENT_KEYS(KEY)
struct damping_coefficient_given {
    double none;
};

static inline double damping_coefficient_normal(const struct damping_coefficient_given *given,
                                                const struct law_damped *in) {
    (void)given;
    return in->gamma_n;
}

static inline double damping_coefficient_tangential(const struct law_damped *in, double c_n) {
    (void)c_n;
    return in->gamma_t;
}

static const struct law_damping_form damping_coefficient_form = {.base = LAW_BASE_MASS, .given = true};

#endif
