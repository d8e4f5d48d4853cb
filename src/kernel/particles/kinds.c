/* SPDX-License-Identifier: BSD-3-Clause */
/* The kinds of particles; the classes and the range of particles of each kind. */
#include "kernel/particles/kinds.h"
#include "base/memory.h"
#include "kernel/particles/fields.h"
#include <assert.h>
#include <string.h>

static const struct field kind_field = {.name = "kind",
                                        .type = FIELD_UINT8,
                                        .components = 1,
                                        .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_FIXED,
                                        .needed_for = "more than one kind of particles",
                                        .help = "0: grain, 1: fluid, 2: boundary, 3: body"};

const char *kinds_name(enum kind kind) {
    static const char *const names[KINDS] = {
        [KIND_GRAIN] = "grain", [KIND_FLUID] = "fluid", [KIND_BOUNDARY] = "boundary", [KIND_BODY] = "body"};
    return names[kind];
}

static const enum kind order_of_kinds[KINDS] = {KIND_FLUID, KIND_BOUNDARY, KIND_GRAIN, KIND_BODY};

int kinds_place(enum kind kind) {
    int place = 0;
    while (order_of_kinds[place] != kind)
        place++;
    return place;
}

enum kind kinds_at(int place) {
    return order_of_kinds[place];
}

/* The place of the kind of a class. */
static int class_place(const struct size_classes *classes, int c) {
    return kinds_place((enum kind)classes->kind[c]);
}

void kinds_register(struct particles *particles) {
    fields_register(particles, &kind_field);
}

uint8_t *kinds_of(const struct particles *particles) {
    return fields_values(particles, &kind_field);
}

bool kinds_join_classes(struct size_classes *classes, enum kind kind, const struct size_classes *of_kind,
                        const struct classes_options *options, const struct classes_range *range,
                        struct error *error) {
    assert(classes->count == 0 || class_place(classes, classes->count - 1) < kinds_place(kind));
    if (classes->count + of_kind->count > CLASS_MAX)
        return error_set(error, ERROR_USER,
                         "classes: %d size classes of %s particles and %d of other kinds; together there may "
                         "be up to %d",
                         of_kind->count, kinds_name(kind), classes->count, CLASS_MAX);
    for (int c = 0; c < of_kind->count; c++) {
        int to = classes->count++;
        classes->kind[to] = (uint8_t)kind;
        classes->cut[to] = of_kind->cut[c];
        classes->radius_min[to] = of_kind->radius_min[c];
        classes->radius_max[to] = of_kind->radius_max[c];
        classes->population[to] = of_kind->population[c];
    }
    classes_set_margins(classes, options, range);
    return true;
}

/* The classes of a kind: first ... end-1. */
static void class_range(const struct size_classes *classes, enum kind kind, int *first, int *end) {
    int place = kinds_place(kind);
    *first = 0;
    while (*first < classes->count && class_place(classes, *first) < place)
        ++*first;
    *end = *first;
    while (*end < classes->count && class_place(classes, *end) == place)
        ++*end;
}

int kinds_class(const struct size_classes *classes, enum kind kind, double radius) {
    int c, end;
    class_range(classes, kind, &c, &end);
    assert(c < end);
    while (c < end - 1 && radius > classes->cut[c])
        c++;
    return c;
}

void kinds_sort(const struct particles *particles, const struct size_classes *classes, uint32_t *order) {
    size_t start[CLASS_MAX + 1] = {0}, n = particles->owned;
    if (kinds_of(particles) == NULL)
        return;
    for (size_t k = 0; k < n; k++)
        start[particles->size_class[k] + 1]++;
    for (int c = 0; c < classes->count; c++)
        start[c + 1] += start[c];
    uint32_t *sorted = memory_allocate(n, sizeof *sorted, "particle order");
    for (size_t k = 0; k < n; k++)
        sorted[start[particles->size_class[order[k]]]++] = order[k];
    memcpy(order, sorted, n * sizeof *order);
    memory_free(sorted);
}

/* The first owned particle of a class of this number or a higher one. */
static size_t first_from(const struct particles *particles, int class) {
    size_t low = 0, high = particles->owned;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (particles->size_class[middle] < class)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

struct kind_span kinds_span(const struct particles *particles, const struct size_classes *classes,
                            enum kind kind) {
    int first, end;
    class_range(classes, kind, &first, &end);
    return (struct kind_span){first_from(particles, first), first_from(particles, end)};
}
