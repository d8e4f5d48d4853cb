/* SPDX-License-Identifier: BSD-3-Clause */
/* The contacts of bodies of spheres as points, of which some stand for all. Read contacts.h and thin.h first. */
#include "physics/hard/contacts.h"
#include <string.h>

static struct hard_point *point_next(struct hard_contacts *contacts, size_t count) {
    contacts->point =
        hard_problem_grow(contacts->point, &contacts->point_room, count + 1, sizeof *contacts->point);
    return &contacts->point[count];
}

/* The place of a contact relative to the body of sphere i, whose normal is `normal`. */
static void point_place(struct hard_point *point, const struct hard_scene *scene, uint32_t i) {
    hard_clumps_lever(scene->clumps, i, point->place);
    for (int d = 0; d < 3; d++)
        point->place[d] += scene->particles->state[i].radius * point->normal[d];
}

uint64_t hard_contacts_order(int64_t a, int64_t b) {
    return (uint64_t)a * UINT64_C(0x9e3779b97f4a7c15) + (uint64_t)b;
}

/* Points of pairs of bodies of spheres. */
static size_t points_of_pairs(struct hard_contacts *contacts, const struct hard_pairs *pairs,
                              const struct hard_scene *scene, const struct hard_pace *pace) {
    const int64_t *id = scene->particles->id;
    size_t count = 0;
    for (size_t m = 0; m < pairs->colours.pairs; m++) {
        const uint32_t *end = pairs->end[m];
        double apart[3], distance;
        if (!hard_clumps_carries(scene->clumps, end[0]) || !hard_clumps_carries(scene->clumps, end[1]) ||
            !hard_contacts_near(pairs, scene, pace, m))
            continue;
        struct hard_point *point = point_next(contacts, count++);
        uint64_t a = hard_clumps_carrier(scene->clumps, end[0]),
                 b = hard_clumps_carrier(scene->clumps, end[1]);
        bool first = id[a] < id[b]; /* places and normals are those of the lower one */
        *point =
            (struct hard_point){.bodies = a < b ? a << 32 | b : b << 32 | a,
                                .order = hard_contacts_order(id[end[first ? 0 : 1]], id[end[first ? 1 : 0]]),
                                .number = m,
                                .gap = hard_contacts_separate(pairs, scene, m, apart, &distance),
                                .pressed = pairs->memory[m].push > 0.0};
        for (int d = 0; d < 3; d++)
            point->normal[d] = (first ? apart[d] : -apart[d]) / distance;
        point_place(point, scene, end[first ? 0 : 1]);
    }
    return count;
}

/* Points of bodies of spheres and walls; `number` is that of the contact. */
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
        point_place(point, scene, i);
    }
    return count;
}

void hard_contacts_thin(struct hard_contacts *contacts, const struct hard_pairs *pairs,
                        const struct hard_scene *scene, const struct hard_pace *pace) {
    size_t all = pairs->colours.pairs > contacts->walls ? pairs->colours.pairs : contacts->walls, left = 0;
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
