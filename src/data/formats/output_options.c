/* SPDX-License-Identifier: BSD-3-Clause */
/* Decides when an interval is due; the defaults of the output. Read output_options.h first. */
#include "data/formats/output_options.h"

#include <math.h>

bool output_interval_set(const struct output_interval *interval) {
    return interval->steps > 0 || interval->time > 0;
}

/* Multiples of the interval up to a time. A multiple counts as reached a little early, so that rounding in
 * the sum of steps shifts no output by a step. */
static double multiples(double time, double interval) {
    return floor(time / interval + 1e-6);
}

bool output_interval_due(const struct output_interval *interval, uint64_t step, double time, double dt) {
    if (!output_interval_set(interval))
        return false;
    if (step == 0)
        return true;
    if (interval->steps > 0)
        return step % interval->steps == 0;
    return multiples(time, interval->time) > multiples(time - dt, interval->time);
}

struct output_options output_options_default(void) {
    return (struct output_options){.trajectory = {.xdmf = true, .units = true},
                                   .checkpoint = {.keep = 2, .at_end = true}};
}
