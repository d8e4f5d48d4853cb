/* SPDX-License-Identifier: BSD-3-Clause */
/* The contacts of rocks in a step: points, the law at each point, forces and torques. Read rocks.h first. */
#include "physics/bodies/rocks_state.h"
#include "base/vector.h"
#include "physics/bodies/rotor.h"
#include "physics/grains/grains.h"
#include "physics/grains/laws/law_kernel.h"
#include "base/memory.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include <math.h>
#include <string.h>

/* What all contacts of an evaluation share. */
struct scene_of {
    const struct physics_context *context;
    const struct rocks *rocks;
    const struct particles *particles;
    const struct pairlist *list;
    const struct walls *walls;
    const struct law *law;
    struct law_case law_case;
    struct law_step step;
    const double (*omega)[4];
    const uint8_t *material;
};

/* Both ends of a contact. */
struct ends {
    struct posed posed[2];
    double apart[3], centre[3]; /* centre: of the first end */
    double mass, radius;        /* effective */
    double ball;                /* the smaller radius of both balls */
    const struct law_coefficients *coefficients;
    const struct law_extra *extra;
    double turn[9]; /* of the first end */
};

static const double dot_corner[1][3] = {{0}}, dot_turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

static void cross(const double a[3], const double b[3], double c[3]) {
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3, f = (d + 2) % 3;
        c[d] = a[e] * b[f] - a[f] * b[e];
    }
}

static struct law_vector vector(const double a[3]) {
    return (struct law_vector){a[0], a[1], a[2]};
}

static void store(struct law_vector from, double to[3]) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

/* A particle as a solid. */
static struct posed posed_of(const struct scene_of *scene, uint32_t i) {
    int32_t stand = scene->rocks->stand_of[i];
    if (stand >= 0)
        return scene->rocks->stand[stand].posed;
    return (struct posed){.core = &scene->rocks->dot,
                          .corner = dot_corner,
                          .turn = dot_turn,
                          .scale = 1,
                          .rounding = scene->particles->state[i].radius};
}

/* Fills both ends; false: they cannot touch, or nothing moves them. */
static bool ends_make(const struct scene_of *scene, const struct rocks_pair *pair, struct ends *ends) {
    const struct particle_state *a = &scene->particles->state[pair->end[0]], *b = NULL;
    int material[2] = {material_of(scene->material, pair->end[0]), 0};
    double inverse = a->inverse_mass;
    ends->posed[0] = posed_of(scene, pair->end[0]);
    ends->radius = ends->posed[0].rounding;
    ends->ball = a->radius;
    memcpy(ends->centre, a->x, sizeof ends->centre);
    memcpy(ends->turn, ends->posed[0].turn, sizeof ends->turn);
    if (pair->wall < 0) {
        b = &scene->particles->state[pair->end[1]];
        inverse += b->inverse_mass;
        rocks_apart(pair, scene->particles, scene->list, ends->apart);
        if (!(vector_dot(ends->apart, ends->apart) < (a->radius + b->radius) * (a->radius + b->radius)))
            return false;
        ends->posed[1] = posed_of(scene, pair->end[1]);
        ends->ball = fmin(a->radius, b->radius);
        ends->radius *= ends->posed[1].rounding / (ends->posed[0].rounding + ends->posed[1].rounding);
    }
    material[1] =
        b ? material_of(scene->material, pair->end[1]) : walls_options(scene->walls, pair->wall)->material;
    ends->mass = inverse > 0 ? 1 / inverse : 0;
    ends->coefficients = law_pair_of(scene->law, material[0], material[1]);
    ends->extra = scene->law->options.user ? law_extra_of(scene->law, material[0], material[1]) : NULL;
    return inverse > 0;
}

/* The contact with a plane. */
static bool plane_touch(const struct scene_of *scene, const struct rocks_pair *pair, const struct ends *ends,
                        struct touch *touch) {
    double point[3], inward[3], height = 0;
    walls_plane(scene->walls, pair->wall, point, inward);
    for (int d = 0; d < 3; d++)
        height += inward[d] * (ends->centre[d] - point[d]);
    return touch_plane(&ends->posed[0], inward, height, touch);
}

/* Gives each point of a contact what the same point remembers: by its features, else by the nearest place of one
 * that nobody has taken, if it is nearer than `reach`. */
static void points_match(const struct rocks_pair *pair, const struct ends *ends, const struct touch *touch,
                         double reach, struct rocks_memory *now) {
    bool taken[TOUCH_POINTS_MAX] = {false}, found[TOUCH_POINTS_MAX] = {false};
    for (int k = 0; k < touch->points; k++) {
        now[k] = (struct rocks_memory){.key = touch->point[k].key};
        rotor_turn_back(ends->turn, touch->point[k].at, now[k].place);
        for (int m = 0; m < pair->points && !found[k]; m++) {
            if (taken[m] || pair->point[m].key != now[k].key)
                continue;
            memcpy(now[k].spring, pair->point[m].spring, sizeof now[k].spring);
            memcpy(now[k].roll, pair->point[m].roll, sizeof now[k].roll);
            found[k] = taken[m] = true;
        }
    }
    for (int k = 0; k < touch->points; k++) {
        int best = -1;
        double least = reach * reach;
        for (int m = 0; m < pair->points && !found[k]; m++) {
            double off[3];
            for (int d = 0; d < 3; d++)
                off[d] = pair->point[m].place[d] - now[k].place[d];
            if (!taken[m] && vector_dot(off, off) < least) {
                least = vector_dot(off, off);
                best = m;
            }
        }
        if (best < 0)
            continue;
        taken[best] = true;
        memcpy(now[k].spring, pair->point[best].spring, sizeof now[k].spring);
        memcpy(now[k].roll, pair->point[best].roll, sizeof now[k].roll);
    }
}

/* Velocity of the surface of a particle at an arm from its centre. */
static void surface_velocity(const struct scene_of *scene, uint32_t i, const double arm[3],
                             double velocity[3]) {
    cross(scene->omega[i], arm, velocity);
    for (int d = 0; d < 3; d++)
        velocity[d] += scene->particles->state[i].v[d];
}

/* The input of the law at a point; `arm`: from both centres. */
static struct law_contact contact_of(const struct scene_of *scene, const struct rocks_pair *pair,
                                     const struct ends *ends, const struct touch *touch, int k,
                                     double arm[2][3]) {
    const struct touch_point *point = &touch->point[k];
    double first[3], second[3], spin[3], at[3], inward[3];
    for (int d = 0; d < 3; d++) {
        arm[0][d] = point->at[d];
        arm[1][d] = point->at[d] - ends->apart[d];
        at[d] = ends->centre[d] + point->at[d];
        inward[d] = -point->normal[d];
    }
    surface_velocity(scene, pair->end[0], arm[0], first);
    if (pair->wall >= 0) {
        walls_surface_motion(scene->walls, pair->wall, at, inward, second, spin);
    } else {
        surface_velocity(scene, pair->end[1], arm[1], second);
        for (int d = 0; d < 3 && scene->list->moves; d++)
            second[d] += (pair->turned ? -1 : 1) * scene->list->drift[pair->image][d];
        memcpy(spin, scene->omega[pair->end[1]], sizeof spin);
    }
    struct law_contact in = {.overlap = touch->overlap,
                             .mass = ends->mass,
                             .radius = ends->radius,
                             .normal = vector(point->normal),
                             .velocity = law_add(vector(second), -1, vector(first)),
                             .coefficients = *ends->coefficients,
                             .half_normal = vector(point->normal),
                             .spin = law_add(vector(spin), -1, vector(scene->omega[pair->end[0]]))};
    return in;
}

/* The normal springs of the law at a point. */
static struct law_springs springs_of(const struct scene_of *scene, const struct ends *ends,
                                     const struct law_contact *in) {
    return law_springs_of(&scene->law->options, ends->coefficients, ends->extra, in->radius, in->overlap);
}

/* Adds a force on the second end at an arm from both centres, with a torque of rolling. */
static void force_give(struct rocks_pair *pair, const struct ends *ends, const double force[3],
                       const double roll[3], const double (*arm)[3]) {
    double torque[2][3];
    cross(arm[0], force, torque[0]);
    cross(arm[1], force, torque[1]);
    for (int d = 0; d < 3; d++) {
        pair->force[d] += force[d];
        pair->torque[0][d] -= torque[0][d] + roll[d];
        pair->torque[1][d] += torque[1][d] + roll[d];
    }
    force_add_virial(pair->sums.virial, 1, pair->wall >= 0 ? arm[0] : ends->apart, force);
}

/* Adds what friction and dampers give at a point: its share of all but the elastic force. */
static void point_act(struct rocks_pair *pair, const struct ends *ends, const struct law_response *out,
                      const struct touch_point *point, double spring, const double (*arm)[3]) {
    const double share = point->share;
    double force[3], roll[3];
    store(law_scale(share, law_add(out->force, -spring, vector(point->normal))), force);
    store(law_scale(share, out->rolling), roll);
    force_give(pair, ends, force, roll, arm);
    pair->sums.tangential += share * out->spring_energy;
    pair->sums.taken += share * out->taken;
}

/* Adds the elastic force, which all features have together. */
static void push_act(struct rocks_pair *pair, const struct ends *ends, const struct touch *touch,
                     double spring) {
    double force[3], branch[3];
    for (int d = 0; d < 3; d++) {
        force[d] = spring * touch->push[d];
        pair->force[d] += force[d];
        pair->torque[0][d] += spring * touch->turn[0][d];
        pair->torque[1][d] += spring * touch->turn[1][d];
        branch[d] = pair->wall >= 0 ? touch->point[0].at[d] : ends->apart[d];
    }
    force_add_virial(pair->sums.virial, 1, branch, force);
}

/* True if another physics, as that of bonds, stands for the contact of a pair. */
static bool joined(const struct scene_of *scene, const struct rocks_pair *pair) {
    PHYSICS_EACH (active, scene->context->set, joints)
        if (active->row != &bodies_physics && active->row->joints->joins(&active->context) &&
            active->row->joints->joined(&active->context, pair->end[0], pair->end[1]))
            return true;
    return false;
}

/* The contact of a pair in this evaluation. */
static void pair_act(const struct scene_of *scene, struct rocks_pair *pair) {
    struct rocks_memory now[TOUCH_POINTS_MAX];
    struct ends ends = {0};
    struct touch touch = {0};
    memset(pair->force, 0, sizeof pair->force);
    memset(pair->torque, 0, sizeof pair->torque);
    pair->sums = (struct rocks_sums){0};
    bool touches =
        (pair->wall >= 0 || !joined(scene, pair)) && ends_make(scene, pair, &ends) &&
        (pair->wall >= 0 ? plane_touch(scene, pair, &ends, &touch)
                         : touch_find(&ends.posed[0], &ends.posed[1], ends.apart, &pair->simplex, &touch));
    if (!touches) {
        pair->points = 0;
        return;
    }
    double smaller =
        pair->wall >= 0 ? ends.posed[0].rounding : fmin(ends.posed[0].rounding, ends.posed[1].rounding);
    points_match(pair, &ends, &touch, smaller, now);
    double spring = 0;
    for (int k = 0; k < touch.points; k++) {
        double arm[2][3];
        struct law_contact in = contact_of(scene, pair, &ends, &touch, k, arm);
        in.spring = vector(now[k].spring);
        in.roll = vector(now[k].roll);
        struct law_springs springs = springs_of(scene, &ends, &in);
        struct law_response out = law_respond_with(scene->law_case, scene->step, &in, springs);
        store(out.spring, now[k].spring);
        store(out.roll, now[k].roll);
        spring = springs.force;
        pair->sums.normal = out.normal_energy;
        point_act(pair, &ends, &out, &touch.point[k], spring, (const double(*)[3])arm);
    }
    push_act(pair, &ends, &touch, spring);
    pair->points = touch.points;
    memcpy(pair->point, now, (size_t)touch.points * sizeof *now);
    pair->sums.overlap = touch.overlap / ends.ball;
}

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

/* Adds to each particle the forces of its pairs, in the order of the ids of their partners. */
static void forces_add(const struct rocks *rocks, const struct particles *p) {
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < rocks->particles; k++) {
        double force[3] = {0}, torque[3] = {0}, *to = p->force + k * (size_t)p->force_stride;
        if (rocks->first[k] == rocks->first[k + 1])
            continue;
        for (size_t e = rocks->first[k]; e < rocks->first[k + 1]; e++) {
            const struct rocks_pair *pair = &rocks->pair[rocks->end[e].pair];
            int side = rocks->end[e].side;
            for (int d = 0; d < 3; d++) {
                force[d] += side ? pair->force[d] : -pair->force[d];
                torque[d] += pair->torque[side][d];
            }
        }
        for (int d = 0; d < 3; d++) {
            to[d] += force[d];
            to[4 + d] += torque[d];
        }
    }
}

/* The force of a rock on a plane acts where its torque says: at an arm across the force. */
static void wall_push(const struct scene_of *scene, struct walls *walls, const struct rocks_pair *pair) {
    double square = vector_dot(pair->force, pair->force), arm[3], point[3];
    struct wall_place place = {.wall = pair->wall};
    if (!(square > 0))
        return;
    cross(pair->force, pair->torque[0], arm); /* torque = -arm x force */
    walls_plane(walls, pair->wall, point, place.normal);
    for (int d = 0; d < 3; d++) {
        place.normal[d] = -place.normal[d];
        place.at[d] = scene->particles->state[pair->end[0]].x[d] - arm[d] / square;
    }
    walls_push(walls, 0, &place, pair->force);
}

void rocks_act(struct bodies *bodies, const struct physics_context *context) {
    struct rocks *rocks = bodies->rocks;
    const struct force_context *contact = grains_contact(context);
    struct scene_of scene = {.context = context,
                             .rocks = rocks,
                             .particles = context->particles,
                             .list = grains_list(context),
                             .walls = grains_walls(context),
                             .law = contact->law,
                             .law_case = law_case_of(&contact->law->options, true),
                             .step = law_step_of(&contact->law->options, context->evaluation->dt),
                             .omega = spin_values(context->particles),
                             .material = material_numbers(context->particles)};
    stands_turn(rocks, context->particles);
#pragma omp parallel for schedule(dynamic, 16)
    for (size_t k = 0; k < rocks->pairs; k++)
        pair_act(&scene, &rocks->pair[k]);
    forces_add(rocks, context->particles);
    for (size_t k = 0; k < rocks->pairs; k++)
        if (rocks->pair[k].wall >= 0)
            wall_push(&scene, grains_walls(context), &rocks->pair[k]);
    rocks->carried = false;
}

void rocks_sum(struct bodies *bodies, const struct physics_context *context) {
    const struct rocks *rocks = bodies->rocks;
    struct grains *grains = grains_of(context->set);
    struct force_sums *sums = &grains->sums;
    double taken = 0;
    for (size_t k = 0; k < rocks->pairs; k++) {
        const struct rocks_pair *pair = &rocks->pair[k];
        const bool whole = pair->wall >= 0 || (pair->gives[0] && pair->gives[1]);
        const double weight = whole ? 1 : 0.5;
        if (pair->points == 0)
            continue;
        sums->contact_sides += whole ? 2 : 1;
        sums->elastic_normal += weight * pair->sums.normal;
        sums->elastic_tangential += weight * pair->sums.tangential;
        taken += weight * pair->sums.taken;
        for (int c = 0; c < 6; c++) {
            sums->virial[c] += weight * pair->sums.virial[c];
            if (grains->exact)
                exact_add(&grains->exact->sum[c], weight * pair->sums.virial[c]);
        }
        if (grains->exact)
            exact_add(&grains->exact->sum[6], weight * pair->sums.normal);
        if (pair->sums.overlap <= sums->overlap_max)
            continue;
        sums->overlap_max = pair->sums.overlap;
        sums->overlap_id[0] = context->particles->id[pair->end[0]];
        sums->overlap_id[1] = pair->wall >= 0 ? -1 - pair->wall : context->particles->id[pair->end[1]];
    }
    sums->contacts = sums->contact_sides / 2;
    sums->taken += taken;
    grains->taken += taken;
}
