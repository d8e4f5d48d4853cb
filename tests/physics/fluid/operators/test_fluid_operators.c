/* SPDX-License-Identifier: BSD-3-Clause */
/* Kernels, weights and corrected operators of the fluid: normalisation, the identities of the weights on random arrangements,
 * mirrors, and errors and orders on lattices and displaced ones against measured figures of a prototype. */
#include "tests/test.h"

#include "base/memory.h"
#include "physics/fluid/lattice/mirror.h"
#include "tests/physics/fluid/fluid_cloud.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void test_kernels(void **state) {
    (void)state;
    for (int name = 0; name < KERNELS; name++)
        for (int dimension = 2; dimension <= 3; dimension++) {
            struct kernel kernel = kernel_make((enum kernel_name)name, 1.7, dimension);
            double sum = 0, slope = 0, step = 1.7 / 20000;
            for (double r = 0.5 * step; r < 1.7; r += step) {
                double shell = dimension == 2 ? 2 * M_PI * r * step : 4 * M_PI * r * r * step;
                sum += kernel_value(&kernel, r) * shell;
                slope -= r * kernel_slope(&kernel, r) / dimension * shell;
            }
            assert_float_equal(sum, 1, 1e-6);
            assert_float_equal(slope, 1, 1e-6);
            assert_true(kernel_value(&kernel, 1.7) == 0 && kernel_slope(&kernel, 1.8) == 0);
        }
}

static void test_identities(void **state) {
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++)
        for (int name = 0; name < KERNELS; name++)
            for (double chi = 0; chi < 0.9; chi += 0.4) {
                struct fluid_cloud c;
                fluid_cloud_make(&c, dimension, dimension == 2 ? 24 : 10, 3.1, chi, 2);
                struct weights w = fluid_cloud_weigh(&c, (enum kernel_name)name, WEIGHTS_CORRECTED, false);
                assert_int_equal(w.poor, 0);
                assert_true(fluid_cloud_identities(&c, &w) < 1e-11);
                weights_free(&w);
                fluid_cloud_free(&c);
            }
}

/* Rows equal those of a double loop; bits do not depend on threads; a support with four neighbours is singular. */
static void test_rows(void **state) {
    struct fluid_cloud c, other;
    (void)state;
    fluid_cloud_make(&c, 3, 9, 2.2, 0.4, 1);
    fluid_cloud_make(&other, 3, 9, 2.2, 0.4, 3);
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, false);
    struct weights v = fluid_cloud_weigh(&other, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, false);
    for (size_t i = 0; i < w.rows; i++) {
        size_t at = w.start[i];
        for (size_t j = 0; j < w.rows; j++) {
            double square = 0;
            for (int d = 0; d < 3; d++) {
                double apart = c.particles->state[j].x[d] - c.particles->state[i].x[d];
                square += pow(apart - floor(apart + 0.5), 2);
            }
            if (i == j || square >= c.reach * c.reach)
                continue;
            assert_true(at < w.start[i + 1]);
            assert_int_equal(pair_partner(w.partner[at++]), j);
        }
        assert_int_equal(at, w.start[i + 1]);
    }
    assert_int_equal(w.start[w.rows], v.start[v.rows]);
    assert_memory_equal(w.scalars, v.scalars, w.start[w.rows] * sizeof *w.scalars);
    assert_memory_equal(w.vectors, v.vectors, 3 * w.start[w.rows] * sizeof *w.vectors);
    weights_free(&w);
    weights_free(&v);
    fluid_cloud_free(&c);
    fluid_cloud_free(&other);
    fluid_cloud_make(&c, 3, 9, 1.2, 0, 1);
    w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    assert_int_equal(w.poor, w.rows);
    assert_int_equal(w.poor_first, 0);
    weights_free(&w);
    fluid_cloud_free(&c);
}

/* Two weights of a square lattice with eight neighbours: w1 + 2 w2 = 1 / dx^2, b = -b of the opposite. */
static void test_eight(void **state) {
    struct fluid_cloud c;
    (void)state;
    fluid_cloud_make(&c, 2, 10, 1.6, 0, 1);
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    double edge = 0, corner = 0, apart[3];
    for (size_t e = w.start[44]; e < w.start[45]; e++) {
        fluid_cloud_apart(&c, &w, 44, e, apart);
        bool straight = fabs(apart[0] * apart[1]) < 1e-9;
        *(straight ? &edge : &corner) += weights_scalar(&w, e) / 4;
        assert_true(weights_scalar(&w, e) > 0);
        assert_true(weights_vector(&w, e)[0] * apart[0] + weights_vector(&w, e)[1] * apart[1] > 0);
    }
    assert_int_equal(w.start[45] - w.start[44], 8);
    assert_float_equal((edge + 2 * corner) / 100, 1, 1e-12);
    weights_free(&w);
    fluid_cloud_free(&c);
}

static void within(double value, double expected, double part) {
    if (!(fabs(value - expected) <= part * expected))
        fail_msg("%.4g instead of %.4g", value, expected);
}

static void test_convergence(void **state) {
    (void)state;
    struct fluid_cloud_errors coarse = fluid_cloud_errors(2, 32, 3.1, 0, WEIGHTS_CORRECTED),
                              fine = fluid_cloud_errors(2, 128, 3.1, 0, WEIGHTS_CORRECTED);
    within(coarse.gradient, 2.57e-2, 0.02);
    within(coarse.laplacian, 1.29e-2, 0.02);
    within(fine.gradient, 1.62e-3, 0.02);
    within(fine.laplacian, 8.11e-4, 0.02);
    assert_true(log2(coarse.gradient / fine.gradient) / 2 >= 1.95);
    assert_true(log2(coarse.laplacian / fine.laplacian) / 2 >= 1.95);
    fine = fluid_cloud_errors(2, 128, 3.1, 0.2, WEIGHTS_CORRECTED);
    within(fine.gradient, 2.00e-3, 0.1);
    within(fine.laplacian, 1.41e-3, 0.1);
    fine = fluid_cloud_errors(3, 40, 2.8, 0.4, WEIGHTS_CORRECTED);
    within(fine.gradient, 2.09e-2, 0.1);
    within(fine.laplacian, 1.14e-2, 0.1);
    coarse = fluid_cloud_errors(2, 32, 3.1, 0.2, WEIGHTS_STANDARD);
    fine = fluid_cloud_errors(2, 128, 3.1, 0.2, WEIGHTS_STANDARD);
    within(coarse.laplacian, 1.6e-1, 0.15);
    within(fine.laplacian, 6.0e-1, 0.15);
}

/* Second order on the other lattices, too, which are stretched to fit the unit square and cube; identities on both. */
static void test_lattices(void **state) {
    static const struct {
        enum fluid_arrangement arrangement;
        int dimension, side;
        double reach;
        size_t neighbours;
    } rows[] = {{FLUID_HEXAGONAL, 2, 32, 2.4, 18}, {FLUID_BCC, 3, 12, 1.95, 26}, {FLUID_FCC, 3, 12, 2.1, 42}};
    (void)state;
    for (int k = 0; k < 3; k++) {
        struct fluid_cloud_errors error[2];
        double finer = 1; /* by which the stretched steps are shorter */
        for (int fine = 0; fine < 2; fine++) {
            struct fluid_cloud c;
            fluid_cloud_make_on(&c, rows[k].arrangement, rows[k].dimension, (1 + fine) * rows[k].side,
                                rows[k].reach, 0, 2);
            struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, false);
            assert_true(fluid_cloud_identities(&c, &w) < 1e-11);
            assert_int_equal(w.start[w.rows], rows[k].neighbours * w.rows);
            weights_free(&w);
            finer = pow((double)c.particles->owned, 1.0 / c.dimension) / (fine ? finer : 1);
            error[fine] = fluid_cloud_errors_of(&c, WEIGHTS_CORRECTED);
        }
        print_message("lattice %d: %.3g %.3g, then %.3g %.3g\n", k, error[0].gradient, error[0].laplacian,
                      error[1].gradient, error[1].laplacian);
        assert_true(log(error[0].gradient / error[1].gradient) / log(finer) >= 1.95);
        assert_true(log(error[0].laplacian / error[1].laplacian) / log(finer) >= 1.95);
    }
}

/* A plane below z = 0.31 whose normal is z: the mirrored operators of a velocity that is linear in the distance and
 * vanishes at the plane are exact; so is its divergence. */
static void plane(const void *context, int64_t wall, const double x[3], struct weights_foot *foot) {
    (void)context, (void)wall;
    *foot = (struct weights_foot){.distance = x[2] - 0.31, .normal = {0, 0, 1}, .velocity = {0.25, 0, 0}};
}

static struct operators_values velocity_of(const struct fluid_cloud *c) {
    return (struct operators_values){.value = c->particles->state[0].v,
                                     .stride = sizeof *c->particles->state / sizeof(double)};
}

static void test_mirror(void **state) {
    struct fluid_cloud c;
    uint8_t *kind;
    int64_t *body;
    (void)state;
    size_t fluid = fluid_cloud_plane(&c, 0.31, &kind, &body);
    for (size_t k = 0; k < c.particles->owned; k++) {
        double v[3] = {0.25 + 3 * (c.particles->state[k].x[2] - 0.31), 0,
                       2 * (c.particles->state[k].x[2] - 0.31)};
        memcpy(c.particles->state[k].v, v, sizeof v);
    }
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    struct mirror_input input = {.rows = &c.input, .body = body, .spacing = c.spacing, .wall = plane};
    assert_int_equal(mirror_make(&w, &input), 0);
    assert_true(w.wall_start[w.rows] > 1000);
    double *divergence = memory_allocate(fluid, sizeof *divergence, "test");
    double(*laplacian)[3] = memory_allocate(fluid, sizeof *laplacian, "test");
    struct operators_values u = velocity_of(&c);
    operators_divergence(&w, u, divergence);
    operators_laplacian_velocity(&w, u, laplacian);
    int near = 0, far = 0;
    for (size_t i = 0; i < fluid; i++) {
        double height = c.particles->state[i].x[2] - 0.31;
        if (height > 0.3) /* the other side is not linear */
            continue;
        near += height < 0.2;
        far += height >= 0.2;
        assert_float_equal(laplacian[i][0], 0, 1e-9);
        assert_float_equal(laplacian[i][2], 0, 1e-9);
        bool capped = false;
        for (size_t k = w.wall_start[i]; k < w.wall_start[i + 1]; k++)
            capped = capped || w.mirror[k] > WEIGHTS_MIRROR_CAP;
        if (!capped)
            assert_float_equal(divergence[i], 2, 1e-10);
    }
    assert_true(near == 200 && far > 0);
    memory_free(divergence);
    memory_free(laplacian);
    memory_free(kind);
    memory_free(body);
    weights_free(&w);
    fluid_cloud_free(&c);
}

/* Sums of u . inertia and of its size, over all rows. */
static void work_of(const struct fluid_cloud *c, const struct weights *w, double viscosity, double sum[2]) {
    double(*out)[3] = memory_allocate(w->rows, sizeof *out, "test");
    operators_inertia(w, &(struct operators_stream){velocity_of(c), velocity_of(c), 0.5}, viscosity, out);
    sum[0] = sum[1] = 0;
    for (size_t i = 0; i < w->rows; i++)
        for (int d = 0; d < 3; d++) {
            double work = c->particles->state[i].v[d] * out[i][d];
            sum[0] += work;
            sum[1] += fabs(work);
        }
    memory_free(out);
}

/* Velocities at random, which are anything but free of divergence. */
static void stir(struct fluid_cloud *c) {
    for (size_t k = 0; k < c->particles->owned; k++)
        for (int d = 0; d < 3; d++)
            c->particles->state[k].v[d] =
                d < c->dimension ? sin(12.9898 * (double)(3 * k + (size_t)d + 1) * (double)(k + 2)) : 0;
}

/* A volume flow that is anything but free of divergence carries a velocity: of div (g u) no momentum gets lost on a lattice, and its work on u is half
 * of the sum of u^2 div g. */
static void test_stream(void **state) {
    struct fluid_cloud c;
    (void)state;
    fluid_cloud_make(&c, 3, 10, 2.3, 0, 2);
    stir(&c);
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    double(*g)[3] = memory_allocate(w.rows, sizeof *g, "test"), sum[3] = {0}, size = 0, work[2] = {0};
    double(*out)[3] = memory_allocate(w.rows, sizeof *out, "test");
    double *divergence = memory_allocate(w.rows, sizeof *divergence, "test");
    for (size_t i = 0; i < w.rows; i++)
        for (int d = 0; d < 3; d++)
            g[i][d] = cos(7.233 * (double)(i + 1) * (d + 2));
    const struct operators_values flow = {.value = g[0], .stride = 3};
    operators_inertia(&w, &(struct operators_stream){flow, velocity_of(&c), 1}, 0, out);
    operators_divergence(&w, flow, divergence);
    for (size_t i = 0; i < w.rows; i++)
        for (int d = 0; d < 3; d++) {
            double u = c.particles->state[i].v[d];
            sum[d] += out[i][d];
            size += fabs(out[i][d]);
            work[0] += u * out[i][d];
            work[1] += 0.5 * u * u * divergence[i];
        }
    for (int d = 0; d < 3; d++)
        assert_true(fabs(sum[d]) < 1e-12 * size && size > 10);
    assert_true(fabs(work[0] - work[1]) < 1e-12 * size);
    memory_free(g);
    memory_free(out);
    memory_free(divergence);
    weights_free(&w);
    fluid_cloud_free(&c);
}

static void rest(const void *context, int64_t wall, const double x[3], struct weights_foot *foot) {
    plane(context, wall, x, foot);
    memset(foot->velocity, 0, sizeof foot->velocity);
}

/* Inertia makes no kinetic energy of any velocity, on lattices and beside a wall at rest; without viscosity it takes some beside the wall. */
static void test_energy(void **state) {
    struct fluid_cloud c;
    uint8_t *kind;
    int64_t *body;
    double sum[2];
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++) {
        fluid_cloud_make(&c, dimension, 12, 2.3, 0, 2);
        stir(&c);
        struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
        work_of(&c, &w, 0, sum);
        assert_true(fabs(sum[0]) < 1e-12 * sum[1] && sum[1] > 10);
        weights_free(&w);
        fluid_cloud_free(&c);
    }
    fluid_cloud_plane(&c, 0.31, &kind, &body);
    stir(&c);
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    struct mirror_input input = {.rows = &c.input, .body = body, .spacing = c.spacing, .wall = rest};
    assert_int_equal(mirror_make(&w, &input), 0);
    work_of(&c, &w, 1e6, sum);
    assert_true(fabs(sum[0]) < 1e-12 * sum[1] && sum[1] > 10);
    work_of(&c, &w, 0, sum);
    assert_true(sum[0] > 1e-2 * sum[1]);
    memory_free(kind);
    memory_free(body);
    weights_free(&w);
    fluid_cloud_free(&c);
}

/* Relative error of the inertia of Taylor and Green's vortices, -grad p = pi (sin 4 pi x, sin 4 pi y). */
static double inertia_error(int side, double chi) {
    struct fluid_cloud c;
    double gap = 0, size = 0;
    fluid_cloud_make(&c, 2, side, 3.1, chi, 2);
    for (size_t k = 0; k < c.particles->owned; k++) {
        const double *x = c.particles->state[k].x;
        double v[3] = {sin(2 * M_PI * x[0]) * cos(2 * M_PI * x[1]),
                       -cos(2 * M_PI * x[0]) * sin(2 * M_PI * x[1]), 0};
        memcpy(c.particles->state[k].v, v, sizeof v);
    }
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, chi == 0);
    double(*out)[3] = memory_allocate(w.rows, sizeof *out, "test");
    operators_inertia(&w, &(struct operators_stream){velocity_of(&c), velocity_of(&c), 0.5}, 0, out);
    for (size_t i = 0; i < w.rows; i++)
        for (int d = 0; d < 2; d++) {
            double exact = M_PI * sin(4 * M_PI * c.particles->state[i].x[d]);
            gap += pow(out[i][d] - exact, 2);
            size += exact * exact;
        }
    memory_free(out);
    weights_free(&w);
    fluid_cloud_free(&c);
    return sqrt(gap / size);
}

static void test_inertia(void **state) {
    (void)state;
    double coarse = inertia_error(32, 0), fine = inertia_error(128, 0), displaced = inertia_error(128, 0.2);
    print_message("inertia: %.3g, %.3g, displaced %.3g\n", coarse, fine, displaced);
    assert_true(log2(coarse / fine) / 2 >= 1.95 && fine < 1e-2);
    assert_true(displaced < 2 * fine);
}

TEST_MAIN(fluid_operators, cmocka_unit_test(test_kernels), cmocka_unit_test(test_identities),
          cmocka_unit_test(test_rows), cmocka_unit_test(test_eight), cmocka_unit_test(test_convergence),
          cmocka_unit_test(test_lattices), cmocka_unit_test(test_mirror), cmocka_unit_test(test_energy),
          cmocka_unit_test(test_stream), cmocka_unit_test(test_inertia))
