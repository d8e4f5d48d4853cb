/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes and frees rows. Read rows.h first. */
#include "data/formats/rows.h"

#include "base/memory.h"

static void *column(unsigned columns, enum rows_column which, size_t count, size_t bytes) {
    return columns & which ? memory_allocate_zero(count, bytes, "rows of a file") : NULL;
}

void rows_create(struct rows *rows, size_t count, unsigned columns) {
    *rows = (struct rows){.count = count,
                          .total = count,
                          .dimension = 3,
                          .position = column(columns, ROWS_POSITION, count, sizeof *rows->position),
                          .velocity = column(columns, ROWS_VELOCITY, count, sizeof *rows->velocity),
                          .angular_velocity =
                              column(columns, ROWS_ANGULAR_VELOCITY, count, sizeof *rows->angular_velocity),
                          .radius = column(columns, ROWS_RADIUS, count, sizeof *rows->radius),
                          .mass = column(columns, ROWS_MASS, count, sizeof *rows->mass),
                          .id = column(columns, ROWS_ID, count, sizeof *rows->id),
                          .material = column(columns, ROWS_MATERIAL, count, sizeof *rows->material),
                          .image = column(columns, ROWS_IMAGE, count, sizeof *rows->image),
                          .line = column(columns, ROWS_LINE, count, sizeof *rows->line)};
}

void rows_free(struct rows *rows) {
    memory_free(rows->position);
    memory_free(rows->velocity);
    memory_free(rows->angular_velocity);
    memory_free(rows->radius);
    memory_free(rows->mass);
    memory_free(rows->id);
    memory_free(rows->material);
    memory_free(rows->image);
    memory_free(rows->line);
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
    return (rows->position ? ROWS_POSITION : 0u) | (rows->velocity ? ROWS_VELOCITY : 0u) |
           (rows->angular_velocity ? ROWS_ANGULAR_VELOCITY : 0u) | (rows->radius ? ROWS_RADIUS : 0u) |
           (rows->mass ? ROWS_MASS : 0u) | (rows->id ? ROWS_ID : 0u) | (rows->material ? ROWS_MATERIAL : 0u) |
           (rows->image ? ROWS_IMAGE : 0u);
}
