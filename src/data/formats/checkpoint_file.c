/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads datasets of a checkpoint without HDF5, by its table. Read checkpoint_parts.h first. */
#include "data/formats/checkpoint_parts.h"

#include "base/checksum.h"
#include "data/formats/checkpoint_names.h"
#include "base/memory.h"
#include "base/file.h"

#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { PIECE = 1 << 20 };

const struct checkpoint_entry *checkpoint_file_find(const struct checkpoint_file *file, const char *dataset) {
    for (int k = 0; k < file->table.entries; k++)
        if (strcmp(file->table.entry[k].name, dataset) == 0)
            return &file->table.entry[k];
    return NULL;
}

static bool refuse_sum(const struct checkpoint_file *file, const char *dataset, struct error *error) {
    return error_set(error, ERROR_USER, "%s: dataset %s is damaged: its bytes do not give its checksum",
                     file->path, dataset);
}

/* Checksum of rows [first, last) of a dataset; the bytes go to `data`, if `data` is not NULL. */
static bool sum_rows(const struct checkpoint_file *file, const struct checkpoint_entry *entry, uint64_t first,
                     uint64_t last, char *data, uint64_t *sum, struct error *error) {
    uint64_t rows_a_piece = entry->row_bytes < PIECE ? PIECE / entry->row_bytes : 1;
    char *buffer = data ? NULL : memory_allocate(rows_a_piece, entry->row_bytes, "piece of a file");
    bool good = true;
    *sum = 0;
    for (uint64_t row = first; good && row < last; row += rows_a_piece) {
        uint64_t rows = last - row < rows_a_piece ? last - row : rows_a_piece;
        char *to = data ? data + (row - first) * entry->row_bytes : buffer;
        good =
            file_read_at(file->handle, to, rows * entry->row_bytes, entry->offset + row * entry->row_bytes);
        if (good)
            *sum += checksum_rows(row, to, rows, entry->row_bytes);
        else
            error_set_errno(error, "%s: dataset %s cannot be read on rank %d", file->path, entry->name,
                            file->comm->rank);
    }
    memory_free(buffer);
    return good;
}

static bool is_large(const struct checkpoint_entry *entry) {
    return strncmp(entry->name, "/particles/", 11) == 0 || strcmp(entry->name, CHECKPOINT_FULL) == 0 ||
           strncmp(entry->name, "/history/", 9) == 0 || strncmp(entry->name, "/wall_history/", 14) == 0;
}

/* The checksums of all datasets not yet compared; each rank reads a part of each dataset. */
static bool sum_datasets(const struct checkpoint_file *file, const bool skip[CHECKPOINT_DATASETS_MAX],
                         int64_t sums[CHECKPOINT_DATASETS_MAX], struct error *error) {
    const struct checkpoint_table *table = &file->table;
    uint64_t size = (uint64_t)file->comm->size, rank = (uint64_t)file->comm->rank;
    bool good = true;
    for (int k = 0; good && k < table->entries; k++) {
        const struct checkpoint_entry *entry = &table->entry[k];
        uint64_t rows = entry->row_bytes > 0 ? entry->bytes / entry->row_bytes : 0, sum = 0;
        uint64_t first = rows / size * rank + (rank < rows % size ? rank : rows % size);
        uint64_t mine = rows / size + (rank < rows % size);
        if (mine > 0 && !skip[k])
            good = sum_rows(file, entry, first, first + mine, NULL, &sum, error);
        sums[k] = (int64_t)sum;
    }
    if (!comm_agree(file->comm, error))
        return false;
    comm_sum_int(file->comm, sums, table->entries);
    return true;
}

static bool compare(struct checkpoint_file *file, bool large, struct error *error) {
    const struct checkpoint_table *table = &file->table;
    int64_t sums[CHECKPOINT_DATASETS_MAX] = {0};
    bool skip[CHECKPOINT_DATASETS_MAX];
    for (int k = 0; k < table->entries; k++)
        skip[k] = file->compared[k] || (!large && is_large(&table->entry[k]));
    if (!sum_datasets(file, skip, sums, error))
        return false;
    for (int k = 0; k < table->entries; k++) {
        if (!skip[k] && (uint64_t)sums[k] != table->entry[k].checksum)
            return refuse_sum(file, table->entry[k].name, error);
        file->compared[k] = file->compared[k] || !skip[k];
    }
    return true;
}

static bool compare_rest(const struct checkpoint_file *file, struct error *error) {
    uint64_t rest = 0;
    if (file->comm->rank == 0) {
        if (!checkpoint_table_sum_rest(&file->table, file->handle, &rest))
            error_set_errno(error, "%s: cannot be read on rank 0", file->path);
        else if (rest != file->table.rest)
            error_set(error, ERROR_USER,
                      "%s: is damaged between its datasets: the bytes do not give their checksum",
                      file->path);
    }
    return comm_agree(file->comm, error);
}

bool checkpoint_file_compare(struct checkpoint_file *file, struct error *error) {
    return compare(file, true, error);
}

bool checkpoint_file_open(struct checkpoint_file *file, const struct comm *comm, const char *path,
                          struct error *error) {
    *file = (struct checkpoint_file){.comm = comm, .handle = -1};
    if (strlen(path) >= sizeof file->path)
        return error_set(error, ERROR_USER, "%.100s...: the path is longer than %d characters", path,
                         FILE_PATH_MAX - 1);
    snprintf(file->path, sizeof file->path, "%s", path);
    if (!checkpoint_table_read(&file->table, comm, path, error))
        return false;
    file->handle = open(path, O_RDONLY | O_CLOEXEC);
    if (file->handle < 0)
        error_set_errno(error, "%s: cannot be opened on rank %d", path, comm->rank);
    if (comm_agree(comm, error) && compare(file, false, error) && compare_rest(file, error))
        return true;
    checkpoint_file_close(file);
    return false;
}

void checkpoint_file_close(struct checkpoint_file *file) {
    if (file->handle >= 0)
        close(file->handle);
    file->handle = -1;
}

/* The entry of a dataset that must exist, with rows of this form; the same result on every rank. */
static const struct checkpoint_entry *entry_of(const struct checkpoint_file *file, const char *dataset,
                                               size_t row_bytes, uint64_t rows, struct error *error) {
    const struct checkpoint_entry *entry = checkpoint_file_find(file, dataset);
    if (entry == NULL)
        error_set(error, ERROR_USER, "%s: holds no %s", file->path, dataset);
    else if (entry->bytes != rows * row_bytes || (rows > 0 && entry->row_bytes != row_bytes))
        error_set(error, ERROR_USER, "%s: %s: has other dimensions than a checkpoint of this version",
                  file->path, dataset);
    else
        return entry;
    return NULL;
}

bool checkpoint_file_read(struct checkpoint_file *file, const struct checkpoint_rows *rows, void *data,
                          struct error *error) {
    const struct checkpoint_entry *entry = entry_of(file, rows->dataset, rows->row_bytes, rows->rows, error);
    uint64_t sum = 0;
    if (!comm_agree(file->comm, error))
        return false;
    if (rows->count > 0)
        sum_rows(file, entry, rows->first, rows->first + rows->count, data, &sum, error);
    if (!comm_agree(file->comm, error))
        return false;
    int64_t total = (int64_t)sum;
    comm_sum_int(file->comm, &total, 1);
    if ((uint64_t)total != entry->checksum)
        return refuse_sum(file, entry->name, error);
    file->compared[entry - file->table.entry] = true;
    return true;
}
