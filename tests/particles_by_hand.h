/* SPDX-License-Identifier: BSD-3-Clause */
/* A set of particles with values of their own in each field. Included once by each test that needs it. */
#ifndef SCREE_TESTS_PARTICLES_BY_HAND_H
#define SCREE_TESTS_PARTICLES_BY_HAND_H

#include "base/random.h"
#include "kernel/particles/particles.h"
#include "tests/fields_by_hand.h"

/* `n` particles at random, with ids from 1000 down. */
static inline struct particles *sample(unsigned features, size_t n) {
    struct particles *p = particles_with(features, 0);
    for (size_t k = 0; k < n; k++) {
        struct random_sequence random = random_sequence(5, RANDOM_TEST, k);
        size_t i = particles_append(p);
        for (int d = 0; d < 3; d++) {
            p->state[i].x[d] = 10 * random_uniform(&random) - 2;
            p->state[i].v[d] = random_normal(&random);
        }
        p->state[i].radius = 0.1 + random_uniform(&random);
        p->state[i].inverse_mass = 1 + random_uniform(&random);
        p->id[i] = (int64_t)(1000 - k);
        p->force[i * (size_t)p->force_stride] = (double)k;
        if (spin_of(p))
            spin_of(p)[i][2] = (double)k;
        if (material_numbers(p))
            material_numbers(p)[i] = (uint8_t)(k % 3);
    }
    return p;
}

#endif
