/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes frames of a simulation for a page. Read shot.h first. */
#include "front/view/shot.h"
#include "base/memory.h"
#include "base/mix.h"
#include "data/observe/report_json.h"
#include "front/view/shot_rocks.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A row, in a run with rocks. */
enum { ROW_RADIUS = 3, ROW_VALUE, ROW_ROCK, ROW_MOST = ROW_ROCK + SHOT_ROCK_NUMBERS };
_Static_assert((int)ROW_ROCK == (int)SHOT_NUMBERS, "the page knows the rows");

/* The fields that can give the colour: those that files show, velocity first, without the position. */
static struct field_list fields_shown(const struct particles *particles) {
    struct field_list all = fields_with(particles, FIELD_OUTPUT), shown = fields_one(FIELD_VELOCITY);
    for (int k = 0; k < all.count; k++)
        if (all.field[k] != FIELD_VELOCITY && all.field[k] != FIELD_POSITION)
            shown.field[shown.count++] = all.field[k];
    return shown;
}

char *shot_about(const struct simulation *s) {
    char *text = NULL;
    size_t bytes = 0;
    FILE *file = open_memstream(&text, &bytes);
    struct field_list shown = fields_shown(s->particles);
    bool plain = s->scene->units == SCENE_UNITS_NONE;
    if (file == NULL)
        error_fatal("out of memory: live view");
    fprintf(file, "{\"title\": ");
    report_json_text(file, s->scene->title);
    fprintf(file, ", \"dimension\": %d, \"lower\": [%.9g, %.9g, %.9g], \"fields\": [", s->box.dimension,
            s->box.origin[0], s->box.origin[1], s->box.origin[2]);
    for (int k = 0; k < shown.count; k++) {
        const struct field *field = fields_get(s->particles, shown.field[k]);
        fprintf(file, "%s{\"name\": ", k ? ", " : "");
        report_json_text(file, field->name);
        fprintf(file, ", \"unit\": ");
        report_json_text(file, field->unit && !plain ? field->unit : "");
        fprintf(file, "}");
    }
    fprintf(file, "]");
    if (shot_rocks_there(s)) {
        fprintf(file, ", \"shapes\": ");
        shot_rocks_write(file, s);
    }
    fprintf(file, "}\n");
    fclose(file);
    char *about = memory_allocate(bytes + 1, 1, "live view");
    memcpy(about, text, bytes + 1);
    free(text);
    return about;
}

/* A number, or the length of a vector. */
static double value_of(const struct field *field, const char *at) {
    if (field->components == 1)
        return fields_component(field, at, 0);
    double sum = 0;
    if (field->components == 3 && field->type == FIELD_DOUBLE) {
        const double *v = (const double *)(const void *)at;
        return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    for (int k = 0; k < field->components; k++)
        sum += fields_component(field, at, k) * fields_component(field, at, k);
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

/* Fills the rows of this rank's particles, of `numbers` floats each; returns how many are shown, and counts those of which
 * they are a part. */
static size_t rows_fill(const struct simulation *s, int field, int numbers, float *rows, int64_t *all) {
    const struct particles *p = s->particles;
    struct field_list shown = fields_shown(p);
    int f = shown.field[field >= 0 && field < shown.count ? field : 0];
    const struct field *of = fields_get(p, f);
    size_t stride, count = 0;
    const char *values = fields_base(p, f, &stride);
    double share[CLASS_MAX];
    const uint8_t *kind = kinds_of(p);
    bool thin = s->total > SHOT_MOST;
    shares_find(&s->classes, share);
    *all = 0;
    for (size_t i = 0; i < p->owned; i++) {
        const struct particle_state *state = &p->state[i];
        if (kind && kind[i] == KIND_BODY)
            continue;
        ++*all;
        if (thin && draw(p->id[i]) >= share[p->size_class[i]])
            continue;
        float *row = rows + (size_t)numbers * count++;
        for (int d = 0; d < 3; d++)
            row[d] = (float)(state->x[d] + s->box.origin[d]);
        row[ROW_RADIUS] = (float)state->radius;
        row[ROW_VALUE] = (float)value_of(of, values + i * stride);
        if (numbers > ROW_ROCK)
            shot_rocks_take(s, i, row + ROW_ROCK);
    }
    return count;
}

/* What a frame holds. */
struct held {
    size_t count; /* rows */
    int64_t all;  /* particles of which they are a part */
    int numbers;  /* of a row */
};

/* Writes the head of a frame. */
static void head_write(const struct simulation *s, int field, bool paused, const struct held *held,
                       char *head) {
    char text[SHOT_HEAD];
    snprintf(text, sizeof text,
             "{\"step\": %" PRIu64 ", \"time\": %.9g, \"dt\": %.9g, \"count\": %zu, \"total\": %" PRId64
             ", \"numbers\": %d, \"paused\": %s, \"field\": %d, \"edge\": [%.9g, %.9g, %.9g]}",
             s->clock.step, s->clock.time, s->clock.dt, held->count, held->all, held->numbers,
             paused ? "true" : "false", field, s->box.edge[0], s->box.edge[1], s->box.edge[2]);
    memset(head, ' ', SHOT_HEAD);
    memcpy(head, text, strlen(text));
}

char *shot_take(const struct simulation *s, int field, bool paused, size_t *bytes) {
    struct held held = {.numbers = shot_rocks_there(s) ? ROW_MOST : ROW_ROCK};
    const size_t row = (size_t)held.numbers * sizeof(float);
    char *frame = memory_allocate(SHOT_HEAD + s->particles->owned * row, 1, "live view");
    held.count = rows_fill(s, field, held.numbers, (float *)(void *)(frame + SHOT_HEAD), &held.all);
    comm_sum_int(s->comm, &held.all, 1);
    if (s->comm->size > 1) {
        void *all = NULL;
        size_t own = held.count * row;
        size_t whole = comm_gather_varying(s->comm, frame + SHOT_HEAD, own, &all, NULL);
        memory_free(frame);
        if (s->comm->rank != 0)
            return NULL;
        frame = memory_allocate(SHOT_HEAD + whole, 1, "live view");
        memcpy(frame + SHOT_HEAD, all, whole);
        memory_free(all);
        held.count = whole / row;
    }
    head_write(s, field, paused, &held, frame);
    *bytes = SHOT_HEAD + held.count * row;
    return frame;
}
