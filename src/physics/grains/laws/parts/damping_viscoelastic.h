/* SPDX-License-Identifier: BSD-3-Clause */
/* The damper of a viscoelastic material, A times the slope of the force of the spring alone, whose restitution falls with the speed
 * (Brilliantov et al., Phys. Rev. E 53 (1996) 5382). */
#ifndef SCREE_LAWS_DAMPING_VISCOELASTIC_H
#define SCREE_LAWS_DAMPING_VISCOELASTIC_H

#include "physics/grains/laws/law_part.h"
#define DAMPING_VISCOELASTIC_KEYS(KEY)                                                                       \
    KEY(viscoelastic, dissipative_time, "[0, inf)", .unit = "s", .required = true, .example = "1e-6 s",      \
        .help = "Brilliantov's A: the damper is A times the slope of the spring's force")
struct damping_viscoelastic_given {
    DAMPING_VISCOELASTIC_KEYS(LAW_GIVEN_MEMBER)
};

static inline double damping_viscoelastic_normal(const struct damping_viscoelastic_given *given,
                                                 const struct law_damped *in) {
    (void)in;
    return given->dissipative_time;
}

static inline double damping_viscoelastic_tangential(const struct law_damped *in, double c_n) {
    return in->tangential * c_n * in->ratio;
}

static const struct law_damping_form damping_viscoelastic_form = {.base = LAW_BASE_SLOPE, .general = true};

#endif
