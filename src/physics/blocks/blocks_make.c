/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls as blocks, and the features of their contacts. Read blocks.h first. */
#include "physics/blocks/blocks_state.h"
#include "base/memory.h"
#include "base/rotor.h"
#include "base/vector.h"
#include "physics/grains/grains.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A mesh that fills less of its hull is not convex. */
static const double convex_part = 0.999999;

/* A round core's points are one where they are nearer than this part of its length. */
static const double round_merge = 0.1;

static const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/* Refuses wall w of pair p: `why` goes on behind its name. */
static bool refuse(const struct physics_context *context, int p, int w, const char *why,
                   struct error *error) {
    const struct scene *scene = context->scene;
    char key[64];
    snprintf(key, sizeof key, "wall_contacts.pairs[%d].walls", p);
    return scene_fail(scene, error, key, "wall '%s' %s", scene->wall[w].name, why);
}

/* The corners of the triangles of a wall, about the corner of the box, before its motions. Allocated. */
static double (*corners_at_rest(const struct physics_context *context, int w, size_t *triangles))[9] {
    double(*corner)[9];
    struct wall_pose pose;
    *triangles = walls_triangles(grains_walls(context), w, &corner);
    walls_pose(grains_walls(context), w, &pose);
    for (size_t k = 0; k < 3 * *triangles; k++) {
        double *x = corner[k / 3] + 3 * (k % 3);
        for (int d = 0; d < 3; d++)
            x[d] -= context->box->origin[d] + pose.translation[d];
        rotor_turn_back(pose.rotation, x, x);
    }
    return corner;
}

/* The solid that a closed convex surface bounds, about its centre; false, with what to say behind its name, where it is none. */
static bool solid_of(struct solid *solid, const double (*corner)[9], size_t triangles, double centre[3],
                     char *why, size_t room) {
    struct moments inside, hull;
    struct error refused = {0};
    moments_solid(corner, triangles, &inside);
    if (!solid_make(solid, (const double(*)[3])corner, 3 * triangles, &refused)) {
        snprintf(why, room, "%s", refused.text);
        return false;
    }
    solid_moments(solid, &hull);
    memcpy(centre, hull.centre, sizeof hull.centre);
    solid_move(solid, hull.centre, identity);
    if (fabs(inside.volume) >= convex_part * hull.volume)
        return true;
    snprintf(why, room, "is not convex: it fills %.4g of its hull", fabs(inside.volume) / hull.volume);
    return false;
}

static bool solid_take(struct block *block, const struct physics_context *context, int p, int w,
                       double rounding, struct error *error) {
    struct solid solid = {0};
    struct error small = {0};
    char why[400];
    size_t triangles;
    if (isnan(rounding))
        return scene_fail(context->scene, error, "wall_contacts.rounding",
                          "is missing: edges and corners of wall '%s' touch by it",
                          context->scene->wall[w].name);
    if (walls_open_edges(grains_walls(context), w) > 0)
        return refuse(context, p, w,
                      "has an open surface; allowed: planes, boxes, cylinders, closed convex meshes", error);
    double(*corner)[9] = corners_at_rest(context, w, &triangles);
    bool good = solid_of(&solid, (const double(*)[9])corner, triangles, block->centre, why, sizeof why);
    memory_free(corner);
    if (good && !solid_inset(&block->core, &solid, rounding, &small)) {
        snprintf(why, sizeof why, "%s; allowed: a smaller wall_contacts.rounding", small.text);
        good = false;
    }
    solid_free(&solid);
    block->rounding = block->merge = rounding;
    return good || refuse(context, p, w, why, error);
}

/* The axis of a cylinder; one without ends reaches far beyond the box. */
static void round_take(struct block *block, const struct wall_options *wall, const struct box *box) {
    const double length = sqrt(vector_dot(wall->axis, wall->axis)),
                 whole = wall->length > 0 ? wall->length : 8 * (box->edge[0] + box->edge[1] + box->edge[2]);
    solid_dot(&block->core);
    block->core.corners = 2;
    for (int d = 0; d < 3; d++) {
        block->centre[d] = wall->point[d] - box->origin[d];
        block->core.corner[0][d] = -0.5 * whole * wall->axis[d] / length;
        block->core.corner[1][d] = 0.5 * whole * wall->axis[d] / length;
    }
    block->core.edges = 1;
    block->core.edge[0] = (struct solid_edge){{0, 1}, {-1, -1}};
    block->rounding = wall->radius;
    block->merge = fmin(wall->radius, round_merge * whole);
}

/* Wall w of pair p. */
static bool block_take(struct blocks *blocks, const struct physics_context *context, int p, int w,
                       struct error *error) {
    struct block *block = &blocks->block[w];
    const struct wall_options *wall = &context->scene->wall[w];
    if (block->kind != BLOCK_NONE)
        return true;
    block->kind = wall->shape == WALL_PLANE      ? BLOCK_PLANE
                  : wall->shape == WALL_CYLINDER ? BLOCK_ROUND
                                                 : BLOCK_SOLID;
    if (block->kind == BLOCK_PLANE)
        return true;
    if (block->kind == BLOCK_ROUND)
        round_take(block, wall, context->box);
    else if (!solid_take(block, context, p, w, blocks->options->rounding, error))
        return false;
    block->extent = solid_extent(&block->core) + block->rounding;
    block->corner = memory_allocate_zero((size_t)block->core.corners, sizeof *block->corner, "wall contacts");
    return true;
}

bool blocks_make(struct blocks *blocks, const struct physics_context *context, struct error *error) {
    *blocks = (struct blocks){.options = context->options, .walls = context->scene->walls};
    blocks->block = memory_allocate_zero((size_t)blocks->walls, sizeof *blocks->block, "wall contacts");
    for (int p = 0; p < blocks->options->pairs; p++) {
        const int *wall = blocks->options->pair[p].wall;
        struct blocks_pair *pair = &blocks->pair[blocks->pairs++];
        for (int side = 0; side < 2; side++)
            if (!block_take(blocks, context, p, wall[side], error))
                return false;
        bool turned = blocks->block[wall[0]].kind == BLOCK_PLANE;
        pair->wall[0] = wall[turned];
        pair->wall[1] = wall[!turned];
        if (blocks->block[pair->wall[0]].kind == BLOCK_PLANE)
            return refuse(context, p, wall[0], "is a plane, and so is the other one; allowed: one of them",
                          error);
    }
    return true;
}

void blocks_free(struct blocks *blocks) {
    for (int w = 0; blocks->block && w < blocks->walls; w++) {
        solid_free(&blocks->block[w].core);
        memory_free(blocks->block[w].corner);
    }
    memory_free(blocks->block);
    blocks->block = NULL;
}

void blocks_stand(struct blocks *blocks, const struct physics_context *context) {
    for (int w = 0; w < blocks->walls; w++) {
        struct block *block = &blocks->block[w];
        struct wall_pose pose;
        if (block->kind == BLOCK_NONE || block->kind == BLOCK_PLANE)
            continue;
        walls_pose(grains_walls(context), w, &pose);
        memcpy(block->turn, pose.rotation, sizeof block->turn);
        rotor_turn(pose.rotation, block->centre, block->place);
        for (int d = 0; d < 3; d++)
            block->place[d] += pose.translation[d];
        posed_corners(&block->core, block->turn, 1, block->corner);
    }
}

static struct posed posed_of(const struct block *block) {
    return (struct posed){.core = &block->core,
                          .corner = (const double(*)[3])block->corner,
                          .turn = block->turn,
                          .scale = 1,
                          .rounding = block->rounding};
}

/* The ends of a cylinder are flat: an end of the axis stands for the place of its rim that lies farthest along the normal. `side`: 1
 * of the first block, -1 of the second one. */
static void rim_take(const struct block *block, double side, struct feature *feature) {
    const double *from = block->corner[0], *to = block->corner[1], radius = block->rounding;
    const double before = feature->overlap;
    double axis[3], out[3];
    vector_minus(to, from, axis);
    const double length = sqrt(vector_dot(axis, axis)), along = vector_dot(feature->normal, axis) / length,
                 across = sqrt(fmax(0, 1 - along * along));
    feature->overlap -= radius * (1 - across);
    for (int d = 0; d < 3; d++) {
        out[d] = across > 1e-6 ? (feature->normal[d] - along * axis[d] / length) / across : 0;
        feature->at[d] += side * (radius * (out[d] - feature->normal[d]) +
                                  0.5 * (before - feature->overlap) * feature->normal[d]);
    }
}

static void rims_take(const struct block *block, double side, struct features *features) {
    int left = 0;
    for (int k = 0; block->kind == BLOCK_ROUND && k < features->count; k++) {
        rim_take(block, side, &features->feature[k]);
        if (features->feature[k].overlap > 0)
            features->feature[left++] = features->feature[k];
    }
    features->count = block->kind == BLOCK_ROUND ? left : features->count;
}

/* The vector to the nearest image of the second block; false: they are too far from each other. */
static bool apart_find(const struct block *a, const struct block *b, const struct box *box, double apart[3]) {
    const double reach = a->extent + b->extent;
    vector_minus(b->place, a->place, apart);
    for (int d = 0; d < 3; d++)
        if (box->periodic[d])
            apart[d] -= box->edge[d] * rint(apart[d] / box->edge[d]);
    return vector_dot(apart, apart) < reach * reach;
}

int blocks_features(const struct blocks *blocks, const struct physics_context *context,
                    const struct blocks_pair *pair, double apart[3], struct features *features) {
    const struct block *a = &blocks->block[pair->wall[0]], *b = &blocks->block[pair->wall[1]];
    const struct posed first = posed_of(a), second = posed_of(b);
    struct gjk_simplex simplex = {0};
    double point[3], normal[3], height[3] = {0};
    features->count = 0;
    if (b->kind == BLOCK_PLANE) {
        memset(apart, 0, 3 * sizeof *apart);
        if (!walls_plane(grains_walls(context), pair->wall[1], point, normal))
            return 0;
        vector_minus(a->place, point, height);
        touch_plane(&first, normal, vector_dot(normal, height), features);
    } else if (apart_find(a, b, context->box, apart)) {
        touch_find(&first, &second, apart, &simplex, features, normal);
    }
    rims_take(a, 1, features);
    rims_take(b, -1, features);
    return features->count;
}

double blocks_radius(const struct blocks *blocks, const struct blocks_pair *pair) {
    const struct block *a = &blocks->block[pair->wall[0]], *b = &blocks->block[pair->wall[1]];
    return b->kind == BLOCK_PLANE ? a->rounding : a->rounding * b->rounding / (a->rounding + b->rounding);
}

double blocks_size(const struct blocks *blocks, const struct blocks_pair *pair) {
    const struct block *a = &blocks->block[pair->wall[0]], *b = &blocks->block[pair->wall[1]];
    const double of[2] = {a->kind == BLOCK_ROUND ? a->rounding : a->extent, b->kind == BLOCK_PLANE ? INFINITY
                                                                            : b->kind == BLOCK_ROUND
                                                                                ? b->rounding
                                                                                : b->extent};
    return fmin(of[0], of[1]);
}
