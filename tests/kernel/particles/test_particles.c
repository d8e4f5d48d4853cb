/* SPDX-License-Identifier: BSD-3-Clause */
/* The particle set, its field table and images. */
#include "tests/test.h"

#include "base/random.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/particles.h"
#include "tests/particles_by_hand.h"
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

static void test_append_and_remove_keep_order(void **state) {
    (void)state;
    struct particles *p = sample(WITH_ALL, 100);
    uint8_t remove[100] = {0};
    for (int k = 0; k < 100; k += 3)
        remove[k] = 1;
    assert_int_equal(particles_remove(p, remove), 34);
    assert_int_equal(p->owned, 66);
    for (size_t k = 0, from = 0; from < 100; from++) {
        if (remove[from])
            continue;
        assert_int_equal(p->id[k], 1000 - (int64_t)from);
        assert_int_equal(material_numbers(p)[k], from % 3);
        assert_true(spin_of(p)[k][2] == (double)from);
        k++;
    }
    particles_destroy(&p);
    assert_null(p);
}

static void test_vacate_moves_the_last_alone(void **state) {
    (void)state;
    struct particles *p = sample(WITH_ALL, 100);
    uint8_t leaves[100] = {0};
    uint32_t place[100];
    const size_t who[] = {0, 7, 40, 96, 98};
    for (size_t k = 0; k < 5; k++)
        leaves[who[k]] = 1;
    assert_int_equal(particles_places(leaves, 100, place), 95);
    particles_vacate(p, place, 95);
    assert_int_equal(p->owned, 95);
    const size_t filler[] = {95, 97, 99}; /* of 0, 7, 40 */
    for (size_t k = 0, f = 0; k < 95; k++) {
        size_t from = leaves[k] ? filler[f++] : k;
        assert_int_equal(place[from], k);
        assert_int_equal(p->id[k], 1000 - (int64_t)from);
        assert_int_equal(material_numbers(p)[k], from % 3);
        assert_true(spin_of(p)[k][2] == (double)from);
    }
    for (size_t k = 0; k < 5; k++)
        assert_int_equal(place[who[k]], PARTICLE_LEFT);
    particles_destroy(&p);
}

static void test_vacate_by_all_or_none(void **state) {
    (void)state;
    struct particles *p = sample(WITH_ALL, 10);
    uint8_t leaves[10] = {0};
    uint32_t place[10];
    assert_int_equal(particles_places(leaves, 10, place), 10);
    particles_vacate(p, place, 10);
    assert_int_equal(p->owned, 10);
    assert_int_equal(p->id[9], 1000 - 9);
    memset(leaves, 1, sizeof leaves);
    assert_int_equal(particles_places(leaves, 10, place), 0);
    particles_vacate(p, place, 0);
    assert_int_equal(p->owned, 0);
    particles_destroy(&p);
}

/* Reorders n particles twice, by `threads`, in memory that all threads have spread them in; their forces are zero where
 * `clear`. */
static void check_reorder(unsigned features, bool clear, int threads, const uint32_t *order, uint32_t n) {
    struct particles *p = sample(features, n), *q = sample(features, n);
    omp_set_num_threads(threads);
    p->force_clear = clear;
    for (size_t k = 0; clear && k < n * (size_t)p->force_stride; k++)
        p->force[k] = q->force[k] = 0;
    particles_spread(p);
    particles_reorder(p, order);
    particles_reorder(p, order);
    for (int f = 0; f < fields_count(p); f++) {
        size_t stride, bytes = fields_bytes(fields_get(p, f));
        const char *new = fields_base(p, f, &stride), *old = fields_base(q, f, &stride);
        for (size_t k = 0; k < n; k++)
            assert_memory_equal(new + k *stride, old + order[order[k]] * stride, bytes);
    }
    particles_destroy(&p);
    particles_destroy(&q);
}

static void test_reorder_moves_every_field(void **state) {
    (void)state;
    uint32_t order[257];
    for (uint32_t k = 0; k < 257; k++)
        order[k] = (k * 100 + 7) % 257;
    for (unsigned features = 0; features <= (WITH_ALL | WITH_OTHERS); features++) {
        check_reorder(features, false, 1, order, 257);
        check_reorder(features, true, 3, order, 257);
    }
}

/* Changes places, each with one at most `reach` away. */
static void shuffle(uint32_t *order, uint32_t n, uint32_t reach) {
    struct random_sequence random = random_sequence(7, RANDOM_TEST, reach);
    for (uint32_t k = 0; k < n; k++) {
        uint32_t other = k + (uint32_t)(reach * random_uniform(&random)), moved = order[k];
        if (other >= n)
            continue;
        order[k] = order[other];
        order[other] = moved;
    }
}

/* Rows that stay close, that go far ahead or back, and any; on threads that meet at all kinds of places. */
static void test_reorder_by_any_order(void **state) {
    (void)state;
    enum { N = 12345 };
    static const uint32_t shifts[] = {0, 1, 895, 896, 897, 1024, N / 2, N - 1},
                          reaches[] = {0, 3, 800, 2000, N};
    static uint32_t order[N];
    for (size_t s = 0; s < sizeof shifts / sizeof *shifts; s++)
        for (size_t r = 0; r < sizeof reaches / sizeof *reaches; r++) {
            for (uint32_t k = 0; k < N; k++)
                order[k] = (k + N - shifts[s]) % N;
            shuffle(order, N, reaches[r]);
            for (int threads = 1; threads <= 5; threads += 2) {
                check_reorder(WITH_SPIN, s % 2 == 0, threads, order, N);
                check_reorder(0, s % 2 == 1, threads, order, N);
            }
        }
}

static void test_reorder_of_few(void **state) {
    (void)state;
    static const uint32_t order[3] = {2, 0, 1};
    for (int threads = 1; threads <= 5; threads++) {
        check_reorder(WITH_ALL, true, threads, order, 3);
        check_reorder(WITH_ALL, false, threads, NULL, 0);
    }
}

/* Values of fields that a test adds: to sets with particles or without, wider than the hot record too. */
static void test_any_field_can_be_registered(void **state) {
    (void)state;
    static const struct field wide = {
        .name = "wide", .type = FIELD_DOUBLE, .components = 13, .use = FIELD_TRAVELS, .fill = 2, .help = ""};
    struct particles *p = sample(WITH_SPIN, 40);
    int stride = p->force_stride, count = fields_count(p);
    int f = fields_register(p, &wide), g = fields_register(p, &field_visits);
    assert_int_equal(fields_register(p, &wide), f);
    assert_int_equal(fields_handle(p, &wide), f);
    assert_int_equal(fields_find(p, "visits"), g);
    assert_int_equal(fields_handle(p, &field_flux), -1);
    assert_null(fields_values(p, &field_flux));
    assert_int_equal(fields_count(p), count + 2);
    assert_int_equal(p->force_stride, stride);
    particles_append(p);
    size_t step;
    double(*w)[13] = fields_base(p, f, &step);
    const int64_t *visits = fields_values(p, &field_visits);
    assert_int_equal(step, sizeof *w);
    for (size_t k = 0; k < 41; k++) {
        assert_true(w[k][0] == 2 && w[k][12] == 2 && visits[k] == -3);
        for (int c = 0; c < 13; c++)
            w[k][c] = (double)k + 100 * c;
    }
    assert_true(spin_of(p)[39][2] == 39);
    uint32_t order[41];
    for (uint32_t k = 0; k < 41; k++)
        order[k] = 40 - k;
    for (int clear = 0; clear < 2; clear++) {
        p->force_clear = clear;
        particles_reorder(p, order);
    }
    particles_reorder(p, order);
    w = fields_base(p, f, NULL);
    for (size_t k = 0; k < 41; k++)
        for (int c = 0; c < 13; c++)
            assert_true(w[k][c] == (double)(40 - k) + 100 * c);
    uint8_t remove[41] = {1};
    assert_int_equal(particles_remove(p, remove), 1);
    particles_reserve(p, 5000);
    w = fields_base(p, f, NULL);
    assert_true(w[39][12] == 1200 && w[0][1] == 139);
    particles_destroy(&p);
}

/* Torque comes to a set whose particles have forces. */
static void test_forces_stay_where_a_record_widens(void **state) {
    (void)state;
    struct particles *p = sample(0, 30);
    assert_int_equal(p->force_stride, 4);
    spin_register(p);
    assert_int_equal(p->force_stride, 8);
    for (size_t k = 0; k < 30; k++)
        assert_true(p->force[8 * k] == (double)k && p->force[8 * k + 4] == 0);
    particles_destroy(&p);
}

static void test_pack_and_unpack_are_inverse(void **state) {
    (void)state;
    struct particles *p = sample(WITH_ALL, 20), *q = sample(WITH_ALL, 20);
    uint32_t list[3] = {4, 19, 0};
    char buffer[4096];
    const struct field_list fields = fields_with(p, FIELD_MIGRATE);
    char *end = fields_pack(p, &fields, list, 3, buffer);
    assert_int_equal(end - buffer, 3 * (long)fields_packed_bytes(p, &fields));
    fields_unpack(q, &fields, 5, 3, buffer);
    for (int k = 0; k < 3; k++) {
        assert_int_equal(q->id[5 + k], p->id[list[k]]);
        assert_memory_equal(&q->state[5 + k], &p->state[list[k]], sizeof *p->state);
        assert_int_equal(material_numbers(q)[5 + k], material_numbers(p)[list[k]]);
    }
    particles_destroy(&p);
    particles_destroy(&q);
}

static size_t bytes_of(const struct particles *p, unsigned use) {
    const struct field_list fields = fields_with(p, use);
    return fields_packed_bytes(p, &fields);
}

static void test_scene_without_friction_carries_nothing_of_it(void **state) {
    (void)state;
    struct particles *p = sample(0, 3), *q = sample(WITH_SPIN, 3);
    assert_null(spin_of(p));
    assert_int_equal(p->force_stride, 4);
    assert_int_equal(bytes_of(q, FIELD_FORWARD) - bytes_of(p, FIELD_FORWARD), 24);
    assert_int_equal(bytes_of(q, FIELD_REVERSE) - bytes_of(p, FIELD_REVERSE), 24);
    assert_int_equal(particles_bytes_each(q) - particles_bytes_each(p), 64);
    assert_int_equal(fields_find(p, "torque"), -1);
    particles_destroy(&p);
    particles_destroy(&q);
}

/* A counter that is full does not start over. */
static void test_wrap_refuses_full_counters(void **state) {
    (void)state;
    struct box box = {.dimension = 3, .edge = {4, 5, 6}, .periodic = {true, true, true}};
    static const struct {
        int32_t image;
        double x;
        bool good;
    } cases[] = {{INT32_MAX - 1, 4.5, true}, {INT32_MAX, 4.5, false},      {INT32_MAX, -0.5, true},
                 {-INT32_MAX, -0.5, false},  {-INT32_MAX + 1, -0.5, true}, {0, 4e15, false},
                 {0, -4e300, false},         {INT32_MAX, 3.5, true}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        struct particles *p = sample(WITH_IMAGE, 3);
        int32_t(*image)[3] = particles_images(p);
        for (size_t i = 0; i < 3; i++)
            memset(image[i], 0, sizeof image[i]);
        image[1][0] = cases[k].image;
        p->state[1].x[0] = cases[k].x;
        assert_int_equal(particles_wrap(p, &box), cases[k].good);
        bool inside = p->state[1].x[0] >= 0 && p->state[1].x[0] < 4;
        assert_int_equal(inside, cases[k].good);
        if (!cases[k].good)
            assert_true(image[1][0] == cases[k].image && p->state[1].x[0] == cases[k].x);
        particles_destroy(&p);
    }
}

static void test_wrap_counts_images(void **state) {
    (void)state;
    struct box box = {.dimension = 3, .edge = {4, 5, 6}, .periodic = {true, false, true}};
    struct particles *p = sample(WITH_IMAGE, 50), *q = sample(WITH_IMAGE, 50);
    q->state[0].x[0] = p->state[0].x[0] = -1e-17; /* rounds to the upper face, which is the lower one */
    assert_true(particles_wrap(p, &box));
    for (size_t k = 0; k < 50; k++) {
        assert_true(p->state[k].x[0] >= 0 && p->state[k].x[0] < 4);
        assert_true(p->state[k].x[2] >= 0 && p->state[k].x[2] < 6);
        for (int d = 0; d < 3; d++)
            assert_true(fabs(p->state[k].x[d] + particles_images(p)[k][d] * box.edge[d] - q->state[k].x[d]) <
                        1e-12);
    }
    assert_true(p->state[0].x[0] == 0);
    p->state[7].x[1] = NAN;
    assert_false(particles_wrap(p, &box));
    p->state[7].x[1] = INFINITY;
    assert_false(particles_wrap(p, &box));
    particles_destroy(&p);
    particles_destroy(&q);
}

static void test_image_codes_and_shifts(void **state) {
    (void)state;
    struct box box = {.dimension = 3, .edge = {4, 5, 6}};
    double shift[IMAGE_CODES][4];
    box_image_shifts(&box, shift);
    assert_int_equal(image_code(0, 0, 0), 0);
    for (unsigned code = 0; code < IMAGE_CODES; code++)
        for (int d = 0; d < 3; d++)
            assert_true(shift[code][d] == -shift[image_opposite(code)][d]);
    assert_true(shift[image_code(1, -1, 0)][0] == 4 && shift[image_code(1, -1, 0)][1] == -5);
}

static void test_validity_finds_nonsense(void **state) {
    (void)state;
    char why[200];
    struct particles *p = sample(0, 4);
    assert_true(particles_valid(p, why, sizeof why));
    p->state[2].x[1] = NAN;
    assert_false(particles_valid(p, why, sizeof why));
    assert_non_null(strstr(why, "998"));
    particles_destroy(&p);
}

TEST_MAIN(particles, cmocka_unit_test(test_append_and_remove_keep_order),
          cmocka_unit_test(test_vacate_moves_the_last_alone), cmocka_unit_test(test_vacate_by_all_or_none),
          cmocka_unit_test(test_reorder_moves_every_field), cmocka_unit_test(test_reorder_by_any_order),
          cmocka_unit_test(test_reorder_of_few), cmocka_unit_test(test_any_field_can_be_registered),
          cmocka_unit_test(test_forces_stay_where_a_record_widens),
          cmocka_unit_test(test_pack_and_unpack_are_inverse),
          cmocka_unit_test(test_scene_without_friction_carries_nothing_of_it),
          cmocka_unit_test(test_wrap_counts_images), cmocka_unit_test(test_wrap_refuses_full_counters),
          cmocka_unit_test(test_image_codes_and_shifts), cmocka_unit_test(test_validity_finds_nonsense))
