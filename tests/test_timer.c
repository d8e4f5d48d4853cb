/* SPDX-License-Identifier: BSD-3-Clause */
/* Timers: nested stages, names, counts. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <string.h>

#include "core/timer.h"

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

static void every_stage_has_a_name_of_its_own(void **state) {
    (void)state;
    for (int i = 0; i < TIMER_STAGES; i++) {
        const char *name = timer_stage_name((enum timer_stage)i);
        assert_non_null(name);
        assert_true(strlen(name) > 0);
        for (int j = 0; j < i; j++) {
            assert_string_not_equal(name, timer_stage_name((enum timer_stage)j));
        }
    }
}

/* Whatever the machine does in between, exclusive times must add up to the time that the outermost stage
 * spanned, and each must be at least what was spent in it. */
static void inner_time_is_not_charged_to_the_outer(void **state) {
    (void)state;
    struct timers timers = {0};
    double before = timer_now();
    timer_start(&timers, TIMER_OTHER);
    double outer = spend(0.002);
    timer_start(&timers, TIMER_PAIRS);
    double inner = spend(0.004);
    timer_start(&timers, TIMER_INDEX);
    double innermost = spend(0.003);
    timer_stop(&timers, TIMER_INDEX);
    inner += spend(0.001);
    timer_stop(&timers, TIMER_PAIRS);
    outer += spend(0.001);
    timer_stop(&timers, TIMER_OTHER);
    double span = timer_now() - before;
    double sum = 0;
    for (int i = 0; i < TIMER_STAGES; i++) {
        sum += timers.seconds[i];
    }
    assert_true(timers.seconds[TIMER_OTHER] >= outer);
    assert_true(timers.seconds[TIMER_PAIRS] >= inner);
    assert_true(timers.seconds[TIMER_INDEX] >= innermost);
    assert_true(timers.seconds[TIMER_OTHER] <= span - inner - innermost + 1e-9);
    assert_true(timers.seconds[TIMER_PAIRS] <= span - outer - innermost + 1e-9);
    assert_true(sum <= span + 1e-9);
    assert_int_equal(timers.depth, 0);
}

static void calls_are_counted(void **state) {
    (void)state;
    struct timers timers = {0};
    for (int i = 0; i < 5; i++) {
        timer_start(&timers, TIMER_CONTACT);
        timer_start(&timers, TIMER_CONTACT);
        timer_stop(&timers, TIMER_CONTACT);
        timer_stop(&timers, TIMER_CONTACT);
    }
    timer_start(&timers, TIMER_WALL);
    timer_stop(&timers, TIMER_WALL);
    assert_int_equal(timers.calls[TIMER_CONTACT], 10);
    assert_int_equal(timers.calls[TIMER_WALL], 1);
    assert_int_equal(timers.calls[TIMER_COMM], 0);
    assert_true(timers.seconds[TIMER_COMM] == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clock_is_monotonic),
        cmocka_unit_test(every_stage_has_a_name_of_its_own),
        cmocka_unit_test(inner_time_is_not_charged_to_the_outer),
        cmocka_unit_test(calls_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
