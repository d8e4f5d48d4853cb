/* SPDX-License-Identifier: BSD-3-Clause */
/* What walls and open sides do to the operators of a fluid, against closed forms. Read physics/fluid/operators/weights.h first. */
#include "tests/test.h"

#include "base/memory.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include "physics/fluid/operators/surface_forces.h"
#include "physics/fluid/lattice/mirror.h"
#include "physics/fluid/schemes/open_sides.h"
#include "tests/physics/fluid/fluid_cloud.h"
#include <math.h>
#include <string.h>
#include "tests/near.h"

static const double spin[3] = {0.7, -0.4, 1.3}, slide[3] = {0.2, 0.5, 0};

/* A plane below z = 0.31 on a body that moves by `slide` and turns by `spin` about the origin. */
static void turning(const void *context, int64_t wall, const double x[3], struct weights_foot *foot) {
    (void)context, (void)wall;
    *foot = (struct weights_foot){.distance = x[2] - 0.31, .normal = {0, 0, 1}};
    memcpy(foot->spin, spin, sizeof spin);
    for (int d = 0; d < 3; d++)
        foot->velocity[d] =
            slide[d] + spin[(d + 1) % 3] * x[(d + 2) % 3] - spin[(d + 2) % 3] * x[(d + 1) % 3];
}

/* True where a row sees no periodic side, across which a linear function jumps, and nothing of the boundary particles above. */
static bool clear_of_sides(const double x[3]) {
    return x[0] > 0.23 && x[0] < 0.77 && x[1] > 0.23 && x[1] < 0.77 && x[2] < 0.55;
}

/* A fluid that moves with a wall as one rigid body: no Laplacian, no divergence, and no force and torque on the wall; with a slip
 * length, too. */
static void test_turn(void **state) {
    (void)state;
    for (int slips = 0; slips < 2; slips++) {
        struct fluid_cloud c;
        uint8_t *kind;
        int64_t *body;
        int seen = 0;
        size_t fluid = fluid_cloud_plane(&c, 0.31, &kind, &body);
        struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
        struct mirror_input input = {.rows = &c.input, .body = body, .spacing = c.spacing, .wall = turning};
        w.slip = slips ? 0.07 : 0;
        assert_int_equal(mirror_make(&w, &input), 0);
        for (size_t k = 0; k < c.particles->owned; k++) {
            struct weights_foot foot;
            turning(NULL, 0, c.particles->state[k].x, &foot);
            memcpy(c.particles->state[k].v, foot.velocity, sizeof foot.velocity);
        }
        double(*laplacian)[3] = memory_allocate(fluid, sizeof *laplacian, "test");
        double *divergence = memory_allocate(fluid, sizeof *divergence, "test");
        double *pressure = memory_allocate_zero(c.particles->owned, sizeof *pressure, "test");
        struct surface_forces_part *part = memory_allocate(w.foot_start[w.rows], sizeof *part, "test");
        const struct flow flow = {.weights = &w,
                                  .velocity = c.particles->state[0].v,
                                  .velocity_stride = sizeof *c.particles->state / sizeof(double),
                                  .pressure = pressure};
        operators_laplacian_velocity(&w, flow_velocity(&flow), laplacian);
        operators_divergence(&w, flow_velocity(&flow), divergence);
        surface_forces_feet(&flow, 3, part);
        for (size_t i = 0; i < fluid; i++) {
            if (!clear_of_sides(c.particles->state[i].x))
                continue;
            const double lever[3] = {1, 2, 3};
            double torque[3];
            seen += w.wall_start[i + 1] > w.wall_start[i];
            assert_float_equal(divergence[i], 0, 1e-10);
            for (int d = 0; d < 3; d++)
                assert_float_equal(laplacian[i][d], 0, 1e-9);
            for (size_t k = w.foot_start[i]; k < w.foot_start[i + 1]; k++) {
                surface_forces_torque(&part[k], lever, torque);
                for (int d = 0; d < 3; d++)
                    assert_float_equal(fabs(torque[d]) + fabs(part[k].viscous[d]), 0, 1e-9);
            }
        }
        assert_true(seen > 30);
        memory_free(laplacian);
        memory_free(divergence);
        memory_free(pressure);
        memory_free(part);
        memory_free(kind);
        memory_free(body);
        weights_free(&w);
        fluid_cloud_free(&c);
    }
}

/* The couple of a flow that slips along a wall is -mu times the integral of n x v, v the slip: of the stress of a fluid that slides past it. */
static void test_couple(void **state) {
    struct fluid_cloud c;
    uint8_t *kind;
    int64_t *body;
    double couple[3] = {0};
    (void)state;
    size_t fluid = fluid_cloud_plane(&c, 0.3, &kind, &body);
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    struct mirror_input input = {.rows = &c.input, .body = body, .spacing = c.spacing, .wall = turning};
    w.slip = 1e9;
    assert_int_equal(mirror_make(&w, &input), 0);
    for (size_t k = 0; k < w.foot_start[w.rows]; k++)
        memset(w.foot[k].velocity, 0, sizeof w.foot[k].velocity);
    for (size_t k = 0; k < fluid; k++)
        memcpy(c.particles->state[k].v, (double[3]){2, -1, 0}, 3 * sizeof(double));
    double *pressure = memory_allocate_zero(c.particles->owned, sizeof *pressure, "test");
    struct surface_forces_part *part = memory_allocate(w.foot_start[w.rows], sizeof *part, "test");
    const struct flow flow = {.weights = &w,
                              .velocity = c.particles->state[0].v,
                              .velocity_stride = sizeof *c.particles->state / sizeof(double),
                              .pressure = pressure};
    surface_forces_feet(&flow, 3, part);
    for (size_t i = 0; i < fluid; i++)
        for (size_t k = w.foot_start[i]; k < w.foot_start[i + 1]; k++)
            for (int d = 0; d < 3 && c.particles->state[i].x[2] < 0.55; d++)
                couple[d] += part[k].couple[d];
    assert_float_equal(couple[0], -3, 1e-6); /* -3 (0, 0, 1) x (2, -1, 0), area 1 */
    assert_float_equal(couple[1], -6, 1e-6);
    assert_float_equal(couple[2], 0, 1e-9);
    memory_free(pressure);
    memory_free(part);
    memory_free(kind);
    memory_free(body);
    weights_free(&w);
    fluid_cloud_free(&c);
}

/* What is given at an open side z = 0.3 midway between nodes, at x. */
static const double given[3] = {1, -2, 0.5}, along[3] = {0.3, 0.8, -1.1}, rise = 1.7;
static void open_side(const void *context, int64_t side, const double x[3], struct weights_foot *foot) {
    (void)side;
    *foot = (struct weights_foot){
        .distance = x[2] - 0.3, .normal = {0, 0, 1}, .open = true, .pressed = context != NULL};
    for (int d = 0; d < 3; d++)
        foot->velocity[d] = given[d] + along[d] * x[0] * x[0];
    foot->pressure = 4;
}

/* The mirror at an open side. A given velocity that changes along the side (as the square) continues in a straight line, and the pressure does not change
 * across; at a given pressure it is the other way round. */
static void open_by(bool pressed) {
    struct fluid_cloud c;
    uint8_t *kind;
    int64_t *body;
    int seen = 0;
    size_t fluid = fluid_cloud_plane(&c, 0.3, &kind, &body);
    for (size_t k = 0; k < c.particles->owned; k++)
        body[k] = body_of_side(4);
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    struct mirror_input input = {.rows = &c.input,
                                 .body = body,
                                 .spacing = c.spacing,
                                 .wall = open_side,
                                 .context = pressed ? &c : NULL};
    assert_int_equal(mirror_make(&w, &input), 0);
    assert_true(w.opens > 0);
    double *pressure = memory_allocate_zero(c.particles->owned, sizeof *pressure, "test");
    for (size_t k = 0; k < c.particles->owned; k++) {
        const double *x = c.particles->state[k].x, across = x[2] - 0.3;
        for (int d = 0; d < 3; d++)
            c.particles->state[k].v[d] = given[d] + along[d] * x[0] * x[0] + (pressed ? 0 : rise * across);
        pressure[k] = pressed ? 4 + rise * across : 4 + rise * x[0];
    }
    const struct operators_values u = {.value = c.particles->state[0].v,
                                       .stride = sizeof *c.particles->state / sizeof(double)},
                                  p = {.value = pressure, .stride = 1, .open = 1};
    double(*laplacian)[3] = memory_allocate(fluid, sizeof *laplacian, "test"),
    (*gradient)[3] = memory_allocate(fluid, sizeof *gradient, "test");
    double *divergence = memory_allocate(fluid, sizeof *divergence, "test");
    operators_laplacian_velocity(&w, u, laplacian);
    operators_divergence(&w, u, divergence);
    operators_gradient(&w, p, gradient);
    for (size_t i = 0; i < fluid; i++) {
        if (!clear_of_sides(c.particles->state[i].x))
            continue;
        seen += w.wall_start[i + 1] > w.wall_start[i];
        assert_float_equal(divergence[i], 2 * along[0] * c.particles->state[i].x[0] + (pressed ? 0 : rise),
                           1e-10);
        for (int d = 0; d < 3; d++) {
            assert_float_equal(laplacian[i][d], 2 * along[d], 1e-9);
            assert_float_equal(gradient[i][d], d == (pressed ? 2 : 0) ? rise : 0, 1e-10);
        }
    }
    assert_true(seen > 30);
    memory_free(laplacian);
    memory_free(gradient);
    memory_free(divergence);
    memory_free(pressure);
    memory_free(kind);
    memory_free(body);
    weights_free(&w);
    fluid_cloud_free(&c);
}

static void test_open(void **state) {
    (void)state;
    open_by(false);
    open_by(true);
}

/* A parabola is one in the middle, 3/4 half-way, and 0 at the edges, in each direction along the side that does not repeat. */
static void test_parabola(void **state) {
    const struct box box = {.dimension = 3, .edge = {2, 4, 8}, .periodic = {false, false, true}};
    const struct fluid_open open = {.side = 0, .profile = FLUID_PARABOLIC, .velocity = {1, 2, 3}};
    const double share[] = {0, 0.75, 1, 0.75, 0};
    (void)state;
    for (int k = 0; k < 5; k++) {
        double velocity[3];
        open_velocity(&open, &box, (double[3]){0.3, k, 1}, velocity);
        for (int d = 0; d < 3; d++)
            assert_float_equal(velocity[d], share[k] * open.velocity[d], 1e-15);
    }
}

TEST_MAIN(fluid_walls, cmocka_unit_test(test_turn), cmocka_unit_test(test_couple),
          cmocka_unit_test(test_open), cmocka_unit_test(test_parabola))
