/* SPDX-License-Identifier: BSD-3-Clause */
/* Size classes, and kinds of particles. */
#include "tests/test.h"

#include "index/choose/auto_choose.h"
#include "kernel/particles/kinds.h"
#include "tests/particles_by_hand.h"
#include "kernel/pairs/classes_choose.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A range that is the same for all. */
static double range_same(const void *context, int kind_a, double a, int kind_b, double b) {
    (void)kind_a, (void)a, (void)kind_b, (void)b;
    return *(const double *)context;
}

static const struct classes_range half = {.of = range_same, .context = &(const double){0.5}};
static const struct classes_range quarter = {.of = range_same, .context = &(const double){0.25}};

static void test_classes_by_ratio_and_by_cuts(void **state) {
    (void)state;
    struct size_classes classes;
    struct classes_options options = classes_options_default();
    struct error error = {0};
    double two[200];
    for (int k = 0; k < 200; k++)
        two[k] = k % 100 == 0 ? 10 : 1;
    assert_true(classes_choose(&classes, &options, NULL, two, 200, &error));
    assert_int_equal(classes.count, 2);
    assert_int_equal(classes_of(&classes, 1), 0);
    assert_int_equal(classes_of(&classes, 10), 1);
    assert_int_equal(classes_of(&classes, 1e9), 1);
    assert_true(classes.skin[0][1] == 0.3 && classes.skin[1][1] == 3 && classes.skin[0][2] == 0.3);
    double many[] = {1, 1.5, 2.5, 3, 5, 9};
    options = (struct classes_options){
        .method = CLASSES_CUTS, .cut_count = 2, .cut = {2, 4}, .skin_given = true, .skin = 0.25};
    assert_true(classes_choose(&classes, &options, &half, many, 6, &error));
    assert_int_equal(classes.count, 3);
    assert_int_equal(classes.population[1], 2);
    assert_true(classes.radius_max[0] == 1.5 && classes.radius_min[2] == 5);
    assert_true(classes.margin[0][2] == 0.75);
    options.cut[1] = 2;
    assert_false(classes_choose(&classes, &options, NULL, many, 6, &error));
    assert_int_equal(error.kind, ERROR_USER);
    assert_non_null(strstr(error.text, "classes.cuts"));
}

static void test_classes_by_quantiles(void **state) {
    (void)state;
    struct size_classes classes;
    struct classes_options options = {.method = CLASSES_QUANTILES, .count = 3, .skin_relative = 0.1};
    struct error error = {0};
    double even[] = {12, 1, 11, 2, 10, 3, 9, 4, 8, 5, 7, 6};
    assert_true(classes_choose(&classes, &options, NULL, even, 12, &error));
    assert_int_equal(classes.count, 3);
    for (int c = 0; c < 3; c++) {
        assert_int_equal(classes.population[c], 4);
        assert_true(classes.radius_min[c] == 4 * c + 1 && classes.radius_max[c] == 4 * c + 4);
    }
    assert_int_equal(classes_of(&classes, 4), 0);
    assert_int_equal(classes_of(&classes, 4.5), 1);
    assert_int_equal(classes_of(&classes, 99), 2);
    /* as many equal radii as two of the classes hold, the smallest or the largest: no class is empty */
    double small[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 3, 2}, large[] = {3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 1, 2};
    assert_true(classes_choose(&classes, &options, NULL, small, 12, &error));
    assert_int_equal(classes.count, 2);
    assert_true(classes.population[0] == 10 && classes.population[1] == 2);
    assert_true(classes_choose(&classes, &options, NULL, large, 12, &error));
    assert_int_equal(classes.count, 1);
    assert_true(classes.population[0] == 12 && classes.radius_min[0] == 1 && classes.radius_max[0] == 3);
}

/* Grains and fluid of like radii: classes of their own, and one range each after an order by class. */
static void test_kinds_lie_together(void **state) {
    (void)state;
    enum { N = 300 };
    struct classes_options two = {
        .method = CLASSES_CUTS, .cut_count = 1, .cut = {0.5}, .skin_given = true, .skin = 0.01};
    struct classes_options one = {.method = CLASSES_ONE, .skin_given = true, .skin = 0.01};
    struct size_classes all = {0}, of_kind;
    struct error error = {0};
    struct particles *p = sample(WITH_SPIN, N);
    double radii[2][N];
    size_t count[2] = {0};
    assert_null(kinds_of(p));
    kinds_register(p);
    for (size_t k = 0; k < N; k++) {
        int fluid = k % 3 == 0;
        kinds_of(p)[k] = fluid ? KIND_FLUID : KIND_GRAIN;
        radii[fluid][count[fluid]++] = p->state[k].radius;
    }
    assert_true(classes_choose(&of_kind, &one, NULL, radii[1], count[1], &error));
    assert_true(kinds_join_classes(&all, KIND_FLUID, &of_kind, &one, &quarter, &error));
    assert_true(classes_choose(&of_kind, &two, NULL, radii[0], count[0], &error));
    assert_true(kinds_join_classes(&all, KIND_GRAIN, &of_kind, &two, &quarter, &error));
    assert_int_equal(all.count, 3);
    assert_true(all.kind[0] == KIND_FLUID && all.kind[1] == KIND_GRAIN && all.kind[2] == KIND_GRAIN);
    assert_true(all.margin[0][2] == 0.26 && all.population[0] == count[1]);
    assert_true(all.margin[0][0] == 0.25 && all.margin[1][1] == 0.26); /* fluid rests */
    particles_classify(p, &all);
    uint32_t order[N];
    for (uint32_t k = 0; k < N; k++)
        order[k] = N - 1 - k;
    kinds_sort(p, &all, order);
    particles_reorder(p, order);
    struct kind_span grains = kinds_span(p, &all, KIND_GRAIN), fluid = kinds_span(p, &all, KIND_FLUID);
    struct kind_span none = kinds_span(p, &all, KIND_BOUNDARY);
    assert_true(fluid.first == 0 && fluid.end == count[1]);
    assert_true(grains.first == count[1] && grains.end == N);
    assert_true(none.first == none.end);
    for (size_t k = 0; k < N; k++) {
        size_t from = (size_t)(1000 - p->id[k]); /* where it lay */
        int class = k < count[1] ? 0 : p->state[k].radius > 0.5 ? 2 : 1;
        assert_int_equal(kinds_of(p)[k], from % 3 == 0 ? KIND_FLUID : KIND_GRAIN);
        assert_int_equal(p->size_class[k], class);
        if (k > 0 && p->size_class[k - 1] == class)
            assert_true(p->id[k] > p->id[k - 1]); /* in a class the order stays */
    }
    particles_destroy(&p);
}

/* With one kind there is no field, all are grains, and an order stays as it is. */
static void test_one_kind_costs_nothing(void **state) {
    (void)state;
    struct classes_options options = {.method = CLASSES_CUTS, .cut_count = 1, .cut = {0.5}};
    struct size_classes classes;
    struct error error = {0};
    struct particles *p = sample(0, 50);
    double radii[50];
    uint32_t order[50];
    for (uint32_t k = 0; k < 50; k++) {
        radii[k] = p->state[k].radius;
        order[k] = 49 - k;
    }
    assert_true(classes_choose(&classes, &options, NULL, radii, 50, &error));
    particles_classify(p, &classes);
    kinds_sort(p, &classes, order);
    for (uint32_t k = 0; k < 50; k++)
        assert_int_equal(order[k], 49 - k);
    assert_int_equal(fields_find(p, "kind"), -1);
    assert_true(kinds_class(&classes, KIND_GRAIN, 0.4) == 0 && kinds_class(&classes, KIND_GRAIN, 9) == 1);
    struct kind_span all = kinds_span(p, &classes, KIND_GRAIN);
    assert_true(all.first == 0 && all.end == 50);
    particles_destroy(&p);
}

/* Margins so large that every cost is beyond what a number holds: one level has all sizes. */
static void test_costs_beyond_numbers(void **state) {
    (void)state;
    static struct cost_scene scene = {.dimension = 3, .volume = 1e3};
    double radii[40];
    struct cost_plan plan;
    for (int k = 0; k < 40; k++)
        radii[k] = k < 30 ? 0.1 + 0.001 * k : 1.0 + 0.01 * k;
    auto_bins(&scene, radii, 40, 1.0);
    for (int bin = 0; bin < scene.bins; bin++)
        scene.margin[bin] = 1e308;
    auto_levels(&scene, 8, &plan);
    assert_true(plan.levels >= 1 && plan.levels <= 8);
    assert_int_equal(plan.last[plan.levels - 1], scene.bins - 1);
}

TEST_MAIN(classes, cmocka_unit_test(test_costs_beyond_numbers),
          cmocka_unit_test(test_classes_by_ratio_and_by_cuts), cmocka_unit_test(test_classes_by_quantiles),
          cmocka_unit_test(test_kinds_lie_together), cmocka_unit_test(test_one_kind_costs_nothing))
