/* SPDX-License-Identifier: BSD-3-Clause */
/* What other physics ask of grains. Read grains.h first. */
#include "physics/grains/grains.h"
#include "engine/physics_set.h"

struct grains *grains_of(const struct physics_set *set) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row == &grains_physics)
            return set->active[k].context.self;
    return NULL;
}

struct walls *grains_walls(const struct physics_context *context) {
    return grains_of(context->set)->walls;
}

struct force_context *grains_contact(const struct physics_context *context) {
    return &grains_of(context->set)->contact;
}

const struct pairlist *grains_list(const struct physics_context *context) {
    const struct physics_set *set = context->set;
    const struct grains *grains = grains_of(set);
    const void *finds = grains->contact.solver ? grains->contact.solver : grains;
    for (int k = 0; k < set->count; k++)
        if (set->active[k].context.self == finds)
            return set->active[k].context.list[0];
    return NULL;
}

struct integrator_context *grains_motion(const struct physics_context *context) {
    return &grains_of(context->set)->motion;
}

bool grains_solved(const struct physics_context *context) {
    return context->scene->law.solved;
}

bool grains_touch(const struct physics_context *context) {
    return context->scene->materials > 0;
}
