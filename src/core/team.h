/* SPDX-License-Identifier: BSD-3-Clause */
/* How many of a run's threads work at a time. The work is dealt out to a fixed number of threads, and that
 * deal alone decides the bits; a team of fewer takes several threads' shares each. Where other programs use
 * the cores, a thread that the system has put aside holds up all others at each barrier, and one thread alone
 * may be several times faster than two. The team therefore measures itself: where its threads are put aside
 * it tries half as many for a twentieth of a second, and keeps what was faster; later it tries twice as many.
 * On cores of its own a team tries nothing.
 *
 * A part that is dealt out to `threads` is a loop over them: `#pragma omp parallel for schedule(static, 1)`
 * without num_threads. One thread calls these functions, outside of any parallel part. */
#ifndef SCREE_CORE_TEAM_H
#define SCREE_CORE_TEAM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a span of steps took. */
struct team_sample {
    double seconds;    /* by the clock */
    double work;       /* seconds of these in parts that are dealt out to threads */
    double processor;  /* seconds on processors, all threads together */
    int64_t put_aside; /* times that a thread lost its processor against its will */
    uint64_t steps;
};

/* Plain data. */
struct team {
    int most, size; /* threads that the work is dealt out to; threads that work */
    bool fixed;     /* the user said how many: watches, changes nothing */
    struct team_sample begun, usual, trial;
    int trying, before;                                /* spans left of a trial; size before it */
    int wait_down, wait_up, pause_down, pause_up, age; /* in spans */
    int crowded;                                       /* spans in which threads were put aside */
    bool shrunk;                                       /* ever */
    double thread_seconds, seconds;                    /* for team_mean */
};

/* Begins with all `threads` at work. */
void team_begin(struct team *team, int threads, bool fixed);

/* Keeps all threads busy for a hundredth of a second. Where the system puts them aside, the team begins with
 * as many as it had processors for. */
void team_probe(struct team *team);

/* Gives OpenMP back the number of threads that it had at the beginning. */
void team_end(const struct team *team);

/* Called after each step: `now` from timer_now, `work` as in a sample but since the start of the run. Once in
 * a twentieth of a second it looks at clocks, and may change the size of all teams from here on
 * (omp_set_num_threads). */
void team_step(struct team *team, double now, double work);

/* The decision alone: what one span was like. True if the size has changed. */
bool team_judge(struct team *team, const struct team_sample *sample);

/* The mean number of threads that worked; all of them before the first look. */
double team_mean(const struct team *team);

/* True if there is something to warn of: threads were put aside for a second, or are fewer for that reason.
 */
bool team_crowded(const struct team *team);

/* The warning, with the machine's load and cores. */
void team_describe(const struct team *team, char *text, size_t room);

#endif
