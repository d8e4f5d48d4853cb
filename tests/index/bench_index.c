/* Times order, build, count and fill of every index on the bidisperse benchmark: 250 spheres of radius 10
 * among small ones of radius 1, 46 % of a periodic cube, margin 0.5. Small ones lie on a jittered lattice and
 * outside the large ones. Not a test.
 *
 *     bench_index [small particles [name [cell_factor [repetitions [instructions]]]]]
 */
#include "core/memory.h"
#include "core/random.h"
#include "core/timer.h"
#include "index/index.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STRIDE = 8, LARGE_RADIUS = 10 };

struct sample {
    double *record;
    uint8_t *size_class;
    int64_t *id;
    struct index_view view;
};

static void put(struct sample *sample, const double x[3], double radius) {
    size_t k = sample->view.total++;
    memcpy(sample->record + k * STRIDE, x, 3 * sizeof x[0]);
    sample->record[k * STRIDE + 3] = radius;
    sample->size_class[k] = radius > 1;
    sample->id[k] = (int64_t)k + 1;
}

/* True if a sphere of this radius at x keeps clear of the first `large` ones. */
static bool is_free(const struct sample *sample, const double x[3], double radius, size_t large) {
    for (size_t k = 0; k < large; k++) {
        double square = 0;
        for (int d = 0; d < 3; d++) {
            double dx = fabs(x[d] - sample->record[k * STRIDE + (size_t)d]);
            dx = fmin(dx, sample->view.edge[d] - dx);
            square += dx * dx;
        }
        double least = 0.99 * (radius + sample->record[k * STRIDE + 3]);
        if (square < least * least) {
            return false;
        }
    }
    return true;
}

static void make_sample(struct sample *sample, size_t small) {
    double edge = 205.9 * cbrt((double)small / 711657.0);
    size_t large = (size_t)(250 * (double)small / 711657.0 + 0.5);
    size_t across = (size_t)cbrt((double)small * 1.145) + 1;
    size_t room = across * across * across + large;
    sample->record = memory_allocate_zero(room * STRIDE, sizeof(double), "records");
    sample->size_class = memory_allocate(room, 1, "classes");
    sample->id = memory_allocate(room, sizeof(int64_t), "ids");
    sample->view = (struct index_view){.dimension = 3,
                                       .stride = STRIDE,
                                       .position = sample->record,
                                       .radius = sample->record + 3,
                                       .size_class = sample->size_class,
                                       .id = sample->id,
                                       .edge = {edge, edge, edge},
                                       .periodic = {true, true, true},
                                       .newton = true,
                                       .classes = 2,
                                       .radius_max = {1, LARGE_RADIUS},
                                       .margin = {{0.5, 0.5}, {0.5, 0.5}}};
    struct random_sequence random = random_sequence(1, RANDOM_TEST, 1);
    for (size_t tries = 0; sample->view.total < large && tries < 1000 * large; tries++) {
        double x[3];
        for (int d = 0; d < 3; d++) {
            x[d] = random_uniform(&random) * edge;
        }
        if (is_free(sample, x, LARGE_RADIUS, sample->view.total)) {
            put(sample, x, LARGE_RADIUS);
        }
    }
    large = sample->view.total;
    for (size_t k = 0; k < across * across * across; k++) {
        size_t cell[3] = {k % across, k / across % across, k / across / across};
        double x[3];
        for (int d = 0; d < 3; d++) {
            double u = (double)cell[d] + 0.5 + 0.9 * (random_uniform(&random) - 0.5);
            x[d] = u / (double)across * edge;
        }
        if (is_free(sample, x, 1, large)) {
            put(sample, x, 1);
        }
    }
    sample->view.owned = sample->view.total;
}

static void shuffle(struct sample *sample, const uint32_t *order) {
    size_t n = sample->view.owned;
    double *record = memory_allocate(n * STRIDE, sizeof(double), "records");
    uint8_t *size_class = memory_allocate(n, 1, "classes");
    for (size_t k = 0; k < n; k++) {
        memcpy(record + k * STRIDE, sample->record + order[k] * (size_t)STRIDE, STRIDE * sizeof(double));
        size_class[k] = sample->size_class[order[k]];
    }
    memcpy(sample->record, record, n * STRIDE * sizeof(double));
    memcpy(sample->size_class, size_class, n);
    memory_free(record);
    memory_free(size_class);
}

struct result {
    double order, build, count, fill;
    size_t pairs;
};

/* Visits blocks of rows, as the pair list does, and counts, or fills each thread's own buffer. */
static double visit_all(const struct index *index, const struct index_view *view, size_t room,
                        size_t *pairs) {
    enum { ROWS = 4096 };
    size_t total = 0;
    double start = timer_now();
#pragma omp parallel num_threads(view->threads) reduction(+ : total)
    {
        struct index_sink sink = {.capacity = room};
        sink.i = memory_allocate(room + INDEX_SINK_PAD, sizeof(uint32_t), "pairs");
        sink.j = memory_allocate(room + INDEX_SINK_PAD, sizeof(uint32_t), "pairs");
#pragma omp for schedule(dynamic)
        for (size_t first = 0; first < view->owned; first += ROWS) {
            size_t last = first + ROWS < view->owned ? first + ROWS : view->owned;
            index_visit(index, view, first, last, &sink);
        }
        total += sink.count;
        memory_free(sink.i);
        memory_free(sink.j);
    }
    *pairs = total;
    return 1000 * (timer_now() - start);
}

static void keep_least(double *least, double value) {
    *least = *least == 0 || value < *least ? value : *least;
}

static void run(struct sample *sample, const char *name, const struct index_params *params, int repetitions) {
    struct error error = {0};
    struct index *index = index_create(name, params, &error);
    uint32_t *order = memory_allocate(sample->view.owned, sizeof *order, "order");
    struct result least = {0};
    index_order(index, &sample->view, order);
    shuffle(sample, order);
    for (int r = 0; r < repetitions; r++) {
        size_t pairs;
        double before = index->order_seconds;
        index_order(index, &sample->view, order);
        keep_least(&least.order, 1000 * (index->order_seconds - before));
        before = index->build_seconds;
        index_build(index, &sample->view);
        keep_least(&least.build, 1000 * (index->build_seconds - before));
        keep_least(&least.count, visit_all(index, &sample->view, 0, &least.pairs));
        keep_least(&least.fill, visit_all(index, &sample->view, least.pairs, &pairs));
    }
    struct index_description description;
    index_describe(index, &description);
    printf(
        "%-9s threads %d: order %7.2f  build %7.2f  count %8.2f  fill %8.2f ms, %zu pairs, %.1f B/particle, "
        "cells",
        name, sample->view.threads, least.order, least.build, least.count, least.fill, least.pairs,
        (double)index_memory(index) / (double)sample->view.owned);
    for (int l = 0; l < description.levels; l++) {
        printf(" %.3g%s", description.level[l].cell, description.level[l].sparse ? " (sparse)" : "");
    }
    printf("\n");
    fflush(stdout);
    memory_free(order);
    index_destroy(&index);
}

int main(int argc, char **argv) {
    size_t small = argc > 1 ? strtoul(argv[1], NULL, 10) : 711657;
    const char *only = argc > 2 ? argv[2] : "";
    struct index_params params = {.cell_factor = argc > 3 ? atof(argv[3]) : 0};
    int repetitions = argc > 4 ? atoi(argv[4]) : 5;
    params.instructions = argc > 5 ? atoi(argv[5]) : INDEX_BEST;
    struct sample sample;
    make_sample(&sample, small);
    printf("%zu particles, edge %.1f\n", sample.view.total, sample.view.edge[0]);
    for (int k = 1; k < index_registry_count(); k++) {
        const char *name = index_registry_get(k)->name;
        for (sample.view.threads = 1; sample.view.threads <= 2; sample.view.threads++) {
            if (only[0] == 0 || strcmp(only, name) == 0) {
                run(&sample, name, &params, repetitions);
            }
        }
    }
    memory_free(sample.record);
    memory_free(sample.size_class);
    memory_free(sample.id);
    return 0;
}
