/* SPDX-License-Identifier: BSD-3-Clause */
/* Index, pair list and skin of a packing. Read pack_search.h first. */
#include "data/scene/pack/pack_search.h"

#include "base/memory.h"
#include "kernel/pairs/classes_choose.h"

#include <math.h>
#include <string.h>

/* Skin, as part of the smallest radius of the smaller class. */
static const double skin = 0.4;
/* Radii of one class differ by this factor at most, if the index has so many classes: few levels of the grid
 * are fast. */
static const double class_ratio = 4;

/* Margins: a pair may push when it is nearer than (1 + gap) times the sum of its radii. */
static void set_margins(struct size_classes *classes, double gap) {
    for (int a = 0; a < classes->count; a++)
        for (int b = 0; b < classes->count; b++)
            classes->margin[a][b] =
                classes->skin[a][b] + gap * (classes->radius_max[a] + classes->radius_max[b]);
}

static bool choose_classes(struct pack_search *search, double gap, struct error *error) {
    const struct particles *particles = search->particles;
    struct classes_options options = classes_options_default();
    double *radius = memory_allocate(particles->owned, sizeof *radius, "radii in order");
    double smallest = INFINITY, largest = 0;
    for (size_t k = 0; k < particles->owned; k++) {
        radius[k] = particles->state[k].radius;
        smallest = fmin(smallest, radius[k]);
        largest = fmax(largest, radius[k]);
    }
    options.method = CLASSES_GEOMETRIC;
    options.count = (int)ceil(log(largest / smallest) / log(class_ratio));
    options.skin_relative = skin;
    bool good = classes_choose(&search->classes, &options, NULL, radius, particles->owned, error);
    memory_free(radius);
    set_margins(&search->classes, gap);
    return good;
}

struct pack_search *pack_search_create(struct particles *particles, const struct box *box, double gap,
                                       int threads, struct error *error) {
    struct pack_search *search = memory_allocate_zero(1, sizeof *search, "search of a packing");
    struct index_params params = {0};
    search->particles = particles;
    search->box = box;
    search->threads = threads;
    if (choose_classes(search, gap, error))
        search->index = index_create("hgrid", &params, error);
    if (search->index == NULL) {
        memory_free(search);
        return NULL;
    }
    search->list = pairlist_create(&(struct pairlist_options){.threads = threads});
    particles_classify(particles, &search->classes);
    return search;
}

void pack_search_destroy(struct pack_search **search) {
    if (*search == NULL)
        return;
    index_destroy(&(*search)->index);
    pairlist_destroy(&(*search)->list);
    memory_free(*search);
    *search = NULL;
}

static void view_fill(const struct pack_search *search, struct index_view *view) {
    static const bool wrap[3] = {true, true, true};
    pairlist_view(view, search->particles, &search->classes, search->box, wrap);
    view->newton = true;
    view->threads = search->threads;
}

void pack_search_run(struct pack_search *search) {
    struct particles *particles = search->particles;
    struct index_view view;
    uint32_t *order = memory_allocate(particles->owned, sizeof *order, "particle order");
    particles_wrap(particles, search->box);
    particles->force_clear = true;
    view_fill(search, &view);
    index_order(search->index, &view, order);
    particles_reorder(particles, order);
    memory_free(order);
    view_fill(search, &view);
    index_build(search->index, &view);
    pairlist_build(search->list, search->index, &view, search->box);
    memset(search->moved, 0, sizeof search->moved);
    search->searches++;
}

bool pack_search_moved(struct pack_search *search, const double largest[CLASS_MAX]) {
    const struct size_classes *classes = &search->classes;
    bool due = false;
    for (int c = 0; c < classes->count; c++)
        search->moved[c] += largest[c];
    for (int a = 0; a < classes->count; a++)
        for (int b = a; b < classes->count; b++)
            due = due || search->moved[a] + search->moved[b] > classes->skin[a][b];
    return due;
}
