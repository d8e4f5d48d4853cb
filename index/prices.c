/* SPDX-License-Identifier: BSD-3-Clause */
/* The prices of the steps of a search. Read prices.h first. */
#include "index/prices.h"

/* Nanoseconds an event, on an AMD EPYC (Zen 4), AVX-512: fit to 102 rebuilds of 14 packings, whose events the search
 * counted, with a relative error of 8 % (bench_index). Visits are so cheap that the fit cannot tell; mixed is an
 * estimate. */
static const double price[COST_TERMS] = {
    [COST_PARTICLE] = 31, [COST_CELL] = 4.5,  [COST_MIXED] = 60, [COST_WINDOW] = 4.2,
    [COST_VECTOR] = 1.2,  [COST_LONG] = 4.2,  [COST_VISIT] = 1,  [COST_RUN] = 12,
    [COST_ROUND] = 5,     [COST_SPARSE] = 20, [COST_TEST] = 1.8, [COST_SINGLE] = 90,
};

double prices_event(enum cost_term term) {
    return price[term];
}

/* Nanoseconds, estimated on an AMD EPYC (Zen 4), not fitted: a small particle looks at the large ones about
 * it; a large one looks up pencils of small ones and tests these. */
static const double row_price = 8, large_price = 0.25;
static const double single_price = 100, pencil_price = 12, sparse_price = 40, small_price = 0.25;

bool prices_from_larger(const struct prices_sides *sides) {
    double pencil = sides->sparse ? sparse_price : pencil_price;
    return sides->larger * (single_price + sides->pencils * pencil + sides->found_smaller * small_price) <
           sides->smaller * (row_price + sides->found_larger * large_price);
}
