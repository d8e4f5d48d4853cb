/* SPDX-License-Identifier: BSD-3-Clause */
/* Computes the number of due particles and proposed places, and accepts the particles that find a place. Read
 * insertion.h first. */
#include "data/scene/insertion.h"
#include "kernel/particles/particles.h"

#include <math.h>
#include <string.h>

/* Mass over volume of a particle of this radius. */
static double density_of(const struct insertion *insertion, double radius) {
    return particles_density(&insertion->box, radius, insertion->density);
}

void insertion_weigh(struct insertion *insertion, insertion_mass *mass, const void *context) {
    enum { SAMPLE = 65536 };
    struct insertion_candidate candidate = {.material = insertion->options.material,
                                            .shape = insertion->options.form.shape};
    double sum = 0;
    for (int64_t k = 0; k < SAMPLE; k++) {
        struct random_sequence random = random_sequence(insertion->seed, RANDOM_RADIUS, (uint64_t)k);
        candidate.radius = sizes_draw(&insertion->sampler, &random);
        candidate.density = density_of(insertion, candidate.radius);
        sum += mass(context, &candidate, k);
    }
    insertion->mean_mass = sum / SAMPLE;
}

bool insertion_prepare(struct insertion *insertion, const struct insertion_options *options, int number,
                       double density, uint64_t seed, const struct box *box, struct error *error) {
    *insertion = (struct insertion){.options = *options, .number = number, .box = *box, .seed = seed};
    insertion->density = options->density > 0 ? options->density : density;
    struct region *region = &insertion->options.region;
    if (region->shape == REGION_ALL) {
        region->shape = REGION_BOX;
        for (int d = 0; d < 3; d++) {
            region->lower[d] = box->origin[d];
            region->upper[d] = box->origin[d] + box->edge[d];
        }
    }
    insertion->space =
        (struct region_space){.dimension = box->dimension, .plane = box->origin[2] + box->edge[2] / 2};
    for (int d = 0; d < 3; d++)
        insertion->space.wrap[d] = box->periodic[d] && region->shape == REGION_BOX &&
                                   region->lower[d] <= box->origin[d] &&
                                   region->upper[d] >= box->origin[d] + box->edge[d];
    return sizes_prepare(&insertion->sampler, &options->sizes, error);
}

uint64_t insertion_due(const struct insertion *insertion, double time) {
    const struct insertion_options *o = &insertion->options;
    double until = time < o->stop ? time : o->stop;
    if (!(until > o->start))
        return 0;
    double rate = o->rate > 0 ? o->rate : o->mass_rate / insertion->mean_mass;
    double due = floor(rate * (until - o->start) * (1 + 1e-12));
    if (o->count > 0 && due > (double)o->count)
        due = (double)o->count;
    return due < 1e18 ? (uint64_t)due : (uint64_t)1e18;
}

/* The sequence of a particle of this region: its size and velocity, or its place in one round. */
static struct random_sequence sequence_of(const struct insertion *insertion, uint64_t number,
                                          uint32_t round) {
    uint64_t item = (uint64_t)(insertion->number + 1) << 48 | (number & 0xffffffffffff);
    struct random_sequence random = random_sequence(insertion->seed, RANDOM_INSERTION, item);
    random.draw = round;
    return random;
}

void insertion_begin(const struct insertion *insertion, const struct insertion_state *state,
                     struct insertion_candidate *candidate, size_t n) {
    const struct insertion_options *o = &insertion->options;
    for (size_t k = 0; k < n; k++) {
        uint64_t number = state->placed + k;
        struct random_sequence random = sequence_of(insertion, number, 0);
        candidate[k] = (struct insertion_candidate){.number = number,
                                                    .temperature = o->temperature,
                                                    .material = o->material,
                                                    .group = o->group,
                                                    .shape = o->form.shape};
        candidate[k].radius = sizes_draw(&insertion->sampler, &random);
        candidate[k].density = density_of(insertion, candidate[k].radius);
        for (int d = 0; d < 3; d++) {
            bool flat = d == 2 && insertion->space.dimension == 2;
            candidate[k].v[d] =
                o->velocity[d] +
                (o->velocity_sigma > 0 && !flat ? o->velocity_sigma * random_normal(&random) : 0);
            candidate[k].omega[d] = o->omega[d];
        }
    }
}

bool insertion_reaches(const struct insertion *insertion, double largest, const double x[3], double radius) {
    const struct box *box = &insertion->box;
    double lower[3], upper[3], reach = largest + radius;
    region_bounds(&insertion->options.region, lower, upper);
    for (int d = 0; d < box->dimension; d++) {
        double edge = box->edge[d], above = x[d] + box->origin[d] - lower[d], length = upper[d] - lower[d];
        if (box->periodic[d])
            above -= floor(above / edge) * edge;
        double beyond = above - length, below = box->periodic[d] ? edge - above : -above;
        double gap = box->periodic[d] ? fmin(beyond, below) : fmax(beyond, below); /* below 0 inside */
        if (gap > reach + 1e-9 * (edge + length))
            return false;
    }
    return true;
}

/* Box-relative, wrapped in periodic directions. */
static void enter_box(const struct insertion *insertion, double x[3]) {
    const struct box *box = &insertion->box;
    for (int d = 0; d < 3; d++) {
        x[d] -= box->origin[d];
        if (box->periodic[d])
            x[d] -= floor(x[d] / box->edge[d]) * box->edge[d];
        if (box->periodic[d] && x[d] >= box->edge[d])
            x[d] = 0;
    }
}

void insertion_propose(const struct insertion *insertion, struct insertion_state *state,
                       struct insertion_candidate *candidate, uint8_t *blocked, size_t n) {
    /* each round has draws of its own, far from those of sizes and velocities */
    uint32_t round = (uint32_t)(1 + state->tried % 4000000) << 10;
    memset(blocked, 0, n);
    for (size_t k = 0; k < n; k++) {
        if (candidate[k].settled)
            continue;
        struct random_sequence random = sequence_of(insertion, candidate[k].number, round);
        blocked[k] = !region_draw(&insertion->options.region, &insertion->space, candidate[k].radius, &random,
                                  candidate[k].x);
        enter_box(insertion, candidate[k].x);
    }
    state->tried++;
}

static bool candidates_touch(const struct box *box, const struct insertion_candidate *a,
                             const struct insertion_candidate *b) {
    double reach = a->radius + b->radius;
    return box_distance2(box, a->x, b->x) < reach * reach;
}

size_t insertion_settle(const struct insertion *insertion, struct insertion_candidate *candidate,
                        const uint8_t *blocked, size_t n) {
    size_t unsettled = 0;
    for (size_t k = 0; k < n; k++) {
        if (candidate[k].settled)
            continue;
        bool free = !blocked[k];
        for (size_t other = 0; other < n && free; other++)
            free = !candidate[other].accepted ||
                   !candidates_touch(&insertion->box, &candidate[k], &candidate[other]);
        candidate[k].settled = candidate[k].accepted = free;
        unsettled += !free;
    }
    return unsettled;
}

size_t insertion_end(struct insertion_state *state, struct insertion_candidate *candidate, size_t n) {
    size_t placed = 0;
    while (placed < n && candidate[placed].accepted)
        placed++;
    for (size_t k = placed; k < n; k++)
        candidate[k].accepted = false;
    state->placed += placed;
    return placed;
}

bool deletion_due(const struct deletion_options *options, double time, int64_t step) {
    return time >= options->start && time < options->stop && step % options->every == 0;
}
