/* SPDX-License-Identifier: BSD-3-Clause */
/* The stable step for contacts that may come, from the grains at the start and those to be inserted. The present contacts
 * are limit.c's. Read grains.h first. */
#include "physics/grains/grains_own.h"
#include "physics/grains/sorts.h"
#include "physics/grains/walls/walls_free.h"
#include "base/memory.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The largest speed expected of an impact, however long the run: from the scene, else the speed of the fastest particle
 * now, or of an insertion, or of a fall through the box. */
static double speed_expected(const struct physics_context *c, const struct sorts *sorts) {
    const struct scene *scene = c->scene;
    double fall = 0;
    if (scene->step.speed_max > 0)
        return scene->step.speed_max;
    for (int d = 0; d < 3; d++)
        if (!scene->box.periodic[d])
            fall += 2 * fabs(scene->gravity[d]) * scene->box.edge[d];
    return sqrt(fmax(fall, sorts->fastest));
}

static void limits_find(const struct physics_context *c, const struct sorts *sorts) {
    struct grains *grains = c->self;
    grains->stable.speed_most = speed_expected(c, sorts);
    grains->stable.limits = (struct timestep_limits){.stable = INFINITY};
    if (grains_solved(c))
        return;
    struct timestep_kind *kind =
        memory_allocate(SORTS_MAX + LAW_MATERIALS_MAX + WALLS_MAX, sizeof *kind, "sorts of grains");
    int n = 0;
    for (int k = 0; k < SORTS_MAX; k++)
        if (sorts->radius_max[k] > 0) {
            double least = sorts->radius_min[k];
            kind[n++] = (struct timestep_kind){.material = sorts_material(k),
                                               .radius_min = least,
                                               .radius_max = sorts->radius_max[k],
                                               .mass_min = sorts->lightest[k] * (least * least * least),
                                               .body = sorts->body[k]};
        }
    for (int m = 0; m < c->scene->materials; m++)
        if (sorts->fixed[m] > 0)
            kind[n++] = (struct timestep_kind){.material = m, .wall = true};
    for (int w = 0; grains->walls && w < walls_count(grains->walls); w++)
        if (walls_is_free(grains->walls, w))
            kind[n++] = (struct timestep_kind){.material = c->scene->wall[w].material,
                                               .wall = true,
                                               .yield = {walls_yield_most(grains->walls, w),
                                                         walls_yield_spread(grains->walls, w),
                                                         walls_whole_area(grains->walls, w)}};
    timestep_limits(&grains->stable.limits, &(struct timestep_input){.law = &grains->law,
                                                                     .kinds = n,
                                                                     .kind = kind,
                                                                     .material = c->scene->material,
                                                                     .speed_max = grains->stable.speed_most,
                                                                     .contacts = c->scene->step.contacts,
                                                                     .dimension = c->box->dimension});
    memory_free(kind);
}

double stable_find(const struct physics_context *c) {
    struct grains *grains = c->self;
    struct sorts *sorts = memory_allocate(1, sizeof *sorts, "sorts of grains");
    sorts_collect(c, sorts);
    limits_find(c, sorts);
    memory_free(sorts);
    return grains->stable.limits.stable;
}

void stable_why(const struct physics_context *c, char *text, size_t room) {
    const struct grains *grains = c->self;
    const struct timestep_limits *limits = &grains->stable.limits;
    snprintf(text, room, "contact between materials '%s' and '%s', damping ratio %.3g",
             c->scene->material[limits->material_a].name, c->scene->material[limits->material_b].name,
             limits->damping_ratio + 0.0);
}
