#include "formats/frame.h"

#include <string.h>

/* Adds a column that borrows `data`, named and typed as the field table has it. */
static void borrow(struct frame *frame, const char *name, void *data, bool spatial, bool fixed) {
    if (!data)
        return;
    bool mass = strcmp(name, "mass") == 0;
    const struct field *field = fields_get(fields_find(mass ? "inverse_mass" : name));
    frame->column[frame->columns++] =
        (struct frame_column){.name = name,
                              .unit = mass ? "kg" : field->unit,
                              .type = field->type == FIELD_UINT8 ? FIELD_INT32 : field->type,
                              .components = field->components,
                              .spatial = spatial,
                              .fixed = fixed,
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
    borrow(frame, "id", rows->id, false, true);
    borrow(frame, "position", rows->position, true, false);
    borrow(frame, "velocity", rows->velocity, true, false);
    borrow(frame, "radius", rows->radius, false, true);
    borrow(frame, "mass", rows->mass, false, true);
    borrow(frame, "angular_velocity", rows->angular_velocity, false, false);
    borrow(frame, "material", rows->material, false, true);
    borrow(frame, "image", rows->image, true, false);
}
