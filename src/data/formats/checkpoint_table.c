/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of a checkpoint: the place of each dataset, and its checksum. Read checkpoint_table.h first. */
#include "data/formats/checkpoint_table.h"

#include "base/checksum.h"
#include "base/file.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { REST_ROW = 4096 };

static const char magic[] = "scree checkpoint ";

static int compare_offsets(const void *a, const void *b) {
    const struct checkpoint_entry *x = a, *y = b;
    return (x->offset > y->offset) - (x->offset < y->offset);
}

/* Sums each gap between datasets in rows of REST_ROW bytes, keyed by the place of the row. */
bool checkpoint_table_sum_rest(const struct checkpoint_table *table, int handle, uint64_t *sum) {
    struct checkpoint_entry sorted[CHECKPOINT_DATASETS_MAX + 1];
    memcpy(sorted, table->entry, sizeof table->entry);
    qsort(sorted, (size_t)table->entries, sizeof sorted[0], compare_offsets);
    sorted[table->entries] = (struct checkpoint_entry){.offset = table->bytes};
    uint64_t place = CHECKPOINT_BLOCK;
    char buffer[REST_ROW];
    *sum = 0;
    for (int k = 0; k <= table->entries; k++) {
        if (k < table->entries && sorted[k].bytes == 0)
            continue;
        while (place < sorted[k].offset) {
            uint64_t left = sorted[k].offset - place, bytes = left < REST_ROW ? left : REST_ROW;
            if (!file_read_at(handle, buffer, bytes, place))
                return false;
            *sum += checksum_row(place, buffer, bytes);
            place += bytes;
        }
        place = sorted[k].offset + sorted[k].bytes;
    }
    return true;
}

static void format_table(const struct checkpoint_table *table, char block[CHECKPOINT_BLOCK]) {
    memset(block, 0, CHECKPOINT_BLOCK);
    size_t used = (size_t)snprintf(block, CHECKPOINT_BLOCK, "%s%d\nbytes %" PRIu64 "\n", magic,
                                   CHECKPOINT_VERSION, table->bytes);
    for (int k = 0; k < table->entries; k++) {
        const struct checkpoint_entry *e = &table->entry[k];
        used += (size_t)snprintf(block + used, CHECKPOINT_BLOCK - used,
                                 "dataset %s %" PRIu64 " %" PRIu64 " %" PRIu64 " %016" PRIx64 "\n", e->name,
                                 e->offset, e->bytes, e->row_bytes, e->checksum);
    }
    used += (size_t)snprintf(block + used, CHECKPOINT_BLOCK - used, "rest %016" PRIx64 "\n", table->rest);
    uint64_t own = checksum_row(0, block, used);
    snprintf(block + used, CHECKPOINT_BLOCK - used, "table %016" PRIx64 "\n", own);
}

/* The value of a line "WORD VALUE" in the given base; moves `line` on. */
static bool parse_line(const char **line, const char *word, int base, uint64_t *value) {
    size_t length = strlen(word);
    if (strncmp(*line, word, length) != 0 || (*line)[length] != ' ')
        return false;
    char *end;
    *value = strtoull(*line + length + 1, &end, base);
    if (*end != '\n')
        return false;
    *line = end + 1;
    return true;
}

static bool parse_entry(const char **line, struct checkpoint_entry *entry) {
    int length = 0;
    static_assert(OUTPUT_NAME_MAX == 64, "the length below");
    if (sscanf(*line, "dataset %63s %" SCNu64 " %" SCNu64 " %" SCNu64 " %" SCNx64 "%n", entry->name,
               &entry->offset, &entry->bytes, &entry->row_bytes, &entry->checksum, &length) != 5 ||
        (*line)[length] != '\n')
        return false;
    *line += length + 1;
    return true;
}

/* Parses a block. A table is correct if writing the table again gives the same bytes: this check covers the
 * checksum, the form of the numbers, and the zeros behind. */
static bool parse_table(struct checkpoint_table *table, const char block[CHECKPOINT_BLOCK]) {
    *table = (struct checkpoint_table){0};
    char text[CHECKPOINT_BLOCK + 1], again[CHECKPOINT_BLOCK];
    memcpy(text, block, CHECKPOINT_BLOCK);
    text[CHECKPOINT_BLOCK] = '\0';
    const char *line = strchr(text, '\n');
    if (!line++ || !parse_line(&line, "bytes", 10, &table->bytes))
        return false;
    while (strncmp(line, "dataset ", 8) == 0) {
        if (table->entries == CHECKPOINT_DATASETS_MAX || !parse_entry(&line, &table->entry[table->entries]))
            return false;
        table->entries++;
    }
    if (!parse_line(&line, "rest", 16, &table->rest))
        return false;
    format_table(table, again);
    return memcmp(block, again, CHECKPOINT_BLOCK) == 0;
}

/* Reports a wrong size of a file, in terms of datasets. */
static bool refuse_size(const struct checkpoint_table *table, const char *path, uint64_t size,
                        struct error *error) {
    if (size > table->bytes)
        return error_set(error, ERROR_USER,
                         "%s: has %" PRIu64 " bytes more than the %" PRIu64 " it was made of", path,
                         size - table->bytes, table->bytes);
    for (int k = 0; k < table->entries; k++)
        if (table->entry[k].bytes > 0 && table->entry[k].offset + table->entry[k].bytes > size)
            return error_set(error, ERROR_USER,
                             "%s: is cut off: %" PRIu64 " of %" PRIu64 " bytes; dataset %s is not whole",
                             path, size, table->bytes, table->entry[k].name);
    return error_set(error, ERROR_USER, "%s: is cut off: %" PRIu64 " of %" PRIu64 " bytes", path, size,
                     table->bytes);
}

static bool check_block(struct checkpoint_table *table, const char *path, const char *block, uint64_t size,
                        struct error *error) {
    size_t mark = strlen(magic), seen = size < mark ? (size_t)size : mark;
    if (seen == 0 || memcmp(block, magic, seen) != 0)
        return error_set(error, ERROR_USER, "%s: is not a checkpoint of scree", path);
    if (size < CHECKPOINT_BLOCK)
        return error_set(error, ERROR_USER,
                         "%s: is cut off: %" PRIu64 " bytes, not even its table of contents is whole", path,
                         size);
    long version = strtol(block + mark, NULL, 10);
    if (version > CHECKPOINT_VERSION || version == 1)
        return error_set(error, ERROR_USER,
                         "%s: was written by %s version of scree (format %ld, here %d): only that version "
                         "can go on from it",
                         path, version > CHECKPOINT_VERSION ? "a newer" : "an older", version,
                         CHECKPOINT_VERSION);
    if (!parse_table(table, block))
        return error_set(error, ERROR_USER, "%s: its table of contents (first %d bytes) is damaged", path,
                         CHECKPOINT_BLOCK);
    return size == table->bytes || refuse_size(table, path, size, error);
}

bool checkpoint_table_read(struct checkpoint_table *table, const struct comm *comm, const char *path,
                           struct error *error) {
    *table = (struct checkpoint_table){0};
    if (comm->rank == 0) {
        char block[CHECKPOINT_BLOCK] = {0};
        struct stat status;
        int handle = open(path, O_RDONLY | O_NONBLOCK);
        if (handle < 0 || fstat(handle, &status) != 0) {
            error_set(error, file_is_missing(errno) ? ERROR_USER : ERROR_SYSTEM, "%s: cannot be opened: %s",
                      path, strerror(errno));
        } else if (!S_ISREG(status.st_mode)) {
            error_set(error, ERROR_USER, "%s: is not a file", path);
        } else {
            uint64_t size = (uint64_t)status.st_size, seen = size < sizeof block ? size : sizeof block;
            if (!file_read_at(handle, block, seen, 0))
                error_set_errno(error, "%s: cannot be read", path);
            else
                check_block(table, path, block, size, error);
        }
        if (handle >= 0)
            close(handle);
    }
    if (!comm_agree(comm, error))
        return false;
    comm_broadcast(comm, table, sizeof *table);
    return true;
}

bool checkpoint_table_write(struct checkpoint_table *table, const struct comm *comm, const char *path,
                            struct error *error) {
    if (comm->rank == 0) {
        struct stat status;
        char block[CHECKPOINT_BLOCK];
        int handle = open(path, O_RDWR);
        if (handle < 0 || fstat(handle, &status) != 0) {
            error_set_errno(error, "%s: cannot be opened again", path);
        } else {
            table->bytes = (uint64_t)status.st_size;
            bool good = checkpoint_table_sum_rest(table, handle, &table->rest);
            format_table(table, block);
            if (!good || !file_write_at(handle, block, sizeof block, 0))
                error_set_errno(error, "%s: its table of contents cannot be written", path);
        }
        if (handle >= 0 && close(handle) != 0)
            error_set_errno(error, "%s: cannot be closed", path);
    }
    if (!comm_agree(comm, error))
        return false;
    comm_broadcast(comm, table, sizeof *table);
    return true;
}
