/* SPDX-License-Identifier: BSD-3-Clause */
/* Times order, build, count and fill of an index, and prints the prediction of the cost model. Not a test.
 *
 *     bench_index [key=value ...]
 *
 * file: a packing from a LAMMPS data file; or law, exponent, ratio, particles, large, fraction: a packing made here
 * open, skin, inflate: see bench_scene.h
 * index (hgrid), levels (0: as `auto` chooses; -1: one level for each factor of two; else the number of
 * levels, of equal occupancy), factor (cell edges as a multiple of the cut-offs; 0: as `auto` chooses),
 * threads, repetitions, instructions
 *
 * One line of JSON: seconds are CPU time over threads, the least of the repetitions, of order + build + fill.
 */
#include "base/memory.h"
#include "index/choose/auto_choose.h"
#include "tests/index/bench_events.h"
#include "tests/index/bench_fit.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* CPU time of all threads over their number: on a busy machine as good as a wall clock on an idle one. */
static double seconds_now(int threads) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return ((double)now.tv_sec + 1e-9 * (double)now.tv_nsec) / threads;
}

struct bench {
    struct bench_spec spec;
    const char *index;
    int levels, threads, repetitions;
    double factor;
    bool terms, calibrate;
    struct index_params params;
    struct cost_scene scene;
    struct cost_plan plan;
};

struct result {
    double order, build, count, fill;
    size_t pairs;
};

/* A level for each factor of two in radius, cells of the cut-off. */
static void octaves(struct bench *bench) {
    const struct cost_scene *scene = &bench->scene;
    struct cost_plan *plan = &bench->plan;
    double ratio = scene->radius_max[scene->bins - 1] / scene->radius_min[0];
    int levels = ratio > 2 ? (int)ceil(log2(ratio) - 1e-9) : 1;
    ratio = fmax(ratio, 1 + 1e-9);
    *plan = (struct cost_plan){0};
    for (int bin = 0; bin < scene->bins; bin++) {
        double octave = log(scene->radius_min[bin] / scene->radius_min[0]) / log(ratio) * levels - 1e-9;
        double next =
            bin + 1 < scene->bins
                ? log(scene->radius_min[bin + 1] / scene->radius_min[0]) / log(ratio) * levels - 1e-9
                : levels + 1;
        if (floor(octave) < floor(next)) {
            plan->last[plan->levels++] = bin;
        }
    }
    for (int g = 0; g < plan->levels; g++) {
        plan->edge[g] = cost_cutoff(scene, plan, g);
    }
}

static void choose(struct bench *bench) {
    if (bench->levels < 0) {
        octaves(bench);
    } else if (bench->levels > 0) {
        auto_equal(&bench->scene, bench->levels, &bench->plan);
        auto_edges(&bench->scene, &bench->plan);
    } else {
        auto_levels(&bench->scene, INDEX_CLASS_MAX, &bench->plan);
    }
    for (int g = 0; g < bench->plan.levels; g++) {
        if (bench->factor > 0) {
            bench->plan.edge[g] = bench->factor * cost_cutoff(&bench->scene, &bench->plan, g);
        }
        bench->params.level_cell[g] = bench->levels < 0 ? 0 : bench->plan.edge[g];
    }
}

/* Visits blocks of rows, as the pair list does, and counts, or fills each thread's own buffer. */
static double visit_all(const struct index *index, const struct index_view *view, struct index_sink *sinks,
                        size_t *pairs) {
    enum { ROWS = 2048 };
    size_t total = 0;
    double start = seconds_now(view->threads);
#pragma omp parallel num_threads(view->threads) reduction(+ : total)
    {
        struct index_sink sink = sinks[omp_get_thread_num()];
#pragma omp for schedule(dynamic)
        for (size_t first = 0; first < view->owned; first += ROWS) {
            size_t last = first + ROWS < view->owned ? first + ROWS : view->owned;
            index_visit(index, view, first, last, &sink);
        }
        total += sink.count;
    }
    *pairs = total;
    return seconds_now(view->threads) - start;
}

static void keep_least(double *least, double value) {
    *least = *least == 0 || value < *least ? value : *least;
}

static void measure(struct bench *bench, struct bench_scene *scene, struct index *index,
                    struct result *least) {
    struct index_view *view = &scene->view;
    uint32_t *order = memory_allocate(view->owned, sizeof *order, "order");
    struct index_sink *sinks = memory_allocate_zero((size_t)view->threads, sizeof *sinks, "sinks");
    struct index_sink *none = memory_allocate_zero((size_t)view->threads, sizeof *none, "sinks");
    index_order(index, view, order);
    bench_scene_reorder(scene, order);
    for (int r = 0; r < bench->repetitions; r++) {
        size_t pairs;
        double start = seconds_now(view->threads);
        index_order(index, view, order);
        double ordered = seconds_now(view->threads);
        index_build(index, view);
        keep_least(&least->order, ordered - start);
        keep_least(&least->build, seconds_now(view->threads) - ordered);
        keep_least(&least->count, visit_all(index, view, none, &least->pairs));
        for (int t = 0; t < view->threads && sinks[t].i == NULL; t++) {
            sinks[t].capacity = least->pairs;
            sinks[t].i = memory_allocate_zero(least->pairs + INDEX_SINK_PAD, sizeof(uint32_t), "pairs");
            sinks[t].j = memory_allocate_zero(least->pairs + INDEX_SINK_PAD, sizeof(uint32_t), "pairs");
        }
        keep_least(&least->fill, visit_all(index, view, sinks, &pairs));
    }
    for (int t = 0; t < view->threads; t++) {
        memory_free(sinks[t].i);
        memory_free(sinks[t].j);
    }
    memory_free(sinks);
    memory_free(none);
    memory_free(order);
}

/* Particles in a cell of its cut-off, averaged over the levels: the m of equation 3. */
static double occupancy(const struct bench *bench) {
    double sum = 0;
    for (int g = 0, bin = 0; g < bench->plan.levels; g++) {
        double count = 0;
        for (; bin <= bench->plan.last[g]; bin++) {
            count += bench->scene.count[bin];
        }
        sum += count * pow(cost_cutoff(&bench->scene, &bench->plan, g), 3) / bench->scene.volume;
    }
    return sum / bench->plan.levels;
}

/* The events that the model predicts, and those that the search counts. */
static void print_terms(const struct bench *bench, struct bench_scene *scene) {
    double count[COST_TERMS], counted[COST_TERMS];
    cost_count(&bench->scene, &bench->plan, count);
    bench_events(scene, &bench->plan, counted);
    for (int t = 0; t < COST_TERMS; t++) {
        const char *name = cost_name((enum cost_term)t);
        printf(", \"%s\": %.6g, \"%s_counted\": %.6g", name, count[t], name, counted[t]);
    }
}

static void print(const struct bench *bench, struct bench_scene *scene, const struct result *r) {
    const struct index_view *view = &scene->view;
    double seconds = r->order + r->build + r->fill, n = (double)view->owned;
    printf("{\"law\": \"%s\", \"exponent\": %g, \"ratio\": %g, \"fraction\": %g, \"skin\": %g, \"index\": "
           "\"%s\", "
           "\"levels\": %d, \"factor\": %g, \"threads\": %d, \"particles\": %zu, \"seconds\": %.6g, "
           "\"ns_per_particle\": %.4g, \"order\": %.6g, \"build\": %.6g, \"count\": %.6g, \"fill\": %.6g, "
           "\"pairs\": %zu, \"occupancy\": %.6g, \"predicted\": %.6g",
           bench->spec.law, bench->spec.exponent, bench->spec.ratio, bench->spec.fraction, bench->spec.skin,
           bench->index, bench->plan.levels, bench->factor, view->threads, view->owned, seconds,
           1e9 * seconds / n, r->order, r->build, r->count, r->fill, r->pairs, occupancy(bench),
           cost_seconds(&bench->scene, &bench->plan));
    if (bench->terms) {
        print_terms(bench, scene);
    }
    printf(", \"edges\": [");
    for (int g = 0; g < bench->plan.levels; g++) {
        printf("%s%.4g", g ? ", " : "", bench->plan.edge[g]);
    }
    printf("]}\n");
    fflush(stdout);
}

/* Chooses, measures and prints; returns the seconds. */
static double run_plan(struct bench *bench, struct bench_scene *scene) {
    struct error error = {0};
    struct result least = {0};
    choose(bench);
    bench_classes(scene, &bench->scene, &bench->plan, bench->spec.skin);
    struct index *index = index_create(bench->index, &bench->params, &error);
    if (index == NULL) {
        fprintf(stderr, "bench_index: %s\n", error.text);
        exit(2);
    }
    measure(bench, scene, index, &least);
    print(bench, scene, &least);
    index_destroy(&index);
    return least.order + least.build + least.fill;
}

static void run(struct bench *bench) {
    struct bench_scene scene;
    bench_scene_make(&scene, &bench->spec);
    scene.view.threads = bench->threads;
    bench_describe(&scene.view, bench->spec.skin, &bench->scene);
    run_plan(bench, &scene);
    bench_scene_free(&scene);
}

/* Fits the prices of the events that the search counts to the seconds of this machine, on one thread, and compares the
 * seconds with those of the events that the model predicts. */
static void calibrate(struct bench *bench) {
    static const struct bench_spec specs[] = {
        {.law = "power", .ratio = 1, .particles = 40000, .fraction = 0.3, .skin = 0.3},
        {.law = "power", .ratio = 1, .particles = 30000, .fraction = 0.01, .skin = 0.3},
        {.law = "power", .exponent = -3, .ratio = 50, .particles = 30000, .fraction = 0.4},
        {.law = "power", .exponent = -3, .ratio = 50, .particles = 30000, .fraction = 0.1},
        {.law = "power", .exponent = 0, .ratio = 8, .particles = 30000, .fraction = 0.35, .skin = 0.3},
        {.law = "bidisperse", .large = 4e-4, .ratio = 10, .particles = 40000, .fraction = 0.4, .skin = 0.3},
        {.law = "bidisperse", .large = 0.3, .ratio = 2, .particles = 30000, .fraction = 0.35, .skin = 0.3},
        {.law = "bidisperse", .large = 0.03, .ratio = 5, .particles = 40000, .fraction = 0.5, .skin = 0.3},
        {.law = "bidisperse", .large = 3e-3, .ratio = 10, .particles = 60000, .fraction = 0.5, .skin = 0.3},
        {.law = "lognormal", .ratio = 20, .particles = 30000, .fraction = 0.35, .skin = 0.3},
    };
    static const double factors[] = {0.7, 1, 1.4, 2, 2.8};
    enum { LEVELS = 4, SPECS = sizeof specs / sizeof specs[0], FACTORS = sizeof factors / sizeof factors[0] };
    static struct bench_sample sample[SPECS * LEVELS * FACTORS], predicted[SPECS * LEVELS * FACTORS];
    int samples = 0;
    for (int s = 0; s < SPECS; s++) {
        struct bench_scene scene;
        bench->spec = specs[s];
        bench_scene_make(&scene, &bench->spec);
        scene.view.threads = bench->threads;
        bench_describe(&scene.view, bench->spec.skin, &bench->scene);
        for (int l = 1; l <= LEVELS; l++) {
            for (int f = 0; f < (l == 1 && specs[s].ratio > 8 ? 2 : FACTORS); f++) {
                bench->levels = l;
                bench->factor = factors[f];
                double seconds = run_plan(bench, &scene);
                if (bench->plan.levels == l) {
                    sample[samples].seconds = predicted[samples].seconds = seconds;
                    bench_events(&scene, &bench->plan, sample[samples].count);
                    cost_count(&bench->scene, &bench->plan, predicted[samples++].count);
                }
            }
        }
        bench_scene_free(&scene);
    }
    double price[COST_TERMS];
    double error = bench_fit(sample, samples, price);
    printf("{\"samples\": %d, \"relative_error\": %.3g, \"predicted_error\": %.3g", samples, error,
           bench_fit_error(predicted, samples, price));
    for (int t = 0; t < COST_TERMS; t++) {
        printf(", \"%s\": %.4g", cost_name((enum cost_term)t), price[t]);
    }
    printf("}\n");
}

static void set(struct bench *bench, const char *key, const char *value) {
    const struct {
        const char *key;
        double *real;
        int *integer;
    } keys[] = {{"exponent", &bench->spec.exponent, NULL},
                {"ratio", &bench->spec.ratio, NULL},
                {"large", &bench->spec.large, NULL},
                {"fraction", &bench->spec.fraction, NULL},
                {"skin", &bench->spec.skin, NULL},
                {"inflate", &bench->spec.inflate, NULL},
                {"factor", &bench->factor, NULL},
                {"levels", NULL, &bench->levels},
                {"threads", NULL, &bench->threads},
                {"repetitions", NULL, &bench->repetitions},
                {"instructions", NULL, &bench->params.instructions}};
    for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++) {
        if (strcmp(key, keys[k].key) == 0 && keys[k].real != NULL) {
            *keys[k].real = atof(value);
            return;
        }
        if (strcmp(key, keys[k].key) == 0) {
            *keys[k].integer = atoi(value);
            return;
        }
    }
    if (strcmp(key, "file") == 0) {
        strcpy(bench->spec.law, "file");
        bench->spec.file = value;
        bench->spec.exponent = bench->spec.ratio = bench->spec.fraction = 0;
    } else if (strcmp(key, "law") == 0) {
        snprintf(bench->spec.law, sizeof bench->spec.law, "%s", value);
    } else if (strcmp(key, "index") == 0) {
        bench->index = value;
    } else if (strcmp(key, "particles") == 0) {
        bench->spec.particles = (size_t)atof(value);
    } else if (strcmp(key, "open") == 0) {
        bench->spec.open = atoi(value) != 0;
    } else if (strcmp(key, "calibrate") == 0) {
        bench->calibrate = atoi(value) != 0;
    } else if (strcmp(key, "terms") == 0) {
        bench->terms = atoi(value) != 0;
    } else {
        fprintf(stderr, "bench_index: unknown key \"%s\"\n", key);
        exit(2);
    }
}

int main(int argc, char **argv) {
    struct bench bench = {
        .spec =
            {.law = "power", .exponent = -3, .ratio = 50, .particles = 125001, .fraction = 0.4, .inflate = 1},
        .index = "hgrid",
        .threads = 1,
        .repetitions = 5};
    for (int k = 1; k < argc; k++) {
        char *value = strchr(argv[k], '=');
        if (value == NULL) {
            fprintf(stderr, "bench_index: key=value expected, not \"%s\"\n", argv[k]);
            return 2;
        }
        *value = '\0';
        set(&bench, argv[k], value + 1);
    }
    if (bench.calibrate) {
        calibrate(&bench);
    } else {
        run(&bench);
    }
    return 0;
}
