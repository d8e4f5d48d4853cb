/* SPDX-License-Identifier: BSD-3-Clause */
/* Shared parts of the tests under mpirun. All ranks run the same tests side by side. A rank that fails may not
 * stop alone, because the other ranks would wait for this rank: the tests collect failures, and all ranks agree
 * on the failures at the end of a test. */
#ifndef SCREE_TESTS_MPI_TEAM_H
#define SCREE_TESTS_MPI_TEAM_H

#include "kernel/comm/comm.h"

struct team {
    struct comm comm;
    struct error error; /* the first failure of this rank in this test */
};

/* Starts MPI; ranks other than 0 keep quiet on stdout. Stop ends MPI, and returns 1 if this rank still holds
 * memory from base/memory.h, else 0. */
void team_start(struct team *team, int *argc, char ***argv);
int team_stop(struct team *team);

/* Notes a failure, with the place, unless `good`. Returns `good`. */
#define team_expect(team, good, ...) team_note(team, good, __FILE__, __LINE__, __VA_ARGS__)
bool team_note(struct team *team, bool good, const char *file, int line, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* Ends a test that these ranks cannot make, and prints the reason. All ranks alike. */
_Noreturn void team_skip(const struct team *team, const char *why);

/* Ends a test; the test fails on all ranks if it failed on one. Collective. */
void team_finish(struct team *team);

/* Defines the main of a program that runs these cases, each a team_case(FUNCTION), which gets the team as its state, or a
 * cmocka_unit_test of any kind. `name` names them all in what the program prints. */
#define TEAM_MAIN(name, ...)                                                                                 \
    int main(int argc, char **argv) {                                                                        \
        struct team team;                                                                                    \
        team_start(&team, &argc, &argv);                                                                     \
        const struct CMUnitTest name##_cases[] = {__VA_ARGS__};                                              \
        int failed = cmocka_run_group_tests_name(#name, name##_cases, NULL, NULL);                           \
        return team_stop(&team) + failed;                                                                    \
    }
#define team_case(function) cmocka_unit_test_prestate(function, &team)

#endif
