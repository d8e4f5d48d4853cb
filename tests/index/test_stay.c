/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles that move and stay in their slots: the pairs are those of brute force, however far they move and wherever
 * they cross the box; and the particles are sorted again when that pays. */
#include "tests/test.h"

#include "base/random.h"
#include "tests/index/index_cloud.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PERIODIC                                                                                             \
    { true, true, true }

static const struct cloud_spec specs[] = {
    {"mono", 500, 0, CLOUD_MONO, 1, .fraction = 0.5, .dimension = 3, .periodic = PERIODIC},
    {"mono, slab", 500, 0, CLOUD_MONO, 1, .fraction = 0.4, .dimension = 3, .periodic = {true, false, true}},
    {"mono, discs", 300, 0, CLOUD_MONO, 1, .fraction = 0.6, .dimension = 2, .periodic = {true, true, false}},
    {"mono, open", 500, 0, CLOUD_MONO, 1, .fraction = 0.4, .dimension = 3, .periodic = {false, false, false}},
    {"nearly empty", 200, 0, CLOUD_MONO, 1, .fraction = 1e-7, .dimension = 3, .periodic = PERIODIC},
    {"bidisperse 4", 900, 6, CLOUD_BIDISPERSE, 4, .fraction = 0.05, .dimension = 3, .periodic = PERIODIC},
    {"bidisperse 4, relative margins", 900, 6, CLOUD_BIDISPERSE, 4, .margins = CLOUD_MARGIN_RELATIVE,
     .fraction = 0.05, .dimension = 3, .periodic = {false, true, true}},
    {"power law 4", 500, 0, CLOUD_POWER, 4, .fraction = 0.2, .dimension = 3, .periodic = PERIODIC},
    {"power law 4, one class", 500, 0, CLOUD_ONE_CLASS, 4, .fraction = 0.2, .dimension = 3,
     .periodic = PERIODIC},
    {"thin in x", 300, 0, CLOUD_MONO, 1, .edge = {4.5, 20, 20}, .dimension = 3, .periodic = PERIODIC},
    {"ghosts around", 700, 0, CLOUD_MONO, 1, .fraction = 0.3, .dimension = 3,
     .periodic = {false, true, false}, .ghosts = 0.3, .around = true, .newton = true},
    {"ghosts among the others", 700, 6, CLOUD_BIDISPERSE, 4, .fraction = 0.05, .dimension = 3,
     .periodic = {true, false, true}, .ghosts = 0.3},
    {"faces and twins", 300, 3, CLOUD_BIDISPERSE, 3, CLOUD_FACES, .edge = {40, 40, 40}, .dimension = 3,
     .periodic = PERIODIC},
};
enum { SPECS = sizeof specs / sizeof specs[0], BUILDS = 5 };

/* Moves each particle by up to `far` in each direction, and back into the box. */
static void stir(struct cloud *cloud, double far, uint64_t step) {
    for (size_t k = 0; k < cloud->view.total; k++) {
        double *x = cloud->record + k * cloud->view.stride;
        struct random_sequence random = random_sequence(step, RANDOM_TEST, (uint64_t)cloud->id[k]);
        for (int d = 0; d < cloud->view.dimension; d++) {
            const double edge = cloud->view.edge[d];
            x[d] += far * (2 * random_uniform(&random) - 1);
            if (cloud->view.periodic[d]) {
                x[d] -= x[d] >= edge ? edge : x[d] < 0 ? -edge : 0;
            }
        }
    }
}

static void brute_set(struct pair_set *set, const struct cloud *cloud) {
    const struct index_params params = {0};
    struct index *brute = cloud_index(cloud, "brute", &params);
    pair_set_collect(set, brute, &cloud->view, 1);
    index_destroy(&brute);
}

static void compare(const struct pair_set *expected, const struct cloud *cloud, const struct index *index,
                    const char *what) {
    struct pair_set found;
    char why[INDEX_WHY_MAX] = "";
    if (!index_check(index, &cloud->view, why)) {
        fail_msg("%s: %s", what, why);
    }
    pair_set_collect(&found, index, &cloud->view, 3);
    pair_set_compare(expected, &found, what);
    pair_set_free(&found);
}

/* Where the ghosts are. */
static struct index_around around_of(const struct index_view *view) {
    struct index_around around = {.known = view->total > view->owned,
                                  .low = {INFINITY, INFINITY, INFINITY},
                                  .high = {-INFINITY, -INFINITY, -INFINITY}};
    for (size_t k = view->owned; k < view->total; k++) {
        for (int d = 0; d < 3; d++) {
            double x = view->position[k * view->stride + (size_t)d];
            around.low[d] = fmin(around.low[d], x);
            around.high[d] = fmax(around.high[d], x);
        }
    }
    return around;
}

/* Orders, or lets the index keep the order, and builds. True if the particles stayed. */
static bool rebuild(struct cloud *cloud, struct index *index, bool may_stay) {
    const struct index_around around = around_of(&cloud->view);
    uint32_t *order = malloc((cloud->view.owned + 1) * sizeof *order);
    struct index_view owned = cloud->view, view = cloud->view;
    bool stays = may_stay && index_stays(index, &view);
    owned.total = owned.owned;
    owned.around = around;
    if (!stays) {
        index_order(index, &owned, order);
        index_cloud_reorder(cloud, order);
    }
    free(order);
    view.ordered = true;
    index_build(index, &view);
    return stays;
}

/* A cloud on its way: the pairs after each of the moves. */
struct way {
    const struct cloud_spec *spec;
    double far;
    struct pair_set expected[BUILDS];
};

static void way_make(struct way *way, const struct cloud_spec *spec, double far) {
    struct cloud cloud;
    *way = (struct way){.spec = spec, .far = far};
    index_cloud_make(&cloud, spec);
    for (uint64_t step = 0; step < BUILDS; step++) {
        brute_set(&way->expected[step], &cloud);
        stir(&cloud, far, step);
    }
    index_cloud_free(&cloud);
}

static void way_free(struct way *way) {
    for (int step = 0; step < BUILDS; step++) {
        pair_set_free(&way->expected[step]);
    }
}

/* Goes the way with an index; returns how often the particles stayed. */
static int stays_on(const struct way *way, const char *name, const struct index_params *params) {
    struct error error = {0};
    struct cloud cloud;
    char what[256];
    int stays = 0;
    index_cloud_make(&cloud, way->spec);
    cloud.view.threads = 2;
    struct index *index = index_create(name, params, &error);
    for (uint64_t step = 0; step < BUILDS; step++) {
        snprintf(what, sizeof what,
                 "%s, %s, factor %g, cross search %d, instructions %d, moves of %g, build %d",
                 way->spec->name, name, params->cell_factor, params->cross_search, params->instructions,
                 way->far, (int)step);
        stays += rebuild(&cloud, index, step > 0);
        compare(&way->expected[step], &cloud, index, what);
        stir(&cloud, way->far, step);
    }
    index_destroy(&index);
    index_cloud_free(&cloud);
    return stays;
}

static void pairs_after_moves_equal_brute(void **state) {
    static const struct index_params variants[] = {{0},
                                                   {.cross_search = INDEX_CROSS_SMALLER, .cell_factor = 0.6},
                                                   {.cross_search = INDEX_CROSS_LARGER, .cell_factor = 0.6},
                                                   {.instructions = INDEX_PLAIN},
                                                   {.instructions = INDEX_AVX2}};
    static const double far[] = {0.02, 0.3, 1.9};
    (void)state;
    for (size_t s = 0; s < SPECS; s++) {
        for (size_t m = 0; m < sizeof far / sizeof far[0]; m++) {
            struct way way;
            way_make(&way, &specs[s], far[m]);
            for (int k = 1; k < index_registry_count(); k++) {
                for (size_t v = 0; v < sizeof variants / sizeof variants[0]; v++) {
                    stays_on(&way, index_registry_get(k)->name, &variants[v]);
                }
            }
            way_free(&way);
        }
    }
}

static int stays_of(const struct cloud_spec *spec, const char *name, double far) {
    const struct index_params params = {0};
    struct way way;
    way_make(&way, spec, far);
    int stays = stays_on(&way, name, &params);
    way_free(&way);
    return stays;
}

/* Short moves cost no sort, long ones do; particles that have not moved stay for ever. */
static void a_sort_comes_when_it_pays(void **state) {
    (void)state;
    assert_int_equal(stays_of(&specs[0], "bytype", 0), BUILDS - 1);
    assert_int_equal(stays_of(&specs[0], "bytype", 0.002), BUILDS - 1);
    assert_in_range(stays_of(&specs[0], "bytype", 0.1), 1, BUILDS - 2);
    assert_int_equal(stays_of(&specs[0], "linkcell", 0), BUILDS - 1);
    assert_int_equal(stays_of(&specs[5], "hgrid", 0.002), BUILDS - 1);
    assert_int_equal(stays_of(&specs[7], "bytype", 0.002), BUILDS - 1);
    assert_int_equal(stays_of(&specs[0], "multi", 0), 0);  /* its stencils begin in the cell of the row */
    assert_int_equal(stays_of(&specs[9], "bytype", 0), 0); /* two images of a pair are too near */
    assert_int_equal(stays_of(&specs[10], "bytype", 0.002), BUILDS - 1);
    assert_int_equal(stays_of(&specs[11], "hgrid", 0.002), BUILDS - 1);
    assert_int_equal(stays_of(&specs[0], "brute", 1.9), BUILDS - 1);
}

/* Without the caller's word that the particles lie as at the last build, they are sorted. */
static void other_particles_are_sorted(void **state) {
    const struct index_params params = {0};
    struct error error = {0};
    struct cloud cloud;
    (void)state;
    index_cloud_make(&cloud, &specs[0]);
    struct index *index = index_create("bytype", &params, &error);
    assert_false(rebuild(&cloud, index, true)); /* there was no build */
    assert_false(rebuild(&cloud, index, false));
    assert_true(rebuild(&cloud, index, true));
    cloud.view.edge[1] += 0.5;
    assert_false(rebuild(&cloud, index, true)); /* another box */
    struct pair_set expected;
    brute_set(&expected, &cloud);
    compare(&expected, &cloud, index, "another box");
    pair_set_free(&expected);
    index_destroy(&index);
    index_cloud_free(&cloud);
}

TEST_MAIN(stay, cmocka_unit_test(pairs_after_moves_equal_brute), cmocka_unit_test(a_sort_comes_when_it_pays),
          cmocka_unit_test(other_particles_are_sorted))
