/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains in which the flow is rigid: the edge, the gain and its integrals, the equations of a grain. */
#include "tests/test.h"

#include <math.h>
#include <string.h>

#include "kernel/particles/kinds.h"
#include "physics/fluid/coupling/rigid_grains.h"
#include "physics/fluid/coupling/solid_field.h"
#include "tests/near.h"

/* 1 inside, 0 outside, one half at the surface, and odd about it; the gain leaves 0 and 1, and is phi with kappa 1. */
static void the_edge_and_the_gain(void **state) {
    (void)state;
    assert_near(solid_edge(-1), 1, 0);
    assert_near(solid_edge(1), 0, 0);
    assert_near(solid_edge(0), 0.5, 1e-15);
    for (double s = -0.9; s < 1; s += 0.3)
        assert_near(solid_edge(s) + solid_edge(-s), 1, 1e-15);
    for (double kappa = 0.1; kappa < 9; kappa *= 3) {
        assert_near(solid_gain(0, kappa), 0, 0);
        assert_near(solid_gain(1, kappa), 1, 0);
    }
    assert_near(solid_gain(0.3, 1), 0.3, 1e-15);
    assert_near(solid_gain(0.5, 3), 0.25, 1e-15);
    assert_near(solid_kappa(0.5, 2, 0.01), 0.1 * 0.25 / 0.02, 1e-12);
    assert_near(solid_kappa(0.5, 2, 1e-6), SOLID_KAPPA_MOST, 0);
}

/* With kappa 1 the integrals of phi have closed forms: with t = (r - R) / e, a mean of r^n over the edge. In two dimensions
 * pi (R^2 + e^2 (1 - 8 / pi^2)), as the integral of -phi' t^2 is 1 - 8 / pi^2. */
static void the_integrals_of_the_gain(void **state) {
    double volume, moment, e = SOLID_EDGE * 0.25, square = e * e * (1 - 8 / (M_PI * M_PI));
    (void)state;
    solid_mean(1, 0.25, 1, 2, &volume, &moment);
    assert_near(volume, M_PI * (1 + square), 1e-4);
    solid_mean(1, 0.25, 1, 3, &volume, &moment);
    assert_near(volume, 4.0 / 3 * M_PI * (1 + 3 * square), 1e-3);
    solid_mean(1, 1e-6, 1, 3, &volume, &moment);
    assert_near(moment, 0.4 * 4.0 / 3 * M_PI, 1e-5);
    solid_mean(1, 1e-6, 1, 2, &volume, &moment);
    assert_near(moment, 0.5 * M_PI, 1e-5);
}

/* A grain whose fluid moves rigidly, and that has its own momentum of the same motion, keeps it. */
static void a_rigid_motion_stays(void **state) {
    const double motion[6] = {0.3, -1.2, 0.7, 2, -0.4, 1.1};
    double momentum[6] = {0}, found[6];
    struct rigid_grains_sums sums = {0};
    struct rigid_grains_own own = {
        .mass = 2.5, .inertia = {0.7, 0.9, 0.8, 0.1, -0.05, 0.02}, .dimension = 3, .turns = true};
    double spin[3];
    (void)state;
    for (int k = 0; k < 40; k++) {
        double arm[3] = {sin(3.1 * k), cos(1.7 * k), sin(0.9 * k + 1)}, mass = 0.1 + 0.05 * (k % 7), v[3];
        rigid_grains_add(&sums, mass, arm);
        rigid_grains_velocity(motion, arm, v);
        for (int d = 0; d < 3; d++) {
            int next = (d + 1) % 3, last = (d + 2) % 3;
            momentum[d] += mass * v[d];
            momentum[3 + d] += mass * (arm[next] * v[last] - arm[last] * v[next]);
        }
    }
    rigid_grains_momentum(&sums, motion, found);
    rigid_grains_spin(own.inertia, motion + 3, spin);
    assert_near(spin[0], 0.7 * 2 + 0.02 * -0.4 - 0.05 * 1.1, 1e-12);
    for (int d = 0; d < 6; d++) {
        assert_near(found[d], momentum[d], 1e-12);
        momentum[d] += d < 3 ? own.mass * motion[d] : spin[d - 3];
    }
    rigid_grains_solve(&sums, &own, momentum, found);
    for (int d = 0; d < 6; d++)
        assert_near(found[d], motion[d], 1e-12);
    own.turns = false; /* then the mass alone counts, and nothing turns */
    rigid_grains_solve(&sums, &own, momentum, found);
    assert_near(found[0], momentum[0] / (sums.mass + own.mass), 1e-12);
    assert_near(found[4], 0, 0);
    own = (struct rigid_grains_own){.mass = 2.5, .inertia = {0.7, 0.7, 0.7}, .dimension = 2, .turns = true};
    rigid_grains_solve(&sums, &own, momentum, found);
    assert_true(found[2] == 0 && found[3] == 0 && found[4] == 0 && found[5] != 0);
}

static void pair_rows_of(struct pair_rows *rows, size_t *start, uint32_t *partner) {
    rows->start = start;
    rows->partner = partner;
}

/* Two grains that overlap at a node share its gain, which is not above 1. */
static void grains_share_a_node(void **state) {
    struct particle_state places[3] = {{.x = {0.5, 0.5}, .radius = 0.05},
                                       {.x = {0.2, 0.5}, .radius = 0.3},
                                       {.x = {0.8, 0.5}, .radius = 0.3}};
    const uint8_t kind[3] = {KIND_FLUID, KIND_GRAIN, KIND_GRAIN};
    const double none[1][4] = {{0}};
    uint32_t partner[2] = {1, 2};
    size_t start[2] = {0, 2};
    struct pair_rows rows = {0};
    struct solid_field solid = {0};
    double filled[1];
    (void)state;
    pair_rows_of(&rows, start, partner);
    solid_pairs_take(&solid, &rows, kind, 0, 1);
    assert_int_equal(solid.pairs, 2);
    const struct solid_places at = {
        .state = places, .shift = none, .spacing = 0.1, .kappa = 2, .hydraulic = 1, .dimension = 2};
    solid_field_make(&solid, &at, 1, filled);
    assert_int_equal(solid.nodes, 1);
    assert_int_equal(solid.parts, 2);
    assert_near(filled[0], 1, 1e-12);
    assert_near(solid.part[0].share + solid.part[1].share, 1, 1e-12);
    assert_near(solid.part[0].arm[0], 0.3, 1e-15);
    assert_near(solid.part[1].arm[0], -0.3, 1e-15);
    places[2].x[0] = 2; /* far away: the node is half a grain's, with the gain of kappa */
    solid_field_make(&solid, &at, 1, filled);
    assert_int_equal(solid.parts, 1);
    assert_near(filled[0], 0.5, 1e-12);
    assert_near(solid.part[0].share, 0.5 / (0.5 + 2 * 0.5), 1e-12);
    solid_field_free(&solid);
}

/* Parts of walls come among those of grains, by row: nodes 1 and 2 are a grain's, 0, 1 and 3 a wall's. */
static void grains_and_walls_share_nodes(void **state) {
    struct particle_state places[5] = {
        {.x = {0, 0}}, {.x = {0.5, 0}}, {.x = {0.6, 0}}, {.x = {2, 0}}, {.x = {0.55, 0}, .radius = 0.2}};
    const uint8_t kind[5] = {KIND_FLUID, KIND_FLUID, KIND_FLUID, KIND_FLUID, KIND_GRAIN};
    const double none[1][4] = {{0}};
    uint32_t partner[2] = {4, 4};
    size_t start[5] = {0, 0, 1, 2, 2};
    const struct solid_part wall[3] = {{.row = 0, .grain = solid_of_wall(7), .share = 0.25},
                                       {.row = 1, .grain = solid_of_wall(7), .share = 1},
                                       {.row = 3, .grain = solid_of_wall(0), .share = 0.5}};
    struct pair_rows rows = {0};
    struct solid_field solid = {0};
    double filled[4];
    (void)state;
    pair_rows_of(&rows, start, partner);
    solid_pairs_take(&solid, &rows, kind, 0, 4);
    const struct solid_places at = {.state = places,
                                    .shift = none,
                                    .at_wall = wall,
                                    .at_walls = 3,
                                    .spacing = 0.1,
                                    .kappa = 1,
                                    .hydraulic = 1,
                                    .dimension = 2};
    solid_field_make(&solid, &at, 4, filled);
    assert_int_equal(solid.nodes, 4);
    assert_int_equal(solid.parts, 5);
    assert_near(filled[0], 0.25, 1e-15);
    assert_near(filled[1], 1, 1e-15);
    assert_near(filled[2], 1, 1e-15);
    assert_near(filled[3], 0.5, 1e-15);
    for (size_t node = 0; node < 4; node++)
        assert_int_equal(solid.part[solid.start[node]].row, node);
    assert_int_equal(solid.start[2] - solid.start[1], 2);
    assert_near(solid.part[solid.start[1]].share + solid.part[solid.start[1] + 1].share, 1, 1e-15);
    assert_int_equal(solid_wall(solid.part[solid.start[3]].grain), 0);
    assert_int_equal(solid_wall(solid.part[solid.start[0]].grain), 7);
    assert_int_equal(solid_wall(4), -1);
    solid_field_free(&solid);
}

TEST_MAIN(fluid_rigid, cmocka_unit_test(the_edge_and_the_gain), cmocka_unit_test(the_integrals_of_the_gain),
          cmocka_unit_test(a_rigid_motion_stays), cmocka_unit_test(grains_share_a_node),
          cmocka_unit_test(grains_and_walls_share_nodes))
