/* SPDX-License-Identifier: BSD-3-Clause */
/* The number of a run's threads that work at a time. The work is dealt out to a fixed number of threads, and
 * that deal alone decides the bits of the results. In a smaller team each thread takes the shares of several
 * threads. If other programs use the cores, a thread that the system has put aside holds up all others at
 * each barrier, and one thread alone may be several times faster than two. The team therefore measures
 * itself. If its threads are put aside, the team tries half as many threads for a twentieth of a second and
 * keeps the faster size; later the team tries twice as many. If its threads are never put aside, the team
 * tries nothing.
 *
 * A part that is dealt out to `threads` is a loop over the thread numbers:
 * `#pragma omp parallel for schedule(static, 1)` without num_threads. One thread calls these functions,
 * outside of any parallel part. */
#ifndef SCREE_BASE_TEAM_H
#define SCREE_BASE_TEAM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Time that a span of steps took. */
struct team_sample {
    double seconds;    /* by the clock */
    double work;       /* of `seconds`: in parts that are dealt out to threads */
    double processor;  /* seconds on processors, all threads together */
    int64_t put_aside; /* times that a thread lost its processor against its will */
    uint64_t steps;
};

/* Plain data. */
struct team {
    int most, size; /* threads that the work is dealt out to; threads that work */
    bool fixed;     /* the user chose the number: the team measures, and changes nothing */
    struct team_sample begun, usual, trial;
    int trying, before;                                /* spans left of a trial; size before the trial */
    int wait_down, wait_up, pause_down, pause_up, age; /* in spans */
    int crowded;                                       /* spans in which threads were put aside */
    bool shrunk;                                       /* the team has been reduced at least once */
    double thread_seconds, seconds;                    /* for team_mean */
};

/* Begins with all `threads` at work. */
void team_begin(struct team *team, int threads, bool fixed);

/* Keeps all threads busy for a hundredth of a second. If the system puts threads aside, the team begins with
 * as many threads as got processors. */
void team_probe(struct team *team);

/* Gives OpenMP back the number of threads that it had at the beginning. */
void team_end(const struct team *team);

/* Called after each step: `now` from timer_now, `work` as in a sample but since the start of the run. Once in
 * a twentieth of a second the function reads the clocks, and may change the size of all later teams
 * (omp_set_num_threads). */
void team_step(struct team *team, double now, double work);

/* Decides after one span, given as a sample. True if the size has changed. */
bool team_judge(struct team *team, const struct team_sample *sample);

/* The mean number of threads that worked; before the first reading of the clocks, the number of all
 * threads. */
double team_mean(const struct team *team);

/* True if a warning is due: threads were put aside for a second, or the team is smaller for that reason. */
bool team_crowded(const struct team *team);

/* The warning, with the machine's load and cores. */
void team_describe(const struct team *team, char *text, size_t room);

#endif
