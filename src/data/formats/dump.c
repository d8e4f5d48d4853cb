/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes dumps as LAMMPS does. Read dump.h first. */
#include "data/formats/dump.h"

#include "base/memory.h"
#include "base/file.h"
#include "base/lines.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct dump {
    const struct comm *comm; /* borrowed */
    char path[FILE_PATH_MAX];
    FILE *file; /* rank 0 */
};

/* The columns of a dump for each field that it can show; the id comes first in any case. */
struct dump_column {
    const char *field;
    const char *head; /* as many names as the field has components */
    int add;          /* to integers: LAMMPS's types begin at 1 */
};

static const struct dump_column dump_columns[] = {
    {"material", "type", 1},
    {"radius", "radius", 0},
    {"mass", "mass", 0},
    {"position", "x y z", 0},
    {"velocity", "vx vy vz", 0},
    {"angular_velocity", "omegax omegay omegaz", 0},
    {"force", "fx fy fz", 0},
    {"torque", "tqx tqy tqz", 0},
    {"rock_orientation", "quatw quati quatj quatk", 0},
    {"image", "ix iy iz", 0},
    {"drag", "dragx dragy dragz", 0},
    {"vorticity", "curlx curly curlz", 0},
    {"electric_field", "efieldx efieldy efieldz", 0},
};
enum {
    DUMP_COLUMNS = sizeof dump_columns / sizeof dump_columns[0],
    LINE_BYTES = 26 * (26 + OUTPUT_FIELDS_MAX)
};

static const struct dump_column *known_column(const char *field) {
    for (int c = 0; c < DUMP_COLUMNS; c++)
        if (strcmp(dump_columns[c].field, field) == 0)
            return &dump_columns[c];
    return NULL;
}

const char *dump_columns_of(const char *field, int components) {
    const struct dump_column *known = known_column(field);
    return known ? known->head : components == 1 ? field : "";
}

bool dump_check_fields(const struct output_fields *fields, const struct particles *particles,
                       struct error *error) {
    for (int f = 0; f < fields_count(particles); f++) {
        struct frame_field field = frame_field_get(fields_get(particles, f));
        for (int k = 0; k < fields->count; k++)
            if (strcmp(fields->name[k], field.name) == 0 &&
                dump_columns_of(field.name, field.components)[0] == '\0')
                return error_set(error, ERROR_USER,
                                 "field \"%s\": a dump has no columns for this field; "
                                 "output.trajectory.fields may name it",
                                 field.name);
    }
    return true;
}

/* True if LAMMPS has no name for a column of one number. Such a column keeps its own name, and stands behind the
 * others. The id stands before them. */
static bool is_other(const struct frame_column *column) {
    return known_column(column->name) == NULL && column->components == 1 && strcmp(column->name, "id") != 0;
}

/* Cuts an existing file behind the last whole frame up to a step. */
static bool cut_file(const char *path, int64_t step, struct error *error) {
    struct lines lines;
    if (!lines_open(&lines, path, error))
        return false;
    int64_t end = 0;
    while (lines_next(&lines) && strncmp(lines.text, "ITEM: TIMESTEP", 14) == 0) {
        if (!lines_next(&lines) || strtoll(lines.text, NULL, 10) > step)
            break;
        if (!lines_next(&lines) || !lines_next(&lines))
            break;
        int64_t left = strtoll(lines.text, NULL, 10) + 5; /* box: 4 lines, head of the columns: 1 */
        while (left > 0 && lines_next(&lines))
            left--;
        if (left > 0 || !lines.whole)
            break;
        end = lines_place(&lines);
    }
    lines_close(&lines);
    return truncate(path, end) == 0 || error_set_errno(error, "%s: cannot be cut to go on with it", path);
}

bool dump_open(struct dump **dump, const struct comm *comm, const char *path, int64_t resume_step,
               struct error *error) {
    struct dump *made = memory_allocate_zero(1, sizeof *made, "dump");
    made->comm = comm;
    snprintf(made->path, sizeof made->path, "%s", path);
    *dump = made;
    if (comm->rank == 0) {
        bool go_on = resume_step >= 0 && file_size(path) >= 0;
        if (!go_on || cut_file(path, resume_step, error)) {
            made->file = fopen(path, go_on ? "a" : "w");
            if (!made->file)
                error_set_errno(error, "%s: cannot be written", path);
        }
    }
    if (comm_agree(comm, error))
        return true;
    struct error ignored = {0};
    dump_close(dump, &ignored);
    return false;
}

/* The bounds of a sheared box as LAMMPS has them: lines that hold the whole cell, and the tilts xy, xz, yz. LAMMPS
 * has no tilt of a higher direction along a lower one; then the cell is shown without tilt. */
static void write_bounds(const struct dump *dump, const struct box *box) {
    const struct box_motion *motion = &box->motion;
    bool tilts = motion->shears && motion->flow < motion->gradient;
    double tilt[3] = {0}, low[3] = {0}, high[3] = {0}; /* xy xz yz */
    if (tilts) {
        tilt[motion->flow + motion->gradient - 1] = motion->offset;
        low[0] = fmin(fmin(0, tilt[0]), fmin(tilt[1], tilt[0] + tilt[1]));
        high[0] = fmax(fmax(0, tilt[0]), fmax(tilt[1], tilt[0] + tilt[1]));
        low[1] = fmin(0, tilt[2]);
        high[1] = fmax(0, tilt[2]);
        fprintf(dump->file, " xy xz yz");
    }
    for (int d = 0; d < 3; d++)
        fprintf(dump->file, " %s", box->periodic[d] ? "pp" : "ff");
    for (int d = 0; d < 3; d++) {
        fprintf(dump->file, "\n%.15g %.15g", box->origin[d] + low[d],
                box->origin[d] + box->edge[d] + high[d]);
        if (tilts)
            fprintf(dump->file, " %.15g", tilt[d]);
    }
}

static void write_head(const struct dump *dump, const struct frame *frame) {
    fprintf(dump->file, "ITEM: TIMESTEP\n%" PRIu64 "\nITEM: NUMBER OF ATOMS\n%" PRIu64 "\nITEM: BOX BOUNDS",
            frame->step, frame->total);
    write_bounds(dump, &frame->box);
    fprintf(dump->file, "\nITEM: ATOMS id");
    if (!frame_find(frame, "material"))
        fprintf(dump->file, " type");
    for (int c = 0; c < DUMP_COLUMNS; c++)
        if (frame_find(frame, dump_columns[c].field))
            fprintf(dump->file, " %s", dump_columns[c].head);
    for (int c = 0; c < frame->columns; c++)
        if (is_other(&frame->column[c]))
            fprintf(dump->file, " %s", frame->column[c].name);
    fprintf(dump->file, "\n");
}

/* Formats a value; `add` is added to integers. */
static size_t format_column(const struct frame_column *column, int add, size_t row, char *to) {
    size_t used = 0;
    for (int d = 0; d < column->components; d++) {
        size_t k = row * (size_t)column->components + (size_t)d;
        if (column->type == FIELD_DOUBLE)
            used += (size_t)sprintf(to + used, " %.15g", ((const double *)column->data)[k]);
        else if (column->type == FIELD_INT32)
            used += (size_t)sprintf(to + used, " %d", ((const int32_t *)column->data)[k] + add);
        else
            used += (size_t)sprintf(to + used, " %" PRId64, ((const int64_t *)column->data)[k] + add);
    }
    return used;
}

/* The lines of this rank's rows; memory_free. */
static char *format_rows(const struct frame *frame, size_t *bytes) {
    size_t room = 1 << 16, used = 0;
    char *text = memory_allocate(room, 1, "lines of a dump");
    bool typed = frame_find(frame, "material") != NULL;
    for (size_t row = 0; row < frame->rows; row++) {
        if (room - used < LINE_BYTES) {
            room *= 2;
            text = memory_resize(text, room, 1, "lines of a dump");
        }
        const int64_t *id = frame->column[0].data;
        used += (size_t)sprintf(text + used, "%" PRId64 "%s", id[row], typed ? "" : " 1");
        for (int c = 0; c < DUMP_COLUMNS; c++) {
            const struct frame_column *column = frame_find(frame, dump_columns[c].field);
            if (column)
                used += format_column(column, dump_columns[c].add, row, text + used);
        }
        for (int c = 0; c < frame->columns; c++)
            if (is_other(&frame->column[c]))
                used += format_column(&frame->column[c], 0, row, text + used);
        text[used++] = '\n';
    }
    *bytes = used;
    return text;
}

bool dump_write(struct dump *dump, const struct frame *frame, struct error *error) {
    size_t mine;
    char *text = format_rows(frame, &mine);
    if (dump->file)
        write_head(dump, frame);
    /* rank by rank, so that rank 0 holds the lines of only one other rank at a time */
    for (int rank = 0; rank < dump->comm->size; rank++) {
        void *all = NULL;
        size_t bytes = comm_gather_varying(dump->comm, text, rank == dump->comm->rank ? mine : 0, &all, NULL);
        if (dump->file && fwrite(all, 1, bytes, dump->file) != bytes)
            error_set_errno(error, "%s: a frame cannot be written", dump->path);
        memory_free(all);
    }
    memory_free(text);
    if (dump->file && (fflush(dump->file) != 0 || ferror(dump->file)))
        error_set_errno(error, "%s: a frame cannot be written", dump->path);
    return comm_agree(dump->comm, error);
}

bool dump_close(struct dump **dump, struct error *error) {
    struct dump *d = *dump;
    if (!d)
        return true;
    if (d->file && fclose(d->file) != 0)
        error_set_errno(error, "%s: not all could be written", d->path);
    bool good = comm_agree(d->comm, error);
    memory_free(d);
    *dump = NULL;
    return good;
}
