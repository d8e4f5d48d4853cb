/* SPDX-License-Identifier: BSD-3-Clause */
/* The material of each particle: the row of the law's coefficients for the particle. Registered if a scene
 * has more than one material. */
#ifndef SCREE_PARTICLES_MATERIAL_H
#define SCREE_PARTICLES_MATERIAL_H

#include "kernel/particles/particles.h"

/* Registers `material`. */
void material_register(struct particles *particles);

/* The number of the material of each particle; NULL if all particles are of one material. Borrowed until the
 * set grows. */
uint8_t *material_numbers(const struct particles *particles);

/* Material of particle i, from material_numbers. */
static inline int material_of(const uint8_t *number, size_t i) {
    return number ? number[i] : 0;
}

#endif
