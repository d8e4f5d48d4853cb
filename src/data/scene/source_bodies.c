/* SPDX-License-Identifier: BSD-3-Clause */
/* The bodies of a trajectory: rows that are bodies begin as such again, and the rows of their members go. Read source_bodies.h and source_makers.h
 * first.
 *
 * Of a body counts its own row (kind, body_part, orientation), or of a rock the row of its ball (kind, rock_shape,
 * rock_orientation), where the file lacks a field of the first three. Numbers of shapes are those of the run that wrote the file. Its
 * shapes have names, by which those of the scene are found; rocks must have the same corners. */
#include "data/scene/source_bodies.h"
#include "data/scene/scene_shapes.h"
#include "data/scene/source_makers.h"

#include "base/memory.h"
#include "base/rotor.h"
#include "data/formats/h5md_read.h"
#include "kernel/particles/kinds.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Numbers of shapes that a file may have. */
enum { NUMBERS_MAX = 1 << 14 };

/* Corners agree up to this part of the radius. */
static const double corner_part = 1e-5;

/* What a row is. */
enum role { ROLE_NONE, ROLE_GRAIN, ROLE_BODY, ROLE_UNCLEAR };

struct bodies_reading {
    const struct scene *scene;
    const struct source_options *source;
    struct rows *rows;
    bool own;                  /* bodies have rows of their own that tell all */
    struct output_shapes list; /* of the file */
    int numbers, *shape;       /* of the scene, by the number in the file; -1: not looked up yet */
    struct error *error;
};

static __attribute__((format(printf, 2, 3))) bool refuse(const struct bodies_reading *b, const char *format,
                                                         ...) {
    char text[ERROR_TEXT_MAX / 2];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return error_set(b->error, ERROR_USER, "%.700s: %s", b->source->file, text);
}

/* The role of row k; of a body the number of its shape in the file, and its orientation. */
static enum role role_of(const struct bodies_reading *b, size_t k, int *number, const double **turn) {
    const struct rows *rows = b->rows;
    const int kind = rows->kind ? rows->kind[k] : KIND_GRAIN;
    const bool rock = rows->rock_shape && rows->rock_orientation && rows->rock_shape[k] >= 0;
    const bool member = rows->body && rows->body[k] >= 0;
    if (kind == KIND_BODY && b->own) {
        *number = rows->body_part[k];
        *turn = rows->orientation[k];
        return ROLE_BODY;
    }
    if (kind != KIND_GRAIN || (b->own && (rock || member)))
        return ROLE_NONE;
    if (rock) {
        *number = rows->rock_shape[k];
        *turn = rows->rock_orientation[k];
        return rows->kind ? ROLE_BODY : ROLE_UNCLEAR;
    }
    return member ? ROLE_UNCLEAR : ROLE_GRAIN;
}

/* The shape of the list with a number, NULL: none; and how many of the same name stand before it. */
static const struct output_shape *listed(const struct output_shapes *list, int number, int *before) {
    const struct output_shape *found = NULL;
    for (int k = 0; k < list->count; k++)
        if (list->shape[k].number == number)
            found = &list->shape[k];
    *before = 0;
    for (int k = 0; found && k < list->count; k++)
        *before += list->shape[k].number < number && strcmp(list->shape[k].name, found->name) == 0;
    return found;
}

static bool corners_agree(const struct output_shape *a, const struct output_shape *b) {
    bool agree = a->corners == b->corners;
    for (int c = 0; c < a->corners && agree; c++)
        for (int d = 0; d < 3; d++)
            agree = agree && fabs(a->corner[c][d] / a->radius - b->corner[c][d] / b->radius) <= corner_part;
    return agree;
}

/* The shape of the scene for a number of the file; -1, with an error: there is none such. */
static int shape_find(const struct bodies_reading *b, int number) {
    const struct scene_shapes *shapes = b->scene->shapes;
    char why[1200];
    int before, none;
    const struct output_shape *of_file = listed(&b->list, number, &before), *of_scene = NULL;
    const bool clump = number < shapes->shapes && listed(&shapes->drawn, number, &none) == NULL;
    if (of_file == NULL && number < shapes->shapes && (clump || b->list.count == 0))
        return number; /* files have no names of clumps */
    if (of_file == NULL) {
        refuse(b, "has a body of shape number %d, and the scene has no such entry of bodies", number);
        return -1;
    }
    const int entry = scene_shapes_find(shapes, of_file->name, why, sizeof why);
    if (entry < 0) {
        refuse(b, "has bodies of the shape '%s': %.600s", of_file->name, why);
        return -1;
    }
    const int shape = shapes->entry[entry].first + before;
    if (before < shapes->entry[entry].shapes)
        of_scene = listed(&shapes->drawn, shape, &none);
    if (of_scene && corners_agree(of_file, of_scene))
        return shape;
    refuse(b,
           "has bodies of the shape '%s' with other corners than the entry of the scene; needed: the same "
           "rounding, and the "
           "same vertices, file or random corners (of the same seed, at the same place in bodies.shapes)",
           of_file->name);
    return -1;
}

/* The same, looked up once for each number. */
static int shape_of(struct bodies_reading *b, int number) {
    if (number < 0 || number >= NUMBERS_MAX) {
        refuse(b, "has a body of shape number %d; allowed: 0 to %d", number, NUMBERS_MAX - 1);
        return -1;
    }
    if (number >= b->numbers) {
        b->shape = memory_resize(b->shape, (size_t)number + 1, sizeof *b->shape, "shapes of a file");
        while (b->numbers <= number)
            b->shape[b->numbers++] = -1;
    }
    if (b->shape[number] < 0)
        b->shape[number] = shape_find(b, number);
    return b->shape[number];
}

/* A quaternion in the frame of the entry. In two dimensions only the turn about z is left of it. */
static void turn_take(const struct scene *scene, const double axes[4], const double turn[4], double to[4]) {
    const double back[4] = {axes[0], -axes[1], -axes[2], -axes[3]};
    rotor_product(turn, back, to);
    for (int d = 1; d < 3 && scene->box.dimension == 2; d++)
        to[d] = 0;
}

/* Makes row `to` the grain that becomes the body of row k again. */
static bool body_take(struct bodies_reading *b, struct source_batch *batch, size_t k, size_t to, int number,
                      const double turn[4]) {
    struct rows *rows = b->rows;
    const struct scene_shapes *shapes = b->scene->shapes;
    const int s = shape_of(b, number);
    double q[4];
    if (s < 0)
        return false;
    const struct scene_shape *shape = &shapes->shape[s];
    const double ball = rows->radius[k] * b->source->scale;
    const double mass = b->own ? (rows->body_mass ? rows->body_mass[k] : 0) : rows->mass ? rows->mass[k] : 0;
    if (!scene_shapes_may_turn(turn, 3))
        return refuse(b, "particle %lld: its orientation is no quaternion",
                      rows->id ? (long long)rows->id[k] : (long long)k + 1);
    if (shape->drawn > 0 && !(fabs(ball / shape->drawn - 1) < corner_part))
        return refuse(
            b,
            "has a body '%s' in a ball of radius %.9g, and with size: drawn all have %.9g; allowed: another "
            "size of the entry",
            shapes->entry[shape->entry].name, ball, shape->drawn);
    turn_take(b->scene, shape->axes, turn, q);
    rows_move(rows, k, to);
    memcpy(rows->orientation[to], q, sizeof q);
    rows->mass[to] = mass / shape->solid; /* that of the whole ball */
    batch->form[to] = (struct source_row){.shape = shape->entry + 1,
                                          .variant = s - shapes->entry[shape->entry].first + 1,
                                          .ball = shape->grain,
                                          .solid = shape->solid / pow(shape->grain, 3)};
    return true;
}

static void grain_take(struct source_batch *batch, size_t k, size_t to) {
    rows_move(&batch->rows, k, to);
    memset(batch->rows.orientation[to], 0, sizeof batch->rows.orientation[to]);
    batch->form[to] = (struct source_row){.shape = -1, .ball = 1, .solid = 1};
}

/* Takes the roles of all rows. */
static bool roles_take(struct bodies_reading *b, struct source_batch *batch) {
    struct rows *rows = b->rows;
    size_t kept = 0;
    for (size_t k = 0; k < rows->count; k++) {
        int number = -1;
        const double *turn = NULL;
        const enum role role = role_of(b, k, &number, &turn);
        if (role == ROLE_UNCLEAR)
            return refuse(
                b,
                "has bodies, but not all fields that tell what they are; needed: kind, body, body_part and "
                "orientation, or of rocks kind, rock_shape and rock_orientation");
        if (role == ROLE_NONE)
            continue;
        if (role == ROLE_GRAIN)
            grain_take(batch, k, kept);
        else if (!body_take(b, batch, k, kept, number, turn))
            return false;
        kept++;
    }
    rows->count = kept;
    return kept > 0 || refuse(b, "has no grains and no bodies");
}

/* True if some row is a body or a part of one. */
static bool has_bodies(const struct rows *rows) {
    for (size_t k = 0; k < rows->count; k++)
        if ((rows->kind && rows->kind[k] == KIND_BODY) || (rows->body && rows->body[k] >= 0) ||
            (rows->rock_shape && rows->rock_shape[k] >= 0))
            return true;
    return false;
}

/* Orientations without shapes, as other programs write them: in the frame of the entry that the source names. */
static bool turns_take(const struct bodies_reading *b) {
    struct rows *rows = b->rows;
    if (rows->orientation == NULL) {
        rows->orientation = rows->rock_orientation;
        rows->rock_orientation = NULL;
    }
    if (rows->orientation && b->scene->shapes && b->source->form.shape == 0)
        return refuse(
            b,
            "has orientations, and nothing says of what; needed: `shape` of the source, the name of an entry "
            "of bodies");
    for (size_t k = 0; rows->orientation && b->source->form.shape > 0 && k < rows->count; k++)
        if (!scene_shapes_may_turn(rows->orientation[k], b->scene->box.dimension))
            return refuse(b, "particle %lld: its orientation is no quaternion%s",
                          rows->id ? (long long)rows->id[k] : (long long)k + 1,
                          b->scene->box.dimension == 2 ? " about z, which is all that turns in two dimensions"
                                                       : "");
    return true;
}

bool source_bodies_take(const struct scene *scene, int source, struct source_batch *batch,
                        struct error *error) {
    struct rows *rows = &batch->rows;
    struct bodies_reading b = {
        .scene = scene, .source = &scene->source[source], .rows = rows, .error = error};
    b.own = rows->kind && rows->body && rows->body_part && rows->orientation;
    if (!has_bodies(rows))
        return rows->kind || rows->rock_shape || turns_take(&b);
    if (scene->shapes == NULL)
        return refuse(
            &b, "has rigid bodies, and the scene has no section bodies; needed: entries there with their "
                "names and shapes");
    if (b.source->form.shape > 0)
        return refuse(&b, "has rigid bodies whose shapes it tells; leave `shape` of the source out");
    if (!output_shapes_read(b.source->file, &b.list, error))
        return false;
    batch->form = memory_allocate_zero(rows->count, sizeof *batch->form, "bodies of a file");
    if (rows->orientation == NULL)
        rows->orientation = memory_allocate_zero(rows->count, sizeof *rows->orientation, "bodies of a file");
    if (rows->mass == NULL)
        rows->mass = memory_allocate_zero(rows->count, sizeof *rows->mass, "bodies of a file");
    bool good = roles_take(&b, batch);
    output_shapes_free(&b.list);
    memory_free(b.shape);
    return good;
}

bool source_bodies_told(const struct scene *scene, int source, bool *told, struct error *error) {
    const struct source_options *options = &scene->source[source];
    *told = false;
    if (options->kind != SOURCE_FILE || options->format == SOURCE_LAMMPS_DATA)
        return true;
    if (options->format == SOURCE_TABLE)
        return table_names_shapes(scene, source, told, error);
    return h5md_has_field(options->file, "body_part", told, error) &&
           (*told || h5md_has_field(options->file, "rock_shape", told, error));
}
