/* SPDX-License-Identifier: BSD-3-Clause */
/* The laws of sizes of packings, by the Kolmogorov-Smirnov distance from their closed forms, and the scenes that
 * the keys make. */
#include "tests/test.h"

#include "base/memory.h"
#include "data/scene/source_radii.h"
#include "front/pack/recipe.h"
#include <stdio.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { DRAWS = 40000 };

/* At DRAWS draws a right law exceeds this once in two thousand times: 2 exp(-2 x^2) = 5e-4 at x = 2.04. */
static const double distance_most = 2.04 / 200;

static bool read_recipe(struct recipe *recipe, const char *law, const char *one, const char *two,
                        struct error *error) {
    const char *setting[] = {one, two};
    return recipe_read(recipe, law, setting, one ? two ? 2 : 1 : 0, error);
}

/* The first source of a recipe. */
static const struct source_options *source_of(const struct recipe *recipe) {
    return &recipe->scene->source[0];
}

/* The edge of its cube. */
static double edge_of(const struct recipe *recipe) {
    return recipe->scene->box.edge[0];
}

/* Draws radii of the first source until they hold `volume` times its volume fraction, or `count` of them. */
static struct source_radii radii_of(const struct recipe *recipe, size_t count, double volume) {
    struct scene_share share = {.size = 1};
    struct source_wish wish = {.count = count, .volume = volume};
    struct source_radii radii;
    struct error error = {0};
    if (!source_radii_draw(recipe->scene, &share, &wish, &radii, &error))
        fail_msg("%s", error.text);
    return radii;
}

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The largest distance between the drawn radii and the part of them below r that the law says. Frees the recipe. */
static void check_law(struct recipe *recipe, double (*below)(double, const void *), const void *context) {
    struct source_radii drawn = radii_of(recipe, DRAWS, 0);
    double *radius = drawn.radius, most = 0;
    qsort(radius, DRAWS, sizeof radius[0], compare);
    for (int k = 0; k < DRAWS; k++) {
        double part = below(radius[k], context);
        most = fmax(most, fmax(fabs(part - (double)k / DRAWS), fabs(part - (k + 1.0) / DRAWS)));
    }
    memory_free(radius);
    recipe_free(recipe);
    if (!(most < distance_most))
        fail_msg("distance %g", most);
}

static void read_good(struct recipe *recipe, const char *law, const char *one, const char *two) {
    struct error error = {0};
    if (!read_recipe(recipe, law, one, two, &error))
        fail_msg("%s", error.text);
}

static double power_below(double r, const void *context) {
    const double *o = context; /* min, max, exponent */
    double n = o[2] + 1;
    return (pow(r, n) - pow(o[0], n)) / (pow(o[1], n) - pow(o[0], n));
}

static void power_laws(void **state) {
    (void)state;
    struct recipe recipe;
    read_good(&recipe, "univol", "ratio=50", NULL);
    check_law(&recipe, power_below, (double[]){1, 50, -3});
    read_good(&recipe, "power", "exponent=2", "max=4");
    check_law(&recipe, power_below, (double[]){1, 4, 2});
}

static double exponential_below(double r, const void *context) {
    const double *o = context; /* ratio, scale */
    return expm1(-(2 * r - 1) / o[1]) / expm1(-(o[0] - 1) / o[1]);
}

/* Integral of d^-3 exp(-d / scale) by Simpson's rule. */
static double mass_integral(double low, double high, double scale) {
    enum { PARTS = 400 };
    double sum = 0, step = log(high / low) / PARTS;
    for (int k = 0; k <= PARTS; k++) {
        double d = low * exp(k * step);
        sum += (k == 0 || k == PARTS ? 1 : k % 2 ? 4 : 2) * exp(-d / scale) / (d * d);
    }
    return sum * step / 3;
}

static double by_mass_below(double r, const void *context) {
    const double *o = context;
    return r <= 0.5 ? 0 : mass_integral(1, 2 * r, o[1]) / mass_integral(1, o[0], o[1]);
}

static void exponential_laws(void **state) {
    (void)state;
    struct recipe recipe;
    read_good(&recipe, "exponential", "by=number", "scale=2");
    check_law(&recipe, exponential_below, (double[]){50, 2});
    read_good(&recipe, "exponential", "by=number", "scale=200"); /* cut where much is left */
    check_law(&recipe, exponential_below, (double[]){50, 200});
    read_good(&recipe, "exponential", "scale=6", NULL);
    check_law(&recipe, by_mass_below, (double[]){50, 6});
}

/* A log-normal law cut to [2, 925]. */
static double cut_lognormal(double x, double median, double width) {
    double low = erf(log(2 / median) / width / M_SQRT2), high = erf(log(925 / median) / width / M_SQRT2);
    return (erf(log(x / median) / width / M_SQRT2) - low) / (high - low);
}

static double sand_below(double r, const void *context) {
    const double *o = context; /* ratio, broad */
    double x = 2 + (2 * r - 1) / (o[0] - 1) * 923;
    return (1 - o[1]) * cut_lognormal(x, 2.55, 0.15) + o[1] * cut_lognormal(x, 320, 0.35);
}

static void sand(void **state) {
    (void)state;
    struct recipe recipe;
    read_good(&recipe, "sand", NULL, NULL);
    assert_true(source_of(&recipe)->count == 712333 && edge_of(&recipe) == 205.9);
    check_law(&recipe, sand_below, (double[]){10, 0.05});
    read_good(&recipe, "sand", "ratio=40", "broad=0.6");
    check_law(&recipe, sand_below, (double[]){40, 0.6});
}

/* Linear in the radius between sieves of radius 0.5, 1 and 2; passing 0, 0.25 and 1. */
static double sieve_below(double r, const void *context) {
    (void)context;
    return r < 1 ? 0.25 * (r - 0.5) / 0.5 : 0.25 + 0.75 * (r - 1);
}

/* The same by mass: the number density is r^-3 times the slope. */
static double sieve_mass_below(double r, const void *context) {
    (void)context;
    double first = 0.5 * (1 / 0.25 - 1), second = 0.75 * (1 - 1 / 4.0);
    double part = r < 1 ? 0.5 * (1 / 0.25 - 1 / (r * r)) : first + 0.75 * (1 - 1 / (r * r));
    return part / (first + second);
}

static void sieve_file(char *path, const char *text) {
    int file = mkstemp(path);
    assert_true(file >= 0);
    assert_int_equal(write(file, text, strlen(text)), strlen(text));
    close(file);
}

static void sieves(void **state) {
    (void)state;
    char path[] = "/tmp/scree-sieve-XXXXXX", table[64];
    struct recipe recipe;
    sieve_file(path, "# opening, percent\n1 0\n2 25 # half way\n\n4 100\n");
    snprintf(table, sizeof table, "table=%s", path);
    read_good(&recipe, "sieve", table, "by=number");
    check_law(&recipe, sieve_below, NULL);
    read_good(&recipe, "sieve", table, NULL);
    check_law(&recipe, sieve_mass_below, NULL);
    unlink(path);
}

static void bad_sieves(void **state) {
    (void)state;
    static const char *const bad[][2] = {
        {"1 0\n2 x\n", ":2:"},      {"1 0\n2 50\n", "end with 1"}, {"2 0\n1 100\n", "increase"},
        {"1 0 3\n", "two numbers"}, {"-1 0\n2 1\n", "positive"},   {"1 0\n2000 1\n", "1000 times"},
        {"", "two radii"}};
    for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
        char path[] = "/tmp/scree-sieve-XXXXXX", table[64];
        struct recipe recipe;
        struct error error = {0};
        sieve_file(path, bad[k][0]);
        snprintf(table, sizeof table, "table=%s", path);
        bool good = read_recipe(&recipe, "sieve", table, NULL, &error);
        unlink(path);
        assert_false(good);
        assert_int_equal(error.kind, ERROR_USER);
        if (!strstr(error.text, bad[k][1]))
            fail_msg("no '%s' in: %s", bad[k][1], error.text);
    }
}

static void published_numbers(void **state) {
    (void)state;
    struct recipe recipe;
    read_good(&recipe, "bidisperse", "ratio=40", NULL);
    assert_true(edge_of(&recipe) == 500.14 && source_of(&recipe)->count == 56);
    assert_true(recipe.scene->source[1].count == 9624306 && recipe.scene->source[1].meets == SOURCE_YIELDS);
    recipe_free(&recipe);
    read_good(&recipe, "sand", "ratio=20", NULL);
    assert_true(edge_of(&recipe) == 506 && source_of(&recipe)->count == 2336380);
    recipe_free(&recipe);
    read_good(&recipe, "exponential", NULL, NULL);
    assert_true(edge_of(&recipe) == 368.77 && source_of(&recipe)->count == 5040560);
    recipe_free(&recipe);
    read_good(&recipe, "exponential", "count=630070", NULL);
    assert_true(fabs(edge_of(&recipe) - 368.77 / 2) < 1e-9);
    recipe_free(&recipe);
}

static double solid_of(const double *radius, size_t count) {
    double sum = 0;
    for (size_t k = 0; k < count; k++)
        sum += 4 * M_PI / 3 * pow(radius[k], 3);
    return sum;
}

/* As many spheres as come nearest to the solid volume: one more or one less is farther off. */
static void nearest_count(void **state) {
    (void)state;
    struct recipe recipe;
    read_good(&recipe, "power", "box=100", "fraction=0.4");
    for (int k = 0; k < 20; k++) {
        double solid = 4e5 * (1 + 0.01 * k);
        struct source_radii some = radii_of(&recipe, 0, solid / 0.4),
                            more = radii_of(&recipe, some.count + 1, 0);
        double off = fabs(solid_of(some.radius, some.count) - solid);
        assert_memory_equal(some.radius, more.radius, some.count * sizeof *some.radius);
        assert_true(off <= fabs(solid_of(some.radius, some.count - 1) - solid));
        assert_true(off <= fabs(solid_of(more.radius, more.count) - solid));
        memory_free(some.radius);
        memory_free(more.radius);
    }
    recipe_free(&recipe);
}

/* Of box, count and fraction two decide the third. */
static void two_of_three(void **state) {
    (void)state;
    struct recipe recipe;
    struct error error = {0};
    read_good(&recipe, "power", "box=30", "fraction=0.2");
    assert_true(edge_of(&recipe) == 30 && source_of(&recipe)->volume_fraction == 0.2 &&
                source_of(&recipe)->count == 0);
    recipe_free(&recipe);
    read_good(&recipe, "power", "box=30", "count=5");
    assert_true(edge_of(&recipe) == 30 && source_of(&recipe)->volume_fraction == 0 &&
                source_of(&recipe)->count == 5);
    recipe_free(&recipe);
    read_good(&recipe, "power", "count=5", "fraction=0.2"); /* the scene finds the cube */
    struct source_radii radii = radii_of(&recipe, 5, 0);
    assert_float_equal(pow(edge_of(&recipe), 3), solid_of(radii.radius, 5) / 0.2, 1e-9);
    assert_int_equal(source_of(&recipe)->count, 5);
    memory_free(radii.radius);
    recipe_free(&recipe);
    const char *all[] = {"box=3", "fraction=0.2", "count=5"};
    assert_false(recipe_read(&recipe, "power", all, 3, &error));
    assert_int_equal(error.kind, ERROR_USER);
    assert_non_null(strstr(error.text, "two decide the third"));
    recipe_free(&recipe);
}

static void bad_options(void **state) {
    (void)state;
    static const char *const bad[][4] = {{"gravel", NULL, NULL, "known are bidisperse"},
                                         {"sand", "ratio=11", NULL, "not a published system"},
                                         {"sand", "ratio=11", "count=50", "give box or fraction"},
                                         {"sand", "exponent=2", NULL, "no key of the law sand"},
                                         {"power", "min", NULL, "KEY=VALUE"},
                                         {"power", "min=", NULL, "needs a value"},
                                         {"power", "min=1e400", NULL, "sizes.min"},
                                         {"power", "fraction=0.95", NULL, "volume_fraction"},
                                         {"sand", "ratio=2000", NULL, "must lie in"},
                                         {"exponential", "scale=x", NULL, "not a number"},
                                         {"bidisperse", "large=1.5", NULL, "whole number"},
                                         {"power", "count=1.5", NULL, "whole number"},
                                         {"power", "min=3", "max=2", "above min"},
                                         {"power", "min=3", "max=3001", "1000 times"},
                                         {"power", "radius=3", NULL, "does not go with shape=cube"},
                                         {"power", "shape=sphere", NULL, "needs radius="},
                                         {"power", "shape=sphere", "box=3", "does not go with"},
                                         {"power", "shape=ball", NULL, "allowed are"},
                                         {"power", "walls=soft", NULL, "allowed are periodic, hard"},
                                         {"sieve", NULL, NULL, "give one of radii, diameters and file"},
                                         {"sieve", "table=", NULL, "needs a value"},
                                         {"bidisperse", "ratio=7", NULL, "published table"},
                                         {"bidisperse", "ratio=10", "small=70", "need a box"},
                                         {"bidisperse", "ratio=10", "box=70", "needs small"}};
    for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
        struct recipe recipe;
        struct error error = {0};
        assert_false(read_recipe(&recipe, bad[k][0], bad[k][1], bad[k][2], &error));
        assert_int_equal(error.kind, ERROR_USER);
        if (!strstr(error.text, bad[k][3]))
            fail_msg("no '%s' in: %s", bad[k][3], error.text);
    }
}

TEST_MAIN(pack_draw, cmocka_unit_test(power_laws), cmocka_unit_test(exponential_laws), cmocka_unit_test(sand),
          cmocka_unit_test(sieves), cmocka_unit_test(bad_sieves), cmocka_unit_test(published_numbers),
          cmocka_unit_test(nearest_count), cmocka_unit_test(two_of_three), cmocka_unit_test(bad_options))
