/* SPDX-License-Identifier: BSD-3-Clause */
/* Measures whether other programs use the cores, and chooses the size of the team. Read team.h first. */
#include "base/team.h"
#include "base/timer.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

/* In seconds: the length of a span, and of the probe at the start. In spans: the length of a trial, the pause
 * from a failed trial to the next (doubled after each failed trial), and the crowded spans until a
 * warning. A trial whose steps take HOPELESS times as long as usual ends with its first span. */
#define SPAN 0.025
#define PROBE 0.01
#define HOPELESS 2
enum { SPAN_STEPS = 4, TRIAL = 2, PAUSE_FIRST = 40, PAUSE_MOST = 1200, CROWDED_WARN = 40 };

void team_begin(struct team *team, int threads, bool fixed) {
    *team = (struct team){.most = threads,
                          .size = threads,
                          .fixed = fixed,
                          .wait_down = 1,
                          .wait_up = PAUSE_FIRST,
                          .pause_down = PAUSE_FIRST,
                          .pause_up = PAUSE_FIRST};
}

void team_end(const struct team *team) {
    if (team->size != team->most)
        omp_set_num_threads(team->most);
}

static double pace(const struct team_sample *sample) {
    return sample->work / (double)sample->steps;
}

/* Adds a span; older spans count less and less. */
static void remember(struct team_sample *sum, const struct team_sample *more, double weight) {
    sum->work = weight * sum->work + more->work;
    sum->steps = (uint64_t)(weight * (double)sum->steps) + more->steps;
}

/* True if threads were put aside, and the threads got less than nine tenths of the processor time that they
 * asked for. */
static bool is_crowded(const struct team *team, const struct team_sample *sample) {
    return sample->put_aside > 0 && sample->processor < 0.9 * team->size * sample->seconds;
}

static void try_size(struct team *team, int size) {
    team->before = team->size;
    team->size = size;
    team->trial = (struct team_sample){0};
    team->trying = TRIAL;
}

static int longer(int pause) {
    return pause < PAUSE_MOST / 2 ? 2 * pause : PAUSE_MOST;
}

/* Ends a trial: fewer threads are kept if they are no slower, more threads if they gain a tenth. */
static bool conclude(struct team *team) {
    bool down = team->size < team->before;
    bool keep = pace(&team->trial) < (down ? 1.0 : 0.9) * pace(&team->usual);
    if (down)
        team->pause_down = keep ? PAUSE_FIRST : longer(team->pause_down);
    else if (!keep)
        team->pause_up = longer(team->pause_up);
    else
        team->age = 0;
    if (down && keep && team->age < PAUSE_MOST)
        team->pause_up = team->shrunk ? longer(team->pause_up) : PAUSE_FIRST;
    team->shrunk = team->shrunk || (down && keep);
    team->wait_down = keep && !down ? TRIAL : team->pause_down;
    team->wait_up = team->pause_up;
    if (keep) {
        team->usual = team->trial;
        return false;
    }
    team->size = team->before;
    return true;
}

bool team_judge(struct team *team, const struct team_sample *sample) {
    if (sample->steps == 0 || team->most < 2)
        return false;
    if (team->trying > 0) {
        remember(&team->trial, sample, 1);
        if (pace(&team->trial) > HOPELESS * pace(&team->usual))
            team->trying = 1;
        return --team->trying == 0 && conclude(team);
    }
    bool crowded = is_crowded(team, sample);
    remember(&team->usual, sample, 0.5);
    team->crowded += crowded;
    team->age++;
    if (team->age == PAUSE_MOST)
        team->pause_up = PAUSE_FIRST;
    team->wait_down -= team->wait_down > 0;
    team->wait_up -= team->wait_up > -PAUSE_MOST;
    if (team->fixed)
        return false;
    if (team->size < team->most && team->wait_up <= 0 && (!crowded || team->wait_up == -PAUSE_MOST))
        try_size(team, 2 * team->size < team->most ? 2 * team->size : team->most);
    else if (team->size > 1 && crowded && team->wait_down == 0)
        try_size(team, (team->size + 1) / 2);
    else
        return false;
    return true;
}

static struct team_sample clocks(double now, double work) {
    struct timespec processor;
    struct rusage use;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &processor);
    getrusage(RUSAGE_SELF, &use);
    return (struct team_sample){.seconds = now,
                                .work = work,
                                .processor = (double)processor.tv_sec + 1e-9 * (double)processor.tv_nsec,
                                .put_aside = use.ru_nivcsw};
}

/* Keeps all threads busy until `end`. */
static void spin(double end) {
#pragma omp parallel
    while (timer_now() < end)
        ;
}

void team_probe(struct team *team) {
    if (team->fixed || team->most < 2)
        return;
    spin(timer_now()); /* makes the threads */
    double begun = timer_now();
    struct team_sample sample = clocks(begun, 0);
    spin(begun + PROBE);
    double ended = timer_now();
    struct team_sample after = clocks(ended, 0);
    sample = (struct team_sample){.seconds = ended - begun,
                                  .processor = after.processor - sample.processor,
                                  .put_aside = after.put_aside - sample.put_aside};
    if (!is_crowded(team, &sample))
        return;
    int got = (int)(sample.processor / sample.seconds);
    team->size = got > 1 ? got : 1;
    team->shrunk = true;
    team->wait_up = TRIAL;
    omp_set_num_threads(team->size);
}

void team_step(struct team *team, double now, double work) {
    if (team->most < 2)
        return;
    struct team_sample *begun = &team->begun;
    if (begun->seconds == 0) {
        *begun = clocks(now, work);
        return;
    }
    begun->steps++;
    if (now - begun->seconds < SPAN || begun->steps < (team->trying > 0 ? 1 : SPAN_STEPS))
        return;
    struct team_sample sample = clocks(now, work), next = sample;
    sample.seconds -= begun->seconds;
    sample.work -= begun->work;
    sample.processor -= begun->processor;
    sample.put_aside -= begun->put_aside;
    sample.steps = begun->steps;
    team->thread_seconds += team->size * sample.seconds;
    team->seconds += sample.seconds;
    if (team_judge(team, &sample))
        omp_set_num_threads(team->size);
    *begun = next;
}

double team_mean(const struct team *team) {
    return team->seconds > 0 ? team->thread_seconds / team->seconds : team->most;
}

bool team_crowded(const struct team *team) {
    return team->shrunk || team->crowded >= CROWDED_WARN;
}

void team_describe(const struct team *team, char *text, size_t room) {
    double load = NAN;
    char what[160];
    if (getloadavg(&load, 1) != 1)
        load = NAN;
    if (team->fixed)
        snprintf(
            what, sizeof what,
            "the %d threads wait for each other; fewer may be faster, and without 'threads' the run finds "
            "out how many",
            team->most);
    else
        snprintf(what, sizeof what,
                 "of %d threads so many work at a time as are fastest; results are the same", team->most);
    snprintf(text, room, "other programs use the cores (load %.3g on %ld cores): %s", load,
             sysconf(_SC_NPROCESSORS_ONLN), what);
}
