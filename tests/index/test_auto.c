/* SPDX-License-Identifier: BSD-3-Clause */
/* The choice of auto: levels, cuts and cells for scenes with a clear answer, and equal choices for equal
 * scenes. */
#include "tests/test.h"

#include "index/choose/auto_choose.h"
#include "tests/index/index_cloud.h"

#include <math.h>
#include <string.h>

enum { RADII = 4000 };

/* Radii, number density ~ r^-3 from 1 to ratio, at a volume fraction of 0.4. */
static void univol(struct cost_scene *scene, double ratio) {
    double radii[RADII], volume = 0;
    for (int k = 0; k < RADII; k++) {
        radii[k] = 1 / sqrt(1 - (k + 0.5) / RADII * (1 - 1 / (ratio * ratio)));
        volume += 4 * M_PI / 3 * pow(radii[k], 3);
    }
    *scene = (struct cost_scene){.dimension = 3, .threads = 1, .volume = 25 * volume / 0.4};
    auto_bins(scene, radii, RADII, 25);
}

/* `large` particles of radius `ratio` among RADII particles of radius 1. */
static void bidisperse(struct cost_scene *scene, double ratio, int large) {
    double radii[RADII], volume = 0;
    for (int k = 0; k < RADII; k++) {
        radii[k] = k < RADII - large ? 1 : ratio;
        volume += 4 * M_PI / 3 * pow(radii[k], 3);
    }
    *scene = (struct cost_scene){.dimension = 3, .threads = 1, .volume = 25 * volume / 0.45};
    auto_bins(scene, radii, RADII, 25);
    for (int bin = 0; bin < scene->bins; bin++) {
        scene->margin[bin] = 0.3 * scene->radius_min[bin];
    }
}

static void equal_sizes_share_a_level(void **state) {
    (void)state;
    struct cost_scene scene;
    struct cost_plan plan;
    bidisperse(&scene, 1, 0);
    auto_levels(&scene, INDEX_CLASS_MAX, &plan);
    assert_int_equal(plan.levels, 1);
    assert_true(plan.edge[0] >= 1 && plan.edge[0] <= 5);
}

static void sizes_far_apart_do_not(void **state) {
    (void)state;
    const struct {
        double ratio;
        int large;
    } cases[] = {{10, 4}, {40, 1}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        struct cost_scene scene;
        struct cost_plan plan;
        bidisperse(&scene, cases[k].ratio, cases[k].large);
        auto_levels(&scene, INDEX_CLASS_MAX, &plan);
        assert_int_equal(plan.levels, 2);
        assert_true(scene.radius_max[plan.last[0]] == 1);
    }
}

/* A wide law: several levels, cheaper than one and than many; the model explains its choice. */
static void wide_laws_get_a_few_levels(void **state) {
    (void)state;
    struct cost_scene scene;
    struct cost_plan plan, other;
    univol(&scene, 50);
    auto_levels(&scene, INDEX_CLASS_MAX, &plan);
    assert_in_range(plan.levels, 2, 6);
    double best = cost_seconds(&scene, &plan);
    for (int levels = 1; levels <= 16; levels++) {
        auto_equal(&scene, levels, &other);
        assert_true(best <= auto_edges(&scene, &other) * 1.01);
    }
    auto_equal(&scene, 1, &other);
    assert_true(auto_edges(&scene, &other) > 3 * best);
}

/* Equation 2: as many particles in a cell on every level, as far as bins go. */
static void equal_levels_have_equal_occupancy(void **state) {
    (void)state;
    struct cost_scene scene;
    struct cost_plan plan;
    univol(&scene, 50);
    for (int levels = 2; levels <= 6; levels++) {
        double least = INFINITY, most = 0;
        auto_equal(&scene, levels, &plan);
        assert_int_equal(plan.levels, levels);
        assert_int_equal(plan.last[levels - 1], scene.bins - 1);
        for (int g = 0, bin = 0; g < levels; g++) {
            double count = 0;
            for (; bin <= plan.last[g]; bin++) {
                count += scene.count[bin];
            }
            double m = count * pow(plan.edge[g], 3);
            least = fmin(least, m);
            most = fmax(most, m);
        }
        assert_true(most < 3 * least);
    }
}

/* Levels that never meet cost as much as each level alone, and a level that meets no level costs its
 * particles alone. */
static void unwanted_pairs_cost_nothing(void **state) {
    (void)state;
    struct cost_scene scene;
    struct cost_plan plan;
    bidisperse(&scene, 10, 4);
    auto_levels(&scene, INDEX_CLASS_MAX, &plan);
    const int last = scene.bins - 1;
    assert_true(plan.levels == 2 && last > 0);
    double both[COST_TERMS], apart[COST_TERMS], large[COST_TERMS], all = cost_seconds(&scene, &plan);
    scene.unwanted[0] = (uint64_t)1 << last;
    scene.unwanted[last] = 1;
    cost_count(&scene, &plan, apart);
    assert_true(cost_seconds(&scene, &plan) < all);
    scene.unwanted[0] = 1 | (uint64_t)1 << last;
    cost_count(&scene, &plan, large);
    scene.count[0] = 0;
    cost_count(&scene, &plan, both);
    for (int t = 0; t < COST_TERMS; t++) {
        assert_true(apart[t] >= large[t] && (t == COST_PARTICLE || t == COST_CELL || large[t] == both[t]));
    }
    assert_true(apart[COST_WINDOW] > large[COST_WINDOW] && large[COST_PARTICLE] > both[COST_PARTICLE]);
}

/* For a view an index makes the same choice as a new index, whatever the earlier choices. */
static void choices_have_no_memory(void **state) {
    (void)state;
    struct cloud few, many;
    struct error error = {0};
    struct index_params params = {0};
    index_cloud_make(&few, &(struct cloud_spec){.count = 900,
                                                .sizes = CLOUD_POWER,
                                                .ratio = 50,
                                                .fraction = 0.5,
                                                .dimension = 3,
                                                .periodic = {true, true, true}});
    index_cloud_make(&many, &(struct cloud_spec){.count = 4000,
                                                 .sizes = CLOUD_BIDISPERSE,
                                                 .large = 20,
                                                 .ratio = 6,
                                                 .fraction = 0.1,
                                                 .dimension = 3});
    struct index *used = index_create("auto", &params, &error),
                 *fresh = index_create("auto", &params, &error);
    struct index_description a, b;
    index_build(used, &many.view);
    index_build(used, &few.view);
    index_build(fresh, &few.view);
    index_describe(used, &a);
    index_describe(fresh, &b);
    assert_int_equal(a.choices, 2);
    assert_int_equal(b.choices, 1);
    assert_true(a.levels == b.levels && a.predicted == b.predicted && strcmp(a.why, b.why) == 0);
    for (int l = 0; l < a.levels; l++) {
        assert_true(a.level[l].cell == b.level[l].cell && a.level[l].particles == b.level[l].particles);
    }
    index_destroy(&used);
    index_destroy(&fresh);
    index_cloud_free(&few);
    index_cloud_free(&many);
}

/* All variants that are offered find the same pairs. */
static void variants_find_the_same(void **state) {
    (void)state;
    struct cloud cloud;
    struct index_params params = {0};
    index_cloud_make(&cloud, &(struct cloud_spec){.count = 2000,
                                                  .sizes = CLOUD_POWER,
                                                  .ratio = 20,
                                                  .fraction = 0.3,
                                                  .dimension = 3,
                                                  .periodic = {true, true, true}});
    struct index *index = cloud_index(&cloud, "auto", &params);
    struct pair_set expected, found;
    pair_set_collect(&expected, index, &cloud.view, 3);
    assert_true(index_trials(index) >= 3);
    for (int k = 1; k < index_trials(index); k++) {
        struct index_description description;
        index_select(index, k);
        index_build(index, &cloud.view);
        index_describe(index, &description);
        assert_int_equal(description.variant, k);
        pair_set_collect(&found, index, &cloud.view, 3);
        pair_set_compare(&expected, &found, "variant");
        pair_set_free(&found);
    }
    pair_set_free(&expected);
    index_destroy(&index);
    index_cloud_free(&cloud);
}

/* Cells are the user's multiple of the chosen cells, even if larger cells would keep the grid dense. */
static void cell_factors_are_kept(void **state) {
    (void)state;
    static const double factors[] = {1, 0.7, 0.6, 0.5, 0.4, 0.3};
    struct cloud cloud;
    double edge = 0;
    index_cloud_make(&cloud,
                     &(struct cloud_spec){
                         .count = 4000, .sizes = CLOUD_MONO, .ratio = 1, .fraction = 0.5, .dimension = 3});
    for (size_t k = 0; k < sizeof factors / sizeof factors[0]; k++) {
        struct index_params params = {.cell_factor = factors[k]};
        struct index *index = cloud_index(&cloud, "auto", &params);
        struct index_description description;
        index_describe(index, &description);
        edge = k == 0 ? description.level[0].cell : edge;
        assert_true(fabs(description.level[0].cell - factors[k] * edge) < 1e-5 * edge);
        index_destroy(&index);
    }
    index_cloud_free(&cloud);
}

/* 32 classes with radii from 1 to `ratio`, as many particles in each as a law r^-3 has. */
static void many_classes(struct cost_scene *scene, double ratio) {
    *scene = (struct cost_scene){.bins = INDEX_CLASS_MAX, .dimension = 3, .threads = 1, .classes = true};
    for (int c = 0; c < INDEX_CLASS_MAX; c++) {
        const double radius = pow(ratio, (c + 1.0) / INDEX_CLASS_MAX);
        scene->radius_min[c] = scene->radius_max[c] = radius;
        scene->count[c] = 1e6 / (radius * radius);
        scene->margin[c] = 0.3 * radius;
        scene->volume += scene->count[c] * pow(radius, 3) * 4 * M_PI / 3 / 0.4;
    }
}

/* A sheet that changes step by step says what a plan says that is priced anew. */
static void sheets_price_as_plans(void **state) {
    (void)state;
    struct cost_scene scene;
    struct cost_sheet sheet;
    struct cost_plan plan = {.levels = 12};
    many_classes(&scene, 60);
    for (int g = 0; g < plan.levels; g++) {
        plan.last[g] = g + 1 < plan.levels ? 2 * g + 1 : INDEX_CLASS_MAX - 1;
        plan.edge[g] = 1.4 * cost_cutoff(&scene, &plan, g);
    }
    cost_sheet_make(&sheet, &scene, &plan);
    for (int k = 0; sheet.levels > 1; k++) {
        const int level = k * 5 % (sheet.levels - 1);
        if (k % 2 == 0) {
            cost_sheet_edge(&sheet, level, 0.8 * sheet.level[level].edge);
        } else {
            cost_sheet_join(&sheet, level);
        }
        cost_sheet_plan(&sheet, &plan);
        const double seconds = cost_seconds(&scene, &plan);
        assert_true(fabs(cost_sheet_seconds(&sheet) - seconds) < 1e-9 * seconds);
    }
}

/* As many classes as there can be are grouped at once, into a plan that is better than one grid for all, and than a
 * grid for each. */
static void many_classes_are_grouped(void **state) {
    (void)state;
    for (double ratio = 1.5; ratio < 300; ratio *= 3) {
        struct cost_scene scene;
        struct cost_plan plan, one = {.levels = 1, .last = {INDEX_CLASS_MAX - 1}},
                               each = {.levels = INDEX_CLASS_MAX};
        many_classes(&scene, ratio);
        for (int c = 0; c < INDEX_CLASS_MAX; c++) {
            each.last[c] = c;
        }
        auto_group(&scene, &plan);
        const double best = cost_seconds(&scene, &plan);
        assert_int_equal(plan.last[plan.levels - 1], INDEX_CLASS_MAX - 1);
        assert_true(best <= auto_edges(&scene, &one) * 1.02 && best <= auto_edges(&scene, &each));
    }
}

TEST_MAIN(auto, cmocka_unit_test(equal_sizes_share_a_level), cmocka_unit_test(sizes_far_apart_do_not),
          cmocka_unit_test(wide_laws_get_a_few_levels), cmocka_unit_test(equal_levels_have_equal_occupancy),
          cmocka_unit_test(choices_have_no_memory), cmocka_unit_test(variants_find_the_same),
          cmocka_unit_test(cell_factors_are_kept), cmocka_unit_test(sheets_price_as_plans),
          cmocka_unit_test(many_classes_are_grouped), cmocka_unit_test(unwanted_pairs_cost_nothing))
