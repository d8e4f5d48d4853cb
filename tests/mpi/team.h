/* SPDX-License-Identifier: BSD-3-Clause */
/* What tests under mpirun share. All ranks run the same tests side by side, so a rank that fails may not stop
 * alone, or the others would wait for it: failures are collected, and agreed upon at the end of a test. */
#ifndef SCREE_TESTS_MPI_TEAM_H
#define SCREE_TESTS_MPI_TEAM_H

#include "comm/comm.h"

struct team {
    struct comm comm;
    struct error error; /* the first failure of this rank in this test */
};

/* Starts MPI; ranks other than 0 keep quiet on stdout. Stop ends it, and returns 1 if this rank still holds
 * memory from core/memory.h, else 0. */
void team_start(struct team *team, int *argc, char ***argv);
int team_stop(struct team *team);

/* Notes a failure, with the place, unless `good`. Returns `good`. */
#define team_expect(team, good, ...) team_note(team, good, __FILE__, __LINE__, __VA_ARGS__)
bool team_note(struct team *team, bool good, const char *file, int line, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* Ends a test that these ranks cannot make, and says why. All ranks alike. */
_Noreturn void team_skip(const struct team *team, const char *why);

/* Ends a test: fails it on all ranks if it failed on one. Collective. */
void team_finish(struct team *team);

#endif
