/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes frames of a simulation for a page. Read shot.h first. */
#include "front/view/shot.h"
#include "base/memory.h"
#include "base/mix.h"
#include "data/observe/report_json.h"
#include "kernel/particles/fields.h"
#include <inttypes.h>
#include <math.h>
#include <string.h>

enum { ABOUT_ROOM = 65536 };

struct row {
    float x[3], radius, value;
};

/* The fields that can give the colour: those that files show, velocity first, without the position. */
static struct field_list fields_shown(const struct particles *particles) {
    struct field_list all = fields_with(particles, FIELD_OUTPUT), shown = fields_one(FIELD_VELOCITY);
    for (int k = 0; k < all.count; k++)
        if (all.field[k] != FIELD_VELOCITY && all.field[k] != FIELD_POSITION)
            shown.field[shown.count++] = all.field[k];
    return shown;
}

char *shot_about(const struct scene *scene, const struct box *box, const struct particles *particles) {
    char *text = memory_allocate_zero(ABOUT_ROOM, 1, "live view");
    FILE *file = fmemopen(text, ABOUT_ROOM - 1, "w");
    struct field_list shown = fields_shown(particles);
    bool plain = scene->units == SCENE_UNITS_NONE;
    if (file == NULL)
        error_fatal("out of memory: live view");
    fprintf(file, "{\"title\": ");
    report_json_text(file, scene->title);
    fprintf(file, ", \"dimension\": %d, \"lower\": [%.9g, %.9g, %.9g], \"fields\": [", box->dimension,
            box->origin[0], box->origin[1], box->origin[2]);
    for (int k = 0; k < shown.count; k++) {
        const struct field *field = fields_get(particles, shown.field[k]);
        fprintf(file, "%s{\"name\": ", k ? ", " : "");
        report_json_text(file, field->name);
        fprintf(file, ", \"unit\": ");
        report_json_text(file, field->unit && !plain ? field->unit : "");
        fprintf(file, "}");
    }
    fprintf(file, "]}\n");
    fclose(file);
    return text;
}

static double number_of(const struct field *field, const char *at, int k) {
    switch (field->type) {
    case FIELD_DOUBLE:
        return ((const double *)at)[k];
    case FIELD_INT64:
        return (double)((const int64_t *)at)[k];
    case FIELD_INT32:
        return ((const int32_t *)at)[k];
    default:
        return ((const uint8_t *)at)[k];
    }
}

/* A number, or the length of a vector. */
static double value_of(const struct field *field, const char *at) {
    if (field->components == 1)
        return number_of(field, at, 0);
    double sum = 0;
    if (field->components == 3 && field->type == FIELD_DOUBLE) {
        const double *v = (const double *)(const void *)at;
        return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    for (int k = 0; k < field->components; k++)
        sum += number_of(field, at, k) * number_of(field, at, k);
    return sqrt(sum);
}

/* A number in [0, 1) that belongs to an id. */
static double draw(int64_t id) {
    return (double)(mix_bits((uint64_t)id * MIX_GOLDEN) >> 11) * 0x1p-53;
}

/* The part of each size class that a frame has: the classes with the fewest particles take what they need of equal
 * shares, and leave the rest to the others. */
static void shares_find(const struct size_classes *classes, double share[CLASS_MAX]) {
    double left = SHOT_MOST;
    bool done[CLASS_MAX] = {false};
    for (int waiting = classes->count; waiting > 0; waiting--) {
        int least = -1;
        for (int c = 0; c < classes->count; c++)
            if (!done[c] && (least < 0 || classes->population[c] < classes->population[least]))
                least = c;
        double has = (double)classes->population[least], gets = fmin(has, left / waiting);
        share[least] = has > 0 ? gets / has : 1;
        left -= gets;
        done[least] = true;
    }
}

/* Fills the rows of this rank's particles, of a part of each class if `thin`; returns their number. */
static size_t rows_fill(const struct particles *p, const struct size_classes *classes, const struct box *box,
                        bool thin, int field, struct row *rows) {
    struct field_list shown = fields_shown(p);
    int f = shown.field[field >= 0 && field < shown.count ? field : 0];
    const struct field *of = fields_get(p, f);
    size_t stride, count = 0;
    const char *values = fields_base(p, f, &stride);
    double share[CLASS_MAX];
    shares_find(classes, share);
    for (size_t i = 0; i < p->owned; i++) {
        const struct particle_state *state = &p->state[i];
        if (thin && draw(p->id[i]) >= share[p->size_class[i]])
            continue;
        struct row *row = &rows[count++];
        for (int d = 0; d < 3; d++)
            row->x[d] = (float)(state->x[d] + box->origin[d]);
        row->radius = (float)state->radius;
        row->value = (float)value_of(of, values + i * stride);
    }
    return count;
}

/* Writes the head of a frame of `count` particles. */
static void head_write(const struct simulation *s, int field, bool paused, size_t count, char *head) {
    char text[SHOT_HEAD];
    snprintf(text, sizeof text,
             "{\"step\": %" PRIu64 ", \"time\": %.9g, \"dt\": %.9g, \"count\": %zu, \"total\": %" PRIu64
             ", \"paused\": %s, \"field\": %d, \"edge\": [%.9g, %.9g, %.9g]}",
             s->clock.step, s->clock.time, s->clock.dt, count, s->total, paused ? "true" : "false", field,
             s->box.edge[0], s->box.edge[1], s->box.edge[2]);
    memset(head, ' ', SHOT_HEAD);
    memcpy(head, text, strlen(text));
}

char *shot_take(const struct simulation *s, int field, bool paused, size_t *bytes) {
    char *frame = memory_allocate(SHOT_HEAD + s->particles->owned * sizeof(struct row), 1, "live view");
    size_t count = rows_fill(s->particles, &s->classes, &s->box, s->total > SHOT_MOST, field,
                             (struct row *)(void *)(frame + SHOT_HEAD));
    if (s->comm->size > 1) {
        void *all = NULL;
        size_t own = count * sizeof(struct row);
        size_t whole = comm_gather_varying(s->comm, frame + SHOT_HEAD, own, &all, NULL);
        memory_free(frame);
        if (s->comm->rank != 0)
            return NULL;
        frame = memory_allocate(SHOT_HEAD + whole, 1, "live view");
        memcpy(frame + SHOT_HEAD, all, whole);
        memory_free(all);
        count = whole / sizeof(struct row);
    }
    head_write(s, field, paused, count, frame);
    *bytes = SHOT_HEAD + count * sizeof(struct row);
    return frame;
}
