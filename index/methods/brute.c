/* SPDX-License-Identifier: BSD-3-Clause */
/* brute: every pair, every image. The oracle of the tests and the file to copy when writing an index; its
 * time grows as the square of the number of particles. */
#include "base/memory.h"
#include "index/exact_test.h"
#include "index/index.h"

static struct index *brute_create(const struct index_params *params) {
    (void)params;
    return memory_allocate_zero(1, sizeof(struct index), "brute index");
}

static void brute_destroy(struct index *self) {
    memory_free(self);
}

static void brute_build(struct index *self, const struct index_view *view) {
    (void)self;
    (void)view;
}

/* Emits (i, j) once for every image through which the two meet, if their classes do. */
static void pair_images(const struct index_view *view, size_t i, size_t j, struct index_sink *sink) {
    if (!index_wanted(view, view->size_class[i], view->size_class[j])) {
        return;
    }
    int reach[3];
    for (int d = 0; d < 3; d++) {
        reach[d] = view->periodic[d] ? 1 : 0;
    }
    int image[3];
    for (image[2] = -reach[2]; image[2] <= reach[2]; image[2]++) {
        for (image[1] = -reach[1]; image[1] <= reach[1]; image[1]++) {
            for (image[0] = -reach[0]; image[0] <= reach[0]; image[0]++) {
                if (exact_near(view, i, j, image)) {
                    index_sink_put(sink, (uint32_t)i, (uint32_t)j, image_code(image[0], image[1], image[2]));
                }
            }
        }
    }
}

static void brute_visit(const struct index *self, const struct index_view *view, size_t first, size_t last,
                        struct index_sink *sink) {
    (void)self;
    for (size_t i = first; i < last; i++) {
        for (size_t j = i + 1; j < view->owned; j++) {
            pair_images(view, i, j, sink);
        }
        for (size_t j = view->owned; j < view->total; j++) {
            if (!view->newton || exact_home(view, i, j)) {
                pair_images(view, i, j, sink);
            }
        }
    }
}

static void brute_describe(const struct index *self, struct index_description *description) {
    (void)self;
    description->levels = 0;
}

static size_t brute_memory(const struct index *self) {
    return sizeof *self;
}

const struct index_ops brute_ops = {
    .name = "brute",
    .summary = "tests every pair of particles: correct and slow, the reference of all other indexes",
    .create = brute_create,
    .destroy = brute_destroy,
    .build = brute_build,
    .visit = brute_visit,
    .describe = brute_describe,
    .memory = brute_memory,
};
