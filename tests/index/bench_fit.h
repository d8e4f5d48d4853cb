/* SPDX-License-Identifier: BSD-3-Clause */
/* Prices of the cost model from measurements: non-negative least squares of relative errors. */
#ifndef SCREE_TESTS_INDEX_BENCH_FIT_H
#define SCREE_TESTS_INDEX_BENCH_FIT_H

#include "index/choose/cost.h"

/* One measured rebuild: events and seconds (of all threads together). */
struct bench_sample {
    double count[COST_TERMS];
    double seconds;
};

/* The root mean square of the relative errors of the samples' seconds by these prices. */
double bench_fit_error(const struct bench_sample *sample, int samples, const double price[COST_TERMS]);

/* The prices, nanoseconds, none below zero, that predict the samples best; returns the root mean square of
 * the relative errors. */
double bench_fit(const struct bench_sample *sample, int samples, double price[COST_TERMS]);

#endif
