#include "particles/storage.h"
#include <assert.h>
#include <string.h>

struct storage_row {
    size_t member; /* offset of the pointer in struct particles */
    size_t stride; /* bytes a particle; 0: the force record, which depends on the features */
    unsigned needs;
};

static const struct storage_row storage_rows[STORAGE_ARRAYS] = {
    [STORAGE_STATE] = {offsetof(struct particles, state), sizeof(struct particle_state), 0},
    [STORAGE_OMEGA] = {offsetof(struct particles, omega), 4 * sizeof(double), PARTICLE_SPIN},
    [STORAGE_FORCE] = {offsetof(struct particles, force), 0, 0},
    [STORAGE_ID] = {offsetof(struct particles, id), sizeof(int64_t), 0},
    [STORAGE_CLASS] = {offsetof(struct particles, size_class), sizeof(uint8_t), 0},
    [STORAGE_MATERIAL] = {offsetof(struct particles, material), sizeof(uint8_t), PARTICLE_MATERIAL},
    [STORAGE_GROUP] = {offsetof(struct particles, group), sizeof(uint8_t), PARTICLE_GROUP},
    [STORAGE_DENSITY] = {offsetof(struct particles, density), sizeof(double), PARTICLE_GROUP},
    [STORAGE_IMAGE] = {offsetof(struct particles, image), 3 * sizeof(int32_t), PARTICLE_IMAGE},
};

bool storage_present(enum storage_array array, unsigned features) {
    unsigned needs = storage_rows[array].needs;
    return (features & needs) == needs;
}

size_t storage_stride(enum storage_array array, unsigned features) {
    if (array == STORAGE_FORCE)
        return ((features & PARTICLE_SPIN) ? 8 : 4) * sizeof(double);
    return storage_rows[array].stride;
}

void *storage_get(const struct particles *particles, enum storage_array array) {
    void *pointer;
    memcpy(&pointer, (const char *)particles + storage_rows[array].member, sizeof pointer);
    return pointer;
}

void storage_set(struct particles *particles, enum storage_array array, void *pointer) {
    memcpy((char *)particles + storage_rows[array].member, &pointer, sizeof pointer);
}
