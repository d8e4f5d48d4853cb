/* SPDX-License-Identifier: BSD-3-Clause */
/* What drag and a fluid that carries grains without resolving them tell each other: the fluid its density and viscosity
 * and, by grain, its velocity; drag, by grain, the force of its law. */
#ifndef SCREE_DRAG_CARRIER_H
#define SCREE_DRAG_CARRIER_H

#include "particles/particles.h"
#include "scene/scene.h"

struct carrier {
    double density, viscosity;
    double largest; /* radius of the grains that it does not resolve, at most */
};

/* True if a physics of the scene has such a fluid. */
bool carrier_of(const struct scene *scene, struct carrier *carrier);

/* Registers the fields below. */
void carrier_fields_add(struct particles *particles);

/* By particle number, of the grains that are not resolved: the velocity of the fluid there, made before the passes of
 * PASS_CLOSE; force and force over slip, which drag fills before the pass of the fluid. NULL: no fields. */
double (*carrier_seen(const struct particles *particles))[3];
double (*carrier_force(const struct particles *particles))[4];

#endif
