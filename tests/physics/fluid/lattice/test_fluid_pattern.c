/* SPDX-License-Identifier: BSD-3-Clause */
/* One table of weights for all rows of a lattice, against weights of each row; and Stokes' operator against its parts. */
#include "tests/test.h"

#include "base/memory.h"
#include "base/random.h"
#include "physics/fluid/operators/operators.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

/* A block of SIDE^3 nodes of a lattice, the INNER^3 in its middle first: these have rows. */
enum { SIDE = 9, INNER = 3, NODES = SIDE * SIDE * SIDE, ROWS = INNER * INNER * INNER, DOUBLES = 4 };
static const double spacing = 0.1, reach = 2.2;

struct block {
    struct particles *particles;
    uint8_t kind[NODES];
    size_t start[ROWS + 1];
    uint32_t partner[ROWS * 64];
    struct pair_rows pairs;
    struct weights_input input;
};

static bool is_inner(const int at[3]) {
    for (int d = 0; d < 3; d++)
        if (at[d] < (SIDE - INNER) / 2 || at[d] >= (SIDE + INNER) / 2)
            return false;
    return true;
}

static void places(struct block *b) {
    for (int inner = 1; inner >= 0; inner--)
        for (int k = 0; k < NODES; k++) {
            int at[3] = {k % SIDE, k / SIDE % SIDE, k / SIDE / SIDE};
            if (is_inner(at) != inner)
                continue;
            struct particle_state *state = &b->particles->state[particles_append(b->particles)];
            for (int d = 0; d < 3; d++)
                state->x[d] = (at[d] + 0.5) * spacing;
            /* the three upper layers are a wall */
            b->kind[b->particles->owned - 1] = at[2] >= SIDE - 3 ? KIND_BOUNDARY : KIND_FLUID;
        }
}

static double distance(const struct block *b, size_t i, size_t j) {
    double square = 0;
    for (int d = 0; d < 3; d++)
        square += pow(b->particles->state[i].x[d] - b->particles->state[j].x[d], 2);
    return sqrt(square);
}

/* `moved`: a node next to the rows is off its place by this part of the spacing. */
static void block_make(struct block *b, double moved) {
    static const double shift[1][4];
    memset(b, 0, sizeof *b);
    b->particles = particles_create(NODES);
    places(b);
    for (size_t j = ROWS; j < NODES; j++)
        if (moved > 0 && distance(b, 0, j) < 1.5 * spacing) {
            b->particles->state[j].x[0] += moved * spacing;
            moved = 0;
        }
    size_t count = 0;
    for (size_t i = 0; i < ROWS; i++) {
        for (size_t j = 0; j < NODES; j++)
            if (j != i && distance(b, i, j) < 2.4 * spacing)
                b->partner[count++] = (uint32_t)j;
        b->start[i + 1] = count;
    }
    b->pairs = (struct pair_rows){.rows = ROWS, .start = b->start, .partner = b->partner};
    b->input = (struct weights_input){.particles = b->particles,
                                      .kind = b->kind,
                                      .end = ROWS,
                                      .pairs = &b->pairs,
                                      .shift = shift,
                                      .dimension = 3};
}

static struct weights weigh(const struct block *b, double support) {
    struct weights weights = {0};
    struct weights_options options = {.kernel = kernel_make(KERNEL_WENDLAND_C2, support * spacing, 3),
                                      .spacing = spacing,
                                      .volume = kernel_power(spacing, 3)};
    weights_make(&weights, &b->input, &options);
    return weights;
}

/* The rows that do not see the moved node have the same weights in the table as by themselves. */
static void test_table(void **state) {
    struct block *whole = memory_allocate(2, sizeof *whole, "blocks"), *other = whole + 1;
    (void)state;
    block_make(whole, 0);
    block_make(other, 0.01);
    struct weights table = weigh(whole, reach), each = weigh(other, reach);
    size_t same = 0;
    assert_non_null(table.code);
    assert_null(each.code);
    assert_int_equal(table.value_room, 32);
    assert_true(weights_memory(&table) < weights_memory(&each) / 3);
    for (size_t row = 0; row < ROWS; row++) {
        double apart = 0;
        assert_int_equal(table.start[row + 1] - table.start[row], 32);
        for (size_t e = table.start[row]; e < table.start[row + 1]; e++) {
            assert_int_equal(table.partner[e], each.partner[e]);
            apart =
                fmax(apart, fabs(weights_scalar(&table, e) - weights_scalar(&each, e)) * spacing * spacing);
            for (int d = 0; d < 3; d++)
                apart =
                    fmax(apart, fabs(weights_vector(&table, e)[d] - weights_vector(&each, e)[d]) * spacing);
        }
        assert_true(apart < 1e-12 || apart > 1e-5);
        same += apart < 1e-12;
    }
    assert_in_range(same, 1, ROWS - 1);
    weights_free(&table);
    weights_free(&each);
    particles_destroy(&whole->particles);
    particles_destroy(&other->particles);
    memory_free(whole);
}

/* A mirror at each wall entry, as of one plane. */
static void wall_make(struct weights *w) {
    size_t walls = w->wall_start[w->rows];
    assert_true(walls > 0);
    w->foot = memory_allocate_zero(1, sizeof *w->foot, "foot");
    w->foot[0] =
        (struct weights_foot){.distance = 0.5 * spacing, .normal = {0, 0, -1}, .velocity = {0.3, 0.2, 0}};
    for (size_t k = 0; k < walls; k++) {
        w->mirror[k] = 0.25 + (double)k / (double)walls * 6;
        w->wall_foot[k] = 0;
    }
}

static void test_stokes(void **state) {
    struct block *b = memory_allocate(1, sizeof *b, "block");
    double(*value)[DOUBLES] = memory_allocate(NODES, sizeof *value, "values"), worst = 0, gradient[ROWS][3],
    laplacian[ROWS][3], divergence[ROWS], out[DOUBLES * ROWS];
    (void)state;
    block_make(b, 0);
    struct weights w = weigh(b, reach);
    wall_make(&w);
    for (size_t k = 0; k < NODES; k++) {
        struct random_sequence random = random_sequence(7, RANDOM_TEST, k);
        for (int c = 0; c < DOUBLES; c++)
            value[k][c] = random_uniform(&random) - 0.5;
    }
    struct operators_values u = {value[0], DOUBLES, 0}, p = {&value[0][3], DOUBLES, 0};
    for (w.slip = 0; w.slip < 0.2; w.slip += 0.1) {
        operators_gradient(&w, p, gradient);
        operators_laplacian_velocity(&w, u, laplacian);
        operators_divergence(&w, u, divergence);
        operators_stokes(&w, u, p, &(struct operators_stokes){2, 3, 5}, out);
        for (size_t row = 0; row < ROWS; row++) {
            for (size_t d = 0; d < 3; d++)
                worst =
                    fmax(worst, fabs(out[d * ROWS + row] - (2 * gradient[row][d] - 3 * laplacian[row][d])));
            worst = fmax(worst, fabs(out[3 * ROWS + row] + 5 * divergence[row]));
        }
    }
    if (!(worst < 1e-9))
        print_message("worst %g\n", worst);
    assert_true(worst < 1e-9);
    weights_free(&w);
    particles_destroy(&b->particles);
    memory_free(value);
    memory_free(b);
}

TEST_MAIN(fluid_pattern, cmocka_unit_test(test_table), cmocka_unit_test(test_stokes))
