/* SPDX-License-Identifier: BSD-3-Clause */
/* Divides a cloud among ranks, makes copies, and states the copies that must exist. Read fixture.h first. */
#include "tests/test.h"

#include "fixture.h"

#include "kernel/comm/domain_tree.h"
#include "base/random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PERIODIC                                                                                             \
    {                                                                                                        \
        .dimension = 3, .edge = {10, 11, 12}, .periodic = { true, true, true }                               \
    }
#define OPEN                                                                                                 \
    {                                                                                                        \
        .dimension = 3, .edge = { 10, 11, 12 }                                                               \
    }
#define MIXED                                                                                                \
    {                                                                                                        \
        .dimension = 3, .edge = {10, 20, 12}, .periodic = { false, true, false }                             \
    }
#define FLAT                                                                                                 \
    {                                                                                                        \
        .dimension = 2, .edge = {10, 11, 1}, .periodic = { true, false, false }                              \
    }

const struct scene fixture_scenes[BRICKS] = {
    {PERIODIC, CLOUD_EQUAL, true, true, false},      {PERIODIC, CLOUD_BIDISPERSE, true, true, false},
    {PERIODIC, CLOUD_BIDISPERSE, true, false, true}, {PERIODIC, CLOUD_BIDISPERSE, false, false, false},
    {PERIODIC, CLOUD_CONTINUOUS, true, true, true},  {PERIODIC, CLOUD_CONTINUOUS, false, false, false},
    {PERIODIC, CLOUD_BOULDERS, true, true, false},   {PERIODIC, CLOUD_BOULDERS, true, true, true},
    {PERIODIC, CLOUD_BOULDERS, true, false, false},  {PERIODIC, CLOUD_BOULDERS, false, false, false},
    {OPEN, CLOUD_BIDISPERSE, true, true, false},     {OPEN, CLOUD_BOULDERS, true, true, false},
    {OPEN, CLOUD_BOULDERS, false, false, true},      {MIXED, CLOUD_BIDISPERSE, true, true, false},
    {MIXED, CLOUD_BOULDERS, true, true, true},       {MIXED, CLOUD_CONTINUOUS, false, false, false},
    {FLAT, CLOUD_BIDISPERSE, true, true, false},     {FLAT, CLOUD_BOULDERS, true, true, false},
    {FLAT, CLOUD_BOULDERS, false, false, false},     {PERIODIC, CLOUD_CONTINUOUS, true, true, false},
    {OPEN, CLOUD_CONTINUOUS, true, false, false},    {PERIODIC, CLOUD_CONTINUOUS, false, false, true},
    {FLAT, CLOUD_CONTINUOUS, true, true, false},
};

/* A third of the class pairs, and all of the last class. */
static void set_unwanted(struct size_classes *classes, int first) {
    for (int a = 0; a < classes->count; a++)
        for (int b = 0; b <= a; b++)
            if ((first + a + b) % 3 == 0 || a == classes->count - 1)
                classes->margin[a][b] = classes->margin[b][a] = INDEX_NOT_WANTED;
}

/* Cuts the cuboid of the ranks [first, last) somewhere. */
static void divide(int first, int last, int dimension, struct random_sequence *sequence, double (*lower)[3],
                   double (*upper)[3]) {
    if (last - first == 1)
        return;
    int middle = first + 1 + (int)(random_uniform(sequence) * (last - first - 1));
    int axis = (int)(random_uniform(sequence) * dimension);
    double part = 0.1 + 0.8 * random_uniform(sequence);
    double at = lower[first][axis] + part * (upper[first][axis] - lower[first][axis]);
    for (int k = first; k < last; k++)
        (k < middle ? upper : lower)[k][axis] = at;
    divide(first, middle, dimension, sequence, lower, upper);
    divide(middle, last, dimension, sequence, lower, upper);
}

/* The same uneven tree on all ranks. */
static struct domain_tree *uneven_tree(const struct box *box, int size, uint64_t seed) {
    double lower[64][3], upper[64][3];
    struct random_sequence sequence = random_sequence(seed, RANDOM_TEST, 0);
    assert_true(size <= 64);
    for (int k = 0; k < size; k++) {
        memset(lower[k], 0, sizeof lower[k]);
        memcpy(upper[k], box->edge, sizeof upper[k]);
    }
    divide(0, size, box->dimension, &sequence, lower, upper);
    return domain_tree_from_bounds(size, box->dimension, (const double(*)[3])lower,
                                   (const double(*)[3])upper);
}

void fixture_make(struct fixture *fixture, struct team *team, int number, size_t n) {
    const struct scene *scene = &fixture_scenes[number % BRICKS];
    fixture->team = team;
    fixture->scene = scene;
    cloud_make(&fixture->cloud, &scene->box, scene->radii, n, 5);
    if (number % BRICKS >= SCENE_UNWANTED)
        set_unwanted(&fixture->cloud.classes, number % BRICKS);
    int size = team->comm.size;
    struct domain_options options = {.grid = {scene->slabs ? size : 0, 0, 0},
                                     .kind = number < BRICKS ? DOMAIN_BRICK : DOMAIN_BISECTION};
    struct error error = {0};
    fixture->domain = domain_create(&team->comm, &scene->box, &options, &error);
    assert_non_null(fixture->domain);
    if (number >= BRICKS)
        domain_divide(fixture->domain, uneven_tree(&scene->box, size, (uint64_t)number));
    struct ghosts_options ghosts = {.newton = scene->newton, .reduced = scene->reduced};
    fixture->ghosts = ghosts_create(&team->comm, fixture->domain, &fixture->cloud.box, &ghosts);
    fixture->particles = particles_with(WITH_ALL | WITH_OTHERS, 0);
    for (size_t k = 0; k < fixture->cloud.n; k++)
        if (k % (size_t)size == (size_t)team->comm.rank)
            cloud_append(&fixture->cloud, k, FIXTURE_STAMP, fixture->particles);
}

void fixture_free(struct fixture *fixture) {
    ghosts_destroy(&fixture->ghosts);
    particles_destroy(&fixture->particles);
    domain_destroy(&fixture->domain);
    cloud_free(&fixture->cloud);
}

void fixture_rebuild(struct fixture *fixture) {
    struct particles *particles = fixture->particles;
    ghosts_drop(fixture->ghosts, particles);
    for (size_t i = 0; i < particles->owned; i++)
        memcpy(particles->state[i].x, fixture->cloud.x[particles->id[i] - 1], 3 * sizeof(double));
    ghosts_migrate(fixture->ghosts, particles, NULL);
    particles_classify(particles, &fixture->cloud.classes);
    ghosts_make(fixture->ghosts, particles, &fixture->cloud.classes);
}

bool fixture_wraps(const struct fixture *fixture, int d) {
    bool wrap[3];
    domain_wrap(fixture->domain, wrap);
    return wrap[d];
}

/* Images along d that copies may have. */
static int images(const struct fixture *fixture, int d) {
    return fixture->scene->box.periodic[d] && !fixture_wraps(fixture, d) ? 1 : 0;
}

static double distance_to(const struct fixture *fixture, int rank, size_t k, const int image[3]) {
    double lower[3], upper[3], squared = 0;
    domain_bounds(fixture->domain, rank, lower, upper);
    for (int d = 0; d < 3; d++) {
        double y = fixture->cloud.x[k][d] + image[d] * fixture->scene->box.edge[d];
        double gap = y < lower[d] ? lower[d] - y : y > upper[d] ? y - upper[d] : 0;
        squared += fixture_wraps(fixture, d) ? 0 : gap * gap;
    }
    return sqrt(squared);
}

/* Does the rank that owns a particle of class c compute its pair with a particle of class a? */
static bool computes(const struct scene *scene, int c, int a) {
    return !scene->newton || !scene->reduced || c <= a;
}

bool fixture_needs(const struct fixture *fixture, int rank, size_t k, const int image[3]) {
    const struct size_classes *classes = &fixture->cloud.classes;
    int a = classes_of(classes, fixture->cloud.radius[k]);
    double distance = distance_to(fixture, rank, k, image);
    bool self = domain_owner(fixture->domain, fixture->cloud.x[k]) == rank && image[0] == 0 &&
                image[1] == 0 && image[2] == 0;
    for (int c = 0; c < classes->count; c++)
        if (computes(fixture->scene, c, a) && !self && classes->margin[a][c] != INDEX_NOT_WANTED &&
            distance <= fixture->cloud.radius[k] + classes->radius_max[c] + classes->margin[a][c])
            return true;
    return false;
}

bool fixture_image(const struct fixture *fixture, int turn, int image[3]) {
    int vector[3] = {turn % 3 - 1, turn / 3 % 3 - 1, turn / 9 - 1};
    for (int d = 0; d < 3; d++) {
        image[d] = vector[d];
        if (abs(vector[d]) > images(fixture, d))
            return false;
    }
    return true;
}
