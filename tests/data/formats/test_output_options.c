/* SPDX-License-Identifier: BSD-3-Clause */
/* When output is due. */
#include "tests/test.h"

#include "data/formats/output_options.h"

static void never_unless_asked(void **state) {
    (void)state;
    struct output_interval never = {0};
    assert_false(output_interval_set(&never));
    for (uint64_t step = 0; step < 10; step++)
        assert_false(output_interval_due(&never, step, 0.1 * (double)step, 0.1));
}

static void by_steps(void **state) {
    (void)state;
    struct output_interval interval = {.steps = 3};
    assert_true(output_interval_set(&interval));
    for (uint64_t step = 0; step < 20; step++)
        assert_int_equal(output_interval_due(&interval, step, 0, 1), step % 3 == 0);
}

/* A step length that divides the interval: exactly every tenth step, whatever rounding does. */
static void by_time_at_multiples(void **state) {
    (void)state;
    struct output_interval interval = {.time = 5e-6};
    double dt = 5e-7, time = 0;
    for (uint64_t step = 0; step < 100000; step++) {
        assert_int_equal(output_interval_due(&interval, step, (double)step * dt, dt), step % 10 == 0);
        /* also where the time is a sum of steps */
        assert_int_equal(output_interval_due(&interval, step, time, dt), step % 10 == 0);
        time += dt;
    }
}

/* One that does not: the first step at or after each multiple. */
static void by_time_between_multiples(void **state) {
    (void)state;
    struct output_interval interval = {.time = 1};
    double dt = 0.3;
    int due = 0;
    for (uint64_t step = 0; step < 1000; step++) {
        bool first = step == 0 || (long)((double)step * dt + 1e-9) > (long)((double)(step - 1) * dt + 1e-9);
        assert_int_equal(output_interval_due(&interval, step, (double)step * dt, dt), first);
        due += first;
    }
    assert_int_equal(due, 300);
}

/* An interval shorter than a step: every step. */
static void by_time_below_the_step(void **state) {
    (void)state;
    struct output_interval interval = {.time = 0.01};
    for (uint64_t step = 0; step < 100; step++)
        assert_true(output_interval_due(&interval, step, (double)step, 1));
}

static void defaults(void **state) {
    (void)state;
    struct output_options options = output_options_default();
    assert_true(options.trajectory.xdmf && options.checkpoint.at_end);
    assert_int_equal(options.checkpoint.keep, 2);
    assert_false(output_interval_set(&options.trajectory.every));
    assert_false(output_interval_set(&options.observables.every));
}

TEST_MAIN(output_options, cmocka_unit_test(never_unless_asked), cmocka_unit_test(by_steps),
          cmocka_unit_test(by_time_at_multiples), cmocka_unit_test(by_time_between_multiples),
          cmocka_unit_test(by_time_below_the_step), cmocka_unit_test(defaults))
