/* SPDX-License-Identifier: BSD-3-Clause */
/* The plan of the fused sweep on any number of threads, with ghosts and busy particles: every particle moves once, and before
 * it is read. */
#include "tests/test.h"

#include "base/memory.h"
#include "base/random.h"
#include "kernel/pairs/pairlist.h"
#include "kernel/pairs/sweep.h"
#include "kernel/pairs/classes_choose.h"
#include <omp.h>
#include <stdlib.h>

enum { CLOUD = 1200, LARGE = 6, ORIGINALS = 40 };

#define EDGE 9.0

struct cloud {
    struct particles *particles;
    struct size_classes classes;
    struct box box;
    struct index *index;
    struct index_view view;
    struct pairlist *list;
};

/* Small particles, then large ones, then ghosts; with a search index the small ones are sorted by cells. */
static void cloud_fill(struct cloud *c, size_t ghosts) {
    double *radii = memory_allocate(CLOUD, sizeof *radii, "test");
    struct classes_options options = {
        .method = CLASSES_CUTS, .cut_count = 1, .cut = {1}, .skin_given = true, .skin = 0.1};
    struct error error = {0};
    c->box = (struct box){.dimension = 3, .edge = {EDGE, EDGE, EDGE}, .periodic = {true, true, true}};
    c->particles = particles_create(CLOUD);
    for (size_t k = 0; k < CLOUD; k++) {
        struct random_sequence random = random_sequence(3, RANDOM_TEST, k);
        size_t i = particles_append(c->particles);
        bool large = k >= CLOUD - ghosts - LARGE && k < CLOUD - ghosts;
        for (int d = 0; d < 3; d++)
            c->particles->state[i].x[d] = EDGE * random_uniform(&random);
        radii[i] = c->particles->state[i].radius = large ? 2.0 : 0.2 + 0.1 * random_uniform(&random);
        c->particles->id[i] = (int64_t)k + 1;
    }
    assert_true(classes_choose(&c->classes, &options, NULL, radii, CLOUD, &error));
    particles_classify(c->particles, &c->classes);
    c->particles->owned = CLOUD - ghosts;
    c->particles->ghosts = ghosts;
    memory_free(radii);
}

static void cloud_search(struct cloud *c, int threads, bool newton) {
    const bool wrap[3] = {true, true, true};
    const struct index_params params = {0};
    struct error error = {0};
    struct pairlist_options options = {.threads = threads, .block_rows = 100, .busy_bound = 20};
    pairlist_view(&c->view, c->particles, &c->classes, &c->box, wrap);
    c->view.newton = newton;
    omp_set_num_threads(threads);
    c->view.threads = threads;
    c->index = index_create("brute", &params, &error);
    index_build(c->index, &c->view);
    c->list = pairlist_create(&options);
    pairlist_build(c->list, c->index, &c->view, &c->box);
}

static void cloud_free(struct cloud *c, struct sweep **sweep) {
    pairlist_destroy(&c->list);
    index_destroy(&c->index);
    particles_destroy(&c->particles);
    sweep_destroy(sweep);
}

static int block_of_row(const struct pairlist *list, uint32_t row) {
    for (int b = 0; b < list->thread_block[list->threads]; b++)
        if (row >= list->blocks[b].first_row && row < list->blocks[b].last_row)
            return b;
    return -1;
}

/* Early ranges of one block and one grain with a short gap between them are one range. */
static void check_gaps(const struct sweep *sweep, const struct pairlist *list) {
    for (int t = 0; t < sweep->threads; t++) {
        const struct sweep_thread *thread = &sweep->thread[t];
        for (size_t r = 1; r < thread->early_count; r++) {
            uint32_t before = thread->early[r - 1].last, first = thread->early[r].first;
            bool apart = first / SWEEP_CHUNK != (before - 1) / SWEEP_CHUNK ||
                         block_of_row(list, first) != block_of_row(list, before - 1);
            assert_true(apart || first > before + SWEEP_GAP);
        }
    }
}

static void check_plan(int threads, size_t ghosts, bool newton) {
    struct cloud c = {0};
    struct sweep *sweep = sweep_create(threads);
    uint32_t originals[ORIGINALS];
    char why[200] = "";
    cloud_fill(&c, ghosts);
    cloud_search(&c, threads, newton);
    for (uint32_t k = 0; k < ORIGINALS; k++)
        originals[k] = 7 * k;
    size_t count = ghosts > 0 ? ORIGINALS : 0;
    for (int again = 0; again < 2; again++) {
        sweep_build(sweep, c.list, c.particles->owned, originals, count);
        if (!sweep_valid(sweep, c.list, c.particles->owned, why, sizeof why))
            fail_msg("%d threads: %s", threads, why);
        check_gaps(sweep, c.list);
    }
    for (size_t k = 0; k < count; k++)
        assert_true(sweep->early[originals[k]]);
    size_t early = 0;
    for (size_t k = 0; k < c.particles->owned; k++)
        early += sweep->early[k];
    if (threads == 1 && ghosts == 0)
        assert_int_equal(early, 0);
    if (threads > 1)
        assert_true(early > LARGE);
    cloud_free(&c, &sweep);
}

static void test_plan(void **state) {
    (void)state;
    for (int threads = 1; threads <= 4; threads++)
        check_plan(threads, 0, true);
}

static void test_plan_with_ghosts(void **state) {
    (void)state;
    for (int threads = 1; threads <= 4; threads++)
        for (int newton = 0; newton < 2; newton++)
            check_plan(threads, 200, newton);
}

/* A plan that is wrong is told from a right one. */
static void test_wrong_plan(void **state) {
    (void)state;
    struct cloud c = {0};
    struct sweep *sweep = sweep_create(2);
    char why[200] = "";
    cloud_fill(&c, 0);
    cloud_search(&c, 2, true);
    sweep_build(sweep, c.list, c.particles->owned, NULL, 0);
    assert_true(sweep_valid(sweep, c.list, c.particles->owned, why, sizeof why));
    struct sweep_thread *thread = &sweep->thread[1];
    thread->early_count--;
    assert_false(sweep_valid(sweep, c.list, c.particles->owned, why, sizeof why));
    thread->early_count++;
    size_t blocks = (size_t)(c.list->thread_block[2] - c.list->thread_block[1]);
    for (size_t b = 0; b < blocks; b++)
        thread->start[b] = 0; /* all at the last block */
    assert_false(sweep_valid(sweep, c.list, c.particles->owned, why, sizeof why));
    cloud_free(&c, &sweep);
}

static void test_empty(void **state) {
    (void)state;
    struct cloud c = {0};
    struct sweep *sweep = sweep_create(2);
    char why[200] = "";
    cloud_fill(&c, 0);
    c.particles->owned = 0;
    cloud_search(&c, 2, true);
    sweep_build(sweep, c.list, 0, NULL, 0);
    assert_true(sweep_valid(sweep, c.list, 0, why, sizeof why));
    cloud_free(&c, &sweep);
}

TEST_MAIN(sweep, cmocka_unit_test(test_plan), cmocka_unit_test(test_plan_with_ghosts),
          cmocka_unit_test(test_wrong_plan), cmocka_unit_test(test_empty))
