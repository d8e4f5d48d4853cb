/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes the particles of one moment. The first frame makes the elements; later frames must have the same
 * columns. */
#include "data/formats/h5md_parts.h"
#include "data/formats/h5md_file.h"
#include "data/formats/h5md_head.h"
#include "data/formats/h5md_observables.h"

#include "base/memory.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { CHUNK_ROWS_MAX = 65536, CHUNK_ROWS_VARYING = 4096 };

static const char frames_group[] = "/parameters/frames", frames_rows[] = "/parameters/frames/rows";

/* The number of components in the file: two in a 2D scene. */
static int components_of(const struct frame_column *column, const struct box *box) {
    return column->spatial ? box->dimension : column->components;
}

static bool is_fixed(const struct h5md *h5md, const struct frame_column *column) {
    return column->fixed && !h5md->varying;
}

static struct h5_table table_of(const struct h5md_element *element, const struct frame *frame) {
    return (struct h5_table){.type = element->type,
                             .single = element->single,
                             .rows = frame->total,
                             .width = element->shown.components > 1 ? (uint64_t)element->shown.components : 0,
                             .first = frame->first,
                             .count = frame->rows};
}

/* The data of a column with as many components as the file has; a copy (memory_free) if the file has fewer
 * components. */
static void *narrow(const struct frame_column *column, int components, size_t rows) {
    if (components == column->components)
        return NULL;
    size_t from = frame_column_bytes(column), to = from / (size_t)column->components * (size_t)components;
    char *data = memory_allocate(rows, to, "columns of a flat scene");
    for (size_t k = 0; k < rows; k++)
        memcpy(data + k * to, (const char *)column->data + k * from, to);
    return data;
}

/* The data of a column as floats (memory_free); NULL where the element holds the column as it is. HDF5 would
 * convert, too, but then could not write compressed data of several ranks. */
static float *as_floats(const struct h5md_element *element, const void *data, size_t rows) {
    size_t count = rows * (size_t)element->shown.components;
    if (!element->single)
        return NULL;
    float *value = memory_allocate(count, sizeof *value, "columns of floats");
    for (size_t k = 0; k < count; k++)
        value[k] = (float)((const double *)data)[k];
    return value;
}

static uint64_t chunk_rows(const struct h5md *h5md, uint64_t rows) {
    uint64_t least = h5md->varying ? CHUNK_ROWS_VARYING : 1;
    return rows < least ? least : rows > CHUNK_ROWS_MAX ? CHUNK_ROWS_MAX : rows;
}

/* Makes the element of a column, and writes the values of a fixed element. */
static bool make_element(struct h5md *h5md, const struct h5 *h5, const struct frame *frame,
                         const struct frame_column *column, struct error *error) {
    static const int64_t absent = -1;
    static const double nothing[1] = {0};
    bool frames = !is_fixed(h5md, column), is_id = strcmp(column->name, "id") == 0;
    const struct h5md_element *element =
        h5md_add_element(h5md, column->name, column->type, components_of(column, &frame->box), frames);
    struct h5_table table = table_of(element, frame);
    table.deflate = h5md->deflate;
    if (frames) {
        char group[2 * OUTPUT_NAME_MAX];
        snprintf(group, sizeof group, "/particles/all/%s", element->name);
        const void *fill = !h5md->varying ? NULL : is_id ? (const void *)&absent : (const void *)nothing;
        if (!h5md_make_element(h5md, h5, group, frames_group, error) ||
            !h5_make_frames(h5, element->dataset, &table, h5md->chunk, fill, error))
            return false;
    } else if (!h5_write_table(h5, element->dataset, &table, column->data, error)) {
        return false;
    }
    return h5md_write_unit(h5md, h5, element->dataset, column->unit, error);
}

/* Links `species`, which is H5MD's name for `material`. */
static bool link_species(const struct h5md *h5md, const struct h5 *h5, struct error *error) {
    for (int k = 0; k < h5md->elements; k++)
        if (strcmp(h5md->element[k].name, "material") == 0)
            return h5_link(h5, "/particles/all/material", "/particles/all/species", error);
    return true;
}

static bool make_elements(struct h5md *h5md, const struct h5 *h5, const struct frame *frame,
                          struct error *error) {
    h5md->chunk = chunk_rows(h5md, frame->total);
    bool good = h5md_make_element(h5md, h5, frames_group, NULL, error) &&
                h5_make_series(h5, frames_rows, FIELD_INT64, error) &&
                h5md_make_edges(h5md, h5, &frame->box, frames_group, error);
    for (int c = 0; good && c < frame->columns; c++)
        good = make_element(h5md, h5, frame, &frame->column[c], error);
    h5md->rows = frame->total;
    return good && link_species(h5md, h5, error);
}

/* The column of an element, if name, type and components agree. */
static const struct frame_column *column_of(const struct frame *frame, const struct h5md_element *element) {
    const struct frame_column *column = frame_find(frame, element->name);
    bool same = column && column->type == element->type &&
                components_of(column, &frame->box) == element->shown.components;
    return same ? column : NULL;
}

static bool check_columns(const struct h5md *h5md, const struct frame *frame, struct error *error) {
    if (!h5md->varying && frame->total != h5md->rows)
        return error_set(error, ERROR_USER,
                         "%s: holds frames of %" PRIu64 " particles, now there are %" PRIu64
                         ", and the file was not made for a number that changes",
                         h5md->path, h5md->rows, frame->total);
    bool same = h5md->elements == frame->columns;
    for (int k = 0; same && k < h5md->elements; k++)
        same = column_of(frame, &h5md->element[k]) != NULL;
    return same || error_set(error, ERROR_USER,
                             "%s: holds other fields than this run writes; choose another output directory",
                             h5md->path);
}

static bool write_elements(struct h5md *h5md, const struct h5 *h5, const struct frame *frame,
                           struct error *error) {
    for (int k = 0; k < h5md->elements; k++) {
        const struct h5md_element *element = &h5md->element[k];
        if (!element->shown.frames)
            continue;
        const struct frame_column *column = column_of(frame, element);
        struct h5_table table = table_of(element, frame);
        void *narrowed = narrow(column, element->shown.components, frame->rows);
        const void *data = narrowed ? narrowed : column->data;
        float *floats = as_floats(element, data, frame->rows);
        bool good = h5_write_frame(h5, element->dataset, &table, h5md->frames, floats ? floats : data, error);
        memory_free(narrowed);
        memory_free(floats);
        if (!good)
            return false;
    }
    int64_t step = (int64_t)frame->step, rows = (int64_t)frame->total;
    return h5md_write_edges(h5md, h5, &frame->box, error) &&
           h5_write_series(h5, "/parameters/frames/step", FIELD_INT64, h5md->frames, 1, &step, error) &&
           h5_write_series(h5, "/parameters/frames/time", FIELD_DOUBLE, h5md->frames, 1, &frame->time,
                           error) &&
           h5_write_series(h5, frames_rows, FIELD_INT64, h5md->frames, 1, &rows, error);
}

/* Reserves the room for a frame, or refuses before the file is changed. */
static bool reserve_room(const struct h5md *h5md, const struct frame *frame, struct error *error) {
    bool first = h5md->elements == 0;
    uint64_t bytes = H5MD_ROOM_FRAME;
    struct h5md_stored stored = {.frames = h5md->frames,
                                 .rows = h5md->rows,
                                 .chunk = first ? chunk_rows(h5md, frame->total) : h5md->chunk};
    for (int c = 0; c < frame->columns; c++) {
        const struct frame_column *column = &frame->column[c];
        size_t value_bytes = frame_column_bytes(column) / (size_t)column->components;
        stored.row_bytes = value_bytes * (size_t)components_of(column, &frame->box);
        if (!is_fixed(h5md, column))
            bytes += h5md_room(&stored, frame->total);
        else if (first)
            bytes += H5MD_ROOM_DATASET + frame->total * stored.row_bytes;
    }
    return h5md_reserve(h5md, bytes, error);
}

bool h5md_write_frame(struct h5md *h5md, const struct frame *frame, struct error *error) {
    if (h5md->frames > 0 && frame->step <= h5md->frame[h5md->frames - 1].step)
        return true;
    if ((!h5md->made && !h5md_make_file(h5md, &frame->box, error)) || !reserve_room(h5md, frame, error))
        return false;
    if (h5md->elements > 0 && !check_columns(h5md, frame, error))
        return false;
    struct h5 h5;
    if (!h5_open(&h5, h5md->path, h5md->comm, true, error))
        return false;
    bool good = h5md->elements > 0 || make_elements(h5md, &h5, frame, error);
    good = good && write_elements(h5md, &h5, frame, error) && h5md_write_observables(h5md, &h5, error);
    if (!h5_close(&h5, error) || !good)
        return false;
    h5md->rows = frame->total > h5md->rows ? frame->total : h5md->rows;
    struct xdmf_frame shown = {.step = frame->step, .rows = frame->total, .time = frame->time};
    h5md_remember(h5md, &shown);
    return h5md_update_xdmf(h5md, false, error);
}
