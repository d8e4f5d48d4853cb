/* SPDX-License-Identifier: BSD-3-Clause */
/* The progress of a run on a terminal: a bar with the time left and particle-steps per second in a line that
 * fits the width of the terminal, or plain lines. Rank 0 alone. */
#ifndef SCREE_OBSERVE_PROGRESS_H
#define SCREE_OBSERVE_PROGRESS_H

#include "data/formats/output_options.h"
#include <stdio.h>

enum { PROGRESS_COLUMNS_MAX = 160 };

/* The place of a run among others. */
struct progress_series {
    const char *name; /* of this run; borrowed while the run lasts */
    int number, runs; /* number of this run, from 1; number of all runs */
    double after;     /* duration of all later runs, in units of the duration of this run */
};

/* Plain data, filled by progress_start. */
struct progress {
    FILE *file;                           /* borrowed */
    enum progress_mode mode;              /* never AUTO */
    const struct progress_series *series; /* borrowed; NULL: a run by itself */
    bool rare;                            /* lines: by time alone, not at each tenth */
    uint64_t first, last;                 /* steps of this run */
    double began, shown;                  /* seconds (timer_now) */
    double work;                          /* particle-steps so far */
    uint64_t step;                        /* last step reported */
    int tenths;                           /* lines: tenths already printed */
    /* Writes the last observables to `text`, "" if there are none; called for a drawing or line only. NULL: none.
     * Set after progress_start. */
    void (*last_values)(const void *context, char *text, size_t room);
    const void *context; /* of last_values */
};

/* Starts at step `first` of `last`, of a run by itself (series NULL) or of one of several. AUTO becomes BAR
 * if `file` is a terminal, else LINES by time alone: one after five seconds, later more rarely, up to one a
 * minute. */
void progress_start(struct progress *progress, const struct progress_options *options,
                    const struct progress_series *series, FILE *file, uint64_t first, uint64_t last);

/* Reports that `step` is done, with `particles` particles (all ranks); draws at most a few times a second. `time` is the
 * simulated time. The caller may have changed `last`; where the end is more than 2^60 steps away, nobody knows the end,
 * and a line begins with the step instead of a part and a time left. */
void progress_update(struct progress *progress, uint64_t step, uint64_t particles, double time);

/* Removes the bar. */
void progress_finish(struct progress *progress);

/* Formats a duration as "1:02:03" or "2:03" into text. */
void progress_duration(double seconds, char *text, size_t size);

/* Columns that a line on a terminal may fill without a break: one less than its width, at most
 * PROGRESS_COLUMNS_MAX; 79 where the width is not known. */
int progress_columns(FILE *file);

#endif
