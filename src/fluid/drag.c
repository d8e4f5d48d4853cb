/* SPDX-License-Identifier: BSD-3-Clause */
/* Forces at feet, brought home to the grains. Read drag.h first. */
#include "fluid/drag.h"
#include "core/memory.h"
#include "fluid/fields.h"
#include "fluid/forces.h"
#include "particles/fields.h"
#include "particles/kinds.h"
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

void drag_on_grains(const struct physics_context *context, const struct flow *flow, double viscosity) {
    struct particles *p = context->particles;
    const struct weights *weights = flow->weights;
    double *drag = fluid_drag(p);
    struct place *places;
    size_t feet = weights->foot_start[weights->rows], count = places_make(p, &places);
    struct forces_part *part = memory_allocate(feet, sizeof *part, "forces of the fluid");
    memset(drag, 0, 3 * (p->owned + p->ghosts) * sizeof *drag);
    forces_feet(flow, viscosity, part);
    for (size_t k = 0; k < feet; k++) {
        const struct place key = {weights->foot[k].body, 0};
        const struct place *at = key.id > 0 ? bsearch(&key, places, count, sizeof *places, by_id) : NULL;
        for (size_t d = 0; at && d < 3; d++)
            drag[3 * at->number + d] += part[k].viscous[d] + part[k].pressure[d];
    }
    memory_free(part);
    memory_free(places);
    if (context->ghosts) {
        struct field_list list = fields_one(fluid_drag_handle(p));
        ghosts_sum(context->ghosts, p, &list);
    }
}
