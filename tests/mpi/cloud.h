/* SPDX-License-Identifier: BSD-3-Clause */
/* A cloud of particles that every rank knows as a whole, because every rank can make the cloud: the oracle of
 * the tests of migration and copies. Particle k has id k + 1. The value of every field follows from the id and
 * a number (`stamp`), so that any rank knows the right value. */
#ifndef SCREE_TESTS_MPI_CLOUD_H
#define SCREE_TESTS_MPI_CLOUD_H

#include "kernel/particles/particles.h"
#include "tests/fields_by_hand.h"

enum cloud_radii {
    CLOUD_EQUAL,
    CLOUD_BIDISPERSE, /* ratio 10, one particle in twenty is large */
    CLOUD_CONTINUOUS, /* uniform in log radius, ratio 30 */
    CLOUD_BOULDERS    /* dust, and two boulders of 0.42 and 0.45 of the shortest edge */
};

struct cloud {
    size_t n;
    struct box box;
    double (*x)[3], *radius;
    struct size_classes classes;
};

/* Makes a cloud in a box; positions wrapped, a few beyond open sides. */
void cloud_make(struct cloud *cloud, const struct box *box, enum cloud_radii radii, size_t n, uint64_t seed);
void cloud_free(struct cloud *cloud);

/* Gives all particles new positions, unrelated to the old ones. */
void cloud_scatter(struct cloud *cloud, uint64_t seed);

/* The number by which cloud_value knows the field of a name, and a field of a set. */
int cloud_code(const char *name);
static inline int cloud_field(const struct particles *particles, int field) {
    return cloud_code(fields_get(particles, field)->name);
}

/* The value of a field's component of the particle with this id, small whole numbers; exact in any type. */
double cloud_value(int64_t id, int code, int component, unsigned stamp);

/* Appends particle k to the set: its position, radius and id, and cloud_value in all other fields. */
void cloud_append(const struct cloud *cloud, size_t k, unsigned stamp, struct particles *particles);

/* Reads, and sets, one component of a field of local particle `i`. */
double cloud_get(const struct particles *particles, int field, int component, size_t i);
void cloud_set(struct particles *particles, int field, int component, size_t i, double value);

/* True if the field is one that cloud_value fills (not position, radius, id, size_class). */
bool cloud_stamped(const struct field *field);

#endif
