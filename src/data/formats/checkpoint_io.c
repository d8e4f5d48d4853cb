/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes tables and enters them, with checksums from memory, into the table of the file; reads them by that table.
 * Read checkpoint_parts.h first. */
#include "data/formats/checkpoint_parts.h"

#include "base/checksum.h"
#include "base/memory.h"
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

/* Enters a dataset, just written, into the table. */
static bool enter(struct checkpoint_io *io, const struct checkpoint_rows *rows, const void *data,
                  struct error *error) {
    struct checkpoint_table *table = &io->file.table;
    if (!fits(table, rows->dataset))
        return error_set(error, ERROR_SYSTEM,
                         "%s: %s: the table of a checkpoint has no room for more datasets", io->h5.path,
                         rows->dataset);
    struct checkpoint_entry *entry = &table->entry[table->entries++];
    *entry = (struct checkpoint_entry){.row_bytes = rows->row_bytes};
    snprintf(entry->name, sizeof entry->name, "%s", rows->dataset);
    int64_t sum = (int64_t)checksum_rows(rows->first, data, rows->count, rows->row_bytes);
    comm_sum_int(io->comm, &sum, 1);
    entry->checksum = (uint64_t)sum;
    if (rows->rows == 0)
        return true;
    if (!h5_get_place(&io->h5, rows->dataset, &entry->offset, &entry->bytes) ||
        entry->bytes != rows->rows * rows->row_bytes)
        error_set(error, ERROR_SYSTEM, "%s: %s: HDF5 does not tell where it lies in the file", io->h5.path,
                  rows->dataset);
    return comm_agree(io->comm, error);
}

bool checkpoint_io_rows(struct checkpoint_io *io, const char *name, const struct h5_table *table, void *data,
                        struct error *error) {
    struct checkpoint_rows rows = {.dataset = name,
                                   .row_bytes =
                                       checkpoint_type_bytes(table->type) * (table->width ? table->width : 1),
                                   .rows = table->rows,
                                   .first = table->first,
                                   .count = table->count};
    if (io->written)
        return h5_write_table(&io->h5, name, table, data, error) && enter(io, &rows, data, error);
    return checkpoint_file_read(&io->file, &rows, data, error);
}

bool checkpoint_io_common(struct checkpoint_io *io, const char *name, enum field_type type, uint64_t rows,
                          uint64_t width, void *data, struct error *error) {
    uint64_t mine = io->comm->rank == 0 ? rows : 0;
    struct h5_table table = {.type = type, .rows = rows, .width = width, .first = rows - mine, .count = mine};
    if (!checkpoint_io_rows(io, name, &table, data, error))
        return false;
    if (io->written == NULL)
        comm_broadcast(io->comm, data, rows * (width ? width : 1) * checkpoint_type_bytes(type));
    return true;
}

bool checkpoint_io_of_ranks(struct checkpoint_io *io, const char *name, enum field_type type, int ranks,
                            uint64_t width, void *data, struct error *error) {
    struct h5_table mine = {
        .type = type, .rows = (uint64_t)ranks, .width = width, .first = (uint64_t)io->comm->rank, .count = 1};
    return io->written ? checkpoint_io_rows(io, name, &mine, data, error)
                       : checkpoint_io_common(io, name, type, (uint64_t)ranks, width, data, error);
}

bool checkpoint_io_text(struct checkpoint_io *io, const char *name, char **text, struct error *error) {
    struct checkpoint_rows row = {
        .dataset = name, .rows = 1, .count = io->comm->rank == 0, .first = io->comm->rank > 0};
    if (io->written) {
        row.row_bytes = strlen(*text) + 1;
        return h5_write_string(&io->h5, name, *text, error) && enter(io, &row, *text, error);
    }
    row.row_bytes = checkpoint_io_count(io, name, 1, 0);
    *text = memory_allocate_zero(row.row_bytes + 1, 1, "text of a file");
    if (!checkpoint_file_read(&io->file, &row, *text, error))
        return false;
    comm_broadcast(io->comm, *text, row.row_bytes);
    return true;
}

bool checkpoint_io_has(const struct checkpoint_io *io, const char *name) {
    return checkpoint_file_find(&io->file, name) != NULL;
}

uint64_t checkpoint_io_count(const struct checkpoint_io *io, const char *name, size_t row_bytes,
                             uint64_t written) {
    const struct checkpoint_entry *entry = checkpoint_file_find(&io->file, name);
    return io->written ? written : entry ? entry->bytes / row_bytes : 0;
}
