/* SPDX-License-Identifier: BSD-3-Clause */
/* The range of a pair of materials, and that of all pairs. */
#include "tests/test.h"

#include "physics/grains/laws/law.h"
#include "base/random.h"
#include "tests/near.h"

enum { MATERIALS = 7 };

/* Pairs of materials that differ in all: bridges of a volume and of a share of the grains', attractions that are none. */
static void differ(struct random_sequence *r, struct law_material *material, struct law_pair *pair) {
    for (int m = 0; m < MATERIALS; m++)
        material[m] =
            (struct law_material){.density = 1.0, .young = 1e4 + 1e6 * random_uniform(r), .poisson = 0.3};
    for (int k = 0; k < MATERIALS * MATERIALS; k++)
        pair[k] = (struct law_pair){
            .restitution = 0.5,
            .extra = {.cohesion_jkr = {.surface_energy = random_uniform(r)},
                      .cohesion_dmt = {.surface_energy = random_uniform(r)},
                      .cohesion_sjkr = {.cohesion_density = random_uniform(r)},
                      .cohesion_capillary = {.surface_tension = k % 3 ? 0.1 : 0.0,
                                             .contact_angle = random_uniform(r),
                                             .bridge_volume = k % 4 ? 0.0 : 0.1 * random_uniform(r),
                                             .bridge_fraction = k % 4 ? 0.1 * random_uniform(r) : 0.0},
                      .cohesion_van_der_waals = {.hamaker = k % 5 ? 1.0 : 0.0,
                                                 .gap_least = 1e-3,
                                                 .cut_off = 0.01 + random_uniform(r)}}};
}

/* The largest of the ranges of all pairs, one by one. */
static double farthest(const struct law *law, double ri, double rj) {
    double most = 0.0;
    for (int a = 0; a < MATERIALS; a++)
        for (int b = 0; b < MATERIALS; b++)
            most = fmax(most, law_range_of(law, a, b, ri, rj));
    return most;
}

/* At all radii the range of all is the largest of the pairs, of whatever cohesion. */
static void test_farthest(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(3, RANDOM_TEST, 0);
    struct law_options options = law_options_default();
    for (int trial = 0; trial < 20 * LAW_COHESION_COUNT; trial++) {
        struct law_material material[MATERIALS];
        struct law_pair pair[MATERIALS * MATERIALS];
        struct law law;
        struct error error = {0};
        options.cohesion = (enum law_cohesion)(trial / 20);
        options.jkr_end = trial % 2 ? LAW_JKR_END_FORCE : LAW_JKR_END_DISTANCE;
        differ(&r, material, pair);
        if (!law_prepare(&law, &options, MATERIALS, material, pair, &error))
            fail_msg("%s", error.text);
        for (double ri = 1e-6; ri < 1e6; ri *= 30.0) {
            double far = farthest(&law, ri, INFINITY), near = farthest(&law, ri, 2.0 * ri);
            assert_near(law_range(&law, ri, INFINITY), far, 1e-14 * far);
            assert_near(law_range(&law, ri, 2.0 * ri), near, 1e-14 * near);
        }
        law_free(&law);
    }
}

/* A pair has a range of its own, whichever comes first; without materials there is none. */
static void test_pairs(void **state) {
    (void)state;
    struct law law;
    struct error error = {0};
    struct law_options options = law_options_default();
    const struct law_material materials[2] = {{.density = 1.0, .young = 1e4, .poisson = 0.3},
                                              {.density = 1.0, .young = 1e4, .poisson = 0.3}};
    struct law_pair pair[4];
    options.cohesion = LAW_COHESION_VAN_DER_WAALS;
    for (int k = 0; k < 4; k++)
        pair[k] = (struct law_pair){
            .restitution = 0.5,
            .extra.cohesion_van_der_waals = {.hamaker = 1.0, .gap_least = 1e-3, .cut_off = 0.1 + 0.1 * k}};
    assert_true(law_prepare(&law, &options, 2, materials, pair, &error));
    assert_true(law_range_of(&law, 0, 0, 1.0, INFINITY) == 0.1);
    assert_true(law_range_of(&law, 1, 0, 1.0, INFINITY) == law_range_of(&law, 0, 1, 1.0, INFINITY));
    assert_true(law_range_of(&law, 0, 1, 1.0, INFINITY) == pair[1].extra.cohesion_van_der_waals.cut_off);
    assert_true(law_range(&law, 1.0, INFINITY) == pair[3].extra.cohesion_van_der_waals.cut_off);
    law_free(&law);
    assert_true(law_prepare(&law, &options, 0, NULL, NULL, &error));
    assert_true(law_range(&law, 1.0, 1.0) == -INFINITY);
    law_free(&law);
}

TEST_MAIN(law_range, cmocka_unit_test(test_farthest), cmocka_unit_test(test_pairs))
