/* SPDX-License-Identifier: BSD-3-Clause */
/* A frame of rows that were read from a file. Read frame.h first. */
#include "data/formats/frame.h"

#include <string.h>

/* Adds a column that borrows `data`, with the description of the field. */
static void borrow(struct frame *frame, const struct particles *known, const char *name, void *data) {
    bool mass = strcmp(name, "mass") == 0;
    if (!data)
        return;
    struct frame_field shown =
        frame_field_get(fields_get(known, fields_find(known, mass ? "inverse_mass" : name)));
    frame->column[frame->columns++] = (struct frame_column){.name = name,
                                                            .unit = shown.unit,
                                                            .type = shown.type,
                                                            .components = shown.components,
                                                            .spatial = shown.spatial,
                                                            .fixed = shown.fixed,
                                                            .data = data};
}

void frame_from_rows(struct frame *frame, const struct rows *rows) {
    *frame = (struct frame){.step = rows->step,
                            .time = rows->time,
                            .rows = rows->count,
                            .total = rows->count,
                            .box = {.dimension = rows->dimension}};
    for (int d = 0; d < 3; d++) {
        frame->box.origin[d] = rows->lower[d];
        frame->box.edge[d] = rows->upper[d] - rows->lower[d];
        frame->box.periodic[d] = rows->periodic[d];
    }
    frame->box.motion.shears = rows->tilt.flow != rows->tilt.gradient;
    frame->box.motion.flow = rows->tilt.flow;
    frame->box.motion.gradient = rows->tilt.gradient;
    frame->box.motion.offset = rows->tilt.offset;
    struct particles *known = particles_create(0);
    frame_register_all(known);
    for (int k = 0; k < ROWS_KINDS; k++)
        if (rows_kinds[k].name)
            borrow(frame, known, rows_kinds[k].name, rows_values(rows, &rows_kinds[k]));
    particles_destroy(&known);
}
