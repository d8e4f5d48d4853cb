/* SPDX-License-Identifier: BSD-3-Clause */
/* Asks the physics of a scene for a fluid that carries grains. Read carrier.h first. */
#include "physics/drag/carrier.h"
#include "engine/physics_set.h"
#include "kernel/particles/kinds.h"

#define OF_CARRIER .type = FIELD_DOUBLE, .needed_for = "fluid.grains.unresolved"
static const struct field seen = {.name = "fluid_seen",
                                  .components = CARRIER_SEEN,
                                  .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED,
                                  .kinds = 1u << KIND_GRAIN,
                                  OF_CARRIER,
                                  .help =
                                      "at a grain that the fluid does not resolve: volume flow of fluid and "
                                      "grains, m s-1; force of the pressure, N; factor of the law"},
                          force = {
                              .name = "fluid_taken",
                              .components = 4,
                              .kinds = 1u << KIND_GRAIN,
                              OF_CARRIER,
                              .help =
                                  "force of the fluid on such a grain, N, and that over the slip, kg s-1"};

bool carrier_of(const struct scene *scene, struct carrier *carrier) {
    for (int k = 0; k < PHYSICS_COUNT; k++) {
        const struct physics *row = physics_get((enum physics_number)k);
        if (scene->physics_given[k] && row->carrier &&
            row->carrier->of(scene->physics[k], &carrier->density, &carrier->viscosity, &carrier->largest))
            return true;
    }
    return false;
}

void carrier_fields_add(struct particles *particles) {
    fields_register(particles, &seen);
    fields_register(particles, &force);
}

double (*carrier_seen(const struct particles *particles))[CARRIER_SEEN] {
    return fields_values(particles, &seen);
}

double (*carrier_force(const struct particles *particles))[4] {
    return fields_values(particles, &force);
}
