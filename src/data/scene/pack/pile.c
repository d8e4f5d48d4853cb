/* SPDX-License-Identifier: BSD-3-Clause */
/* Places and bounds of the spheres of a packing. Read pile.h first. */
#include "data/scene/pack/pile.h"

#include "base/random.h"

#include <math.h>
#include <string.h>

/* Places drawn for a sphere, and draws that may find none in the region (each tries 1000 places). */
enum { PLACES_MOST = 20000, MISSES_MOST = 20 };
/* Parts of a move that a sphere tries where a wall stands in its way. */
static const double steps[] = {1, 0.5, 0.125};

struct pile pile_create(const struct box *box, double smallest) {
    return (struct pile){
        .box = box, .particles = particles_create(0), .still = placegrid_create(box, smallest)};
}

void pile_free(struct pile *pile) {
    particles_destroy(&pile->particles);
    placegrid_destroy(&pile->still);
}

void pile_add(struct pile *pile, int64_t id, double radius) {
    size_t k = particles_append(pile->particles);
    pile->particles->id[k] = id;
    pile->particles->state[k].radius = radius;
    pile->particles->state[k].inverse_mass = 1;
}

void pile_add_still(struct pile *pile, const double x[3], double radius) {
    size_t k = particles_append(pile->particles);
    struct particle_state *state = &pile->particles->state[k];
    memcpy(state->x, x, sizeof state->x);
    state->radius = radius;
    state->inverse_mass = 0;
    pile->particles->id[k] = 0;
    placegrid_add(pile->still, x, radius);
}

static const struct pile_part *part_of(const struct pile *pile, size_t k) {
    int p = 0;
    while (p < pile->parts - 1 && pile->particles->id[k] >= pile->part[p].end)
        p++;
    return &pile->part[p];
}

/* True if walls leave the place to a sphere; x need not be wrapped. */
static bool is_clear(const struct pile *pile, const double x[3], double radius) {
    const struct scene_share *share = pile->share;
    double y[3];
    if (!share->taken)
        return true;
    for (int d = 0; d < 3; d++)
        y[d] = pile->box->periodic[d] ? x[d] - floor(x[d] / pile->box->edge[d]) * pile->box->edge[d] : x[d];
    return !share->taken(share->context, y, radius);
}

/* Box-relative and wrapped. */
static void take_place(const struct box *box, const double user[3], double x[3]) {
    for (int d = 0; d < 3; d++) {
        x[d] = user[d] - box->origin[d];
        if (box->periodic[d])
            x[d] -= floor(x[d] / box->edge[d]) * box->edge[d];
    }
}

static bool place_one(const struct pile *pile, size_t k) {
    const struct pile_part *part = part_of(pile, k);
    struct particle_state *state = &pile->particles->state[k];
    double room = state->radius * (1 + pile->gap), user[3];
    struct random_sequence random =
        random_sequence(pile->seed, RANDOM_POSITION, (uint64_t)pile->particles->id[k]);
    for (int n = 0, misses = 0; n < PLACES_MOST && misses < MISSES_MOST; n++) {
        if (!region_draw(&part->region, &part->space, room, &random, user)) {
            misses++;
            continue;
        }
        take_place(pile->box, user, state->x);
        if (is_clear(pile, state->x, room) && !placegrid_touches(pile->still, state->x, state->radius))
            return true;
    }
    return false;
}

double pile_place(const struct pile *pile) {
    double homeless = 0;
#pragma omp parallel for schedule(dynamic, 64) reduction(max : homeless)
    for (size_t k = 0; k < pile->particles->owned; k++)
        if (pile->particles->state[k].inverse_mass > 0 && !place_one(pile, k))
            homeless = fmax(homeless, pile->particles->state[k].radius);
    return homeless;
}

/* How far the image of x that is nearest to the middle of the region lies from x, along one direction. */
static double image_shift(const struct pile *pile, const struct pile_part *part, int d, double x) {
    double lower[3], upper[3];
    if (!pile->box->periodic[d] || part->space.wrap[d])
        return 0;
    region_bounds(&part->region, lower, upper);
    double middle = (lower[d] + upper[d]) / 2 - pile->box->origin[d];
    return pile->box->edge[d] * rint((middle - x) / pile->box->edge[d]);
}

/* Into the region. What the region leaves alone keeps its bits. */
static void hold_in_region(const struct pile *pile, const struct pile_part *part, const double from[3],
                           double room, double x[3]) {
    double shift[3], was[3], start[3], user[3];
    for (int d = 0; d < 3; d++) {
        shift[d] = pile->box->origin[d] + image_shift(pile, part, d, from[d]);
        start[d] = from[d] + shift[d];
        was[d] = user[d] = x[d] + shift[d];
    }
    region_hold(&part->region, &part->space, start, room, user);
    for (int d = 0; d < 3; d++)
        if (user[d] != was[d])
            x[d] = user[d] - shift[d];
}

void pile_hold(const struct pile *pile, size_t k, double x[3]) {
    const struct pile_part *part = part_of(pile, k);
    const struct particle_state *state = &pile->particles->state[k];
    double wanted[3] = {x[0], x[1], x[2]}, room = state->radius * (1 + pile->gap);
    for (size_t s = 0; s < sizeof steps / sizeof steps[0]; s++) {
        for (int d = 0; d < 3; d++)
            x[d] = s == 0 ? wanted[d] : state->x[d] + steps[s] * (wanted[d] - state->x[d]);
        hold_in_region(pile, part, state->x, room, x);
        if (is_clear(pile, x, state->radius * (1 + pile->gap / 2)))
            return;
    }
    memcpy(x, state->x, sizeof state->x);
}
