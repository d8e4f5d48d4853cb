/* SPDX-License-Identifier: BSD-3-Clause */
/* The part of rocks in the stability of the present contacts. Read rocks.h first. */
#include "physics/bodies/rocks_ends.h"
#include "kernel/particles/material.h"
#include "physics/bodies/shapes/stiff.h"
#include "physics/grains/grains.h"
#include "physics/grains/motion/stability.h"
#include "physics/grains/motion/timestep.h"
#include <math.h>
#include <string.h>

/* The moments of inertia over mass of a particle: of a rock, or of a sphere. */
static void side_make(const struct bodies *bodies, const struct rocks_scene *scene,
                      const struct rocks_pair *pair, const struct rocks_ends *ends, int end,
                      struct stiff_side *side) {
    const uint32_t i = pair->end[end];
    const int shape = rocks_shape(scene->particles, i);
    const double radius = scene->particles->state[i].radius;
    *side = (struct stiff_side){.second = end == 1, .turn = ends->posed[end].turn};
    memcpy(side->apart, ends->apart, sizeof side->apart);
    for (int d = 0; d < 3; d++) {
        double scale = shape >= 0 ? radius / bodies->clump[shape].extent : 0;
        side->gyration[d] = shape >= 0 ? bodies->clump[shape].gyration[d] * scale * scale
                                       : TIMESTEP_INERTIA * radius * radius;
    }
}

/* Adds a contact, as both ends feel it. */
static void group_stiffen(const struct bodies *bodies, const struct rocks_scene *scene,
                          const struct rocks_pair *pair, const struct rocks_ends *both,
                          const struct feature *feature, int count, struct stability *stability) {
    const double h = stability->step, overlap = feature_overlap(feature, count);
    const struct rocks_ends ends = *both;
    const int material[2] = {material_of(scene->material, pair->end[0]),
                             pair->wall >= 0 ? walls_options(scene->walls, pair->wall)->material
                                             : material_of(scene->material, pair->end[1])};
    struct law_springs springs = rocks_springs(scene, &ends, overlap);
    struct timestep_springs s =
        timestep_springs(scene->law, material[0], material[1], ends.mass, ends.radius, overlap);
    const double q = s.k_n > 0 ? fmin(springs.force / (overlap * s.k_n), 1) : 1;
    for (int end = 0; end < (pair->wall >= 0 ? 1 : 2); end++) {
        const double mass = scene->particles->state[pair->end[end]].inverse_mass;
        struct stiff_side side;
        struct stiff stiff;
        if (!pair->gives[end] || mass == 0)
            continue;
        side_make(bodies, scene, pair, &ends, end, &side);
        stiff_find(feature, count, &side, q, &stiff);
        double roll = h * (h * s.k_r + 2 * s.c_r) * ends.radius * ends.radius / side.gyration[0];
        const double weight[STIFF_KINDS] = {h * h * s.k_n, 2 * h * s.c_n, h * (h * s.k_t + 2 * s.c_t)};
        stability_bound(stability, pair->end[end], mass * (stiff_largest(&stiff, weight) + roll));
    }
}

/* Adds the contacts of a pair. */
static void pair_stiffen(const struct bodies *bodies, const struct rocks_scene *scene,
                         struct rocks_pair *pair, struct walls_probe *probe, struct stability *stability) {
    struct rocks_ends ends = {0};
    struct features features;
    if (!rocks_ends_make(scene, pair, &ends))
        return;
    rocks_features(scene, pair, &ends, probe, &features);
    for (int from = 0, count; from < features.count; from += count) {
        count = rocks_group(&features, from);
        group_stiffen(bodies, scene, pair, &ends, features.feature + from, count, stability);
    }
}

void rocks_stiffen(struct bodies *bodies, const struct physics_context *context,
                   struct stability *stability) {
    struct rocks *rocks = bodies->rocks;
    struct rocks_scene scene;
    rocks_scene_make(rocks, context, &scene);
#pragma omp parallel
    {
        struct walls_probe probe = {0};
#pragma omp for schedule(dynamic, 16)
        for (size_t k = 0; k < rocks->pairs; k++)
            pair_stiffen(bodies, &scene, &rocks->pair[k], &probe, stability);
        walls_probe_free(&probe);
    }
}

double rocks_stiffest(const struct bodies *bodies, const struct physics_context *context,
                      const struct stability *stability) {
    const struct rocks *rocks = bodies->rocks;
    double most = 0;
    (void)context;
    for (size_t k = 0; k < rocks->pairs; k++) {
        const struct rocks_pair *pair = &rocks->pair[k];
        struct rocks_scene scene = {.particles = context->particles, .list = grains_list(context)};
        double sum = stability->local[pair->end[0]], apart[3];
        if (pair->wall >= 0 && stability->wall)
            sum += stability->wall[pair->wall];
        if (pair->wall < 0) {
            const struct particle_state *a = &scene.particles->state[pair->end[0]],
                                        *b = &scene.particles->state[pair->end[1]];
            rocks_apart(pair, scene.particles, scene.list, apart);
            if (!(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2] <
                  (a->radius + b->radius) * (a->radius + b->radius)))
                continue;
            sum += stability->local[pair->end[1]];
        }
        most = fmax(most, sum);
    }
    return most;
}
