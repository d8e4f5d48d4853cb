/* SPDX-License-Identifier: BSD-3-Clause */
/* Class pairs that are not wanted: a plain double loop finds the same pairs, and the index searches no
 * unwanted table. */
#include "tests/test.h"

#include "index/levels/levels.h"
#include "index/levels/levels_plan.h"
#include "tests/index/index_cloud.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CLASSES = 3, PATTERNS = 64 };

/* Pairs of classes, of which bit k of a pattern says that the k-th is not wanted. */
static const int class_pair[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

static bool never(unsigned pattern, int a, int b) {
    for (int k = 0; k < 6; k++) {
        if (class_pair[k][0] == (a < b ? a : b) && class_pair[k][1] == (a < b ? b : a)) {
            return pattern >> k & 1;
        }
    }
    return true;
}

static bool meets_nobody(unsigned pattern, int c) {
    return never(pattern, c, 0) && never(pattern, c, 1) && never(pattern, c, 2);
}

/* Three classes of radii 1 ... 7.9, a fourth of the particles ghosts; `kind` chooses the rest. */
static void make_cloud(struct cloud *cloud, int kind) {
    const struct cloud_spec spec = {.count = 240,
                                    .sizes = CLOUD_POWER,
                                    .ratio = 7.9,
                                    .fraction = kind & 1 ? 0.4 : 0.7,
                                    .dimension = kind & 1 ? 2 : 3,
                                    .periodic = {(kind & 2) != 0, true, kind == 2},
                                    .ghosts = kind == 2 ? 0 : 0.25,
                                    .newton = kind < 2,
                                    .seed = (uint64_t)kind};
    index_cloud_make(cloud, &spec);
    assert_int_equal(cloud->view.classes, CLASSES);
}

static void set_pattern(struct cloud *cloud, unsigned pattern) {
    for (int a = 0; a < CLASSES; a++) {
        for (int b = 0; b < CLASSES; b++) {
            cloud->view.margin[a][b] = never(pattern, a, b) ? INDEX_NOT_WANTED : 0.2 + 0.1 * (a + b);
        }
    }
}

/* Does the rank that owns i keep its pair with the ghost j? */
static bool kept(const struct index_view *view, size_t i, size_t j) {
    double ri = view->radius[i * view->stride], rj = view->radius[j * view->stride];
    if (!view->newton || ri < rj) {
        return true;
    }
    return ri == rj && ((view->id[i] + view->id[j]) % 2 != 0) == (view->id[i] < view->id[j]);
}

/* The pairs of i and j through all images. */
static void plain_pair(struct pair_set *set, const struct index_view *view, size_t i, size_t j,
                       double margin) {
    const double *xi = view->position + i * view->stride, *xj = view->position + j * view->stride;
    double reach = xi[3] + xj[3] + margin;
    for (int turn = 0; turn < 27; turn++) {
        int image[3] = {turn % 3 - 1, turn / 3 % 3 - 1, turn / 9 - 1};
        double square = 0;
        bool there = true;
        for (int d = 0; d < 3; d++) {
            double x = xj[d] - xi[d] + image[d] * view->edge[d];
            there = there && (image[d] == 0 || view->periodic[d]);
            square += x * x;
        }
        if (there && sqrt(square) <= reach) {
            unsigned code = image_code(image[0], image[1], image[2]);
            set->key[set->count++] = pair_key(view, (uint32_t)i, (uint32_t)j | code << INDEX_IMAGE_SHIFT);
        }
    }
}

static void plain_set(struct pair_set *set, const struct index_view *view, unsigned pattern) {
    *set = (struct pair_set){.key = malloc(view->total * view->total * 27 * sizeof *set->key)};
    for (size_t i = 0; i < view->owned; i++) {
        for (size_t j = i + 1; j < view->total; j++) {
            int a = view->size_class[i], b = view->size_class[j];
            if (!never(pattern, a, b) && (j < view->owned || kept(view, i, j))) {
                plain_pair(set, view, i, j, 0.2 + 0.1 * (a + b));
            }
        }
    }
    pair_set_sort(set);
}

/* Builds the index for the cloud, by turns after an order, and compares. */
static void compare_index(struct cloud *cloud, struct index *index, const struct pair_set *expected,
                          const char *what) {
    struct pair_set found;
    char why[INDEX_WHY_MAX];
    if (cloud->view.ordered) {
        uint32_t *order = malloc(cloud->view.owned * sizeof *order);
        struct index_view owned = cloud->view;
        owned.total = owned.owned;
        index_order(index, &owned, order);
        index_cloud_reorder(cloud, order);
        free(order);
    }
    index_build(index, &cloud->view);
    assert_true(index_check(index, &cloud->view, why));
    pair_set_collect(&found, index, &cloud->view, 2);
    pair_set_compare(expected, &found, what);
    pair_set_free(&found);
}

/* All 64 patterns of three classes; each index, with each set of instructions, searches one pattern after
 * another. */
static void a_plain_loop_finds_the_same(void **state) {
    (void)state;
    struct error error = {0};
    struct index *index[64];
    const int indexes = 3 * index_registry_count();
    assert_in_range(indexes, 1, 64);
    for (int kind = 0; kind < 4; kind++) {
        struct cloud cloud;
        make_cloud(&cloud, kind);
        for (int k = 0; k < indexes; k++) {
            const struct index_params params = {.instructions = INDEX_PLAIN + k % 3};
            index[k] = index_create(index_registry_get(k / 3)->name, &params, &error);
        }
        for (unsigned pattern = 0; pattern < PATTERNS; pattern++) {
            struct pair_set expected;
            set_pattern(&cloud, pattern);
            cloud.view.ordered = pattern % 3 == 1;
            plain_set(&expected, &cloud.view, pattern);
            assert_true((pattern == PATTERNS - 1) == (expected.count == 0));
            for (int k = 0; k < indexes; k++) {
                char what[64];
                snprintf(what, sizeof what, "%s, cloud %d, pattern %u", index[k]->ops->name, kind, pattern);
                compare_index(&cloud, index[k], &expected, what);
            }
            pair_set_free(&expected);
        }
        for (int k = 0; k < indexes; k++) {
            index_destroy(&index[k]);
        }
        index_cloud_free(&cloud);
    }
}

/* One grid for each class: each class searches the grids of the classes that it meets, and no other grid. */
static void searches_in_vain_are_left_out(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        struct cloud cloud;
        make_cloud(&cloud, kind);
        for (unsigned pattern = 0; pattern < PATTERNS; pattern++) {
            struct levels levels = {0};
            struct levels_plan plan = {.grids = CLASSES, .grid_of = {0, 1, 2}, .edge = {3, 5, 9}};
            set_pattern(&cloud, pattern);
            levels_plan_apart(&plan, &cloud.view);
            levels_start(&levels, &(struct index_params){0});
            levels_build(&levels, &plan, &cloud.view);
            bool ghosts = cloud.view.total > cloud.view.owned;
            int expected = 0, found = 0;
            for (int a = 0; a < CLASSES; a++) {
                assert_int_equal(plan.idle[a], meets_nobody(pattern, a));
                assert_int_equal(levels.level[a].owned.count == 0, meets_nobody(pattern, a));
                for (int b = 0; b < CLASSES; b++) {
                    bool among_owned = b >= a, with_ghosts = ghosts && (b >= a || !cloud.view.newton);
                    expected += never(pattern, a, b) ? 0 : among_owned + with_ghosts;
                }
                found += levels.searches.count[a] + levels.cross_searches.count[a];
            }
            assert_int_equal(found, expected);
            levels_free(&levels);
        }
        index_cloud_free(&cloud);
    }
}

/* The description of an index: particles of a class that meets no class lie in no cells, and the cells are as
 * large as the other classes demand. */
static void who_meets_nobody_needs_no_cells(void **state) {
    (void)state;
    const struct index_params params = {0};
    struct cloud cloud;
    index_cloud_make(&cloud, &(struct cloud_spec){.count = 2000,
                                                  .large = 40,
                                                  .sizes = CLOUD_BIDISPERSE,
                                                  .ratio = 10,
                                                  .fraction = 0.5,
                                                  .dimension = 3,
                                                  .periodic = {true, true, true}});
    for (int alone = 0; alone < 2; alone++) {
        for (int b = 0; b < 2; b++) {
            cloud.view.margin[alone][b] = cloud.view.margin[b][alone] = INDEX_NOT_WANTED;
            cloud.view.margin[1 - alone][1 - alone] = 0.4;
        }
        for (int k = 1; k < index_registry_count(); k++) {
            struct index *index = cloud_index(&cloud, index_registry_get(k)->name, &params);
            struct index_description description;
            index_describe(index, &description);
            if (description.levels == 0) { /* an index without cells */
                index_destroy(&index);
                continue;
            }
            assert_int_equal(description.levels, 2);
            const struct index_level *none = &description.level[alone], *some = &description.level[1 - alone];
            assert_true(none->cell == 0 && none->cells == 0 && !none->sparse);
            assert_true(some->cell > 0.4 * (alone ? 2 : 20) && some->cell < 5 * (alone ? 2.4 : 20.4));
            assert_int_equal(none->particles, alone ? 40 : 1960);
            assert_int_equal(some->particles, alone ? 1960 : 40);
            index_destroy(&index);
        }
    }
    cloud.view.margin[0][0] = INDEX_NOT_WANTED;
    for (int k = 1; k < index_registry_count(); k++) { /* no class meets a class: no cells at all */
        struct index *index = cloud_index(&cloud, index_registry_get(k)->name, &params);
        struct index_description description;
        index_describe(index, &description);
        for (int l = 0; l < description.levels; l++) {
            assert_int_equal(description.level[l].cells, 0);
        }
        index_destroy(&index);
    }
    index_cloud_free(&cloud);
}

TEST_MAIN(wanted, cmocka_unit_test(a_plain_loop_finds_the_same),
          cmocka_unit_test(searches_in_vain_are_left_out), cmocka_unit_test(who_meets_nobody_needs_no_cells))
