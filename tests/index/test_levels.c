/* SPDX-License-Identifier: BSD-3-Clause */
/* Every index against brute: exact sets of pairs over clouds of all kinds. The clouds have a third of the particles, with
 * SCREE_SHORT, as under sanitizers, an eighth, with SCREE_LONG all. */
#include "tests/test.h"

#include "index/search/search.h"
#include "tests/index/index_cloud.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PERIODIC                                                                                             \
    { true, true, true }
#define OPEN                                                                                                 \
    { false, false, false }

static const struct cloud_spec specs[] = {
    {"nothing", 0, 0, CLOUD_MONO, 1, .fraction = 0.1, .dimension = 3, .periodic = PERIODIC},
    {"one", 1, 0, CLOUD_MONO, 1, .fraction = 0.01, .dimension = 3, .periodic = PERIODIC},
    {"two", 2, 0, CLOUD_MONO, 1, .fraction = 0.1, .dimension = 3, .periodic = PERIODIC, .seed = 2},
    {"two, open", 2, 0, CLOUD_MONO, 1, .fraction = 0.3, .dimension = 3, .periodic = OPEN, .seed = 3},
    {"mono", 2000, 0, CLOUD_MONO, 1, .fraction = 0.5, .dimension = 3, .periodic = PERIODIC},
    {"mono, open", 2000, 0, CLOUD_MONO, 1, .fraction = 0.5, .dimension = 3, .periodic = OPEN},
    {"mono, slab", 2000, 0, CLOUD_MONO, 1, .fraction = 0.4, .dimension = 3, .periodic = {true, false, true}},
    {"mono, discs", 1500, 0, CLOUD_MONO, 1, .fraction = 0.6, .dimension = 2, .periodic = {true, true, false}},
    {"mono, discs, open", 1500, 0, CLOUD_MONO, 1, .fraction = 0.6, .dimension = 2,
     .periodic = {false, true, false}},
    {"dense", 1200, 0, CLOUD_MONO, 1, .fraction = 5, .dimension = 3, .periodic = PERIODIC},
    {"nearly empty", 1200, 0, CLOUD_MONO, 1, .fraction = 1e-7, .dimension = 3, .periodic = PERIODIC},
    {"bidisperse 10", 1300, 3, CLOUD_BIDISPERSE, 10, .fraction = 0.5, .dimension = 3, .periodic = PERIODIC},
    {"bidisperse 10, relative margins", 3000, 5, CLOUD_BIDISPERSE, 10, .margins = CLOUD_MARGIN_RELATIVE,
     .fraction = 0.5, .dimension = 3, .periodic = {false, true, true}},
    {"bidisperse 100", 1000, 2, CLOUD_BIDISPERSE, 100, .fraction = 0.3, .dimension = 3, .periodic = PERIODIC},
    {"bidisperse 100, discs", 3000, 3, CLOUD_BIDISPERSE, 100, .fraction = 0.5, .dimension = 2,
     .periodic = {true, true, false}},
    {"bidisperse 1000", 1500, 2, CLOUD_BIDISPERSE, 1000, .fraction = 0.2, .dimension = 3, .periodic = OPEN},
    {"bidisperse 1000, periodic", 1500, 2, CLOUD_BIDISPERSE, 1000, .fraction = 0.1, .dimension = 3,
     .periodic = PERIODIC},
    {"power law 50", 900, 0, CLOUD_POWER, 50, .fraction = 0.5, .dimension = 3, .periodic = PERIODIC},
    {"power law 50, mixed margins, loose", 2000, 0, CLOUD_POWER, 50, .margins = CLOUD_MARGIN_MIXED,
     .fraction = 0.6, .dimension = 3, .periodic = {true, true, false}, .loose_bounds = true},
    {"power law 8, discs", 1500, 0, CLOUD_POWER, 8, .margins = CLOUD_MARGIN_RELATIVE, .fraction = 0.7,
     .dimension = 2, .periodic = {true, true, false}},
    {"power law 30, one class", 1300, 0, CLOUD_ONE_CLASS, 30, .fraction = 0.5, .dimension = 3,
     .periodic = PERIODIC},
    {"boulder of nearly half the box", 2000, 1, CLOUD_BOULDER, 9.8, .edge = {40, 40, 40}, .dimension = 3,
     .periodic = PERIODIC},
    {"boulder of most of the box", 1300, 1, CLOUD_BOULDER, 14, .edge = {30, 30, 30}, .dimension = 3,
     .periodic = PERIODIC},
    {"two boulders", 1300, 2, CLOUD_BOULDER, 12, .edge = {27, 27, 27}, .dimension = 3, .periodic = PERIODIC},
    {"two boulders, open", 2000, 2, CLOUD_BOULDER, 12, .edge = {27, 27, 27}, .dimension = 3,
     .periodic = OPEN},
    {"one spot", 700, 3, CLOUD_BIDISPERSE, 4, CLOUD_ONE_SPOT, .edge = {50, 50, 50}, .dimension = 3,
     .periodic = PERIODIC},
    {"one spot, open", 700, 3, CLOUD_BIDISPERSE, 4, CLOUD_ONE_SPOT, .edge = {50, 50, 50}, .dimension = 3,
     .periodic = OPEN},
    {"faces and twins", 600, 3, CLOUD_BIDISPERSE, 3, CLOUD_FACES, .edge = {12, 12, 12}, .dimension = 3,
     .periodic = PERIODIC},
    {"faces and twins, open", 600, 3, CLOUD_BIDISPERSE, 3, CLOUD_FACES, .edge = {12, 12, 12}, .dimension = 3,
     .periodic = OPEN},
    {"thin in x", 500, 0, CLOUD_MONO, 1, .edge = {2.5, 20, 20}, .dimension = 3, .periodic = PERIODIC},
    {"thin in y", 500, 0, CLOUD_MONO, 1, .edge = {20, 3.0, 20}, .dimension = 3, .periodic = PERIODIC},
    {"thin in z", 500, 0, CLOUD_MONO, 1, .edge = {20, 20, 4.5}, .dimension = 3, .periodic = PERIODIC},
    {"thin in all", 60, 0, CLOUD_MONO, 1, .edge = {2.5, 3.5, 4.9}, .dimension = 3, .periodic = PERIODIC},
    {"thin in all, 7 cells", 400, 0, CLOUD_MONO, 1, .edge = {7.3, 7.4, 5}, .dimension = 3,
     .periodic = PERIODIC},
    {"clustered", 1300, 3, CLOUD_BIDISPERSE, 10, CLOUD_CLUSTERED, .edge = {5000, 5000, 5000}, .dimension = 3,
     .periodic = PERIODIC},
    {"outliers", 2000, 3, CLOUD_BIDISPERSE, 10, CLOUD_OUTLIERS, .edge = {30, 30, 30}, .dimension = 3,
     .periodic = OPEN},
    {"outliers, tube", 2000, 0, CLOUD_POWER, 10, CLOUD_OUTLIERS, .edge = {30, 50, 30}, .dimension = 3,
     .periodic = {true, false, true}},
    {"long runs", 2500, 4, CLOUD_BIDISPERSE, 20, .edge = {60, 50, 50}, .dimension = 3, .periodic = PERIODIC},
    {"ghosts, mono", 2000, 0, CLOUD_MONO, 1, .fraction = 0.5, .dimension = 3, .periodic = OPEN,
     .ghosts = 0.4},
    {"ghosts, bidisperse", 3000, 20, CLOUD_BIDISPERSE, 10, .fraction = 0.8, .dimension = 3,
     .periodic = {true, false, false}, .ghosts = 0.5},
    {"ghosts, power law", 2000, 0, CLOUD_POWER, 30, .margins = CLOUD_MARGIN_RELATIVE, .fraction = 0.6,
     .dimension = 3, .periodic = OPEN, .ghosts = 0.3},
    {"ghosts, one class", 2000, 0, CLOUD_ONE_CLASS, 10, .fraction = 0.6, .dimension = 3,
     .periodic = {false, false, true}, .ghosts = 0.3},
    {"ghosts around, mono", 3000, 0, CLOUD_MONO, 1, .fraction = 0.4, .dimension = 3, .periodic = OPEN,
     .ghosts = 0.3, .around = true},
    {"ghosts around, bidisperse", 3000, 20, CLOUD_BIDISPERSE, 6, .fraction = 0.5, .dimension = 3,
     .periodic = {true, false, true}, .ghosts = 0.4, .around = true},
    {"ghosts around, faces", 900, 0, CLOUD_MONO, 1, CLOUD_FACES, .edge = {14, 14, 14}, .dimension = 3,
     .periodic = {false, true, false}, .ghosts = 0.4, .around = true},
    {"ghosts around, power law", 3000, 0, CLOUD_POWER, 30, .margins = CLOUD_MARGIN_RELATIVE, .fraction = 0.4,
     .dimension = 3, .periodic = OPEN, .ghosts = 0.4, .around = true},
    {"ghosts around, discs", 1500, 9, CLOUD_BIDISPERSE, 5, .fraction = 0.5, .dimension = 2,
     .periodic = {false, true, false}, .ghosts = 0.4, .around = true},
    {"ghosts only", 100, 3, CLOUD_BIDISPERSE, 3, .fraction = 0.5, .dimension = 3, .periodic = OPEN,
     .ghosts = 1},
    {"ghosts, discs", 1000, 9, CLOUD_BIDISPERSE, 5, .fraction = 0.5, .dimension = 2,
     .periodic = {false, true, false}, .ghosts = 0.4},
};

enum { SPECS = sizeof specs / sizeof specs[0] };

/* The number of particles: all of them if SCREE_LONG is set, an eighth if SCREE_SHORT is, else a third, rounded up. */
static size_t particles_of(const struct cloud_spec *spec) {
    const size_t part = getenv("SCREE_LONG") != NULL ? 1 : getenv("SCREE_SHORT") != NULL ? 8 : 3;
    return (spec->count + part - 1) / part;
}

/* One index with one set of parameters on a cloud whose pairs brute has found: in the given order, and again
 * in the index's order. */
static void compare(struct cloud *cloud, const struct pair_set *expected, const char *name,
                    const struct index_params *params, const char *what) {
    char label[256];
    snprintf(label, sizeof label,
             "%s, %s, factor %g, levels %d, cross search %d, threads %d, instructions %d", name, what,
             params->cell_factor, params->levels, params->cross_search, cloud->view.threads,
             params->instructions);
    struct index *index = cloud_index(cloud, name, params);
    struct pair_set found;
    pair_set_collect(&found, index, &cloud->view, 3);
    pair_set_compare(expected, &found, label);
    pair_set_free(&found);
    index_destroy(&index);
}

static void all_indexes(struct cloud *cloud, const struct pair_set *expected, const char *what,
                        bool all_variants) {
    static const struct index_params variants[] = {{0},
                                                   {.cell_factor = 0.3},
                                                   {.cell_factor = 1.7},
                                                   {.cell_factor = 3},
                                                   {.levels = 1},
                                                   {.levels = 2},
                                                   {.level_cell = {2.9, 0, 7}},
                                                   {.cross_search = INDEX_CROSS_SMALLER},
                                                   {.cross_search = INDEX_CROSS_LARGER},
                                                   {.cross_search = INDEX_CROSS_LARGER, .cell_factor = 0.4},
                                                   {.instructions = INDEX_PLAIN},
                                                   {.instructions = INDEX_AVX2}};
    for (int k = 1; k < index_registry_count(); k++) {
        for (size_t v = 0; v < (all_variants ? sizeof variants / sizeof variants[0] : 1); v++) {
            bool hgrid = strcmp(index_registry_get(k)->name, "hgrid") == 0;
            if (hgrid || (variants[v].levels == 0 && variants[v].level_cell[0] == 0)) {
                compare(cloud, expected, index_registry_get(k)->name, &variants[v], what);
            }
        }
    }
}

static void brute_set(struct pair_set *set, struct cloud *cloud) {
    struct index_params params = {0};
    struct index *brute = cloud_index(cloud, "brute", &params);
    pair_set_collect(set, brute, &cloud->view, 1);
    index_destroy(&brute);
}

/* All pairs of an index in the order of the search; the caller frees both arrays. */
static struct index_sink all_pairs(const struct index *index, const struct index_view *view) {
    struct index_sink sink = {0};
    index_visit(index, view, 0, view->owned, &sink);
    sink.capacity = sink.count;
    sink.count = 0;
    sink.i = malloc((sink.capacity + INDEX_SINK_PAD) * sizeof *sink.i);
    sink.j = malloc((sink.capacity + INDEX_SINK_PAD) * sizeof *sink.j);
    index_visit(index, view, 0, view->owned, &sink);
    assert_int_equal(sink.count, sink.capacity);
    return sink;
}

/* An index that may keep data from the ordering of the particles finds the same pairs as an index that may
 * not. The sequence of the pairs is the same, too, unless a frame comes from a sample of the particles in
 * their order (outliers). */
static void build_ordered(const struct cloud *cloud, struct index *index, const struct index_params *params,
                          const struct pair_set *expected_set, const char *what) {
    char why[INDEX_WHY_MAX];
    struct index_view view = cloud->view;
    struct index *other = cloud_index(cloud, index->ops->name, params);
    struct index_sink expected = all_pairs(other, &view);
    view.ordered = true;
    index_build(index, &view);
    assert_true(index_check(index, &view, why));
    struct index_sink found = all_pairs(index, &view);
    assert_int_equal(found.count, expected.count);
    if (strstr(what, "outliers") == NULL) {
        assert_memory_equal(found.i, expected.i, expected.count * sizeof *found.i);
        assert_memory_equal(found.j, expected.j, expected.count * sizeof *found.j);
    }
    struct pair_set set;
    pair_set_collect(&set, index, &view, 3);
    pair_set_compare(expected_set, &set, what);
    pair_set_free(&set);
    free(expected.i);
    free(expected.j);
    free(found.i);
    free(found.j);
    index_destroy(&other);
}

/* Orders the cloud by the index and checks that nothing but the order changed. */
static void reordered(struct cloud *cloud, const struct pair_set *expected, const char *what) {
    struct error error = {0};
    struct index_params params = {0};
    uint32_t *order = malloc((cloud->view.owned + 1) * sizeof *order);
    for (int k = 1; k < index_registry_count(); k++) {
        const char *name = index_registry_get(k)->name;
        struct index *index = index_create(name, &params, &error);
        for (int again = 0; again < 2; again++) {
            struct index_view owned = cloud->view;
            owned.total = owned.owned;
            index_order(index, &owned, order);
            index_cloud_reorder(cloud, order);
            build_ordered(cloud, index, &params, expected, what);
        }
        index_destroy(&index);
        compare(cloud, expected, name, &params, what);
    }
    free(order);
}

static void run_spec(const struct cloud_spec *spec, bool newton) {
    struct cloud_spec variant = *spec;
    variant.newton = newton;
    variant.count = particles_of(spec);
    struct cloud cloud;
    index_cloud_make(&cloud, &variant);
    struct pair_set expected;
    brute_set(&expected, &cloud);
    all_indexes(&cloud, &expected, spec->name, true);
    cloud.view.threads = 2;
    reordered(&cloud, &expected, spec->name);
    cloud.view.threads = 4;
    all_indexes(&cloud, &expected, spec->name, false);
    pair_set_free(&expected);
    index_cloud_free(&cloud);
}

static void every_index_equals_brute(void **state) {
    (void)state;
    for (size_t s = 0; s < SPECS; s++) {
        run_spec(&specs[s], true);
        if (specs[s].ghosts > 0) {
            run_spec(&specs[s], false);
        }
    }
}

/* Class pairs that are not wanted, the class with itself among them: every scene of several classes, smaller. */
static void unwanted_classes_never_meet(void **state) {
    (void)state;
    size_t pairs = 0;
    for (size_t s = 0; s < SPECS; s++) {
        for (uint64_t draw = 0; draw < 3; draw++) {
            struct cloud_spec variant = specs[s];
            variant.count = variant.count > 200 ? variant.count / 3 + 100 : variant.count;
            variant.newton = (s + draw) % 2 == 0;
            variant.unwanted = 0.2 + 0.2 * (double)draw;
            variant.seed = 100 * draw + s;
            struct cloud cloud;
            struct pair_set expected;
            index_cloud_make(&cloud, &variant);
            brute_set(&expected, &cloud);
            pairs += expected.count;
            all_indexes(&cloud, &expected, variant.name, draw == 0 && cloud.view.classes > 1);
            cloud.view.threads = 3;
            reordered(&cloud, &expected, variant.name);
            pair_set_free(&expected);
            index_cloud_free(&cloud);
        }
    }
    assert_true(pairs > 10000);
}

/* One index searches scene after scene, large and small, on few and many threads: earlier pairs found from
 * the larger side leave no trace. The largest scene has more pairs than there is room for at first. */
static void unlike_pairs_of_changing_scenes(void **state) {
    (void)state;
    static const struct cloud_spec scenes[] = {
        {"mono", 300, 0, CLOUD_MONO, 1, .fraction = 0.4, .dimension = 3, .periodic = PERIODIC},
        {"many finds", 6000, 60, CLOUD_BIDISPERSE, 10, .edge = {40, 40, 40}, .dimension = 3,
         .periodic = PERIODIC},
        {"power law", 900, 0, CLOUD_POWER, 30, .fraction = 0.5, .dimension = 3, .periodic = OPEN},
        {"discs", 500, 9, CLOUD_BIDISPERSE, 5, .fraction = 0.5, .dimension = 2,
         .periodic = {false, true, false}},
        {"mono again", 800, 0, CLOUD_MONO, 1, .fraction = 0.4, .dimension = 3, .periodic = PERIODIC},
        {"boulders", 2000, 2, CLOUD_BOULDER, 20, .fraction = 0.6, .dimension = 3, .periodic = PERIODIC},
    };
    static const int threads[] = {1, 4, 2, 5, 3, 1};
    const struct index_params params = {.cross_search = INDEX_CROSS_LARGER};
    struct error error = {0};
    struct index *index = index_create("hgrid", &params, &error);
    for (size_t round = 0; round < 2; round++) {
        for (size_t s = 0; s < sizeof scenes / sizeof scenes[0]; s++) {
            struct cloud cloud;
            struct pair_set expected, found;
            struct cloud_spec spec = scenes[s];
            spec.count = particles_of(&scenes[s]);
            index_cloud_make(&cloud, &spec);
            brute_set(&expected, &cloud);
            cloud.view.threads = threads[(s + round) % (sizeof threads / sizeof threads[0])];
            index_build(index, &cloud.view);
            pair_set_collect(&found, index, &cloud.view, 2);
            pair_set_compare(&expected, &found, scenes[s].name);
            pair_set_free(&expected);
            pair_set_free(&found);
            index_cloud_free(&cloud);
        }
    }
    index_destroy(&index);
}

/* If a CPU lacks instructions, the widest instructions of the CPU replace these instructions. */
static int say_instructions(void **state) {
    (void)state;
    static const char *const names[] = {
        [INDEX_PLAIN] = "plain", [INDEX_AVX2] = "AVX2", [INDEX_AVX512] = "AVX-512"};
    for (int k = INDEX_PLAIN; k <= INDEX_AVX512; k++) {
        if (k <= search_instructions()) {
            print_message("tested: %s instructions\n", names[k]);
        } else {
            print_message("skipped: %s instructions: this CPU lacks them\n", names[k]);
        }
    }
    return 0;
}

TEST_MAIN_GROUP(levels, say_instructions, NULL, cmocka_unit_test(every_index_equals_brute),
                cmocka_unit_test(unwanted_classes_never_meet),
                cmocka_unit_test(unlike_pairs_of_changing_scenes))
