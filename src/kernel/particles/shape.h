/* SPDX-License-Identifier: BSD-3-Clause */
/* What a grain is to become: the shape of bodies that its source names. Read once, when bodies are made of grains that have just been
 * added; the values do not travel. Registered if a scene has bodies. */
#ifndef SCREE_PARTICLES_SHAPE_H
#define SCREE_PARTICLES_SHAPE_H

#include "kernel/particles/particles.h"

/* Registers `source_shape`. */
void shape_register(struct particles *particles);

/* The number of the shape + 1 of each grain that has just been added, 0: material and radius choose; NULL if there are no
 * bodies. Borrowed until the set grows. */
int32_t *shape_numbers(const struct particles *particles);

#endif
