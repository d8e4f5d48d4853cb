/* SPDX-License-Identifier: BSD-3-Clause */
/* The events that the cost model predicts for a rebuild are those that the search counts, for packings of many kinds,
 * on the grids that `auto` chooses and on others. */
#include "tests/test.h"

#include "index/choose/auto_choose.h"
#include "tests/index/bench_events.h"

#include <math.h>

struct packing_case {
    const char *name;
    struct bench_spec spec;
    int levels; /* of equal occupancy; 0: as auto chooses, with its cells */
    double factor;
};

#define ONE .law = "power", .ratio = 1
#define TWO(r, share) .law = "bidisperse", .ratio = (r), .large = (share)

static const struct packing_case cases[] = {
    {"one size, auto", {ONE, .particles = 12000, .fraction = 0.4, .skin = 0.3}, 0, 0},
    {"one size, cells of the cut-off", {ONE, .particles = 12000, .fraction = 0.4, .skin = 0.3}, 1, 1},
    {"one size, two cut-offs", {ONE, .particles = 12000, .fraction = 0.4, .skin = 0.3}, 1, 2},
    {"gas, auto", {ONE, .particles = 12000, .fraction = 0.001, .skin = 0.3}, 0, 0},
    {"dilute, cells of the cut-off", {ONE, .particles = 12000, .fraction = 0.02, .skin = 0.3}, 1, 1},
    {"two sizes, ratio 2, auto", {TWO(2, 0.2), .particles = 12000, .fraction = 0.3, .skin = 0.3}, 0, 0},
    {"two sizes, ratio 4, auto", {TWO(4, 0.02), .particles = 16000, .fraction = 0.4, .skin = 0.3}, 0, 0},
    {"two sizes, ratio 4, two levels",
     {TWO(4, 0.1), .particles = 12000, .fraction = 0.3, .skin = 0.3},
     2,
     1.4},
    {"two sizes, ratio 10, auto", {TWO(10, 4e-4), .particles = 20000, .fraction = 0.4, .skin = 0.3}, 0, 0},
    {"two sizes, ratio 20, auto", {TWO(20, 1e-4), .particles = 30000, .fraction = 0.3, .skin = 0.3}, 0, 0},
    {"power law of ratio 8, auto",
     {.law = "power", .exponent = 0, .ratio = 8, .particles = 12000, .fraction = 0.35, .skin = 0.3},
     0,
     0},
    {"power law of ratio 50, auto",
     {.law = "power", .exponent = -3, .ratio = 50, .particles = 20000, .fraction = 0.4},
     0,
     0},
    {"power law of ratio 50, four levels",
     {.law = "power", .exponent = -3, .ratio = 50, .particles = 20000, .fraction = 0.4},
     4,
     1.4},
    {"lognormal of ratio 20, auto",
     {.law = "lognormal", .ratio = 20, .particles = 12000, .fraction = 0.35, .skin = 0.3},
     0,
     0},
    {"exponential, auto",
     {.law = "exponential", .ratio = 12, .particles = 12000, .fraction = 0.4, .skin = 0.3},
     0,
     0},
    {"boulders, auto",
     {.law = "boulder", .ratio = 8, .large = 5, .particles = 20000, .fraction = 0.05, .skin = 0.3},
     0,
     0},
};

static double priced(const double count[COST_TERMS]) {
    double sum = 0;
    for (int t = 0; t < COST_TERMS; t++) {
        sum += count[t] * prices_event((enum cost_term)t);
    }
    return sum;
}

/* The number of things that differ by more than 6 % of the cost: the cost, and each part of it. Prints the parts as predicted
 * and as counted. */
static int compare(const struct packing_case *of, int levels, const double predicted[COST_TERMS],
                   const double counted[COST_TERMS]) {
    const double whole = priced(counted), bound = 0.06;
    int wrong = fabs(priced(predicted) / whole - 1) > bound;
    printf("%-36s %d levels: %.3f", of->name, levels, priced(predicted) / whole);
    for (int t = 0; t < COST_TERMS; t++) {
        const double price = prices_event((enum cost_term)t) / whole, share = counted[t] * price,
                     as_predicted = predicted[t] * price;
        if (share > 0.02 || as_predicted > 0.02) {
            printf(" %s %.3f/%.3f", cost_name((enum cost_term)t), as_predicted, share);
        }
        wrong += fabs(as_predicted - share) > bound;
    }
    printf("\n");
    return wrong;
}

static void events_are_those_of_the_search(void **state) {
    (void)state;
    static struct cost_scene scene;
    static struct cost_sheet sheet;
    int wrong = 0;
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        const struct packing_case *of = &cases[k];
        struct bench_scene packing;
        struct cost_plan plan;
        double predicted[COST_TERMS], counted[COST_TERMS];
        bench_scene_make(&packing, &of->spec);
        bench_describe(&packing.view, of->spec.skin, &scene);
        if (of->levels > 0) {
            auto_equal(&scene, of->levels, &plan);
        } else {
            auto_levels(&scene, INDEX_CLASS_MAX, &plan);
        }
        for (int g = 0; g < plan.levels && of->factor > 0; g++) {
            plan.edge[g] = of->factor * cost_cutoff(&scene, &plan, g);
        }
        cost_sheet_make(&sheet, &scene, &plan);
        cost_sheet_plan(&sheet, &plan); /* with cells as the grids will have them */
        bench_classes(&packing, &scene, &plan, of->spec.skin);
        cost_count(&scene, &plan, predicted);
        bench_events(&packing, &plan, counted);
        wrong += compare(of, plan.levels, predicted, counted);
        bench_scene_free(&packing);
    }
    assert_int_equal(wrong, 0);
}

TEST_MAIN(events, cmocka_unit_test(events_are_those_of_the_search))
