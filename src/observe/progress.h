/* The progress of a run on a terminal: a bar with the time left and particle-steps per second, or plain
 * lines. Rank 0 alone. */
#ifndef SCREE_OBSERVE_PROGRESS_H
#define SCREE_OBSERVE_PROGRESS_H

#include "formats/output_options.h"
#include <stdio.h>

/* Plain data, filled by progress_start. */
struct progress {
    FILE *file;              /* borrowed */
    enum progress_mode mode; /* never AUTO */
    uint64_t first, last;    /* steps of this run */
    double began, shown;     /* seconds (timer_now) */
    double work;             /* particle-steps so far */
    uint64_t step;           /* last one told */
    int tenths;              /* lines: tenths already printed */
};

/* Starts at step `first` of `last`. AUTO becomes BAR if `file` is a terminal, else OFF. */
void progress_start(struct progress *progress, const struct progress_options *options, FILE *file,
                    uint64_t first, uint64_t last);

/* Tells that `step` is done, with `particles` particles (all ranks); draws at most a few times a second.
 * `time` is the simulated time. */
void progress_update(struct progress *progress, uint64_t step, uint64_t particles, double time);

/* Removes the bar. */
void progress_finish(struct progress *progress);

/* Formats a duration as "1:02:03" or "2:03" into text. */
void progress_duration(double seconds, char *text, size_t size);

#endif
