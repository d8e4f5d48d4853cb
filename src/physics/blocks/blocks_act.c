/* SPDX-License-Identifier: BSD-3-Clause */
/* The forces between blocks, and their stiffness. Read blocks.h first. */
#include "physics/blocks/blocks_state.h"
#include "base/vector.h"
#include "physics/grains/grains.h"
#include "physics/grains/laws/law_kernel.h"
#include "physics/grains/motion/stability.h"
#include "physics/grains/motion/timestep.h"
#include "physics/grains/walls/walls_free.h"
#include <math.h>
#include <string.h>

/* A pair in an evaluation. */
struct meeting {
    struct walls *walls;
    const struct law *law;
    struct law_case law_case;
    struct law_step step;
    const struct law_coefficients *coefficients;
    const struct law_extra *extra;
    const int *wall;
    double radius, merge, apart[3];
    double place[2]
                [3]; /* of the centres, each in the image of its own wall; of a plane that of the other one */
    const double *turn; /* of the first block */
    bool gives;         /* this rank gives the forces */
};

static struct law_vector vector(const double a[3]) {
    return (struct law_vector){a[0], a[1], a[2]};
}

static void store(struct law_vector from, double to[3]) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

static void meeting_make(const struct blocks *blocks, const struct physics_context *context,
                         const struct blocks_pair *pair, struct meeting *meeting) {
    const struct block *a = &blocks->block[pair->wall[0]], *b = &blocks->block[pair->wall[1]];
    const struct law *law = grains_contact(context)->law;
    const int material[2] = {context->scene->wall[pair->wall[0]].material,
                             context->scene->wall[pair->wall[1]].material};
    *meeting =
        (struct meeting){.walls = grains_walls(context),
                         .law = law,
                         .law_case = law_case_of(&law->options, true),
                         .step = law_step_of(&law->options, context->evaluation->dt),
                         .coefficients = law_pair_of(law, material[0], material[1]),
                         .extra = law->options.user ? law_extra_of(law, material[0], material[1]) : NULL,
                         .wall = pair->wall,
                         .radius = blocks_radius(blocks, pair),
                         .merge = b->kind == BLOCK_PLANE ? a->merge : fmin(a->merge, b->merge),
                         .turn = a->turn,
                         .gives = context->comm->rank == 0};
    memcpy(meeting->place[0], a->place, sizeof a->place);
    memcpy(meeting->place[1], b->kind == BLOCK_PLANE ? a->place : b->place, sizeof b->place);
}

/* The input of the law at a point, whose places on both walls are `at`. */
static struct law_contact contact_of(const struct meeting *meeting, const struct touch *touch,
                                     const struct touch_point *point, const struct touch_memory *memory,
                                     double at[2][3]) {
    double velocity[2][3], spin[2][3], inverse = 0;
    for (int side = 0; side < 2; side++) {
        for (int d = 0; d < 3; d++)
            at[side][d] = meeting->place[side][d] + point->at[d] - (side ? meeting->apart[d] : 0);
        walls_surface_motion(meeting->walls, meeting->wall[side], at[side], point->normal, velocity[side],
                             spin[side]);
        inverse += walls_yield(meeting->walls, meeting->wall[side], at[side], point->normal);
    }
    return (struct law_contact){.overlap = touch->overlap,
                                .mass = inverse > 0 ? 1 / inverse : 0,
                                .radius = meeting->radius,
                                .normal = vector(point->normal),
                                .velocity = law_add(vector(velocity[1]), -1, vector(velocity[0])),
                                .coefficients = *meeting->coefficients,
                                .half_normal = vector(point->normal),
                                .spin = law_add(vector(spin[1]), -1, vector(spin[0])),
                                .spring = vector(memory->spring),
                                .roll = vector(memory->roll)};
}

/* Gives both walls a force on the second one at their places, with a torque each. */
static void force_give(const struct meeting *meeting, const double at[2][3], const double normal[3],
                       const double force[3], const double torque[2][3], double impedance) {
    for (int side = 0; side < 2 && meeting->gives; side++) {
        struct wall_place place = {.wall = meeting->wall[side]};
        double own[3];
        for (int d = 0; d < 3; d++) {
            own[d] = side ? force[d] : -force[d];
            place.at[d] = at[side][d];
            place.normal[d] = normal[d];
            place.torque[d] = torque[side][d];
        }
        walls_push(meeting->walls, 0, &place, own, impedance);
    }
}

/* Friction and dampers at a point: its share of all but the elastic force. */
static void point_act(struct blocks_pair *pair, const struct meeting *meeting, const struct touch *touch,
                      int k, struct law_springs springs, struct touch_memory *memory) {
    const struct touch_point *point = &touch->point[k];
    double at[2][3], force[3], torque[2][3];
    struct law_contact in = contact_of(meeting, touch, point, memory, at);
    struct law_response out = law_respond_with(meeting->law_case, meeting->step, &in, springs);
    store(out.spring, memory->spring);
    store(out.roll, memory->roll);
    store(law_scale(point->share, law_add(out.force, -springs.force, in.normal)), force);
    store(law_scale(-point->share, out.rolling), torque[0]);
    store(law_scale(point->share, out.rolling), torque[1]);
    force_give(meeting, (const double(*)[3])at, point->normal, force, (const double(*)[3])torque, 0);
    pair->tangential += point->share * out.spring_energy;
    pair->taken += point->share * out.taken;
}

/* The elastic force, which all features have together, and the friction of the points. */
static void touch_act(struct blocks_pair *pair, const struct meeting *meeting, const struct touch *touch) {
    struct law_springs springs = law_springs_of(&meeting->law->options, meeting->coefficients, meeting->extra,
                                                meeting->radius, touch->overlap);
    struct touch_memory now[TOUCH_POINTS_MAX];
    double force[3], torque[2][3], at[2][3];
    recall_points(pair->point, (int)pair->points, meeting->turn, touch, meeting->merge, now);
    const double mass = contact_of(meeting, touch, &touch->point[0], &now[0], at).mass;
    for (int k = 0; k < touch->points; k++)
        point_act(pair, meeting, touch, k, springs, &now[k]);
    for (int d = 0; d < 3; d++) {
        force[d] = springs.force * touch->push[d];
        torque[0][d] = springs.force * touch->turn[0][d];
        torque[1][d] = springs.force * touch->turn[1][d];
    }
    force_give(meeting, (const double(*)[3])meeting->place, touch->point[0].normal, force,
               (const double(*)[3])torque, sqrt(fmax(0, mass * springs.force / touch->overlap)));
    pair->overlap = touch->overlap;
    pair->normal = springs.energy;
    pair->points = touch->points;
    memcpy(pair->point, now, (size_t)touch->points * sizeof *now);
}

static bool moves(const struct walls *walls, const struct blocks_pair *pair) {
    return walls_is_free(walls, pair->wall[0]) || walls_is_free(walls, pair->wall[1]);
}

void blocks_act(struct blocks *blocks, const struct physics_context *context) {
    blocks_stand(blocks, context);
    for (int p = 0; p < blocks->pairs; p++) {
        struct blocks_pair *pair = &blocks->pair[p];
        struct meeting meeting;
        struct features features;
        struct touch touch = {0};
        meeting_make(blocks, context, pair, &meeting);
        pair->overlap = pair->normal = pair->tangential = pair->taken = 0;
        if (!moves(meeting.walls, pair) ||
            blocks_features(blocks, context, pair, meeting.apart, &features) == 0) {
            pair->points = 0;
            continue;
        }
        feature_sum(features.feature, features.count, meeting.apart, TOUCH_MERGE * meeting.merge, &touch);
        touch_act(pair, &meeting, &touch);
    }
}

/* Overlaps that are to be expected, over the effective radius. */
static const double overlap_usual = 1e-3;

/* Adds a pair to both walls: `most` features that overlap alike are most^(1/3) times as stiff as one against a push, and at most five
 * times that against a tilt (docs/physics.md, Rocks). */
static void pair_stiffen(const struct blocks *blocks, const struct physics_context *context,
                         const struct blocks_pair *pair, struct stability *stability) {
    enum { FEATURES = 8, TILT = 5 };
    const struct walls *walls = grains_walls(context);
    const struct law *law = grains_contact(context)->law;
    const double h = stability->step, radius = blocks_radius(blocks, pair), most = cbrt((double)FEATURES);
    double yield[2];
    for (int side = 0; side < 2; side++)
        yield[side] = walls_yield_most(walls, pair->wall[side]);
    if (!(yield[0] + yield[1] > 0))
        return;
    struct timestep_springs s = timestep_springs(
        law, context->scene->wall[pair->wall[0]].material, context->scene->wall[pair->wall[1]].material,
        1 / (yield[0] + yield[1]), radius, fmax(pair->overlap, overlap_usual * radius));
    const double push = most * (h * h * (TILT * s.k_n + s.k_t) + 2 * h * (s.c_n + s.c_t)),
                 roll = most * h * (h * s.k_r + 2 * s.c_r) * radius * radius;
    for (int side = 0; side < 2; side++)
        stability->wall[pair->wall[side]] +=
            push * yield[side] + roll * walls_turn_yield(walls, pair->wall[side]);
}

void blocks_stiffen(const struct blocks *blocks, const struct physics_context *context,
                    struct stability *stability) {
    for (int p = 0; stability->wall && p < blocks->pairs; p++)
        pair_stiffen(blocks, context, &blocks->pair[p], stability);
}

double blocks_stiffest(const struct blocks *blocks, const struct stability *stability) {
    double most = 0;
    for (int p = 0; stability->wall && p < blocks->pairs; p++)
        most =
            fmax(most, stability->wall[blocks->pair[p].wall[0]] + stability->wall[blocks->pair[p].wall[1]]);
    return most;
}
