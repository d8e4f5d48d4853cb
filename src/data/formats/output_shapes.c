/* SPDX-License-Identifier: BSD-3-Clause */
/* Keeps shapes. Read output_shapes.h first. */
#include "data/formats/output_shapes.h"

#include "base/memory.h"

struct output_shape *output_shapes_add(struct output_shapes *shapes) {
    shapes->shape =
        memory_resize(shapes->shape, (size_t)shapes->count + 1, sizeof *shapes->shape, "shapes for files");
    shapes->shape[shapes->count] = (struct output_shape){0};
    return &shapes->shape[shapes->count++];
}

void output_shapes_free(struct output_shapes *shapes) {
    for (int k = 0; k < shapes->count; k++) {
        memory_free(shapes->shape[k].corner);
        memory_free(shapes->shape[k].start);
        memory_free(shapes->shape[k].ring);
    }
    memory_free(shapes->shape);
    *shapes = (struct output_shapes){0};
}

uint64_t output_shapes_bytes(const struct output_shapes *shapes) {
    enum { ROOM_GROUP = 1 << 13 }; /* of a group, three datasets and their heads */
    uint64_t bytes = 0;
    for (int k = 0; k < shapes->count; k++) {
        const struct output_shape *shape = &shapes->shape[k];
        bytes += ROOM_GROUP + (uint64_t)shape->corners * sizeof *shape->corner +
                 (uint64_t)(shape->polygons + 1 + shape->start[shape->polygons]) * sizeof *shape->ring;
    }
    return bytes;
}
