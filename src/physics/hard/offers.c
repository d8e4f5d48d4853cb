/* SPDX-License-Identifier: BSD-3-Clause */
/* What pairs with rocks, and rocks and walls, offer in a step. Read offers.h first. */
#include "physics/hard/offers.h"
#include "base/memory.h"
#include "base/rotor.h"
#include "engine/physics_set.h"
#include "physics/bodies/rocks_near.h"
#include "physics/grains/grains.h"
#include "physics/hard/problem.h"
#include <math.h>

static const char what[] = "contacts of rocks";

void hard_rocks_create(struct hard_rocks *rocks, const struct physics_context *context) {
    const struct bodies *bodies = bodies_of(context->set);
    *rocks = (struct hard_rocks){.context = context, .threads = context->threads};
    rocks->rocks = bodies ? bodies->rocks : NULL;
    rocks->found = memory_allocate_zero((size_t)rocks->threads, sizeof *rocks->found, what);
}

void hard_rocks_free(struct hard_rocks *rocks) {
    for (int t = 0; t < rocks->threads; t++) {
        memory_free(rocks->found[t].offer);
        memory_free(rocks->found[t].wall);
    }
    memory_free(rocks->found);
    memory_free(rocks->pair);
    memory_free(rocks->of);
    memory_free(rocks->first);
    memory_free(rocks->offer);
    memory_free(rocks->past);
    *rocks = (struct hard_rocks){0};
}

bool hard_rocks_is(const struct hard_rocks *rocks, uint32_t i) {
    return rocks->rocks && rocks->rocks->stand_of[i] >= 0;
}

/* The first point that pair m remembers. */
static size_t past_first(const struct hard_rocks *rocks, uint32_t m) {
    size_t low = 0, high = rocks->pasts;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (rocks->past[middle].pair < m)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Gives an offer a memory, which no other one gets. */
static void recall(struct hard_offer *offer, const struct hard_past *past, bool *taken) {
    offer->memory = past->memory;
    offer->couple = past->couple;
    *taken = true;
}

/* Gives the offers of a pair what they remember: by their features, then by the nearest places up to `follow`. */
static void offers_recall(const struct hard_rocks *rocks, uint32_t m, struct hard_offer *offer, int count,
                          double follow) {
    const struct hard_past *past = rocks->past + past_first(rocks, m);
    bool taken[ROCKS_POINTS_MAX] = {false}, found[ROCKS_POINTS_MAX] = {false};
    int pasts = 0;
    while (pasts < ROCKS_POINTS_MAX && past + pasts < rocks->past + rocks->pasts && past[pasts].pair == m)
        pasts++;
    for (int k = 0; k < count; k++)
        for (int p = 0; p < pasts && !found[k]; p++)
            if (!taken[p] && past[p].key == offer[k].key) {
                recall(&offer[k], &past[p], &taken[p]);
                found[k] = true;
            }
    for (int k = 0; k < count; k++) {
        double least = follow * follow, off[3];
        int best = -1;
        for (int p = 0; p < pasts && !found[k]; p++) {
            vector_minus(past[p].place, offer[k].place, off);
            if (!taken[p] && vector_dot(off, off) < least) {
                least = vector_dot(off, off);
                best = p;
            }
        }
        if (best >= 0)
            recall(&offer[k], &past[best], &taken[best]);
    }
}

/* An offer from a point. `turned`: the row goes from the second end of the pair of rocks to the first one. */
static struct hard_offer offer_of(const struct rocks_point *point, const struct rocks_ends *ends, bool wall,
                                  bool turned) {
    struct hard_offer offer = {.key = point->key, .touch = {.gap = point->gap, .size = ends->inner}};
    for (int d = 0; d < 3; d++) {
        offer.touch.normal[d] = turned ? -point->normal[d] : point->normal[d];
        offer.arm[turned][d] = point->at[d];
        offer.arm[!turned][d] = wall ? 0.0 : point->at[d] - ends->apart[d];
    }
    offer.touch.radius[turned] = ends->posed[0].rounding;
    offer.touch.radius[!turned] = wall ? INFINITY : ends->posed[1].rounding;
    rotor_turn_back(ends->turn, point->at, offer.place);
    return offer;
}

/* Appends the points of a pair to those of a thread; returns their number. */
static int pair_offer(const struct hard_rocks *rocks, const struct rocks_scene *scene,
                      const struct hard_pairs *pairs, const struct hard_rocks_pair *pair,
                      struct walls_probe *probe, struct hard_found *found) {
    struct rocks_pair *rock = &rocks->rocks->pair[pair->rock];
    struct rocks_points points;
    struct rocks_ends ends;
    int count = rocks_near(scene, rock, probe, &ends, &points);
    bool turned = pairs->end[pair->pair][0] != rock->end[0];
    size_t all = found->count + (size_t)count;
    if (count == 0)
        return 0;
    found->offer = hard_problem_grow(found->offer, &found->room, all, sizeof *found->offer);
    struct hard_offer *offer = found->offer + found->count;
    for (int k = 0; k < count; k++)
        offer[k] = offer_of(&points.point[k], &ends, false, turned);
    if (rocks->pasts > 0)
        offers_recall(rocks, pair->pair, offer, count, points.follow);
    found->count = all;
    return count;
}

/* The place of a wall that belongs to a point. */
static struct wall_place place_of(const struct rocks_scene *scene, const struct rocks_pair *rock,
                                  const struct rocks_ends *ends, const struct rocks_point *point) {
    struct wall_place place = {
        .particle = rock->end[0], .wall = rock->wall, .feature = (int32_t)point->key, .gap = point->gap};
    double spin[3];
    for (int d = 0; d < 3; d++) {
        place.normal[d] = point->normal[d];
        place.at[d] = ends->centre[d] + point->at[d];
    }
    walls_surface_motion(scene->walls, rock->wall, place.at, place.normal, place.velocity, spin);
    return place;
}

/* Appends the points of a rock and a wall to those of a thread. */
static void wall_offer(const struct hard_rocks *rocks, const struct rocks_scene *scene,
                       const struct hard_rocks_pair *pair, struct walls_probe *probe,
                       struct hard_found *found) {
    struct rocks_pair *rock = &rocks->rocks->pair[pair->rock];
    struct rocks_points points;
    struct rocks_ends ends;
    size_t count = (size_t)rocks_near(scene, rock, probe, &ends, &points);
    found->wall =
        hard_problem_grow(found->wall, &found->wall_room, found->walls + count, sizeof *found->wall);
    for (size_t k = 0; k < count; k++)
        found->wall[found->walls++] = (struct hard_wall_offer){
            place_of(scene, rock, &ends, &points.point[k]), offer_of(&points.point[k], &ends, true, false)};
}

/* The offers of all threads as one array; `first` has the number of each pair, one place behind its own. */
static void offers_join(struct hard_rocks *rocks) {
    size_t count = 0;
    rocks->first[0] = 0;
    for (size_t n = 0; n < rocks->pairs; n++)
        rocks->first[n + 1] += rocks->first[n];
    rocks->offers = rocks->first[rocks->pairs];
    rocks->offer = hard_problem_grow(rocks->offer, &rocks->room, rocks->offers, sizeof *rocks->offer);
    for (int t = 0; t < rocks->threads; t++) {
        const struct hard_found *found = &rocks->found[t];
        if (found->count > 0)
            memcpy(rocks->offer + count, found->offer, found->count * sizeof *found->offer);
        count += found->count;
    }
}

/* The part of `count` that thread t has begins here. */
static size_t part_of(const struct hard_rocks *rocks, size_t count, int t) {
    return count * (size_t)t / (size_t)rocks->threads;
}

void hard_rocks_find(struct hard_rocks *rocks, const struct hard_pairs *pairs, double near) {
    struct rocks_scene scene;
    if (rocks->rocks == NULL)
        return;
    rocks_scene_make(rocks->rocks, rocks->context, &scene);
    scene.reach = near;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < rocks->threads; t++) {
        struct hard_found *found = &rocks->found[t];
        struct walls_probe probe = {0};
        found->count = found->walls = 0;
        for (size_t n = part_of(rocks, rocks->pairs, t); n < part_of(rocks, rocks->pairs, t + 1); n++)
            rocks->first[n + 1] = (size_t)pair_offer(rocks, &scene, pairs, &rocks->pair[n], &probe, found);
        for (size_t k = part_of(rocks, rocks->walls, t); k < part_of(rocks, rocks->walls, t + 1); k++)
            wall_offer(rocks, &scene, &rocks->pair[rocks->pairs + k], &probe, found);
        walls_probe_free(&probe);
    }
    offers_join(rocks);
}
