/* SPDX-License-Identifier: BSD-3-Clause */
/* The history of contacts over rebuilds: particles in another order, removed ones, other numbers of threads, slots that end. */
#include "kernel/pairs/history.h"
#include "kernel/pairs/history_keep.h"
#include "tests/kernel/pairs/cloud_by_hand.h"

#include <math.h>
#include <string.h>

enum { PLACES = 600 };

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
        struct pair_visit pair = pairlist_thread(c->list, t);
        while (pairlist_each(c->list, &pair)) {
            if (!holds_record(c, pair.k))
                continue;
            part->pair[part->count] = (uint32_t)(pair.k - first);
            for (int d = 0; d < 3; d++)
                part->value[3 * part->count + (size_t)d] = expected(c, pair.k, d);
            part->count++;
        }
    }
    history_flip(history);
}

static void history_compare(const struct cloud *c, const struct history *history) {
    for (int t = 0; t < c->list->threads; t++) {
        const struct history_part *part = &history->part[history->now][t];
        size_t first = pairlist_thread_first(c->list, t), at = 0;
        struct pair_visit pair = pairlist_thread(c->list, t);
        while (pairlist_each(c->list, &pair)) {
            if (!holds_record(c, pair.k))
                continue;
            assert_true(at < part->count);
            assert_int_equal(part->pair[at], pair.k - first);
            for (int d = 0; d < 3; d++)
                assert_true(part->value[3 * at + (size_t)d] == expected(c, pair.k, d));
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

/* The copies are made anew, and come in another order. */
static void turn_copies(struct particles *particles) {
    for (size_t k = 0; k < particles->ghosts / 2; k++) {
        size_t a = particles->owned + k, b = particles->owned + particles->ghosts - 1 - k;
        struct particle_state state = particles->state[a];
        int64_t id = particles->id[a];
        particles->state[a] = particles->state[b];
        particles->id[a] = particles->id[b];
        particles->state[b] = state;
        particles->id[b] = id;
    }
}

/* Particles keep their numbers, and the second list has another skin. Records stay in place, but for those of pairs with copies,
 * if the second list has the pairs of all of them in their order. */
static void check_still(int threads, size_t copies, double skin, bool swapped, bool in_place) {
    struct cloud c = {.near = 0.05};
    struct history_kept kept;
    struct flight flight = {0};
    const size_t owned = PLACES - copies;
    cloud_fill(&c, PLACES, copies);
    for (size_t k = 0; k < PLACES; k++) {
        c.particles->state[k].radius = fmin(c.particles->state[k].radius, 1.5);
        flight.place[k] = (uint32_t)k;
    }
    cloud_search(&c, threads, true);
    size_t pairs = c.list->pair_count;
    struct history *history = history_create(3, threads);
    history_fill(&c, history);
    int now = history->now;
    if (copies)
        history_loosen(history, c.list, c.particles, flight.place, &flight.loose, &flight.leave);
    assert_int_equal(flight.loose.count > 0, copies > 0);
    turn_copies(c.particles);
    const struct history_followers followers = {&flight.loose, c.particles, NULL, 0};
    history_keep(history, c.list, &(struct history_numbers){.owned = owned, .before = owned},
                 copies ? &followers : NULL, &kept);
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
    history_loose_free(&flight.loose);
    history_loose_free(&flight.leave);
    history_destroy(&history);
    cloud_free(&c);
    particles_destroy(&c.particles);
}

static void test_history_of_still_particles_stays_in_place(void **state) {
    (void)state;
    for (int threads = 1; threads <= 4; threads++)
        for (size_t copies = 0; copies <= 150; copies += 150) {
            check_still(threads, copies, 0.1, false, true);
            check_still(threads, copies, 0.3, false, true);
            check_still(threads, copies, 0.07, false, true);
            check_still(threads, copies, 0.3, true, false);   /* two pairs have changed places */
            check_still(threads, copies, 0.02, false, false); /* pairs with records are gone */
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
    struct history_rows rows = {.start = memory_allocate(5, sizeof(size_t), "test"),
                                .row = memory_allocate(4, sizeof *row, "test"),
                                .count = 4};
    memcpy(rows.start, start, sizeof start);
    memcpy(rows.row, row, sizeof row);
    history_rows_remove(&rows, (const uint8_t[]){0, 1, 1, 0}, 4);
    assert_int_equal(rows.count, 3);
    assert_int_equal(rows.start[1], 2);
    assert_int_equal(rows.start[2], 3);
    assert_int_equal(rows.row[2].id, 4);
    history_rows_free(&rows);
}

TEST_MAIN(history, cmocka_unit_test(test_history_survives_reorder_and_another_thread_count),
          cmocka_unit_test(test_kept_history_equals_detached),
          cmocka_unit_test(test_history_of_still_particles_stays_in_place),
          cmocka_unit_test(test_history_where_slots_end),
          cmocka_unit_test(test_rows_follow_removed_particles))
