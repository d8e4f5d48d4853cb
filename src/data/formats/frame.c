/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes a frame in four steps: resolve columns; copy each field of the owned particles, in the user's terms;
 * send every particle to the rank of its interval of ids; sort each interval. The intervals are equal parts
 * of the range of ids, so the ranks are balanced as long as ids are spread evenly. The result is correct in
 * any case. */
#include "data/formats/frame.h"

#include "kernel/comm/exchange.h"
#include "kernel/comm/rank_groups.h"
#include "base/memory.h"
#include "fields_table.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include "physics_table.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The output form of a field that is not copied unchanged. */
struct shown {
    const char *field, *name;
    const char *unit, *help;                                                  /* NULL: those of the field */
    void (*value)(const struct output_view *view, size_t i, double value[3]); /* NULL: copied */
};

static void show_position(const struct output_view *view, size_t i, double value[3]) {
    for (int d = 0; d < 3; d++)
        value[d] = view->particles->state[i].x[d] + view->box->origin[d];
}

static void show_velocity(const struct output_view *view, size_t i, double value[3]) {
    integrator_full_step(view->particles, view->motion, i, value, NULL);
}

static void show_angular_velocity(const struct output_view *view, size_t i, double value[3]) {
    double velocity[3];
    integrator_full_step(view->particles, view->motion, i, velocity, value);
}

static void show_mass(const struct output_view *view, size_t i, double value[3]) {
    value[0] = groups_mass(view->particles, i);
}

static const struct shown shown_table[] = {
    {"position", "position", NULL, NULL, show_position},
    {"velocity", "velocity", NULL, "velocity of the centre, at the same moment as the position",
     show_velocity},
    {"angular_velocity", "angular_velocity", NULL, "angular velocity, at the same moment as the position",
     show_angular_velocity},
    {"inverse_mass", "mass", "kg", "mass", show_mass},
};

static struct shown shown_of(const struct field *field) {
    for (size_t k = 0; k < sizeof shown_table / sizeof shown_table[0]; k++)
        if (strcmp(shown_table[k].field, field->name) == 0)
            return shown_table[k];
    return (struct shown){.field = field->name, .name = field->name};
}

void frame_register_all(struct particles *particles) {
    kinds_register(particles);
#define FIELDS_REGISTER(register_fields, needed) register_fields(particles);
    FIELDS_TABLE(FIELDS_REGISTER)
#undef FIELDS_REGISTER
#define FIELDS_OF(name, key, whose, summary) name##_fields(particles);
    PHYSICS_TABLE(FIELDS_OF)
#undef FIELDS_OF
}

static const char *unit_of(const struct field *field, const struct shown *shown) {
    return shown->unit ? shown->unit : field->unit ? field->unit : "";
}

/* The type in the output: a field of one byte becomes INT32. */
static enum field_type shown_type(const struct field *field) {
    return field->type == FIELD_UINT8 ? FIELD_INT32 : field->type;
}

struct frame_field frame_field_get(const struct field *field) {
    struct shown shown = shown_of(field);
    return (struct frame_field){.name = shown.name,
                                .unit = unit_of(field, &shown),
                                .help = shown.help ? shown.help : field->help,
                                .type = shown_type(field),
                                .components = field->components,
                                .spatial = (field->use & FIELD_SPATIAL) != 0,
                                .fixed = (field->use & FIELD_FIXED) != 0,
                                .asked_only = (field->use & FIELD_ASKED) != 0,
                                .needed_for = field->needed_for};
}

static bool listed(const struct output_fields *fields, const char *name) {
    for (int k = 0; k < fields->count; k++)
        if (strcmp(fields->name[k], name) == 0)
            return true;
    return false;
}

static bool wanted(const struct output_fields *fields, const struct field *field) {
    if (!(field->use & FIELD_OUTPUT))
        return false;
    if (fields->count == 0)
        return !(field->use & FIELD_ASKED);
    return listed(fields, shown_of(field).name);
}

static size_t type_bytes(enum field_type type) {
    return type == FIELD_INT32 ? sizeof(int32_t) : type == FIELD_UINT8 ? 1 : sizeof(int64_t);
}

size_t frame_column_bytes(const struct frame_column *column) {
    return type_bytes(column->type) * (size_t)column->components;
}

const struct frame_column *frame_find(const struct frame *frame, const char *name) {
    for (int c = 0; c < frame->columns; c++)
        if (strcmp(frame->column[c].name, name) == 0)
            return &frame->column[c];
    return NULL;
}

/* Words of other programs for a field; "": none is known. */
static const char *field_meant(const char *word) {
    static const char *const words[][2] = {{"omega", "angular_velocity"},
                                           {"spin", "angular_velocity"},
                                           {"w", "angular_velocity"},
                                           {"angular_speed", "angular_velocity"},
                                           {"v", "velocity"},
                                           {"velocities", "velocity"},
                                           {"speed", "velocity"},
                                           {"x", "position"},
                                           {"positions", "position"},
                                           {"coordinates", "position"},
                                           {"f", "force"},
                                           {"forces", "force"},
                                           {"torques", "torque"},
                                           {"r", "radius"},
                                           {"radii", "radius"},
                                           {"diameter", "radius"},
                                           {"m", "mass"},
                                           {"type", "material"},
                                           {"temp", "temperature"},
                                           {"ids", "id"}};
    for (size_t k = 0; k < sizeof words / sizeof words[0]; k++)
        if (strcasecmp(word, words[k][0]) == 0)
            return words[k][1];
    return "";
}

static bool field_there(const struct particles *particles, const char *name) {
    for (int f = 0; f < fields_count(particles); f++) {
        const struct field *field = fields_get(particles, f);
        if ((field->use & FIELD_OUTPUT) && strcmp(shown_of(field).name, name) == 0)
            return true;
    }
    return false;
}

bool frame_check_fields(const struct output_fields *fields, const struct particles *particles,
                        struct error *error) {
    char known[ERROR_TEXT_MAX / 2] = "";
    for (int f = 0; f < fields_count(particles); f++) {
        const struct field *field = fields_get(particles, f);
        size_t used = strlen(known);
        if (field->use & FIELD_OUTPUT)
            snprintf(known + used, sizeof known - used, "%s%s", used ? ", " : "", shown_of(field).name);
    }
    for (int k = 0; k < fields->count; k++) {
        const char *name = fields->name[k], *meant = field_meant(name);
        bool like = field_there(particles, meant);
        if (!field_there(particles, name))
            return error_set(error, ERROR_USER, "field \"%s\": this scene has no such field%s%s%s; it has %s",
                             name, like ? " (did you mean '" : "", like ? meant : "", like ? "'?)" : "",
                             known);
    }
    return true;
}

/* Copies field f of the owned particles into a column's array, UINT8 widened to INT32. */
static void copy_field(const struct particles *particles, int f, struct frame_column *column) {
    const struct field *field = fields_get(particles, f);
    size_t stride, bytes = fields_bytes(field);
    const char *base = fields_base(particles, f, &stride);
    if (field->type == FIELD_UINT8) {
        size_t width = (size_t)field->components;
        for (size_t i = 0; i < particles->owned; i++)
            for (size_t c = 0; c < width; c++)
                ((int32_t *)column->data)[i * width + c] = ((const uint8_t *)base + i * stride)[c];
        return;
    }
    for (size_t i = 0; i < particles->owned; i++)
        memcpy((char *)column->data + i * bytes, base + i * stride, bytes);
}

static void fill_column(const struct output_view *view, int f, const struct shown *shown,
                        struct frame_column *column) {
    size_t n = view->particles->owned, components = (size_t)column->components;
    column->data = memory_allocate(n * components, type_bytes(column->type), "frame");
    if (!shown->value) {
        copy_field(view->particles, f, column);
        return;
    }
    double *data = column->data;
#pragma omp parallel for
    for (size_t i = 0; i < n; i++) {
        double value[3];
        shown->value(view, i, value);
        for (size_t d = 0; d < components; d++)
            data[i * components + d] = value[d];
    }
}

static void add_column(struct frame *frame, const struct output_view *view, int f) {
    const struct field *field = fields_get(view->particles, f);
    struct shown shown = shown_of(field);
    assert(frame->columns < OUTPUT_FIELDS_MAX);
    struct frame_column *column = &frame->column[frame->columns++];
    *column = (struct frame_column){.name = shown.name,
                                    .unit = unit_of(field, &shown),
                                    .type = shown_type(field),
                                    .components = field->components,
                                    .spatial = (field->use & FIELD_SPATIAL) != 0,
                                    .fixed = (field->use & FIELD_FIXED) != 0};
    fill_column(view, f, &shown, column);
}

/* The rank of each owned particle's id: equal parts of the range of all ids. */
static int *assign_ranks(const struct frame *frame, const struct comm *comm) {
    const int64_t *id = frame->column[0].data;
    int64_t limits[2] = {INT64_MIN, INT64_MIN}; /* -lowest, highest */
    for (size_t i = 0; i < frame->rows; i++) {
        limits[0] = -id[i] > limits[0] ? -id[i] : limits[0];
        limits[1] = id[i] > limits[1] ? id[i] : limits[1];
    }
    comm_max_int(comm, limits, 2);
    int *rank = memory_allocate(frame->rows, sizeof *rank, "ranks of ids");
    if (limits[1] == INT64_MIN) /* no particles on any rank */
        return rank;
    int64_t lowest = -limits[0], width = (limits[1] - lowest) / comm->size + 1;
    for (size_t i = 0; i < frame->rows; i++)
        rank[i] = (int)((id[i] - lowest) / width);
    return rank;
}

static size_t row_bytes(const struct frame *frame) {
    size_t bytes = 0;
    for (int c = 0; c < frame->columns; c++)
        bytes += frame_column_bytes(&frame->column[c]);
    return bytes;
}

static void pack_row(const struct frame *frame, size_t row, char *to) {
    for (int c = 0; c < frame->columns; c++) {
        size_t bytes = frame_column_bytes(&frame->column[c]);
        memcpy(to, (const char *)frame->column[c].data + row * bytes, bytes);
        to += bytes;
    }
}

/* Sends the rows to the ranks of their ids; returns the rows received, packed. */
static char *send_rows(struct frame *frame, const struct comm *comm, size_t *received) {
    size_t bytes = row_bytes(frame);
    int *rank = assign_ranks(frame, comm);
    struct groups groups;
    rank_groups_make(&groups, rank, frame->rows, comm->size);
    char *packed = memory_allocate(frame->rows, bytes, "rows to send");
    for (size_t k = 0; k < frame->rows; k++)
        pack_row(frame, groups.item[k], packed + k * bytes);
    struct exchange_message *out = memory_allocate(groups.count, sizeof *out, "messages");
    for (size_t g = 0; g < groups.count; g++)
        out[g] = (struct exchange_message){.rank = groups.rank[g],
                                           .bytes = (groups.start[g + 1] - groups.start[g]) * bytes,
                                           .data = packed + groups.start[g] * bytes};
    struct exchange exchange;
    struct exchange_inbox inbox = {0};
    exchange_init(&exchange, comm);
    exchange_sparse(&exchange, out, groups.count, &inbox);
    size_t total = 0, done = 0;
    for (size_t m = 0; m < inbox.count; m++) {
        if (inbox.message[m].bytes % bytes != 0)
            error_fatal(
                "a frame: the message from rank %d has %zu bytes, which is not the length of rows of %zu",
                inbox.message[m].rank, inbox.message[m].bytes, bytes);
        total += inbox.message[m].bytes;
    }
    char *rows = memory_allocate(total, 1, "rows received");
    for (size_t m = 0; m < inbox.count; m++) {
        memcpy(rows + done, inbox.message[m].data, inbox.message[m].bytes);
        done += inbox.message[m].bytes;
    }
    *received = total / bytes;
    exchange_inbox_free(&inbox);
    rank_groups_free(&groups);
    memory_free(out);
    memory_free(packed);
    memory_free(rank);
    return rows;
}

struct numbered {
    int64_t id;
    size_t row;
};

static int compare_ids(const void *a, const void *b) {
    const struct numbered *x = a, *y = b;
    return (x->id > y->id) - (x->id < y->id);
}

/* Replaces the columns by the packed rows, sorted by id (which begins each row). */
static void unpack_sorted(struct frame *frame, const char *packed, size_t rows) {
    size_t bytes = row_bytes(frame);
    struct numbered *order = memory_allocate(rows, sizeof *order, "order of ids");
    for (size_t k = 0; k < rows; k++) {
        memcpy(&order[k].id, packed + k * bytes, sizeof order[k].id);
        order[k].row = k;
    }
    qsort(order, rows, sizeof *order, compare_ids);
    size_t offset = 0;
    for (int c = 0; c < frame->columns; c++) {
        struct frame_column *column = &frame->column[c];
        size_t width = frame_column_bytes(column);
        memory_free(column->data);
        column->data = memory_allocate(rows, width, "frame");
        for (size_t k = 0; k < rows; k++)
            memcpy((char *)column->data + k * width, packed + order[k].row * bytes + offset, width);
        offset += width;
    }
    memory_free(order);
    frame->rows = rows;
}

/* The sum of crossings; beyond 32 bits the number next to it. */
static int32_t image_add(int32_t image, double more) {
    return (int32_t)fmin(fmax(image + more, INT32_MIN), INT32_MAX);
}

/* Crossings as the lattice of the box counts them that the frame shows: the offset of a shear as it is, and not
 * the sum since the start. */
static void settle_images(struct frame *frame) {
    const struct box_motion *motion = &frame->box.motion;
    for (int c = 0; c < frame->columns; c++) {
        int32_t *image = frame->column[c].data;
        if (!motion->shears || strcmp(frame->column[c].name, "image") != 0)
            continue;
        for (size_t k = 0; k < frame->rows; k++)
            image[3 * k + (size_t)motion->flow] = image_add(
                image[3 * k + (size_t)motion->flow], motion->turns * image[3 * k + (size_t)motion->gradient]);
    }
}

void frame_create(struct frame *frame, const struct output_view *view, const struct output_fields *fields) {
    *frame = (struct frame){
        .step = view->step, .time = view->time, .rows = view->particles->owned, .box = *view->box};
    add_column(frame, view, FIELD_ID);
    for (int f = 0; f < fields_count(view->particles); f++)
        if (f != FIELD_ID && wanted(fields, fields_get(view->particles, f)))
            add_column(frame, view, f);
    settle_images(frame);
    size_t received;
    char *packed = send_rows(frame, view->comm, &received);
    unpack_sorted(frame, packed, received);
    memory_free(packed);
    int64_t total = (int64_t)frame->rows;
    frame->first = (uint64_t)comm_scan(view->comm, total);
    comm_sum_int(view->comm, &total, 1);
    frame->total = (uint64_t)total;
}

void frame_free(struct frame *frame) {
    for (int c = 0; c < frame->columns; c++)
        memory_free(frame->column[c].data);
    *frame = (struct frame){0};
}
