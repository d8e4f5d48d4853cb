/* SPDX-License-Identifier: BSD-3-Clause */
/* A cloud of small particles with a few large ones, and its pair list, for tests of pair lists and of histories. */
#ifndef SCREE_TESTS_CLOUD_BY_HAND_H
#define SCREE_TESTS_CLOUD_BY_HAND_H

#include "tests/test.h"

#include "base/memory.h"
#include "base/random.h"
#include "kernel/pairs/pairlist.h"
#include "kernel/pairs/classes_choose.h"

#include <omp.h>

#define CLOUD_EDGE 8.0

/* A cloud of small particles with a few large ones, of which the last `ghosts` are ghosts. */
struct cloud {
    struct particles *particles;
    struct size_classes classes;
    struct box box;
    struct index *index;
    struct index_view view;
    struct pairlist *list;
    double near; /* pairs hold records up to this distance of their surfaces; 0: at any */
};

static inline void cloud_fill(struct cloud *c, size_t n, size_t ghosts) {
    c->box = (struct box){
        .dimension = 3, .edge = {CLOUD_EDGE, CLOUD_EDGE, CLOUD_EDGE}, .periodic = {true, true, true}};
    c->particles = particles_create(n);
    for (size_t k = 0; k < n; k++) {
        struct random_sequence random = random_sequence(9, RANDOM_TEST, k);
        size_t i = particles_append(c->particles);
        bool large = k >= n - ghosts - 4 && k < n - ghosts;
        for (int d = 0; d < 3; d++)
            c->particles->state[i].x[d] = CLOUD_EDGE * random_uniform(&random);
        c->particles->state[i].radius = large ? 2.5 : 0.2 + 0.1 * random_uniform(&random);
        c->particles->state[i].inverse_mass = 1;
        c->particles->id[i] = (int64_t)(k * 7919 % 100003) + 1;
    }
    double *radii = memory_allocate(n, sizeof *radii, "test");
    for (size_t k = 0; k < n; k++)
        radii[k] = c->particles->state[k].radius;
    struct classes_options options = {
        .method = CLASSES_CUTS, .cut_count = 1, .cut = {1}, .skin_given = true, .skin = 0.1};
    struct error error = {0};
    assert_true(classes_choose(&c->classes, &options, NULL, radii, n, &error));
    memory_free(radii);
    particles_classify(c->particles, &c->classes);
    c->particles->owned = n - ghosts;
    c->particles->ghosts = ghosts;
}

static inline void cloud_search(struct cloud *c, int threads, bool newton) {
    const bool wrap[3] = {true, true, true};
    const struct index_params params = {0};
    struct error error = {0};
    pairlist_view(&c->view, c->particles, &c->classes, &c->box, wrap);
    c->view.newton = newton;
    omp_set_num_threads(threads);
    c->view.threads = threads;
    c->index = index_create("brute", &params, &error);
    index_build(c->index, &c->view);
    struct pairlist_options options = {.threads = threads, .block_rows = 100, .busy_bound = 20};
    c->list = pairlist_create(&options);
    pairlist_build(c->list, c->index, &c->view, &c->box);
}

static inline void cloud_free(struct cloud *c) {
    pairlist_destroy(&c->list);
    index_destroy(&c->index);
}

#endif
