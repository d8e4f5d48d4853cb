/* SPDX-License-Identifier: BSD-3-Clause */
/* What drag and a fluid that carries grains without resolving them tell each other: the fluid its density and viscosity
 * and, by grain, its velocity; drag, by grain, the force of its law. */
#ifndef SCREE_DRAG_CARRIER_H
#define SCREE_DRAG_CARRIER_H

#include "kernel/particles/particles.h"
#include "data/scene/scene.h"

struct carrier {
    double density, viscosity;
    double largest; /* radius of the grains that it does not resolve, at most */
};

/* True if a physics of the scene has such a fluid. */
bool carrier_of(const struct scene *scene, struct carrier *carrier);

/* Registers the fields below. */
void carrier_fields_add(struct particles *particles);

/* By particle number, of the grains that are not resolved, what they see of the fluid, held from one step of the fluid to the next: its velocity;
 * the force of its pressure; the factor of the law, 1 of form B (drag_law.h), the porosity where the force of the pressure is apart. And the whole
 * force, with force over slip, which drag fills before the pass of the fluid. NULL: no fields. */
enum { CARRIER_PUSH = 3, CARRIER_SHARE = 6, CARRIER_SEEN };
double (*carrier_seen(const struct particles *particles))[CARRIER_SEEN];
double (*carrier_force(const struct particles *particles))[4];

#endif
