/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes and frees rows. Read rows.h first. */
#include "data/formats/rows.h"

#include "base/memory.h"

#include <string.h>

#define KIND(bit, name, type, components, fixed, member)                                                     \
    { bit, name, type, components, fixed, offsetof(struct rows, member) }
const struct rows_kind rows_kinds[ROWS_KINDS] = {
    KIND(ROWS_ID, "id", FIELD_INT64, 1, true, id),
    KIND(ROWS_POSITION, "position", FIELD_DOUBLE, 3, false, position),
    KIND(ROWS_VELOCITY, "velocity", FIELD_DOUBLE, 3, false, velocity),
    KIND(ROWS_RADIUS, "radius", FIELD_DOUBLE, 1, true, radius),
    KIND(ROWS_MASS, "mass", FIELD_DOUBLE, 1, true, mass),
    KIND(ROWS_ANGULAR_VELOCITY, "angular_velocity", FIELD_DOUBLE, 3, false, angular_velocity),
    KIND(ROWS_MATERIAL, "material", FIELD_INT32, 1, true, material),
    KIND(ROWS_IMAGE, "image", FIELD_INT32, 3, false, image),
    KIND(ROWS_LINE, NULL, FIELD_INT32, 1, false, line),
    KIND(ROWS_KIND, "kind", FIELD_INT32, 1, true, kind),
    KIND(ROWS_BODY, "body", FIELD_INT64, 1, true, body),
    KIND(ROWS_BODY_PART, "body_part", FIELD_INT32, 1, true, body_part),
    KIND(ROWS_BODY_MASS, "body_mass", FIELD_DOUBLE, 1, true, body_mass),
    KIND(ROWS_ORIENTATION, "orientation", FIELD_DOUBLE, 4, false, orientation),
    KIND(ROWS_ROCK_SHAPE, "rock_shape", FIELD_INT32, 1, false, rock_shape),
    KIND(ROWS_ROCK_ORIENTATION, "rock_orientation", FIELD_DOUBLE, 4, false, rock_orientation),
};
#undef KIND

/* All pointers to data are alike in memory; copies of bytes take them whatever they point to. */
void *rows_values(const struct rows *rows, const struct rows_kind *kind) {
    void *values;
    memcpy(&values, (const char *)rows + kind->place, sizeof values);
    return values;
}

void rows_set(struct rows *rows, const struct rows_kind *kind, void *values) {
    memcpy((char *)rows + kind->place, &values, sizeof values);
}

size_t rows_bytes(const struct rows_kind *kind) {
    return (kind->type == FIELD_INT32 ? sizeof(int32_t) : sizeof(int64_t)) * (size_t)kind->components;
}

void rows_move(struct rows *rows, size_t from, size_t to) {
    for (int k = 0; k < ROWS_KINDS && from != to; k++) {
        char *values = rows_values(rows, &rows_kinds[k]);
        const size_t bytes = rows_bytes(&rows_kinds[k]);
        if (values)
            memcpy(values + to * bytes, values + from * bytes, bytes);
    }
}

void rows_create(struct rows *rows, size_t count, unsigned columns) {
    *rows = (struct rows){.count = count, .total = count, .dimension = 3};
    for (int k = 0; k < ROWS_KINDS; k++)
        if (columns & rows_kinds[k].bit)
            rows_set(rows, &rows_kinds[k],
                     memory_allocate_zero(count, rows_bytes(&rows_kinds[k]), "rows of a file"));
}

void rows_free(struct rows *rows) {
    for (int k = 0; k < ROWS_KINDS; k++)
        memory_free(rows_values(rows, &rows_kinds[k]));
    *rows = (struct rows){0};
}

bool rows_tilt_of(const double tilt[3], struct rows_tilt *out) {
    int tilts = 0;
    *out = (struct rows_tilt){0};
    for (int k = 0; k < 3; k++)
        if (tilt[k] != 0) {
            *out = (struct rows_tilt){.flow = k == 2, .gradient = k == 0 ? 1 : 2, .offset = tilt[k]};
            tilts++;
        }
    return tilts <= 1;
}

unsigned rows_columns(const struct rows *rows) {
    unsigned columns = 0;
    for (int k = 0; k < ROWS_KINDS; k++)
        if (rows_kinds[k].name && rows_values(rows, &rows_kinds[k]))
            columns |= rows_kinds[k].bit;
    return columns;
}
