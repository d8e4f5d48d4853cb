/* Reading, by plain reads (checkpoint_file.h). The file's bytes have been compared with its table before; the
 * shape of each dataset is still checked, since a file may come from a program that differs. */
#include "formats/checkpoint_parts.h"

#include "core/memory.h"
#include "formats/checkpoint_file.h"
#include "integrate/groups.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

struct reading {
    const struct comm *comm;
    struct checkpoint_file file;
    struct checkpoint_loaded *loaded;
    uint64_t first, count; /* particles of this rank */
};

/* The bytes of a row of `width` values (0: one). */
static size_t row_bytes(enum field_type type, uint64_t width) {
    return checkpoint_type_bytes(type) * (width ? width : 1);
}

/* Reads rows [first, first + count) of a table; all ranks' rows together are the whole of it. */
static bool get(struct reading *r, const char *name, const struct h5_table *table, void *data,
                struct error *error) {
    struct checkpoint_rows rows = {.dataset = name,
                                   .row_bytes = row_bytes(table->type, table->width),
                                   .rows = table->rows,
                                   .first = table->first,
                                   .count = table->count};
    return checkpoint_file_read(&r->file, &rows, data, error);
}

/* A table that every rank reads whole. */
static bool get_common(struct reading *r, const char *name, enum field_type type, uint64_t rows,
                       uint64_t width, void *data, struct error *error) {
    return checkpoint_file_read_common(&r->file, name, row_bytes(type, width), rows, data, error);
}

/* A text that every rank reads; memory_free. NULL on failure. */
static char *get_text(struct reading *r, const char *name, struct error *error) {
    const struct checkpoint_entry *entry = checkpoint_file_find(&r->file, name);
    uint64_t length = entry ? entry->bytes : 0;
    char *text = memory_allocate_zero(length + 1, 1, "text of a file");
    if (checkpoint_file_read_common(&r->file, name, length, 1, text, error))
        return text;
    memory_free(text);
    return NULL;
}

static bool get_numbers(struct reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    int64_t integers[CHECKPOINT_INTEGERS];
    double times[2];
    if (!get_common(r, "/run/integers", FIELD_INT64, CHECKPOINT_INTEGERS, 0, integers, error) ||
        !get_common(r, "/run/time_dt", FIELD_DOUBLE, 2, 0, times, error) ||
        !get_common(r, "/run/counters", FIELD_INT64, CHECKPOINT_COUNTERS, 0, l->numbers.counter, error))
        return false;
    l->numbers.step = (uint64_t)integers[CHECKPOINT_STEP];
    l->numbers.seed = (uint64_t)integers[CHECKPOINT_SEED];
    l->numbers.next_id = integers[CHECKPOINT_NEXT_ID];
    l->numbers.time = times[0];
    l->numbers.dt = times[1];
    l->ranks = (int)integers[CHECKPOINT_RANKS];
    l->history_components = (int)integers[CHECKPOINT_HISTORY_COMPONENTS];
    l->walls = (int)integers[CHECKPOINT_WALLS];
    l->total = (uint64_t)integers[CHECKPOINT_TOTAL];
    for (int d = 0; d < 3; d++)
        l->numbers.grid[d] = (int)integers[CHECKPOINT_GRID + d];
    l->same_layout = l->ranks == r->comm->size;
    if (l->ranks < 1 || l->walls < 0 || l->walls > WALLS_MAX || l->history_components < 0 ||
        l->history_components > HISTORY_COMPONENTS_MAX)
        return error_set(error, ERROR_USER, "%s: /run/integers: holds impossible numbers", r->file.path);
    return true;
}

/* The sums: each rank its own, or rank 0 the total. */
static bool get_sums(struct reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    double(*sums)[CHECKPOINT_COUNTERS] = memory_allocate((size_t)l->ranks, sizeof *sums, "sums of ranks");
    bool good =
        get_common(r, "/run/sums", FIELD_DOUBLE, (uint64_t)l->ranks, CHECKPOINT_COUNTERS, sums, error);
    if (good && l->same_layout)
        memcpy(l->numbers.sum, sums[r->comm->rank], sizeof l->numbers.sum);
    for (int k = 0; good && !l->same_layout && r->comm->rank == 0 && k < l->ranks; k++)
        for (int s = 0; s < CHECKPOINT_COUNTERS; s++)
            l->numbers.sum[s] += sums[k][s];
    memory_free(sums);
    return good;
}

/* -1 where it is too large. */
static int small_integer(double x) {
    return x >= 0 && x <= INT_MAX ? (int)x : -1;
}

/* How the box was divided, if it was by a bisection among as many ranks. */
static bool get_tree(struct reading *r, struct error *error) {
    static const double lowest[3] = {-INFINITY, -INFINITY, -INFINITY},
                        highest[3] = {INFINITY, INFINITY, INFINITY};
    int ranks = r->loaded->ranks;
    if (!r->loaded->same_layout || ranks < 2 || !checkpoint_file_find(&r->file, CHECKPOINT_CUTS))
        return true;
    size_t cuts = (size_t)ranks - 1;
    double(*row)[CHECKPOINT_CUT] = memory_allocate_zero(cuts, sizeof *row, "cuts of a bisection");
    struct domain_cut *cut = memory_allocate(cuts, sizeof *cut, "cuts of a bisection");
    bool good = get_common(r, CHECKPOINT_CUTS, FIELD_DOUBLE, cuts, CHECKPOINT_CUT, row, error);
    for (size_t k = 0; k < cuts; k++)
        cut[k] = (struct domain_cut){row[k][0], small_integer(row[k][1]), small_integer(row[k][2])};
    if (good && !(r->loaded->tree = domain_tree_from_cuts(ranks, cut, lowest, highest)))
        good =
            error_set(error, ERROR_USER, "%s: %s: holds impossible numbers", r->file.path, CHECKPOINT_CUTS);
    memory_free(row);
    memory_free(cut);
    return good;
}

static bool get_surroundings(struct reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    double lengths[6];
    int32_t sides[CHECKPOINT_SIDES];
    if (!get_common(r, "/box/origin_edge", FIELD_DOUBLE, 6, 0, lengths, error) ||
        !get_common(r, "/box/sides", FIELD_INT32, CHECKPOINT_SIDES, 0, sides, error))
        return false;
    l->box.dimension = sides[0];
    for (int d = 0; d < 3; d++) {
        l->box.origin[d] = lengths[d];
        l->box.edge[d] = lengths[3 + d];
        l->box.periodic[d] = sides[1 + d] != 0;
        l->box.leave[d][0] = (enum box_leave)sides[4 + 2 * d];
        l->box.leave[d][1] = (enum box_leave)sides[5 + 2 * d];
    }
    l->scene = get_text(r, "/scene", error);
    return l->scene != NULL;
}

static bool get_walls(struct reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    uint64_t count = (uint64_t)l->walls;
    l->wall = memory_allocate_zero(count, sizeof *l->wall, "walls of a checkpoint");
    double(*pose)[CHECKPOINT_POSE] = memory_allocate(count, sizeof *pose, "wall poses");
    char(*name)[WALL_NAME_MAX] = memory_allocate(count, sizeof *name, "wall names");
    bool good = get_common(r, "/walls/pose", FIELD_DOUBLE, count, CHECKPOINT_POSE, pose, error) &&
                get_common(r, "/walls/name", FIELD_UINT8, count, WALL_NAME_MAX, name, error);
    for (uint64_t k = 0; good && k < count; k++) {
        memcpy(&l->wall[k].pose, pose[k], sizeof l->wall[k].pose);
        if (r->comm->rank > 0) /* sums over ranks are the first one's part */
            memset(l->wall[k].pose.force, 0, sizeof l->wall[k].pose.force);
        memcpy(l->wall[k].name, name[k], WALL_NAME_MAX - 1);
    }
    memory_free(pose);
    memory_free(name);
    return good;
}

/* Which particles are this rank's. */
static bool get_share(struct reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    uint64_t size = (uint64_t)r->comm->size, rank = (uint64_t)r->comm->rank;
    r->first = l->total / size * rank + (rank < l->total % size ? rank : l->total % size);
    r->count = l->total / size + (rank < l->total % size);
    if (!l->same_layout)
        return true;
    int64_t *owned = memory_allocate(size, sizeof *owned, "particles of ranks");
    bool good = get_common(r, "/run/particles_of_ranks", FIELD_INT64, size, 0, owned, error);
    r->first = 0;
    for (uint64_t k = 0; good && k < rank; k++)
        r->first += (uint64_t)owned[k];
    r->count = good ? (uint64_t)owned[rank] : 0;
    memory_free(owned);
    if (good && r->first + r->count > l->total)
        error_set(error, ERROR_USER, "%s: /run/particles_of_ranks: does not fit the number of particles",
                  r->file.path);
    return comm_agree(r->comm, error);
}

static bool get_field(struct reading *r, struct particles *p, int f, struct error *error) {
    const struct field *field = fields_get(p, f);
    size_t stride, bytes = fields_bytes(field);
    char *base = fields_base(p, f, &stride);
    char *data = memory_allocate(r->count, bytes, "field of a checkpoint");
    struct h5_table table = {.type = field->type,
                             .rows = r->loaded->total,
                             .width = field->components > 1 ? (uint64_t)field->components : 0,
                             .first = r->first,
                             .count = r->count};
    char name[OUTPUT_NAME_MAX];
    checkpoint_field_name(field, name);
    r->loaded->field_read[f] = h5_exists(&r->h5, name);
    bool good = !r->loaded->field_read[f] || get(r, name, &table, data, error);
    for (size_t i = 0; good && r->loaded->field_read[f] && i < r->count; i++)
        memcpy(base + i * stride, data + i * bytes, bytes);
    memory_free(data);
    return good;
}

/* Density and inverse mass where the sets differ in having groups. */
static bool complete_masses(struct reading *r, struct particles *p, struct error *error) {
    double *kept = groups_densities(p);
    bool written = h5_exists(&r->h5, "/particles/density");
    if (written == (kept != NULL))
        return true;
    if (kept) {
        for (size_t i = 0; i < r->count; i++)
            kept[i] = 1 / (p->state[i].inverse_mass * particles_sphere_mass(p->state[i].radius, 1));
        return true;
    }
    struct h5_table table = {
        .type = FIELD_DOUBLE, .rows = r->loaded->total, .first = r->first, .count = r->count};
    double *density = memory_allocate(r->count, sizeof *density, "densities");
    bool good = get(r, "/particles/density", &table, density, error);
    for (size_t i = 0; good && i < r->count; i++)
        if (p->state[i].inverse_mass == 0)
            p->state[i].inverse_mass = 1 / particles_sphere_mass(p->state[i].radius, density[i]);
    memory_free(density);
    return good;
}

static bool get_particles(struct reading *r, struct particles *p, struct error *error) {
    particles_reserve(p, r->count);
    for (uint64_t i = 0; i < r->count; i++)
        particles_append(p);
    bool good = true;
    const struct field_list fields = fields_with(p, FIELD_RESTART);
    for (int k = 0; good && k < fields.count; k++)
        good = get_field(r, p, fields.field[k], error);
    return good && complete_masses(r, p, error);
}

/* The rows that belong to this rank's particles: fills start, and the place of the rows in their tables. */
static bool get_starts(struct reading *r, const char *counts, const char *rows, size_t **start,
                       struct h5_table *place, struct error *error) {
    struct h5_table table = {
        .type = FIELD_INT32, .rows = r->loaded->total, .first = r->first, .count = r->count};
    int32_t *count = memory_allocate(r->count, sizeof *count, "history counts");
    bool good = get(r, counts, &table, count, error);
    *start = memory_allocate(r->count + 1, sizeof **start, "history rows");
    (*start)[0] = 0;
    for (uint64_t i = 0; i < r->count; i++)
        (*start)[i + 1] = (*start)[i] + (good && count[i] > 0 ? (size_t)count[i] : 0);
    memory_free(count);
    const struct checkpoint_entry *entry = checkpoint_file_find(&r->file, rows);
    size_t mine = (*start)[r->count];
    *place = (struct h5_table){.rows = entry && entry->row_bytes > 0 ? entry->bytes / entry->row_bytes : 0,
                               .count = mine,
                               .first = (uint64_t)comm_scan(r->comm, (int64_t)mine)};
    if (good && place->first + place->count > place->rows)
        error_set(error, ERROR_USER, "%s: %s: holds fewer rows than %s says", r->file.path, rows, counts);
    return comm_agree(r->comm, error);
}

static bool get_history(struct reading *r, const struct particles *p, struct error *error) {
    struct history_rows *rows = &r->loaded->history;
    struct h5_table place;
    if (!get_starts(r, "/history/count", "/history/partner", &rows->start, &place, error))
        return false;
    int64_t *partner = memory_allocate(place.count, sizeof *partner, "history rows");
    double(*value)[CHECKPOINT_HISTORY] = memory_allocate(place.count, sizeof *value, "history rows");
    place.type = FIELD_INT64;
    bool good = get(r, "/history/partner", &place, partner, error);
    place.type = FIELD_DOUBLE;
    place.width = CHECKPOINT_HISTORY;
    good = good && get(r, "/history/value_separation", &place, value, error);
    rows->count = good ? place.count : 0;
    rows->row = memory_allocate_zero(rows->count, sizeof *rows->row, "history rows");
    for (uint64_t i = 0; good && i < r->count; i++)
        for (size_t k = rows->start[i]; k < rows->start[i + 1]; k++) {
            rows->row[k].id = p->id[i];
            rows->row[k].partner = partner[k];
            memcpy(rows->row[k].value, value[k], sizeof rows->row[k].value);
            memcpy(rows->row[k].separation, value[k] + HISTORY_COMPONENTS_MAX,
                   sizeof rows->row[k].separation);
        }
    memory_free(partner);
    memory_free(value);
    return good;
}

static bool get_wall_history(struct reading *r, const struct particles *p, struct error *error) {
    struct wall_rows *rows = &r->loaded->wall_history;
    struct h5_table place;
    if (!get_starts(r, "/wall_history/count", "/wall_history/wall_patch", &rows->start, &place, error))
        return false;
    int32_t(*where)[2] = memory_allocate(place.count, sizeof *where, "wall history rows");
    double(*value)[HISTORY_COMPONENTS_MAX] = memory_allocate(place.count, sizeof *value, "wall history rows");
    place.type = FIELD_INT32;
    place.width = 2;
    bool good = get(r, "/wall_history/wall_patch", &place, where, error);
    place.type = FIELD_DOUBLE;
    place.width = HISTORY_COMPONENTS_MAX;
    good = good && get(r, "/wall_history/value", &place, value, error);
    rows->count = good ? place.count : 0;
    rows->row = memory_allocate_zero(rows->count, sizeof *rows->row, "wall history rows");
    for (uint64_t i = 0; good && i < r->count; i++)
        for (size_t k = rows->start[i]; k < rows->start[i + 1]; k++) {
            rows->row[k] = (struct wall_row){.id = p->id[i], .wall = where[k][0], .patch = where[k][1]};
            memcpy(rows->row[k].value, value[k], sizeof value[k]);
        }
    memory_free(where);
    memory_free(value);
    return good;
}

static bool get_head(struct reading *r, struct error *error) {
    return get_numbers(r, error) && get_sums(r, error) && get_tree(r, error) && get_surroundings(r, error) &&
           get_walls(r, error);
}

static bool get_rest(struct reading *r, struct particles *particles, struct error *error) {
    if (!get_share(r, error) || !get_particles(r, particles, error))
        return false;
    if (checkpoint_file_find(&r->file, "/history/count") && !get_history(r, particles, error))
        return false;
    return !checkpoint_file_find(&r->file, "/wall_history/count") || get_wall_history(r, particles, error);
}

bool checkpoint_read_head(const struct comm *comm, const char *path, struct checkpoint_loaded *loaded,
                          struct error *error) {
    *loaded = (struct checkpoint_loaded){0};
    struct reading r = {.comm = comm, .loaded = loaded};
    if (!checkpoint_file_open(&r.file, comm, path, error))
        return false;
    bool good = get_head(&r, error);
    checkpoint_file_close(&r.file);
    if (!good)
        checkpoint_loaded_free(loaded);
    return good;
}

bool checkpoint_read(const struct comm *comm, const char *path, struct particles *particles,
                     struct checkpoint_loaded *loaded, struct error *error) {
    *loaded = (struct checkpoint_loaded){0};
    struct reading r = {.comm = comm, .loaded = loaded};
    if (!checkpoint_file_open(&r.file, comm, path, error))
        return false;
    bool good =
        get_head(&r, error) && get_rest(&r, particles, error) && checkpoint_file_compare(&r.file, error);
    checkpoint_file_close(&r.file);
    if (!good)
        checkpoint_loaded_free(loaded);
    return good;
}

void checkpoint_loaded_free(struct checkpoint_loaded *loaded) {
    history_rows_free(&loaded->history);
    wall_rows_free(&loaded->wall_history);
    domain_tree_destroy(&loaded->tree);
    memory_free(loaded->wall);
    memory_free(loaded->scene);
    *loaded = (struct checkpoint_loaded){0};
}
