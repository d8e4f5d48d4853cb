/* SPDX-License-Identifier: BSD-3-Clause */
/* Converts between the formats, frame by frame. Read convert.h first. */
#include "data/formats/convert.h"

#include "kernel/particles/kinds.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include "base/memory.h"
#include "data/formats/checkpoint.h"
#include "data/formats/dump.h"
#include "base/file.h"
#include "data/formats/h5md.h"
#include "data/formats/h5md_read.h"
#include "data/formats/info.h"
#include "data/formats/lammps_data.h"
#include "data/formats/output_shapes.h"
#include "kernel/particles/groups.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const struct {
    const char *name, *ending;
    enum convert_format format;
} formats[] = {
    {"lammps-data", ".data", CONVERT_LAMMPS_DATA},
    {"lammps-data", ".lammps", CONVERT_LAMMPS_DATA},
    {"lammps-dump", ".lammpstrj", CONVERT_LAMMPS_DUMP},
    {"lammps-dump", ".dump", CONVERT_LAMMPS_DUMP},
    {"h5md", ".h5", CONVERT_H5MD},
    {"xdmf", ".xdmf", CONVERT_XDMF},
};
enum { FORMATS = sizeof formats / sizeof formats[0] };

/* One conversion. */
struct converting {
    const char *in, *out;
    const struct convert_options *options;
    const struct comm *comm;
    enum info_kind kind;
    enum convert_format to;
    uint64_t frames; /* number of frames in the input */
};

enum convert_format convert_format_find(const char *name) {
    for (int k = 0; k < FORMATS; k++)
        if (strcmp(formats[k].name, name) == 0)
            return formats[k].format;
    return CONVERT_BY_NAME;
}

static enum convert_format format_of_name(const char *path) {
    size_t length = strlen(path);
    for (int k = 0; k < FORMATS; k++) {
        size_t end = strlen(formats[k].ending);
        if (length > end && strcmp(path + length - end, formats[k].ending) == 0)
            return formats[k].format;
    }
    return CONVERT_BY_NAME;
}

static bool count_frames(struct converting *c, struct error *error) {
    c->frames = 1;
    if (c->kind == INFO_H5MD)
        return h5md_read_frames(c->in, NULL, &c->frames, error);
    if (c->kind == INFO_LAMMPS_DUMP)
        return dump_frames(c->in, &c->frames, error);
    return c->kind == INFO_LAMMPS_DATA || c->kind == INFO_CHECKPOINT ||
           error_set(error, ERROR_USER,
                     "%s: is no LAMMPS data file, LAMMPS dump, H5MD file or checkpoint, and so cannot be "
                     "converted",
                     c->in);
}

static int compare_ids(const void *a, const void *b) {
    const int64_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* Sorts rows by id, as in frames; one pass reorders each array. */
static void sort_array(void *array, size_t bytes, const int64_t (*order)[2], size_t n) {
    if (!array)
        return;
    char *sorted = memory_allocate(n, bytes, "rows by id");
    for (size_t k = 0; k < n; k++)
        memcpy(sorted + k * bytes, (char *)array + (size_t)order[k][1] * bytes, bytes);
    memcpy(array, sorted, n * bytes);
    memory_free(sorted);
}

static void sort_rows(struct rows *rows) {
    size_t n = rows->count;
    if (!rows->id) {
        rows->id = memory_allocate(n, sizeof *rows->id, "ids");
        for (size_t k = 0; k < n; k++)
            rows->id[k] = (int64_t)k + 1;
        return;
    }
    int64_t(*order)[2] = memory_allocate(n, sizeof *order, "rows by id");
    for (size_t k = 0; k < n; k++) {
        order[k][0] = rows->id[k];
        order[k][1] = (int64_t)k;
    }
    qsort(order, n, sizeof *order, compare_ids);
    const int64_t(*by)[2] = (const int64_t(*)[2])order;
    for (int k = 0; k < ROWS_KINDS; k++)
        sort_array(rows_values(rows, &rows_kinds[k]), rows_bytes(&rows_kinds[k]), by, n);
    memory_free(order);
}

/* True if the file has the field of this name. */
static bool was_read(const struct checkpoint_loaded *loaded, const struct particles *p, const char *name) {
    return loaded->field_read[fields_find(p, name)];
}

/* Fills a column that shows a field as it is, a number of one byte in four. */
static void copy_column(struct rows *rows, const struct rows_kind *kind, const struct particles *p) {
    const int f = fields_find(p, kind->name);
    const struct field *field = fields_get(p, f);
    const size_t bytes = rows_bytes(kind);
    size_t stride;
    const char *from = fields_base(p, f, &stride);
    char *to = rows_values(rows, kind);
    for (size_t i = 0; i < p->owned; i++) {
        const int32_t small = field->type == FIELD_UINT8 ? *(const uint8_t *)(from + i * stride) : 0;
        memcpy(to + i * bytes, field->type == FIELD_UINT8 ? (const char *)&small : from + i * stride, bytes);
    }
}

static void rows_of_particles(struct rows *rows, const struct particles *p,
                              const struct checkpoint_loaded *loaded) {
    const struct box *box = &loaded->box;
    double(*omega)[4] = was_read(loaded, p, "angular_velocity") ? spin_of(p) : NULL;
    const uint8_t *material = was_read(loaded, p, "material") ? material_numbers(p) : NULL;
    int32_t(*image)[3] = was_read(loaded, p, "image") ? particles_images(p) : NULL;
    unsigned columns = ROWS_POSITION | ROWS_VELOCITY | ROWS_RADIUS | ROWS_MASS | ROWS_ID;
    columns |= omega ? ROWS_ANGULAR_VELOCITY : 0u;
    columns |= material ? ROWS_MATERIAL : 0u;
    columns |= image ? ROWS_IMAGE : 0u;
    for (int k = 0; k < ROWS_KINDS; k++)
        if (rows_kinds[k].bit > ROWS_LINE && was_read(loaded, p, rows_kinds[k].name))
            columns |= rows_kinds[k].bit;
    rows_create(rows, p->owned, columns);
    for (int k = 0; k < ROWS_KINDS; k++)
        if (rows_kinds[k].bit > ROWS_LINE && rows_values(rows, &rows_kinds[k]))
            copy_column(rows, &rows_kinds[k], p);
    for (size_t i = 0; i < p->owned; i++) {
        rows->id[i] = p->id[i];
        rows->radius[i] = p->state[i].radius;
        rows->mass[i] = groups_mass(p, i);
        for (int d = 0; d < 3; d++)
            rows->position[i][d] = p->state[i].x[d];
        memcpy(rows->velocity[i], p->state[i].v, sizeof rows->velocity[i]);
        if (omega)
            memcpy(rows->angular_velocity[i], omega[i], sizeof rows->angular_velocity[i]);
        if (material)
            rows->material[i] = material[i];
        if (image)
            memcpy(rows->image[i], image[i], sizeof rows->image[i]);
    }
    rows->dimension = box->dimension;
    rows->box_given = rows->periodic_given = true;
    for (int d = 0; d < 3; d++) {
        rows->lower[d] = box->origin[d];
        rows->upper[d] = box->origin[d] + box->edge[d];
        rows->periodic[d] = box->periodic[d];
    }
    rows->tilt = (struct rows_tilt){box->motion.flow, box->motion.gradient, box->motion.offset};
}

/* Reads the particles of a checkpoint as files show them: positions of the user, velocities of the full step. */
static bool read_shown(const struct comm *comm, const char *path, struct particles *particles,
                       struct checkpoint_loaded *loaded, struct error *error) {
    frame_register_all(particles);
    kinds_register(particles); /* bodies and particles of a fluid have no mass of a grain */
    if (!checkpoint_read_full(comm, path, particles, loaded, error))
        return false;
    for (size_t i = 0; i < particles->owned; i++)
        for (int d = 0; d < 3; d++)
            particles->state[i].x[d] += loaded->box.origin[d];
    return true;
}

static bool read_checkpoint(const struct converting *c, struct rows *rows, struct error *error) {
    struct checkpoint_loaded loaded;
    struct particles *particles = particles_create(0);
    bool good = read_shown(c->comm, c->in, particles, &loaded, error);
    if (good) {
        rows_of_particles(rows, particles, &loaded);
        rows->step = loaded.numbers.step;
        rows->time = loaded.numbers.time;
        checkpoint_loaded_free(&loaded);
    }
    particles_destroy(&particles);
    return good;
}

static bool read_frame(const struct converting *c, int64_t frame, struct rows *rows, struct error *error) {
    struct h5md_read_options options = {.frame = frame};
    bool good = false;
    if (c->kind == INFO_LAMMPS_DATA)
        good = lammps_data_read(c->in, rows, error);
    else if (c->kind == INFO_LAMMPS_DUMP)
        good = dump_read(c->in, frame, rows, error);
    else if (c->kind == INFO_CHECKPOINT)
        good = read_checkpoint(c, rows, error);
    else
        good = h5md_read(c->in, &options, NULL, rows, error);
    if (good)
        sort_rows(rows);
    return good;
}

bool convert_read(const char *in, int64_t frame, const struct comm *comm, struct rows *rows, uint64_t *frames,
                  struct error *error) {
    struct converting c = {.in = in, .comm = comm};
    *rows = (struct rows){0};
    if (!info_kind(in, &c.kind, error) || (frames && !count_frames(&c, error)))
        return false;
    if (frames)
        *frames = c.frames;
    return read_frame(&c, frame, rows, error);
}

/* A component of a field, or the length of a vector. */
static double value_of(const struct field *field, const void *at, int component) {
    double square = 0;
    if (component >= 0 || field->components == 1)
        return fields_component(field, at, component < 0 ? 0 : component);
    for (int k = 0; k < field->components; k++)
        square += fields_component(field, at, k) * fields_component(field, at, k);
    return sqrt(square);
}

static void values_take(const struct particles *p, int f, int component, struct h5md_values *values) {
    size_t stride;
    const char *base = fields_base(p, f, &stride);
    int64_t(*order)[2] = memory_allocate(p->owned, sizeof *order, "rows by id");
    *values = (struct h5md_values){p->owned, memory_allocate(p->owned, sizeof *values->id, "ids"),
                                   memory_allocate(p->owned, sizeof *values->value, "values of a field")};
    for (size_t k = 0; k < p->owned; k++) {
        order[k][0] = p->id[k];
        order[k][1] = (int64_t)k;
    }
    qsort(order, p->owned, sizeof *order, compare_ids);
    for (size_t k = 0; k < p->owned; k++) {
        values->id[k] = order[k][0];
        values->value[k] = value_of(fields_get(p, f), base + (size_t)order[k][1] * stride, component);
    }
    memory_free(order);
}

bool convert_values(const char *checkpoint, const char *name, int component, const struct comm *comm,
                    struct h5md_values *values, struct error *error) {
    struct checkpoint_loaded loaded;
    struct particles *particles = particles_create(0);
    *values = (struct h5md_values){0};
    bool good = read_shown(comm, checkpoint, particles, &loaded, error);
    if (good) {
        const int f = fields_find(particles, name);
        good = f >= 0 && loaded.field_read[f] && component < fields_get(particles, f)->components;
        if (good)
            values_take(particles, f, component, values);
        else
            error_set(error, ERROR_USER, "%s: has no field %s, or not component %d of it", checkpoint, name,
                      component);
        checkpoint_loaded_free(&loaded);
    }
    particles_destroy(&particles);
    return good;
}

/* The frames asked for: [first, last). */
static bool choose_frames(const struct converting *c, uint64_t *first, uint64_t *last, struct error *error) {
    *first = 0;
    *last = c->frames;
    bool one = c->options->one_frame || c->to == CONVERT_LAMMPS_DATA;
    if (!one)
        return true;
    int64_t wanted = c->options->one_frame ? c->options->frame : -1;
    int64_t frame = wanted < 0 ? wanted + (int64_t)c->frames : wanted;
    if (frame < 0 || frame >= (int64_t)c->frames)
        return error_set(error, ERROR_USER, "%s: has %" PRIu64 " frames, frame %" PRId64 " is wanted", c->in,
                         c->frames, wanted);
    *first = (uint64_t)frame;
    *last = (uint64_t)frame + 1;
    return true;
}

/* Passes all chosen frames to one of the writers. */
static bool write_frames(const struct converting *c, struct h5md *h5md, struct dump *dump,
                         struct error *error) {
    uint64_t first, last;
    bool good = choose_frames(c, &first, &last, error);
    for (uint64_t k = first; good && k < last; k++) {
        struct rows rows;
        struct frame frame;
        if (!read_frame(c, (int64_t)k, &rows, error))
            return false;
        frame_from_rows(&frame, &rows);
        good = h5md ? h5md_write_frame(h5md, &frame, error) : dump_write(dump, &frame, error);
        rows_free(&rows);
    }
    return good;
}

/* True if two columns of `bytes` bytes hold different values, or one of the columns is missing. */
static bool column_differs(const void *a, const void *b, size_t bytes) {
    return a && b ? memcmp(a, b, bytes) != 0 : a != b;
}

/* True if two frames differ in columns that a file with a fixed set of particles holds only once. */
static bool fixed_differ(const struct rows *a, const struct rows *b) {
    bool differ = a->count != b->count;
    for (int k = 0; k < ROWS_KINDS && !differ; k++)
        differ = rows_kinds[k].fixed &&
                 column_differs(rows_values(a, &rows_kinds[k]), rows_values(b, &rows_kinds[k]),
                                a->count * rows_bytes(&rows_kinds[k]));
    return differ;
}

/* True if the particles, or their fixed columns, differ between chosen frames. */
static bool find_varying(const struct converting *c, bool *varying, struct error *error) {
    uint64_t first, last;
    struct rows before = {0};
    bool good = choose_frames(c, &first, &last, error);
    *varying = false;
    for (uint64_t k = first; good && !*varying && k < last && last - first > 1; k++) {
        struct rows rows;
        good = read_frame(c, (int64_t)k, &rows, error);
        if (!good)
            break;
        *varying = k > first && fixed_differ(&before, &rows);
        rows_free(&before);
        before = rows;
    }
    rows_free(&before);
    return good;
}

static bool write_h5md(const struct converting *c, struct error *error) {
    struct output_shapes shapes = {0};
    struct h5md_head head = {.shapes = &shapes, .dimensionless = true, .xdmf = true};
    struct h5md *h5md = NULL;
    bool good = c->kind != INFO_H5MD || output_shapes_read(c->in, &shapes, error);
    good =
        good && find_varying(c, &head.varying, error) && h5md_open(&h5md, c->comm, c->out, &head, -1, error);
    if (h5md) {
        good = write_frames(c, h5md, NULL, error);
        good = h5md_close(&h5md, error) && good;
    }
    output_shapes_free(&shapes);
    return good;
}

static bool write_dump(const struct converting *c, struct error *error) {
    struct dump *dump = NULL;
    if (!dump_open(&dump, c->comm, c->out, -1, error))
        return false;
    bool good = write_frames(c, NULL, dump, error);
    return dump_close(&dump, error) && good;
}

static bool write_data(const struct converting *c, struct error *error) {
    uint64_t first, last;
    struct rows rows;
    if (!choose_frames(c, &first, &last, error) || !read_frame(c, (int64_t)first, &rows, error))
        return false;
    bool good = lammps_data_write(c->out, &rows, error);
    rows_free(&rows);
    return good;
}

static bool write_xdmf(const struct converting *c, struct error *error) {
    if (c->kind != INFO_H5MD)
        return error_set(error, ERROR_USER,
                         "%s: XDMF points into an H5MD file; convert to .h5, which makes both", c->in);
    return h5md_write_xdmf(c->in, c->out, c->comm, error);
}

static bool same_file(const char *a, const char *b) {
    struct stat one, two;
    return stat(a, &one) == 0 && stat(b, &two) == 0 && one.st_dev == two.st_dev && one.st_ino == two.st_ino;
}

bool convert_file(const char *in, const char *out, const struct convert_options *options,
                  const struct comm *comm, struct error *error) {
    struct converting c = {.in = in, .out = out, .options = options, .comm = comm};
    c.to = options->to == CONVERT_BY_NAME ? format_of_name(out) : options->to;
    if (c.to == CONVERT_BY_NAME)
        return error_set(
            error, ERROR_USER,
            "%s: the format is not clear from this name (.data, .lammpstrj, .h5, .xdmf; faces of rocks: "
            ".vtp, .pvd)",
            out);
    if (!info_kind(in, &c.kind, error) || !count_frames(&c, error))
        return false;
    if (same_file(in, out))
        return error_set(error, ERROR_USER, "%s: cannot be converted into itself", in);
    if (!options->overwrite && file_size(out) >= 0)
        return error_set(error, ERROR_USER, "%s: is there already (--overwrite replaces it)", out);
    switch (c.to) {
    case CONVERT_LAMMPS_DATA:
        return write_data(&c, error);
    case CONVERT_LAMMPS_DUMP:
        return write_dump(&c, error);
    case CONVERT_H5MD:
        return write_h5md(&c, error);
    default:
        return write_xdmf(&c, error);
    }
}
