/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads checkpoints by plain reads (checkpoint_file.h). The bytes of the file agree with the table at this
 * point. The shape of each dataset is still checked, as the file may come from a different program. */
#include "data/formats/checkpoint.h"
#include "data/formats/checkpoint_names.h"
#include "data/formats/checkpoint_read_head.h"

#include "base/memory.h"
#include "data/formats/checkpoint_file.h"
#include "data/formats/h5.h"
#include "kernel/particles/groups.h"

#include <string.h>

/* The bytes of a row of `width` values (width 0: one value). */
static size_t row_bytes(enum field_type type, uint64_t width) {
    return checkpoint_type_bytes(type) * (width ? width : 1);
}

/* Reads rows [first, first + count) of a table; the rows of all ranks together are the whole table. */
static bool get(struct checkpoint_reading *r, const char *name, const struct h5_table *table, void *data,
                struct error *error) {
    struct checkpoint_rows rows = {.dataset = name,
                                   .row_bytes = row_bytes(table->type, table->width),
                                   .rows = table->rows,
                                   .first = table->first,
                                   .count = table->count};
    return checkpoint_file_read(&r->file, &rows, data, error);
}

/* Finds the particles of this rank. */
static bool get_share(struct checkpoint_reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    uint64_t size = (uint64_t)r->comm->size, rank = (uint64_t)r->comm->rank;
    r->first = l->total / size * rank + (rank < l->total % size ? rank : l->total % size);
    r->count = l->total / size + (rank < l->total % size);
    if (!l->same_layout)
        return true;
    int64_t *owned = memory_allocate(size, sizeof *owned, "particles of ranks");
    bool good = checkpoint_get_common(r, "/run/particles_of_ranks", FIELD_INT64, size, 0, owned, error);
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

static bool get_field(struct checkpoint_reading *r, struct particles *p, int f, struct error *error) {
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
    r->loaded->field_read[f] = checkpoint_file_find(&r->file, name) != NULL;
    bool good = !r->loaded->field_read[f] || get(r, name, &table, data, error);
    for (size_t i = 0; good && r->loaded->field_read[f] && i < r->count; i++)
        memcpy(base + i * stride, data + i * bytes, bytes);
    memory_free(data);
    return good;
}

/* Computes density and inverse mass, if only one of file and set has groups. */
static bool complete_masses(struct checkpoint_reading *r, struct particles *p, struct error *error) {
    double *kept = groups_densities(p);
    bool written = checkpoint_file_find(&r->file, "/particles/density") != NULL;
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

static bool get_particles(struct checkpoint_reading *r, struct particles *p, struct error *error) {
    particles_reserve(p, r->count);
    for (uint64_t i = 0; i < r->count; i++)
        particles_append(p);
    bool good = true;
    const struct field_list fields = fields_with(p, FIELD_RESTART);
    for (int k = 0; good && k < fields.count; k++)
        good = get_field(r, p, fields.field[k], error);
    return good && complete_masses(r, p, error);
}

/* Finds the rows of this rank's particles: fills start, and the place of the rows in their tables. */
static bool get_starts(struct checkpoint_reading *r, const char *counts, const char *rows, size_t **start,
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

/* Fills rows but for their partners: the id of their particle, and what put_values has written. */
static bool get_values(struct checkpoint_reading *r, const char *name, struct h5_table place, size_t apart,
                       const struct particles *p, struct history_rows *rows, struct error *error) {
    size_t width = checkpoint_history_width(rows->components) + apart;
    double *value = memory_allocate(place.count * width, sizeof *value, "history rows");
    place.type = FIELD_DOUBLE;
    place.width = width;
    bool good = get(r, name, &place, value, error);
    rows->count = good ? place.count : 0;
    for (uint64_t i = 0; good && i < r->count; i++)
        for (size_t k = rows->start[i]; k < rows->start[i + 1]; k++) {
            const double *from = value + k * width;
            rows->row[k].id = p->id[i];
            memcpy(rows->row[k].value, from, (width - apart) * sizeof *from);
            memcpy(rows->row[k].separation, from + width - apart, apart * sizeof *from);
        }
    memory_free(value);
    return good;
}

/* Reads the rows of pairs of a group; `components` is that of the file. */
static bool get_rows(struct checkpoint_reading *r, const char *group, const struct particles *p,
                     int components, struct history_rows *rows, struct error *error) {
    char name[CHECKPOINT_ROWS_NAMES][OUTPUT_NAME_MAX];
    checkpoint_rows_names(group, name);
    struct h5_table place;
    rows->components = components;
    if (!get_starts(r, name[CHECKPOINT_ROWS_COUNT], name[CHECKPOINT_ROWS_PARTNER], &rows->start, &place,
                    error))
        return false;
    int64_t *partner = memory_allocate(place.count, sizeof *partner, "history rows");
    rows->row = memory_allocate_zero(place.count, sizeof *rows->row, "history rows");
    place.type = FIELD_INT64;
    bool good = get(r, name[CHECKPOINT_ROWS_PARTNER], &place, partner, error);
    for (size_t k = 0; good && k < place.count; k++)
        rows->row[k].partner = partner[k];
    memory_free(partner);
    return good && get_values(r, name[CHECKPOINT_ROWS_VALUE], place, 3, p, rows, error);
}

static bool get_wall_history(struct checkpoint_reading *r, const struct particles *p, struct error *error) {
    struct history_rows *rows = &r->loaded->wall_history;
    struct h5_table place;
    rows->components = r->loaded->history_components;
    if (!get_starts(r, "/wall_history/count", "/wall_history/wall_patch", &rows->start, &place, error))
        return false;
    int32_t(*where)[2] = memory_allocate(place.count, sizeof *where, "wall history rows");
    rows->row = memory_allocate_zero(place.count, sizeof *rows->row, "wall history rows");
    place.type = FIELD_INT32;
    place.width = 2;
    bool good = get(r, "/wall_history/wall_patch", &place, where, error);
    for (size_t k = 0; good && k < place.count; k++)
        rows->row[k].partner = wall_row_partner(where[k][0], where[k][1]);
    memory_free(where);
    return good && get_values(r, "/wall_history/value", place, 0, p, rows, error);
}

/* Counts the particles of all ranks in each material or group; without numbers, all particles count for the
 * first. */
static bool count_kind(struct checkpoint_reading *r, const char *dataset, struct checkpoint_kind *kind,
                       int kinds, struct error *error) {
    enum { NUMBERS = UINT8_MAX + 1 };
    int64_t count[NUMBERS] = {0};
    struct h5_table table = {
        .type = FIELD_UINT8, .rows = r->loaded->total, .first = r->first, .count = r->count};
    uint8_t *number = memory_allocate_zero(r->count, sizeof *number, "materials or groups");
    bool good = !checkpoint_file_find(&r->file, dataset) || get(r, dataset, &table, number, error);
    for (uint64_t i = 0; good && i < r->count; i++)
        count[number[i]]++;
    memory_free(number);
    comm_sum_int(r->comm, count, NUMBERS);
    for (int k = 0; k < kinds; k++)
        kind[k].particles = count[k];
    for (int k = kinds; good && kinds > 0 && k < NUMBERS; k++)
        if (count[k] > 0)
            return error_set(error, ERROR_USER, "%s: %s: holds impossible numbers", r->file.path, dataset);
    return good;
}

/* Reads the rows of physics. The width of their values tells how many doubles count, but for the usual ones. */
static bool get_carried(struct checkpoint_reading *r, const struct particles *p, struct error *error) {
    bool good = true;
    for (int k = 0; good && k < PHYSICS_COUNT; k++) {
        char name[CHECKPOINT_ROWS_NAMES][OUTPUT_NAME_MAX];
        checkpoint_rows_names(checkpoint_physics_names[k], name);
        const struct checkpoint_entry *entry = checkpoint_file_find(&r->file, name[CHECKPOINT_ROWS_VALUE]);
        if (entry == NULL)
            continue;
        size_t width = entry->row_bytes / sizeof(double);
        if (width < HISTORY_COMPONENTS_USUAL + 3 || width > HISTORY_COMPONENTS_MAX + 3)
            return error_set(error, ERROR_USER, "%s: %s: has rows of an unknown width", r->file.path,
                             name[CHECKPOINT_ROWS_VALUE]);
        good = get_rows(r, checkpoint_physics_names[k], p, (int)width - 3, &r->loaded->carried[k], error);
    }
    return good;
}

static bool get_rest(struct checkpoint_reading *r, struct particles *particles, struct error *error) {
    if (!get_share(r, error) || !get_particles(r, particles, error) ||
        !count_kind(r, "/particles/material", r->loaded->material, r->loaded->materials, error) ||
        !count_kind(r, "/particles/group", r->loaded->group, r->loaded->groups, error))
        return false;
    if (checkpoint_file_find(&r->file, "/history/count") &&
        !get_rows(r, "history", particles, r->loaded->history_components, &r->loaded->history, error))
        return false;
    if (checkpoint_file_find(&r->file, "/wall_history/count") && !get_wall_history(r, particles, error))
        return false;
    return get_carried(r, particles, error);
}

bool checkpoint_read_head(const struct comm *comm, const char *path, struct checkpoint_loaded *loaded,
                          struct error *error) {
    *loaded = (struct checkpoint_loaded){0};
    struct checkpoint_reading r = {.comm = comm, .loaded = loaded};
    if (!checkpoint_file_open(&r.file, comm, path, error))
        return false;
    bool good = checkpoint_get_head(&r, error);
    checkpoint_file_close(&r.file);
    if (!good)
        checkpoint_loaded_free(loaded);
    return good;
}

bool checkpoint_read(const struct comm *comm, const char *path, struct particles *particles,
                     struct checkpoint_loaded *loaded, struct error *error) {
    *loaded = (struct checkpoint_loaded){0};
    struct checkpoint_reading r = {.comm = comm, .loaded = loaded};
    if (!checkpoint_file_open(&r.file, comm, path, error))
        return false;
    bool good = checkpoint_get_head(&r, error) && get_rest(&r, particles, error) &&
                checkpoint_file_compare(&r.file, error);
    checkpoint_file_close(&r.file);
    if (!good)
        checkpoint_loaded_free(loaded);
    return good;
}

void checkpoint_loaded_free(struct checkpoint_loaded *loaded) {
    history_rows_free(&loaded->history);
    history_rows_free(&loaded->wall_history);
    for (int k = 0; k < PHYSICS_COUNT; k++)
        history_rows_free(&loaded->carried[k]);
    domain_tree_destroy(&loaded->tree);
    restart_values_free(&loaded->restart);
    lineage_free(&loaded->lineage);
    memory_free(loaded->wall);
    memory_free(loaded->material);
    memory_free(loaded->group);
    memory_free(loaded->law);
    memory_free(loaded->scene);
    *loaded = (struct checkpoint_loaded){0};
}
