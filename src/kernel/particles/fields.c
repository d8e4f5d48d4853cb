/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of fields of a set, and their way into buffers and back. */
#include "kernel/particles/fields.h"
#include "base/memory.h"
#include "kernel/particles/storage.h"
#include <assert.h>
#include <string.h>

static size_t type_bytes(enum field_type type) {
    static const size_t size[] = {
        [FIELD_DOUBLE] = 8, [FIELD_INT64] = 8, [FIELD_INT32] = 4, [FIELD_UINT8] = 1};
    return size[type];
}

size_t fields_bytes(const struct field *field) {
    return type_bytes(field->type) * (size_t)field->components;
}

/* Bytes that a field takes in memory. */
static size_t room_bytes(const struct field *field) {
    return type_bytes(field->type) * (size_t)(field->room > 0 ? field->room : field->components);
}

int fields_count(const struct particles *particles) {
    return particles->storage->fields;
}

const struct field *fields_get(const struct particles *particles, int f) {
    assert(f >= 0 && f < particles->storage->fields);
    return particles->storage->place[f].field;
}

int fields_handle(const struct particles *particles, const struct field *field) {
    const struct storage *storage = particles->storage;
    for (int f = FIELD_FIRST_COUNT; f < storage->fields; f++)
        if (storage->place[f].field == field)
            return f;
    return -1;
}

int fields_find(const struct particles *particles, const char *name) {
    const struct storage *storage = particles->storage;
    for (int f = 0; f < storage->fields; f++)
        if (strcmp(storage->place[f].field->name, name) == 0)
            return f;
    return -1;
}

void *fields_base(const struct particles *particles, int f, size_t *stride) {
    const struct storage *storage = particles->storage;
    assert(f >= 0 && f < storage->fields);
    const struct storage_place *place = &storage->place[f];
    if (stride)
        *stride = storage->array[place->array].stride;
    return storage->array[place->array].base + place->offset;
}

void *fields_values(const struct particles *particles, const struct field *field) {
    int f = fields_handle(particles, field);
    return f < 0 ? NULL : fields_base(particles, f, NULL);
}

double *fields_numbers(const struct particles *particles, const char *name) {
    int f = fields_find(particles, name);
    return f < 0 ? NULL : fields_base(particles, f, NULL);
}

double fields_component(const struct field *field, const void *at, int k) {
    switch (field->type) {
    case FIELD_DOUBLE:
        return ((const double *)at)[k];
    case FIELD_INT64:
        return (double)((const int64_t *)at)[k];
    case FIELD_INT32:
        return ((const int32_t *)at)[k];
    default:
        return ((const uint8_t *)at)[k];
    }
}

/* Enters a field into the table. */
static int enter(struct particles *particles, const struct field *field, int array, size_t offset) {
    struct storage *storage = particles->storage;
    if (fields_find(particles, field->name) >= 0)
        error_fatal("field %s: two physics have a field of this name", field->name);
    assert(field->components >= 1 && field->components <= FIELD_COMPONENTS_MAX);
    assert(!(field->use & FIELD_REVERSE) || field->type == FIELD_DOUBLE);
    assert(!(field->use & FIELD_SPATIAL) || field->components == 3);
    if (storage->fields == FIELDS_MAX)
        error_fatal("field %s: a set of particles has up to %d fields", field->name, FIELDS_MAX);
    storage->place[storage->fields] = (struct storage_place){field, array, offset};
    storage->filled = storage->filled || field->fill != 0;
    return storage->fields++;
}

int fields_register(struct particles *particles, const struct field *field) {
    struct storage *storage = particles->storage;
    int known = fields_handle(particles, field);
    if (known >= 0)
        return known;
    int f = enter(particles, field, storage->arrays, 0);
    size_t n = particles->owned + particles->ghosts, stride = room_bytes(field);
    struct storage_array *array = &storage->array[storage->arrays++];
    *array = (struct storage_array){memory_allocate(particles->capacity, stride, field->name), stride};
    memset(array->base, 0, n * stride);
    storage_fill(particles, 0, n);
    return f;
}

int fields_register_with_force(struct particles *particles, const struct field *field) {
    struct storage_array *array = &particles->storage->array[STORAGE_FORCE];
    int known = fields_handle(particles, field);
    if (known >= 0)
        return known;
    assert(field->type == FIELD_DOUBLE && field->fill == 0);
    assert(room_bytes(field) % 32 == 0); /* records are read by vectors of four */
    size_t n = particles->owned + particles->ghosts, old = array->stride, stride = old + room_bytes(field);
    int f = enter(particles, field, STORAGE_FORCE, old);
    char *wide = memory_allocate(particles->capacity, stride, "particles");
    memset(wide, 0, n * stride);
    for (size_t k = 0; k < n; k++)
        memcpy(wide + k * stride, array->base + k * old, old);
    memory_free(array->base);
    *array = (struct storage_array){wide, stride};
    storage_publish(particles);
    return f;
}

int fields_flowing(const struct particles *particles, struct fields_flow flow[FIELDS_MAX]) {
    const struct field_list list = fields_with(particles, FIELD_FLOWS);
    for (int k = 0; k < list.count; k++) {
        const struct field *field = fields_get(particles, list.field[k]);
        assert(field->type == FIELD_DOUBLE && field->components == 3 && field->room == 0);
        flow[k] = (struct fields_flow){fields_base(particles, list.field[k], NULL), field->kinds};
    }
    return list.count;
}

struct field_list fields_with(const struct particles *particles, unsigned use) {
    struct field_list list = {.count = 0};
    for (int f = 0; f < particles->storage->fields; f++)
        if (particles->storage->place[f].field->use & use)
            list.field[list.count++] = f;
    return list;
}

struct field_list fields_one(int f) {
    return (struct field_list){.count = 1, .field = {f}};
}

bool fields_listed(const struct field_list *list, int f) {
    for (int k = 0; k < list->count; k++)
        if (list->field[k] == f)
            return true;
    return false;
}

/* The listed fields, resolved once a call. */
struct transfer {
    int count;
    struct {
        char *base;
        size_t stride, bytes;
    } field[FIELDS_MAX];
};

static void transfer_make(struct transfer *t, const struct particles *particles,
                          const struct field_list *fields) {
    t->count = fields->count;
    for (int k = 0; k < fields->count; k++) {
        int f = fields->field[k];
        t->field[k].base = fields_base(particles, f, &t->field[k].stride);
        t->field[k].bytes = fields_bytes(fields_get(particles, f));
    }
}

size_t fields_packed_bytes(const struct particles *particles, const struct field_list *fields) {
    size_t bytes = 0;
    for (int k = 0; k < fields->count; k++)
        bytes += fields_bytes(fields_get(particles, fields->field[k]));
    return bytes;
}

char *fields_pack(const struct particles *particles, const struct field_list *fields, const uint32_t *list,
                  size_t n, char *buffer) {
    struct transfer t;
    transfer_make(&t, particles, fields);
    for (size_t k = 0; k < n; k++) {
        for (int f = 0; f < t.count; f++) {
            memcpy(buffer, t.field[f].base + list[k] * t.field[f].stride, t.field[f].bytes);
            buffer += t.field[f].bytes;
        }
    }
    return buffer;
}

const char *fields_unpack(struct particles *particles, const struct field_list *fields, size_t first,
                          size_t n, const char *buffer) {
    assert(first + n <= particles->capacity);
    struct transfer t;
    transfer_make(&t, particles, fields);
    for (size_t k = first; k < first + n; k++) {
        for (int f = 0; f < t.count; f++) {
            memcpy(t.field[f].base + k * t.field[f].stride, buffer, t.field[f].bytes);
            buffer += t.field[f].bytes;
        }
    }
    return buffer;
}

const char *fields_unpack_list(struct particles *particles, const struct field_list *fields,
                               const uint32_t *list, size_t n, const char *buffer) {
    struct transfer t;
    transfer_make(&t, particles, fields);
    for (size_t k = 0; k < n; k++) {
        for (int f = 0; f < t.count; f++) {
            memcpy(t.field[f].base + list[k] * t.field[f].stride, buffer, t.field[f].bytes);
            buffer += t.field[f].bytes;
        }
    }
    return buffer;
}

const char *fields_unpack_add(struct particles *particles, const struct field_list *fields,
                              const uint32_t *list, size_t n, const char *buffer) {
    struct transfer t;
    transfer_make(&t, particles, fields);
    for (int k = 0; k < fields->count; k++)
        assert(fields_get(particles, fields->field[k])->type == FIELD_DOUBLE);
    for (size_t k = 0; k < n; k++) {
        for (int f = 0; f < t.count; f++) {
            double *to = (double *)(void *)(t.field[f].base + list[k] * t.field[f].stride);
            for (size_t c = 0; c < t.field[f].bytes / sizeof(double); c++) {
                double add;
                memcpy(&add, buffer, sizeof add);
                to[c] += add;
                buffer += sizeof add;
            }
        }
    }
    return buffer;
}

void fields_clear_reverse(struct particles *particles, size_t first, size_t n) {
    const struct storage *storage = particles->storage;
    for (int f = 0; f < storage->fields; f++) {
        const struct storage_place *place = &storage->place[f];
        const struct storage_array *array = &storage->array[place->array];
        if ((place->field->use & FIELD_REVERSE) && place->offset == 0)
            memset(array->base + first * array->stride, 0, n * array->stride);
    }
}
