/* SPDX-License-Identifier: BSD-3-Clause */
/* The contacts of rocks in a step: points, the law at each point, forces and torques. Read rocks.h first. */
#include "physics/bodies/rocks_ends.h"
#include "base/vector.h"
#include "physics/grains/walls/walls_free.h"
#include "physics/grains/grains.h"
#include <math.h>
#include <string.h>

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

/* Velocity of the surface of a particle at an arm from its centre. */
static void surface_velocity(const struct rocks_scene *scene, uint32_t i, const double arm[3],
                             double velocity[3]) {
    cross(scene->omega[i], arm, velocity);
    for (int d = 0; d < 3; d++)
        velocity[d] += scene->particles->state[i].v[d];
}

/* The effective mass at a point, for dampers: a free wall gives way. */
static double mass_at(const struct rocks_scene *scene, const struct rocks_pair *pair,
                      const struct rocks_ends *ends, const double at[3], const double along[3]) {
    if (pair->wall < 0 || !walls_is_free(scene->walls, pair->wall))
        return ends->mass;
    double inverse = (ends->mass > 0 ? 1 / ends->mass : 0) + walls_yield(scene->walls, pair->wall, at, along);
    return inverse > 0 ? 1 / inverse : 0;
}

/* The input of the law at a point; `arm`: from both centres. */
static struct law_contact contact_of(const struct rocks_scene *scene, const struct rocks_pair *pair,
                                     const struct rocks_ends *ends, const struct touch *touch, int k,
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
                             .mass = mass_at(scene, pair, ends, at, inward),
                             .radius = ends->radius,
                             .normal = vector(point->normal),
                             .velocity = law_add(vector(second), -1, vector(first)),
                             .coefficients = *ends->coefficients,
                             .half_normal = vector(point->normal),
                             .spin = law_add(vector(spin), -1, vector(scene->omega[pair->end[0]]))};
    return in;
}

/* Adds a force on the second end at an arm from both centres, with a torque of rolling. */
static void force_give(struct rocks_pair *pair, const struct rocks_ends *ends, const double force[3],
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
static void point_act(struct rocks_pair *pair, const struct rocks_ends *ends, const struct law_response *out,
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
static void push_act(struct rocks_pair *pair, const struct rocks_ends *ends, const struct touch *touch,
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

/* A point of one of the contacts of a pair. */
struct chosen {
    int contact, point;
    double weight; /* of the force there */
};

/* The contacts of a pair: one, or those with the features of a wall. */
enum { CONTACTS_MAX = 64 };
struct contacts {
    int count, points;
    struct touch touch[CONTACTS_MAX];
    double spring[CONTACTS_MAX], energy[CONTACTS_MAX];
    struct chosen point[TOUCH_POINTS_MAX];
};

/* Takes a point; where there is no room, the one with the least force goes. */
static void point_choose(struct contacts *contacts, int contact, int point, double weight) {
    int least = 0;
    for (int k = 1; k < contacts->points; k++)
        least = contacts->point[k].weight < contacts->point[least].weight ? k : least;
    if (contacts->points < TOUCH_POINTS_MAX)
        least = contacts->points++;
    else if (contacts->point[least].weight >= weight)
        return;
    contacts->point[least] = (struct chosen){contact, point, weight};
}

/* Adds up the features of each contact. The last one has the rest, should there be too many. */
static void contacts_make(const struct rocks_scene *scene, const struct rocks_ends *ends,
                          const struct features *features, double merge, struct contacts *contacts) {
    contacts->count = contacts->points = 0;
    for (int from = 0, count; from < features->count; from += count) {
        const int c = contacts->count++;
        struct touch *touch = &contacts->touch[c];
        count = c + 1 < CONTACTS_MAX ? rocks_group(features, from) : features->count - from;
        *touch = (struct touch){0};
        feature_sum(features->feature + from, count, ends->apart, merge, touch);
        struct law_springs springs = rocks_springs(scene, ends, touch->overlap);
        contacts->spring[c] = springs.force;
        contacts->energy[c] = springs.energy;
        for (int k = 0; k < touch->points; k++)
            point_choose(contacts, c, k, touch->point[k].share * springs.force);
    }
}

/* The chosen points as points of one contact, for their memory. */
static void points_list(const struct contacts *contacts, struct touch *list) {
    list->points = contacts->points;
    for (int k = 0; k < contacts->points; k++)
        list->point[k] = contacts->touch[contacts->point[k].contact].point[contacts->point[k].point];
}

/* The forces of all contacts of a pair. */
static void contacts_act(const struct rocks_scene *scene, struct rocks_pair *pair,
                         const struct rocks_ends *ends, struct contacts *contacts, struct touch_memory *now) {
    for (int p = 0; p < contacts->points; p++) {
        const int c = contacts->point[p].contact, k = contacts->point[p].point;
        const struct touch *touch = &contacts->touch[c];
        double arm[2][3];
        struct law_contact in = contact_of(scene, pair, ends, touch, k, arm);
        in.spring = vector(now[p].spring);
        in.roll = vector(now[p].roll);
        struct law_springs springs = rocks_springs(scene, ends, in.overlap);
        struct law_response out = law_respond_with(scene->law_case, scene->step, &in, springs);
        store(out.spring, now[p].spring);
        store(out.roll, now[p].roll);
        point_act(pair, ends, &out, &touch->point[k], springs.force, (const double(*)[3])arm);
    }
    for (int c = 0; c < contacts->count; c++) {
        push_act(pair, ends, &contacts->touch[c], contacts->spring[c]);
        if (pair->wall >= 0 && contacts->spring[c] > 0)
            pair->sums.impedance += sqrt(ends->mass * contacts->spring[c] / contacts->touch[c].overlap);
        pair->sums.normal += contacts->energy[c];
        if (contacts->touch[c].overlap <= pair->sums.overlap * ends->ball)
            continue;
        pair->sums.overlap = contacts->touch[c].overlap / ends->ball;
        memcpy(pair->normal, contacts->touch[c].point[0].normal, sizeof pair->normal);
    }
}

/* The contacts of a pair in this evaluation. */
static void pair_act(const struct rocks_scene *scene, struct rocks_pair *pair, struct walls_probe *probe) {
    struct touch_memory now[TOUCH_POINTS_MAX];
    struct rocks_ends ends = {0};
    struct touch points = {0};
    struct features features;
    struct contacts contacts;
    memset(pair->force, 0, sizeof pair->force);
    memset(pair->torque, 0, sizeof pair->torque);
    pair->sums = (struct rocks_sums){0};
    const bool touches =
        rocks_ends_make(scene, pair, &ends) && rocks_features(scene, pair, &ends, probe, &features) > 0;
    if (!touches) {
        pair->points = 0;
        return;
    }
    double smaller =
        pair->wall >= 0 ? ends.posed[0].rounding : fmin(ends.posed[0].rounding, ends.posed[1].rounding);
    contacts_make(scene, &ends, &features, TOUCH_MERGE * smaller, &contacts);
    points_list(&contacts, &points);
    recall_points(pair->point, pair->points, ends.turn, &points, smaller, now);
    contacts_act(scene, pair, &ends, &contacts, now);
    pair->points = points.points;
    memcpy(pair->point, now, (size_t)points.points * sizeof *now);
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

/* The force of a rock on a wall acts where its torque says: at an arm across the force. The torque along the force, which no
 * arm has, goes with it. */
static void wall_push(const struct rocks_scene *scene, struct walls *walls, const struct rocks_pair *pair) {
    double square = vector_dot(pair->force, pair->force), arm[3], shift[3];
    struct wall_place place = {.wall = pair->wall};
    if (!(square > 0))
        return;
    cross(pair->force, pair->torque[0], arm); /* torque = -arm x force */
    walls_group_shift(walls, &pair->group, shift);
    for (int d = 0; d < 3; d++) {
        place.normal[d] = pair->normal[d];
        place.torque[d] = -vector_dot(pair->torque[0], pair->force) / square * pair->force[d];
        place.at[d] = scene->particles->state[pair->end[0]].x[d] - shift[d] - arm[d] / square;
    }
    walls_push(walls, 0, &place, pair->force, pair->sums.impedance);
}

void rocks_act(struct bodies *bodies, const struct physics_context *context) {
    struct rocks *rocks = bodies->rocks;
    struct rocks_scene scene;
    rocks_scene_make(rocks, context, &scene);
#pragma omp parallel
    {
        struct walls_probe probe = {0};
#pragma omp for schedule(dynamic, 16)
        for (size_t k = 0; k < rocks->pairs; k++)
            pair_act(&scene, &rocks->pair[k], &probe);
        walls_probe_free(&probe);
    }
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
