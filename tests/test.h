/* SPDX-License-Identifier: BSD-3-Clause */
/* CMocka with the headers that it needs, and the main of a test program. */
#ifndef SCREE_TESTS_TEST_H
#define SCREE_TESTS_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Defines the main of a program that runs these cases, each a cmocka_unit_test of any kind. `name` names them all in what
 * the program prints. A program on several ranks has TEAM_MAIN of tests/mpi/team.h. */
#define TEST_MAIN(name, ...) TEST_MAIN_GROUP(name, NULL, NULL, __VA_ARGS__)

/* The same with the functions to call before the first case and after the last; NULL: none. */
#define TEST_MAIN_GROUP(name, setup, teardown, ...)                                                          \
    int main(void) {                                                                                         \
        const struct CMUnitTest name##_cases[] = {__VA_ARGS__};                                              \
        return cmocka_run_group_tests_name(#name, name##_cases, setup, teardown);                            \
    }

#endif
