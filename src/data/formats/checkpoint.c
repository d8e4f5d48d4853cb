/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes checkpoints. Every dataset is a table of rows: the rows of a rank lie together, in the order of the
 * ranks. The checksum of a dataset comes from memory. Then the closed file is compared with the checksums, so
 * only a whole file is renamed. */
#include "data/formats/checkpoint.h"
#include "data/formats/checkpoint_head.h"
#include "data/formats/checkpoint_names.h"
#include "data/formats/checkpoint_put.h"

#include "base/memory.h"
#include "data/formats/checkpoint_file.h"
#include "base/file.h"

#include <assert.h>
#include <inttypes.h>
#include <string.h>
#include <unistd.h>

static bool put_field(struct checkpoint_writing *w, int f, struct error *error) {
    const struct particles *p = w->checkpoint->particles;
    const struct field *field = fields_get(p, f);
    size_t stride, bytes = fields_bytes(field);
    const char *base = fields_base(p, f, &stride);
    char *data = memory_allocate(p->owned, bytes, "field of a checkpoint");
#pragma omp parallel for
    for (size_t i = 0; i < p->owned; i++)
        memcpy(data + i * bytes, base + i * stride, bytes);
    struct h5_table table = {.type = field->type,
                             .rows = w->total,
                             .width = field->components > 1 ? (uint64_t)field->components : 0,
                             .first = w->first,
                             .count = p->owned};
    char name[OUTPUT_NAME_MAX];
    checkpoint_field_name(field, name);
    bool good = checkpoint_put(w, name, &table, data, error);
    memory_free(data);
    return good;
}

/* The place of this rank's rows among the rows of all ranks. */
static struct h5_table place_rows(const struct comm *comm, size_t count) {
    int64_t total = (int64_t)count, first = comm_scan(comm, total);
    comm_sum_int(comm, &total, 1);
    return (struct h5_table){.rows = (uint64_t)total, .first = (uint64_t)first, .count = count};
}

/* Writes the number of rows of each particle, from the start table of the rows. */
static bool put_counts(struct checkpoint_writing *w, const char *name, const size_t *start,
                       struct error *error) {
    size_t n = w->checkpoint->particles->owned;
    int32_t *count = memory_allocate(n, sizeof *count, "history counts");
    for (size_t i = 0; i < n; i++)
        count[i] = (int32_t)(start[i + 1] - start[i]);
    struct h5_table table = {.type = FIELD_INT32, .rows = w->total, .first = w->first, .count = n};
    bool good = checkpoint_put(w, name, &table, count, error);
    memory_free(count);
    return good;
}

/* Writes the values of rows, and behind them `apart` numbers of their separations: 0 or 3. */
static bool put_values(struct checkpoint_writing *w, const char *name, const struct history_rows *rows,
                       size_t apart, struct error *error) {
    size_t width = checkpoint_history_width(rows->components) + apart;
    double *value = memory_allocate_zero(rows->count * width, sizeof *value, "history rows");
    for (size_t k = 0; k < rows->count; k++) {
        double *to = value + k * width;
        memcpy(to, rows->row[k].value, (size_t)rows->components * sizeof *to);
        memcpy(to + width - apart, rows->row[k].separation, apart * sizeof *to);
    }
    struct h5_table table = place_rows(w->comm, rows->count);
    table.type = FIELD_DOUBLE;
    table.width = width;
    bool good = checkpoint_put(w, name, &table, value, error);
    memory_free(value);
    return good;
}

/* Writes the rows of pairs of a group: "history", or a physics. */
static bool put_rows(struct checkpoint_writing *w, const char *group, const struct history_rows *rows,
                     struct error *error) {
    char name[CHECKPOINT_ROWS_NAMES][OUTPUT_NAME_MAX];
    checkpoint_rows_names(group, name);
    if (!put_counts(w, name[CHECKPOINT_ROWS_COUNT], rows->start, error))
        return false;
    int64_t *partner = memory_allocate(rows->count, sizeof *partner, "history rows");
    for (size_t k = 0; k < rows->count; k++)
        partner[k] = rows->row[k].partner;
    struct h5_table table = place_rows(w->comm, rows->count);
    table.type = FIELD_INT64;
    bool good = checkpoint_put(w, name[CHECKPOINT_ROWS_PARTNER], &table, partner, error);
    memory_free(partner);
    return good && put_values(w, name[CHECKPOINT_ROWS_VALUE], rows, 3, error);
}

static bool put_wall_history(struct checkpoint_writing *w, struct error *error) {
    const struct history_rows *rows = w->checkpoint->wall_history;
    if (!put_counts(w, "/wall_history/count", rows->start, error))
        return false;
    int32_t(*place)[2] = memory_allocate(rows->count, sizeof *place, "wall history rows");
    for (size_t k = 0; k < rows->count; k++) {
        place[k][0] = wall_row_wall(&rows->row[k]);
        place[k][1] = wall_row_feature(&rows->row[k]);
    }
    struct h5_table table = place_rows(w->comm, rows->count);
    table.type = FIELD_INT32;
    table.width = 2;
    bool good = checkpoint_put(w, "/wall_history/wall_patch", &table, place, error);
    memory_free(place);
    return good && put_values(w, "/wall_history/value", rows, 0, error);
}

static bool put_all(struct checkpoint_writing *w, struct error *error) {
    const struct checkpoint *c = w->checkpoint;
    bool good = checkpoint_put_head(w, error);
    const struct field_list fields = fields_with(c->particles, FIELD_RESTART);
    for (int k = 0; good && k < fields.count; k++)
        good = put_field(w, fields.field[k], error);
    /* either every rank has rows, or no rank: the law decides */
    if (good && c->history)
        good = put_rows(w, "history", c->history, error);
    if (good && c->wall_history)
        good = put_wall_history(w, error);
    for (int k = 0; good && c->carried && k < PHYSICS_COUNT; k++)
        if (c->carried[k])
            good = put_rows(w, checkpoint_physics_names[k], c->carried[k], error);
    return good;
}

/* The bytes of the file to be written, with some spare. */
static uint64_t estimate_bytes(const struct checkpoint_writing *w) {
    const struct checkpoint *c = w->checkpoint;
    uint64_t rows = (c->history ? c->history->count : 0) + (c->wall_history ? c->wall_history->count : 0);
    uint64_t carried = 0;
    for (int k = 0; c->carried && k < PHYSICS_COUNT; k++)
        if (c->carried[k])
            carried += c->carried[k]->count * 8 * (checkpoint_history_width(c->carried[k]->components) + 4);
    const struct field_list fields = fields_with(c->particles, FIELD_RESTART);
    int64_t bytes = (int64_t)(c->particles->owned * (fields_packed_bytes(c->particles, &fields) + 8) +
                              carried + rows * 8 * (checkpoint_history_width(c->history_components) + 4));
    comm_sum_int(w->comm, &bytes, 1);
    uint64_t ranks = (uint64_t)w->comm->size, walls = c->walls ? (uint64_t)walls_count(c->walls) : 0;
    uint64_t numbers = c->restart ? c->restart->count : 0, texts = 0;
    uint64_t of_ranks = ranks * (numbers + CHECKPOINT_CUT + 1) * sizeof(double);
    for (size_t k = 0; c->lineage && k < c->lineage->count; k++)
        texts += strlen(c->lineage->run[k].scene) + 1;
    uint64_t of_walls = walls * (CHECKPOINT_POSE * sizeof(double) + WALL_NAME_MAX);
    return (uint64_t)bytes + of_ranks + of_walls + strlen(c->scene) + texts + numbers * OUTPUT_NAME_MAX +
           (1 << 16);
}

/* Writes all data to the temporary file and compares the bytes of the file with the checksums. */
static bool write_file(struct checkpoint_writing *w, const char *temporary, uint64_t bytes,
                       struct error *error) {
    if (!h5_create(&w->h5, temporary, w->comm, CHECKPOINT_BLOCK, error))
        return false;
    if (w->comm->rank == 0)
        file_reserve(temporary, bytes, error);
    bool good = comm_agree(w->comm, error) && put_all(w, error);
    good = h5_close(&w->h5, error) && good;
    return good && checkpoint_table_write(&w->table, w->comm, temporary, error) &&
           checkpoint_verify(w->comm, temporary, error);
}

bool checkpoint_write(const struct comm *comm, const char *directory, const char *suffix,
                      const struct checkpoint *checkpoint, int keep, struct error *error) {
    struct checkpoint_writing w = {.comm = comm, .checkpoint = checkpoint, .h5 = {.file = -1}};
    int64_t total = (int64_t)checkpoint->particles->owned;
    w.first = (uint64_t)comm_scan(comm, total);
    comm_sum_int(comm, &total, 1);
    w.total = (uint64_t)total;
    char name[OUTPUT_NAME_MAX], path[FILE_PATH_MAX], temporary[FILE_PATH_MAX + 8];
    snprintf(name, sizeof name, "checkpoint-%" PRIu64 "%.20s.h5", checkpoint->numbers.step, suffix);
    uint64_t bytes = estimate_bytes(&w);
    if (file_join(path, directory, name, error) && comm->rank == 0)
        file_check_room(path, 0, bytes, error);
    if (!comm_agree(comm, error))
        return false;
    snprintf(temporary, sizeof temporary, "%s.part", path);
    bool good = write_file(&w, temporary, bytes, error);
    if (good && comm->rank == 0 && file_settle(temporary, path, error) && keep > 0 && suffix[0] == '\0')
        checkpoint_delete_old(directory, checkpoint->numbers.step, keep);
    good = comm_agree(comm, error);
    if (!good && comm->rank == 0)
        unlink(temporary);
    return good;
}

bool checkpoint_verify(const struct comm *comm, const char *path, struct error *error) {
    struct checkpoint_file file;
    if (!checkpoint_file_open(&file, comm, path, error))
        return false;
    bool good = checkpoint_file_compare(&file, error);
    checkpoint_file_close(&file);
    return good;
}
