/* SPDX-License-Identifier: BSD-3-Clause */
/* The links of a scalar beside a plane: a linear one has no diffusion and its flux, with a value or a slope given there; closed walls
 * let nothing through; upwind links are not negative. */
#include "tests/test.h"

#include <math.h>

#include "base/memory.h"
#include "tests/physics/fluid/fluid_cloud.h"
#include "tests/near.h"
#include "physics/fluid/carried/scalar_links.h"
#include "physics/fluid/lattice/mirror.h"

static const double rise = 1.7, base = 0.4, diffusivity = 2.5;

static void planes(const void *context, int64_t wall, const double x[3], struct weights_foot *foot) {
    (void)context, (void)wall;
    bool below = x[2] < 0.55;
    *foot =
        (struct weights_foot){.distance = below ? x[2] - 0.3 : 0.8 - x[2], .normal = {0, 0, below ? 1 : -1}};
}

struct room {
    struct fluid_cloud cloud;
    struct weights weights;
    uint8_t *kind;
    int64_t *body;
    size_t fluid, feet;
    double *value, *given, *slope, *out;
};

/* The fluid between z = 0.3 and 0.8, c = base + rise (z - 0.3). */
static void room_make(struct room *r) {
    r->fluid = fluid_cloud_plane(&r->cloud, 0.3, &r->kind, &r->body);
    for (size_t k = 0; k < r->cloud.particles->owned; k++)
        r->body[k] = body_of_wall(fmod(r->cloud.particles->state[k].x[2] + 0.45, 1) < 0.5);
    r->weights = fluid_cloud_weigh(&r->cloud, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    struct mirror_input input = {
        .rows = &r->cloud.input, .body = r->body, .spacing = r->cloud.spacing, .wall = planes};
    assert_int_equal(mirror_make(&r->weights, &input), 0);
    r->feet = r->weights.foot_start[r->weights.rows];
    r->value = memory_allocate_zero(r->cloud.particles->owned, sizeof *r->value, "test");
    r->given = memory_allocate(r->feet, sizeof *r->given, "test");
    r->slope = memory_allocate(r->feet, sizeof *r->slope, "test");
    r->out = memory_allocate(r->fluid, sizeof *r->out, "test");
    for (size_t k = 0; k < r->feet; k++) {
        bool below = r->weights.foot[k].normal[2] > 0;
        r->given[k] = below ? base : base + 0.5 * rise;
        r->slope[k] = below ? rise : -rise; /* into the fluid */
    }
    for (size_t i = 0; i < r->fluid; i++)
        r->value[i] = base + rise * (r->cloud.particles->state[i].x[2] - 0.3);
}

static void room_free(struct room *r) {
    memory_free(r->value);
    memory_free(r->given);
    memory_free(r->slope);
    memory_free(r->out);
    memory_free(r->kind);
    memory_free(r->body);
    weights_free(&r->weights);
    fluid_cloud_free(&r->cloud);
}

static void a_linear_scalar_has_its_flux(void **state) {
    (void)state;
    for (int sloped = 0; sloped < 2; sloped++) {
        struct room r;
        room_make(&r);
        for (size_t k = 0; k < r.feet && sloped; k++)
            r.given[k] = NAN;
        const struct links links = {.weights = &r.weights,
                                    .diffusivity = diffusivity,
                                    .given = r.given,
                                    .slope = r.slope,
                                    .input = &r.cloud.input};
        double(*flux)[3] = memory_allocate(r.fluid, sizeof *flux, "test");
        scalar_links_apply(&links, r.value, r.out);
        scalar_links_flux(&links, r.value, flux);
        for (size_t i = 0; i < r.fluid; i++) {
            assert_near(r.out[i], 0, 1e-9);
            bool walls = r.weights.wall_start[i + 1] > r.weights.wall_start[i];
            assert_near(flux[i][2] / (diffusivity * rise), -1, walls ? 0.01 : 1e-10);
            assert_near(flux[i][0], 0, 1e-9);
        }
        memory_free(flux);
        room_free(&r);
    }
}

/* Without values and slopes nothing goes through a wall: of a constant, and, as links are symmetric, of the sum of any scalar. */
static void closed_walls_let_nothing_through(void **state) {
    struct room r;
    double sum = 0, size = 0;
    (void)state;
    room_make(&r);
    for (size_t k = 0; k < r.feet; k++)
        r.given[k] = NAN;
    const struct links links = {.weights = &r.weights, .diffusivity = diffusivity, .given = r.given};
    for (size_t i = 0; i < r.fluid; i++)
        r.value[i] = sin(7.0 * (double)i);
    scalar_links_apply(&links, r.value, r.out);
    for (size_t i = 0; i < r.fluid; i++) {
        sum += r.out[i];
        size += fabs(r.out[i]);
    }
    assert_true(size > 1000);
    assert_near(sum / size, 0, 1e-12);
    room_free(&r);
}

/* Upwind links are those of the central ones with a diffusion |a| more: none is negative, whatever the flow carries. */
static void upwind_links_are_not_negative(void **state) {
    struct room r;
    (void)state;
    room_make(&r);
    size_t entries = r.weights.start[r.weights.rows];
    double *carry = memory_allocate(entries, sizeof *carry, "test");
    for (size_t e = 0; e < entries; e++)
        carry[e] = 1e5 * sin(3.0 * (double)e);
    struct links links = {
        .weights = &r.weights, .diffusivity = diffusivity, .carry = carry, .upwind = true, .given = r.given};
    for (size_t i = 0; i < r.fluid; i++)
        r.value[i] = 0;
    r.value[r.fluid / 2] = 1; /* all others gain, and it loses */
    for (size_t k = 0; k < r.feet; k++)
        r.given[k] = 0;
    scalar_links_apply(&links, r.value, r.out);
    for (size_t i = 0; i < r.fluid; i++)
        assert_true(i == r.fluid / 2 ? r.out[i] < 0 : r.out[i] >= 0);
    memory_free(carry);
    room_free(&r);
}

/* Where grains fill particles whole nothing diffuses into them or out of them; half filled ones have half of the links; the sum stays. */
static void nothing_diffuses_into_grains(void **state) {
    struct room r;
    double sum = 0, size = 0, half = 0;
    (void)state;
    room_make(&r);
    double *filled = memory_allocate_zero(r.cloud.particles->owned, sizeof *filled, "test");
    struct links links = {.weights = &r.weights, .diffusivity = diffusivity, .given = r.given};
    for (size_t k = 0; k < r.feet; k++)
        r.given[k] = NAN;
    for (size_t i = 0; i < r.fluid; i++)
        r.value[i] = sin(7.0 * (double)i);
    scalar_links_apply(&links, r.value, r.out);
    for (size_t i = 0; i < r.fluid; i++) {
        half += fabs(r.out[i]);
        filled[i] = 0.5;
    }
    links.filled = filled;
    scalar_links_apply(&links, r.value, r.out);
    for (size_t i = 0; i < r.fluid; i++) {
        half -= 2 * fabs(r.out[i]);
        filled[i] = i % 3 == 0 ? 1 : 0.3;
    }
    assert_near(half, 0, 1e-6);
    scalar_links_apply(&links, r.value, r.out);
    for (size_t i = 0; i < r.fluid; i++) {
        if (i % 3 == 0)
            assert_near(r.out[i], 0, 0);
        sum += r.out[i];
        size += fabs(r.out[i]);
    }
    assert_true(size > 100);
    assert_near(sum / size, 0, 1e-12);
    memory_free(filled);
    room_free(&r);
}

TEST_MAIN(fluid_scalar_links, cmocka_unit_test(a_linear_scalar_has_its_flux),
          cmocka_unit_test(closed_walls_let_nothing_through), cmocka_unit_test(upwind_links_are_not_negative),
          cmocka_unit_test(nothing_diffuses_into_grains))
