/* SPDX-License-Identifier: BSD-3-Clause */
/* Datasets: tables, tables a frame, series. The dimensions of a dataset are [frames][rows][width]; a
 * dimension that the dataset does not need is left out. */
#include "data/formats/h5.h"

#include "base/memory.h"

#include <string.h>

enum { SERIES_CHUNK = 256 };

hid_t h5_type(enum field_type type) {
    switch (type) {
    case FIELD_DOUBLE:
        return H5T_NATIVE_DOUBLE;
    case FIELD_INT64:
        return H5T_NATIVE_INT64;
    case FIELD_INT32:
        return H5T_NATIVE_INT32;
    default:
        return H5T_NATIVE_UINT8;
    }
}

/* The type of a table, in the file and in memory. */
static hid_t table_type(const struct h5_table *table) {
    return table->single && table->type == FIELD_DOUBLE ? H5T_NATIVE_FLOAT : h5_type(table->type);
}

/* Writes a block (start, count; with 0 rows nothing is written, but all ranks call) of an open dataset. */
static bool write_block(const struct h5 *h5, const char *name, hid_t dataset, hid_t type,
                        const hsize_t *start, const hsize_t *count, const void *data, struct error *error) {
    hid_t file_space = H5Dget_space(dataset);
    int rank = H5Sget_simple_extent_ndims(file_space);
    hid_t memory_space = H5Screate_simple(rank, count, NULL);
    bool empty = false, good = file_space >= 0 && memory_space >= 0;
    for (int d = 0; d < rank; d++)
        empty = empty || count[d] == 0;
    if (good && empty)
        good = H5Sselect_none(file_space) >= 0 && H5Sselect_none(memory_space) >= 0;
    else if (good)
        good = H5Sselect_hyperslab(file_space, H5S_SELECT_SET, start, NULL, count, NULL) >= 0;
    good = good && H5Dwrite(dataset, type, memory_space, file_space, h5->transfer, data) >= 0;
    if (!good)
        h5_fail(h5, ERROR_SYSTEM, name, "the data cannot be written", error);
    H5Sclose(memory_space);
    H5Sclose(file_space);
    return good;
}

/* Makes a dataset with a creation list, which is closed here; all ranks call alike. */
static hid_t make_dataset(const struct h5 *h5, const char *dataset, hid_t type, hid_t space, hid_t creation,
                          struct error *error) {
    hid_t links = H5Pcreate(H5P_LINK_CREATE);
    hid_t id = -1;
    if (space >= 0 && creation >= 0 && H5Pset_create_intermediate_group(links, 1) >= 0)
        id = H5Dcreate2(h5->file, dataset, type, space, links, creation, H5P_DEFAULT);
    if (id < 0)
        h5_fail(h5, ERROR_SYSTEM, dataset, "the dataset cannot be made", error);
    H5Pclose(creation);
    H5Pclose(links);
    H5Sclose(space);
    return id;
}

bool h5_write_string(const struct h5 *h5, const char *dataset, const char *text, struct error *error) {
    hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, strlen(text) + 1);
    hid_t id = make_dataset(h5, dataset, type, H5Screate(H5S_SCALAR), H5Pcreate(H5P_DATASET_CREATE), error);
    if (id >= 0) {
        if (H5Dwrite(id, type, H5S_ALL, H5S_ALL, h5->transfer, text) < 0)
            h5_fail(h5, ERROR_SYSTEM, dataset, "the text cannot be written", error);
        H5Dclose(id);
    }
    H5Tclose(type);
    return h5_agree(h5, error);
}

char *h5_read_string(const struct h5 *h5, const char *dataset, struct error *error) {
    struct h5_shape shape;
    if (!h5_get_shape(h5, dataset, &shape, error))
        return NULL;
    hid_t id = H5Dopen2(h5->file, dataset, H5P_DEFAULT);
    hid_t type = H5Dget_type(id);
    char *text = NULL;
    if (shape.type != H5T_STRING || shape.rank != 0 || H5Tis_variable_str(type) > 0) {
        error_set(error, ERROR_USER, "%s: %s: is not one string of fixed length", h5->path, dataset);
    } else {
        text = memory_allocate_zero(shape.bytes + 1, 1, "text of a file");
        if (H5Dread(id, type, H5S_ALL, H5S_ALL, h5->transfer, text) < 0)
            h5_fail(h5, ERROR_USER, dataset, "the text cannot be read", error);
    }
    H5Tclose(type);
    H5Dclose(id);
    if (h5_agree(h5, error))
        return text;
    memory_free(text);
    return NULL;
}

bool h5_write_table(const struct h5 *h5, const char *dataset, const struct h5_table *table, const void *data,
                    struct error *error) {
    hsize_t size[2] = {table->rows, table->width};
    hsize_t start[2] = {table->first, 0}, count[2] = {table->count, table->width};
    hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER);
    hid_t id = make_dataset(h5, dataset, h5_type(table->type),
                            H5Screate_simple(table->width ? 2 : 1, size, NULL), creation, error);
    if (!h5_agree(h5, error)) {
        if (id >= 0)
            H5Dclose(id);
        return false;
    }
    if (table->rows > 0)
        write_block(h5, dataset, id, table_type(table), start, count, data, error);
    H5Dclose(id);
    return h5_agree(h5, error);
}

bool h5_make_frames(const struct h5 *h5, const char *dataset, const struct h5_table *table,
                    uint64_t chunk_rows, const void *fill, struct error *error) {
    int rank = table->width ? 3 : 2;
    hsize_t size[3] = {0, table->rows, table->width};
    hsize_t most[3] = {H5S_UNLIMITED, H5S_UNLIMITED, table->width};
    hsize_t chunk[3] = {1, chunk_rows ? chunk_rows : 1, table->width};
    hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    bool good = H5Pset_chunk(creation, rank, chunk) >= 0;
    if (good && table->deflate > 0)
        good = H5Pset_shuffle(creation) >= 0 && H5Pset_deflate(creation, (unsigned)table->deflate) >= 0;
    if (fill)
        good = good && H5Pset_fill_value(creation, h5_type(table->type), fill) >= 0 &&
               H5Pset_fill_time(creation, H5D_FILL_TIME_ALLOC) >= 0;
    else
        good = good && H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER) >= 0;
    hid_t id = -1;
    if (good)
        id =
            make_dataset(h5, dataset, table_type(table), H5Screate_simple(rank, size, most), creation, error);
    else
        h5_fail(h5, ERROR_SYSTEM, dataset, "the dataset cannot be prepared", error);
    if (id >= 0)
        H5Dclose(id);
    return h5_agree(h5, error);
}

/* Grows an open dataset so that it holds `wanted` in every direction. */
static bool grow(hid_t dataset, const hsize_t *wanted, int rank) {
    hsize_t size[3];
    hid_t space = H5Dget_space(dataset);
    bool good = space >= 0 && H5Sget_simple_extent_ndims(space) == rank &&
                H5Sget_simple_extent_dims(space, size, NULL) >= 0;
    H5Sclose(space);
    bool larger = false;
    for (int d = 0; good && d < rank; d++) {
        larger = larger || wanted[d] > size[d];
        size[d] = wanted[d] > size[d] ? wanted[d] : size[d];
    }
    return good && (!larger || H5Dset_extent(dataset, size) >= 0);
}

bool h5_write_frame(const struct h5 *h5, const char *dataset, const struct h5_table *table, uint64_t frame,
                    const void *data, struct error *error) {
    int rank = table->width ? 3 : 2;
    hsize_t wanted[3] = {frame + 1, table->rows, table->width};
    hsize_t start[3] = {frame, table->first, 0}, count[3] = {1, table->count, table->width};
    hid_t id = H5Dopen2(h5->file, dataset, H5P_DEFAULT);
    if (id < 0)
        h5_fail(h5, ERROR_SYSTEM, dataset, "the dataset cannot be opened", error);
    else if (!grow(id, wanted, rank))
        h5_fail(h5, ERROR_SYSTEM, dataset, "the dataset cannot be enlarged", error);
    bool ready = h5_agree(h5, error);
    if (ready && table->rows > 0)
        write_block(h5, dataset, id, table_type(table), start, count, data, error);
    if (id >= 0)
        H5Dclose(id);
    return h5_agree(h5, error);
}

bool h5_make_series(const struct h5 *h5, const char *dataset, enum field_type type, struct error *error) {
    hsize_t none = 0, unlimited = H5S_UNLIMITED, chunk = SERIES_CHUNK;
    hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(creation, 1, &chunk);
    H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER);
    hid_t id =
        make_dataset(h5, dataset, h5_type(type), H5Screate_simple(1, &none, &unlimited), creation, error);
    if (id >= 0)
        H5Dclose(id);
    return h5_agree(h5, error);
}

bool h5_write_series(const struct h5 *h5, const char *dataset, enum field_type type, uint64_t first,
                     uint64_t count, const void *values, struct error *error) {
    hsize_t wanted = first + count, start = first, mine = h5->comm && h5->comm->rank > 0 ? 0 : count;
    hid_t id = H5Dopen2(h5->file, dataset, H5P_DEFAULT);
    if (id < 0)
        h5_fail(h5, ERROR_SYSTEM, dataset, "the dataset cannot be opened", error);
    else if (!grow(id, &wanted, 1))
        h5_fail(h5, ERROR_SYSTEM, dataset, "the dataset cannot be enlarged", error);
    if (h5_agree(h5, error))
        write_block(h5, dataset, id, h5_type(type), &start, &mine, values, error);
    if (id >= 0)
        H5Dclose(id);
    return h5_agree(h5, error);
}

bool h5_cut_frames(const struct h5 *h5, const char *dataset, uint64_t frames, struct error *error) {
    struct h5_shape shape;
    if (!h5_get_shape(h5, dataset, &shape, error))
        return false;
    hid_t id = H5Dopen2(h5->file, dataset, H5P_DEFAULT);
    bool good = id >= 0 && shape.rank >= 1;
    if (good && shape.size[0] > frames) {
        shape.size[0] = frames;
        good = H5Dset_extent(id, shape.size) >= 0;
    }
    if (!good)
        h5_fail(h5, ERROR_SYSTEM, dataset, "the dataset cannot be cut", error);
    if (id >= 0)
        H5Dclose(id);
    return good;
}

bool h5_get_shape(const struct h5 *h5, const char *dataset, struct h5_shape *shape, struct error *error) {
    *shape = (struct h5_shape){0};
    if (!h5_exists(h5, dataset))
        return error_set(error, ERROR_USER, "%s: %s: there is no such object", h5->path, dataset);
    hid_t id = H5Dopen2(h5->file, dataset, H5P_DEFAULT);
    if (id < 0)
        return h5_fail(h5, ERROR_USER, dataset, "is not a dataset that can be read", error);
    hid_t space = H5Dget_space(id), type = H5Dget_type(id);
    bool good = space >= 0 && type >= 0;
    if (good) {
        shape->rank = H5Sget_simple_extent_ndims(space);
        shape->type = H5Tget_class(type);
        shape->bytes = H5Tget_size(type);
        good =
            shape->rank >= 0 && shape->rank <= 4 && H5Sget_simple_extent_dims(space, shape->size, NULL) >= 0;
    }
    hid_t creation = H5Dget_create_plist(id);
    if (good && creation >= 0 && H5Pget_layout(creation) == H5D_CHUNKED)
        good = H5Pget_chunk(creation, 4, shape->chunk) >= 0;
    H5Pclose(creation);
    H5Tclose(type);
    H5Sclose(space);
    H5Dclose(id);
    return good || h5_fail(h5, ERROR_USER, dataset, "its dimensions cannot be read", error);
}

bool h5_read_block(const struct h5 *h5, const char *dataset, enum field_type type, const hsize_t *start,
                   const hsize_t *count, void *data, struct error *error) {
    hid_t id = H5Dopen2(h5->file, dataset, H5P_DEFAULT);
    if (id < 0)
        return h5_fail(h5, ERROR_USER, dataset, "the dataset cannot be opened", error);
    hid_t file_space = H5Dget_space(id);
    int rank = H5Sget_simple_extent_ndims(file_space);
    hid_t memory_space = rank > 0 ? H5Screate_simple(rank, count, NULL) : H5Screate(H5S_SCALAR);
    bool empty = false, good = true;
    for (int d = 0; d < rank; d++)
        empty = empty || count[d] == 0;
    if (empty)
        good = H5Sselect_none(file_space) >= 0 && H5Sselect_none(memory_space) >= 0;
    else if (rank > 0)
        good = H5Sselect_hyperslab(file_space, H5S_SELECT_SET, start, NULL, count, NULL) >= 0;
    good = good && H5Dread(id, h5_type(type), memory_space, file_space, h5->transfer, data) >= 0;
    if (!good)
        h5_fail(h5, ERROR_USER, dataset, "the data cannot be read", error);
    H5Sclose(memory_space);
    H5Sclose(file_space);
    H5Dclose(id);
    return h5_agree(h5, error);
}

bool h5_read_fill(const struct h5 *h5, const char *dataset, int64_t *fill) {
    hid_t id = H5Dopen2(h5->file, dataset, H5P_DEFAULT);
    hid_t creation = id >= 0 ? H5Dget_create_plist(id) : -1;
    H5D_fill_value_t status = H5D_FILL_VALUE_UNDEFINED;
    bool good = creation >= 0 && H5Pfill_value_defined(creation, &status) >= 0 &&
                status == H5D_FILL_VALUE_USER_DEFINED &&
                H5Pget_fill_value(creation, H5T_NATIVE_INT64, fill) >= 0;
    if (creation >= 0)
        H5Pclose(creation);
    if (id >= 0)
        H5Dclose(id);
    return good;
}

bool h5_get_place(const struct h5 *h5, const char *dataset, uint64_t *offset, uint64_t *bytes) {
    hid_t id = H5Dopen2(h5->file, dataset, H5P_DEFAULT);
    if (id < 0)
        return false;
    haddr_t address = H5Dget_offset(id);
    *offset = address;
    *bytes = H5Dget_storage_size(id);
    H5Dclose(id);
    H5Eclear2(H5E_DEFAULT);
    return address != HADDR_UNDEF && *bytes > 0;
}
