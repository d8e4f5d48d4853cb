/* SPDX-License-Identifier: BSD-3-Clause */
/* The contacts of bodies as points, of which some stand for all. Read contacts.h and thin.h first. */
#include "physics/hard/contacts.h"
#include <string.h>

static struct hard_point *point_next(struct hard_contacts *contacts, size_t count) {
    contacts->point =
        hard_problem_grow(contacts->point, &contacts->point_room, count + 1, sizeof *contacts->point);
    return &contacts->point[count];
}

/* The place of a contact relative to the body of particle i. `arm`: from the centre of the particle; NULL: along the normal. */
static void point_place(struct hard_point *point, const struct hard_scene *scene, uint32_t i,
                        const double arm[3]) {
    hard_clumps_lever(scene->clumps, i, point->place);
    for (int d = 0; d < 3; d++)
        point->place[d] += arm ? arm[d] : scene->particles->state[i].radius * point->normal[d];
}

uint64_t hard_contacts_order(int64_t a, int64_t b) {
    return (uint64_t)a * UINT64_C(0x9e3779b97f4a7c15) + (uint64_t)b;
}

/* A point of pair m between two bodies; places and normals are those of the one with the lower id. `normal`: of the pair. */
static struct hard_point point_of(const struct hard_pairs *pairs, const struct hard_scene *scene, size_t m,
                                  const double normal[3], const double (*arm)[3]) {
    const int64_t *id = scene->particles->id;
    const uint32_t *end = pairs->end[m];
    uint64_t a = hard_clumps_carrier(scene->clumps, end[0]), b = hard_clumps_carrier(scene->clumps, end[1]);
    const int first = id[a] < id[b] ? 0 : 1;
    struct hard_point point = {.bodies = a < b ? a << 32 | b : b << 32 | a,
                               .order = hard_contacts_order(id[end[first]], id[end[1 - first]])};
    for (int d = 0; d < 3; d++)
        point.normal[d] = first == 0 ? normal[d] : -normal[d];
    point_place(&point, scene, end[first], arm ? arm[first] : NULL);
    return point;
}

/* The points that a pair with a rock offers. */
static size_t points_of_rock(struct hard_contacts *contacts, const struct hard_pairs *pairs,
                             const struct hard_scene *scene, size_t m, size_t count) {
    const struct hard_rocks *rocks = scene->rocks;
    int32_t n = hard_rocks_of(rocks, m);
    for (size_t k = rocks->first[n]; k < rocks->first[n + 1]; k++) {
        const struct hard_offer *offer = &rocks->offer[k];
        struct hard_point *point = point_next(contacts, count++);
        *point = point_of(pairs, scene, m, offer->touch.normal, offer->arm);
        point->order = hard_contacts_order((int64_t)point->order, offer->key);
        point->number = pairs->colours.pairs + k;
        point->gap = offer->touch.gap;
        point->pressed = offer->memory.push > 0.0;
    }
    return count;
}

/* Points of pairs of bodies. */
static size_t points_of_pairs(struct hard_contacts *contacts, const struct hard_pairs *pairs,
                              const struct hard_scene *scene, const struct hard_pace *pace) {
    size_t count = 0;
    for (size_t m = 0; m < pairs->colours.pairs; m++) {
        const uint32_t *end = pairs->end[m];
        double apart[3], distance;
        if (!hard_clumps_carries(scene->clumps, end[0]) || !hard_clumps_carries(scene->clumps, end[1]))
            continue;
        if (hard_rocks_of(scene->rocks, m) >= 0) {
            count = points_of_rock(contacts, pairs, scene, m, count);
            continue;
        }
        if (!hard_contacts_near(pairs, scene, pace, m))
            continue;
        double gap = hard_contacts_separate(pairs, scene, m, apart, &distance);
        for (int d = 0; d < 3; d++)
            apart[d] /= distance;
        struct hard_point *point = point_next(contacts, count++);
        *point = point_of(pairs, scene, m, apart, NULL);
        point->number = m;
        point->gap = gap;
        point->pressed = pairs->memory[m].push > 0.0;
    }
    return count;
}

/* Points of bodies and walls; `number` is that of the contact. */
static size_t points_of_walls(struct hard_contacts *contacts, const struct hard_scene *scene) {
    size_t count = 0;
    for (size_t k = 0; k < contacts->walls; k++) {
        const struct wall_place *place = &contacts->wall[k].place;
        uint32_t i = (uint32_t)place->particle;
        if (!hard_clumps_carries(scene->clumps, i))
            continue;
        struct hard_point *point = point_next(contacts, count++);
        *point = (struct hard_point){.bodies = (uint64_t)hard_clumps_carrier(scene->clumps, i) << 32 |
                                               (uint32_t)place->wall,
                                     .order = contacts->wall[k].order,
                                     .number = k,
                                     .gap = place->gap,
                                     .pressed = contacts->wall[k].memory.push > 0.0};
        memcpy(point->normal, place->normal, sizeof point->normal);
        point_place(point, scene, i, contacts->wall[k].rock ? contacts->wall[k].arm : NULL);
    }
    return count;
}

void hard_contacts_thin(struct hard_contacts *contacts, const struct hard_pairs *pairs,
                        const struct hard_scene *scene, const struct hard_pace *pace) {
    size_t all = pairs->colours.pairs + scene->rocks->offers, left = 0;
    all = all > contacts->walls ? all : contacts->walls;
    contacts->dropped = hard_problem_grow(contacts->dropped, &contacts->dropped_room, all + 1, 1);
    size_t count = points_of_walls(contacts, scene);
    hard_thin(contacts->point, count);
    memset(contacts->dropped, 0, all + 1);
    for (size_t k = 0; k < count; k++)
        contacts->dropped[contacts->point[k].number] = !contacts->point[k].keep;
    for (size_t k = 0; k < contacts->walls; k++)
        if (!contacts->dropped[k])
            contacts->wall[left++] = contacts->wall[k];
    contacts->walls = left;
    count = points_of_pairs(contacts, pairs, scene, pace);
    hard_thin(contacts->point, count);
    memset(contacts->dropped, 0, all + 1);
    for (size_t k = 0; k < count; k++)
        contacts->dropped[contacts->point[k].number] = !contacts->point[k].keep;
}
