/* SPDX-License-Identifier: BSD-3-Clause */
/* Random numbers: published values, independence, moments. */
#include "tests/test.h"

#include <math.h>

#include "base/random.h"

/* The published known answers of Philox4x32-10 (kat_vectors of Random123): counter, key and the first two
 * words. */
struct known {
    uint32_t counter[4], key[2], answer[2];
};

static const struct known known_answers[] = {
    {{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d}},
    {{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}, {0x408f276d, 0x41c83b0e}},
    {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}, {0xd16cfe09, 0x94fdcceb}},
};

static void published_answers(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof known_answers / sizeof known_answers[0]; i++) {
        const struct known *known = &known_answers[i];
        struct random_sequence sequence = {
            .seed = (uint64_t)known->key[1] << 32 | known->key[0],
            .item = (uint64_t)known->counter[3] << 32 | known->counter[2],
            .stream = known->counter[1],
            .draw = known->counter[0],
        };
        uint64_t bits = (uint64_t)known->answer[1] << 32 | known->answer[0];
        assert_true(random_uniform(&sequence) == ldexp((double)(bits >> 11), -53));
    }
}

static void values_depend_on_seed_stream_item_and_draw_alone(void **state) {
    (void)state;
    struct random_sequence a = random_sequence(5, RANDOM_RADIUS, 17);
    struct random_sequence b = random_sequence(5, RANDOM_RADIUS, 17);
    double first = random_uniform(&a);
    double second = random_uniform(&a);
    assert_true(first != second);
    assert_true(random_uniform(&b) == first);
    assert_true(random_uniform(&b) == second);
    struct random_sequence others[] = {
        random_sequence(6, RANDOM_RADIUS, 17),
        random_sequence(5, RANDOM_POSITION, 17),
        random_sequence(5, RANDOM_RADIUS, 18),
        random_sequence(5, RANDOM_RADIUS, 17 + ((uint64_t)1 << 32)),
        random_sequence(5 + ((uint64_t)1 << 32), RANDOM_RADIUS, 17),
    };
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        assert_true(random_uniform(&others[i]) != first);
    }
}

/* Chi-square over 64 bins of 64000 draws, neighbouring items: 63 degrees of freedom, 120 is beyond 1e-5. */
static void uniform_fills_the_interval(void **state) {
    (void)state;
    int bins[64] = {0};
    for (uint64_t item = 0; item < 32000; item++) {
        struct random_sequence sequence = random_sequence(1, RANDOM_TEST, item);
        for (int draw = 0; draw < 2; draw++) {
            double value = random_uniform(&sequence);
            assert_true(value >= 0 && value < 1);
            bins[(int)(64 * value)]++;
        }
    }
    double chi_square = 0;
    for (int i = 0; i < 64; i++) {
        chi_square += (bins[i] - 1000.0) * (bins[i] - 1000.0) / 1000;
    }
    assert_true(chi_square > 25 && chi_square < 120);
}

/* The first four moments of 100000 draws, each within five of its standard deviations. */
static void normal_has_normal_moments(void **state) {
    (void)state;
    const int n = 100000;
    double sums[4] = {0};
    struct random_sequence sequence = random_sequence(2, RANDOM_TEST, 0);
    for (int i = 0; i < n; i++) {
        double value = random_normal(&sequence);
        assert_true(isfinite(value));
        double power = 1;
        for (int moment = 0; moment < 4; moment++) {
            power *= value;
            sums[moment] += power / n;
        }
    }
    assert_true(fabs(sums[0]) < 5 * sqrt(1.0 / n));
    assert_true(fabs(sums[1] - 1) < 5 * sqrt(2.0 / n));
    assert_true(fabs(sums[2]) < 5 * sqrt(15.0 / n));
    assert_true(fabs(sums[3] - 3) < 5 * sqrt(96.0 / n));
}

TEST_MAIN(random, cmocka_unit_test(published_answers),
          cmocka_unit_test(values_depend_on_seed_stream_item_and_draw_alone),
          cmocka_unit_test(uniform_fills_the_interval), cmocka_unit_test(normal_has_normal_moments))
