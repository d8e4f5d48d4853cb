/* SPDX-License-Identifier: BSD-3-Clause */
/* Sets of particles with the fields that a test asks for, as scenes bring them. */
#ifndef TESTS_FIELDS_BY_HAND_H
#define TESTS_FIELDS_BY_HAND_H

#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/fields.h"

enum { WITH_SPIN = 1, WITH_MATERIAL = 2, WITH_GROUP = 4, WITH_IMAGE = 8, WITH_ALL = 15, WITH_OTHERS = 16 };

/* Fields that the program does not know. */
enum { OTHERS_USE = FIELD_GHOST | FIELD_FORWARD | FIELD_TRAVELS | FIELD_OUTPUT };
static const struct field field_visits = {.name = "visits",
                                          .type = FIELD_INT64,
                                          .components = 1,
                                          .use = OTHERS_USE,
                                          .fill = -3,
                                          .help = "one whole number"};
static const struct field field_flux = {
    .name = "flux", .type = FIELD_DOUBLE, .components = 3, .use = OTHERS_USE, .fill = 0.5, .help = "three"};
static const struct field field_strain = {
    .name = "strain", .type = FIELD_DOUBLE, .components = 5, .use = OTHERS_USE, .help = "five"};
static const struct field field_heat = {
    .name = "heat", .type = FIELD_DOUBLE, .components = 1, .use = FIELD_REVERSE, .help = "a sum"};
static const struct field field_moment = {.name = "moment",
                                          .type = FIELD_DOUBLE,
                                          .components = 5,
                                          .use = FIELD_REVERSE | FIELD_TRAVELS,
                                          .help = "five sums"};

static inline struct particles *particles_with(unsigned fields, size_t capacity) {
    struct particles *particles = particles_create(capacity);
    if (fields & WITH_SPIN)
        spin_register(particles);
    if (fields & WITH_MATERIAL)
        material_register(particles);
    if (fields & WITH_GROUP)
        groups_register(particles);
    if (fields & WITH_IMAGE)
        particles_count_images(particles);
    if (fields & WITH_OTHERS) {
        fields_register(particles, &field_visits);
        fields_register(particles, &field_flux);
        fields_register(particles, &field_strain);
        fields_register(particles, &field_heat);
        fields_register(particles, &field_moment);
    }
    return particles;
}

#endif
