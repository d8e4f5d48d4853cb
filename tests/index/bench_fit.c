/* SPDX-License-Identifier: BSD-3-Clause */
/* Fits the prices. Read bench_fit.h first. */
#include "tests/index/bench_fit.h"

#include <math.h>

enum { ROUNDS = 20000 };

/* Relative error of a sample under the prices. */
static double error_of(const struct bench_sample *sample, const double price[COST_TERMS]) {
    double seconds = 0;
    for (int t = 0; t < COST_TERMS; t++) {
        seconds += price[t] * 1e-9 * sample->count[t];
    }
    return seconds / sample->seconds - 1;
}

double bench_fit_error(const struct bench_sample *sample, int samples, const double price[COST_TERMS]) {
    double sum = 0;
    for (int k = 0; k < samples; k++) {
        sum += pow(error_of(&sample[k], price), 2);
    }
    return sqrt(sum / samples);
}

double bench_fit(const struct bench_sample *sample, int samples, double price[COST_TERMS]) {
    for (int t = 0; t < COST_TERMS; t++) {
        price[t] = 0;
    }
    for (int round = 0; round < ROUNDS; round++) {
        for (int t = 0; t < COST_TERMS; t++) {
            double slope = 0, curve = 0;
            for (int k = 0; k < samples; k++) {
                double share = 1e-9 * sample[k].count[t] / sample[k].seconds;
                slope += error_of(&sample[k], price) * share;
                curve += share * share;
            }
            price[t] = curve > 0 ? fmax(0, price[t] - slope / curve) : 0;
        }
    }
    return bench_fit_error(sample, samples, price);
}
