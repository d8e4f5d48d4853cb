/* SPDX-License-Identifier: BSD-3-Clause */
/* Trials of the variants that an index offers: each variant for two rebuilds. Only the second rebuild counts,
 * as the first one sorts particles into a new order. */
#include "engine/tune.h"
#include <math.h>

void tune_begin(struct tuning *tuning) {
    tuning->start = timer_now();
}

void tune_select(struct search *search) {
    index_select(search->index, search->tuning.variant);
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

void tune_end(struct search *search, const struct comm *comm) {
    struct tuning *tuning = &search->tuning;
    struct index_description description;
    double seconds = timer_now() - tuning->start, offered = index_trials(search->index);
    index_describe(search->index, &description);
    int64_t choices = (int64_t)description.choices;
    comm_max(comm, &seconds, 1);
    comm_min(comm, &offered, 1);
    comm_sum_int(comm, &choices, 1);
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

double tune_measured(const struct search *search) {
    double builds = search->index->builds > 0 ? (double)search->index->builds : 1;
    return (search->index->order_seconds + search->index->build_seconds + search->pairs_seconds) / builds;
}
