/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes tables and enters them, with checksums from memory, into the table of the file. Read
 * checkpoint_put.h first. */
#include "data/formats/checkpoint_put.h"

#include "base/checksum.h"
#include "data/formats/checkpoint_names.h"

#include <stdio.h>
#include <string.h>

/* Most letters of a line of the table beside the name (checkpoint_table.c), and of its lines without a dataset. */
enum { LINE_MOST = 92, HEAD_MOST = 256 };

/* True if the table has room for one more dataset. */
static bool fits(const struct checkpoint_table *table, const char *name) {
    size_t used = HEAD_MOST + LINE_MOST + strlen(name);
    for (int k = 0; k < table->entries; k++)
        used += LINE_MOST + strlen(table->entry[k].name);
    return table->entries < CHECKPOINT_DATASETS_MAX && used <= CHECKPOINT_BLOCK;
}

bool checkpoint_enter(struct checkpoint_writing *w, const char *name, const struct h5_table *rows,
                      size_t row_bytes, const void *data, struct error *error) {
    if (!fits(&w->table, name))
        return error_set(error, ERROR_SYSTEM,
                         "%s: %s: the table of a checkpoint has no room for more datasets", w->h5.path, name);
    struct checkpoint_entry *entry = &w->table.entry[w->table.entries++];
    *entry = (struct checkpoint_entry){.row_bytes = row_bytes};
    snprintf(entry->name, sizeof entry->name, "%s", name);
    int64_t sum = (int64_t)checksum_rows(rows->first, data, rows->count, row_bytes);
    comm_sum_int(w->comm, &sum, 1);
    entry->checksum = (uint64_t)sum;
    if (rows->rows == 0)
        return true;
    if (!h5_get_place(&w->h5, name, &entry->offset, &entry->bytes) || entry->bytes != rows->rows * row_bytes)
        error_set(error, ERROR_SYSTEM, "%s: %s: HDF5 does not tell where it lies in the file", w->h5.path,
                  name);
    return comm_agree(w->comm, error);
}

bool checkpoint_put(struct checkpoint_writing *w, const char *name, const struct h5_table *rows,
                    const void *data, struct error *error) {
    size_t row_bytes = checkpoint_type_bytes(rows->type) * (rows->width ? rows->width : 1);
    return h5_write_table(&w->h5, name, rows, data, error) &&
           checkpoint_enter(w, name, rows, row_bytes, data, error);
}

bool checkpoint_put_common(struct checkpoint_writing *w, const char *name, enum field_type type,
                           uint64_t rows, uint64_t width, const void *data, struct error *error) {
    struct h5_table table = {.type = type, .rows = rows, .width = width};
    table.count = w->comm->rank == 0 ? rows : 0;
    table.first = w->comm->rank == 0 ? 0 : rows;
    return checkpoint_put(w, name, &table, data, error);
}

bool checkpoint_put_of_ranks(struct checkpoint_writing *w, const char *name, enum field_type type,
                             uint64_t width, const void *data, struct error *error) {
    struct h5_table table = {.type = type,
                             .rows = (uint64_t)w->comm->size,
                             .width = width,
                             .first = (uint64_t)w->comm->rank,
                             .count = 1};
    return checkpoint_put(w, name, &table, data, error);
}
