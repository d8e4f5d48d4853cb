/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes random clouds and compares sets of pairs. Read index_cloud.h first. */
#include "tests/test.h"

#include "tests/index/index_cloud.h"

#include "base/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STRIDE = 5 };

static double radius_of(const struct cloud_spec *spec, struct random_sequence *random, size_t k) {
    double u = random_uniform(random);
    switch (spec->sizes) {
    case CLOUD_MONO:
        return 1;
    case CLOUD_BIDISPERSE:
    case CLOUD_BOULDER:
        return k < spec->large ? spec->ratio : 1;
    default: /* the inverse of the distribution function of r^-3 on 1 ... ratio */
        return 1 / sqrt(1 - u * (1 - 1 / (spec->ratio * spec->ratio)));
    }
}

static int class_of(const struct cloud_spec *spec, double radius) {
    switch (spec->sizes) {
    case CLOUD_BIDISPERSE:
    case CLOUD_BOULDER:
        return radius > 1;
    case CLOUD_POWER:
        return (int)fmin(floor(log2(radius)), INDEX_CLASS_MAX - 1);
    default:
        return 0;
    }
}

static void set_box(struct index_view *view, const struct cloud_spec *spec) {
    double volume = 0;
    for (size_t k = 0; k < view->total; k++) {
        double r = view->radius[k * STRIDE];
        volume += spec->dimension == 2 ? 3.14159 * r * r : 4.18879 * r * r * r;
    }
    double edge = pow(fmax(volume, 1) / fmax(spec->fraction, 1e-9), 1.0 / spec->dimension);
    for (int d = 0; d < 3; d++) {
        view->edge[d] = spec->edge[0] > 0 ? spec->edge[d] : edge;
        view->periodic[d] = spec->periodic[d];
    }
}

static double place(const struct cloud_spec *spec, struct random_sequence *random, size_t k, double edge,
                    bool periodic) {
    double u = random_uniform(random);
    switch (spec->places) {
    case CLOUD_ONE_SPOT:
        return edge / 2 + u;
    case CLOUD_FACES:
        return edge * floor(u * (periodic ? 4 : 5)) / 4;
    case CLOUD_CLUSTERED:
        return k % 10 == 0 ? u * edge : u * fmin(edge, 3 * cbrt((double)spec->count));
    case CLOUD_OUTLIERS:
        return periodic || k % 50 != 7 ? u * edge : (u - 0.5) * pow(10, 3 + (double)(k % 7) * 3);
    default:
        return u * edge;
    }
}

/* Puts a ghost on the other side of a face of the box, or on the face. */
static void move_out(const struct cloud_spec *spec, double *x, size_t k, const double edge[3]) {
    int d = (int)(k % (size_t)spec->dimension);
    while (spec->periodic[d]) {
        d = (d + 1) % spec->dimension;
    }
    x[d] = k % 2 == 0 ? -0.3 * x[d] : edge[d] + 0.3 * x[d];
}

static void set_margins(struct index_view *view, const struct cloud_spec *spec) {
    for (int a = 0; a < view->classes; a++) {
        for (int b = 0; b < view->classes; b++) {
            double smaller = view->radius_max[a < b ? a : b];
            double margin[3] = {0.4, 0.3 * smaller, 0.05 + 0.11 * ((a + b) % 4)};
            view->margin[a][b] = margin[spec->margins];
        }
    }
}

/* Draws the class pairs that never meet; every other time one class meets no class. */
static void set_unwanted(struct index_view *view, const struct cloud_spec *spec) {
    struct random_sequence random = random_sequence(spec->seed, RANDOM_TEST, 1);
    int alone = (int)(random_uniform(&random) * 2 * view->classes);
    for (int a = 0; a < view->classes && spec->unwanted > 0; a++) {
        for (int b = 0; b <= a; b++) {
            if (random_uniform(&random) < spec->unwanted || a == alone || b == alone) {
                view->margin[a][b] = view->margin[b][a] = INDEX_NOT_WANTED;
            }
        }
    }
}

static void set_classes(struct cloud *cloud, const struct cloud_spec *spec) {
    struct index_view *view = &cloud->view;
    int classes[] = {1, 2, (int)ceil(log2(fmax(spec->ratio, 2)) + 1e-9), 1, 2};
    view->classes = classes[spec->sizes];
    for (size_t k = 0; k < view->total; k++) {
        int c = class_of(spec, view->radius[k * STRIDE]);
        cloud->size_class[k] = (uint8_t)c;
        view->radius_max[c] = fmax(view->radius_max[c], view->radius[k * STRIDE]);
    }
    for (int c = 0; c < view->classes && spec->loose_bounds; c++) {
        view->radius_max[c] = fmax(view->radius_max[c], pow(2, c + 1));
    }
    set_margins(view, spec);
    set_unwanted(view, spec);
}

void index_cloud_make(struct cloud *cloud, const struct cloud_spec *spec) {
    *cloud = (struct cloud){0};
    size_t n = spec->count;
    cloud->record = calloc(STRIDE * (n + 1), sizeof *cloud->record);
    cloud->size_class = calloc(n + 1, 1);
    cloud->id = calloc(n + 1, sizeof *cloud->id);
    struct index_view *view = &cloud->view;
    *view = (struct index_view){.total = n,
                                .owned = n - (size_t)((double)n * spec->ghosts),
                                .position = cloud->record,
                                .radius = cloud->record + 3,
                                .stride = STRIDE,
                                .size_class = cloud->size_class,
                                .id = cloud->id,
                                .dimension = spec->dimension,
                                .newton = spec->newton,
                                .threads = 1};
    struct random_sequence random = random_sequence(spec->seed, RANDOM_TEST, 0);
    uint64_t odd = 2 * (uint64_t)(random_uniform(&random) * 1e6) + 1;
    for (size_t k = 0; k < n; k++) { /* large ones anywhere in memory */
        size_t at = (size_t)((k * 2654435761u + odd) % n);
        while (cloud->record[at * STRIDE + 3] > 0) {
            at = (at + 1) % n;
        }
        cloud->record[at * STRIDE + 3] = radius_of(spec, &random, k);
    }
    set_box(view, spec);
    for (size_t k = 0; k < n; k++) {
        for (int d = 0; d < 3; d++) {
            double x = place(spec, &random, k, view->edge[d], spec->periodic[d]);
            cloud->record[k * STRIDE + (size_t)d] = spec->dimension == 2 && d == 2 ? 0.5 * view->edge[2] : x;
        }
        if (spec->around && k >= view->owned) {
            move_out(spec, cloud->record + k * STRIDE, k, view->edge);
        }
        cloud->id[k] = (int64_t)k + 1;
    }
    set_classes(cloud, spec);
}

void index_cloud_free(struct cloud *cloud) {
    free(cloud->record);
    free(cloud->size_class);
    free(cloud->id);
}

void index_cloud_reorder(struct cloud *cloud, const uint32_t *order) {
    size_t n = cloud->view.owned;
    double *record = malloc((n + 1) * STRIDE * sizeof *record);
    uint8_t *size_class = malloc(n + 1);
    int64_t *id = malloc((n + 1) * sizeof *id);
    for (size_t k = 0; k < n; k++) {
        memcpy(record + k * STRIDE, cloud->record + order[k] * STRIDE, STRIDE * sizeof *record);
        size_class[k] = cloud->size_class[order[k]];
        id[k] = cloud->id[order[k]];
    }
    memcpy(cloud->record, record, n * STRIDE * sizeof *record);
    memcpy(cloud->size_class, size_class, n);
    memcpy(cloud->id, id, n * sizeof *id);
    free(record);
    free(size_class);
    free(id);
}

uint64_t pair_key(const struct index_view *view, uint32_t i, uint32_t tagged) {
    uint32_t j = tagged & ((1u << INDEX_IMAGE_SHIFT) - 1);
    uint64_t code = tagged >> INDEX_IMAGE_SHIFT;
    assert_true(i < view->owned && j < view->total && code < IMAGE_CODES);
    uint64_t a = (uint64_t)view->id[i], b = (uint64_t)view->id[j];
    if (j < view->owned && a > b) {
        uint64_t swap = a;
        a = b;
        b = swap;
        code = (27 - code) % 27;
    }
    return a << 34 | b << 5 | code;
}

static int compare_keys(const void *a, const void *b) {
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

void pair_set_sort(struct pair_set *set) {
    qsort(set->key, set->count, sizeof *set->key, compare_keys);
}

/* The pairs of rows [first, last): counted, filled exactly, and filled into a sink that is too small. */
static void collect_part(struct pair_set *set, const struct index *index, const struct index_view *view,
                         const size_t rows[2]) {
    struct index_sink count = {0};
    index_visit(index, view, rows[0], rows[1], &count);
    struct index_sink sink = {.capacity = count.count};
    sink.i = malloc((sink.capacity + INDEX_SINK_PAD) * sizeof(uint32_t));
    sink.j = malloc((sink.capacity + INDEX_SINK_PAD) * sizeof(uint32_t));
    struct index_sink small = sink;
    small.capacity = count.count / 2;
    index_visit(index, view, rows[0], rows[1], &small);
    assert_int_equal(small.count, count.count);
    index_visit(index, view, rows[0], rows[1], &sink);
    assert_int_equal(sink.count, count.count);
    set->key = realloc(set->key, (set->count + sink.count + 1) * sizeof *set->key);
    for (size_t k = 0; k < sink.count; k++) {
        assert_true(sink.i[k] >= rows[0] && sink.i[k] < rows[1]);
        set->key[set->count++] = pair_key(view, sink.i[k], sink.j[k]);
    }
    free(sink.i);
    free(sink.j);
}

void pair_set_collect(struct pair_set *set, const struct index *index, const struct index_view *view,
                      int parts) {
    *set = (struct pair_set){0};
    for (int p = 0; p < parts; p++) { /* uneven: part p ends at (p + 1)^2 / parts^2 */
        size_t rows[2] = {view->owned * (size_t)(p * p) / (size_t)(parts * parts),
                          view->owned * (size_t)((p + 1) * (p + 1)) / (size_t)(parts * parts)};
        collect_part(set, index, view, rows);
    }
    pair_set_sort(set);
}

void pair_set_free(struct pair_set *set) {
    free(set->key);
}

void pair_set_compare(const struct pair_set *expected, const struct pair_set *found, const char *what) {
    size_t k = 0;
    while (k < expected->count && k < found->count && expected->key[k] == found->key[k]) {
        k++;
    }
    if (k == expected->count && k == found->count) {
        return;
    }
    bool lost = k == found->count || (k < expected->count && expected->key[k] < found->key[k]);
    uint64_t key = lost ? expected->key[k] : found->key[k];
    fail_msg("%s: %zu pairs, expected %zu; first difference: ids %llu and %llu, image %llu is %s", what,
             found->count, expected->count, (unsigned long long)(key >> 34),
             (unsigned long long)(key >> 5 & ((1u << 29) - 1)), (unsigned long long)(key & 31),
             lost ? "missing" : "too many");
}

struct index *cloud_index(const struct cloud *cloud, const char *name, const struct index_params *params) {
    struct error error = {0};
    char why[INDEX_WHY_MAX] = "";
    if (!index_applicable(name, params, &cloud->view, why)) {
        fail_msg("%s: not applicable: %s", name, why);
    }
    struct index *index = index_create(name, params, &error);
    assert_non_null(index);
    index_build(index, &cloud->view);
    if (!index_check(index, &cloud->view, why)) {
        fail_msg("%s: %s", name, why);
    }
    return index;
}
