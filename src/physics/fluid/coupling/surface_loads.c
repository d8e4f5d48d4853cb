/* SPDX-License-Identifier: BSD-3-Clause */
/* Forces at feet, brought home to grains, groups and walls. Read surface_loads.h first. */
#include "physics/fluid/coupling/surface_loads.h"
#include "base/memory.h"
#include "physics/fluid/fluid_fields.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include <stdlib.h>
#include <string.h>

/* A grain here: owned, or a copy. */
struct place {
    int64_t id;
    size_t number;
};

static int by_id(const void *a, const void *b) {
    const struct place *x = a, *y = b;
    return (x->id > y->id) - (x->id < y->id);
}

static size_t places_make(const struct particles *p, struct place **places) {
    const uint8_t *kind = kinds_of(p);
    size_t total = p->owned + p->ghosts, count = 0;
    for (size_t k = 0; k < total; k++)
        count += kind[k] == KIND_GRAIN;
    *places = memory_allocate(count, sizeof **places, "grains in a fluid");
    count = 0;
    for (size_t k = 0; k < total; k++)
        if (kind[k] == KIND_GRAIN)
            (*places)[count++] = (struct place){p->id[k], k};
    qsort(*places, count, sizeof **places, by_id);
    return count;
}

void surface_loads_grains(size_t **grain, const struct particles *p, const struct weights *weights) {
    struct place *places;
    size_t feet = weights->foot_start[weights->rows], count = places_make(p, &places);
    *grain = memory_resize(*grain, feet, sizeof **grain, "forces of the fluid");
    for (size_t k = 0; k < feet; k++) {
        const struct place key = {weights->foot[k].body, 0};
        const struct place *at =
            key.id > 0 && count > 0 ? bsearch(&key, places, count, sizeof *places, by_id) : NULL;
        (*grain)[k] = at ? at->number : SIZE_MAX;
    }
    memory_free(places);
}

void surface_loads_look(struct forces *forces, const struct physics_context *context, const struct flow *flow,
                        double viscosity) {
    struct particles *p = context->particles;
    double *force = fluid_drag(p);
    size_t feet = flow->weights->foot_start[flow->weights->rows];
    surface_loads_grains(&forces->grain, p, flow->weights);
    forces->part = memory_resize(forces->part, feet, sizeof *forces->part, "forces of the fluid");
    surface_forces_feet(flow, viscosity, forces->part);
    memset(force, 0, 3 * (p->owned + p->ghosts) * sizeof *force);
    for (size_t k = 0; k < feet; k++)
        for (size_t d = 0; forces->grain[k] != SIZE_MAX && d < 3; d++)
            force[3 * forces->grain[k] + d] += forces->part[k].viscous[d] + forces->part[k].pressure[d];
    if (context->ghosts) {
        struct field_list list = fields_one(fluid_drag_handle(p));
        ghosts_sum(context->ghosts, p, &list);
    }
}
