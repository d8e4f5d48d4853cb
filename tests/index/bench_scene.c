/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the packings of the benchmark. Read bench_scene.h first. */
#include "tests/index/bench_scene.h"

#include "base/memory.h"
#include "base/random.h"
#include "data/formats/lammps_data.h"
#include "kernel/particles/box.h"
#include "data/scene/placegrid.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Places tried for a sphere before it may overlap more. */
enum { TRIES = 64 };

static double power_radius(double exponent, double ratio, double u) {
    double a = exponent + 1;
    return fabs(a) < 1e-9 ? pow(ratio, u) : pow(1 + u * (pow(ratio, a) - 1), 1 / a);
}

/* Exponential in the diameter, with a scale of 0.85 of the smallest diameter, cut at the ratio. */
static double exponential_radius(double ratio, double u) {
    const double scale = 0.85;
    return 1 - scale * log(1 - u * (1 - exp(-(ratio - 1) / scale)));
}

/* A bell in the logarithm of the radius between two bounds; u in (0, 1). */
static double bell_radius(double low, double high, double u) {
    double t = 0.5 + log(u / (1 - u)) / 14;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return low * pow(high / low, t);
}

/* Radius of particle k of n, k = 0 the largest. */
static double radius_of(const struct bench_spec *spec, size_t k) {
    double u = 1 - ((double)k + 0.5) / (double)spec->particles, ratio = spec->ratio;
    if (strcmp(spec->law, "bidisperse") == 0) {
        return 1 - u < spec->large ? ratio : 1;
    }
    if (strcmp(spec->law, "boulder") == 0) {
        return (double)k < spec->large ? ratio : 1;
    }
    if (strcmp(spec->law, "exponential") == 0) {
        return exponential_radius(ratio, u);
    }
    if (strcmp(spec->law, "lognormal") == 0) {
        return bell_radius(1, ratio, u);
    }
    if (strcmp(spec->law, "sand") == 0) { /* a sharp peak at the small end, a broad one below the large end */
        const double broad = 0.02;
        return 1 - u < broad ? bell_radius(0.15 * ratio, ratio, 1 - (1 - u) / broad)
                             : bell_radius(1, 1.6, u / (1 - broad));
    }
    return power_radius(spec->exponent, ratio, u);
}

/* A free place, or the place with the least overlap of many tries. */
static void place(const struct placegrid *grid, double edge, double radius, struct random_sequence *random,
                  double x[3]) {
    for (double shrink = 1;; shrink *= 0.97) {
        for (int t = 0; t < TRIES; t++) {
            for (int d = 0; d < 3; d++) {
                x[d] = random_uniform(random) * edge;
            }
            if (!placegrid_touches(grid, x, shrink * radius)) {
                return;
            }
        }
    }
}

/* A random permutation by sorting places: particle k goes to slot (k * step) mod n, step prime to n. */
static size_t coprime_step(size_t n) {
    size_t step = (size_t)(0.6180339887 * (double)n) | 1;
    for (;; step += 2) {
        size_t a = n, b = step;
        while (b != 0) {
            size_t rest = a % b;
            a = b;
            b = rest;
        }
        if (a == 1) {
            return step;
        }
    }
}

static void allocate(struct bench_scene *scene, size_t n) {
    scene->record = memory_allocate_zero(n * BENCH_STRIDE, sizeof(double), "records");
    scene->size_class = memory_allocate_zero(n, 1, "classes");
    scene->id = memory_allocate(n, sizeof(int64_t), "ids");
}

static void set_view(struct bench_scene *scene, const struct bench_spec *spec, size_t n,
                     const double edge[3]) {
    scene->view = (struct index_view){.owned = n,
                                      .total = n,
                                      .dimension = 3,
                                      .stride = BENCH_STRIDE,
                                      .position = scene->record,
                                      .radius = scene->record + 3,
                                      .size_class = scene->size_class,
                                      .id = scene->id,
                                      .edge = {edge[0], edge[1], edge[2]},
                                      .periodic = {!spec->open, !spec->open, !spec->open},
                                      .newton = true,
                                      .threads = 1,
                                      .classes = 1};
}

/* The packing of a file, in the file's order. */
static void read_file(struct bench_scene *scene, const struct bench_spec *spec) {
    struct error error = {0};
    struct rows rows;
    double edge[3];
    if (!lammps_data_read(spec->file, &rows, &error)) {
        fprintf(stderr, "bench_index: %s\n", error.text);
        exit(2);
    }
    allocate(scene, rows.count);
    for (size_t k = 0; k < rows.count; k++) {
        double *record = scene->record + k * BENCH_STRIDE;
        for (int d = 0; d < 3; d++) {
            record[d] = rows.position[k][d] - rows.lower[d];
        }
        record[3] = rows.radius[k] * (spec->inflate > 0 ? spec->inflate : 1);
        scene->id[k] = rows.id[k];
    }
    for (int d = 0; d < 3; d++) {
        edge[d] = rows.upper[d] - rows.lower[d];
    }
    set_view(scene, spec, rows.count, edge);
    rows_free(&rows);
}

void bench_scene_make(struct bench_scene *scene, const struct bench_spec *spec) {
    size_t n = spec->particles;
    double volume = 0;
    if (spec->file) {
        read_file(scene, spec);
        return;
    }
    for (size_t k = 0; k < n; k++) {
        volume += 4 * M_PI / 3 * pow(radius_of(spec, k), 3);
    }
    double edge = cbrt(volume / spec->fraction);
    allocate(scene, n);
    struct box box = {.edge = {edge, edge, edge}, .dimension = 3};
    for (int d = 0; d < 3; d++) {
        box.periodic[d] = !spec->open;
    }
    struct placegrid *grid = placegrid_create(&box, 1);
    struct random_sequence random = random_sequence(1, RANDOM_TEST, 1);
    size_t step = coprime_step(n);
    for (size_t k = 0; k < n; k++) {
        double radius = radius_of(spec, k);
        size_t at = (size_t)((unsigned __int128)k * step % n);
        double *record = scene->record + at * BENCH_STRIDE;
        place(grid, edge, radius, &random, record);
        placegrid_add(grid, record, radius);
        record[3] = radius * (spec->inflate > 0 ? spec->inflate : 1);
        scene->id[at] = (int64_t)k + 1;
    }
    placegrid_destroy(&grid);
    set_view(scene, spec, n, (double[3]){edge, edge, edge});
}

void bench_scene_free(struct bench_scene *scene) {
    memory_free(scene->record);
    memory_free(scene->size_class);
    memory_free(scene->id);
}

void bench_scene_reorder(struct bench_scene *scene, const uint32_t *order) {
    size_t n = scene->view.owned;
    double *record = memory_allocate(n * BENCH_STRIDE, sizeof(double), "records");
    int64_t *id = memory_allocate(n, sizeof *id, "ids");
    uint8_t *size_class = memory_allocate(n, 1, "classes");
    for (size_t k = 0; k < n; k++) {
        memcpy(record + k * BENCH_STRIDE, scene->record + order[k] * (size_t)BENCH_STRIDE,
               BENCH_STRIDE * sizeof(double));
        id[k] = scene->id[order[k]];
        size_class[k] = scene->size_class[order[k]];
    }
    memory_free(scene->record);
    memory_free(scene->id);
    memory_free(scene->size_class);
    scene->record = record;
    scene->id = id;
    scene->size_class = size_class;
    scene->view.position = record;
    scene->view.radius = record + 3;
    scene->view.id = id;
    scene->view.size_class = size_class;
}
