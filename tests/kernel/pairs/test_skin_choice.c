/* SPDX-License-Identifier: BSD-3-Clause */
/* The model that chooses a skin. */
#include "tests/test.h"

#include "kernel/pairs/skin_choice.h"
#include <math.h>
#include <stdlib.h>

enum { COUNT = 400 };

/* One class of spheres of radius 1 with a skin of 0.3. */
static struct size_classes one_class(double skin) {
    struct size_classes classes = {.count = 1, .radius_min = {1}, .radius_max = {1}, .population = {COUNT}};
    classes.skin[0][0] = classes.margin[0][0] = skin;
    return classes;
}

/* Pairs nearer than `reach` of points at random places in a periodic cube. */
static double pairs_nearer(double (*x)[3], double edge, double reach) {
    double found = 0;
    for (int i = 0; i < COUNT; i++)
        for (int j = 0; j < i; j++) {
            double square = 0;
            for (int d = 0; d < 3; d++)
                square += pow(remainder(x[i][d] - x[j][d], edge), 2);
            found += square < reach * reach;
        }
    return found;
}

/* The predicted number of pairs against a count, in a gas of points. */
static void test_pairs_follow_the_shells(void **state) {
    (void)state;
    double x[COUNT][3], edge = 20;
    srand(1);
    for (int i = 0; i < COUNT; i++)
        for (int d = 0; d < 3; d++)
            x[i][d] = edge * rand() / ((double)RAND_MAX + 1);
    struct size_classes classes = one_class(0.6);
    struct skin_counts counts = {.particles = COUNT, .dimension = 3};
    counts.pairs = pairs_nearer(x, edge, 2.6);
    counts.contacts = pairs_nearer(x, edge, 2);
    for (int64_t k = 0; k <= 8; k += 4) { /* skins 0.6, 1.2, 2.4, of which the last has 7 times the pairs */
        double counted = pairs_nearer(x, edge, 2 + 0.6 * skin_choice_factor(k));
        assert_true(fabs(skin_choice_pairs(&classes, &counts, 0, k) / counted - 1) < 0.1);
    }
}

/* The least cost over all factors, by leaps from an end, is found, and is that of a search with fine steps. */
static void test_the_best_is_the_minimum(void **state) {
    (void)state;
    for (double rate = 1e-4; rate < 1; rate *= 10) {
        struct size_classes classes = one_class(0.3);
        struct skin_counts counts = {COUNT, 6 * COUNT, 2 * COUNT, rate, 0, 3};
        int64_t now = SKIN_LEAST;
        double least = INFINITY;
        for (int k = 0; k < 12; k++) {
            int64_t next = skin_choice_best(&classes, &counts, now, SKIN_MOST);
            assert_true(llabs(next - now) <= SKIN_LEAP);
            counts.pairs = skin_choice_pairs(&classes, &counts, now, next);
            classes = one_class(0.3 * skin_choice_factor(next) / skin_choice_factor(SKIN_LEAST));
            now = next;
        }
        double found = skin_choice_cost(&classes, &counts, now, now);
        for (int64_t k = SKIN_LEAST; k <= SKIN_MOST; k++)
            if (skin_choice_pairs(&classes, &counts, now, k) <= SKIN_PAIRS_MOST * COUNT)
                least = fmin(least, skin_choice_cost(&classes, &counts, now, k));
        assert_true(found <= least / 0.98 + 1e-9);
    }
}

static void test_fast_particles_want_a_long_skin(void **state) {
    (void)state;
    struct size_classes classes = one_class(0.3);
    struct skin_counts counts = {COUNT, 2 * COUNT, 0, 0.3, 0, 3};
    assert_true(skin_choice_best(&classes, &counts, 0, SKIN_MOST) > 0);
    counts.rate = 1e-6;
    assert_true(skin_choice_best(&classes, &counts, 0, SKIN_MOST) < 0);
    counts.rate = 0.3;
    assert_true(skin_choice_best(&classes, &counts, 0, 1) <= 1); /* the box has no more room */
    assert_true(skin_choice_best(&classes, &counts, 0, -2) <= -2);
    counts.every = 2; /* a rebuild comes anyway before the skin is used up */
    assert_true(skin_choice_best(&classes, &counts, 0, SKIN_MOST) < 0);
    counts.every = 0;
    counts.pairs = 23 * COUNT; /* no room for more pairs */
    assert_true(skin_choice_best(&classes, &counts, 0, SKIN_MOST) <= 0);
}

static void test_intervals_fade(void **state) {
    (void)state;
    struct skin_choice choice = {0};
    skin_choice_add(&choice, 1, 10);
    assert_true(choice.used == 1 && choice.steps == 10);
    for (int k = 0; k < 20; k++)
        skin_choice_add(&choice, 1, 40);
    assert_true(fabs(choice.used / choice.steps - 1.0 / 40) < 1e-3);
    skin_choice_add(&choice, 0.5, 1); /* a short interval counts little */
    assert_true(choice.used / choice.steps < 1.0 / 30);
}

TEST_MAIN(skin_choice, cmocka_unit_test(test_pairs_follow_the_shells),
          cmocka_unit_test(test_the_best_is_the_minimum),
          cmocka_unit_test(test_fast_particles_want_a_long_skin), cmocka_unit_test(test_intervals_fade))
