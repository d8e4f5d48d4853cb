/* SPDX-License-Identifier: BSD-3-Clause */
/* The arrays behind the fields: the first arrays, and the functions that keep struct particles and the table
 * consistent. */
#include "kernel/particles/storage.h"

/* clang-format off */
static const struct field position = {
    .name = "position", .type = FIELD_DOUBLE, .components = 3, .unit = "m", .help = "centre",
    .use = FIELD_GHOST | FIELD_FORWARD | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_SPATIAL};
static const struct field velocity = {
    .name = "velocity", .type = FIELD_DOUBLE, .components = 3, .unit = "m s-1", .help = "velocity of the centre",
    .use = FIELD_GHOST | FIELD_FORWARD | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_SPATIAL};
static const struct field radius = {
    .name = "radius", .type = FIELD_DOUBLE, .components = 1, .unit = "m", .help = "radius",
    .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_FIXED};
static const struct field inverse_mass = {
    .name = "inverse_mass", .type = FIELD_DOUBLE, .components = 1, .unit = "kg-1",
    .help = "1 / mass; 0 while motion is prescribed",
    .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_FIXED};
static const struct field force = {
    .name = "force", .type = FIELD_DOUBLE, .components = 3, .room = 4, .unit = "N",
    .help = "force of contacts and walls, without gravity",
    .use = FIELD_REVERSE | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_SPATIAL};
static const struct field id = {
    .name = "id", .type = FIELD_INT64, .components = 1, .unit = "", .help = "unique number, from 1",
    .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_FIXED};
static const struct field size_class = {
    .name = "size_class", .type = FIELD_UINT8, .components = 1, .unit = "", .help = "size class, from small to large",
    .use = FIELD_GHOST | FIELD_OUTPUT | FIELD_ASKED};
/* clang-format on */

void storage_begin(struct storage *storage) {
    *storage = (struct storage){
        .arrays = STORAGE_FIRST_COUNT,
        .fields = FIELD_FIRST_COUNT,
        .array = {[STORAGE_STATE] = {.stride = sizeof(struct particle_state)},
                  [STORAGE_FORCE] = {.stride = 4 * sizeof(double)},
                  [STORAGE_ID] = {.stride = sizeof(int64_t)},
                  [STORAGE_CLASS] = {.stride = sizeof(uint8_t)}},
        .place = {
            [FIELD_POSITION] = {&position, STORAGE_STATE, offsetof(struct particle_state, x)},
            [FIELD_VELOCITY] = {&velocity, STORAGE_STATE, offsetof(struct particle_state, v)},
            [FIELD_RADIUS] = {&radius, STORAGE_STATE, offsetof(struct particle_state, radius)},
            [FIELD_INVERSE_MASS] = {&inverse_mass, STORAGE_STATE,
                                    offsetof(struct particle_state, inverse_mass)},
            [FIELD_FORCE] = {&force, STORAGE_FORCE, 0},
            [FIELD_ID] = {&id, STORAGE_ID, 0},
            [FIELD_SIZE_CLASS] = {&size_class, STORAGE_CLASS, 0},
        }};
}

void storage_publish(struct particles *particles) {
    const struct storage_array *array = particles->storage->array;
    particles->state = (struct particle_state *)(void *)array[STORAGE_STATE].base;
    particles->force = (double *)(void *)array[STORAGE_FORCE].base;
    particles->force_stride = (int)(array[STORAGE_FORCE].stride / sizeof(double));
    particles->id = (int64_t *)(void *)array[STORAGE_ID].base;
    particles->size_class = (uint8_t *)array[STORAGE_CLASS].base;
}

static void put_value(char *to, enum field_type type, int components, double value) {
    for (int c = 0; c < components; c++) {
        switch (type) {
        case FIELD_DOUBLE:
            ((double *)(void *)to)[c] = value;
            break;
        case FIELD_INT64:
            ((int64_t *)(void *)to)[c] = (int64_t)value;
            break;
        case FIELD_INT32:
            ((int32_t *)(void *)to)[c] = (int32_t)value;
            break;
        case FIELD_UINT8:
            ((uint8_t *)to)[c] = (uint8_t)value;
            break;
        }
    }
}

void storage_fill(const struct particles *particles, size_t first, size_t n) {
    const struct storage *storage = particles->storage;
    for (int f = 0; storage->filled && f < storage->fields; f++) {
        const struct field *field = storage->place[f].field;
        if (field->fill == 0)
            continue;
        size_t stride;
        char *base = fields_base(particles, f, &stride);
        for (size_t k = first; k < first + n; k++)
            put_value(base + k * stride, field->type, field->components, field->fill);
    }
}
