/* SPDX-License-Identifier: BSD-3-Clause */
/* The pair list on any number of threads, with ghosts and busy particles, and the skin. */
#include "kernel/pairs/skin.h"
#include "tests/kernel/pairs/cloud_by_hand.h"

#include <math.h>

/* How often each particle would get a share of the force of its pairs, as sums of partner ids: the same for
 * any layout. */
static int64_t *shares(const struct cloud *c) {
    const struct pairlist *list = c->list;
    const int64_t *id = c->particles->id;
    int64_t *share = memory_allocate_zero(c->view.total, sizeof *share, "test");
    struct pair_visit pair = pairlist_all(list);
    while (pairlist_each(list, &pair)) {
        share[pair.i] += id[pair.j] * (1 + pair.image);
        if (!pair_gives_one(&pair))
            share[pair.j] += id[pair.i] * (1 + image_opposite(pair.image));
    }
    return share;
}

static void check_layouts(size_t ghosts, bool newton) {
    struct cloud c = {0};
    cloud_fill(&c, 800, ghosts);
    cloud_search(&c, 1, newton);
    int64_t *reference = shares(&c);
    size_t primary = c.list->primary_count;
    cloud_free(&c);
    for (int threads = 2; threads <= 5; threads++) {
        char why[200] = "";
        cloud_search(&c, threads, newton);
        assert_int_equal(c.list->primary_count, primary);
        assert_true(c.list->slot_count >= 4);
        if (!pairlist_valid(c.list, &c.view, why, sizeof why))
            fail_msg("%s", why);
        struct index_view none = c.view;
        none.margin[0][0] = INDEX_NOT_WANTED;
        assert_false(pairlist_valid(c.list, &none, why, sizeof why));
        int64_t *share = shares(&c);
        size_t counted = newton ? c.view.total : c.view.owned;
        assert_memory_equal(share, reference, counted * sizeof *share);
        memory_free(share);
        /* A second build goes into the regions of the first */
        pairlist_build(c.list, c.index, &c.view, &c.box);
        share = shares(&c);
        assert_memory_equal(share, reference, counted * sizeof *share);
        memory_free(share);
        /* A list that was released has no pairs and no memory for pairs, and all of them after a build */
        int64_t sides = pairlist_sides(c.list);
        size_t held = pairlist_memory(c.list);
        pairlist_release(c.list);
        share = shares(&c);
        for (size_t k = 0; k < counted; k++)
            assert_int_equal(share[k], 0);
        memory_free(share);
        assert_true(pairlist_sides(c.list) == sides && pairlist_memory(c.list) < held / 2);
        pairlist_build(c.list, c.index, &c.view, &c.box);
        share = shares(&c);
        assert_memory_equal(share, reference, counted * sizeof *share);
        assert_int_equal(pairlist_sides(c.list), sides);
        memory_free(share);
        cloud_free(&c);
    }
    memory_free(reference);
    particles_destroy(&c.particles);
}

static void test_any_thread_count_gives_each_particle_the_same(void **state) {
    (void)state;
    check_layouts(0, true);
    check_layouts(160, true);
    check_layouts(160, false);
}

/* No two threads write to the same particle or slot. */
/* The loop over pairs meets each pair of the blocks once, in their order, with its image and its segment. */
static void test_each_pair_is_visited_once(void **state) {
    (void)state;
    struct cloud c = {0};
    cloud_fill(&c, 800, 160);
    cloud_search(&c, 3, true);
    const struct pairlist *list = c.list;
    struct pair_visit all = pairlist_all(list);
    int segments[3] = {0};
    for (int t = 0; t < 3; t++) {
        struct pair_visit thread = pairlist_thread(list, t);
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
            const struct pair_block *block = &list->blocks[b];
            struct pair_visit one = pairlist_block(b), *visit[] = {&all, &thread, &one};
            for (size_t k = block->first_pair; k < block->end_pair; k++)
                for (int v = 0; v < 3; v++) {
                    assert_true(pairlist_each(list, visit[v]));
                    assert_true(visit[v]->k == k && visit[v]->number == b && visit[v]->block == block);
                    assert_true(visit[v]->i == list->i[k]);
                    assert_true((visit[v]->j | visit[v]->image << PARTICLE_INDEX_BITS) == list->j[k]);
                    assert_int_equal(pair_gives_both(visit[v]), k < block->one_sided);
                    assert_int_equal(pair_gives_slot(visit[v]), k >= block->slotted);
                    segments[pair_gives_one(visit[v]) + 2 * pair_gives_slot(visit[v])]++;
                }
            assert_false(pairlist_each(list, &one));
        }
        assert_false(pairlist_each(list, &thread));
    }
    assert_false(pairlist_each(list, &all));
    assert_true(segments[0] > 0 && segments[1] > 0 && segments[2] > 0);
    cloud_free(&c);
    particles_destroy(&c.particles);
}

static void test_threads_own_what_they_write(void **state) {
    (void)state;
    struct cloud c = {0};
    cloud_fill(&c, 800, 160);
    cloud_search(&c, 3, true);
    int *writer = memory_allocate(c.view.total, sizeof *writer, "test");
    for (size_t k = 0; k < c.view.total; k++)
        writer[k] = -1;
    for (int t = 0; t < 3; t++) {
        struct pair_visit pair = pairlist_thread(c.list, t);
        while (pairlist_each(c.list, &pair)) {
            uint32_t end[2] = {pair.i, pair.j};
            for (int e = 0; e < (pair_gives_both(&pair) ? 2 : 1); e++) {
                assert_true(writer[end[e]] == -1 || writer[end[e]] == t);
                writer[end[e]] = t;
            }
            if (pair_gives_slot(&pair))
                assert_int_equal(c.list->busy[c.list->slot_of[end[1]]], end[1]);
        }
    }
    memory_free(writer);
    cloud_free(&c);
    particles_destroy(&c.particles);
}

static void test_skin_is_due_by_class_pairs(void **state) {
    (void)state;
    struct cloud c = {0};
    cloud_fill(&c, 200, 0);
    struct skin *skin = skin_create();
    skin_reset(skin, c.particles, &c.classes, 0);
    assert_false(skin_due(skin, &c.classes));
    skin_moved(skin, (const double[]){0.4, 0}, 2, 0.1, 0);
    assert_false(skin_due(skin, &c.classes)); /* two small ones may have used 0.08 of 0.1 */
    skin_moved(skin, (const double[]){0.4, 0}, 2, 0.1, 0);
    assert_true(skin_due(skin, &c.classes));
    c.particles->state[3].x[1] += 0.09; /* one particle alone went far: pairs have not used up the skin */
    skin_measure(skin, c.particles, 2);
    assert_false(skin_due(skin, &c.classes));
    assert_true(fabs(skin->bound[0] - 0.09) < 1e-12);
    c.particles->state[4].x[0] -= 0.02;
    skin_measure(skin, c.particles, 2);
    assert_true(skin_due(skin, &c.classes));
    skin_release(skin); /* without the positions the bounds stay */
    skin_measure(skin, c.particles, 2);
    assert_true(skin_due(skin, &c.classes));
    skin_reset(skin, c.particles, &c.classes, 0);
    assert_false(skin_due(skin, &c.classes));
    skin_moved(skin, (const double[]){0, 0}, 2, 0.1, 0.11); /* a wall moved */
    assert_true(skin_due(skin, &c.classes));
    skin_destroy(&skin);
    particles_destroy(&c.particles);
}

TEST_MAIN(pairlist, cmocka_unit_test(test_any_thread_count_gives_each_particle_the_same),
          cmocka_unit_test(test_each_pair_is_visited_once),
          cmocka_unit_test(test_threads_own_what_they_write),
          cmocka_unit_test(test_skin_is_due_by_class_pairs))
