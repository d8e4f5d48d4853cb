/* SPDX-License-Identifier: BSD-3-Clause */
/* The division of the box against its definition, for any number of ranks. The domain does not communicate,
 * so the test pretends the rank counts, and one process is enough. Ranks: 1 */
#include "tests/test.h"

#include "kernel/comm/domain.h"
#include "kernel/comm/domain_grid.h"
#include "kernel/comm/domain_tree.h"
#include "base/memory.h"
#include "base/random.h"

#include <math.h>
#include <string.h>

enum { TOUCH_ROOM = 1024 };

static const struct box boxes[] = {
    {.dimension = 3, .edge = {10, 10, 10}, .periodic = {true, true, true}},
    {.dimension = 3, .edge = {10, 10, 10}},
    {.dimension = 3, .edge = {10, 3, 7.7}, .periodic = {true, false, true}},
    {.dimension = 3, .edge = {1, 40, 2}, .periodic = {false, true, false}}, /* thin */
    {.dimension = 2, .edge = {9, 5, 1}, .periodic = {true, true, false}},
    {.dimension = 2, .edge = {9, 5, 1}, .periodic = {false, true, false}},
};
enum { BOXES = sizeof boxes / sizeof boxes[0] };

static const int sizes[] = {1, 2, 3, 4, 5, 6, 7, 8, 12, 27};
enum { SIZES = sizeof sizes / sizeof sizes[0] };

static struct domain *make(int size, const struct box *box, const int grid[3]) {
    struct comm comm = {.handle = MPI_COMM_NULL, .rank = size - 1, .size = size};
    struct domain_options options = {.grid = {grid[0], grid[1], grid[2]}};
    struct error error = {0};
    struct domain *domain = domain_create(&comm, box, &options, &error);
    if (domain == NULL)
        fail_msg("%s", error.text);
    return domain;
}

static bool is_wrapped(const struct domain *domain, const struct box *box, int d) {
    int grid[3];
    domain_grid(domain, grid);
    return box->periodic[d] && grid[d] == 1;
}

/* A position of migration: wrapped, now and then beyond open sides, sometimes on a face. */
static void random_position(const struct domain *domain, const struct box *box, int size,
                            struct random_sequence *sequence, double x[3]) {
    double lower[3], upper[3];
    domain_bounds(domain, (int)(size * random_uniform(sequence)), lower, upper);
    for (int d = 0; d < 3; d++) {
        x[d] = box->edge[d] * random_uniform(sequence);
        if (!box->periodic[d])
            x[d] = box->edge[d] * (1.4 * random_uniform(sequence) - 0.2);
        if (random_uniform(sequence) < 0.1 && isfinite(lower[d]))
            x[d] = lower[d];
    }
}

/* Exactly one subdomain without its upper faces holds a position: the owner's subdomain. */
static void owner_of_any_position(void **state) {
    (void)state;
    for (int b = 0; b < BOXES; b++) {
        for (int s = 0; s < SIZES; s++) {
            struct domain *domain = make(sizes[s], &boxes[b], (int[3]){0, 0, 0});
            struct random_sequence sequence = random_sequence(1, RANDOM_TEST, (uint64_t)(100 * b + s));
            for (int k = 0; k < 300; k++) {
                double x[3], lower[3], upper[3];
                random_position(domain, &boxes[b], sizes[s], &sequence, x);
                int holders = 0, holder = -1;
                for (int r = 0; r < sizes[s]; r++) {
                    domain_bounds(domain, r, lower, upper);
                    bool in = true;
                    for (int d = 0; d < 3; d++)
                        in = in && x[d] >= lower[d] && x[d] < upper[d];
                    holders += in;
                    holder = in ? r : holder;
                }
                assert_int_equal(holders, 1);
                assert_int_equal(domain_owner(domain, x), holder);
            }
            domain_destroy(&domain);
            assert_null(domain);
        }
    }
}

/* The upper face of the box itself belongs to the last subdomain. */
static void owner_on_the_upper_face(void **state) {
    (void)state;
    struct domain *domain = make(8, &boxes[0], (int[3]){0, 0, 0});
    assert_int_equal(domain_owner(domain, (double[3]){10, 10, 10}), 7);
    assert_int_equal(domain_owner(domain, (double[3]){0, 0, 0}), 0);
    domain_destroy(&domain);
}

/* The definition: sphere against cuboid. */
static bool touches(const struct domain *domain, const struct box *box, int rank, const int image[3],
                    const double x[3], double radius) {
    double lower[3], upper[3], squared = 0;
    domain_bounds(domain, rank, lower, upper);
    for (int d = 0; d < 3; d++) {
        if (is_wrapped(domain, box, d) || (!box->periodic[d] && image[d] != 0)) {
            if (image[d] != 0)
                return false;
            if (is_wrapped(domain, box, d))
                continue;
        }
        double y = x[d] + image[d] * box->edge[d];
        double gap = y < lower[d] ? lower[d] - y : y > upper[d] ? y - upper[d] : 0;
        squared += gap * gap;
    }
    return squared <= radius * radius;
}

static int count_listed(const struct domain_touch *touch, int n, int rank, const int image[3]) {
    int count = 0;
    for (int t = 0; t < n; t++)
        count += touch[t].rank == rank && touch[t].image[0] == image[0] && touch[t].image[1] == image[1] &&
                 touch[t].image[2] == image[2];
    return count;
}

/* Every (rank, image) with images from -2 to 2 is listed once if the ball touches, else not at all. */
static void compare_touching(const struct domain *domain, const struct box *box, int size, const double x[3],
                             double radius) {
    struct domain_touch touch[TOUCH_ROOM];
    int n = domain_touching(domain, x, radius, touch, TOUCH_ROOM), expected = 0;
    assert_true(n <= TOUCH_ROOM);
    for (int r = 0; r < size; r++) {
        for (int code = 0; code < 125; code++) {
            int image[3] = {code % 5 - 2, code / 5 % 5 - 2, code / 25 - 2};
            int count = touches(domain, box, r, image, x, radius) ? 1 : 0;
            expected += count;
            if (count_listed(touch, n, r, image) != count)
                fail_msg("%d ranks: ball %g at %g %g %g, rank %d, image %d %d %d: listed %d times, not %d",
                         size, radius, x[0], x[1], x[2], r, image[0], image[1], image[2],
                         count_listed(touch, n, r, image), count);
        }
    }
    assert_int_equal(n, expected);
    assert_int_equal(domain_touching(domain, x, radius, touch, 0), n);
}

/* The largest radius allowed: below the edge of every divided periodic direction. */
static double radius_bound(const struct domain *domain, const struct box *box) {
    double bound = 1.5 * fmax(box->edge[0], fmax(box->edge[1], box->edge[2]));
    for (int d = 0; d < 3; d++)
        if (box->periodic[d] && !is_wrapped(domain, box, d))
            bound = fmin(bound, box->edge[d]);
    return bound;
}

static void touching_of_random_balls(void **state) {
    (void)state;
    for (int b = 0; b < BOXES; b++) {
        for (int s = 0; s < SIZES; s++) {
            struct domain *domain = make(sizes[s], &boxes[b], (int[3]){0, 0, 0});
            struct random_sequence sequence = random_sequence(2, RANDOM_TEST, (uint64_t)(100 * b + s));
            for (int k = 0; k < 60; k++) {
                double x[3], u = random_uniform(&sequence);
                random_position(domain, &boxes[b], sizes[s], &sequence, x);
                compare_touching(domain, &boxes[b], sizes[s], x, u * u * radius_bound(domain, &boxes[b]));
            }
            domain_destroy(&domain);
        }
    }
}

static void touching_in_thin_grids(void **state) {
    (void)state;
    const int grids[][3] = {{8, 1, 1}, {1, 8, 1}, {1, 1, 8}, {1, 2, 4}, {2, 0, 1}};
    for (int g = 0; g < 5; g++) {
        for (int b = 0; b < 4; b++) {
            struct domain *domain = make(8, &boxes[b], grids[g]);
            struct random_sequence sequence = random_sequence(3, RANDOM_TEST, (uint64_t)(100 * b + g));
            for (int k = 0; k < 60; k++) {
                double x[3], u = random_uniform(&sequence);
                random_position(domain, &boxes[b], 8, &sequence, x);
                compare_touching(domain, &boxes[b], 8, x, u * radius_bound(domain, &boxes[b]));
            }
            domain_destroy(&domain);
        }
    }
}

/* Exactly at the distance of the radius counts as touching; a corner is farther than both of its faces. */
static void touching_is_exact(void **state) {
    (void)state;
    struct domain *domain = make(8, &boxes[1], (int[3]){2, 2, 2});
    struct domain_touch touch[8];
    assert_int_equal(domain_touching(domain, (double[3]){4, 4, 2}, 1, touch, 8), 3);
    assert_int_equal(domain_touching(domain, (double[3]){4, 4, 2}, 0.999, touch, 8), 1);
    assert_int_equal(domain_touching(domain, (double[3]){4, 4, 2}, 1.41, touch, 8), 3);
    assert_int_equal(domain_touching(domain, (double[3]){4, 4, 2}, 1.42, touch, 8), 4);
    assert_int_equal(domain_touching(domain, (double[3]){6, 6, 8}, 1, touch, 8), 3);
    assert_int_equal(domain_touching(domain, (double[3]){-50, 4, 2}, 0.5, touch, 8), 1);
    domain_destroy(&domain);
}

static void expect_grid(int size, const struct box *box, const int given[3], const int expected[3]) {
    struct domain *domain = make(size, box, given);
    int grid[3];
    domain_grid(domain, grid);
    for (int d = 0; d < 3; d++)
        assert_int_equal(grid[d], expected[d]);
    domain_destroy(&domain);
}

static void grids_of_least_surface(void **state) {
    (void)state;
    const int any[3] = {0, 0, 0};
    expect_grid(1, &boxes[0], any, (int[3]){1, 1, 1});
    expect_grid(4, &boxes[0], any, (int[3]){2, 2, 1});
    expect_grid(8, &boxes[0], any, (int[3]){2, 2, 2});
    expect_grid(27, &boxes[1], any, (int[3]){3, 3, 3});
    expect_grid(7, &boxes[1], any, (int[3]){1, 7, 1});
    expect_grid(8, &boxes[3], any, (int[3]){1, 8, 1});
    expect_grid(4, &boxes[5], any, (int[3]){4, 1, 1}); /* 3 cuts of 5 against 5 + 2 x 9 */
    expect_grid(8, &boxes[1], (int[3]){0, 1, 0}, (int[3]){4, 1, 2});
    expect_grid(8, &boxes[1], (int[3]){1, 1, 8}, (int[3]){1, 1, 8});
    for (int size = 1; size < 40; size++) {
        struct domain *domain = make(size, &boxes[4], any);
        int grid[3];
        domain_grid(domain, grid);
        assert_int_equal(grid[2], 1);
        assert_int_equal(grid[0] * grid[1], size);
        domain_destroy(&domain);
    }
}

/* A map with `per_bin` particles in each bin whose place along z is below `height` of the box. */
static double *bed(double height, double per_bin) {
    enum { BINS = DOMAIN_DENSITY_BINS };
    double *density = memory_allocate_zero((size_t)BINS * BINS * BINS, sizeof *density, "map");
    for (size_t k = 0; k < (size_t)BINS * BINS * BINS; k++)
        density[k] = (k / (BINS * BINS) + 0.5) / BINS < height ? per_bin : 0;
    return density;
}

static void expect_choice(int size, const struct box *box, const int given[3], const double *density,
                          const int expected[3]) {
    int grid[3];
    assert_true(domain_grid_choose(size, box, given, density, grid));
    for (int d = 0; d < 3; d++)
        assert_int_equal(grid[d], expected[d]);
}

/* A bed in a tall box is divided into columns, although cuts across the height are smaller. If the bed fills
 * the box, or without a bed, the area decides; the area also decides if the map has few particles. */
static void grids_of_least_load(void **state) {
    const struct box tall = {.dimension = 3, .edge = {2, 2, 10}};
    const int any[3] = {0, 0, 0};
    double *low = bed(0.3, 10), *full = bed(1, 10), *few = bed(0.3, 0.0005), *none = bed(0, 0);
    (void)state;
    expect_choice(4, &tall, any, NULL, (int[3]){1, 1, 4});
    expect_choice(4, &tall, any, low, (int[3]){2, 2, 1});
    expect_choice(4, &tall, (int[3]){1, 0, 0}, low, (int[3]){1, 4, 1});
    expect_choice(4, &tall, (int[3]){1, 1, 0}, low, (int[3]){1, 1, 4});
    expect_choice(5, &tall, any, full, (int[3]){1, 1, 5});
    expect_choice(4, &tall, any, few, (int[3]){1, 1, 4});
    expect_choice(4, &tall, any, none, (int[3]){1, 1, 4});
    for (int b = 0; b < BOXES; b++)
        for (int s = 0; s < SIZES; s++) {
            int grid[3];
            assert_true(domain_grid_choose(sizes[s], &boxes[b], any, NULL, grid));
            expect_choice(sizes[s], &boxes[b], any, full, grid);
        }
    memory_free(low);
    memory_free(full);
    memory_free(few);
    memory_free(none);
}

static void expect_refusal(int size, const struct box *box, const int grid[3], const char *part) {
    struct comm comm = {.handle = MPI_COMM_NULL, .rank = 0, .size = size};
    struct domain_options options = {.grid = {grid[0], grid[1], grid[2]}};
    struct error error = {0};
    assert_null(domain_create(&comm, box, &options, &error));
    assert_int_equal(error.kind, ERROR_USER);
    if (strstr(error.text, part) == NULL)
        fail_msg("'%s' without '%s'", error.text, part);
}

static void grids_that_do_not_fit(void **state) {
    (void)state;
    expect_refusal(4, &boxes[0], (int[3]){3, 1, 1}, "3 x 1 x 1 does not fit 4 ranks");
    expect_refusal(4, &boxes[0], (int[3]){3, 0, 0}, "3 x 0 x 0 does not fit 4 ranks");
    expect_refusal(4, &boxes[0], (int[3]){2, 2, 2}, "does not fit 4 ranks");
    expect_refusal(4, &boxes[0], (int[3]){-4, 1, -1}, "does not fit");
    expect_refusal(4, &boxes[4], (int[3]){2, 1, 2}, "2D box is not divided in z");
    expect_refusal(4, &boxes[4], (int[3]){0, 0, 4}, "2D box is not divided in z");
}

static void wrapped_directions(void **state) {
    (void)state;
    struct domain *domain = make(2, &boxes[0], (int[3]){2, 1, 1});
    bool wrap[3];
    domain_wrap(domain, wrap);
    assert_true(!wrap[0] && wrap[1] && wrap[2]);
    domain_destroy(&domain);
    domain = make(1, &boxes[3], (int[3]){0, 0, 0});
    domain_wrap(domain, wrap);
    assert_true(!wrap[0] && wrap[1] && !wrap[2]);
    domain_destroy(&domain);
}

/* Cuts give the tree that they came from; cuts that share ranks out wrongly or lie elsewhere give none. */
static void trees_from_cuts(void **state) {
    (void)state;
    static const double corner[3] = {0, 0, 0};
    const struct box *box = &boxes[0];
    struct domain_tree *tree = domain_tree_halve(12, box);
    struct domain_cut cut[11];
    memcpy(cut, tree->cut, sizeof cut);
    struct domain_tree *again = domain_tree_from_cuts(12, cut, corner, box->edge);
    assert_non_null(again);
    assert_memory_equal(again->cut, cut, sizeof cut);
    domain_tree_destroy(&again);
    const struct domain_cut wrong[] = {
        {.at = cut[2].at, .middle = 0, .axis = cut[2].axis},
        {.at = cut[2].at, .middle = 99, .axis = cut[2].axis},
        {.at = cut[2].at, .middle = cut[2].middle, .axis = 3},
        {.at = cut[2].at, .middle = cut[2].middle, .axis = -1},
        {.at = 11, .middle = cut[2].middle, .axis = cut[2].axis},
        {.at = NAN, .middle = cut[2].middle, .axis = cut[2].axis},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
        cut[2] = wrong[k];
        assert_null(domain_tree_from_cuts(12, cut, corner, box->edge));
    }
    domain_tree_destroy(&tree);
}

/* The same for a bisection: a position on a cut, or on several cuts, belongs to the one subdomain that begins
 * there. */
static void owner_on_a_cut(void **state) {
    (void)state;
    static const double corner[3] = {0, 0, 0};
    for (int b = 0; b < BOXES; b++)
        for (int s = 0; s < SIZES; s++) {
            struct domain_tree *tree = domain_tree_halve(sizes[s], &boxes[b]);
            for (int rank = 0; rank < sizes[s]; rank++)
                for (int mask = 0; mask < 8; mask++) {
                    double lower[3], upper[3], x[3];
                    memcpy(lower, corner, sizeof lower);
                    memcpy(upper, boxes[b].edge, sizeof upper);
                    domain_tree_bounds(tree, rank, lower, upper);
                    for (int d = 0; d < 3; d++)
                        x[d] = mask >> d & 1 ? lower[d] : 0.5 * (lower[d] + upper[d]);
                    assert_int_equal(domain_tree_owner(tree, x), rank);
                }
            domain_tree_destroy(&tree);
        }
}

TEST_MAIN(domain, cmocka_unit_test(owner_of_any_position), cmocka_unit_test(owner_on_the_upper_face),
          cmocka_unit_test(touching_of_random_balls), cmocka_unit_test(touching_in_thin_grids),
          cmocka_unit_test(touching_is_exact), cmocka_unit_test(grids_of_least_surface),
          cmocka_unit_test(grids_of_least_load), cmocka_unit_test(grids_that_do_not_fit),
          cmocka_unit_test(wrapped_directions), cmocka_unit_test(trees_from_cuts),
          cmocka_unit_test(owner_on_a_cut))
