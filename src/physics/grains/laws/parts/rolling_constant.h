/* SPDX-License-Identifier: BSD-3-Clause */
/* Rolling resistance by a constant torque against the rolling, type A of Ai et al. (Powder Technol. 206 (2011) 269). */
#ifndef SCREE_LAWS_ROLLING_CONSTANT_H
#define SCREE_LAWS_ROLLING_CONSTANT_H

#include "physics/grains/laws/law_part.h"
#define ROLLING_CONSTANT_KEYS(KEY)
struct rolling_constant_given {
    double none;
};

static inline bool rolling_constant_general(const struct rolling_constant_given *given) {
    (void)given;
    return true;
}

LAW_INLINE struct law_resistance rolling_constant_resist(const struct rolling_constant_given *given,
                                                         const struct law_touch *touch) {
    (void)given;
    (void)touch;
    return (struct law_resistance){0};
}

static inline struct law_solved rolling_constant_solved(const struct rolling_constant_given *given) {
    (void)given;
    return (struct law_solved){.row = LAW_SOLVED_RIGID};
}

static const struct law_rolling_form rolling_constant_form = {0};

#endif
