/* SPDX-License-Identifier: BSD-3-Clause */
/* From feet to the surfaces for which a scene gives values. Read boundary_values.h first. */
#include "physics/fluid/schemes/boundary_values.h"
#include "base/memory.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include "physics/fluid/coupling/surface_loads.h"
#include "physics/fluid/schemes/open_sides.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/fields.h"
#include <stdio.h>

static bool same(const struct fluid_surface *a, const struct fluid_surface *b) {
    return a->wall == b->wall && a->group == b->group && a->side == b->side;
}

bool boundary_values_suits(const struct physics_context *context, const char *key,
                           const struct fluid_surface *surface, int surfaces, struct error *error) {
    for (int k = 0; k < surfaces; k++) {
        const struct fluid_surface *at = &surface[k];
        char place[96];
        snprintf(place, sizeof place, "%s[%d]", key, k);
        if ((at->wall >= 0) + (at->group >= 0) + (at->side >= 0) != 1)
            return scene_fail(context->scene, error, place, "needed is one of wall, group and side");
        snprintf(place, sizeof place, "%s[%d].group", key, k);
        if (at->group >= 0 && context->scene->group[at->group].motion == SCENE_FREE)
            return scene_fail(
                context->scene, error, place,
                "beside particles that stay the fluid flows around no free grain; allowed: groups "
                "that are frozen or only spin");
        snprintf(place, sizeof place, "%s[%d].side", key, k);
        if (at->side >= 0 && open_at(context->options, at->side) == NULL)
            return scene_fail(context->scene, error, place,
                              "%s is no open side; allowed: sides of fluid.open", open_name(at->side));
        snprintf(place, sizeof place, "%s[%d]", key, k);
        for (int other = 0; other < k; other++)
            if (same(at, &surface[other]))
                return scene_fail(context->scene, error, place, "the surface of entry %d is there twice",
                                  other);
    }
    return true;
}

/* The number of a wall or an open side in the list. */
static int number_of_body(int64_t body, const struct fluid_surface *surface, int surfaces) {
    int side = body_side(body), wall = body < 0 && side < 0 ? body_wall(body) : -1;
    for (int k = 0; k < surfaces; k++)
        if (side >= 0 ? surface[k].side == side : wall >= 0 && surface[k].wall == wall)
            return k;
    return -1;
}

static int number_of_group(int group, const struct fluid_surface *surface, int surfaces) {
    for (int k = 0; k < surfaces; k++)
        if (surface[k].group == group)
            return k;
    return -1;
}

/* The groups of grains, of copies too; NULL where the scene has no groups. */
static const uint8_t *groups_share(const struct physics_context *context) {
    const uint8_t *group = groups_of(context->particles);
    struct field_list list = fields_one(fields_find(context->particles, "group"));
    if (group != NULL && context->ghosts != NULL) {
        ghosts_forward_begin(context->ghosts, context->particles, &list);
        ghosts_forward_end(context->ghosts, context->particles);
    }
    return group;
}

int boundary_values_number(const struct fluid_surface *surface, int surfaces, int64_t body, int group) {
    if (body <= BODY_NONE)
        return number_of_body(body, surface, surfaces);
    return group >= 0 ? number_of_group(group, surface, surfaces) : -1;
}

void boundary_values_find(const struct physics_context *context, const struct weights *weights,
                          const struct fluid_surface *surface, int surfaces, int *number) {
    const uint8_t *group = groups_share(context);
    size_t *grain = NULL;
    surface_loads_grains(&grain, context->particles, weights);
    for (size_t k = 0; k < weights->foot_start[weights->rows]; k++)
        number[k] = boundary_values_number(surface, surfaces, weights->foot[k].body,
                                           grain[k] != SIZE_MAX && group != NULL ? group[grain[k]] : -1);
    memory_free(grain);
}
