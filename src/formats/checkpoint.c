/* Writing. Every dataset is a table of rows, this rank's rows together, in the order of the ranks; its
 * checksum comes from memory. Then the closed file is compared with these checksums, so what is renamed is
 * known to be whole. */
#include "formats/checkpoint_parts.h"

#include "core/checksum.h"
#include "core/memory.h"
#include "formats/checkpoint_file.h"
#include "files/file.h"

#include <assert.h>
#include <dirent.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A checkpoint on its way. */
struct writing {
    const struct comm *comm;
    const struct checkpoint *checkpoint;
    struct h5 h5;
    struct checkpoint_table table;
    uint64_t first, total; /* particles before this rank's, and of all */
};

void checkpoint_field_name(const struct field *field, char name[OUTPUT_NAME_MAX]) {
    snprintf(name, OUTPUT_NAME_MAX, "/particles/%s", field->name);
}

/* Enters a dataset, just written, into the table. */
static bool enter(struct writing *w, const char *name, const struct h5_table *rows, size_t row_bytes,
                  const void *data, struct error *error) {
    assert(w->table.entries < CHECKPOINT_DATASETS_MAX);
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

size_t checkpoint_type_bytes(enum field_type type) {
    return type == FIELD_UINT8 ? 1 : type == FIELD_INT32 ? 4 : 8;
}

static bool put(struct writing *w, const char *name, const struct h5_table *rows, const void *data,
                struct error *error) {
    size_t row_bytes = checkpoint_type_bytes(rows->type) * (rows->width ? rows->width : 1);
    return h5_write_table(&w->h5, name, rows, data, error) && enter(w, name, rows, row_bytes, data, error);
}

/* A table that every rank has: rank 0 writes it. */
static bool put_common(struct writing *w, const char *name, enum field_type type, uint64_t rows,
                       uint64_t width, const void *data, struct error *error) {
    struct h5_table table = {.type = type, .rows = rows, .width = width};
    table.count = w->comm->rank == 0 ? rows : 0;
    table.first = w->comm->rank == 0 ? 0 : rows;
    return put(w, name, &table, data, error);
}

/* One row of every rank. */
static bool put_of_ranks(struct writing *w, const char *name, enum field_type type, uint64_t width,
                         const void *data, struct error *error) {
    struct h5_table table = {.type = type,
                             .rows = (uint64_t)w->comm->size,
                             .width = width,
                             .first = (uint64_t)w->comm->rank,
                             .count = 1};
    return put(w, name, &table, data, error);
}

static bool put_numbers(struct writing *w, struct error *error) {
    const struct checkpoint *c = w->checkpoint;
    const struct checkpoint_numbers *n = &c->numbers;
    int64_t integers[CHECKPOINT_INTEGERS] = {
        [CHECKPOINT_STEP] = (int64_t)n->step,
        [CHECKPOINT_SEED] = (int64_t)n->seed,
        [CHECKPOINT_NEXT_ID] = n->next_id,
        [CHECKPOINT_RANKS] = w->comm->size,
        [CHECKPOINT_FIELDS] = fields_with(c->particles, FIELD_RESTART).count,
        [CHECKPOINT_HISTORY_COMPONENTS] = c->history_components,
        [CHECKPOINT_WALLS] = c->walls ? walls_count(c->walls) : 0,
        [CHECKPOINT_TOTAL] = (int64_t)w->total,
        [CHECKPOINT_GRID] = n->grid[0],
        [CHECKPOINT_GRID + 1] = n->grid[1],
        [CHECKPOINT_GRID + 2] = n->grid[2],
    };
    double times[2] = {n->time, n->dt};
    int64_t owned = (int64_t)c->particles->owned;
    return put_common(w, "/run/integers", FIELD_INT64, CHECKPOINT_INTEGERS, 0, integers, error) &&
           put_common(w, "/run/time_dt", FIELD_DOUBLE, 2, 0, times, error) &&
           put_common(w, "/run/counters", FIELD_INT64, CHECKPOINT_COUNTERS, 0, n->counter, error) &&
           put_of_ranks(w, "/run/sums", FIELD_DOUBLE, CHECKPOINT_COUNTERS, n->sum, error) &&
           put_of_ranks(w, "/run/particles_of_ranks", FIELD_INT64, 0, &owned, error);
}

static bool put_tree(struct writing *w, struct error *error) {
    const struct domain_tree *tree = w->checkpoint->tree;
    if (tree == NULL || tree->ranks < 2)
        return true;
    uint64_t cuts = (uint64_t)tree->ranks - 1;
    double(*row)[CHECKPOINT_CUT] = memory_allocate(cuts, sizeof *row, "cuts of a bisection");
    for (uint64_t k = 0; k < cuts; k++) {
        row[k][0] = tree->cut[k].at;
        row[k][1] = tree->cut[k].middle;
        row[k][2] = tree->cut[k].axis;
    }
    bool good = put_common(w, CHECKPOINT_CUTS, FIELD_DOUBLE, cuts, CHECKPOINT_CUT, row, error);
    memory_free(row);
    return good;
}

static bool put_surroundings(struct writing *w, struct error *error) {
    const struct checkpoint *c = w->checkpoint;
    double lengths[6];
    int32_t sides[CHECKPOINT_SIDES] = {c->box->dimension};
    for (int d = 0; d < 3; d++) {
        lengths[d] = c->box->origin[d];
        lengths[3 + d] = c->box->edge[d];
        sides[1 + d] = c->box->periodic[d];
        sides[4 + 2 * d] = (int32_t)c->box->leave[d][0];
        sides[5 + 2 * d] = (int32_t)c->box->leave[d][1];
    }
    uint64_t length = strlen(c->scene) + 1;
    if (!put_common(w, "/box/origin_edge", FIELD_DOUBLE, 6, 0, lengths, error) ||
        !put_common(w, "/box/sides", FIELD_INT32, CHECKPOINT_SIDES, 0, sides, error) ||
        !h5_write_string(&w->h5, "/scene", c->scene, error))
        return false;
    struct h5_table text = {.rows = 1, .count = w->comm->rank == 0, .first = w->comm->rank > 0};
    return enter(w, "/scene", &text, length, c->scene, error);
}

static bool put_walls(struct writing *w, struct error *error) {
    static_assert(sizeof(struct wall_pose) == CHECKPOINT_POSE * sizeof(double), "a pose is doubles alone");
    const struct walls *walls = w->checkpoint->walls;
    uint64_t count = walls ? (uint64_t)walls_count(walls) : 0;
    double(*pose)[CHECKPOINT_POSE] = memory_allocate_zero(count, sizeof *pose, "wall poses");
    char(*name)[WALL_NAME_MAX] = memory_allocate_zero(count, sizeof *name, "wall names");
    for (uint64_t k = 0; k < count; k++) {
        struct wall_pose now;
        walls_pose(walls, (int)k, &now);
        comm_sum(w->comm, now.force, 6);
        memcpy(pose[k], &now, sizeof now);
        snprintf(name[k], sizeof name[k], "%s", walls_options(walls, (int)k)->name);
    }
    bool good = put_common(w, "/walls/name", FIELD_UINT8, count, WALL_NAME_MAX, name, error) &&
                put_common(w, "/walls/pose", FIELD_DOUBLE, count, CHECKPOINT_POSE, pose, error);
    memory_free(pose);
    memory_free(name);
    return good;
}

static bool put_field(struct writing *w, int f, struct error *error) {
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
    bool good = put(w, name, &table, data, error);
    memory_free(data);
    return good;
}

/* The rows of this rank among those of all. */
static struct h5_table place_rows(const struct comm *comm, size_t count) {
    int64_t total = (int64_t)count, first = comm_scan(comm, total);
    comm_sum_int(comm, &total, 1);
    return (struct h5_table){.rows = (uint64_t)total, .first = (uint64_t)first, .count = count};
}

/* How many rows each particle has, from the rows' start table. */
static bool put_counts(struct writing *w, const char *name, const size_t *start, struct error *error) {
    size_t n = w->checkpoint->particles->owned;
    int32_t *count = memory_allocate(n, sizeof *count, "history counts");
    for (size_t i = 0; i < n; i++)
        count[i] = (int32_t)(start[i + 1] - start[i]);
    struct h5_table table = {.type = FIELD_INT32, .rows = w->total, .first = w->first, .count = n};
    bool good = put(w, name, &table, count, error);
    memory_free(count);
    return good;
}

static bool put_history(struct writing *w, struct error *error) {
    const struct history_rows *rows = w->checkpoint->history;
    if (!put_counts(w, "/history/count", rows->start, error))
        return false;
    int64_t *partner = memory_allocate(rows->count, sizeof *partner, "history rows");
    double(*value)[CHECKPOINT_HISTORY] = memory_allocate_zero(rows->count, sizeof *value, "history rows");
    for (size_t k = 0; k < rows->count; k++) {
        partner[k] = rows->row[k].partner;
        memcpy(value[k], rows->row[k].value, (size_t)w->checkpoint->history_components * sizeof value[k][0]);
        memcpy(value[k] + HISTORY_COMPONENTS_MAX, rows->row[k].separation, sizeof rows->row[k].separation);
    }
    struct h5_table table = place_rows(w->comm, rows->count);
    table.type = FIELD_INT64;
    bool good = put(w, "/history/partner", &table, partner, error);
    table.type = FIELD_DOUBLE;
    table.width = CHECKPOINT_HISTORY;
    good = good && put(w, "/history/value_separation", &table, value, error);
    memory_free(partner);
    memory_free(value);
    return good;
}

static bool put_wall_history(struct writing *w, struct error *error) {
    const struct wall_rows *rows = w->checkpoint->wall_history;
    if (!put_counts(w, "/wall_history/count", rows->start, error))
        return false;
    int32_t(*place)[2] = memory_allocate(rows->count, sizeof *place, "wall history rows");
    double(*value)[HISTORY_COMPONENTS_MAX] =
        memory_allocate_zero(rows->count, sizeof *value, "wall history rows");
    for (size_t k = 0; k < rows->count; k++) {
        place[k][0] = rows->row[k].wall;
        place[k][1] = rows->row[k].patch;
        memcpy(value[k], rows->row[k].value, (size_t)w->checkpoint->history_components * sizeof value[k][0]);
    }
    struct h5_table table = place_rows(w->comm, rows->count);
    table.type = FIELD_INT32;
    table.width = 2;
    bool good = put(w, "/wall_history/wall_patch", &table, place, error);
    table.type = FIELD_DOUBLE;
    table.width = HISTORY_COMPONENTS_MAX;
    good = good && put(w, "/wall_history/value", &table, value, error);
    memory_free(place);
    memory_free(value);
    return good;
}

static bool put_all(struct writing *w, struct error *error) {
    const struct checkpoint *c = w->checkpoint;
    bool good =
        put_numbers(w, error) && put_tree(w, error) && put_surroundings(w, error) && put_walls(w, error);
    const struct field_list fields = fields_with(c->particles, FIELD_RESTART);
    for (int k = 0; good && k < fields.count; k++)
        good = put_field(w, fields.field[k], error);
    /* every rank has rows, or none: the law decides */
    if (good && c->history)
        good = put_history(w, error);
    if (good && c->wall_history)
        good = put_wall_history(w, error);
    return good;
}

/* Bytes that the file will have, and some more. */
static uint64_t estimate_bytes(const struct writing *w) {
    const struct checkpoint *c = w->checkpoint;
    uint64_t rows = (c->history ? c->history->count : 0) + (c->wall_history ? c->wall_history->count : 0);
    const struct field_list fields = fields_with(c->particles, FIELD_RESTART);
    int64_t bytes = (int64_t)(c->particles->owned * (fields_packed_bytes(c->particles, &fields) + 8) +
                              rows * 8 * (CHECKPOINT_HISTORY + 1));
    comm_sum_int(w->comm, &bytes, 1);
    uint64_t ranks = (uint64_t)w->comm->size, walls = c->walls ? (uint64_t)walls_count(c->walls) : 0;
    uint64_t of_ranks = ranks * (CHECKPOINT_COUNTERS + CHECKPOINT_CUT + 1) * sizeof(double);
    uint64_t of_walls = walls * (CHECKPOINT_POSE * sizeof(double) + WALL_NAME_MAX);
    return (uint64_t)bytes + of_ranks + of_walls + strlen(c->scene) + (1 << 16);
}

/* STEP of "checkpoint-STEPending"; -1 for other names. */
static int64_t step_of_name(const char *name, const char *ending) {
    static const char lead[] = "checkpoint-";
    size_t skip = sizeof lead - 1, digits = 0;
    if (strncmp(name, lead, skip) != 0)
        return -1;
    while (name[skip + digits] >= '0' && name[skip + digits] <= '9')
        digits++;
    if (digits == 0 || digits > 18 || strcmp(name + skip + digits, ending) != 0)
        return -1;
    return strtoll(name + skip, NULL, 10);
}

static int compare_steps(const void *a, const void *b) {
    int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
    return (x < y) - (x > y);
}

/* The steps of the checkpoints in a directory, the newest first; memory_free. */
static int64_t *list_steps(const char *directory, size_t *count) {
    int64_t *step = NULL;
    *count = 0;
    DIR *open_directory = opendir(directory);
    if (!open_directory)
        return NULL;
    for (const struct dirent *entry; (entry = readdir(open_directory)) != NULL;) {
        int64_t found = step_of_name(entry->d_name, ".h5");
        if (found < 0)
            continue;
        step = memory_resize(step, *count + 1, sizeof *step, "checkpoints in a directory");
        step[(*count)++] = found;
    }
    closedir(open_directory);
    if (step)
        qsort(step, *count, sizeof *step, compare_steps);
    return step;
}

static void delete_old(const char *directory, uint64_t newest, int keep) {
    size_t count;
    int kept = 0;
    int64_t *step = list_steps(directory, &count);
    for (size_t k = 0; k < count; k++) {
        if (step[k] > (int64_t)newest || kept++ < keep)
            continue;
        char path[FILE_PATH_MAX + OUTPUT_NAME_MAX];
        snprintf(path, sizeof path, "%s/checkpoint-%" PRId64 ".h5", directory, step[k]);
        unlink(path);
    }
    memory_free(step);
}

bool checkpoint_find_newest(const char *directory, char *path) {
    size_t count;
    int64_t *step = list_steps(directory, &count);
    if (count > 0)
        snprintf(path, FILE_PATH_MAX, "%s/checkpoint-%" PRId64 ".h5", directory, step[0]);
    memory_free(step);
    return count > 0;
}

bool checkpoint_discard(const char *directory, int64_t step, struct error *error) {
    static const char *const endings[] = {".h5", ".h5.part", CHECKPOINT_STOPPED ".h5",
                                          CHECKPOINT_STOPPED ".h5.part"};
    char path[FILE_PATH_MAX];
    DIR *open_directory = opendir(directory);
    if (!open_directory)
        return error_set_errno(error, "%s: cannot be listed", directory);
    for (const struct dirent *entry; (entry = readdir(open_directory)) != NULL;)
        for (size_t k = 0; k < sizeof endings / sizeof endings[0]; k++)
            if (step_of_name(entry->d_name, endings[k]) > step &&
                file_join(path, directory, entry->d_name, error) && unlink(path) != 0)
                error_set_errno(error, "%s: cannot be deleted", path);
    closedir(open_directory);
    return error->kind == ERROR_NONE;
}

/* Writes everything into the temporary file and compares what lies there with what was meant. */
static bool write_file(struct writing *w, const char *temporary, uint64_t bytes, struct error *error) {
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
    struct writing w = {.comm = comm, .checkpoint = checkpoint, .h5 = {.file = -1}};
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
        delete_old(directory, checkpoint->numbers.step, keep);
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
