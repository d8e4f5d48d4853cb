/* SPDX-License-Identifier: BSD-3-Clause */
/* The public library: pairs of a cloud against all pairs. */
#include "core/random.h"
#include "scree.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

enum { SPHERES = 600 };

struct cloud {
    double position[SPHERES][3], radius[SPHERES];
    struct scree_spheres spheres;
};

static void cloud_fill(struct cloud *c) {
    for (int k = 0; k < SPHERES; k++) {
        struct random_sequence random = random_sequence(3, RANDOM_TEST, (uint64_t)k);
        for (int d = 0; d < 3; d++)
            c->position[k][d] = 12 * random_uniform(&random);
        c->radius[k] = k < 3 ? 4 : 0.2 + 0.3 * random_uniform(&random);
    }
    c->spheres =
        (struct scree_spheres){SPHERES, c->position[0], c->radius, {12, 12, 12}, {true, true, false}, 3};
}

static size_t count_all(const struct cloud *c, double margin) {
    size_t n = 0;
    for (int i = 0; i < SPHERES; i++)
        for (int j = i + 1; j < SPHERES; j++)
            for (int image = 0; image < 9; image++) {
                double shift[3] = {12 * (image % 3 - 1), 12 * (image / 3 - 1), 0}, d2 = 0;
                for (int d = 0; d < 3; d++)
                    d2 += pow(c->position[j][d] + shift[d] - c->position[i][d], 2);
                n += sqrt(d2) <= c->radius[i] + c->radius[j] + margin;
            }
    return n;
}

static void test_every_index_finds_all_pairs(void **state) {
    (void)state;
    static struct cloud c;
    const char *const names[] = {"brute", "linkcell", "multi", "bytype", "hgrid"};
    cloud_fill(&c);
    size_t all = count_all(&c, 0.1);
    assert_true(all > 300);
    for (int k = 0; k < 5; k++) {
        struct scree_pair *pairs = NULL;
        size_t found = 0;
        char why[300] = "";
        assert_true(scree_pairs(names[k], &c.spheres, 0.1, 2, &pairs, &found, why, sizeof why));
        assert_int_equal(found, all);
        for (size_t p = 0; p < found; p++) {
            double d2 = 0;
            for (int d = 0; d < 3; d++)
                d2 +=
                    pow(c.position[pairs[p].j][d] + 12.0 * pairs[p].image[d] - c.position[pairs[p].i][d], 2);
            assert_true(sqrt(d2) <= c.radius[pairs[p].i] + c.radius[pairs[p].j] + 0.1 + 1e-12);
        }
        scree_free(pairs);
    }
}

static void test_nonsense_is_refused_with_a_reason(void **state) {
    (void)state;
    static struct cloud c;
    struct scree_pair *pairs = NULL;
    size_t found = 0;
    char why[300] = "";
    cloud_fill(&c);
    assert_false(scree_pairs("octree", &c.spheres, 0.1, 1, &pairs, &found, why, sizeof why));
    assert_non_null(strstr(why, "hgrid"));
    c.radius[7] = 6;
    assert_false(scree_pairs("hgrid", &c.spheres, 0.1, 1, &pairs, &found, why, sizeof why));
    assert_non_null(strstr(why, "sphere 7"));
    c.radius[7] = NAN;
    assert_false(scree_pairs("hgrid", &c.spheres, 0.1, 1, &pairs, &found, NULL, 0));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_index_finds_all_pairs),
        cmocka_unit_test(test_nonsense_is_refused_with_a_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
