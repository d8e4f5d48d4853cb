/* SPDX-License-Identifier: BSD-3-Clause */
/* Keeps shapes, and writes them to H5MD. Read output_shapes.h first. */
#include "data/formats/output_shapes.h"

#include "base/memory.h"
#include "data/formats/h5md_file.h"

#include <stdio.h>

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

/* Writes a table of the first rank. */
static bool write_array(const struct h5md *h5md, const struct h5 *h5, const char *group, const char *name,
                        enum field_type type, int rows, int width, const void *data, struct error *error) {
    char dataset[FILE_PATH_MAX];
    const struct h5_table table = {.type = type,
                                   .rows = (uint64_t)rows,
                                   .width = (uint64_t)width,
                                   .count = h5md->comm->rank == 0 ? (uint64_t)rows : 0};
    snprintf(dataset, sizeof dataset, "%s/%s", group, name);
    return h5_write_table(h5, dataset, &table, data, error);
}

bool output_shapes_write(const struct h5md *h5md, const struct h5 *h5, struct error *error) {
    const struct output_shapes *shapes = h5md->shapes;
    for (int k = 0; shapes && k < shapes->count; k++) {
        const struct output_shape *shape = &shapes->shape[k];
        char group[OUTPUT_NAME_MAX];
        snprintf(group, sizeof group, "/parameters/shapes/%d", shape->number);
        if (!h5_make_group(h5, group, error) || !h5_write_text(h5, group, "name", shape->name, error) ||
            !h5_write_doubles(h5, group, "radius", &shape->radius, 0, error) ||
            !h5_write_doubles(h5, group, "rounding", &shape->rounding, 0, error) ||
            !write_array(h5md, h5, group, "corners", FIELD_DOUBLE, shape->corners, 3, shape->corner, error) ||
            !write_array(h5md, h5, group, "polygon_start", FIELD_INT32, shape->polygons + 1, 0, shape->start,
                         error) ||
            !write_array(h5md, h5, group, "polygon_corners", FIELD_INT32, shape->start[shape->polygons], 0,
                         shape->ring, error))
            return false;
    }
    return true;
}
