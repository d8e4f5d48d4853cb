/* SPDX-License-Identifier: BSD-3-Clause */
/* Size classes from the radii on all ranks. Read kernel/particles/classes.h first. */
#include "engine/classify.h"
#include "engine/skin_auto.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include "kernel/pairs/classes_choose.h"
#include <math.h>

/* A sample of the radii, for the choice of classes: the smallest and the largest radius of each of so many
 * logarithmic bins, and more radii by weight. */
enum { CLASS_BINS = 1024, CLASS_SAMPLE = 64 };

struct radius_bins {
    double least[CLASS_BINS], most[CLASS_BINS], count[CLASS_BINS];
};

static int radius_bin(double radius, double smallest, double largest) {
    if (!(largest > smallest))
        return 0;
    int bin = (int)(CLASS_BINS * log(radius / smallest) / log(largest / smallest));
    return bin < 0 ? 0 : bin >= CLASS_BINS ? CLASS_BINS - 1 : bin;
}

/* The kind of particle k; grains without a field of kinds. */
static int kind_at(const uint8_t *kind, size_t k) {
    return kind ? kind[k] : KIND_GRAIN;
}

static void radius_bins_fill(const struct particles *particles, const struct comm *comm, enum kind kind,
                             struct radius_bins *bins) {
    const uint8_t *kinds = kinds_of(particles);
    double bound[2] = {INFINITY, INFINITY}; /* smallest, minus largest */
    for (size_t k = 0; k < particles->owned; k++) {
        double radius = particles->state[k].radius;
        if (kind_at(kinds, k) != (int)kind)
            continue;
        bound[0] = fmin(bound[0], radius);
        bound[1] = fmin(bound[1], -radius);
    }
    comm_min(comm, bound, 2);
    for (int b = 0; b < CLASS_BINS; b++) {
        bins->least[b] = INFINITY;
        bins->most[b] = bins->count[b] = 0;
    }
    for (size_t k = 0; k < particles->owned; k++) {
        double radius = particles->state[k].radius;
        if (kind_at(kinds, k) != (int)kind)
            continue;
        int b = radius_bin(radius, bound[0], -bound[1]);
        bins->least[b] = fmin(bins->least[b], radius);
        bins->most[b] = fmax(bins->most[b], radius);
        bins->count[b]++;
    }
    comm_min(comm, bins->least, CLASS_BINS);
    comm_max(comm, bins->most, CLASS_BINS);
    comm_sum(comm, bins->count, CLASS_BINS);
}

static size_t radius_sample(const struct radius_bins *bins, double total, double *sample) {
    size_t n = 0;
    for (int b = 0; b < CLASS_BINS; b++) {
        if (bins->count[b] == 0)
            continue;
        sample[n++] = bins->least[b];
        sample[n++] = bins->most[b];
        for (double w = 1; w < bins->count[b] / total * CLASS_SAMPLE * CLASS_BINS && w < bins->count[b]; w++)
            sample[n++] = bins->most[b];
    }
    return n;
}

/* Input for the choice of classes: only functions of the radii and the box, so that a resume makes the same
 * choice. */
static struct classes_options classes_wanted(struct classes_options options, const struct box *box,
                                             const struct radius_bins *bins, enum kind kind, double total) {
    double solid = 0, space = 1;
    for (int b = 0; b < CLASS_BINS; b++) {
        double radius = bins->most[b];
        if (bins->count[b] > 0)
            solid += bins->count[b] * M_PI * radius * radius * (box->dimension == 3 ? 4 * radius / 3 : 1);
    }
    for (int d = 0; d < box->dimension; d++)
        space *= box->edge[d];
    if (kind != KIND_GRAIN)
        options.method = CLASSES_ONE;
    options.kind = (int)kind;
    options.fraction = solid / space;
    options.dimension = box->dimension;
    options.particles = total;
    return options;
}

/* Exact bounds and populations of the classes that were chosen from a sample. */
static void classes_count(struct size_classes *classes, const struct particles *particles,
                          const struct comm *comm) {
    const uint8_t *kind = kinds_of(particles);
    double least[CLASS_MAX], most[CLASS_MAX];
    int64_t population[CLASS_MAX] = {0};
    for (int c = 0; c < classes->count; c++) {
        least[c] = INFINITY;
        most[c] = 0;
    }
    for (size_t k = 0; k < particles->owned; k++) {
        double radius = particles->state[k].radius;
        int c = kind ? kinds_class(classes, (enum kind)kind[k], radius) : classes_of(classes, radius);
        least[c] = fmin(least[c], radius);
        most[c] = fmax(most[c], radius);
        population[c]++;
    }
    comm_min(comm, least, classes->count);
    comm_max(comm, most, classes->count);
    comm_sum_int(comm, population, classes->count);
    for (int c = 0; c < classes->count; c++) {
        classes->population[c] = (uint64_t)population[c];
        if (population[c] == 0)
            continue;
        classes->radius_min[c] = least[c];
        classes->radius_max[c] = most[c];
    }
}

/* Chooses the classes of one kind; without particles of the kind `classes` has none. */
static bool choose(struct simulation *s, enum kind kind, struct size_classes *classes, struct error *error) {
    struct radius_bins *bins = memory_allocate(1, sizeof *bins, "radius histogram");
    radius_bins_fill(s->particles, s->comm, kind, bins);
    double total = 0;
    for (int b = 0; b < CLASS_BINS; b++)
        total += bins->count[b];
    double *sample =
        memory_allocate((size_t)CLASS_BINS * (CLASS_SAMPLE + 4), sizeof *sample, "radius sample");
    size_t n = radius_sample(bins, total, sample);
    struct classes_options options = classes_wanted(s->scene->classes, &s->box, bins, kind, total);
    struct classes_range range = interactions_range(&s->search.interactions);
    bool good = classes_choose(classes, &options, &range, sample, n, error);
    if (n == 0 && kinds_of(s->particles))
        classes->count = 0;
    for (int c = 0; c < classes->count; c++)
        classes->kind[c] = (uint8_t)kind;
    memory_free(sample);
    memory_free(bins);
    return good;
}

/* Chooses the classes of all kinds, and joins them. */
static bool choose_kinds(struct simulation *s, struct error *error) {
    struct classes_range range = interactions_range(&s->search.interactions);
    s->classes = (struct size_classes){0};
    for (int place = 0; place < KINDS; place++) {
        struct size_classes own;
        enum kind kind = kinds_at(place);
        if (!choose(s, kind, &own, error) ||
            (own.count > 0 &&
             !kinds_join_classes(&s->classes, kind, &own, &s->scene->classes, &range, error)))
            return false;
    }
    return s->classes.count > 0 || choose(s, KIND_GRAIN, &s->classes, error);
}

bool classify_choose(struct simulation *s, struct error *error) {
    bool good = kinds_of(s->particles) ? choose_kinds(s, error) : choose(s, KIND_GRAIN, &s->classes, error);
    if (good) {
        struct classes_range range = interactions_range(&s->search.interactions);
        struct classes_options options = skin_auto_options(s->scene, &s->search.choice);
        classes_count(&s->classes, s->particles, s->comm);
        classes_set_margins(&s->classes, &options, &range);
    }
    s->classes_stale = false;
    return good;
}
