/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws with parts, and their contacts, for tests. Read law_general.h first. */
#ifndef SCREE_TESTS_LAW_PARTS_BY_HAND_H
#define SCREE_TESTS_LAW_PARTS_BY_HAND_H

#include "physics/grains/laws/law_general.h"
#include "tests/physics/grains/laws/laws_by_hand.h"

static const struct law_extra sticky = {
    .cohesion_jkr = {.surface_energy = 0.5},
    .cohesion_dmt = {.surface_energy = 0.5},
    .cohesion_sjkr = {.cohesion_density = 1e4},
    .cohesion_capillary = {.surface_tension = 0.1, .contact_angle = 0.4, .bridge_volume = 1e-3},
    .cohesion_van_der_waals = {.hamaker = 1e-3, .gap_least = 1e-3, .cut_off = 0.05},
    .rolling_epsd = {.rolling_damping_ratio = 0.3},
    .twisting_sds = {.twisting_stiffness = 100.0, .twisting_damping = 0.1, .twisting_friction = 0.01},
    .damping_viscoelastic = {.dissipative_time = 1e-4},
    .k_2 = 3e5,
    .k_c = 5e4,
    .yield_pressure = 1e5,
    .plasticity_ratio = 0.6,
    .adhesion_energy = 30.0,
    .adhesion_exponent = 1.5,
    .pull_off = 0.5};
static const struct law_material soft[2] = {{"soft", 2500.0, 1e6, 0.2}, {"soft too", 2500.0, 1e6, 0.2}};

/* The law with these coefficients; a part that they leave out has 0.05 where its key is required. */
static inline struct law law_of(struct law_options options, struct law_extra extra) {
    int count;
    const struct law_given_key *key = law_given_keys(&count);
    for (int k = 0; k < count; k++) {
        double *value = (double *)((char *)&extra + key[k].offset);
        if (key[k].required && *value == 0.0)
            *value = 0.05;
    }
    struct law_pair pair = {.restitution = 0.6,
                            .friction = 0.4,
                            .rolling_friction = 0.2,
                            .k_n = 1e5,
                            .k_t = 3e4,
                            .gamma_n = 50.0,
                            .gamma_t = 20.0,
                            .extra = extra};
    return law_for(options, soft, pair);
}

static inline struct law_surfaces surfaces_of(const struct law *law, double ri, double rj) {
    return (struct law_surfaces){&law->pair[law_place_of(law->materials, 0, 1)],
                                 &law->extra[law_place_of(law->materials, 0, 1)],
                                 {ri, rj},
                                 1.0 / (1.0 / ri + 1.0 / rj)};
}

static inline struct law_grip grip_of(const struct law_options *o, const struct law_surfaces *s,
                                      double overlap, bool held) {
    return law_grip_at(o, s, overlap, &(struct law_past){.held = held});
}

/* The next combination of normal law and cohesion; false after the last. */
static inline bool next_cohesion(struct law_options *o) {
    int count;
    const struct law_part_row *rows = law_part_rows(LAW_PART_COHESION, &count);
    do {
        o->cohesion = (enum law_cohesion)(o->cohesion + 1);
        if ((int)o->cohesion == count) {
            o->cohesion = LAW_COHESION_NONE;
            o->normal = (enum law_normal)(o->normal + 1);
            if ((int)o->normal == LAW_SPRING_COUNT)
                return false;
        }
    } while (!law_part_combines(&rows[o->cohesion], law_row_get(o->normal)->traits));
    return true;
}

static inline struct law_vector random_vector(struct random_sequence *r) {
    double x = 2.0 * random_uniform(r) - 1.0, y = 2.0 * random_uniform(r) - 1.0;
    return (struct law_vector){x, y, 2.0 * random_uniform(r) - 1.0};
}

static inline struct law_general random_contact(const struct law *law, struct random_sequence *r) {
    struct law_general in = {.extra = &law->extra[law_place_of(law->materials, 0, 1)],
                             .radius = {0.5 + random_uniform(r), 0.5 + random_uniform(r)}};
    struct law_vector n = random_vector(r), half;
    n = law_scale(1.0 / sqrt(law_dot(n, n)), n);
    half = law_add(n, 0.05, random_vector(r));
    in.contact = (struct law_contact){.overlap = 0.03 * random_uniform(r) - 0.01,
                                      .mass = 0.5 + random_uniform(r),
                                      .radius = in.radius[0] * in.radius[1] / (in.radius[0] + in.radius[1]),
                                      .normal = n,
                                      .half_normal = law_scale(1.0 / sqrt(law_dot(half, half)), half),
                                      .velocity = random_vector(r),
                                      .surface = random_vector(r),
                                      .spin = random_vector(r),
                                      .coefficients = law->pair[law_place_of(law->materials, 0, 1)]};
    for (int c = 0; c < law->history_components; c++)
        in.value[c] = 0.02 * random_uniform(r);
    return in;
}

/* Options number k of the parts. */
static inline struct law_options options_of(int k) {
    struct law_options o = law_options_default();
    o.tangential = (enum law_tangential)(k % LAW_TANGENTIAL_COUNT);
    k /= LAW_TANGENTIAL_COUNT;
    o.rolling = (enum law_rolling)(k % LAW_ROLLING_COUNT);
    k /= LAW_ROLLING_COUNT;
    o.twisting = (enum law_twisting)(k % LAW_TWISTING_COUNT);
    k /= LAW_TWISTING_COUNT;
    o.cohesion = (enum law_cohesion)(k % LAW_COHESION_COUNT);
    k /= LAW_COHESION_COUNT;
    o.damping = (enum law_damping)(k % LAW_DAMPING_COUNT);
    o.synchronised = k % 3;
    o.end = k % 2 ? LAW_END_FORCE : LAW_END_OVERLAP;
    if (o.tangential == LAW_FRICTIONLESS) {
        o.rolling = LAW_ROLLING_NONE;
        o.twisting = LAW_TWISTING_NONE;
    }
    return o;
}

enum {
    OPTIONS =
        LAW_TANGENTIAL_COUNT * LAW_ROLLING_COUNT * LAW_TWISTING_COUNT * LAW_COHESION_COUNT * LAW_DAMPING_COUNT
};

#endif
