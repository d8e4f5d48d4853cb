/* SPDX-License-Identifier: BSD-3-Clause */
/* A damper from the given restitution, at any speed (law_restitution.h). */
#ifndef SCREE_LAWS_DAMPING_RESTITUTION_H
#define SCREE_LAWS_DAMPING_RESTITUTION_H

#include "physics/grains/laws/law_part.h"
#include "physics/grains/laws/law_restitution.h"

#define DAMPING_RESTITUTION_KEYS(KEY)
struct damping_restitution_given {
    double none;
};

static inline double damping_restitution_normal(const struct damping_restitution_given *given,
                                                const struct law_damped *in) {
    (void)given;
    return in->damper * law_damping_ratio(in->restitution, in->end);
}

static inline double damping_restitution_tangential(const struct law_damped *in, double c_n) {
    return in->tangential * c_n * sqrt(in->ratio);
}

static const struct law_damping_form damping_restitution_form = {.base = LAW_BASE_ROOT, .restitution = true};

#endif
