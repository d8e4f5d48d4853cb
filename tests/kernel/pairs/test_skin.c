/* SPDX-License-Identifier: BSD-3-Clause */
/* When a rebuild is due. */
#include "tests/test.h"

#include "kernel/pairs/skin.h"

/* One size class with skin 1 to itself and to walls; walls have no skin among themselves. */
static struct size_classes one_class(void) {
    struct size_classes classes = {.count = 1};
    classes.skin[0][0] = classes.skin[0][1] = classes.skin[1][0] = 1;
    return classes;
}

static void test_two_particles_share_the_skin(void **state) {
    (void)state;
    struct size_classes classes = one_class();
    struct skin *skin = skin_create();
    double speed = 2;
    skin_moved(skin, &speed, 1, 0.2, 0); /* 0.4 each */
    assert_false(skin_due(skin, &classes));
    skin_moved(skin, &speed, 1, 0.2, 0); /* 0.8 each */
    assert_true(skin_due(skin, &classes));
    skin_destroy(&skin);
}

static void test_moving_walls_count_against_particles_alone(void **state) {
    (void)state;
    struct size_classes classes = one_class();
    struct skin *skin = skin_create();
    double speed = 0;
    skin_moved(skin, &speed, 1, 0.1, 0.9);
    assert_false(skin_due(skin, &classes)); /* although the walls have no skin among themselves */
    skin_moved(skin, &speed, 1, 0.1, 1.1);
    assert_true(skin_due(skin, &classes));
    speed = 2;
    skin_moved(skin, &speed, 1, 0.1, 0.9); /* particle 0.2, wall 0.9 */
    assert_true(skin_due(skin, &classes));
    skin_destroy(&skin);
}

static void test_nothing_moves(void **state) {
    (void)state;
    struct size_classes classes = {.count = 1}; /* no skin at all */
    struct skin *skin = skin_create();
    double speed = 0;
    skin_moved(skin, &speed, 1, 0.1, 0);
    assert_false(skin_due(skin, &classes));
    speed = 1e-9;
    skin_moved(skin, &speed, 1, 0.1, 0);
    assert_true(skin_due(skin, &classes));
    skin_destroy(&skin);
}

/* One step ahead, also right after a rebuild, when nothing has moved yet. */
static void test_the_next_step_is_foreseen(void **state) {
    (void)state;
    struct size_classes classes = one_class();
    struct skin *skin = skin_create();
    struct particles *none = particles_create(1);
    double speed = 2;
    skin_moved(skin, &speed, 1, 0.2, 0); /* 0.4 each, and 0.8 each after one step more */
    skin_settle(skin, 1);
    assert_false(skin_due(skin, &classes));
    assert_true(skin_nearly_due(skin, &classes));
    skin_reset(skin, none, &classes, 0);
    assert_false(skin_nearly_due(skin, &classes));
    skin_moved(skin, &speed, 1, 0.3, 0); /* 0.6 each */
    skin_settle(skin, 1);
    skin_reset(skin, none, &classes, 0);
    assert_true(skin_nearly_due(skin, &classes));
    assert_false(skin_due(skin, &classes));
    particles_destroy(&none);
    skin_destroy(&skin);
}

/* One drift after a rebuild the bound is what the fastest particle has moved; later it is only a bound. */
static void test_a_fast_particle_needs_no_measuring(void **state) {
    (void)state;
    struct size_classes classes = one_class();
    struct skin *skin = skin_create();
    struct particles *none = particles_create(1);
    double speed = 2;
    skin_reset(skin, none, &classes, 0);
    skin_moved(skin, &speed, 1, 0.4, 0); /* 0.8 each: two of them are too much, one alone is not */
    assert_true(skin_due(skin, &classes));
    assert_false(skin_surely_due(skin, &classes));
    skin_reset(skin, none, &classes, 0);
    skin_moved(skin, &speed, 1, 0.6, 0); /* 1.2 */
    assert_true(skin_surely_due(skin, &classes));
    skin_moved(skin, &speed, 1, 0.6, 0);
    assert_false(skin_surely_due(skin, &classes));
    particles_destroy(&none);
    skin_destroy(&skin);
}

/* A class pair that is not wanted has no skin to use up; walls count all the same. */
static void test_unwanted_pairs_use_up_nothing(void **state) {
    (void)state;
    struct size_classes classes = one_class();
    struct skin *skin = skin_create();
    struct particles *none = particles_create(1);
    double speed = 2;
    classes.skin[0][1] = classes.skin[1][0] = 2;
    skin_reset(skin, none, &classes, 0);
    skin_moved(skin, &speed, 1, 0.6, 0); /* 1.2 each */
    skin_settle(skin, 1);
    assert_true(skin_due(skin, &classes) && skin_surely_due(skin, &classes) &&
                skin_nearly_due(skin, &classes));
    classes.margin[0][0] = INDEX_NOT_WANTED;
    assert_false(skin_due(skin, &classes) || skin_surely_due(skin, &classes));
    assert_true(skin_nearly_due(skin, &classes)); /* to walls, after 2.4 */
    skin_moved(skin, &speed, 1, 0.6, 0);
    assert_true(skin_due(skin, &classes));
    skin_reset(skin, none, &classes, 0);
    skin_moved(skin, &speed, 1, 1.1, 0);
    assert_true(skin_surely_due(skin, &classes));
    particles_destroy(&none);
    skin_destroy(&skin);
}

/* Where the next rebuild comes by the number of steps, long before a skin is used up, no positions are noted. */
static void test_positions_are_noted_where_they_may_be_needed(void **state) {
    (void)state;
    struct size_classes classes = one_class();
    struct skin *skin = skin_create();
    struct particles *one = particles_create(1);
    double speed = 1;
    particles_append(one);
    skin_moved(skin, &speed, 1, 0.01, 0);
    skin_settle(skin, 1);
    skin_reset(skin, one, &classes, 20); /* at twice the speed 0.4 each */
    skin_moved(skin, &speed, 1, 0.6, 0); /* faster than foreseen */
    skin_measure(skin, one, 1);
    assert_true(skin->bound[0] == 0.6 && skin_due(skin, &classes));
    skin_reset(skin, one, &classes, 30); /* 0.6 each */
    skin_moved(skin, &speed, 1, 0.6, 0);
    skin_measure(skin, one, 1);
    assert_true(skin->bound[0] == 0 && !skin_due(skin, &classes));
    skin_reset(skin, one, &classes, 0); /* nobody knows when */
    one->state[0].x[1] = 0.25;
    skin_measure(skin, one, 1);
    assert_true(skin->bound[0] == 0.25);
    particles_destroy(&one);
    skin_destroy(&skin);
}

TEST_MAIN(skin, cmocka_unit_test(test_two_particles_share_the_skin),
          cmocka_unit_test(test_moving_walls_count_against_particles_alone),
          cmocka_unit_test(test_nothing_moves), cmocka_unit_test(test_the_next_step_is_foreseen),
          cmocka_unit_test(test_a_fast_particle_needs_no_measuring),
          cmocka_unit_test(test_unwanted_pairs_use_up_nothing),
          cmocka_unit_test(test_positions_are_noted_where_they_may_be_needed))
