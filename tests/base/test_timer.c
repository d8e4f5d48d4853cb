/* SPDX-License-Identifier: BSD-3-Clause */
/* Timers: nested stages, names, counts. */
#include "tests/test.h"

#include <string.h>

#include "base/timer.h"

/* Busy until `seconds` have gone by; returns how long it really took. */
static double spend(double seconds) {
    double begin = timer_now();
    double now = begin;
    while (now - begin < seconds) {
        now = timer_now();
    }
    return now - begin;
}

static void clock_is_monotonic(void **state) {
    (void)state;
    double last = timer_now();
    for (int i = 0; i < 10000; i++) {
        double now = timer_now();
        assert_true(now >= last);
        last = now;
    }
}

static void a_name_is_registered_once(void **state) {
    (void)state;
    struct timers timers = {0};
    assert_int_equal(timer_find(&timers, "pairs"), -1);
    int pairs = timer_register(&timers, "pairs", "pair list", TIMER_WORK | TIMER_REBUILD);
    int comm = timer_register(&timers, "comm", "exchange", TIMER_WAIT);
    assert_int_equal(timer_register(&timers, "pairs", "another", TIMER_WAIT), pairs);
    assert_int_equal(timers.stages, 2);
    assert_int_equal(timer_find(&timers, "comm"), comm);
    assert_string_equal(timers.stage[pairs].help, "pair list");
    timers.stage[pairs].seconds = 2;
    timers.stage[comm].seconds = 3;
    assert_true(timer_sum(&timers, 0, 0) == 5 && timer_sum(&timers, TIMER_WORK, 0) == 2);
    assert_true(timer_sum(&timers, 0, TIMER_REBUILD) == 3 && timer_sum(&timers, TIMER_START, 0) == 0);
    timer_clear(&timers);
    assert_true(timer_sum(&timers, 0, 0) == 0 && timers.stages == 2);
}

/* Whatever the machine does in between, exclusive times must add up to the time that the outermost stage
 * spanned, and each must be at least what was spent in it. */
static void inner_time_is_not_charged_to_the_outer(void **state) {
    (void)state;
    struct timers timers = {0};
    int other = timer_register(&timers, "other", "", 0), pairs = timer_register(&timers, "pairs", "", 0),
        index = timer_register(&timers, "index", "", 0);
    double before = timer_now();
    timer_start(&timers, other);
    double outer = spend(0.002);
    timer_start(&timers, pairs);
    double inner = spend(0.004);
    timer_start(&timers, index);
    double innermost = spend(0.003);
    timer_stop(&timers, index);
    inner += spend(0.001);
    timer_stop(&timers, pairs);
    outer += spend(0.001);
    timer_stop(&timers, other);
    double span = timer_now() - before;
    double sum = 0;
    for (int i = 0; i < timers.stages; i++)
        sum += timers.stage[i].seconds;
    assert_true(timers.stage[other].seconds >= outer);
    assert_true(timers.stage[pairs].seconds >= inner);
    assert_true(timers.stage[index].seconds >= innermost);
    assert_true(timers.stage[other].seconds <= span - inner - innermost + 1e-9);
    assert_true(timers.stage[pairs].seconds <= span - outer - innermost + 1e-9);
    assert_true(sum <= span + 1e-9);
    assert_int_equal(timers.depth, 0);
}

static void calls_are_counted(void **state) {
    (void)state;
    struct timers timers = {0};
    int contact = timer_register(&timers, "contact", "", 0), wall = timer_register(&timers, "wall", "", 0),
        comm = timer_register(&timers, "comm", "", 0);
    for (int i = 0; i < 5; i++) {
        timer_start(&timers, contact);
        timer_start(&timers, contact);
        timer_stop(&timers, contact);
        timer_stop(&timers, contact);
    }
    timer_start(&timers, wall);
    timer_stop(&timers, wall);
    assert_int_equal(timers.stage[contact].calls, 10);
    assert_int_equal(timers.stage[wall].calls, 1);
    assert_int_equal(timers.stage[comm].calls, 0);
    assert_true(timers.stage[comm].seconds == 0);
}

TEST_MAIN(timer, cmocka_unit_test(clock_is_monotonic), cmocka_unit_test(a_name_is_registered_once),
          cmocka_unit_test(inner_time_is_not_charged_to_the_outer), cmocka_unit_test(calls_are_counted))
