/* SPDX-License-Identifier: BSD-3-Clause */
/* Kinds: the physical sort of a particle: grains, or the points at which a fluid is computed, or the points
 * behind its boundaries, or the centres of rigid bodies.
 *
 * Particles lie kind by kind, and class by class inside a kind: a size class is (kind, interval of radii),
 * numbered kind after kind and from small to large in each, and a rebuild orders particles by class
 * (kinds_sort). So the particles of a kind are one range (kinds_span), and a pass of a physics visits its
 * kind alone. A set with one kind has no field of kinds and pays nothing.
 *
 * The order of the kinds (kinds_place) is fluid, boundary, grain, body: an index wants classes from small to
 * large (index.h), and grains are larger than the spacing of a fluid that resolves the flow around them. Bodies
 * meet nobody (their members do), so their sizes do not matter to an index.
 *
 * How to add a kind, in three steps:
 *   1. Add it to enum kind and its name to kinds.c.
 *   2. Call kinds_register where the scene decides that there are such particles, and set the kind
 *      of the particles at their creation. Fields that only this kind needs name it in field.kinds (fields.h).
 *   3. Choose the classes of each kind by classes_choose, and join them in the order of the kinds
 *      (kinds_join_classes). */
#ifndef SCREE_PARTICLES_KINDS_H
#define SCREE_PARTICLES_KINDS_H

#include "kernel/particles/particles.h"

enum kind { KIND_GRAIN, KIND_FLUID, KIND_BOUNDARY, KIND_BODY, KINDS };

/* "grain", "fluid", "boundary", "body". */
const char *kinds_name(enum kind kind);

/* The place of a kind in memory, 0 ... KINDS - 1, and the kind of a place. */
int kinds_place(enum kind kind);
enum kind kinds_at(int place);

/* Registers the field `kind`, grain by default. For sets with more than one kind. */
void kinds_register(struct particles *particles);

/* The kind of each particle; NULL if all are grains. Borrowed until the set grows. */
uint8_t *kinds_of(const struct particles *particles);

/* Adds the classes that were chosen for one kind behind those of the kinds before it, then sets skins and
 * margins of all. `classes` begins as {0}; kinds come in the order of their places. False, with a user's error, where
 * all together are more than CLASS_MAX. */
bool kinds_join_classes(struct size_classes *classes, enum kind kind, const struct size_classes *of_kind,
                        const struct classes_options *options, const struct classes_range *range,
                        struct error *error);

/* The class of a radius among those of a kind. A kind without classes is a programmer's mistake. */
int kinds_class(const struct size_classes *classes, enum kind kind, double radius);

/* Sorts an order of the owned particles (the new particle k is the old order[k]) by class, and leaves it as
 * it is inside a class; an index that orders by class has done so. Leaves sets with one kind alone. One
 * thread. */
void kinds_sort(const struct particles *particles, const struct size_classes *classes, uint32_t *order);

/* A contiguous range of particles: first ... end-1. */
struct kind_span {
    size_t first, end;
};

/* The owned particles of a kind. After a rebuild, while the order by class stands. */
struct kind_span kinds_span(const struct particles *particles, const struct size_classes *classes,
                            enum kind kind);

#endif
