/* SPDX-License-Identifier: BSD-3-Clause */
/* Packings: what they promise, against brute force. Everything is made in full by pack_make. */
#include "tests/test.h"

#include "front/pack/pack.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SETTINGS_MAX = 8 };

/* Settings in one text, separated by blanks. */
static bool make(const char *law, const char *settings, struct rows *rows, struct pack_report *report,
                 struct error *error) {
    char text[256];
    const char *setting[SETTINGS_MAX];
    int n = 0;
    struct recipe recipe;
    snprintf(text, sizeof text, "%s", settings);
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " "))
        setting[n++] = word;
    bool good = recipe_read(&recipe, law, setting, n, error) && pack_make(&recipe, NULL, rows, report, error);
    recipe_free(&recipe);
    return good;
}

static void make_good(const char *law, const char *settings, struct rows *rows, struct pack_report *report) {
    struct error error = {0};
    if (!make(law, settings, rows, report, &error))
        fail_msg("%s %s: %s", law, settings, error.text);
}

/* The largest overlap by all pairs, relative to the smaller radius; <= 0: none. */
static double overlap_by_all(const struct rows *rows) {
    double largest = -INFINITY;
    for (size_t i = 0; i < rows->count; i++)
        for (size_t j = 0; j < i; j++) {
            double square = 0;
            for (int c = 0; c < 3; c++) {
                double d = fabs(rows->position[i][c] - rows->position[j][c]);
                d = rows->periodic[c] ? fmin(d, rows->upper[c] - d) : d;
                square += d * d;
            }
            double overlap = rows->radius[i] + rows->radius[j] - sqrt(square);
            largest = fmax(largest, overlap / fmin(rows->radius[i], rows->radius[j]));
        }
    return largest;
}

static void check_places(const struct rows *rows) {
    for (size_t k = 0; k < rows->count; k++) {
        assert_int_equal(rows->id[k], k + 1);
        for (int c = 0; c < 3; c++) {
            double room = rows->periodic[c] ? 0 : rows->radius[k];
            assert_true(rows->position[k][c] >= room && rows->position[k][c] <= rows->upper[c] - room);
        }
    }
}

/* No overlap, all inside, and the stated solid fraction. */
static void check_packing(const char *law, const char *settings, double fraction) {
    struct rows rows;
    struct pack_report report;
    double solid = 0;
    make_good(law, settings, &rows, &report);
    check_places(&rows);
    double overlap = overlap_by_all(&rows);
    assert_true(overlap <= 1e-12);
    assert_true(report.packed.overlap == 0);
    for (size_t k = 0; k < rows.count; k++)
        solid += 4 * M_PI / 3 * pow(rows.radius[k], 3);
    solid /= rows.upper[0] * rows.upper[1] * rows.upper[2];
    assert_true(fabs(solid - report.fraction) < 1e-12);
    if (fraction > 0)
        assert_true(fabs(solid - fraction) < 1e-9);
    rows_free(&rows);
}

static void nothing_overlaps(void **state) {
    (void)state;
    check_packing("univol", "count=1500 ratio=10 fraction=0.1", 0.1);
    check_packing("univol", "count=1500 ratio=10 fraction=0.55 walls=hard", 0.55);
    check_packing("univol", "count=1500 ratio=10 fraction=0.55 walls=periodic", 0.55);
    check_packing("power", "count=1500 min=1 max=3 exponent=1 fraction=0.5", 0.5);
    check_packing("sand", "count=1500", 0);
    check_packing("exponential", "count=3000", 0);
    check_packing("power", "count=1500 min=0.001 max=0.0011 fraction=0.56 threads=3", 0.56);
}

/* An L of three cubes of edge `edge`, one high: its triangles, nine numbers a row. */
static void write_prism(const char *path, double edge) {
    static const int square[3][4][2] = {
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 0}, {2, 0}, {2, 1}, {1, 1}}, {{0, 1}, {1, 1}, {1, 2}, {0, 2}}};
    static const int loop[8][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}};
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    for (int k = 0; k < 12; k++) { /* floor and lid */
        int order[3] = {0, 1 + k % 2, 2 + k % 2}, lid = k / 2 % 2;
        for (int c = 0; c < 3; c++) {
            const int *at = square[k / 4][order[lid ? c : 2 - c]];
            fprintf(file, "%g %g %g ", edge * at[0], edge * at[1], edge * lid);
        }
        fprintf(file, "\n");
    }
    for (int k = 0; k < 8; k++) {
        const int *a = loop[k], *b = loop[(k + 1) % 8];
        fprintf(file, "%g %g 0 %g %g 0 %g %g %g\n", edge * a[0], edge * a[1], edge * b[0], edge * b[1],
                edge * b[0], edge * b[1], edge);
        fprintf(file, "%g %g 0 %g %g %g %g %g %g\n", edge * a[0], edge * a[1], edge * b[0], edge * b[1], edge,
                edge * a[0], edge * a[1], edge);
    }
    fclose(file);
}

/* How far a sphere lies inside of a container by closed forms, less its radius. */
static double inside_cylinder(const double x[3], double r) {
    return fmin(12 - hypot(x[0], x[1]), fmin(x[2], 30 - x[2])) - r;
}
static double inside_sphere(const double x[3], double r) {
    return 14 - sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) - r;
}
static double inside_box(const double x[3], double r) {
    static const double edge[3] = {20, 15, 30};
    double least = INFINITY;
    for (int c = 0; c < 3; c++)
        least = fmin(least, fmin(x[c], edge[c] - x[c]));
    return least - r;
}
static double inside_prism(const double x[3], double r) {
    double least = fmin(x[2], 12 - x[2]), corner = hypot(fmax(12 - x[0], 0), fmax(12 - x[1], 0));
    for (int c = 0; c < 2; c++)
        least = fmin(least, fmin(x[c], 24 - x[c]));
    return fmin(least, corner) - r;
}

static void fills_containers(void **state) {
    (void)state;
    static const struct {
        const char *settings;
        double volume, (*inside)(const double x[3], double r);
    } cases[] = {
        {"shape=cylinder radius=12 length=30 fraction=0.55 max=2", M_PI * 144 * 30, inside_cylinder},
        {"shape=sphere radius=14 fraction=0.55 max=2", 4 * M_PI / 3 * 14 * 14 * 14, inside_sphere},
        {"shape=box edges=20,15,30 fraction=0.5 max=2 walls=hard", 9000, inside_box},
        {"shape=mesh file=test_pack_prism.txt fraction=0.5 max=2", 3 * 12 * 12 * 12, inside_prism},
        {"shape=mesh file=test_pack_prism.txt count=200 max=2", 3 * 12 * 12 * 12, inside_prism},
    };
    write_prism("test_pack_prism.txt", 12);
    for (size_t m = 0; m < sizeof cases / sizeof cases[0]; m++) {
        struct rows rows;
        struct pack_report report;
        double solid = 0, largest = 0, least = INFINITY;
        make_good("power", cases[m].settings, &rows, &report);
        for (size_t k = 0; k < rows.count; k++) {
            double volume = 4 * M_PI / 3 * pow(rows.radius[k], 3);
            solid += volume;
            largest = fmax(largest, volume);
            least = fmin(least, cases[m].inside(rows.position[k], rows.radius[k]));
            for (int c = 0; c < 3; c++)
                assert_true(rows.position[k][c] > rows.lower[c] && rows.position[k][c] < rows.upper[c]);
        }
        if (!(least > -1e-9))
            fail_msg("%s: a sphere is out by %g", cases[m].settings, -least);
        assert_true(overlap_by_all(&rows) <= 1e-12);
        assert_true(report.packed.overlap == 0);
        assert_true(fabs(solid / cases[m].volume - report.fraction) < 1e-6);
        const char *wanted = strstr(cases[m].settings, "fraction=");
        if (wanted) /* the last sphere makes it no nearer */
            assert_true(fabs(solid - strtod(wanted + 9, NULL) * cases[m].volume) <= largest);
        else
            assert_int_equal(rows.count, 200);
        rows_free(&rows);
    }
    remove("test_pack_prism.txt");
}

/* A bound on the overlap is kept, and used: the first packing that meets it is taken. */
static void overlap_bound(void **state) {
    (void)state;
    struct rows rows;
    struct pack_report report;
    make_good("power", "count=1000 max=2 fraction=0.55 overlap=0.05", &rows, &report);
    double overlap = overlap_by_all(&rows);
    assert_true(overlap > 0 && overlap <= 0.05);
    assert_true(fabs(overlap - report.packed.overlap) < 1e-12);
    rows_free(&rows);
}

static void bidisperse(void **state) {
    (void)state;
    struct rows rows;
    struct pack_report report;
    make_good("bidisperse", "ratio=5 box=25 large=4 small=1200", &rows, &report);
    check_places(&rows);
    assert_int_equal(rows.count, 1204);
    assert_int_equal(report.kinds[1], 4);
    assert_int_equal(report.kinds[0], 1200);
    for (size_t k = 0; k < rows.count; k++) {
        assert_true(rows.radius[k] == (k < 4 ? 5 : 1));
        assert_int_equal(rows.material[k], k < 4);
    }
    assert_true(overlap_by_all(&rows) <= 1e-12);
    rows_free(&rows);
    make_good("bidisperse", "ratio=5 box=25 numbers=recipe", &rows, &report);
    assert_int_equal(report.kinds[1], (int)rint(0.12 * 25 * 25 * 25 / (4 * M_PI / 3 * 125)));
    assert_int_equal(report.kinds[0] + report.packed.removed,
                     (int)rint(0.36 * 25 * 25 * 25 / (4 * M_PI / 3)));
    assert_int_equal(report.packed.thinned, 0);
    assert_true(overlap_by_all(&rows) <= 1e-12);
    rows_free(&rows);
}

/* The large sphere takes those out whose centre lies within its radius and theirs. */
static void bidisperse_removed(void **state) {
    (void)state;
    struct rows rows;
    struct pack_report report;
    make_good("bidisperse", "ratio=20 box=60 large=1 small=12000", &rows, &report);
    double started = (double)(report.kinds[0] + report.packed.removed + report.packed.thinned);
    double share = 4 * M_PI / 3 * 21 * 21 * 21 / (60.0 * 60 * 60);
    assert_true(fabs((double)report.packed.removed / started - share) < 0.03 * share);
    assert_true(started == (double)report.packed.started);
    rows_free(&rows);
}

static void same_for_any_threads(void **state) {
    (void)state;
    static const char *const made[][2] = {{"univol", "count=2500 ratio=30 fraction=0.5 velocity=2 threads="},
                                          {"bidisperse", "ratio=4 box=30 large=9 small=2500 threads="},
                                          {"power", "shape=mesh file=test_pack_prism.txt max=3 threads="}};
    static const char *const threads[] = {"1", "2", "4"};
    write_prism("test_pack_prism.txt", 15);
    for (int m = 0; m < 3; m++) {
        struct rows first = {0};
        for (int t = 0; t < 3; t++) {
            char settings[128];
            struct rows rows;
            struct pack_report report;
            snprintf(settings, sizeof settings, "%s%s", made[m][1], threads[t]);
            make_good(made[m][0], settings, t ? &rows : &first, &report);
            if (t == 0)
                continue;
            assert_int_equal(rows.count, first.count);
            assert_memory_equal(rows.position, first.position, rows.count * sizeof *rows.position);
            assert_memory_equal(rows.radius, first.radius, rows.count * sizeof *rows.radius);
            if (rows.velocity)
                assert_memory_equal(rows.velocity, first.velocity, rows.count * sizeof *rows.velocity);
            rows_free(&rows);
        }
        rows_free(&first);
    }
    remove("test_pack_prism.txt");
}

static void seeds_differ(void **state) {
    (void)state;
    struct rows rows[2];
    struct pack_report report;
    make_good("power", "count=200 fraction=0.3 seed=1", &rows[0], &report);
    make_good("power", "count=200 fraction=0.3 seed=2", &rows[1], &report);
    assert_true(memcmp(rows[0].radius, rows[1].radius, 200 * sizeof(double)) != 0);
    assert_true(memcmp(rows[0].position, rows[1].position, 200 * 3 * sizeof(double)) != 0);
    rows_free(&rows[0]);
    rows_free(&rows[1]);
}

static void velocities(void **state) {
    (void)state;
    struct rows rows;
    struct pack_report report;
    make_good("power", "count=20000 max=1.1 fraction=0.1 velocity=3 density=2", &rows, &report);
    for (int c = 0; c < 3; c++) {
        double sum = 0, square = 0;
        for (size_t k = 0; k < rows.count; k++) {
            sum += rows.velocity[k][c];
            square += rows.velocity[k][c] * rows.velocity[k][c];
        }
        assert_true(fabs(sum / 20000) < 4 * 3 / sqrt(20000));
        assert_true(fabs(square / 20000 / 9 - 1) < 4 * sqrt(2.0 / 20000));
    }
    assert_true(fabs(rows.mass[7] / pow(rows.radius[7], 3) / (8 * M_PI / 3) - 1) < 1e-14);
    rows_free(&rows);
}

static void too_dense(void **state) {
    (void)state;
    struct rows rows;
    struct pack_report report;
    struct error error = {0};
    assert_false(make("power", "count=300 max=1.01 fraction=0.75 sweeps=50", &rows, &report, &error));
    assert_int_equal(error.kind, ERROR_USER);
    assert_non_null(strstr(error.text, "50 sweeps"));
    error = (struct error){0};
    assert_false(make("power", "count=1", &rows, &report, &error));
    assert_non_null(strstr(error.text, "too small"));
    error = (struct error){0};
    assert_false(make("bidisperse", "ratio=5 box=25 large=4 small=4000", &rows, &report, &error));
    assert_non_null(strstr(error.text, "do not fit"));
    error = (struct error){0};
    assert_false(make("bidisperse", "ratio=10 box=1200 numbers=recipe", &rows, &report, &error));
    assert_int_equal(error.kind, ERROR_USER);
    assert_non_null(strstr(error.text, "too many"));
    assert_non_null(strstr(error.text, "fewer than 134217728"));
}

/* A simple cubic bed of spheres in a box twice as high: its solid fraction is pi / 6, and three quarters of it lie below three quarters of
 * its height. */
static void test_bed(void **state) {
    enum { SIDE = 8 };
    (void)state;
    const struct region region = {.shape = REGION_BOX, .upper = {2 * SIDE, 2 * SIDE, 4 * SIDE}};
    const struct region_space space = {.dimension = 3};
    struct rows rows;
    rows_create(&rows, SIDE * SIDE * SIDE, ROWS_POSITION | ROWS_RADIUS);
    for (int k = 0; k < SIDE * SIDE * SIDE; k++) {
        rows.radius[k] = 1;
        rows.position[k][0] = 1 + 2 * (k % SIDE);
        rows.position[k][1] = 1 + 2 * (k / SIDE % SIDE);
        rows.position[k][2] = 1 + 2 * (k / (SIDE * SIDE));
    }
    for (int c = 0; c < 3; c++)
        rows.upper[c] = region.upper[c];
    struct bed bed = bed_measure(&region, &space, &rows);
    assert_float_equal(bed.height, 1.5 * SIDE, 1e-9);
    assert_float_equal(bed.fraction, M_PI / 6, 1e-9);
    rows_free(&rows);
}

TEST_MAIN(pack, cmocka_unit_test(nothing_overlaps), cmocka_unit_test(fills_containers),
          cmocka_unit_test(overlap_bound), cmocka_unit_test(bidisperse), cmocka_unit_test(bidisperse_removed),
          cmocka_unit_test(seeds_differ), cmocka_unit_test(velocities),
          cmocka_unit_test(same_for_any_threads), cmocka_unit_test(too_dense), cmocka_unit_test(test_bed))
