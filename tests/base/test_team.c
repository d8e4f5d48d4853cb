/* SPDX-License-Identifier: BSD-3-Clause */
/* How many threads work at a time, on machines made of a few formulas: cores of its own, cores that others
 * use. */
#include "tests/test.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "base/team.h"
#include "tests/near.h"

/* A machine: seconds that a step takes with so many threads, the share of their time that threads get, and
 * how often they are put aside in a span. */
struct machine {
    double (*pace)(int threads);
    double (*share)(int threads);
    int put_aside;
};

static double alone_pace(int threads) {
    return 1e-3 / threads;
}
static double alone_share(int threads) {
    (void)threads;
    return 1;
}
/* Two cores, on each a busy loop: a single thread gets two thirds of a core, two wait for each other. */
static double busy_pace(int threads) {
    return threads == 1 ? 1.5e-3 : 10e-3;
}
static double busy_share(int threads) {
    return threads == 1 ? 0.67 : 0.5;
}
/* One other program: a single thread has a core of its own. */
static double one_busy_share(int threads) {
    return threads == 1 ? 1 : 0.75;
}
/* Two threads are put aside, and are the faster ones all the same. */
static double crowded_pace(int threads) {
    return threads == 1 ? 2e-3 : 1.2e-3;
}
/* Sixteen cores of which others use twelve. */
static double many_pace(int threads) {
    return threads > 4 ? 4e-3 : 1e-3 / threads;
}
static double many_share(int threads) {
    return threads > 4 ? 0.6 : 1;
}
/* A part of the step is done by one thread. */
static double serial_share(int threads) {
    return threads == 1 ? 1 : 0.6;
}

static const struct machine alone = {alone_pace, alone_share, 0};
static const struct machine noisy = {alone_pace, alone_share, 1};
static const struct machine serial = {alone_pace, serial_share, 0};
static const struct machine busy = {busy_pace, busy_share, 3};
static const struct machine one_busy = {busy_pace, one_busy_share, 3};
static const struct machine crowded = {crowded_pace, busy_share, 3};
static const struct machine many = {many_pace, many_share, 5};

/* The mean number of threads over so many spans of a fortieth of a second. */
static double spans(struct team *team, const struct machine *machine, int count) {
    double sum = 0;
    for (int k = 0; k < count; k++) {
        const double seconds = 0.025, pace = machine->pace(team->size);
        struct team_sample sample = {.seconds = seconds,
                                     .work = seconds,
                                     .processor = machine->share(team->size) * team->size * seconds,
                                     .put_aside = machine->put_aside,
                                     .steps = (uint64_t)ceil(seconds / pace)};
        sample.work = pace * (double)sample.steps;
        sum += team->size;
        int before = team->size;
        bool changed = team_judge(team, &sample);
        assert_int_equal(changed, team->size != before);
    }
    return sum / count;
}

static struct team team_of(int threads, bool fixed) {
    struct team team;
    team_begin(&team, threads, fixed);
    return team;
}

static void test_cores_of_its_own(void **state) {
    (void)state;
    const struct machine *quiet[] = {&alone, &noisy, &serial};
    for (int m = 0; m < 3; m++) {
        struct team team = team_of(8, false);
        assert_true(spans(&team, quiet[m], 20000) == 8.0);
        assert_false(team_crowded(&team));
    }
}

static void test_busy_cores(void **state) {
    (void)state;
    const struct machine *machine[] = {&busy, &one_busy};
    for (int m = 0; m < 2; m++) {
        struct team team = team_of(2, false);
        spans(&team, machine[m], 4);
        assert_int_equal(team.size, 1);
        assert_true(team_crowded(&team));
        assert_true(spans(&team, machine[m], 400) < 1.05); /* ten seconds */
        assert_true(spans(&team, machine[m], 20000) < 1.01);
    }
}

/* A trial of more threads that are many times slower takes a span, not two. */
static void test_hopeless_trial_is_short(void **state) {
    (void)state;
    struct team team = team_of(2, false);
    spans(&team, &busy, 4);
    int trials = 0;
    for (int k = 0; k < 2000; k++) {
        bool tried = spans(&team, &busy, 1) == 2;
        trials += tried;
        if (tried)
            assert_int_equal(team.size, 1);
    }
    assert_in_range(trials, 1, 20);
}

static void test_threads_come_back(void **state) {
    (void)state;
    struct team team = team_of(2, false);
    spans(&team, &busy, 1000);
    assert_int_equal(team.size, 1);
    spans(&team, &alone, 10);
    assert_int_equal(team.size, 2);
    assert_true(spans(&team, &alone, 2000) == 2.0);
}

static void test_all_threads_where_they_are_faster(void **state) {
    (void)state;
    struct team team = team_of(2, false);
    assert_true(spans(&team, &crowded, 20000) > 1.99);
    assert_int_equal(team.size, 2);
    assert_true(team_crowded(&team));
}

static void test_as_many_as_have_cores(void **state) {
    (void)state;
    struct team team = team_of(16, false);
    spans(&team, &many, 100);
    assert_true(spans(&team, &many, 20000) < 4.2);
    assert_int_equal(team.size, 4);
    spans(&team, &alone, 3000);
    assert_int_equal(team.size, 16);
}

static void test_a_number_that_the_user_gave(void **state) {
    (void)state;
    struct team team = team_of(2, true);
    assert_true(spans(&team, &busy, 1000) == 2.0);
    assert_true(team_crowded(&team));
    char text[400];
    team_describe(&team, text, sizeof text);
    assert_non_null(strstr(text, "load "));
    assert_non_null(strstr(text, " cores)"));
    assert_non_null(strstr(text, "the 2 threads"));
}

static void test_one_thread(void **state) {
    (void)state;
    struct team team = team_of(1, false);
    team_probe(&team);
    assert_true(spans(&team, &busy, 1000) == 1.0);
    assert_false(team_crowded(&team));
}

/* Steps of a hundred seconds by a clock of the test, in which threads were put aside and got next to no processor; fewer
 * threads are faster. OpenMP's teams have the size that is said, and the mean is that over the steps. */
static void test_openmp_follows(void **state) {
    (void)state;
    omp_set_num_threads(3);
    struct team team = team_of(3, false);
    double now = 1, work = 0, sizes = 0;
    int steps = 0, seen[4] = {0};
    team_step(&team, now, work); /* reads the clocks alone */
    for (; steps < 400; steps++) {
        int members = 0;
#pragma omp parallel reduction(+ : members)
        members++;
        assert_int_equal(members, team.size);
        assert_in_range(members, 1, 3);
        seen[members]++;
        sizes += members;
        now += 100;
        work += 100.0 * members;
        team.begun.put_aside -= 1;
        team_step(&team, now, work);
    }
    assert_true(team.begun.steps == 0); /* the last step ended a span */
    assert_true(seen[2] > 0 && seen[1] > seen[3] + seen[2]);
    assert_near(team_mean(&team), sizes / steps, 1e-12);
    team_end(&team);
    assert_int_equal(omp_get_max_threads(), 3);
}

/* The probe keeps a number of threads between one and all, and a number that the user gave. */
static void test_probe(void **state) {
    (void)state;
    struct team team = team_of(3, true);
    team_probe(&team);
    assert_int_equal(team.size, 3);
    team_begin(&team, 3, false);
    team_probe(&team);
    assert_in_range(team.size, 1, 3);
    assert_true(team.shrunk == (team_crowded(&team)) && (team.shrunk || team.size == 3));
    assert_int_equal(omp_get_max_threads(), team.size);
    team_end(&team);
}

TEST_MAIN(team, cmocka_unit_test(test_cores_of_its_own), cmocka_unit_test(test_busy_cores),
          cmocka_unit_test(test_hopeless_trial_is_short), cmocka_unit_test(test_threads_come_back),
          cmocka_unit_test(test_all_threads_where_they_are_faster),
          cmocka_unit_test(test_as_many_as_have_cores), cmocka_unit_test(test_a_number_that_the_user_gave),
          cmocka_unit_test(test_one_thread), cmocka_unit_test(test_openmp_follows),
          cmocka_unit_test(test_probe))
