/* SPDX-License-Identifier: BSD-3-Clause */
/* Several interactions over one search: lists of their own, rows of both particles, and sums over them by the walk. */
#include "tests/test.h"

#include "base/memory.h"
#include "base/random.h"
#include "kernel/pairs/interaction.h"
#include "kernel/pairs/walk.h"
#include <math.h>
#include <stdlib.h>
#include <omp.h>
#include <string.h>
#include "tests/near.h"
#include "kernel/pairs/classes_choose.h"

enum { COUNT = 700, GHOSTS = 90, SETS = 3 };

static const double support = 1.1, edge = 10.0;

static double touch(const void *context, int kind_a, double a, int kind_b, double b) {
    (void)context, (void)kind_a, (void)a, (void)kind_b, (void)b;
    return 0.0;
}

static double kernel(const void *context, int kind_a, double a, int kind_b, double b) {
    (void)context, (void)kind_a, (void)kind_b;
    return isinf(b) ? -INFINITY : support - a - b;
}

static double cohesive(const void *context, int kind_a, double a, int kind_b, double b) {
    (void)context, (void)kind_a, (void)kind_b;
    return 0.01 * fmin(a, b);
}

struct cloud {
    struct particles *particles;
    struct size_classes classes;
    struct box box;
    struct index *index;
    struct index_view view;
    struct interactions set;
};

static void cloud_make(struct cloud *c, int threads, bool newton) {
    double radii[COUNT];
    *c = (struct cloud){.box = {.dimension = 3, .edge = {10, 10, 10}, .periodic = {true, true, true}}};
    interactions_add(&c->set, &(struct interaction){.name = "contact", .range = touch});
    interactions_add(&c->set, &(struct interaction){.name = "kernel", .range = kernel});
    interactions_add(&c->set, &(struct interaction){.name = "cohesion", .range = cohesive});
    c->particles = particles_create(COUNT);
    for (size_t k = 0; k < COUNT; k++) {
        struct random_sequence random = random_sequence(21, RANDOM_TEST, k);
        size_t i = particles_append(c->particles);
        struct particle_state *s = &c->particles->state[i];
        for (int d = 0; d < 3; d++)
            s->x[d] = edge * random_uniform(&random);
        s->radius = radii[k] = k % 60 == 0 ? 1.5 : 0.2 + 0.1 * random_uniform(&random);
        s->inverse_mass = 1.0;
        c->particles->id[i] = (int64_t)(k * 7919 % 100003) + 1;
    }
    struct classes_options options = {
        .method = CLASSES_CUTS, .cut_count = 1, .cut = {1}, .skin_given = true, .skin = 0.05};
    struct classes_range range = interactions_range(&c->set);
    struct error error = {0};
    assert_true(classes_choose(&c->classes, &options, &range, radii, COUNT, &error));
    particles_classify(c->particles, &c->classes);
    c->particles->owned = COUNT - GHOSTS;
    c->particles->ghosts = GHOSTS;
    const bool wrap[3] = {true, true, true};
    const struct index_params params = {0};
    pairlist_view(&c->view, c->particles, &c->classes, &c->box, wrap);
    c->view.newton = newton;
    omp_set_num_threads(threads);
    c->view.threads = threads;
    c->index = index_create("hgrid", &params, &error);
    struct pairlist_options list = {.threads = threads, .block_rows = 100, .busy_bound = 20};
    interactions_create(&c->set, &list);
    interactions_divide(&c->set, &c->classes, &list);
    index_build(c->index, &c->view);
    pairlist_build(c->set.all, c->index, &c->view, &c->box);
    interactions_select(&c->set, &c->classes, &c->view);
}

static void cloud_free(struct cloud *c) {
    interactions_free(&c->set);
    index_destroy(&c->index);
    particles_destroy(&c->particles);
}

/* The cut-off of interaction k for two radii: beyond it by the skin pairs are listed. */
static double cutoff(int k, double a, double b) {
    double (*const range[])(const void *, int, double, int, double) = {touch, kernel, cohesive};
    return a + b + range[k](NULL, 0, a, 0, b);
}

static double distance(const struct cloud *c, size_t i, size_t j) {
    double square = 0.0;
    for (int d = 0; d < 3; d++) {
        double apart = c->particles->state[j].x[d] - c->particles->state[i].x[d];
        apart -= edge * rint(apart / edge);
        square += apart * apart;
    }
    return sqrt(square);
}

/* How often pair (i, j) counts for the particle of that number, by its list. */
static void lists_count(const struct pairlist *list, uint8_t (*met)[COUNT]) {
    memset(met, 0, COUNT * sizeof *met);
    struct pair_visit pair = pairlist_all(list);
    while (pairlist_each(list, &pair)) {
        met[pair.i][pair.j]++;
        if (!pair_gives_one(&pair))
            met[pair.j][pair.i]++;
    }
}

/* Each list has each pair within the interaction's cut-off + skin for both its owned particles once, and none
 * farther than the class pair may be. With newton on a pair of an owned one and a ghost is there, for both, or not
 * at all. */
static void lists_check(int threads, bool newton) {
    static uint8_t met[COUNT][COUNT];
    struct cloud c;
    cloud_make(&c, threads, newton);
    assert_non_null(c.set.own[0]);
    assert_non_null(c.set.own[1]);
    assert_non_null(c.set.own[2]);
    for (int k = 0; k < SETS; k++) {
        const struct pairlist *list = interaction_list(&c.set, k);
        size_t primary = 0;
        lists_count(list, met);
        for (size_t i = 0; i < COUNT - GHOSTS; i++)
            for (size_t j = i + 1; j < COUNT; j++) {
                const struct particle_state *a = &c.particles->state[i], *b = &c.particles->state[j];
                double gap = distance(&c, i, j) - cutoff(k, a->radius, b->radius) - 0.05;
                bool ghost = j >= COUNT - GHOSTS;
                int kept = met[i][j];
                if (gap < -1e-12 &&
                    !(ghost && newton &&
                      !index_pair_home(a->radius, c.particles->id[i], b->radius, c.particles->id[j])))
                    assert_int_equal(kept, 1);
                if (gap > 0.45) /* the largest difference of radii in a class, twice */
                    assert_int_equal(kept, 0);
                assert_true(kept <= 1);
                if (!ghost || newton)
                    assert_int_equal(met[j][i], kept);
                primary += kept;
            }
        assert_int_equal(list->primary_count, primary);
    }
    assert_true(c.set.own[0]->primary_count < c.set.all->primary_count / 2);
    cloud_free(&c);
}

static void test_lists(void **state) {
    (void)state;
    for (int threads = 1; threads <= 4; threads++) {
        lists_check(threads, false);
        lists_check(threads, true);
    }
}

/* With newton off the rows of a list hold each pair in the rows of both owned particles, sorted. */
static void test_rows(void **state) {
    (void)state;
    static uint8_t met[COUNT][COUNT];
    struct pair_rows rows = {0};
    for (int threads = 1; threads <= 3; threads++) {
        struct cloud c;
        cloud_make(&c, threads, false);
        for (int k = 0; k < SETS; k++) {
            const struct pairlist *list = interaction_list(&c.set, k);
            lists_count(list, met);
            pair_rows_build(&rows, list, COUNT - GHOSTS);
            assert_int_equal(rows.rows, COUNT - GHOSTS);
            for (size_t i = 0; i < rows.rows; i++) {
                size_t expected = 0;
                for (size_t j = 0; j < COUNT; j++)
                    expected += met[i][j];
                assert_int_equal(rows.start[i + 1] - rows.start[i], expected);
                for (size_t p = rows.start[i]; p < rows.start[i + 1]; p++) {
                    assert_int_equal(met[i][pair_partner(rows.partner[p])], 1);
                    if (p > rows.start[i])
                        assert_true(pair_partner(rows.partner[p]) > pair_partner(rows.partner[p - 1]));
                }
            }
        }
        cloud_free(&c);
    }
    pair_rows_free(&rows);
}

/* Two values for each particle: how many partners are within the support, and the sum of their masses' inverses over
 * the distance; j's value differs from i's. */
static void sum_compute(const struct walk_task *task, struct walk_batch *b) {
    (void)task;
    for (int k = 0; k < b->padded; k++) {
        const double *r = b->record[k];
        double d = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
        b->out[0][k] = 1.0;
        b->out[1][k] = b->radius[1][k] / d;
        b->out[2][k] = 1.0;
        b->out[3][k] = b->radius[0][k] / d;
    }
}

static void test_walk(void **state) {
    (void)state;
    static const struct walk_client client = {.name = "sum",
                                              .memory = sizeof(struct walk_batch),
                                              .scatter = WALK_VALUES,
                                              .values = 2,
                                              .compute = sum_compute};
    static const char *const levels[] = {"baseline", "x86-64-v3", "x86-64-v4"};
    for (int trial = 0; trial < 24; trial++) {
        struct cloud c;
        int threads = 1 + trial % 4;
        bool ordered = trial / 4 % 2;
        cloud_make(&c, threads, false);
        struct walk *walk = walk_create(&client, threads);
        double *sum = memory_allocate_zero(COUNT, 2 * sizeof *sum, "test");
        struct walk_work work = {.particles = c.particles,
                                 .list = interaction_list(&c.set, 1),
                                 .target = sum,
                                 .stride = 2,
                                 .range = support,
                                 .ordered = ordered};
        if (walk_choose(walk, levels[trial / 8])) {
            walk_prepare(walk, &work);
            walk_run(walk, &work);
            for (size_t i = 0; i < COUNT - GHOSTS; i++) {
                double count = 0.0, weight = 0.0;
                for (size_t j = 0; j < COUNT; j++)
                    if (j != i && distance(&c, i, j) < support) {
                        count++;
                        weight += c.particles->state[j].radius / distance(&c, i, j);
                    }
                assert_near(sum[2 * i], count, 0.0);
                assert_near(sum[2 * i + 1], weight, 1e-12 * weight);
            }
        }
        memory_free(sum);
        walk_destroy(&walk);
        cloud_free(&c);
    }
}

TEST_MAIN(interaction, cmocka_unit_test(test_lists), cmocka_unit_test(test_rows), cmocka_unit_test(test_walk))
