/* SPDX-License-Identifier: BSD-3-Clause */
/* Size laws against their moments and shares in closed form. */
#include "tests/test.h"

#include "data/scene/sizes_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { DRAWS = 200000 };

/* Mean of r^power over many draws; all must lie in the bounds that the law states. */
static double moment(const struct sizes_options *options, double power) {
    struct sizes_sampler sampler;
    struct error error = {0};
    if (!sizes_prepare(&sampler, options, &error))
        fail_msg("%s", error.text);
    double smallest, largest, sum = 0;
    sizes_bounds(options, &smallest, &largest);
    for (uint64_t k = 0; k < DRAWS; k++) {
        struct random_sequence random = random_sequence(7, RANDOM_RADIUS, k);
        double r = sizes_draw(&sampler, &random);
        assert_true(r >= smallest * (1 - 1e-14) && r <= largest * (1 + 1e-14));
        sum += pow(r, power);
    }
    double drawn = sum / DRAWS, stated = sizes_moment(&sampler, (int)power);
    if (power == (int)power && !(fabs(drawn - stated) <= 0.03 * stated))
        fail_msg("mean of r^%g: %.6g drawn, %.6g stated", power, drawn, stated);
    return drawn;
}

static void close_to(double value, double expected, double relative) {
    if (!(fabs(value - expected) <= relative * fabs(expected)))
        fail_msg("%.6g instead of %.6g", value, expected);
}

static void simple_laws(void **state) {
    (void)state;
    struct sizes_options fixed = {.law = SIZES_FIXED, .radius = 3};
    close_to(moment(&fixed, 1), 3, 1e-12);
    struct sizes_options uniform = {.law = SIZES_UNIFORM, .min = 1, .max = 3};
    close_to(moment(&uniform, 1), 2, 5e-3);
    close_to(moment(&uniform, 2), 13.0 / 3, 5e-3);
    struct sizes_options normal = {.law = SIZES_NORMAL, .mean = 5, .sigma = 0.5, .min = 2, .max = 8};
    close_to(moment(&normal, 1), 5, 2e-3);
    close_to(moment(&normal, 2) - 25, 0.25, 5e-2);
    /* cut at the mean: the half-normal's mean is mean + sigma sqrt(2 / pi) */
    struct sizes_options half = {.law = SIZES_NORMAL, .mean = 5, .sigma = 0.5, .min = 5, .max = 9};
    close_to(moment(&half, 1), 5 + 0.5 * sqrt(2 / M_PI), 2e-3);
    struct sizes_options lognormal = {.law = SIZES_LOGNORMAL, .mean = 2, .width = 0.3, .min = 0.1, .max = 40};
    close_to(moment(&lognormal, 1), 2 * exp(0.045), 5e-3);
}

/* f ~ r^a: the mean of r^n is ratio of two integrals. */
static void power_laws(void **state) {
    (void)state;
    double exponents[] = {-3, -1, 0, 1.5};
    for (int k = 0; k < 4; k++) {
        double a = exponents[k];
        struct sizes_options power = {.law = SIZES_POWER, .min = 1, .max = 4, .exponent = a};
        double norm = a == -1 ? log(4) : (pow(4, a + 1) - 1) / (a + 1);
        double first = (pow(4, a + 2) - 1) / (a + 2);
        close_to(moment(&power, 1), first / norm, 5e-3);
    }
    /* r^-4 by number is r^-1 by volume: half of the mass lies below the geometric mean */
    struct sizes_options power = {.law = SIZES_POWER, .min = 1, .max = 4, .exponent = -4};
    struct sizes_sampler sampler;
    struct error error = {0};
    assert_true(sizes_prepare(&sampler, &power, &error));
    double below = 0, all = 0;
    for (uint64_t k = 0; k < DRAWS; k++) {
        struct random_sequence random = random_sequence(3, RANDOM_RADIUS, k);
        double r = sizes_draw(&sampler, &random);
        below += r < 2 ? r * r * r : 0;
        all += r * r * r;
    }
    close_to(below / all, 0.5, 2e-2);
}

/* Part of the mass (power 3) or number (power 0) of draws below each radius. */
static double share_below(const struct sizes_options *options, double radius, double power) {
    struct sizes_sampler sampler;
    struct error error = {0};
    assert_true(sizes_prepare(&sampler, options, &error));
    double below = 0, all = 0;
    for (uint64_t k = 0; k < DRAWS; k++) {
        struct random_sequence random = random_sequence(5, RANDOM_RADIUS, k);
        double r = sizes_draw(&sampler, &random), weight = pow(r, power);
        below += r < radius ? weight : 0;
        all += weight;
    }
    return below / all;
}

/* A sieve curve comes back when the drawn particles are sieved, between the sieves too. */
static void sieve_curves(void **state) {
    (void)state;
    struct sizes_options table = {.law = SIZES_TABLE,
                                  .by = SIZES_BY_MASS,
                                  .points = 4,
                                  .values = 4,
                                  .radii = {1, 1.5, 2, 4},
                                  .share = {0, 0.3, 0.3, 1}};
    close_to(share_below(&table, 1.5, 3), 0.3, 2e-2);
    close_to(share_below(&table, 1.25, 3), 0.15, 3e-2);
    close_to(share_below(&table, 2, 3), 0.3, 2e-2);
    close_to(share_below(&table, 3, 3), 0.65, 2e-2);
    table.by = SIZES_BY_NUMBER;
    close_to(share_below(&table, 1.5, 0), 0.3, 1e-2);
    close_to(share_below(&table, 3, 0), 0.65, 1e-2);
    struct sizes_options discrete = {.law = SIZES_DISCRETE,
                                     .by = SIZES_BY_NUMBER,
                                     .points = 3,
                                     .values = 3,
                                     .radii = {3, 1, 2},
                                     .share = {2, 6, 2}};
    close_to(share_below(&discrete, 1.5, 0), 0.6, 1e-2);
    discrete.by = SIZES_BY_MASS;
    close_to(share_below(&discrete, 1.5, 3), 0.6, 2e-2);
    close_to(share_below(&discrete, 2.5, 3), 0.8, 2e-2);
}

/* A file of this text; the caller removes it. */
static void sizes_file(struct sizes_options *options, const char *text) {
    snprintf(options->file, sizeof options->file, "/tmp/scree-sizes-XXXXXX");
    int number = mkstemp(options->file);
    assert_true(number >= 0);
    FILE *file = fdopen(number, "w");
    fputs(text, file);
    fclose(file);
}

/* Radii or diameters, parts or per cent, listed or in a file: the same options, to the bit. */
static void forms_agree(void **state) {
    (void)state;
    static const char *const texts[] = {"# mm, %\n1 0\n3 25\n8 100\n",
                                        "radius passing\n0.5 0\n1.5 0.25\n4 1\n",
                                        "diameter passing\n1 0\n3 25 # a sieve\n8 100\n"};
    struct sizes_options wanted = {.law = SIZES_TABLE,
                                   .points = 3,
                                   .values = 3,
                                   .radii = {1, 3, 8},
                                   .share = {0, 0.25, 1},
                                   .file_unit = 1};
    struct sizes_options form[5] = {
        {.law = SIZES_TABLE, .points = 3, .values = 3, .radii = {1, 3, 8}, .share = {0, 25, 100}},
        {.law = SIZES_TABLE, .diameters = 3, .values = 3, .diameter = {2, 6, 16}, .share = {0, 0.25, 1}}};
    for (int k = 0; k < 5; k++) {
        struct error error = {0};
        bool in_file;
        char path[SIZES_PATH_MAX] = "";
        form[k].law = SIZES_TABLE;
        form[k].file_unit = 2;
        if (k >= 2) {
            sizes_file(&form[k], texts[k - 2]);
            memcpy(path, form[k].file, sizeof path);
        }
        if (!sizes_file_complete(&form[k], &in_file, &error))
            fail_msg("%d: %s", k, error.text);
        assert_memory_equal(&form[k], &wanted, sizeof wanted);
        if (path[0])
            unlink(path);
    }
}

/* Forms that cannot be meant. */
static void forms_refused(void **state) {
    (void)state;
    static const struct {
        struct sizes_options options;
        const char *text, *says; /* text: of the file */
    } cases[] = {
        {{.law = SIZES_TABLE, .values = 1}, NULL, "one of radii, diameters and file"},
        {{.law = SIZES_TABLE, .points = 1, .diameters = 1, .values = 1}, NULL, "one of radii, diameters"},
        {{.law = SIZES_TABLE, .diameters = 1}, NULL, "passing is missing beside diameters"},
        {{.law = SIZES_DISCRETE, .values = 1}, "1 2\n", "weights beside file"},
        {{.law = SIZES_DISCRETE}, "radius passing\n1 2\n", ":1: must hold two numbers"},
        {{.law = SIZES_TABLE}, "1 0\n2 -1\n", ":2: what passes"},
    };
    for (size_t k = 0; k < sizeof(cases) / sizeof(cases[0]); k++) {
        struct sizes_options options = cases[k].options;
        struct error error = {0};
        bool in_file;
        char path[SIZES_PATH_MAX];
        if (cases[k].text)
            sizes_file(&options, cases[k].text);
        memcpy(path, options.file, sizeof path);
        assert_false(sizes_file_complete(&options, &in_file, &error));
        assert_true(in_file == (cases[k].says[0] == ':'));
        if (!strstr(error.text, cases[k].says))
            fail_msg("case %zu: %s", k, error.text);
        if (cases[k].text)
            unlink(path);
    }
}

static void refuses(void **state) {
    (void)state;
    static const struct {
        struct sizes_options options;
        const char *says;
    } cases[] = {
        {{.law = SIZES_TABLE, .points = 1, .values = 1}, "two radii"},
        {{.law = SIZES_TABLE, .points = 2, .values = 2, .radii = {2, 1}, .share = {0, 1}}, "must increase"},
        {{.law = SIZES_TABLE, .points = 3, .values = 3, .radii = {1, 2, 3}, .share = {0, 0.6, 0.5}},
         "must not fall"},
        {{.law = SIZES_TABLE, .points = 2, .values = 2, .radii = {1, 2}, .share = {0.1, 1}}, "begin with 0"},
        {{.law = SIZES_DISCRETE, .points = 2, .values = 2, .radii = {1, 2}, .share = {0, 0}},
         "all weights are 0"},
        {{.law = SIZES_UNIFORM, .min = 2, .max = 2}, "is not above"},
        {{.law = SIZES_LOGNORMAL, .min = 10, .max = 20, .mean = 1, .width = 0.1}, "lies between"},
    };
    for (size_t k = 0; k < sizeof(cases) / sizeof(cases[0]); k++) {
        struct sizes_sampler sampler;
        struct error error = {0};
        assert_false(sizes_prepare(&sampler, &cases[k].options, &error));
        if (!strstr(error.text, cases[k].says))
            fail_msg("case %zu: %s", k, error.text);
    }
}

/* The balls around bodies: all radii, bounds and moments by one factor. */
static void balls(void **state) {
    struct sizes_options law = {.law = SIZES_LOGNORMAL, .min = 0.5, .max = 2, .mean = 1, .width = 0.3},
                         ball = law;
    struct sizes_sampler plain, grown;
    struct error error = {0};
    (void)state;
    ball.ball = 1.5;
    assert_true(sizes_prepare(&plain, &law, &error) && sizes_prepare(&grown, &ball, &error));
    for (uint64_t k = 0; k < 100; k++) {
        struct random_sequence one = random_sequence(7, RANDOM_RADIUS, k), two = one;
        close_to(sizes_draw(&grown, &two), 1.5 * sizes_draw(&plain, &one), 1e-15);
    }
    close_to(moment(&ball, 3), 3.375 * moment(&law, 3), 1e-12);
    double least, most;
    sizes_bounds(&ball, &least, &most);
    close_to(least, 0.75, 1e-15);
    close_to(most, 3, 1e-15);
}

TEST_MAIN(sizes, cmocka_unit_test(simple_laws), cmocka_unit_test(power_laws), cmocka_unit_test(sieve_curves),
          cmocka_unit_test(refuses), cmocka_unit_test(forms_agree), cmocka_unit_test(forms_refused),
          cmocka_unit_test(balls))
