/* SPDX-License-Identifier: BSD-3-Clause */
/* Lattices as rectangular cells with a basis: places run through the cells with x fastest, basis innermost.
 */
#include "data/scene/source_makers.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

/* The largest number of places that a walk looks at, in about ten seconds, and that a lattice has. */
static const double WALK_MAX = 1e9, PLACES_MAX = 1e15;

struct lattice {
    double cell[3]; /* edges, in spacings */
    int points;
    double basis[4][3]; /* in cell edges */
};

static const struct lattice lattices[] = {
    [SOURCE_SC] = {{1, 1, 1}, 1, {{0, 0, 0}}},
    [SOURCE_FCC] = {{M_SQRT2, M_SQRT2, M_SQRT2}, 4, {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}},
    [SOURCE_HCP] = {{1, 1.7320508075688772, 1.6329931618554521},
                    4,
                    {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 5.0 / 6, 0.5}, {0, 1.0 / 3, 0.5}}},
    [SOURCE_SQUARE] = {{1, 1, 0}, 1, {{0, 0, 0}}},
    [SOURCE_HEXAGONAL] = {{1, 1.7320508075688772, 0}, 2, {{0, 0, 0}, {0.5, 0.5, 0}}},
};

/* Data of a walk over the places. */
struct walk {
    const struct scene *scene;
    const struct source_options *source;
    const struct lattice *lattice;
    struct region region;
    struct region_space space;
    double start[3], cell[3];
    double margin; /* largest radius and jitter */
    double jitter; /* length */
    int64_t cells[3];
};

static void prepare_walk(struct walk *walk, const struct scene *scene, const struct source_options *source) {
    double smallest, largest, lower[3], upper[3];
    sizes_bounds(&source->sizes, &smallest, &largest);
    walk->scene = scene;
    walk->source = source;
    walk->lattice = &lattices[source->lattice];
    walk->region = source_region(scene, &source->region, &walk->space);
    walk->jitter = source->jitter * fmax(0, source->spacing / 2 - largest) / sqrt(scene->box.dimension);
    walk->margin = (largest + walk->jitter) * (1 - 1e-9);
    region_bounds(&walk->region, lower, upper);
    for (int d = 0; d < 3; d++) {
        walk->cell[d] = walk->lattice->cell[d] * source->spacing;
        walk->start[d] =
            walk->space.wrap[d] ? lower[d] + walk->cell[d] / 12 : lower[d] + largest + walk->jitter;
        double room = upper[d] - lower[d];
        double cells = 1;
        if (walk->cell[d] != 0 && walk->space.wrap[d])
            cells = floor(room / walk->cell[d] * (1 + 1e-9)); /* whole cells, so that the seam fits */
        else if (walk->cell[d] != 0)
            cells = floor(room / walk->cell[d]) + 1;
        walk->cells[d] = (int64_t)fmin(cells, PLACES_MAX); /* more are refused */
    }
}

/* Place number `n` of the walk; false if it lies outside of the region. */
static bool place(const struct walk *walk, int64_t n, double x[3]) {
    const double *basis = walk->lattice->basis[n % walk->lattice->points];
    int64_t cell = n / walk->lattice->points;
    for (int d = 0; d < 3; d++) {
        x[d] = walk->start[d] + ((double)(cell % walk->cells[d]) + basis[d]) * walk->cell[d];
        cell /= walk->cells[d];
    }
    if (walk->space.dimension == 2)
        x[2] = walk->space.plane;
    return region_contains(&walk->region, &walk->space, x, walk->margin);
}

static int64_t count_places(const struct walk *walk, int64_t places, int64_t wanted) {
    double x[3];
    int64_t found = 0;
    for (int64_t n = 0; n < places && (wanted == 0 || found < wanted); n++)
        found += place(walk, n, x);
    return found;
}

/* Approximate number of places in the region: all places, less the part of the bounding box outside it. */
static double expected_spheres(const struct walk *walk, double places) {
    double lower[3], upper[3], bounds = 1;
    region_bounds(&walk->region, lower, upper);
    for (int d = 0; d < walk->space.dimension; d++)
        bounds *= upper[d] - lower[d];
    return places * fmin(1, region_volume(&walk->region, &walk->space) / bounds);
}

bool lattice_make(const struct scene *scene, int source, struct source_batch *batch, struct error *error) {
    const struct source_options *options = &scene->source[source];
    struct walk walk;
    char key[96];
    prepare_walk(&walk, scene, options);
    double places_real =
        (double)walk.cells[0] * (double)walk.cells[1] * (double)walk.cells[2] * walk.lattice->points;
    double expected = expected_spheres(&walk, places_real), wanted = (double)options->count;
    bool by_count = wanted > 0 && wanted < expected;
    source_key(source, by_count ? "count" : "spacing", key, sizeof(key));
    if ((by_count ? wanted : expected) > SOURCE_SPHERES_MAX)
        return scene_fail(scene, error, key, "gives about %.2g spheres; at most %d are possible",
                          by_count ? wanted : expected, SOURCE_SPHERES_MAX);
    if (places_real > PLACES_MAX || (by_count ? places_real * wanted / expected : places_real) > WALK_MAX)
        return scene_fail(scene, error, source_key(source, "spacing", key, sizeof(key)),
                          "gives %.2g places in the bounds of the region, too many to look at", places_real);
    int64_t places = (int64_t)places_real, found = count_places(&walk, places, options->count);
    if (found == 0 || found < options->count)
        return scene_fail(scene, error,
                          source_key(source, options->count ? "count" : "spacing", key, sizeof(key)),
                          "the lattice has %lld places in the region, too few", (long long)found);
    struct sizes_sampler sampler;
    if (!sizes_prepare(&sampler, &options->sizes, error))
        return false;
    if (!source_room((double)found, 4 * sizeof(double), error))
        return false;
    rows_create(&batch->rows, (size_t)found, ROWS_POSITION | ROWS_RADIUS);
    size_t filled = 0;
    for (int64_t n = 0; n < places && filled < (size_t)found; n++) {
        double *x = batch->rows.position[filled];
        if (!place(&walk, n, x))
            continue;
        uint64_t item = (uint64_t)(source + 1) << 40 | filled;
        struct random_sequence position = random_sequence(scene->seed, RANDOM_POSITION, item);
        struct random_sequence radius = random_sequence(scene->seed, RANDOM_RADIUS, item);
        for (int d = 0; d < scene->box.dimension; d++)
            x[d] += walk.jitter * (2 * random_uniform(&position) - 1);
        batch->rows.radius[filled++] = sizes_draw(&sampler, &radius);
    }
    return true;
}
