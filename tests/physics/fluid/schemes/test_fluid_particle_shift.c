/* SPDX-License-Identifier: BSD-3-Clause */
/* Shifting: nothing on a lattice, the sum over neighbours by a double loop elsewhere, its bound, and what keeps particles off a plane. */
#include "tests/test.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "tests/physics/fluid/fluid_cloud.h"
#include "tests/near.h"
#include "physics/fluid/lattice/mirror.h"
#include "physics/fluid/schemes/particle_shift.h"

static struct weights_options options_of(const struct fluid_cloud *c) {
    return (struct weights_options){.kernel = kernel_make(KERNEL_WENDLAND_C2, c->reach, c->dimension),
                                    .spacing = c->spacing,
                                    .volume = kernel_power(c->spacing, c->dimension)};
}

/* -A dx U times the sum over all others of V W' (1 + 0.2 (W / W(dx))^4) e, at the nearest images. */
static void by_hand(const struct fluid_cloud *c, const struct kernel *kernel, size_t i, double factor,
                    double s[3]) {
    memset(s, 0, 3 * sizeof *s);
    for (size_t j = 0; j < c->particles->owned; j++) {
        double apart[3] = {0}, r = 0;
        for (int d = 0; d < c->dimension; d++) {
            apart[d] = c->particles->state[i].x[d] - c->particles->state[j].x[d];
            apart[d] -= floor(apart[d] + 0.5);
            r += apart[d] * apart[d];
        }
        r = sqrt(r);
        double pairing = 1 + 0.2 * pow(kernel_value(kernel, r) / kernel_value(kernel, c->spacing), 4);
        double part = kernel_power(c->spacing, c->dimension) * kernel_slope(kernel, r) * pairing;
        for (int d = 0; d < c->dimension && i != j; d++)
            s[d] += factor * part * apart[d] / r;
    }
}

static void shifts_are_the_sum(void **state) {
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++)
        for (int displaced = 0; displaced < 2; displaced++) {
            struct fluid_cloud c;
            fluid_cloud_make(&c, dimension, dimension == 2 ? 16 : 8, 2.3, displaced ? 0.4 : 0, 2);
            struct weights_options options = options_of(&c);
            struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
            struct particle_shift_options shift = {.strength = 0.5, .speed = 3, .most = INFINITY};
            double *drift = memory_allocate_zero(3 * w.rows, sizeof *drift, "test"), most = 0, s[3];
            particle_shift_velocity(&w, &c.input, &options, &shift, drift);
            for (size_t i = 0; i < w.rows; i++) {
                by_hand(&c, &options.kernel, i, -0.5 * c.spacing * 3, s);
                for (int d = 0; d < 3; d++)
                    assert_near(drift[3 * i + (size_t)d], displaced ? s[d] : 0, 1e-12);
                most = fmax(most, sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]));
            }
            assert_true(displaced ? most > 0.01 : most < 1e-12);
            shift.most = 0.3 * most; /* the direction stays */
            particle_shift_velocity(&w, &c.input, &options, &shift, drift);
            for (size_t i = 0; i < w.rows && displaced; i++) {
                by_hand(&c, &options.kernel, i, -0.5 * c.spacing * 3, s);
                double size = sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
                for (int d = 0; d < 3; d++)
                    assert_near(drift[3 * i + (size_t)d], s[d] * fmin(1, shift.most / size), 1e-12);
            }
            memory_free(drift);
            weights_free(&w);
            fluid_cloud_free(&c);
        }
}

static void plane(const void *context, int64_t wall, const double x[3], struct weights_foot *foot) {
    (void)context, (void)wall;
    *foot = (struct weights_foot){.distance = x[2] - 0.33, .normal = {0, 0, 1}, .velocity = {5, 0, -1}};
}

/* The lowest layer, 0.02 above a plane that sinks by 1, is to end the step of 0.1 at 0.025: with `most` at 0.03 it may go there by at
 * most 0.003 a step. A layer that is far enough off, and one that leaves by itself, get nothing. */
static void particles_are_kept_off(void **state) {
    struct fluid_cloud c;
    uint8_t *kind;
    int64_t *body;
    (void)state;
    size_t fluid = fluid_cloud_plane(&c, 0.3, &kind, &body), pushed = 0;
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    struct mirror_input input = {.rows = &c.input, .body = body, .spacing = c.spacing, .wall = plane};
    assert_int_equal(mirror_make(&w, &input), 0);
    double *drift = memory_allocate_zero(3 * c.particles->owned, sizeof *drift, "test"),
           *before = memory_allocate_zero(3 * c.particles->owned, sizeof *before, "test");
    const struct flow flow = {.weights = &w,
                              .velocity = c.particles->state[0].v,
                              .velocity_stride = sizeof *c.particles->state / sizeof(double),
                              .velocity_before = before,
                              .drift = drift};
    for (size_t i = 0; i < fluid; i++)
        c.particles->state[i].v[2] = c.particles->state[i].x[0] < 0.5 ? -1.25 : 4;
    const struct particle_shift_off off = {.least = SHIFT_LEAST * c.spacing, .most = 0.03, .dt = 0.1};
    particle_shift_keep_off(&flow, &off);
    for (size_t i = 0; i < fluid; i++) {
        const double *x = c.particles->state[i].x;
        bool near = x[2] < 0.4 && x[0] < 0.5;
        /* (0.023 - 0.02) / 0.1 - (-1.25 + 1) */
        assert_near(drift[3 * i + 2], near ? 0.28 : 0, 1e-12);
        assert_true(drift[3 * i] == 0 && drift[3 * i + 1] == 0);
        pushed += near;
    }
    assert_int_equal(pushed, 50);
    memory_free(drift);
    memory_free(before);
    memory_free(kind);
    memory_free(body);
    weights_free(&w);
    fluid_cloud_free(&c);
}

TEST_MAIN(fluid_particle_shift, cmocka_unit_test(shifts_are_the_sum),
          cmocka_unit_test(particles_are_kept_off))
