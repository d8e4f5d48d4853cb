/* SPDX-License-Identifier: BSD-3-Clause */
/* Rolling resistance by an elastic-plastic spring and dashpot, type C of Ai et al. (Powder Technol. 206 (2011) 269), whose dashpot
 * rests at the limit. */
#ifndef SCREE_LAWS_ROLLING_EPSD_H
#define SCREE_LAWS_ROLLING_EPSD_H

#include "physics/grains/laws/law_part.h"
#define ROLLING_EPSD_KEYS(KEY)                                                                               \
    KEY(epsd, rolling_damping_ratio, "[0, inf)", .fallback = "0.3", .example = "0.3",                        \
        .help = "of rolling to and fro, below the limit")
struct rolling_epsd_given {
    ROLLING_EPSD_KEYS(LAW_GIVEN_MEMBER)
};

static inline bool rolling_epsd_general(const struct rolling_epsd_given *given) {
    (void)given;
    return true;
}

/* The inertia against rolling of two spheres of one density, 1 / (5/(7 m_i r_i^2) + 5/(7 m_j r_j^2)), by their effective
 * mass and radii; that of the sphere at a wall. */
LAW_INLINE double rolling_epsd_inertia(const struct law_radii *radii, double mass) {
    double a = radii->one, b = radii->other, aa = a * a, bb = b * b;
    double wall = 1.4 * mass * radii->effective * radii->effective;
    double spheres = 1.4 * mass * (aa * bb) * (aa * a + bb * b) / (aa * aa * a + bb * bb * b);
    return isinf(a) || isinf(b) ? wall : spheres;
}

LAW_INLINE struct law_resistance rolling_epsd_resist(const struct rolling_epsd_given *given,
                                                     const struct law_touch *touch) {
    double friction = touch->c->rolling_friction, effective = touch->radii.effective;
    double inertia = rolling_epsd_inertia(&touch->radii, touch->mass) / (effective * effective);
    double stiffness = 2.25 * touch->grip->spring * friction * friction;
    return (struct law_resistance){.stiffness = stiffness,
                                   .damping = 2.0 * given->rolling_damping_ratio * sqrt(inertia * stiffness)};
}

static inline struct law_solved rolling_epsd_solved(const struct rolling_epsd_given *given) {
    (void)given;
    return (struct law_solved){.row = LAW_SOLVED_NONE};
}

static const struct law_rolling_form rolling_epsd_form = {.spring = true, .rests = true};

#endif
