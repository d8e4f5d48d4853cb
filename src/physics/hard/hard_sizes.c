/* SPDX-License-Identifier: BSD-3-Clause */
/* The sizes and masses that the step and its notes are about. Read hard_state.h first. */
#include "engine/physics_set.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include "physics/bodies/bodies_fields.h"
#include "physics/bodies/rocks.h"
#include "physics/grains/grains.h"
#include "physics/grains/motion/carried.h"
#include "physics/grains/sorts.h"
#include "physics/hard/hard_state.h"
#include <math.h>

static void mass_count(struct hard_sizes *sizes, double mass) {
    sizes->light = fmin(sizes->light, mass);
    sizes->heavy = fmax(sizes->heavy, mass);
}

/* Counts owned particle k: its members have the radii of a body, the particle of its own has the mass. */
static void particle_count(const struct physics_context *context, size_t k, struct hard_sizes *sizes) {
    const struct particles *p = context->particles;
    const struct particle_state *state = &p->state[k];
    const uint8_t *kind = kinds_of(p), *group = groups_of(p);
    const int64_t *body = carried_by(p);
    if (kind && kind[k] == KIND_BODY) {
        if (!group || !grains_motion(context)->motion[group[k]].prescribed)
            mass_count(sizes, bodies_mass(p)[k]);
        return;
    }
    if ((kind && kind[k] != KIND_GRAIN) || !(state->inverse_mass > 0.0))
        return;
    sizes->smallest = fmin(sizes->smallest, rocks_inner(bodies_of(context->set), p, k));
    if (!body || body[k] < 0)
        mass_count(sizes, 1.0 / state->inverse_mass);
}

/* Counts what a grain of this size becomes, of all variants. */
static void grain_count(void *data, const struct physics_context *context, struct physics_grain grain) {
    struct hard_sizes *sizes = data;
    struct physics_part part;
    for (grain.variant = 0; physics_part(context->set, &grain, 0, &part); grain.variant++) {
        for (int n = 0; physics_part(context->set, &grain, n, &part); n++)
            sizes->smallest = fmin(sizes->smallest, part.inner);
        mass_count(sizes, physics_mass(context->set, &grain));
    }
}

struct hard_sizes hard_sizes_find(const struct physics_context *context) {
    struct hard_sizes sizes = {INFINITY, INFINITY, 0.0};
    for (size_t k = 0; k < context->particles->owned; k++)
        particle_count(context, k, &sizes);
    for (int k = 0; k < context->scene->insertions; k++)
        sorts_entering(context, &context->scene->insertion[k], grain_count, &sizes);
    double least[2] = {sizes.smallest, sizes.light};
    comm_min(context->comm, least, 2);
    comm_max(context->comm, &sizes.heavy, 1);
    return (struct hard_sizes){least[0], least[1], sizes.heavy};
}
