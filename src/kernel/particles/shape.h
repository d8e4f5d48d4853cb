/* SPDX-License-Identifier: BSD-3-Clause */
/* What a grain is to become: the shape of bodies that its source names, and an orientation. Read once, when bodies are made of grains that
 * have just been added; the values do not travel. Registered if a scene has bodies. */
#ifndef SCREE_PARTICLES_SHAPE_H
#define SCREE_PARTICLES_SHAPE_H

#include "kernel/particles/particles.h"

/* Registers `source_shape` and `orientation`; the second one is that of the body, once there is one. */
void shape_register(struct particles *particles);

/* Numbers of each grain that has just been added: of the shape + 1, 0: material and radius choose, -1: it stays a sphere; of the variant +
 * 1, 0: the id chooses. */
int32_t (*shape_numbers(const struct particles *particles))[2];

/* Its orientation, a quaternion w x y z, in the frame of the entry of its shape; all 0: the entry says it. Both borrowed until the set
 * grows; NULL if there are no bodies. */
double (*shape_orientations(const struct particles *particles))[4];

/* Sets both of particle i, where there are bodies. */
void shape_set(const struct particles *particles, size_t i, int shape, int variant,
               const double orientation[4]);

#endif
