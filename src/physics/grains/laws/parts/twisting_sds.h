/* SPDX-License-Identifier: BSD-3-Clause */
/* Twisting resistance by a given spring and dashpot up to a given limit (twisting sds of LAMMPS). */
#ifndef SCREE_LAWS_TWISTING_SDS_H
#define SCREE_LAWS_TWISTING_SDS_H

#include "physics/grains/laws/law_part.h"
#define TWISTING_SDS_KEYS(KEY)                                                                               \
    KEY(sds, twisting_stiffness, "(0, inf)", .unit = "N m", .required = true, .example = "1e-4",             \
        .help = "torque over the angle of twist")                                                            \
    KEY(sds, twisting_damping, "[0, inf)", .unit = "N m s", .fallback = "0", .example = "1e-8",              \
        .help = "torque over the rate of twist")                                                             \
    KEY(sds, twisting_friction, "[0, inf)", .unit = "m", .required = true, .example = "1e-5",                \
        .help = "largest torque over the normal force")
struct twisting_sds_given {
    TWISTING_SDS_KEYS(LAW_GIVEN_MEMBER)
};

LAW_INLINE struct law_resistance twisting_sds_resist(const struct twisting_sds_given *given,
                                                     const struct law_touch *touch) {
    (void)touch;
    return (struct law_resistance){given->twisting_stiffness, given->twisting_damping,
                                   given->twisting_friction};
}

static inline struct law_solved twisting_sds_solved(const struct twisting_sds_given *given) {
    return (struct law_solved){.row = LAW_SOLVED_SPRING,
                               .stiffness = given->twisting_stiffness,
                               .limit = given->twisting_friction,
                               .lacks = given->twisting_damping > 0.0 ? "twisting_damping" : NULL};
}

#endif
