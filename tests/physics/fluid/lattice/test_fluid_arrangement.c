/* SPDX-License-Identifier: BSD-3-Clause */
/* Lattices: numbers of nodes and of neighbours, their distances, the shells around a node, and the stretch that fits a box. */
#include "tests/test.h"

#include <math.h>

#include "base/memory.h"
#include "tests/near.h"
#include "physics/fluid/lattice/arrangement.h"

/* Neighbours along the edges, their distance in spacings, and all nodes nearer than 1.3 of these distances. */
static const struct {
    enum fluid_arrangement arrangement;
    int dimension, edges;
    double square; /* of the distance, in spacings */
    size_t around;
} rows[] = {{FLUID_CUBIC, 2, 4, 1, 4},
            {FLUID_CUBIC, 3, 6, 1, 6},
            {FLUID_HEXAGONAL, 2, 6, 1.1547005383792515, 6}, /* (4 / 3)^(1/2) */
            {FLUID_BCC, 3, 8, 1.1905507889761495, 8 + 6}, /* 3 4^(-2/3); the next ones at 2 / 3^(1/2) of it */
            {FLUID_FCC, 3, 12, 1.2599210498948732, 12}};  /* 2 2^(-2/3) */
enum { ROWS = sizeof rows / sizeof rows[0] };

static struct arrangement lattice_of(int row, double spacing, double edge) {
    struct fluid_options options = {.spacing = spacing, .fill.arrangement = rows[row].arrangement};
    struct box box = {
        .dimension = rows[row].dimension, .edge = {edge, edge, edge}, .periodic = {true, true, true}};
    return arrangement_make(&options, &box);
}

/* As many nodes in a box as cubes of the spacing, each of the volume that is left for it. */
static void nodes_fill_the_box(void **state) {
    (void)state;
    for (int row = 0; row < ROWS; row++) {
        struct arrangement lattice = lattice_of(row, 0.05, 1);
        int64_t at[3], count = 0, layers = rows[row].dimension == 3 ? lattice.planes[2] : 1;
        for (at[2] = 0; at[2] < layers; at[2]++)
            for (at[1] = 0; at[1] < lattice.planes[1]; at[1]++)
                for (at[0] = 0; at[0] < lattice.planes[0]; at[0]++)
                    count += arrangement_has(&lattice, at);
        assert_near((double)count * lattice.volume, 1, 1e-12);
        assert_true(lattice.stretch < 0.05);
        assert_near(lattice.volume, pow(0.05, rows[row].dimension), 0.1 * lattice.volume);
        for (int d = 0; d < rows[row].dimension; d++) {
            assert_near((double)lattice.planes[d] * lattice.step[d], 1, 1e-12);
            assert_true(rows[row].arrangement == FLUID_CUBIC || lattice.planes[d] % 2 == 0);
        }
    }
}

/* In a large box the lattice is hardly stretched: edges have the length of the lattice, and are the nearest nodes. */
static void edges_are_the_nearest_nodes(void **state) {
    (void)state;
    for (int row = 0; row < ROWS; row++) {
        const int(*edge)[3];
        int(*around)[3];
        struct arrangement lattice = lattice_of(row, 0.001, 1);
        assert_int_equal(arrangement_edges(&lattice, &edge), rows[row].edges);
        for (int k = 0; k < rows[row].edges; k++) {
            int64_t at[3] = {edge[k][0], edge[k][1], edge[k][2]};
            double square = 0;
            for (int d = 0; d < 3; d++)
                square += pow((double)at[d] * lattice.step[d] / 0.001, 2);
            assert_true(arrangement_has(&lattice, at));
            assert_near(square, rows[row].square, 0.005);
        }
        size_t count = arrangement_around(&lattice, 0.001, 0.0013 * sqrt(rows[row].square), &around);
        assert_int_equal(count, rows[row].around);
        memory_free(around);
    }
}

/* A spacing of 0.3 does not divide 1: the cubic lattice keeps its step, the others are stretched by what they miss. */
static void only_the_cubic_one_keeps_its_step(void **state) {
    (void)state;
    struct arrangement cubic = lattice_of(1, 0.3, 1), fcc = lattice_of(4, 0.3, 1);
    assert_true(cubic.step[0] == 0.3 && cubic.stretch == 0 && cubic.planes[0] == 3);
    assert_int_equal(fcc.planes[0], 4); /* 1 / (0.3 2^(-1/3)) = 4.2 */
    assert_near(fcc.step[0], 0.25, 1e-15);
    assert_near(fcc.stretch, 0.25 / (0.3 * pow(2, -1.0 / 3)) - 1, 1e-12);
}

TEST_MAIN(fluid_arrangement, cmocka_unit_test(nodes_fill_the_box),
          cmocka_unit_test(edges_are_the_nearest_nodes), cmocka_unit_test(only_the_cubic_one_keeps_its_step))
