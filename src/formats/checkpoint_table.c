#include "formats/checkpoint_table.h"

#include "core/checksum.h"
#include "core/memory.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PIECE = 1 << 20, REST_ROW = 4096 };

static const char magic[] = "scree checkpoint ";

/* Reads exactly `bytes` bytes at `offset`; short files are errors. */
static bool read_exactly(int handle, void *buffer, uint64_t bytes, uint64_t offset) {
    char *next = buffer;
    while (bytes > 0) {
        ssize_t got = pread(handle, next, bytes, (off_t)offset);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0) {
            errno = got == 0 ? EIO : errno;
            return false;
        }
        next += got;
        offset += (uint64_t)got;
        bytes -= (uint64_t)got;
    }
    return true;
}

static bool write_exactly(int handle, const void *buffer, uint64_t bytes, uint64_t offset) {
    const char *next = buffer;
    while (bytes > 0) {
        ssize_t put = pwrite(handle, next, bytes, (off_t)offset);
        if (put < 0 && errno == EINTR)
            continue;
        if (put <= 0)
            return false;
        next += put;
        offset += (uint64_t)put;
        bytes -= (uint64_t)put;
    }
    return true;
}

/* Checksum of rows [first, last) of `row_bytes` bytes that begin at `offset`. */
static bool sum_rows(int handle, const struct checkpoint_entry *entry, uint64_t first, uint64_t last,
                     uint64_t *sum) {
    uint64_t rows_a_piece = entry->row_bytes < PIECE ? PIECE / entry->row_bytes : 1;
    char *buffer = memory_allocate(rows_a_piece, entry->row_bytes, "piece of a file");
    bool good = true;
    *sum = 0;
    for (uint64_t row = first; good && row < last; row += rows_a_piece) {
        uint64_t rows = last - row < rows_a_piece ? last - row : rows_a_piece;
        good = read_exactly(handle, buffer, rows * entry->row_bytes, entry->offset + row * entry->row_bytes);
        if (good)
            *sum += checksum_rows(row, buffer, rows, entry->row_bytes);
    }
    memory_free(buffer);
    return good;
}

static int compare_offsets(const void *a, const void *b) {
    const struct checkpoint_entry *x = a, *y = b;
    return (x->offset > y->offset) - (x->offset < y->offset);
}

/* Checksum of what lies between the datasets: each gap in rows of REST_ROW bytes, keyed by their place. */
static bool sum_rest(int handle, const struct checkpoint_table *table, uint64_t *sum) {
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
            if (!read_exactly(handle, buffer, bytes, place))
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

/* Parses a block. A table is right if writing it again gives the same bytes: that covers its checksum, the
 * form of the numbers and the zeros behind. */
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

/* What is wrong with the size of a file, in terms of datasets. */
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
    if (strtol(block + mark, NULL, 10) > CHECKPOINT_VERSION)
        return error_set(error, ERROR_USER,
                         "%s: was written by a newer version of scree (format %ld, here %d)", path,
                         strtol(block + mark, NULL, 10), CHECKPOINT_VERSION);
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
        int handle = open(path, O_RDONLY);
        if (handle < 0 || fstat(handle, &status) != 0) {
            error_set(error, ERROR_USER, "%s: cannot be opened: %s", path, strerror(errno));
        } else if (!S_ISREG(status.st_mode)) {
            error_set(error, ERROR_USER, "%s: is not a file", path);
        } else {
            uint64_t size = (uint64_t)status.st_size, seen = size < sizeof block ? size : sizeof block;
            if (!read_exactly(handle, block, seen, 0))
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
            bool good = sum_rest(handle, table, &table->rest);
            format_table(table, block);
            if (!good || !write_exactly(handle, block, sizeof block, 0))
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

static bool is_large(const struct checkpoint_entry *entry) {
    return strncmp(entry->name, "/particles/", 11) == 0 || strncmp(entry->name, "/history/", 9) == 0 ||
           strncmp(entry->name, "/wall_history/", 14) == 0;
}

/* The sums of all datasets to be compared, over all ranks. */
static void sum_datasets(const struct checkpoint_table *table, const struct comm *comm, int handle,
                         bool head_only, int64_t sums[CHECKPOINT_DATASETS_MAX], struct error *error) {
    uint64_t size = (uint64_t)comm->size, rank = (uint64_t)comm->rank;
    for (int k = 0; k < table->entries; k++) {
        const struct checkpoint_entry *entry = &table->entry[k];
        uint64_t rows = entry->row_bytes > 0 ? entry->bytes / entry->row_bytes : 0, sum = 0;
        uint64_t first = rows / size * rank + (rank < rows % size ? rank : rows % size);
        uint64_t mine = rows / size + (rank < rows % size);
        if (!(head_only && is_large(entry)) && mine > 0 && error->kind == ERROR_NONE &&
            !sum_rows(handle, entry, first, first + mine, &sum))
            error_set_errno(error, "dataset %s cannot be read", entry->name);
        sums[k] = (int64_t)sum;
    }
    comm_sum_int(comm, sums, table->entries);
}

bool checkpoint_table_compare(const struct checkpoint_table *table, const struct comm *comm, const char *path,
                              bool head_only, struct error *error) {
    int handle = open(path, O_RDONLY);
    if (handle < 0)
        error_set(error, ERROR_USER, "%s: cannot be opened: %s", path, strerror(errno));
    if (!comm_agree(comm, error)) {
        if (handle >= 0)
            close(handle);
        return false;
    }
    int64_t sums[CHECKPOINT_DATASETS_MAX] = {0};
    sum_datasets(table, comm, handle, head_only, sums, error);
    for (int k = 0; k < table->entries; k++)
        if (!(head_only && is_large(&table->entry[k])) && (uint64_t)sums[k] != table->entry[k].checksum)
            error_set(error, ERROR_USER, "%s: dataset %s is damaged: its bytes do not give its checksum",
                      path, table->entry[k].name);
    uint64_t rest = 0;
    if (comm->rank == 0 && error->kind == ERROR_NONE) {
        if (!sum_rest(handle, table, &rest))
            error_set_errno(error, "%s: cannot be read", path);
        else if (rest != table->rest)
            error_set(error, ERROR_USER,
                      "%s: is damaged between its datasets: the bytes do not give their checksum", path);
    }
    close(handle);
    return comm_agree(comm, error);
}
