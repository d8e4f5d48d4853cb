/* SPDX-License-Identifier: BSD-3-Clause */
/* Insertion: what is due, where, and what finds no room; deletion. */
#include "tests/test.h"

#include "data/scene/insertion.h"
#include "kernel/particles/particles.h"

#include <math.h>
#include <string.h>

enum { BATCH = 14 };

static const struct box box = {
    .dimension = 3, .origin = {1, 1, 1}, .edge = {4, 4, 4}, .periodic = {true, false, false}};

static struct insertion_options feed(void) {
    return (struct insertion_options){.name = "feed",
                                      .region = {.shape = REGION_BOX, .lower = {1, 2, 3}, .upper = {5, 4, 5}},
                                      .sizes = {.law = SIZES_UNIFORM, .min = 0.1, .max = 0.3},
                                      .rate = 10,
                                      .start = 2,
                                      .stop = 5,
                                      .attempts = 20,
                                      .velocity = {0, 0, -1},
                                      .velocity_sigma = 0.1,
                                      .material = 1};
}

static struct insertion prepared(const struct insertion_options *options) {
    struct insertion insertion;
    struct error error = {0};
    if (!insertion_prepare(&insertion, options, 0, 3, 42, &box, &error))
        fail_msg("%s", error.text);
    return insertion;
}

/* A sphere's mass. */
static double mass(const void *context, const struct insertion_candidate *candidate, int64_t id) {
    (void)context, (void)id;
    return particles_sphere_mass(candidate->radius, candidate->density);
}

static void due(void **state) {
    (void)state;
    struct insertion_options options = feed();
    struct insertion insertion = prepared(&options);
    assert_int_equal(insertion_due(&insertion, 1), 0);
    assert_int_equal(insertion_due(&insertion, 2), 0);
    assert_int_equal(insertion_due(&insertion, 2.05), 0);
    assert_int_equal(insertion_due(&insertion, 2.1), 1);
    assert_int_equal(insertion_due(&insertion, 3.55), 15);
    assert_int_equal(insertion_due(&insertion, 99), 30);
    options.count = 7;
    insertion = prepared(&options);
    assert_int_equal(insertion_due(&insertion, 99), 7);
    options = feed();
    options.rate = 0;
    options.mass_rate = 2;
    options.density = 5;
    insertion = prepared(&options);
    insertion_weigh(&insertion, mass, NULL);
    double mean_cube = (pow(0.3, 4) - pow(0.1, 4)) / 4 / 0.2;
    assert_true(fabs(insertion.mean_mass / (4 * M_PI / 3 * mean_cube * 5) - 1) < 0.01);
    assert_int_equal(insertion_due(&insertion, 4), (uint64_t)floor(4 / insertion.mean_mass));
}

/* One call as the head of insertion.h tells it; `blocked_number` never finds a place, -1: all do. */
static size_t insert(const struct insertion *insertion, struct insertion_state *state,
                     struct insertion_candidate *candidate, size_t n, int64_t blocked_number) {
    uint8_t blocked[BATCH];
    insertion_begin(insertion, state, candidate, n);
    size_t left = n;
    for (int64_t round = 0; round < insertion->options.attempts && left > 0; round++) {
        insertion_propose(insertion, state, candidate, blocked, n);
        for (size_t k = 0; k < n; k++)
            blocked[k] = blocked[k] || (int64_t)candidate[k].number == blocked_number;
        left = insertion_settle(insertion, candidate, blocked, n);
    }
    return insertion_end(state, candidate, n);
}

static void places_apart(void **state) {
    (void)state;
    struct insertion_options options = feed();
    struct insertion insertion = prepared(&options);
    struct insertion_state progress = {0};
    struct insertion_candidate candidate[BATCH];
    assert_int_equal(insert(&insertion, &progress, candidate, BATCH, -1), BATCH);
    for (int a = 0; a < BATCH; a++) {
        const struct insertion_candidate *c = &candidate[a];
        assert_true(c->accepted && c->material == 1 && c->density == 3);
        assert_int_equal(c->number, a);
        assert_true(c->x[0] >= 0 && c->x[0] < 4);
        assert_true(c->x[1] >= 1 + c->radius && c->x[1] <= 3 - c->radius);
        assert_true(c->x[2] >= 2 + c->radius && c->x[2] <= 4 - c->radius);
        assert_true(fabs(c->v[2] + 1) < 0.6 && fabs(c->v[0]) < 0.6);
        for (int b = 0; b < a; b++) {
            double sum = 0;
            for (int d = 0; d < 3; d++) {
                double gap = fabs(c->x[d] - candidate[b].x[d]);
                gap = d == 0 ? fmin(gap, 4 - gap) : gap;
                sum += gap * gap;
            }
            assert_true(sqrt(sum) >= c->radius + candidate[b].radius);
        }
    }
    assert_int_equal(progress.placed, BATCH);
}

/* The same particles whether they come in one batch or in several: sizes and velocities depend on their
 * numbers alone. */
static void batches_agree(void **state) {
    (void)state;
    struct insertion_options options = feed();
    struct insertion insertion = prepared(&options);
    struct insertion_candidate together[BATCH], alone[BATCH];
    struct insertion_state first = {0}, second = {0};
    insert(&insertion, &first, together, BATCH, -1);
    for (int k = 0; k < BATCH; k++) {
        assert_int_equal(insert(&insertion, &second, alone, 1, -1), 1);
        assert_int_equal(alone[0].number, k);
        assert_true(alone[0].radius == together[k].radius);
        assert_memory_equal(alone[0].v, together[k].v, sizeof(alone[0].v));
    }
}

/* Who finds no room holds up those behind, and comes again: the size law keeps its shares. */
static void queue_keeps_order(void **state) {
    (void)state;
    struct insertion_options options = feed();
    struct insertion insertion = prepared(&options);
    struct insertion_candidate candidate[BATCH];
    struct insertion_state progress = {0};
    assert_int_equal(insert(&insertion, &progress, candidate, 10, 6), 6);
    assert_int_equal(progress.placed, 6);
    for (int k = 0; k < 10; k++)
        assert_int_equal(candidate[k].accepted, k < 6);
    double radius = candidate[6].radius, x = candidate[6].x[1];
    assert_int_equal(insert(&insertion, &progress, candidate, 4, -1), 4);
    assert_int_equal(candidate[0].number, 6);
    assert_true(candidate[0].radius == radius);
    assert_true(candidate[0].x[1] != x); /* another place than before */
}

static void no_room(void **state) {
    (void)state;
    struct insertion_options options = feed();
    options.sizes = (struct sizes_options){.law = SIZES_FIXED, .radius = 1.2};
    struct insertion insertion = prepared(&options);
    struct insertion_candidate candidate[2];
    struct insertion_state progress = {0};
    assert_int_equal(insert(&insertion, &progress, candidate, 2, -1), 0);
    assert_int_equal(progress.placed, 0);
    assert_int_equal(progress.tried, 20);
}

static void seeds_differ(void **state) {
    (void)state;
    struct insertion_options options = feed();
    struct insertion a = prepared(&options), b = prepared(&options), c;
    struct error error = {0};
    b.seed = 43;
    assert_true(insertion_prepare(&c, &options, 1, 3, 42, &box, &error));
    struct insertion_state s = {0}, t = {0}, u = {0};
    struct insertion_candidate p[1], q[1], r[1];
    insert(&a, &s, p, 1, -1);
    insert(&b, &t, q, 1, -1);
    insert(&c, &u, r, 1, -1);
    assert_true(p[0].radius != q[0].radius && p[0].x[0] != q[0].x[0]);
    assert_true(p[0].radius != r[0].radius && p[0].x[0] != r[0].x[0]);
}

/* No place of the region is touched from where insertion_reaches says that none can be; and it says so of
 * most of the box. The region lies across a periodic side. */
static void reaches(void **state) {
    (void)state;
    struct insertion_options options = feed();
    options.region = (struct region){
        .shape = REGION_CYLINDER, .centre = {5, 3, 3}, .axis = {0, 0, 1}, .radius = 0.5, .length = 1};
    options.sizes = (struct sizes_options){.law = SIZES_FIXED, .radius = 0.1};
    struct insertion insertion = prepared(&options);
    struct insertion_state progress = {0};
    struct insertion_candidate candidate[BATCH];
    uint8_t blocked[BATCH];
    insertion_begin(&insertion, &progress, candidate, BATCH);
    int touching = 0, reached = 0;
    for (uint64_t trial = 0; trial < 20000; trial++) {
        struct random_sequence random = random_sequence(7, RANDOM_TEST, trial);
        double x[3] = {4 * random_uniform(&random), 4 * random_uniform(&random), 4 * random_uniform(&random)};
        double radius = 0.3 * random_uniform(&random);
        bool near = insertion_reaches(&insertion, 0.1, x, radius);
        reached += near;
        insertion_propose(&insertion, &progress, candidate, blocked, BATCH);
        for (int k = 0; k < BATCH; k++) {
            double apart[3] = {fabs(x[0] - candidate[k].x[0]), x[1] - candidate[k].x[1],
                               x[2] - candidate[k].x[2]};
            apart[0] = fmin(apart[0], 4 - apart[0]);
            bool touches =
                sqrt(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]) < radius + 0.1;
            touching += touches;
            assert_true(near || !touches);
        }
    }
    assert_true(touching > 100);
    assert_true(reached < 4000);
}

static void deletions(void **state) {
    (void)state;
    struct deletion_options options = {.start = 1, .stop = 2, .every = 10};
    assert_true(deletion_due(&options, 1, 20));
    assert_false(deletion_due(&options, 1.5, 21));
    assert_false(deletion_due(&options, 0.5, 20));
    assert_false(deletion_due(&options, 2, 20));
}

TEST_MAIN(insertion, cmocka_unit_test(due), cmocka_unit_test(places_apart), cmocka_unit_test(batches_agree),
          cmocka_unit_test(queue_keeps_order), cmocka_unit_test(no_room), cmocka_unit_test(seeds_differ),
          cmocka_unit_test(reaches), cmocka_unit_test(deletions))
