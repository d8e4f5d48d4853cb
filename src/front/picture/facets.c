/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads the orientations of rocks, and writes their faces. Read paint.h first. */
#include "front/picture/paint.h"
#include "base/memory.h"
#include "base/rotor.h"
#include "physics/bodies/bodies_shapes.h"
#include "physics_table.h"
#include <math.h>

void facets_free(struct facets *facets) {
    for (int k = 0; k < facets->shapes; k++)
        clump_free(&facets->shape[k]);
    memory_free(facets->shape);
    memory_free(facets->number);
    memory_free(facets->turn);
    *facets = (struct facets){0};
}

static bool has_rocks(const struct scene *scene) {
    return scene && scene->physics_given[PHYSICS_bodies] &&
           ((const struct bodies_options *)(const void *)scene->physics[PHYSICS_bodies])->rocks > 0;
}

/* Makes the shapes in the order of struct bodies; clumps stay empty. False: one cannot be made. */
static bool shapes_take(struct facets *facets, const struct scene *scene, struct error *error) {
    const struct bodies_options *options = (const void *)scene->physics[PHYSICS_bodies];
    bool good = true;
    facets->shapes = bodies_shapes_count(options);
    facets->shape = memory_allocate_zero((size_t)facets->shapes, sizeof *facets->shape, "shapes of rocks");
    int number = options->clumps;
    for (int k = 0; good && k < options->rocks; k++)
        for (int v = 0; good && v < bodies_variants(&options->rock[k]); v++)
            good = rock_make(&facets->shape[number++], scene, k, &options->rock[k], v, error);
    return good;
}

/* A component of a field; NULL: the file lacks it. */
static double *values_of(const struct source *source, const char *name, int component, int64_t frame,
                         const struct rows *rows) {
    struct picture_source_field field = {.component = component, .numbered = true};
    struct error error = {0};
    snprintf(field.name, sizeof field.name, "%s", name);
    return source->h5md || source->checkpoint ? picture_source_values(source, &field, frame, rows, &error)
                                              : NULL;
}

static bool turns_take(struct facets *facets, const struct source *source, int64_t frame,
                       const struct rows *rows) {
    double *shape = values_of(source, "rock_shape", 0, frame, rows), *q[4] = {NULL};
    bool good = shape != NULL;
    for (int c = 0; c < 4 && good; c++)
        good = (q[c] = values_of(source, "rock_orientation", c, frame, rows)) != NULL;
    facets->number = memory_allocate(rows->count, sizeof *facets->number, "rocks");
    facets->turn = memory_allocate(rows->count, sizeof *facets->turn, "rocks");
    for (size_t k = 0; k < rows->count; k++) {
        bool rock = good && shape[k] >= 0 && shape[k] < facets->shapes;
        facets->number[k] = rock ? (int)shape[k] : -1;
        if (rock)
            rotor_matrix((double[4]){q[0][k], q[1][k], q[2][k], q[3][k]}, facets->turn[k]);
    }
    memory_free(shape);
    for (int c = 0; c < 4; c++)
        memory_free(q[c]);
    return good;
}

bool *facets_bodies(const struct source *source, int64_t frame, const struct rows *rows) {
    bool *body = memory_allocate_zero(rows->count, sizeof *body, "bodies");
    const bool may_be = source->scene && source->scene->physics_given[PHYSICS_bodies];
    double *mass = may_be ? values_of(source, "body_mass", 0, frame, rows) : NULL;
    for (size_t k = 0; mass && k < rows->count; k++)
        body[k] = mass[k] > 0;
    memory_free(mass);
    return body;
}

bool facets_make(struct facets *facets, const struct source *source, int64_t frame, const struct rows *rows,
                 struct error *error) {
    *facets = (struct facets){.rows = rows->count};
    if (!has_rocks(source->scene))
        return true;
    bool good =
        shapes_take(facets, source->scene, error) &&
        (turns_take(facets, source, frame, rows) ||
         error_set(error, ERROR_USER,
                   "%s: the faces of rocks need a checkpoint, or a trajectory with the fields rock_shape and "
                   "rock_orientation",
                   source->path));
    if (!good)
        facets_free(facets);
    return good;
}

static void write_place(FILE *out, const double x[3], const double along[3], double by) {
    fprintf(out, "<%.6g,%.6g,%.6g>", x[0] + by * along[0], x[1] + by * along[1], x[2] + by * along[2]);
}

static void declare(FILE *out, const struct clump *shape, int number) {
    const struct solid *core = &shape->core;
    const double r = shape->rounding, none[3] = {0};
    fprintf(out, "#declare R%d = union{mesh{\n", number);
    for (int f = 0; f < core->faces; f++) {
        const struct solid_face *face = &core->face[f];
        const int *ring = core->ring + face->first;
        for (int c = 2; c < face->sides; c++) {
            const int of[3] = {ring[0], ring[c - 1], ring[c]};
            fprintf(out, "triangle{");
            for (int k = 0; k < 3; k++) {
                write_place(out, core->corner[of[k]], face->normal, r);
                fprintf(out, k < 2 ? "," : "}\n");
            }
        }
    }
    fprintf(out, "}\n");
    for (int e = 0; e < core->edges; e++) {
        fprintf(out, "cylinder{");
        write_place(out, core->corner[core->edge[e].end[0]], none, 0);
        fprintf(out, ",");
        write_place(out, core->corner[core->edge[e].end[1]], none, 0);
        fprintf(out, ",%.6g open}\n", r);
    }
    for (int c = 0; c < core->corners; c++) {
        fprintf(out, "sphere{");
        write_place(out, core->corner[c], none, 0);
        fprintf(out, ",%.6g}\n", r);
    }
    fprintf(out, "}\n");
}

void facets_declare(FILE *out, const struct facets *facets) {
    for (int k = 0; k < facets->shapes; k++)
        if (facets->shape[k].core.corners > 0)
            declare(out, &facets->shape[k], k);
}

bool facets_write(FILE *out, const struct facets *facets, const struct camera *camera,
                  const struct rows *rows, size_t k) {
    double centre[3];
    if (facets->shapes == 0 || facets->number[k] < 0)
        return false;
    const double scale = rows->radius[k] / facets->shape[facets->number[k]].extent, *turn = facets->turn[k];
    camera_place(camera, rows->position[k], centre);
    fprintf(out, "object{R%d matrix<", facets->number[k]);
    for (int c = 0; c < 3; c++) {
        double there[3], at[3];
        for (int d = 0; d < 3; d++)
            there[d] = rows->position[k][d] + rows->radius[k] * turn[3 * d + c];
        camera_place(camera, there, at);
        for (int d = 0; d < 3; d++)
            fprintf(out, "%.6g,", (at[d] - centre[d]) * scale / rows->radius[k]);
    }
    fprintf(out, "%.6g,%.6g,%.6g> ", centre[0], centre[1], centre[2]);
    return true;
}
