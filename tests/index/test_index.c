/* SPDX-License-Identifier: BSD-3-Clause */
/* The contract's other promises: names, orders, threads, memory, descriptions. */
#include "tests/test.h"

#include "tests/index/index_cloud.h"

#include <stdlib.h>
#include <string.h>

static void unknown_names_list_the_known(void **state) {
    (void)state;
    struct error error = {0};
    struct index_params params = {0};
    assert_null(index_create("octree", &params, &error));
    assert_int_equal(error.kind, ERROR_USER);
    for (int k = 0; k < index_registry_count(); k++) {
        assert_non_null(strstr(error.text, index_registry_get(k)->name));
        assert_ptr_equal(index_registry_find(index_registry_get(k)->name), index_registry_get(k));
        assert_true(strlen(index_registry_get(k)->summary) > 10);
    }
    assert_string_equal(index_registry_get(0)->name, "brute");
    char why[INDEX_WHY_MAX] = "";
    struct cloud cloud;
    index_cloud_make(&cloud, &(struct cloud_spec){.count = 3, .fraction = 0.1, .dimension = 3});
    assert_false(index_applicable("octree", &params, &cloud.view, why));
    assert_non_null(strstr(why, "octree"));
    cloud.view.total = ((size_t)1 << 27) + 1;
    assert_false(index_applicable("hgrid", &params, &cloud.view, why));
    index_cloud_free(&cloud);
}

static void make_order(const struct cloud *cloud, const char *name, int threads, uint32_t *order) {
    struct error error = {0};
    struct index_params params = {0};
    struct index *index = index_create(name, &params, &error);
    struct index_view view = cloud->view;
    view.threads = threads;
    index_order(index, &view, order);
    index_destroy(&index);
    assert_null(index);
}

/* The order is a permutation, ascending in class, keeps the old order of equal particles, and does not
 * change when an index orders the particles again. */
static void check_order(struct cloud *cloud, const uint32_t *order) {
    size_t n = cloud->view.owned;
    uint8_t *seen = calloc(n, 1);
    for (size_t k = 0; k < n; k++) {
        assert_true(order[k] < n && !seen[order[k]]);
        seen[order[k]] = 1;
        if (k > 0) {
            assert_true(cloud->size_class[order[k]] >= cloud->size_class[order[k - 1]]);
            const double *a = cloud->record + 5 * order[k - 1], *b = cloud->record + 5 * order[k];
            assert_true(memcmp(a, b, 4 * sizeof *a) != 0 || order[k - 1] < order[k]);
        }
    }
    free(seen);
}

static void orders_are_stable_permutations(void **state) {
    (void)state;
    const struct cloud_spec specs[] = {
        {"faces", 20000, 500, CLOUD_BIDISPERSE, 3, CLOUD_FACES, .edge = {60, 60, 60}, .dimension = 3,
         .periodic = {true, true, true}},
        {"power", 20000, 0, CLOUD_POWER, 20, .fraction = 0.5, .dimension = 3,
         .periodic = {true, false, true}},
        {"sparse", 20000, 9, CLOUD_BIDISPERSE, 50, CLOUD_CLUSTERED, .edge = {9000, 9000, 9000},
         .dimension = 3},
        {"same place", 10000, 0, CLOUD_MONO, 1, .edge = {0, 0, 0}, .fraction = 1e9, .dimension = 3}};
    for (size_t s = 0; s < sizeof specs / sizeof specs[0]; s++) {
        struct cloud cloud;
        index_cloud_make(&cloud, &specs[s]);
        size_t bytes = cloud.view.owned * sizeof(uint32_t);
        uint32_t *order = malloc(bytes), *other = malloc(bytes);
        for (int k = 1; k < index_registry_count(); k++) {
            const char *name = index_registry_get(k)->name;
            make_order(&cloud, name, 1, order);
            check_order(&cloud, order);
            for (int threads = 2; threads <= 4; threads++) {
                make_order(&cloud, name, threads, other);
                assert_memory_equal(order, other, bytes);
            }
            index_cloud_reorder(&cloud, order);
            make_order(&cloud, name, 2, other);
            for (size_t i = 0; i < cloud.view.owned; i++) {
                assert_int_equal(other[i], i);
            }
        }
        free(order);
        free(other);
        index_cloud_free(&cloud);
    }
}

static void brute_orders_nothing(void **state) {
    (void)state;
    struct cloud cloud;
    index_cloud_make(&cloud, &(struct cloud_spec){.count = 5, .fraction = 0.1, .dimension = 3});
    uint32_t order[5];
    make_order(&cloud, "brute", 1, order);
    for (uint32_t k = 0; k < 5; k++) {
        assert_int_equal(order[k], k);
    }
    index_cloud_free(&cloud);
}

/* Clouds large enough for the threaded paths; open, so that brute has one image only. */
static void threads_find_the_same_pairs(void **state) {
    (void)state;
    const struct cloud_spec specs[] = {{"dense", 8000, 60, CLOUD_BIDISPERSE, 6, .fraction = 0.7,
                                        .dimension = 3, .ghosts = 0.3, .newton = true},
                                       {"sparse", 8000, 5, CLOUD_BIDISPERSE, 40, CLOUD_CLUSTERED,
                                        .edge = {9000, 9000, 9000}, .dimension = 3},
                                       {"outliers", 8000, 0, CLOUD_POWER, 20, CLOUD_OUTLIERS,
                                        .edge = {90, 90, 90}, .dimension = 3, .ghosts = 0.1}};
    struct index_params params = {0};
    for (size_t s = 0; s < sizeof specs / sizeof specs[0]; s++) {
        struct cloud cloud;
        struct pair_set expected, found;
        index_cloud_make(&cloud, &specs[s]);
        struct index *index = cloud_index(&cloud, "brute", &params);
        pair_set_collect(&expected, index, &cloud.view, 1);
        index_destroy(&index);
        assert_true(expected.count > 1000);
        for (int k = 1; k < index_registry_count(); k++) {
            for (cloud.view.threads = 1; cloud.view.threads <= 4; cloud.view.threads *= 2) {
                index = cloud_index(&cloud, index_registry_get(k)->name, &params);
                pair_set_collect(&found, index, &cloud.view, 5);
                pair_set_compare(&expected, &found, index_registry_get(k)->name);
                pair_set_free(&found);
                index_destroy(&index);
            }
        }
        pair_set_free(&expected);
        index_cloud_free(&cloud);
    }
}

/* An index that is built again and again, for changing clouds, finds the same pairs as a new index. */
static void indexes_can_be_rebuilt(void **state) {
    (void)state;
    struct index_params params = {0};
    struct error error = {0};
    for (int k = 0; k < index_registry_count(); k++) {
        struct index *index = index_create(index_registry_get(k)->name, &params, &error);
        for (int round = 0; round < 6; round++) {
            struct cloud_spec spec = {.count = round == 3 ? 0 : 300 + 200 * (size_t)round % 900,
                                      .sizes = round % 2 ? CLOUD_POWER : CLOUD_MONO,
                                      .ratio = 20,
                                      .fraction = round == 2 ? 1e-5 : 0.5,
                                      .dimension = 3,
                                      .periodic = {true, round % 2 == 0, true},
                                      .ghosts = round == 4 ? 0.5 : 0,
                                      .seed = (uint64_t)round};
            struct cloud cloud;
            struct pair_set expected, found;
            index_cloud_make(&cloud, &spec);
            struct index *brute = cloud_index(&cloud, "brute", &params);
            pair_set_collect(&expected, brute, &cloud.view, 1);
            index_build(index, &cloud.view);
            pair_set_collect(&found, index, &cloud.view, 2);
            pair_set_compare(&expected, &found, index_registry_get(k)->name);
            pair_set_free(&expected);
            pair_set_free(&found);
            index_destroy(&brute);
            index_cloud_free(&cloud);
        }
        assert_int_equal(index->builds, 6);
        index_destroy(&index);
    }
}

/* An order that the caller does not apply has no effect on the pairs. */
static void an_order_need_not_be_followed(void **state) {
    (void)state;
    struct index_params params = {0};
    struct error error = {0};
    struct cloud cloud;
    struct pair_set expected, found;
    struct cloud_spec spec = {.count = 700,
                              .sizes = CLOUD_MONO,
                              .fraction = 0.4,
                              .dimension = 3,
                              .periodic = {true, false, true},
                              .seed = 4};
    index_cloud_make(&cloud, &spec);
    uint32_t *order = malloc(cloud.view.owned * sizeof *order);
    struct index *brute = cloud_index(&cloud, "brute", &params);
    pair_set_collect(&expected, brute, &cloud.view, 1);
    for (int k = 0; k < index_registry_count(); k++) {
        struct index *index = index_create(index_registry_get(k)->name, &params, &error);
        index_order(index, &cloud.view, order);
        index_build(index, &cloud.view);
        pair_set_collect(&found, index, &cloud.view, 2);
        pair_set_compare(&expected, &found, index_registry_get(k)->name);
        pair_set_free(&found);
        index_destroy(&index);
    }
    pair_set_free(&expected);
    index_destroy(&brute);
    free(order);
    index_cloud_free(&cloud);
}

static void memory_grows_with_particles_alone(void **state) {
    (void)state;
    struct index_params params = {0};
    for (int k = 1; k < index_registry_count(); k++) {
        for (double edge = 1e4; edge < 1e8; edge *= 100) {
            struct cloud cloud;
            index_cloud_make(&cloud, &(struct cloud_spec){.count = 5000,
                                                          .large = 2,
                                                          .sizes = CLOUD_BIDISPERSE,
                                                          .ratio = 1000,
                                                          .edge = {edge, edge, edge},
                                                          .dimension = 3,
                                                          .periodic = {true, true, true}});
            struct index *index = cloud_index(&cloud, index_registry_get(k)->name, &params);
            assert_in_range(index_memory(index), 5000 * 4, 5000 * 200 + (1 << 20));
            struct index_description description;
            index_describe(index, &description);
            const char *name = index_registry_get(k)->name; /* auto may take cells that are large enough */
            bool coarse = strcmp(name, "linkcell") == 0 || strcmp(name, "auto") == 0;
            assert_true(description.level[0].sparse || coarse || description.levels == 0);
            index_destroy(&index);
            index_cloud_free(&cloud);
        }
    }
}

/* An index that was released describes its last build, holds little, and finds the same pairs after a new build. */
static void released_indexes_can_be_rebuilt(void **state) {
    (void)state;
    struct cloud cloud;
    index_cloud_make(&cloud, &(struct cloud_spec){.count = 3000,
                                                  .large = 3,
                                                  .sizes = CLOUD_BIDISPERSE,
                                                  .ratio = 20,
                                                  .fraction = 0.4,
                                                  .dimension = 3,
                                                  .periodic = {true, true, true}});
    struct index_params params = {0};
    struct error error = {0};
    for (int k = 1; k < index_registry_count(); k++) {
        struct index *index = index_create(index_registry_get(k)->name, &params, &error);
        struct pair_set expected = {0}, found = {0};
        struct index_description before, after;
        index_build(index, &cloud.view);
        pair_set_collect(&expected, index, &cloud.view, 2);
        index_describe(index, &before);
        size_t held = index_memory(index);
        index_release(index);
        index_describe(index, &after);
        assert_true(index_memory(index) + 4 * 3000 < held);
        assert_int_equal(after.levels, before.levels);
        assert_int_equal(after.level[0].particles, before.level[0].particles);
        index_build(index, &cloud.view);
        pair_set_collect(&found, index, &cloud.view, 2);
        pair_set_compare(&expected, &found, index_registry_get(k)->name);
        pair_set_free(&expected);
        pair_set_free(&found);
        index_destroy(&index);
    }
    index_cloud_free(&cloud);
}

static void descriptions_account_for_all(void **state) {
    (void)state;
    struct cloud cloud;
    index_cloud_make(&cloud, &(struct cloud_spec){.count = 3000,
                                                  .sizes = CLOUD_POWER,
                                                  .ratio = 30,
                                                  .fraction = 0.5,
                                                  .dimension = 3,
                                                  .ghosts = 0.2,
                                                  .periodic = {true, true, true}});
    struct index_params params = {.levels = 3};
    const struct {
        const char *name;
        int levels;
    } known[] = {{"brute", 0}, {"linkcell", 1}, {"multi", 1}, {"bytype", cloud.view.classes}, {"hgrid", 3}};
    for (int k = 0; k < index_registry_count(); k++) {
        struct index *index = cloud_index(&cloud, index_registry_get(k)->name, &params);
        struct index_description description;
        index_describe(index, &description);
        size_t particles = 0;
        for (int l = 0; l < description.levels; l++) {
            const struct index_level *level = &description.level[l];
            particles += level->particles;
            assert_true(level->cell > 0 && level->cells > 0 && level->radius_max > level->radius_min);
            assert_true(l == 0 || level->radius_min >= description.level[l - 1].radius_max);
        }
        assert_int_equal(particles, description.levels > 0 ? 3000 : 0); /* no levels: no cells */
        const char *name = index_registry_get(k)->name;
        for (size_t n = 0; n < sizeof known / sizeof known[0]; n++) {
            assert_true(strcmp(name, known[n].name) != 0 || description.levels == known[n].levels);
        }
        if (strcmp(name, "auto") == 0) {
            assert_true(description.levels > 0 && description.levels <= cloud.view.classes);
            assert_true(description.predicted > 0 && description.choice[0] && description.why[0]);
        }
        index_destroy(&index);
    }
    index_cloud_free(&cloud);
}

/* A check that never fails proves nothing. */
static void checks_notice_moved_particles(void **state) {
    (void)state;
    struct cloud cloud;
    index_cloud_make(&cloud, &(struct cloud_spec){.count = 500, .fraction = 0.3, .dimension = 3});
    struct index_params params = {0};
    for (int k = 1; k < index_registry_count(); k++) {
        struct index *index = cloud_index(&cloud, index_registry_get(k)->name, &params);
        char why[INDEX_WHY_MAX] = "";
        double x = cloud.record[5 * 77];
        cloud.record[5 * 77] = x > cloud.view.edge[0] / 2 ? 0 : cloud.view.edge[0];
        assert_false(index_check(index, &cloud.view, why));
        assert_true(strlen(why) > 0);
        cloud.record[5 * 77] = x;
        assert_true(index_check(index, &cloud.view, why));
        index_destroy(&index);
    }
    index_cloud_free(&cloud);
}

TEST_MAIN(index, cmocka_unit_test(unknown_names_list_the_known),
          cmocka_unit_test(orders_are_stable_permutations), cmocka_unit_test(brute_orders_nothing),
          cmocka_unit_test(threads_find_the_same_pairs), cmocka_unit_test(indexes_can_be_rebuilt),
          cmocka_unit_test(an_order_need_not_be_followed),
          cmocka_unit_test(memory_grows_with_particles_alone),
          cmocka_unit_test(released_indexes_can_be_rebuilt), cmocka_unit_test(descriptions_account_for_all),
          cmocka_unit_test(checks_notice_moved_particles))
