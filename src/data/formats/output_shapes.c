/* SPDX-License-Identifier: BSD-3-Clause */
/* Keeps shapes, writes them to H5MD and reads them from there. Read output_shapes.h first. */
#include "data/formats/output_shapes.h"

#include "base/memory.h"
#include "data/formats/h5md_file.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

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

static const char group_of_all[] = "/parameters/shapes";

bool output_shapes_write(const struct h5md *h5md, const struct h5 *h5, struct error *error) {
    const struct output_shapes *shapes = h5md->shapes;
    for (int k = 0; shapes && k < shapes->count; k++) {
        const struct output_shape *shape = &shapes->shape[k];
        char group[OUTPUT_NAME_MAX];
        snprintf(group, sizeof group, "%s/%d", group_of_all, shape->number);
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

/* Reads a whole table of `width` values a row; memory_free. NULL: there is no such table. */
static void *read_array(const struct h5 *h5, const char *group, const char *name, enum field_type type,
                        int width, int *rows, struct error *error) {
    char dataset[FILE_PATH_MAX];
    struct h5_shape shape = {0};
    const hsize_t start[2] = {0};
    snprintf(dataset, sizeof dataset, "%s/%s", group, name);
    if (!h5_exists(h5, dataset) || !h5_get_shape(h5, dataset, &shape, error) ||
        shape.rank != 1 + (width > 1) || (width > 1 && shape.size[1] != (hsize_t)width) ||
        shape.size[0] > INT_MAX / 4) {
        error_set(error, ERROR_USER, "%s: %s: is no table of a shape", h5->path, dataset);
        return NULL;
    }
    *rows = (int)shape.size[0];
    void *values =
        memory_allocate((size_t)*rows * (size_t)width, type == FIELD_INT32 ? sizeof(int32_t) : sizeof(double),
                        "shapes of a file");
    if (h5_read_block(h5, dataset, type, start, shape.size, values, error))
        return values;
    memory_free(values);
    return NULL;
}

/* Reads the shape with a number. */
static bool read_shape(const struct h5 *h5, const char *number, struct output_shape *shape,
                       struct error *error) {
    char group[2 * OUTPUT_NAME_MAX], name[1][OUTPUT_NAME_MAX];
    int starts = 0, ends = 0;
    snprintf(group, sizeof group, "%s/%s", group_of_all, number);
    shape->number = atoi(number);
    bool good = h5_read_texts(h5, group, "name", name, 1) &&
                h5_read_doubles(h5, group, "radius", &shape->radius, 1) &&
                h5_read_doubles(h5, group, "rounding", &shape->rounding, 1);
    if (!good)
        return error_set(error, ERROR_USER, "%s: %s: has no name, radius and rounding", h5->path, group);
    snprintf(shape->name, sizeof shape->name, "%s", name[0]);
    shape->corner = read_array(h5, group, "corners", FIELD_DOUBLE, 3, &shape->corners, error);
    shape->start =
        shape->corner ? read_array(h5, group, "polygon_start", FIELD_INT32, 1, &starts, error) : NULL;
    shape->ring =
        shape->start ? read_array(h5, group, "polygon_corners", FIELD_INT32, 1, &ends, error) : NULL;
    shape->polygons = starts - 1;
    return shape->ring &&
           ((starts > 0 && shape->start[starts - 1] == ends) ||
            error_set(error, ERROR_USER, "%s: %s: its polygons do not end where their corners do", h5->path,
                      group));
}

bool output_shapes_read(const char *path, struct output_shapes *shapes, struct error *error) {
    struct h5 h5;
    struct h5_names names = {0};
    *shapes = (struct output_shapes){0};
    if (!h5_open(&h5, path, NULL, false, error))
        return false;
    bool good = !h5_exists(&h5, group_of_all) || h5_list(&h5, group_of_all, &names, error);
    for (size_t k = 0; good && k < names.count; k++)
        good = read_shape(&h5, names.name[k], output_shapes_add(shapes), error);
    memory_free(names.name);
    good = h5_close(&h5, error) && good;
    if (!good)
        output_shapes_free(shapes);
    return good;
}
