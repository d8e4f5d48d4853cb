/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the shapes of rocks, and writes their faces. Read paint.h first. */
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
    *facets = (struct facets){0};
}

static bool has_rocks(const struct scene *scene) {
    return scene && scene->physics_given[PHYSICS_bodies] &&
           ((const struct bodies_options *)(const void *)scene->physics[PHYSICS_bodies])->rocks > 0;
}

bool facets_make(struct facets *facets, const struct scene *scene, struct error *error) {
    bool good = true;
    *facets = (struct facets){0};
    if (!has_rocks(scene))
        return true;
    const struct bodies_options *options = (const void *)scene->physics[PHYSICS_bodies];
    facets->shapes = bodies_shapes_count(options);
    facets->shape = memory_allocate_zero((size_t)facets->shapes, sizeof *facets->shape, "shapes of rocks");
    int number = options->clumps;
    for (int k = 0; good && k < options->rocks; k++)
        for (int v = 0; good && v < bodies_variants(&options->rock[k]); v++)
            good = rock_make(&facets->shape[number++], scene, k, &options->rock[k], v, error);
    if (!good)
        facets_free(facets);
    return good;
}

bool facets_told(const struct facets *facets, const char *path, const struct rows *rows,
                 struct error *error) {
    return facets->shapes == 0 || (rows->rock_shape && rows->rock_orientation) ||
           error_set(
               error, ERROR_USER,
               "%s: the faces of rocks need a checkpoint, or a trajectory with the fields rock_shape and "
               "rock_orientation",
               path);
}

int facets_shape(const struct facets *facets, const struct rows *rows, size_t k) {
    const bool told = rows->rock_shape && rows->rock_orientation && rows->rock_shape[k] < facets->shapes;
    return told && rows->rock_shape[k] >= 0 ? rows->rock_shape[k] : -1;
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
    double centre[3], turn[9];
    const int number = facets_shape(facets, rows, k);
    if (number < 0)
        return false;
    const double scale = rows->radius[k] / facets->shape[number].extent;
    rotor_matrix(rows->rock_orientation[k], turn);
    camera_place(camera, rows->position[k], centre);
    fprintf(out, "object{R%d matrix<", number);
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
