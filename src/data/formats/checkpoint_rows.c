/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes or reads the fields of particles and the rows of contacts. Every dataset is a table of rows: the rows of a
 * rank lie together, in the order of the ranks. Read checkpoint_parts.h first. */
#include "data/formats/checkpoint_parts.h"
#include "data/formats/checkpoint_names.h"

#include "base/memory.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/spin.h"

#include <string.h>

/* The form of a table with a row a particle. */
static struct h5_table of_particles(const struct checkpoint_io *io, enum field_type type, int components) {
    return (struct h5_table){.type = type,
                             .rows = io->total,
                             .width = components > 1 ? (uint64_t)components : 0,
                             .first = io->first,
                             .count = io->count};
}

static bool field_rows(struct checkpoint_io *io, struct particles *p, int f, struct error *error) {
    const struct field *field = fields_get(p, f);
    size_t stride, bytes = fields_bytes(field);
    char *base = fields_base(p, f, &stride);
    char *data = memory_allocate(io->count, bytes, "field of a checkpoint");
    struct h5_table table = of_particles(io, field->type, field->components);
    char name[OUTPUT_NAME_MAX];
    checkpoint_field_name(field, name);
    size_t given = io->written ? io->count : 0;
#pragma omp parallel for
    for (size_t i = 0; i < given; i++)
        memcpy(data + i * bytes, base + i * stride, bytes);
    bool good = checkpoint_io_rows(io, name, &table, data, error);
    for (size_t i = 0; good && io->written == NULL && i < io->count; i++)
        memcpy(base + i * stride, data + i * bytes, bytes);
    memory_free(data);
    return good;
}

/* The fields that a resume needs; of those the file may lack some. */
static bool fields(struct checkpoint_io *io, struct particles *p, struct checkpoint_loaded *state,
                   struct error *error) {
    const struct field_list list = fields_with(p, FIELD_RESTART);
    bool good = true;
    for (int k = 0; good && k < list.count; k++) {
        char name[OUTPUT_NAME_MAX];
        int f = list.field[k];
        checkpoint_field_name(fields_get(p, f), name);
        state->field_read[f] = io->written || checkpoint_io_has(io, name);
        good = !state->field_read[f] || field_rows(io, p, f, error);
    }
    return good;
}

/* Writes velocities at the full step; or where they are to be read, and the file has them, puts them in the place of those that were
 * read. */
static bool full_rows(struct checkpoint_io *io, struct particles *p, struct error *error) {
    const struct checkpoint_entry *entry = checkpoint_file_find(&io->file, CHECKPOINT_FULL);
    const struct integrator_context *motion = io->written ? io->written->motion : NULL;
    double(*omega)[4] = spin_of(p);
    if (io->written ? motion == NULL : !io->full || entry == NULL)
        return true;
    const size_t width = io->written ? checkpoint_full_width(p) : entry->row_bytes / sizeof(double);
    if (width != 3 && width != 6)
        return error_set(error, ERROR_USER, "%s: %s: has rows of an unknown width", io->file.path,
                         CHECKPOINT_FULL);
    struct h5_table table = of_particles(io, FIELD_DOUBLE, (int)width);
    double *data = memory_allocate(io->count * width, sizeof *data, "velocities of a checkpoint");
    const size_t given = io->written ? io->count : 0;
#pragma omp parallel for
    for (size_t i = 0; i < given; i++)
        integrator_full_step(p, motion, i, data + i * width, omega ? data + i * width + 3 : NULL);
    bool good = checkpoint_io_rows(io, CHECKPOINT_FULL, &table, data, error);
    for (size_t i = 0; good && io->written == NULL && i < io->count; i++) {
        memcpy(p->state[i].v, data + i * width, sizeof p->state[i].v);
        if (omega && width == 6)
            memcpy(omega[i], data + i * width + 3, 3 * sizeof *data);
    }
    memory_free(data);
    return good;
}

/* The rows of particles: their numbers, in the dataset `counts`, to or from `start`; and the place of this rank's `mine`
 * rows among those of all ranks, in the table `rows`. */
static bool starts(struct checkpoint_io *io, const char *counts, const char *rows, size_t **start,
                   size_t mine, struct h5_table *place, struct error *error) {
    struct h5_table table = of_particles(io, FIELD_INT32, 1);
    int32_t *count = memory_allocate(io->count, sizeof *count, "history counts");
    for (size_t i = 0; io->written && i < io->count; i++)
        count[i] = (int32_t)((*start)[i + 1] - (*start)[i]);
    bool good = checkpoint_io_rows(io, counts, &table, count, error);
    if (io->written == NULL) {
        *start = memory_allocate_zero(io->count + 1, sizeof **start, "history rows");
        for (uint64_t i = 0; i < io->count; i++)
            (*start)[i + 1] = (*start)[i] + (good && count[i] > 0 ? (size_t)count[i] : 0);
        mine = (*start)[io->count];
    }
    memory_free(count);
    int64_t total = (int64_t)mine, first = comm_scan(io->comm, total);
    comm_sum_int(io->comm, &total, 1);
    const struct checkpoint_entry *entry = checkpoint_file_find(&io->file, rows);
    *place = (struct h5_table){.rows = (uint64_t)total, .first = (uint64_t)first, .count = mine};
    if (io->written == NULL)
        place->rows = entry && entry->row_bytes > 0 ? entry->bytes / entry->row_bytes : 0;
    if (good && place->first + place->count > place->rows)
        error_set(error, ERROR_USER, "%s: %s: holds fewer rows than %s says", io->file.path, rows, counts);
    return comm_agree(io->comm, error) && good;
}

/* The rows of pairs of a group: "history", or a physics. */
static bool pair_rows(struct checkpoint_io *io, const char *group, const struct particles *p,
                      struct history_rows *rows, struct error *error) {
    char name[CHECKPOINT_ROWS_NAMES][OUTPUT_NAME_MAX];
    struct h5_table place;
    checkpoint_rows_names(group, name);
    if (!starts(io, name[CHECKPOINT_ROWS_COUNT], name[CHECKPOINT_ROWS_PARTNER], &rows->start, rows->count,
                &place, error))
        return false;
    if (io->written == NULL)
        rows->row = memory_allocate_zero(place.count, sizeof *rows->row, "history rows");
    size_t width = checkpoint_history_width(rows->components),
           doubles = io->written ? (size_t)rows->components : width;
    int64_t *partner = memory_allocate(place.count, sizeof *partner, "history rows");
    double *value = memory_allocate_zero(place.count * (width + 3), sizeof *value, "history rows");
    for (size_t k = 0; io->written && k < place.count; k++) {
        double *to = value + k * (width + 3);
        partner[k] = rows->row[k].partner;
        memcpy(to, rows->row[k].value, doubles * sizeof *to);
        memcpy(to + width, rows->row[k].separation, sizeof rows->row[k].separation);
    }
    place.type = FIELD_INT64;
    bool good = checkpoint_io_rows(io, name[CHECKPOINT_ROWS_PARTNER], &place, partner, error);
    place.type = FIELD_DOUBLE;
    place.width = width + 3;
    good = good && checkpoint_io_rows(io, name[CHECKPOINT_ROWS_VALUE], &place, value, error);
    for (uint64_t i = 0; good && io->written == NULL && i < io->count; i++)
        for (size_t k = rows->start[i]; k < rows->start[i + 1]; k++) {
            const double *from = value + k * (width + 3);
            rows->row[k].id = p->id[i];
            rows->row[k].partner = partner[k];
            memcpy(rows->row[k].value, from, doubles * sizeof *from);
            memcpy(rows->row[k].separation, from + width, sizeof rows->row[k].separation);
        }
    rows->count = good ? place.count : 0;
    memory_free(partner);
    memory_free(value);
    return good;
}

static bool wall_rows(struct checkpoint_io *io, const struct particles *p, struct history_rows *rows,
                      struct error *error) {
    struct h5_table place;
    if (!starts(io, "/wall_history/count", "/wall_history/wall_patch", &rows->start, rows->count, &place,
                error))
        return false;
    if (io->written == NULL)
        rows->row = memory_allocate_zero(place.count, sizeof *rows->row, "wall history rows");
    struct history_row *row = rows->row;
    size_t width = checkpoint_history_width(rows->components),
           doubles = io->written ? (size_t)rows->components : width;
    int32_t(*where)[2] = memory_allocate(place.count, sizeof *where, "wall history rows");
    double *value = memory_allocate_zero(place.count * width, sizeof *value, "wall history rows");
    for (size_t k = 0; io->written && k < place.count; k++) {
        where[k][0] = wall_row_wall(&row[k]);
        where[k][1] = wall_row_feature(&row[k]);
        memcpy(value + k * width, row[k].value, doubles * sizeof *value);
    }
    place.type = FIELD_INT32;
    place.width = 2;
    bool good = checkpoint_io_rows(io, "/wall_history/wall_patch", &place, where, error);
    place.type = FIELD_DOUBLE;
    place.width = width;
    good = good && checkpoint_io_rows(io, "/wall_history/value", &place, value, error);
    for (uint64_t i = 0; good && io->written == NULL && i < io->count; i++)
        for (size_t k = rows->start[i]; k < rows->start[i + 1]; k++) {
            row[k].id = p->id[i];
            row[k].partner = wall_row_partner(where[k][0], where[k][1]);
            memcpy(row[k].value, value + k * width, doubles * sizeof *value);
        }
    rows->count = good ? place.count : 0;
    memory_free(where);
    memory_free(value);
    return good;
}

/* The rows of physics. When read, the width of their values tells how many doubles count, but for the usual ones. */
static bool carried_rows(struct checkpoint_io *io, const struct particles *p, struct checkpoint_loaded *state,
                         struct error *error) {
    bool good = true;
    for (int k = 0; good && k < PHYSICS_COUNT; k++) {
        char name[CHECKPOINT_ROWS_NAMES][OUTPUT_NAME_MAX];
        checkpoint_rows_names(checkpoint_physics_names[k], name);
        if (io->written ? !io->written->carried || !io->written->carried[k]
                        : !checkpoint_io_has(io, name[CHECKPOINT_ROWS_VALUE]))
            continue;
        if (io->written == NULL) {
            const struct checkpoint_entry *entry =
                checkpoint_file_find(&io->file, name[CHECKPOINT_ROWS_VALUE]);
            size_t width = entry->row_bytes / sizeof(double);
            if (width < HISTORY_COMPONENTS_USUAL + 3 || width > HISTORY_COMPONENTS_MAX + 3)
                return error_set(error, ERROR_USER, "%s: %s: has rows of an unknown width", io->file.path,
                                 name[CHECKPOINT_ROWS_VALUE]);
            state->carried[k].components = (int)width - 3;
        }
        good = pair_rows(io, checkpoint_physics_names[k], p, &state->carried[k], error);
    }
    return good;
}

/* The rows of contacts. Either every rank writes some, or no rank: the law decides. */
static bool contact_rows(struct checkpoint_io *io, const struct particles *p, struct checkpoint_loaded *state,
                         struct error *error) {
    const struct checkpoint *c = io->written;
    bool pairs = c ? c->history != NULL : checkpoint_io_has(io, "/history/count"),
         walls = c ? c->wall_history != NULL : checkpoint_io_has(io, "/wall_history/count");
    if (io->written == NULL)
        state->history.components = state->wall_history.components = state->history_components;
    return (!pairs || pair_rows(io, "history", p, &state->history, error)) &&
           (!walls || wall_rows(io, p, &state->wall_history, error)) && carried_rows(io, p, state, error);
}

/* Computes density and inverse mass, if only one of file and set has groups. */
static bool complete_masses(struct checkpoint_io *io, struct particles *p, struct error *error) {
    double *kept = groups_densities(p);
    if (checkpoint_io_has(io, "/particles/density") == (kept != NULL))
        return true;
    if (kept) {
        for (size_t i = 0; i < io->count; i++)
            kept[i] = 1 / (p->state[i].inverse_mass * particles_sphere_mass(p->state[i].radius, 1));
        return true;
    }
    struct h5_table table = of_particles(io, FIELD_DOUBLE, 1);
    double *density = memory_allocate(io->count, sizeof *density, "densities");
    bool good = checkpoint_io_rows(io, "/particles/density", &table, density, error);
    for (size_t i = 0; good && i < io->count; i++)
        if (p->state[i].inverse_mass == 0)
            p->state[i].inverse_mass = 1 / particles_sphere_mass(p->state[i].radius, density[i]);
    memory_free(density);
    return good;
}

/* Counts the particles of all ranks in each material or group; without numbers, all particles count for the
 * first. */
static bool count_kind(struct checkpoint_io *io, const char *dataset, struct checkpoint_kind *kind, int kinds,
                       struct error *error) {
    enum { NUMBERS = UINT8_MAX + 1 };
    int64_t count[NUMBERS] = {0};
    struct h5_table table = of_particles(io, FIELD_UINT8, 1);
    uint8_t *number = memory_allocate_zero(io->count, sizeof *number, "materials or groups");
    bool good = !checkpoint_io_has(io, dataset) || checkpoint_io_rows(io, dataset, &table, number, error);
    for (uint64_t i = 0; good && i < io->count; i++)
        count[number[i]]++;
    memory_free(number);
    comm_sum_int(io->comm, count, NUMBERS);
    for (int k = 0; k < kinds; k++)
        kind[k].particles = count[k];
    for (int k = kinds; good && kinds > 0 && k < NUMBERS; k++)
        if (count[k] > 0)
            return error_set(error, ERROR_USER, "%s: %s: holds impossible numbers", io->file.path, dataset);
    return good;
}

bool checkpoint_rows(struct checkpoint_io *io, struct particles *p, struct checkpoint_loaded *state,
                     struct error *error) {
    bool good = fields(io, p, state, error) && full_rows(io, p, error);
    if (good && io->written == NULL)
        good = complete_masses(io, p, error) &&
               count_kind(io, "/particles/material", state->material, state->materials, error) &&
               count_kind(io, "/particles/group", state->group, state->groups, error);
    return good && contact_rows(io, p, state, error);
}
