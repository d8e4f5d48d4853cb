/* SPDX-License-Identifier: BSD-3-Clause */
/* The features of a rock and a wall. Read rocks_ends.h first. */
#include "physics/bodies/rocks_ends.h"
#include "base/vector.h"
#include <math.h>
#include <string.h>

/* Corners look for walls as far as this many roundings beyond the reach, to find those that they have crossed. */
static const double corner_reach = 2;

/* A rock and a wall. */
struct meeting {
    const struct rocks_scene *scene;
    const struct rocks_pair *pair;
    const struct posed *rock;
    const double *centre; /* of the rock, box-relative */
    struct walls_probe *probe;
    struct features *features;
};

static void place_of(const struct meeting *meeting, const double about[3], double place[3]) {
    for (int d = 0; d < 3; d++)
        place[d] = meeting->centre[d] + about[d];
}

/* True if the way from the centre of the rock to a corner goes through the surface that the corner touches from behind. */
static bool has_crossed(const struct meeting *meeting, const struct wall_corner *touch,
                        const double corner[3]) {
    double height = -vector_dot(touch->normal, corner), back[3], place[3];
    struct walls_probe probe = {0};
    if (touch->distance < 0 || !(height > touch->distance) ||
        walls_one_sided(meeting->scene->walls, meeting->pair->wall))
        return false;
    for (int d = 0; d < 3; d++)
        back[d] = corner[d] * (1 - touch->distance / height);
    place_of(meeting, back, place);
    walls_group_touch(meeting->scene->walls, &meeting->pair->group, place, 1e-3 * meeting->rock->rounding,
                      &probe);
    bool crossed = probe.corners > 0;
    walls_probe_free(&probe);
    return crossed;
}

static void corner_take(const struct meeting *meeting, int k) {
    const double *corner = meeting->rock->corner[k], rounding = meeting->rock->rounding;
    double place[3];
    place_of(meeting, corner, place);
    walls_group_touch(meeting->scene->walls, &meeting->pair->group, place,
                      corner_reach * rounding + meeting->scene->reach, meeting->probe);
    for (size_t c = 0; c < meeting->probe->corners; c++) {
        struct wall_corner touch = meeting->probe->corner[c];
        if (has_crossed(meeting, &touch, corner)) {
            touch.distance = -touch.distance;
            for (int d = 0; d < 3; d++)
                touch.normal[d] = -touch.normal[d];
        }
        feature_add(meeting->features, meeting->rock, rounding, touch.distance, corner, touch.normal,
                    touch_key(TOUCH_CORNER_A, k, touch.feature & 255));
    }
}

/* True if the rock touches a place of a wall from where the wall is hollow; `normal`: from the rock to the wall. */
static bool is_hollow(const double inward[3], const double normal[3]) {
    return vector_dot(inward, normal) < -1e-9;
}

/* An edge of the wall with the edges of the rock. */
static void edge_take(const struct meeting *meeting, const struct wall_edge *edge) {
    const struct posed *rock = meeting->rock;
    for (int e = 0; e < rock->core->edges; e++) {
        const int *of = rock->core->edge[e].end;
        const double *const end[4] = {rock->corner[of[0]], rock->corner[of[1]], edge->end[0], edge->end[1]};
        const struct feature *feature = feature_edges(meeting->features, rock, rock->rounding + edge->radius,
                                                      end, touch_key(TOUCH_EDGES, e, edge->feature & 255));
        if (feature == NULL)
            continue;
        if (is_hollow(edge->inward, feature->normal) || vector_dot(feature->normal, feature->at) < 0)
            meeting->features->count--;
    }
}

/* The face of the rock's core that a place inside of it is nearest to. */
static double depth_of(const struct posed *rock, const double place[3], double normal[3]) {
    double least = INFINITY;
    for (int f = 0; f < rock->core->faces; f++) {
        double n[3];
        posed_normal(rock, f, n);
        double depth = rock->scale * rock->core->face[f].offset - vector_dot(n, place);
        if (depth >= least)
            continue;
        least = depth;
        memcpy(normal, n, sizeof n);
    }
    return least;
}

static void vertex_take(const struct meeting *meeting, const struct wall_vertex *vertex) {
    static const double apart[3] = {0};
    const struct posed *rock = meeting->rock;
    const struct gjk_set core = {rock->core->corners, rock->corner},
                         place = {1, (const double(*)[3]) & vertex->place};
    struct gjk_simplex simplex = {0};
    struct gjk_nearest nearest = {0};
    if (!gjk_distance(&core, &place, apart, &simplex, &nearest)) {
        nearest.distance = -depth_of(rock, vertex->place, nearest.normal);
        for (int d = 0; d < 3; d++)
            nearest.on_a[d] = vertex->place[d] - nearest.distance * nearest.normal[d];
    }
    if (is_hollow(vertex->inward, nearest.normal))
        return;
    feature_add(meeting->features, rock, rock->rounding, nearest.distance, nearest.on_a, nearest.normal,
                touch_key(TOUCH_CORNER_B, vertex->feature & 255, 0));
}

void rocks_wall_features(const struct rocks_scene *scene, const struct rocks_pair *pair,
                         const struct rocks_ends *ends, struct walls_probe *probe,
                         struct features *features) {
    const double *centre = scene->particles->state[pair->end[0]].x;
    struct meeting meeting = {scene, pair, &ends->posed[0], centre, probe, features};
    for (int k = 0; k < meeting.rock->core->corners; k++)
        corner_take(&meeting, k);
    walls_group_edges(scene->walls, &pair->group, centre, ends->ball + scene->reach, probe);
    for (size_t e = 0; e < probe->edges; e++)
        edge_take(&meeting, &probe->edge[e]);
    for (size_t v = 0; v < probe->vertices; v++)
        vertex_take(&meeting, &probe->vertex[v]);
    for (int k = 0; !walls_one_sided(scene->walls, pair->wall) && k < features->count; k++)
        features->feature[k].group = k;
}
