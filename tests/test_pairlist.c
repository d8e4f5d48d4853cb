/* SPDX-License-Identifier: BSD-3-Clause */
/* The pair list on any number of threads, with ghosts and busy particles, and the history over rebuilds. */
#include "core/memory.h"
#include "core/random.h"
#include "pairs/history.h"
#include "pairs/history_keep.h"
#include "pairs/pairlist.h"
#include "pairs/skin.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <omp.h>
#include <string.h>
#include <cmocka.h>

enum { PLACES = 600 };

#define EDGE 8.0

/* A cloud of small particles with a few large ones, of which the last `ghosts` are ghosts. */
struct cloud {
    struct particles *particles;
    struct size_classes classes;
    struct box box;
    struct index *index;
    struct index_view view;
    struct pairlist *list;
    double near; /* pairs hold records up to this distance of their surfaces; 0: at any */
};

static void cloud_fill(struct cloud *c, size_t n, size_t ghosts) {
    c->box = (struct box){.dimension = 3, .edge = {EDGE, EDGE, EDGE}, .periodic = {true, true, true}};
    c->particles = particles_create(n);
    for (size_t k = 0; k < n; k++) {
        struct random_sequence random = random_sequence(9, RANDOM_TEST, k);
        size_t i = particles_append(c->particles);
        bool large = k >= n - ghosts - 4 && k < n - ghosts;
        for (int d = 0; d < 3; d++)
            c->particles->state[i].x[d] = EDGE * random_uniform(&random);
        c->particles->state[i].radius = large ? 2.5 : 0.2 + 0.1 * random_uniform(&random);
        c->particles->state[i].inverse_mass = 1;
        c->particles->id[i] = (int64_t)(k * 7919 % 100003) + 1;
    }
    double *radii = memory_allocate(n, sizeof *radii, "test");
    for (size_t k = 0; k < n; k++)
        radii[k] = c->particles->state[k].radius;
    struct classes_options options = {
        .method = CLASSES_CUTS, .cut_count = 1, .cut = {1}, .skin_given = true, .skin = 0.1};
    struct error error = {0};
    assert_true(classes_choose(&c->classes, &options, NULL, radii, n, &error));
    memory_free(radii);
    particles_classify(c->particles, &c->classes);
    c->particles->owned = n - ghosts;
    c->particles->ghosts = ghosts;
}

static void cloud_search(struct cloud *c, int threads, bool newton) {
    const bool wrap[3] = {true, true, true};
    const struct index_params params = {0};
    struct error error = {0};
    pairlist_view(&c->view, c->particles, &c->classes, &c->box, wrap);
    c->view.newton = newton;
    omp_set_num_threads(threads);
    c->view.threads = threads;
    c->index = index_create("brute", &params, &error);
    index_build(c->index, &c->view);
    struct pairlist_options options = {.threads = threads, .block_rows = 100, .busy_bound = 20};
    c->list = pairlist_create(&options);
    pairlist_build(c->list, c->index, &c->view, &c->box);
}

static void cloud_free(struct cloud *c) {
    pairlist_destroy(&c->list);
    index_destroy(&c->index);
}

/* How often each particle would get a share of the force of its pairs, as sums of partner ids: the same for
 * any layout. */
static int64_t *shares(const struct cloud *c) {
    const struct pairlist *list = c->list;
    const int64_t *id = c->particles->id;
    int64_t *share = memory_allocate_zero(c->view.total, sizeof *share, "test");
    for (int b = 0; b < list->block_count; b++) {
        const struct pair_block *block = &list->blocks[b];
        for (size_t k = block->first_pair; k < block->end_pair; k++) {
            uint32_t i = list->i[k], j = pair_partner(list->j[k]);
            share[i] += id[j] * (1 + pair_image(list->j[k]));
            if (k < block->one_sided || k >= block->slotted)
                share[j] += id[i] * (1 + image_opposite(pair_image(list->j[k])));
        }
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
static void test_threads_own_what_they_write(void **state) {
    (void)state;
    struct cloud c = {0};
    cloud_fill(&c, 800, 160);
    cloud_search(&c, 3, true);
    int *writer = memory_allocate(c.view.total, sizeof *writer, "test");
    for (size_t k = 0; k < c.view.total; k++)
        writer[k] = -1;
    for (int t = 0; t < 3; t++) {
        for (int b = c.list->thread_block[t]; b < c.list->thread_block[t + 1]; b++) {
            const struct pair_block *block = &c.list->blocks[b];
            for (size_t k = block->first_pair; k < block->end_pair; k++) {
                uint32_t end[2] = {c.list->i[k], pair_partner(c.list->j[k])};
                for (int e = 0; e < (k < block->one_sided ? 2 : 1); e++) {
                    assert_true(writer[end[e]] == -1 || writer[end[e]] == t);
                    writer[end[e]] = t;
                }
                if (k >= block->slotted)
                    assert_int_equal(c.list->busy[c.list->slot_of[end[1]]], end[1]);
            }
        }
    }
    memory_free(writer);
    cloud_free(&c);
    particles_destroy(&c.particles);
}

/* Fills the history with values that follow from the ids of a pair and its image. */
static double expected(const struct cloud *c, size_t k, int component) {
    uint32_t i = c->list->i[k], j = pair_partner(c->list->j[k]);
    int64_t a = c->particles->id[i], b = c->particles->id[j];
    const double *shift = c->list->shift[pair_image(c->list->j[k])];
    double along = 0, sign = a < b ? 1 : -1;
    for (int d = 0; d < 3; d++)
        along += (d + 1) * sign * (c->particles->state[j].x[d] + shift[d] - c->particles->state[i].x[d]);
    return sign * ((double)(a + b) + 1e-3 * component + round(1e6 * along));
}

static bool holds_record(const struct cloud *c, size_t k) {
    uint32_t i = c->list->i[k], j = pair_partner(c->list->j[k]);
    const struct particle_state *state = c->particles->state;
    const double *shift = c->list->shift[pair_image(c->list->j[k])];
    double square = 0, reach = state[i].radius + state[j].radius + c->near;
    for (int d = 0; d < 3; d++)
        square += pow(state[j].x[d] - state[i].x[d] + shift[d], 2);
    return (c->particles->id[i] + c->particles->id[j]) % 3 != 0 && (c->near == 0 || square < reach * reach);
}

static void history_fill(const struct cloud *c, struct history *history) {
    for (int t = 0; t < c->list->threads; t++) {
        size_t first = pairlist_thread_first(c->list, t);
        history_reserve(history, t, c->list->pair_count);
        struct history_part *part = &history->part[1 - history->now][t];
        part->count = 0;
        for (int b = c->list->thread_block[t]; b < c->list->thread_block[t + 1]; b++)
            for (size_t k = c->list->blocks[b].first_pair; k < c->list->blocks[b].end_pair; k++) {
                if (!holds_record(c, k))
                    continue;
                part->pair[part->count] = (uint32_t)(k - first);
                for (int d = 0; d < 3; d++)
                    part->value[3 * part->count + (size_t)d] = expected(c, k, d);
                part->count++;
            }
    }
    history_flip(history);
}

static void history_compare(const struct cloud *c, const struct history *history) {
    for (int t = 0; t < c->list->threads; t++) {
        const struct history_part *part = &history->part[history->now][t];
        size_t first = pairlist_thread_first(c->list, t), at = 0;
        for (int b = c->list->thread_block[t]; b < c->list->thread_block[t + 1]; b++)
            for (size_t k = c->list->blocks[b].first_pair; k < c->list->blocks[b].end_pair; k++) {
                if (!holds_record(c, k))
                    continue;
                assert_true(at < part->count);
                assert_int_equal(part->pair[at], k - first);
                for (int d = 0; d < 3; d++)
                    assert_true(part->value[3 * at + (size_t)d] == expected(c, k, d));
                at++;
            }
        assert_int_equal(at, part->count);
    }
}

static void check_history(int before, int after, bool both_ends) {
    struct cloud c = {0};
    struct history_rows rows = {0};
    cloud_fill(&c, PLACES, 0);
    cloud_search(&c, before, true);
    struct history *old = history_create(3, before), *new = history_create(3, after);
    history_fill(&c, old);
    history_detach(old, c.list, c.particles, both_ends, &rows);
    cloud_free(&c);
    uint32_t *order = memory_allocate(PLACES, sizeof *order, "test");
    for (uint32_t k = 0; k < PLACES; k++)
        order[k] = k * 7 % PLACES;
    particles_reorder(c.particles, order);
    history_rows_reorder(&rows, order, PLACES);
    cloud_search(&c, after, true);
    history_attach(new, &rows, c.list, c.particles, 10);
    history_compare(&c, new);
    history_rows_free(&rows);
    memory_free(order);
    cloud_free(&c);
    history_destroy(&old);
    history_destroy(&new);
    particles_destroy(&c.particles);
}

static void test_history_survives_reorder_and_another_thread_count(void **state) {
    (void)state;
    check_history(1, 1, false);
    check_history(3, 2, false);
    check_history(2, 4, true);
}

/* A rebuild of several ranks with its loose rows, on one. */
struct flight {
    uint32_t place[PLACES], near[PLACES];
    struct history_loose loose, leave;
};

/* Makes every `nth` particle leave and come back as the last ones, as if from another rank. */
static void leave_and_return(struct cloud *c, const struct history *history, uint32_t nth,
                             struct flight *flight) {
    uint32_t order[PLACES], back[PLACES], n = 0;
    for (uint32_t k = 0; k < PLACES; k++)
        if (k % nth != 0) {
            order[n] = k;
            flight->place[k] = n++;
        }
    for (uint32_t k = 0; k < PLACES; k++)
        if (k % nth == 0) {
            order[n] = k;
            back[k] = n++;
            flight->place[k] = PARTICLE_LEFT;
        }
    history_loosen(history, c->list, c->particles, flight->place, &flight->loose, &flight->leave);
    for (size_t r = 0; r < flight->leave.count; r++)
        flight->leave.carrier[r] = back[flight->leave.carrier[r]];
    history_loose_join(&flight->loose, &flight->leave);
    for (uint32_t k = 0; k < PLACES; k++)
        flight->near[k] = k;
    particles_reorder(c->particles, order);
}

/* The short way gives what the long way gives, where particles meet through one image only. */
static void check_kept(int threads, uint32_t nth) {
    struct cloud c = {0};
    struct history_kept kept;
    struct flight flight = {0};
    uint32_t order[PLACES];
    cloud_fill(&c, PLACES, 0);
    for (size_t k = 0; k < PLACES; k++) /* boulders shrink, or they would meet others twice */
        c.particles->state[k].radius = fmin(c.particles->state[k].radius, 1.5);
    cloud_search(&c, threads, true);
    struct history *history = history_create(3, threads);
    history_fill(&c, history);
    if (nth)
        leave_and_return(&c, history, nth, &flight);
    for (uint32_t k = 0; k < PLACES; k++)
        order[k] = k * 7 % PLACES;
    particles_reorder(c.particles, order);
    struct history_numbers numbers = {order, PLACES, nth ? flight.place : NULL, PLACES};
    struct history_followers followers = {&flight.loose, c.particles, flight.near, PLACES};
    history_keep(history, c.list, &numbers, nth ? &followers : NULL, &kept);
    cloud_free(&c);
    cloud_search(&c, threads, true);
    history_restore(history, &kept, &(struct history_twins){0}, c.list);
    history_compare(&c, history);
    history_kept_free(&kept);
    history_loose_free(&flight.loose);
    history_destroy(&history);
    cloud_free(&c);
    particles_destroy(&c.particles);
}

static void test_kept_history_equals_detached(void **state) {
    (void)state;
    for (int threads = 1; threads <= 4; threads++) {
        check_kept(threads, 0);
        check_kept(threads, 5);
        check_kept(threads, 1);
    }
}

/* Exchanges two pairs of the first thread that hold records, the first one and the next of the same block. */
static void swap_pairs(struct cloud *c) {
    size_t k = c->list->blocks[0].first_pair, other;
    while (!holds_record(c, k))
        k++;
    for (other = k + 1; !holds_record(c, other);)
        other++;
    assert_true(other < c->list->blocks[0].one_sided);
    uint32_t i = c->list->i[k], j = c->list->j[k];
    c->list->i[k] = c->list->i[other];
    c->list->j[k] = c->list->j[other];
    c->list->i[other] = i;
    c->list->j[other] = j;
}

/* Particles keep their numbers, and the second list has another skin. Records stay in place, if the second list has
 * the pairs of all of them in their order. */
static void check_still(int threads, double skin, bool swapped, bool in_place) {
    struct cloud c = {.near = 0.05};
    struct history_kept kept;
    cloud_fill(&c, PLACES, 0);
    for (size_t k = 0; k < PLACES; k++)
        c.particles->state[k].radius = fmin(c.particles->state[k].radius, 1.5);
    cloud_search(&c, threads, true);
    size_t pairs = c.list->pair_count;
    struct history *history = history_create(3, threads);
    history_fill(&c, history);
    int now = history->now;
    history_keep(history, c.list, &(struct history_numbers){.owned = PLACES, .before = PLACES}, NULL, &kept);
    cloud_free(&c);
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++)
            c.classes.margin[a][b] = skin;
    cloud_search(&c, threads, true);
    assert_true((c.list->pair_count > pairs) == (skin > 0.1) && (c.list->pair_count < pairs) == (skin < 0.1));
    if (swapped)
        swap_pairs(&c);
    history_restore(history, &kept, &(struct history_twins){0}, c.list);
    history_compare(&c, history);
    assert_int_equal(history->now == now, in_place);
    history_kept_free(&kept);
    history_destroy(&history);
    cloud_free(&c);
    particles_destroy(&c.particles);
}

static void test_history_of_still_particles_stays_in_place(void **state) {
    (void)state;
    for (int threads = 1; threads <= 4; threads++) {
        check_still(threads, 0.1, false, true);
        check_still(threads, 0.3, false, true);
        check_still(threads, 0.07, false, true);
        check_still(threads, 0.3, true, false);   /* two pairs have changed places */
        check_still(threads, 0.02, false, false); /* pairs with records are gone */
    }
}

/* A ball with 50 small spheres around it, of which ten touch it; the other small ones are far away. */
static void ball_fill(struct cloud *c, size_t n) {
    cloud_fill(c, n, 0);
    for (size_t k = 0; k < n; k++) {
        bool ball = k == n - 1;
        double z = k < 10 ? cos(0.3 + 0.2 * (double)k) : 1 - 2 * ((double)(k % 50) + 0.5) / 50;
        double r = ball     ? 0
                   : k < 10 ? 1.11
                   : k < 50 ? 1.6
                            : 3,
               across = sqrt(1 - z * z), angle = 2.399963 * (double)(k % 50);
        const double x[3] = {4 + r * across * cos(angle), 4 + r * across * sin(angle), 4 + r * z};
        c->particles->state[k].radius = ball ? 1 : 0.1;
        c->particles->size_class[k] = ball;
        memcpy(c->particles->state[k].x, x, sizeof x);
    }
    for (int a = 0; a < 2; a++) {
        c->classes.radius_min[a] = c->classes.radius_max[a] = a ? 1 : 0.1;
        c->classes.margin[a][0] = c->classes.margin[a][1] = 0.6;
    }
}

/* The ball's class has slots while many small spheres are its partners, and has none when few are left: pairs of two threads
 * then need a record in each, although no thread misses one. */
static void test_history_where_slots_end(void **state) {
    (void)state;
    enum { COUNT = 101 };
    struct cloud c = {.near = 0.05};
    struct history_kept kept;
    ball_fill(&c, COUNT);
    cloud_search(&c, 2, true);
    pairlist_destroy(&c.list);
    c.list = pairlist_create(&(struct pairlist_options){.threads = 2, .block_rows = 100, .busy_bound = 40});
    pairlist_build(c.list, c.index, &c.view, &c.box);
    assert_int_equal(c.list->slot_count, 1);
    struct history *history = history_create(3, 2);
    history_fill(&c, history);
    history_keep(history, c.list, &(struct history_numbers){.owned = COUNT, .before = COUNT}, NULL, &kept);
    for (int a = 0; a < 2; a++)
        c.classes.margin[a][0] = c.classes.margin[a][1] = 0.06;
    pairlist_view(&c.view, c.particles, &c.classes, &c.box, (const bool[]){true, true, true});
    c.view.newton = true;
    c.view.threads = 2;
    index_build(c.index, &c.view);
    pairlist_build(c.list, c.index, &c.view, &c.box);
    assert_int_equal(c.list->slot_count, 0);
    history_restore(history, &kept, &(struct history_twins){0}, c.list);
    history_compare(&c, history);
    history_kept_free(&kept);
    history_destroy(&history);
    cloud_free(&c);
    particles_destroy(&c.particles);
}

static void test_rows_follow_removed_particles(void **state) {
    (void)state;
    struct history_row row[4] = {{.id = 1}, {.id = 1}, {.id = 3}, {.id = 4}};
    size_t start[] = {0, 2, 2, 3, 4};
    struct history_rows rows = {memory_allocate(5, sizeof(size_t), "test"),
                                memory_allocate(4, sizeof *row, "test"), 4};
    memcpy(rows.start, start, sizeof start);
    memcpy(rows.row, row, sizeof row);
    history_rows_remove(&rows, (const uint8_t[]){0, 1, 1, 0}, 4);
    assert_int_equal(rows.count, 3);
    assert_int_equal(rows.start[1], 2);
    assert_int_equal(rows.start[2], 3);
    assert_int_equal(rows.row[2].id, 4);
    history_rows_free(&rows);
}

static void test_skin_is_due_by_class_pairs(void **state) {
    (void)state;
    struct cloud c = {0};
    cloud_fill(&c, 200, 0);
    struct skin *skin = skin_create();
    skin_reset(skin, c.particles);
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
    skin_reset(skin, c.particles);
    assert_false(skin_due(skin, &c.classes));
    skin_moved(skin, (const double[]){0, 0}, 2, 0.1, 0.11); /* a wall moved */
    assert_true(skin_due(skin, &c.classes));
    skin_destroy(&skin);
    particles_destroy(&c.particles);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_any_thread_count_gives_each_particle_the_same),
        cmocka_unit_test(test_threads_own_what_they_write),
        cmocka_unit_test(test_history_survives_reorder_and_another_thread_count),
        cmocka_unit_test(test_kept_history_equals_detached),
        cmocka_unit_test(test_history_of_still_particles_stays_in_place),
        cmocka_unit_test(test_history_where_slots_end),
        cmocka_unit_test(test_rows_follow_removed_particles),
        cmocka_unit_test(test_skin_is_due_by_class_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
