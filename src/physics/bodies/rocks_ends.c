/* SPDX-License-Identifier: BSD-3-Clause */
/* Brings rocks to their places, and finds the features of their contacts. Read rocks_ends.h first. */
#include "physics/bodies/rocks_ends.h"
#include "base/vector.h"
#include "engine/physics_set.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include "base/rotor.h"
#include "physics/grains/grains.h"
#include "physics/grains/walls/walls_free.h"
#include <math.h>
#include <string.h>

static const double dot_corner[1][3] = {{0}}, dot_turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/* The corners of all rocks, as they stand. */
static void stands_turn(struct rocks *rocks, const struct particles *p) {
    const double(*orientation)[4] = (const double(*)[4])rocks_orientations(p);
#pragma omp parallel for schedule(static)
    for (size_t s = 0; s < rocks->stands; s++) {
        struct rocks_stand *stand = &rocks->stand[s];
        rotor_matrix(orientation[stand->particle], stand->turn);
        posed_corners(stand->posed.core, stand->turn, stand->posed.scale, stand->corner);
    }
}

void rocks_scene_make(struct rocks *rocks, const struct physics_context *context, struct rocks_scene *scene) {
    const struct force_context *contact = grains_contact(context);
    *scene = (struct rocks_scene){.context = context,
                                  .rocks = rocks,
                                  .particles = context->particles,
                                  .list = grains_list(context),
                                  .walls = grains_walls(context),
                                  .law = contact->law,
                                  .law_case = law_case_of(&contact->law->options, true),
                                  .omega = spin_values(context->particles),
                                  .material = material_numbers(context->particles)};
    if (context->evaluation)
        scene->step = law_step_of(&contact->law->options, context->evaluation->dt);
    stands_turn(rocks, context->particles);
}

/* A particle as a solid. */
static struct posed posed_of(const struct rocks_scene *scene, uint32_t i) {
    int32_t stand = scene->rocks->stand_of[i];
    if (stand >= 0)
        return scene->rocks->stand[stand].posed;
    return (struct posed){.core = &scene->rocks->dot,
                          .corner = dot_corner,
                          .turn = dot_turn,
                          .scale = 1,
                          .rounding = scene->particles->state[i].radius};
}

/* True if another physics, as that of bonds, stands for the contact of a pair. */
static bool joined(const struct rocks_scene *scene, const struct rocks_pair *pair) {
    PHYSICS_EACH (active, scene->context->set, joints)
        if (active->row != &bodies_physics && active->row->joints->joins(&active->context) &&
            active->row->joints->joined(&active->context, pair->end[0], pair->end[1]))
            return true;
    return false;
}

/* The radius of the largest sphere about the centre of a particle that it holds. */
static double inner_of(const struct rocks_scene *scene, uint32_t i) {
    int32_t stand = scene->rocks->stand_of[i];
    return stand >= 0 ? scene->rocks->stand[stand].inner : scene->particles->state[i].radius;
}

bool rocks_ends_make(const struct rocks_scene *scene, const struct rocks_pair *pair,
                     struct rocks_ends *ends) {
    const struct particle_state *a = &scene->particles->state[pair->end[0]], *b = NULL;
    int material[2] = {material_of(scene->material, pair->end[0]), 0};
    double inverse = a->inverse_mass;
    ends->posed[0] = posed_of(scene, pair->end[0]);
    ends->radius = ends->posed[0].rounding;
    ends->ball = a->radius;
    ends->inner = inner_of(scene, pair->end[0]);
    memcpy(ends->centre, a->x, sizeof ends->centre);
    memcpy(ends->turn, ends->posed[0].turn, sizeof ends->turn);
    if (pair->wall >= 0) {
        double shift[3];
        walls_group_shift(scene->walls, &pair->group, shift);
        for (int d = 0; d < 3; d++)
            ends->centre[d] -= shift[d];
    }
    if (pair->wall < 0) {
        b = &scene->particles->state[pair->end[1]];
        inverse += b->inverse_mass;
        rocks_apart(pair, scene->particles, scene->list, ends->apart);
        double most = a->radius + b->radius + scene->reach;
        if (!(vector_dot(ends->apart, ends->apart) < most * most) || joined(scene, pair))
            return false;
        ends->posed[1] = posed_of(scene, pair->end[1]);
        ends->ball = fmin(a->radius, b->radius);
        ends->inner = fmin(ends->inner, inner_of(scene, pair->end[1]));
        ends->radius *= ends->posed[1].rounding / (ends->posed[0].rounding + ends->posed[1].rounding);
    }
    material[1] =
        b ? material_of(scene->material, pair->end[1]) : walls_options(scene->walls, pair->wall)->material;
    ends->mass = inverse > 0 ? 1 / inverse : 0;
    ends->coefficients = law_pair_of(scene->law, material[0], material[1]);
    ends->extra = scene->law->options.user ? law_extra_of(scene->law, material[0], material[1]) : NULL;
    return inverse > 0 || (pair->wall >= 0 && walls_is_free(scene->walls, pair->wall));
}

/* Brings groups together, in their order. */
static void groups_sort(struct features *features) {
    for (int k = 1; k < features->count; k++) {
        struct feature one = features->feature[k];
        int at = k;
        for (; at > 0 && features->feature[at - 1].group > one.group; at--)
            features->feature[at] = features->feature[at - 1];
        features->feature[at] = one;
    }
}

int rocks_group(const struct features *features, int from) {
    int end = from + 1;
    while (end < features->count && features->feature[end].group == features->feature[from].group)
        end++;
    return end - from;
}

int rocks_features(const struct rocks_scene *scene, struct rocks_pair *pair, const struct rocks_ends *ends,
                   struct walls_probe *probe, struct features *features) {
    double normal[3];
    features->count = 0;
    features->reach = scene->reach;
    if (pair->wall >= 0) {
        rocks_wall_features(scene, pair, ends, probe, features);
        groups_sort(features);
    } else {
        touch_near(&ends->posed[0], &ends->posed[1], ends->apart, &pair->simplex, features, normal);
    }
    return features->count;
}

struct law_springs rocks_springs(const struct rocks_scene *scene, const struct rocks_ends *ends,
                                 double overlap) {
    return law_springs_of(&scene->law->options, ends->coefficients, ends->extra, ends->radius, overlap);
}
