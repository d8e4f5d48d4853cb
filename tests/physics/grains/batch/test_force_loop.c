/* SPDX-License-Identifier: BSD-3-Clause */
/* What holds of the force loop by itself: kernels agree, momentum is conserved, springs mirror each other,
 * contacts are listed, special cases do no harm. */
#include "tests/test.h"

#include "physics/grains/batch/force_kernel.h"
#include "tests/physics/grains/forces_by_hand.h"

/* The kernels have the names by which they are asked for here, and no other name is a kernel's. */
static void test_kernel_names(void **state) {
    (void)state;
    struct force_loop *loop = force_loop_create(1);
    assert_true(force_loop_choose(loop, kernels[0]));
    assert_false(force_loop_choose(loop, "x86-64-v5"));
    assert_string_equal(force_loop_kernel(loop), kernels[0]);
    force_loop_destroy(&loop);
#ifdef SCREE_X86_KERNELS
    assert_string_equal(force_kernel_v3.name, kernels[1]);
    assert_string_equal(force_kernel_v4.name, kernels[2]);
#endif
}

/* All kernels give the same bits, forces and springs. */
static void test_kernels_agree(void **state) {
    (void)state;
    for (int k = 0; k < LAWS; k++) {
        OWN_LAW law = law_number(k, k / 2 % 3 ? 1 : MATERIALS);
        struct rig first, other;
        rig_make(&first, &law, (struct layout){2, 1.0, kernels[0]});
        rig_run(&first);
        for (size_t c = 1; c < sizeof kernels / sizeof kernels[0]; c++) {
            if (!rig_make(&other, &law, (struct layout){2, 1.0, kernels[c]})) {
                if (k == 0)
                    print_message("skipped: kernel %s: this CPU or this program does not have it\n",
                                  kernels[c]);
                continue;
            }
            assert_string_equal(force_loop_kernel(other.loop), kernels[c]);
            rig_run(&other);
            assert_memory_equal(first.particles->force, other.particles->force,
                                COUNT * (size_t)first.particles->force_stride * sizeof(double));
            assert_memory_equal(&first.sums, &other.sums, sizeof first.sums);
            for (int t = 0; first.history && t < 2; t++) {
                const struct history_part *a = &first.history->part[first.history->now][t];
                const struct history_part *b = &other.history->part[other.history->now][t];
                assert_int_equal(a->count, b->count);
                assert_memory_equal(a->pair, b->pair, a->count * sizeof *a->pair);
                assert_memory_equal(a->value, b->value,
                                    a->count * (size_t)law.history_components * sizeof *a->value);
            }
            rig_free(&other);
        }
        rig_free(&first);
    }
}

/* Momentum is conserved, and angular momentum too, as levers meet in the middle of the overlap (with
 * lammps_history they do not, and it is not). */
static void test_conservation(void **state) {
    (void)state;
    int conserved = 0, lost = 0;
    for (int k = 0; k < LAWS; k++) {
        OWN_LAW law = law_number(k, MATERIALS);
        struct rig rig;
        rig_make(&rig, &law, (struct layout){3, 1.0, NULL});
        for (int code = 1; code < IMAGE_CODES; code++)
            for (int c = 0; c < 3; c++)
                rig.list.shift[code][c] = 100.0; /* no contact over the box's sides */
        rig_run(&rig);
        struct law_vector force = {0}, torque = {0};
        double size = 0.0;
        for (size_t i = 0; i < COUNT; i++) {
            const double *f = rig.particles->force + i * (size_t)rig.particles->force_stride;
            struct law_vector x = vector_of(rig.particles->state[i].x);
            force = law_add(force, 1.0, vector_of(f));
            torque = law_add(torque, 1.0, law_cross(x, vector_of(f)));
            if (law.spin)
                torque = law_add(torque, 1.0, vector_of(f + 4));
            size += sqrt(law_dot(vector_of(f), vector_of(f)));
        }
        assert_true(sqrt(law_dot(force, force)) < 1e-14 * size);
        bool exact = sqrt(law_dot(torque, torque)) < 1e-13 * size * edge;
        assert_true(exact == (!law.spin || !law.options.lammps_history));
        conserved += exact;
        lost += !exact;
        rig_free(&rig);
    }
    assert_true(conserved > lost && lost > 0);
}

/* Springs of a pair that two threads compute are opposite to the last bit. */
static void test_mirrored_springs(void **state) {
    (void)state;
    OWN_LAW law = law_number(8 * LAW_ELASTIC_COUNT, 1);
    struct rig rig;
    rig_make(&rig, &law, (struct layout){2, 0.0, NULL});
    rig_run(&rig);
    size_t found = 0;
    for (int t = 0; t < 2; t++) {
        const struct history_part *mine = &rig.history->part[rig.history->now][t];
        const struct history_part *theirs = &rig.history->part[rig.history->now][1 - t];
        for (size_t a = 0; a < mine->count; a++) {
            size_t k = pairlist_thread_first(&rig.list, t) + mine->pair[a];
            for (size_t b = 0; b < theirs->count; b++) {
                size_t l = pairlist_thread_first(&rig.list, 1 - t) + theirs->pair[b];
                unsigned code = pair_image(rig.list.j[k]);
                if (rig.list.i[k] != pair_partner(rig.list.j[l]) ||
                    rig.list.i[l] != pair_partner(rig.list.j[k]) ||
                    pair_image(rig.list.j[l]) != image_opposite(code))
                    continue;
                for (int c = 0; c < 6; c++)
                    assert_true(mine->value[6 * a + (size_t)c] == -theirs->value[6 * b + (size_t)c]);
                found++;
            }
        }
    }
    assert_true(found > 100);
    rig_free(&rig);
}

/* The contact list holds each contact once and gives the forces back. */
static void test_contacts(void **state) {
    (void)state;
    for (int k = 0; k <= LAWS; k++) {
        OWN_LAW law = k < LAWS ? law_number(k, MATERIALS) : law_granular(MATERIALS);
        struct rig rig;
        rig_make(&rig, &law, (struct layout){3, 1.0, NULL});
        rig_run(&rig);
        rig.context.dt = 0.0; /* evaluate again with springs at rest: what the list shows */
        drift(rig.particles, 0.0);
        force_loop_run(rig.loop, &rig.context, &rig.sums);
        struct force_contact *contacts;
        size_t count = force_loop_contacts(&rig.context, &contacts);
        assert_int_equal(count, rig.sums.contacts);
        double sum[COUNT + 1][3] = {{0}};
        for (size_t c = 0; c < count; c++) {
            assert_true(contacts[c].overlap > 0.0);
            for (int d = 0; d < 3; d++) {
                sum[contacts[c].id_i][d] -= contacts[c].force[d];
                sum[contacts[c].id_j][d] += contacts[c].force[d];
            }
        }
        for (size_t i = 0; i < COUNT; i++)
            for (int d = 0; d < 3; d++)
                assert_near(sum[rig.particles->id[i]][d],
                            rig.particles->force[i * (size_t)rig.particles->force_stride + (size_t)d], 1e-8);
        memory_free(contacts);
        rig_free(&rig);
    }
}

/* A list of pairs made by hand, in one block of one thread; block, i and j are the caller's. */
static struct pairlist list_of(struct pair_block *block, uint32_t *i, uint32_t *j, size_t pairs) {
    static int thread_block[2] = {0, 1};
    *block = (struct pair_block){.one_sided = pairs, .slotted = pairs, .end_pair = pairs};
    return (struct pairlist){
        .i = i, .j = j, .blocks = block, .block_count = 1, .threads = 1, .thread_block = thread_block};
}

/* Prescribed particles, coincident centres and pairs that only touch do no harm. */
static void test_degenerate(void **state) {
    (void)state;
    for (int k = 0; k < LAWS; k++) {
        OWN_LAW law = law_number(k, 1);
        struct rig rig;
        rig_make(&rig, &law, (struct layout){1, 0.0, NULL});
        struct particle_state *s = rig.particles->state;
        for (size_t i = 0; i < COUNT; i++)
            for (int c = 0; c < 3; c++)
                s[i].x[c] = 10.0 * (double)i;
        s[0].inverse_mass = s[1].inverse_mass = 0.0; /* a prescribed pair overlaps */
        uint32_t i[3 + INDEX_SINK_PAD] = {0, 2, 4}, j[3 + INDEX_SINK_PAD] = {1, 3, 5};
        struct pair_block block;
        rig.list = list_of(&block, i, j, 3);
        s[1].x[0] = s[0].x[0] + 0.5;
        memcpy(s[3].x, s[2].x, sizeof s[3].x);             /* the same place */
        s[5].x[0] = s[4].x[0] + s[4].radius + s[5].radius; /* touching */
        s[5].x[1] = s[4].x[1], s[5].x[2] = s[4].x[2];
        s[1].x[1] = s[0].x[1], s[1].x[2] = s[0].x[2];
        rig.context.dt = 1e-3;
        force_loop_run(rig.loop, &rig.context, &rig.sums);
        assert_int_equal(rig.sums.contacts, 2);
        for (size_t c = 0; c < 6 * (size_t)rig.particles->force_stride; c++)
            assert_true(isfinite(rig.particles->force[c]));
        assert_true(rig.particles->force[0] < 0.0);
        rig_free(&rig);
    }
}

/* How many contacts the loop and the list find. */
static size_t contacts_of(struct rig *rig) {
    struct force_contact *contacts;
    force_loop_run(rig->loop, &rig->context, &rig->sums);
    size_t listed = force_loop_contacts(&rig->context, &contacts);
    memory_free(contacts);
    assert_int_equal(rig->sums.contacts, listed);
    return listed;
}

/* Two prescribed particles that overlap have a contact where they move or turn differently, and else none. */
static void test_fixed(void **state) {
    (void)state;
    for (int k = 0; k < 8; k += 4) {
        OWN_LAW law = law_number(k, 1);
        struct rig rig;
        rig_make(&rig, &law, (struct layout){1, 0.0, NULL});
        rig.context.prescribed = true;
        uint32_t i[1 + INDEX_SINK_PAD] = {0}, j[1 + INDEX_SINK_PAD] = {1};
        struct pair_block block;
        rig.list = list_of(&block, i, j, 1);
        struct particle_state *s = rig.particles->state;
        s[0].inverse_mass = 0.0;
        s[1] = s[0];
        s[1].x[0] += 0.5;
        if (law.spin)
            memcpy(spin_of(rig.particles)[1], spin_of(rig.particles)[0], sizeof spin_of(rig.particles)[1]);
        assert_int_equal(contacts_of(&rig), 0);
        if (law.spin) {
            spin_of(rig.particles)[1][2] += 1.0;
            assert_int_equal(contacts_of(&rig), 1);
            spin_of(rig.particles)[1][2] = spin_of(rig.particles)[0][2];
        }
        s[1].v[1] += 1.0;
        assert_int_equal(contacts_of(&rig), 1);
        rig_free(&rig);
    }
}

/* Forces in order: two particles that meet through three images get the same bits in whichever order their
 * pairs are listed; added up as they come, they get others. */
static void test_order_of_images(void **state) {
    (void)state;
    static const int image[3][3] = {{0, 0, 0}, {-1, 0, 0}, {0, -1, 1}};
    static const int turns[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    OWN_LAW law = law_number(0, 1);
    struct box box = {.dimension = 3, .edge = {1.9, 1.7, 1.6}, .periodic = {true, true, true}};
    int different[2] = {0, 0};
    for (int ordered = 0; ordered < 2; ordered++) {
        double first[8];
        for (int turn = 0; turn < 6; turn++) {
            struct rig rig;
            rig_make(&rig, &law, (struct layout){1, 0.0, NULL});
            uint32_t i[3 + INDEX_SINK_PAD] = {0}, j[3 + INDEX_SINK_PAD] = {0};
            for (int k = 0; k < 3; k++) {
                const int *m = image[turns[turn][k]];
                j[k] = 1 | image_code(m[0], m[1], m[2]) << PARTICLE_INDEX_BITS;
            }
            struct pair_block block;
            rig.list = list_of(&block, i, j, 3);
            box_image_shifts(&box, rig.list.shift);
            struct particle_state *s = rig.particles->state;
            for (int k = 0; k < 2; k++)
                s[k] = (struct particle_state){.radius = 0.9 + 0.1 * k,
                                               .x = {0.3 + 0.71 * k, 0.4 + 0.83 * k, 0.9 - 0.77 * k},
                                               .v = {0.1, -0.3 * k, 0.7},
                                               .inverse_mass = 1.0};
            rig.context.ordered = ordered;
            force_loop_prepare(rig.loop, &rig.context);
            force_loop_run(rig.loop, &rig.context, &rig.sums);
            assert_int_equal(rig.sums.contacts, 3);
            size_t stride = (size_t)rig.particles->force_stride;
            double now[8];
            for (size_t k = 0; k < 2; k++)
                memcpy(now + 4 * k, rig.particles->force + k * stride, 4 * sizeof *now);
            if (turn == 0)
                memcpy(first, now, sizeof first);
            different[ordered] += memcmp(first, now, sizeof now) != 0;
            rig_free(&rig);
        }
    }
    assert_true(different[0] > 0);
    assert_int_equal(different[1], 0);
}

/* As many contacts as there is room for records: what the last batch writes behind them has room, too. */
static void test_history_padding(void **state) {
    (void)state;
    OWN_LAW law = law_number(8 * LAW_ELASTIC_COUNT, 1);
    struct rig rig;
    rig_make(&rig, &law, (struct layout){1, 0.0, NULL});
    history_reserve(rig.history, 0, 1);
    size_t pairs = rig.history->part[1 - rig.history->now][0].capacity;
    uint32_t *i = memory_allocate_zero(pairs + INDEX_SINK_PAD, sizeof *i, "pairs");
    uint32_t *j = memory_allocate_zero(pairs + INDEX_SINK_PAD, sizeof *j, "pairs");
    for (size_t k = 0; k < pairs; k++)
        j[k] = 1;
    struct pair_block block;
    rig.list = list_of(&block, i, j, pairs);
    struct particle_state *s = rig.particles->state;
    memcpy(s[1].x, s[0].x, sizeof s[1].x);
    s[1].x[0] += s[0].radius;
    force_loop_run(rig.loop, &rig.context, &rig.sums);
    const struct history_part *part = &rig.history->part[rig.history->now][0];
    assert_int_equal(part->count, pairs);
    assert_true(part->count + HISTORY_PAD <= part->capacity);
    memory_free(i);
    memory_free(j);
    rig_free(&rig);
}

TEST_MAIN_GROUP(force_loop, make_lists, free_lists, cmocka_unit_test(test_kernel_names),
                cmocka_unit_test(test_kernels_agree), cmocka_unit_test(test_conservation),
                cmocka_unit_test(test_mirrored_springs), cmocka_unit_test(test_contacts),
                cmocka_unit_test(test_degenerate), cmocka_unit_test(test_fixed),
                cmocka_unit_test(test_history_padding), cmocka_unit_test(test_order_of_images))
