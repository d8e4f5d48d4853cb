#include "particles/fields.h"
#include "particles/storage.h"
#include <assert.h>
#include <string.h>

struct field_place {
    struct field field;
    enum storage_array array;
    size_t offset; /* bytes from the particle's start in the array */
};

enum { TRAVELS = FIELD_MIGRATE | FIELD_RESTART };

static const struct field_place field_table[] = {
    {{"position", FIELD_DOUBLE, 3, 0, FIELD_GHOST | FIELD_FORWARD | TRAVELS, "m", "centre"},
     STORAGE_STATE,
     offsetof(struct particle_state, x)},
    {{"velocity", FIELD_DOUBLE, 3, 0, FIELD_GHOST | FIELD_FORWARD | TRAVELS, "m s-1",
      "velocity of the centre"},
     STORAGE_STATE,
     offsetof(struct particle_state, v)},
    {{"radius", FIELD_DOUBLE, 1, 0, FIELD_GHOST | TRAVELS, "m", "radius"},
     STORAGE_STATE,
     offsetof(struct particle_state, radius)},
    {{"inverse_mass", FIELD_DOUBLE, 1, 0, FIELD_GHOST | TRAVELS, "kg-1",
      "1 / mass; 0 while motion is prescribed"},
     STORAGE_STATE,
     offsetof(struct particle_state, inverse_mass)},
    {{"angular_velocity", FIELD_DOUBLE, 3, PARTICLE_SPIN, FIELD_GHOST | FIELD_FORWARD | TRAVELS, "rad s-1",
      "angular velocity"},
     STORAGE_OMEGA,
     0},
    {{"force", FIELD_DOUBLE, 3, 0, FIELD_REVERSE | TRAVELS, "N",
      "force of contacts and walls, without gravity"},
     STORAGE_FORCE,
     0},
    {{"torque", FIELD_DOUBLE, 3, PARTICLE_SPIN, FIELD_REVERSE | TRAVELS, "N m", "torque about the centre"},
     STORAGE_FORCE,
     4 * sizeof(double)},
    {{"id", FIELD_INT64, 1, 0, FIELD_GHOST | TRAVELS, "", "unique number, from 1"}, STORAGE_ID, 0},
    {{"size_class", FIELD_UINT8, 1, 0, FIELD_GHOST, "", "size class, from small to large"}, STORAGE_CLASS, 0},
    {{"material", FIELD_UINT8, 1, PARTICLE_MATERIAL, FIELD_GHOST | TRAVELS, "",
      "number of the material, from 0"},
     STORAGE_MATERIAL,
     0},
    {{"group", FIELD_UINT8, 1, PARTICLE_GROUP, TRAVELS, "", "number of the group, 0 = free"},
     STORAGE_GROUP,
     0},
    {{"density", FIELD_DOUBLE, 1, PARTICLE_GROUP, TRAVELS, "kg m-3", "mass / volume"}, STORAGE_DENSITY, 0},
    {{"image", FIELD_INT32, 3, PARTICLE_IMAGE, TRAVELS, "", "crossings of the periodic box"},
     STORAGE_IMAGE,
     0},
};

enum { FIELDS = sizeof field_table / sizeof field_table[0] };

int fields_count(void) {
    return FIELDS;
}

const struct field *fields_get(int f) {
    assert(f >= 0 && f < FIELDS);
    return &field_table[f].field;
}

int fields_find(const char *name) {
    for (int f = 0; f < FIELDS; f++)
        if (strcmp(field_table[f].field.name, name) == 0)
            return f;
    return -1;
}

bool fields_present(const struct particles *particles, int f) {
    unsigned needs = field_table[f].field.needs;
    return (particles->features & needs) == needs;
}

void *fields_base(const struct particles *particles, int f, size_t *stride) {
    assert(fields_present(particles, f));
    *stride = storage_stride(field_table[f].array, particles->features);
    return (char *)storage_get(particles, field_table[f].array) + field_table[f].offset;
}

size_t fields_bytes(int f) {
    static const size_t size[] = {
        [FIELD_DOUBLE] = 8, [FIELD_INT64] = 8, [FIELD_INT32] = 4, [FIELD_UINT8] = 1};
    return size[field_table[f].field.type] * (size_t)field_table[f].field.components;
}

/* The present fields that a transfer carries, resolved once a call. */
struct transfer {
    int count;
    struct {
        char *base;
        size_t stride, bytes;
    } field[FIELDS];
};

static struct transfer transfer_of(const struct particles *particles, unsigned use) {
    struct transfer t = {0};
    for (int f = 0; f < FIELDS; f++) {
        if (!(field_table[f].field.use & use) || !fields_present(particles, f))
            continue;
        t.field[t.count].base = fields_base(particles, f, &t.field[t.count].stride);
        t.field[t.count].bytes = fields_bytes(f);
        t.count++;
    }
    return t;
}

size_t fields_packed_bytes(const struct particles *particles, unsigned use) {
    struct transfer t = transfer_of(particles, use);
    size_t bytes = 0;
    for (int f = 0; f < t.count; f++)
        bytes += t.field[f].bytes;
    return bytes;
}

char *fields_pack(const struct particles *particles, unsigned use, const uint32_t *list, size_t n,
                  char *buffer) {
    struct transfer t = transfer_of(particles, use);
    for (size_t k = 0; k < n; k++) {
        for (int f = 0; f < t.count; f++) {
            memcpy(buffer, t.field[f].base + list[k] * t.field[f].stride, t.field[f].bytes);
            buffer += t.field[f].bytes;
        }
    }
    return buffer;
}

const char *fields_unpack(struct particles *particles, unsigned use, size_t first, size_t n,
                          const char *buffer) {
    assert(first + n <= particles->capacity);
    struct transfer t = transfer_of(particles, use);
    for (size_t k = first; k < first + n; k++) {
        for (int f = 0; f < t.count; f++) {
            memcpy(t.field[f].base + k * t.field[f].stride, buffer, t.field[f].bytes);
            buffer += t.field[f].bytes;
        }
    }
    return buffer;
}

const char *fields_unpack_add(struct particles *particles, const uint32_t *list, size_t n,
                              const char *buffer) {
    struct transfer t = transfer_of(particles, FIELD_REVERSE);
    for (size_t k = 0; k < n; k++) {
        for (int f = 0; f < t.count; f++) {
            double add[3];
            double *to = (double *)(void *)(t.field[f].base + list[k] * t.field[f].stride);
            assert(t.field[f].bytes == sizeof add);
            memcpy(add, buffer, sizeof add);
            for (int d = 0; d < 3; d++)
                to[d] += add[d];
            buffer += sizeof add;
        }
    }
    return buffer;
}
