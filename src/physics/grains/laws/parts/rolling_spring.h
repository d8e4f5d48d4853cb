/* SPDX-License-Identifier: BSD-3-Clause */
/* Rolling resistance by a spring and dashpot up to a limit, those of the tangential direction (Luding, Granular Matter 10 (2008) 235),
 * or given ones (rolling sds of LAMMPS). */
#ifndef SCREE_LAWS_ROLLING_SPRING_H
#define SCREE_LAWS_ROLLING_SPRING_H

#include "physics/grains/laws/law_part.h"
#define ROLLING_SPRING_KEYS(KEY)                                                                             \
    KEY(spring, rolling_stiffness, "[0, inf)", .unit = "N/m", .fallback = "0", .example = "1e4",             \
        .help = "of the rolling spring, over R* times the angle; 0: the tangential spring's, damper too")    \
    KEY(spring, rolling_damping, "[0, inf)", .unit = "kg/s", .fallback = "0", .example = "0.01",             \
        .help = "of a rolling spring whose stiffness is given")
struct rolling_spring_given {
    ROLLING_SPRING_KEYS(LAW_GIVEN_MEMBER)
};

/* True if it needs the general loop. */
static inline bool rolling_spring_general(const struct rolling_spring_given *given) {
    return given->rolling_stiffness > 0.0;
}

LAW_INLINE struct law_resistance rolling_spring_resist(const struct rolling_spring_given *given,
                                                       const struct law_touch *touch) {
    bool given_one = given->rolling_stiffness > 0.0;
    return (struct law_resistance){
        .stiffness = given_one ? given->rolling_stiffness : touch->grip->tangential,
        .damping = given_one ? given->rolling_damping : touch->c->c_t * touch->base};
}

static inline struct law_solved rolling_spring_solved(const struct rolling_spring_given *given) {
    return (struct law_solved){.row =
                                   given->rolling_stiffness > 0.0 ? LAW_SOLVED_SPRING : LAW_SOLVED_TANGENTIAL,
                               .stiffness = given->rolling_stiffness,
                               .lacks = given->rolling_damping > 0.0 ? "rolling_damping" : NULL};
}

static const struct law_rolling_form rolling_spring_form = {.spring = true, .plain = true};

#endif
