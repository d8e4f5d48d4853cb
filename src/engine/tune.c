/* SPDX-License-Identifier: BSD-3-Clause */
/* Trials of the variants that an index offers: each variant for two rebuilds. Only the second rebuild counts,
 * as the first one sorts particles into a new order. */
#include "engine/tune.h"
#include <math.h>

void tune_begin(struct simulation *s) {
    s->search.tuning.start = timer_now();
}

void tune_select(struct simulation *s) {
    if (s->scene->index.measure)
        index_select(s->search.index, s->search.tuning.variant);
}

static void restart(struct tuning *tuning, int64_t choices) {
    *tuning = (struct tuning){.choices = choices};
    for (int k = 0; k < TUNING_VARIANTS_MAX; k++)
        tuning->seconds[k] = INFINITY;
}

static int fastest(const struct tuning *tuning, int variants) {
    int best = 0;
    for (int k = 1; k < variants; k++)
        if (tuning->seconds[k] < tuning->seconds[best])
            best = k;
    return best;
}

void tune_end(struct simulation *s) {
    struct tuning *tuning = &s->search.tuning;
    struct index_description description;
    if (!s->scene->index.measure)
        return;
    double seconds = timer_now() - tuning->start, offered = index_trials(s->search.index);
    index_describe(s->search.index, &description);
    int64_t choices = (int64_t)description.choices;
    comm_max(s->comm, &seconds, 1);
    comm_min(s->comm, &offered, 1);
    comm_sum_int(s->comm, &choices, 1);
    int variants = (int)fmin(offered, TUNING_VARIANTS_MAX);
    if (choices != tuning->choices) {
        restart(tuning, choices);
        return;
    }
    if (tuning->settled || variants == 0)
        return;
    tuning->seconds[tuning->variant] = seconds;
    if (++tuning->rebuilds < 2)
        return;
    tuning->rebuilds = 0;
    tuning->settled = ++tuning->variant == variants;
    if (tuning->settled)
        tuning->variant = fastest(tuning, variants);
}

double tune_measured(const struct simulation *s) {
    double builds = s->search.index->builds > 0 ? (double)s->search.index->builds : 1;
    return (s->search.index->order_seconds + s->search.index->build_seconds + s->search.pairs_seconds) /
           builds;
}
