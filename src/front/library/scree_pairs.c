/* SPDX-License-Identifier: BSD-3-Clause */
/* The public functions of libscree (scree.h). */
#include "scree.h"
#include "base/memory.h"
#include "base/version.h"
#include "kernel/pairs/pairlist.h"
#include "kernel/pairs/classes_choose.h"
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>

const char *scree_version(void) {
    return version_number();
}

void scree_free(void *array) {
    memory_free(array);
}

static bool refuse(char *why, size_t room, const char *text) {
    if (why)
        snprintf(why, room, "%s", text);
    return false;
}

/* Lengths whose squares and cubes a double holds, and the largest ratio of lengths that its digits resolve. */
enum { THREADS_MOST = 1024 };
static const double length_least = 1e-100, length_most = 1e100, ratio_most = 1e15;

static bool spheres_good(const struct scree_spheres *spheres, double margin, char *why, size_t room) {
    char text[256];
    double smallest = length_most;
    if (spheres == NULL || (spheres->count > 0 && (spheres->position == NULL || spheres->radius == NULL)))
        return refuse(why, room, "there are no spheres");
    for (size_t k = 0; k < spheres->count; k++)
        if (spheres->radius[k] >= length_least && spheres->radius[k] < smallest)
            smallest = spheres->radius[k];
    if (spheres->count >= (size_t)1 << PARTICLE_INDEX_BITS)
        return refuse(why, room, "more than 2^27 - 1 spheres");
    if (spheres->dimension != 2 && spheres->dimension != 3)
        return refuse(why, room, "dimension must be 2 or 3");
    if (!(margin >= 0 && margin <= length_most))
        return refuse(why, room, "margin must be a number from 0 to 1e100");
    const double most = fmin(length_most, ratio_most * (smallest + margin));
    for (size_t k = 0; k < spheres->count; k++) {
        const double *x = spheres->position + 3 * k;
        double r = spheres->radius[k];
        bool good = r >= length_least && r <= most;
        for (int d = 0; d < 3; d++)
            good = good && fabs(x[d]) <= most;
        for (int d = 0; d < spheres->dimension; d++)
            good = good && (!spheres->periodic[d] ||
                            (x[d] >= 0 && x[d] < spheres->edge[d] && 2 * r + margin < spheres->edge[d]));
        if (good)
            continue;
        snprintf(text, sizeof text,
                 "sphere %zu: position %g %g %g, radius %g do not fit the box, or are beyond 1e-100 to 1e100 "
                 "or 1e15 times "
                 "the smallest radius",
                 k, x[0], x[1], x[2], r);
        return refuse(why, room, text);
    }
    return true;
}

/* Makes the size classes that are best by the cost model of the index, and the class of each sphere. */
static void classes_make(const struct scree_spheres *spheres, double margin, struct size_classes *classes,
                         uint8_t *size_class) {
    struct classes_options options = classes_options_default();
    struct error error = {0};
    double *radii = memory_allocate(spheres->count, sizeof *radii, "radii");
    memcpy(radii, spheres->radius, spheres->count * sizeof *radii);
    options.skin_given = true;
    options.skin = margin;
    classes_choose(classes, &options, NULL, radii, spheres->count, &error);
    memory_free(radii);
    for (size_t k = 0; k < spheres->count; k++)
        size_class[k] = (uint8_t)classes_of(classes, spheres->radius[k]);
}

static void pairs_copy(const struct index_sink *sink, struct scree_pair *pair) {
    int8_t image[IMAGE_CODES][3];
    for (int z = -1; z <= 1; z++)
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++)
                memcpy(image[image_code(x, y, z)], (int8_t[3]){(int8_t)x, (int8_t)y, (int8_t)z}, 3);
    for (size_t k = 0; k < sink->count; k++) {
        pair[k].i = sink->i[k];
        pair[k].j = pair_partner(sink->j[k]);
        memcpy(pair[k].image, image[pair_image(sink->j[k])], 3);
    }
}

/* Counts the pairs, then fills the array. */
static void pairs_find(const struct index *index, const struct index_view *view, struct scree_pair **pairs,
                       size_t *found) {
    struct index_sink sink = {0};
    index_visit(index, view, 0, view->owned, &sink);
    sink.capacity = sink.count;
    sink.i = memory_allocate(sink.capacity + INDEX_SINK_PAD, sizeof *sink.i, "pairs");
    sink.j = memory_allocate(sink.capacity + INDEX_SINK_PAD, sizeof *sink.j, "pairs");
    sink.count = 0;
    index_visit(index, view, 0, view->owned, &sink);
    *pairs = memory_allocate(sink.count, sizeof **pairs, "pairs");
    *found = sink.count;
    pairs_copy(&sink, *pairs);
    memory_free(sink.i);
    memory_free(sink.j);
}

static void view_fill(struct index_view *view, const struct scree_spheres *spheres,
                      const struct size_classes *classes, int threads) {
    view->owned = view->total = spheres->count;
    view->dimension = spheres->dimension;
    view->newton = true;
    view->threads = threads > 0 ? threads : omp_get_max_threads();
    view->classes = classes->count;
    memcpy(view->edge, spheres->edge, sizeof view->edge);
    memcpy(view->periodic, spheres->periodic, sizeof view->periodic);
    for (int a = 0; a < classes->count; a++) {
        view->radius_max[a] = classes->radius_max[a];
        memcpy(view->margin[a], classes->margin[a], (size_t)classes->count * sizeof(double));
    }
}

bool scree_pairs(const char *name, const struct scree_spheres *spheres, double margin, int threads,
                 struct scree_pair **pairs, size_t *found, char *why, size_t room) {
    const struct index_params params = {0};
    struct error error = {0};
    char reason[INDEX_WHY_MAX];
    if (name == NULL || pairs == NULL || found == NULL)
        return refuse(why, room, "there is no name of an index, or no place for the pairs");
    if (!spheres_good(spheres, margin, why, room))
        return false;
    if (threads > THREADS_MOST)
        return refuse(why, room, "more than 1024 threads");
    struct index *index = index_create(name, &params, &error);
    if (index == NULL)
        return refuse(why, room, error.text);
    size_t n = spheres->count;
    uint8_t *size_class = memory_allocate(n, 1, "size classes");
    int64_t *id = memory_allocate(n, sizeof *id, "ids");
    double(*record)[4] = memory_allocate(n, sizeof *record, "spheres");
    struct size_classes classes;
    struct index_view view = {
        .size_class = size_class, .id = id, .position = record[0], .radius = &record[0][3], .stride = 4};
    classes_make(spheres, margin, &classes, size_class);
    for (size_t k = 0; k < n; k++) {
        id[k] = (int64_t)k + 1;
        memcpy(record[k], spheres->position + 3 * k, 3 * sizeof(double));
        record[k][3] = spheres->radius[k];
    }
    view_fill(&view, spheres, &classes, threads);
    bool good = index_applicable(name, &params, &view, reason);
    if (good) {
        index_build(index, &view);
        pairs_find(index, &view, pairs, found);
    } else {
        refuse(why, room, reason);
    }
    index_destroy(&index);
    memory_free(size_class);
    memory_free(id);
    memory_free(record);
    return good;
}
