/* SPDX-License-Identifier: BSD-3-Clause */
/* Feet and mirror coefficients beside a plane that turns, behind it, beside a body that is bent around the fluid, and beside a lone particle. */
#include "tests/test.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "tests/physics/fluid/fluid_cloud.h"
#include "tests/near.h"
#include "physics/fluid/lattice/mirror.h"

static const double spin[3] = {0.4, -0.2, 0.9};
static double height;

static void plane(const void *context, int64_t wall, const double x[3], struct weights_foot *foot) {
    (void)wall;
    *foot = (struct weights_foot){.distance = x[2] - height, .normal = {0, 0, 1}};
    if (context != NULL)
        memcpy(foot->spin, context, sizeof foot->spin);
}

struct room {
    struct fluid_cloud cloud;
    struct weights weights;
    uint8_t *kind;
    int64_t *body;
    size_t fluid;
};

static void room_make(struct room *r) {
    r->fluid = fluid_cloud_plane(&r->cloud, 0.3, &r->kind, &r->body);
    r->weights = fluid_cloud_weigh(&r->cloud, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
}

static void room_free(struct room *r) {
    memory_free(r->kind);
    memory_free(r->body);
    weights_free(&r->weights);
    fluid_cloud_free(&r->cloud);
}

static double place(const struct room *r, size_t row, size_t entry, int d) {
    double apart[3];
    weights_apart(&r->weights, &r->cloud.input, row, entry, apart);
    return r->cloud.particles->state[r->weights.first + row].x[d] + apart[d];
}

/* One foot a row; beta = d_j / d_i below the plane, 0 for what is not behind it; the turn is spin x (x_j - x_i). */
static void a_plane_mirrors_depths(void **state) {
    struct room r;
    size_t behind = 0;
    (void)state;
    height = 0.31;
    room_make(&r);
    struct mirror_input input = {
        .rows = &r.cloud.input, .body = r.body, .spacing = r.cloud.spacing, .wall = plane, .context = spin};
    assert_int_equal(mirror_make(&r.weights, &input), 0);
    assert_int_equal(r.weights.opens + r.weights.behind, 0);
    for (size_t row = 0; row < r.fluid; row++) {
        size_t e = weights_walls(&r.weights, row), first = r.weights.wall_start[row],
               end = r.weights.wall_start[row + 1];
        const double *x = r.cloud.particles->state[row].x;
        assert_int_equal(r.weights.foot_start[row + 1] - r.weights.foot_start[row], end > first);
        for (size_t k = first; k < end; k++, e++) {
            double depth = fmax(height - place(&r, row, e, 2), 0), apart[3], up = x[2] - height;
            assert_near(weights_foot_of(&r.weights, k)->distance, up, 1e-12);
            assert_near(r.weights.mirror[k], depth / up, 1e-9 * (1 + depth / up));
            behind += depth > 0;
            weights_apart(&r.weights, &r.cloud.input, row, e, apart);
            for (int d = 0; d < 3; d++)
                assert_near(weights_turn(&r.weights, k, d),
                            spin[(d + 1) % 3] * apart[(d + 2) % 3] - spin[(d + 2) % 3] * apart[(d + 1) % 3],
                            1e-12);
        }
    }
    assert_true(behind > 1000);
    room_free(&r);
}

/* A particle a spacing behind the surface is counted, and is one at WEIGHTS_NEAREST above it; one less than half a spacing behind
 * is not counted. Without a spin nothing turns. */
static void what_lies_behind_is_counted(void **state) {
    (void)state;
    for (int deep = 0; deep < 2; deep++) {
        struct room r;
        size_t rows = 0;
        room_make(&r);
        height = deep ? 0.45 : 0.38; /* the lowest layers stand at 0.35 and 0.45 */
        struct mirror_input input = {
            .rows = &r.cloud.input, .body = r.body, .spacing = r.cloud.spacing, .wall = plane};
        assert_int_equal(mirror_make(&r.weights, &input), 0);
        for (size_t row = 0; row < r.fluid; row++) {
            if (r.weights.foot_start[row + 1] == r.weights.foot_start[row])
                continue;
            double up = r.cloud.particles->state[row].x[2] - height;
            rows += up < -MIRROR_BEHIND * r.cloud.spacing;
            assert_near(r.weights.foot[r.weights.foot_start[row]].distance,
                        fmax(up, WEIGHTS_NEAREST * r.cloud.spacing), 1e-12);
        }
        assert_int_equal(r.weights.behind, rows);
        assert_int_equal(rows, deep ? 100 : 0);
        assert_null(r.weights.turn);
        room_free(&r);
    }
}

/* Boundary particles that stand alone are walls themselves: a foot each, at their place, with beta 0. */
static void a_lone_particle_is_its_own_wall(void **state) {
    struct room r;
    (void)state;
    room_make(&r);
    for (size_t k = 0; k < r.cloud.particles->owned; k++)
        r.body[k] = BODY_NONE;
    struct mirror_input input = {.rows = &r.cloud.input, .body = r.body, .spacing = r.cloud.spacing};
    assert_int_equal(mirror_make(&r.weights, &input), 0);
    for (size_t row = 0; row < r.fluid; row++) {
        size_t e = weights_walls(&r.weights, row), k = r.weights.wall_start[row];
        double apart[3];
        if (k == r.weights.wall_start[row + 1])
            continue;
        weights_apart(&r.weights, &r.cloud.input, row, e, apart);
        double distance = sqrt(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]);
        const struct weights_foot *foot = weights_foot_of(&r.weights, k);
        assert_near(foot->distance, distance, 1e-12);
        for (int d = 0; d < 3; d++)
            assert_near(foot->normal[d], -apart[d] / distance, 1e-12);
    }
    room_free(&r);
}

TEST_MAIN(fluid_mirror, cmocka_unit_test(a_plane_mirrors_depths),
          cmocka_unit_test(what_lies_behind_is_counted), cmocka_unit_test(a_lone_particle_is_its_own_wall))
