/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds elements, moments and boxes in H5MD files and reads them. Read h5md_read.h first. */
#include "data/formats/h5md_read.h"

#include "base/memory.h"
#include "data/formats/h5md_element.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The group being read. */
struct source {
    struct h5 h5;
    const struct comm *comm;   /* NULL: one rank reads all */
    char group[FILE_PATH_MAX]; /* "/particles/all" */
    int64_t wanted;            /* frame, negative from the end */
    uint64_t frame, frames;
    int dimension;
    uint64_t total, first, count; /* rows in the file; this rank's */
};

static bool find_group(struct source *s, const char *name, struct error *error) {
    struct h5_names names;
    if (!h5_is_group(&s->h5, "/particles"))
        return error_set(error, ERROR_USER,
                         "%s: /particles: there is no such group; this is not an H5MD file", s->h5.path);
    if (h5_exists(&s->h5, "/run/integers"))
        return error_set(error, ERROR_USER,
                         "%s: is a checkpoint; `scree convert CHECKPOINT.h5 OUT.h5` makes an H5MD file of it",
                         s->h5.path);
    bool good = h5_list(&s->h5, "/particles", &names, error);
    const char *found = NULL;
    char known[512] = "";
    for (size_t k = 0; good && k < names.count; k++) {
        const char *want = name ? name : "all";
        if (strcmp(names.name[k], want) == 0 || (!name && names.count == 1))
            found = names.name[k];
        size_t used = strlen(known);
        snprintf(known + used, sizeof known - used, "%s%s", used ? ", " : "", names.name[k]);
    }
    if (found)
        snprintf(s->group, sizeof s->group, "/particles/%s", found);
    else if (good)
        error_set(error, ERROR_USER, "%s: /particles: has no group \"%s\"; it has: %s", s->h5.path,
                  name ? name : "all", known[0] ? known : "nothing");
    memory_free(names.name);
    return found != NULL;
}

static bool refuse_shape(const struct source *s, const struct h5md_found *element, const char *wanted,
                         struct error *error) {
    char shape[128] = "";
    for (int d = 0; d < element->shape.rank; d++) {
        size_t used = strlen(shape);
        snprintf(shape + used, sizeof shape - used, "[%" PRIu64 "]", (uint64_t)element->shape.size[d]);
    }
    return error_set(error, ERROR_USER, "%s: %s: its dimensions are %s, where %s is wanted", s->h5.path,
                     element->dataset, shape[0] ? shape : "those of a single value", wanted);
}

/* Reads this rank's rows of an element into data (rows x in_memory values; of vectors a 2D file leaves the last value
 * unchanged). */
static bool read_element(const struct source *s, const struct h5md_found *element, enum field_type type,
                         int in_memory, void *data, struct error *error) {
    int lead = element->frames;
    uint64_t width = h5md_found_width(element);
    char wanted[96];
    snprintf(wanted, sizeof wanted, "%s[%" PRIu64 "]%s", element->frames ? "[frames]" : "", s->total,
             in_memory == 3  ? "[2 or 3]"
             : in_memory > 1 ? "[4]"
                             : "");
    bool fits = element->shape.rank == lead + 1 + (in_memory > 1) && element->shape.size[lead] == s->total &&
                (in_memory == 1 || width == (uint64_t)in_memory || (in_memory == 3 && width == 2));
    if (!fits || (element->shape.type != H5T_FLOAT && element->shape.type != H5T_INTEGER &&
                  element->shape.type != H5T_ENUM))
        return refuse_shape(s, element, wanted, error);
    if (element->frames && s->frame >= element->shape.size[0])
        return error_set(error, ERROR_USER, "%s: %s: has %" PRIu64 " frames, frame %" PRIu64 " is wanted",
                         s->h5.path, element->dataset, (uint64_t)element->shape.size[0], s->frame);
    const struct h5_table rows = {.type = type, .width = width, .first = s->first, .count = s->count};
    size_t bytes = type == FIELD_INT32 ? 4 : 8;
    char *packed = memory_allocate(s->count, bytes * width, "rows of a file");
    bool good = h5md_found_read(&s->h5, element, s->frame, &rows, packed, error);
    for (uint64_t k = 0; good && k < s->count; k++)
        memcpy((char *)data + k * bytes * (size_t)in_memory, packed + k * bytes * width, bytes * width);
    memory_free(packed);
    return good;
}

/* The number of frames of the group, from the first element that has frames; 1 if no element has frames. */
static bool count_frames(const struct source *s, uint64_t *frames, struct error *error) {
    struct h5_names names;
    *frames = 1;
    if (!h5_list(&s->h5, s->group, &names, error))
        return false;
    struct h5md_found element = {0};
    bool good = h5md_find(&s->h5, s->group, "position", &element, error) || error->kind == ERROR_NONE;
    for (size_t k = 0; good && !element.frames && k < names.count; k++)
        if (strcmp(names.name[k], "box") != 0)
            good = h5md_find(&s->h5, s->group, names.name[k], &element, error) || error->kind == ERROR_NONE;
    if (good && element.frames)
        *frames = element.shape.size[0];
    memory_free(names.name);
    return good;
}

/* Chooses the frame and this rank's rows, from the position. */
static bool choose_rows(struct source *s, struct error *error) {
    struct h5md_found position;
    if (!h5md_find(&s->h5, s->group, "position", &position, error))
        return error_set(error, ERROR_USER, "%s: %.900s/position: there is no such object", s->h5.path,
                         s->group);
    if (!count_frames(s, &s->frames, error))
        return false;
    int64_t frame = s->wanted < 0 ? s->wanted + (int64_t)s->frames : s->wanted;
    if (frame < 0 || frame >= (int64_t)s->frames)
        return error_set(error, ERROR_USER, "%s: %s: has %" PRIu64 " frames, frame %" PRId64 " is wanted",
                         s->h5.path, position.dataset, s->frames, s->wanted);
    s->frame = (uint64_t)frame;
    int lead = position.frames;
    if (position.shape.rank != lead + 2 ||
        (position.shape.size[lead + 1] != 2 && position.shape.size[lead + 1] != 3))
        return refuse_shape(s, &position, lead ? "[frames][particles][2 or 3]" : "[particles][2 or 3]",
                            error);
    s->total = position.shape.size[lead];
    s->dimension = (int)position.shape.size[lead + 1];
    uint64_t size = s->comm ? (uint64_t)s->comm->size : 1, rank = s->comm ? (uint64_t)s->comm->rank : 0;
    s->first = s->total / size * rank + (rank < s->total % size ? rank : s->total % size);
    s->count = s->total / size + (rank < s->total % size);
    return true;
}

/* Reads a column if the file has it. */
static bool read_column(const struct source *s, const char *name, enum field_type type, int components,
                        void **data, struct error *error) {
    struct h5md_found element;
    if (!h5md_find(&s->h5, s->group, name, &element, error))
        return error->kind == ERROR_NONE;
    *data =
        memory_allocate_zero(s->count, (type == FIELD_INT32 ? 4 : 8) * (size_t)components, "rows of a file");
    return read_element(s, &element, type, components, *data, error);
}

/* Reads angular velocities. In a 2D file these may be one number a particle: the rotation about z. */
static bool read_spin(const struct source *s, struct rows *rows, struct error *error) {
    struct h5md_found element;
    if (!h5md_find(&s->h5, s->group, "angular_velocity", &element, error))
        return error->kind == ERROR_NONE;
    rows->angular_velocity = memory_allocate_zero(s->count, sizeof *rows->angular_velocity, "rows of a file");
    if (element.shape.rank != element.frames + 1)
        return read_element(s, &element, FIELD_DOUBLE, 3, rows->angular_velocity, error);
    double *about_z = memory_allocate(s->count, sizeof *about_z, "rows of a file");
    bool good = read_element(s, &element, FIELD_DOUBLE, 1, about_z, error);
    for (uint64_t k = 0; good && k < s->count; k++)
        rows->angular_velocity[k][2] = about_z[k];
    memory_free(about_z);
    return good;
}

/* Reads all columns that the file has; `species` stands for a material. */
static bool read_columns(const struct source *s, struct rows *rows, struct error *error) {
    bool good = true;
    for (int k = 0; good && k < ROWS_KINDS; k++) {
        const struct rows_kind *kind = &rows_kinds[k];
        void *values = NULL;
        if (kind->name == NULL || kind->bit == ROWS_ANGULAR_VELOCITY)
            continue;
        good = read_column(s, kind->name, kind->type, kind->components, &values, error) &&
               (values || kind->bit != ROWS_MATERIAL ||
                read_column(s, "species", kind->type, kind->components, &values, error));
        rows_set(rows, kind, values);
    }
    return good && read_spin(s, rows, error);
}

/* Step and time of the frame. */
static bool read_moment(const struct source *s, struct rows *rows, struct error *error) {
    char path[FILE_PATH_MAX];
    const char *names[2] = {"step", "time"};
    int64_t step = 0;
    for (int k = 0; k < 2; k++) {
        snprintf(path, sizeof path, "%.900s/position/%s", s->group, names[k]);
        struct h5_shape shape;
        if (!h5_exists(&s->h5, path))
            continue;
        if (!h5_get_shape(&s->h5, path, &shape, error))
            return false;
        hsize_t start = s->frame, count = 1;
        if (shape.rank > 1 || (shape.rank == 1 && shape.size[0] <= s->frame))
            return error_set(error, ERROR_USER, "%s: %s: has no value for frame %" PRIu64, s->h5.path, path,
                             s->frame);
        void *value = k == 0 ? (void *)&step : (void *)&rows->time;
        if (!h5_read_block(&s->h5, path, k == 0 ? FIELD_INT64 : FIELD_DOUBLE, &start, &count, value, error))
            return false;
        double offset = 0;
        if (shape.rank == 0) { /* an increment */
            h5_read_doubles(&s->h5, path, "offset", &offset, 1);
            step = k == 0 ? step * (int64_t)s->frame + (int64_t)offset : step;
            rows->time = k == 1 ? rows->time * (double)s->frame + offset : rows->time;
        }
    }
    rows->step = (uint64_t)step;
    return true;
}

static bool read_box(const struct source *s, struct rows *rows, struct error *error) {
    char path[FILE_PATH_MAX];
    snprintf(path, sizeof path, "%.900s/box", s->group);
    rows->dimension = s->dimension;
    char boundary[3][OUTPUT_NAME_MAX];
    rows->periodic_given = h5_read_texts(&s->h5, path, "boundary", boundary, s->dimension);
    for (int d = 0; rows->periodic_given && d < s->dimension; d++)
        rows->periodic[d] = strcmp(boundary[d], "periodic") == 0;
    struct h5md_found edges;
    if (!h5md_find(&s->h5, s->group, "box/edges", &edges, error))
        return error->kind == ERROR_NONE;
    int lead = edges.frames, n = s->dimension;
    bool matrix = edges.shape.rank == lead + 2 && edges.shape.size[lead + 1] == (hsize_t)n;
    if ((!matrix && edges.shape.rank != lead + 1) || edges.shape.size[lead] != (hsize_t)n)
        return refuse_shape(s, &edges, "one edge length, or one edge vector, a dimension", error);
    if (lead && s->frame >= edges.shape.size[0])
        return refuse_shape(s, &edges, "as many frames as the position has", error);
    const struct h5_table all = {
        .type = FIELD_DOUBLE, .width = matrix ? (uint64_t)n : 1, .count = (uint64_t)n};
    double value[9] = {0}, edge[3] = {0}, origin[3] = {0};
    if (!h5md_found_read(&s->h5, &edges, s->frame, &all, value, error))
        return false;
    int tilts = 0;
    for (int k = 0; matrix && k < n * n; k++)
        if (k % (n + 1) != 0 && value[k] != 0) {
            rows->tilt = (struct rows_tilt){k % n, k / n, value[k]};
            tilts++;
        }
    if (tilts > 1)
        return error_set(error, ERROR_USER,
                         "%s: %s: the box has %d tilts in frame %" PRIu64 "; at most one is known",
                         s->h5.path, edges.dataset, tilts, s->frame);
    for (int d = 0; d < n; d++)
        edge[d] = value[matrix ? (n + 1) * d : d];
    h5_read_doubles(&s->h5, path, "origin", origin, s->dimension);
    for (int d = 0; d < 3; d++) {
        rows->lower[d] = origin[d];
        rows->upper[d] = origin[d] + edge[d];
    }
    rows->box_given = true;
    return true;
}

/* Drops the rows whose id is the fill value, and counts the remaining rows on the ranks before this one. */
static void drop_absent(const struct source *s, struct rows *rows) {
    struct h5md_found id;
    struct error none = {0};
    int64_t fill;
    if (rows->id && h5md_find(&s->h5, s->group, "id", &id, &none) &&
        h5_read_fill(&s->h5, id.dataset, &fill)) {
        size_t kept = 0;
        for (size_t k = 0; k < rows->count; k++)
            if (rows->id[k] != fill)
                rows_move(rows, k, kept++);
        rows->count = kept;
    }
    int64_t total = (int64_t)rows->count;
    rows->first = s->comm ? (uint64_t)comm_scan(s->comm, total) : 0;
    if (s->comm)
        comm_sum_int(s->comm, &total, 1);
    rows->total = (uint64_t)total;
}

bool h5md_read(const char *path, const struct h5md_read_options *options, const struct comm *comm,
               struct rows *rows, struct error *error) {
    *rows = (struct rows){0};
    struct source s = {.comm = comm, .wanted = options->frame};
    if (!h5_open(&s.h5, path, comm, false, error))
        return false;
    bool good = find_group(&s, options->group, error) && choose_rows(&s, error);
    rows->count = s.count;
    good = good && read_columns(&s, rows, error) && read_moment(&s, rows, error) && read_box(&s, rows, error);
    if (good)
        drop_absent(&s, rows);
    good = h5_close(&s.h5, error) && good;
    if (!good)
        rows_free(rows);
    return good;
}

/* Lists the fields of the group in a message. */
static bool refuse_field(const struct source *s, const char *name, struct error *error) {
    struct h5_names names;
    char known[512] = "";
    if (!h5_list(&s->h5, s->group, &names, error))
        return false;
    for (size_t k = 0; k < names.count; k++) {
        size_t used = strlen(known);
        if (strcmp(names.name[k], "box") != 0)
            snprintf(known + used, sizeof known - used, "%s%s", used ? ", " : "", names.name[k]);
    }
    memory_free(names.name);
    return error_set(error, ERROR_USER, "%s: has no field '%s'; it has: %s", s->h5.path, name, known);
}

/* Reads a field with any number of components, and takes one component or the length. */
static bool read_values(const struct source *s, const struct h5md_found *e, int component, double *value,
                        struct error *error) {
    int lead = e->frames;
    size_t width = h5md_found_width(e);
    if (width == 0 || e->shape.size[lead] != s->total || (lead && s->frame >= e->shape.size[0]))
        return refuse_shape(s, e, "one value or vector a particle", error);
    if (component >= (int)width)
        return error_set(error, ERROR_USER, "%s: %s: has %zu components, no number %d", s->h5.path,
                         e->dataset, width, component);
    const struct h5_table rows = {.type = FIELD_DOUBLE, .width = width, .count = s->total};
    double *all = memory_allocate(s->total * width, sizeof *all, "values of a field");
    bool good = h5md_found_read(&s->h5, e, s->frame, &rows, all, error);
    for (uint64_t k = 0; good && k < s->total; k++) {
        double square = 0;
        for (size_t d = 0; d < width; d++)
            square += all[k * width + d] * all[k * width + d];
        value[k] = width == 1 ? all[k] : component >= 0 ? all[k * width + (size_t)component] : sqrt(square);
    }
    memory_free(all);
    return good;
}

/* Reads ids, and drops the rows that are absent. */
static bool read_present(const struct source *s, struct h5md_values *values, struct error *error) {
    struct h5md_found id;
    int64_t fill;
    if (!h5md_find(&s->h5, s->group, "id", &id, error)) {
        for (size_t k = 0; k < values->count; k++)
            values->id[k] = (int64_t)k + 1;
        return error->kind == ERROR_NONE;
    }
    if (!read_element(s, &id, FIELD_INT64, 1, values->id, error))
        return false;
    size_t kept = 0;
    bool filled = h5_read_fill(&s->h5, id.dataset, &fill);
    for (size_t k = 0; k < values->count; k++) {
        values->id[kept] = values->id[k];
        values->value[kept] = values->value[k];
        kept += !filled || values->id[k] != fill;
    }
    values->count = kept;
    return true;
}

bool h5md_read_values(const char *path, int64_t frame, const char *name, int component,
                      struct h5md_values *values, struct error *error) {
    struct source s = {.wanted = frame};
    struct h5md_found element;
    *values = (struct h5md_values){0};
    if (!h5_open(&s.h5, path, NULL, false, error))
        return false;
    bool good = find_group(&s, NULL, error) && choose_rows(&s, error);
    if (good && !h5md_find(&s.h5, s.group, name, &element, error))
        good = error->kind == ERROR_NONE && refuse_field(&s, name, error);
    if (good) {
        values->count = s.total;
        values->id = memory_allocate(s.total, sizeof *values->id, "ids");
        values->value = memory_allocate(s.total, sizeof *values->value, "values of a field");
        good = read_values(&s, &element, component, values->value, error) && read_present(&s, values, error);
    }
    good = h5_close(&s.h5, error) && good;
    if (!good) {
        memory_free(values->id);
        memory_free(values->value);
        *values = (struct h5md_values){0};
    }
    return good;
}

bool h5md_has_field(const char *path, const char *name, bool *has, struct error *error) {
    struct source s = {0};
    char element[2 * FILE_PATH_MAX];
    *has = false;
    if (!h5_open(&s.h5, path, NULL, false, error))
        return false;
    bool good = find_group(&s, NULL, error);
    snprintf(element, sizeof element, "%s/%s", s.group, name);
    *has = good && h5_exists(&s.h5, element);
    return h5_close(&s.h5, error) && good;
}

bool h5md_read_frames(const char *path, const char *group, uint64_t *frames, struct error *error) {
    struct source s = {0};
    *frames = 0;
    if (!h5_open(&s.h5, path, NULL, false, error))
        return false;
    bool good = find_group(&s, group, error) && count_frames(&s, frames, error);
    return h5_close(&s.h5, error) && good;
}
