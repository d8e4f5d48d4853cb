/* SPDX-License-Identifier: BSD-3-Clause */
/* From corners, a file or a draw to a rock. Read rock.h first. */
#include "physics/bodies/rock.h"
#include "base/rotor.h"
#include "physics/bodies/shapes/stiff.h"
#include "physics/grains/walls/mesh.h"
#include "physics/grains/walls/wall_inside.h"
#include "base/eigen3.h"
#include "base/memory.h"
#include "base/random.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A solid that fills less than this part of its hull is not convex. */
static const double convex_part = 1 - 1e-4;

/* Draws of a random rock, until one is no sliver. */
enum { DRAWS_MAX = 100 };

/* Sets a user's error at a key of the entry. */
static bool refuse(const struct scene *scene, int number, const char *key, const char *text,
                   struct error *error) {
    char full[64];
    snprintf(full, sizeof full, "bodies.shapes[%d]%s%s", number, key[0] ? "." : "", key);
    return scene_fail(scene, error, full, "%s", text);
}

/* The same of a solid, with what is wrong with it. */
static bool refuse_solid(const struct scene *scene, int number, const char *key, const struct error *why,
                         struct error *error) {
    char text[ERROR_TEXT_MAX / 2];
    snprintf(text, sizeof text, "the solid %.900s", why->text);
    return refuse(scene, number, key, text, error);
}

static bool given_take(struct solid *solid, const struct scene *scene, int number,
                       const struct rock_options *options, struct error *error) {
    struct error why = {0};
    if (options->numbers % 3 != 0)
        return refuse(scene, number, "vertices", "needs three numbers x y z a corner", error);
    return solid_make(solid, (const double(*)[3])options->vertex, (size_t)options->numbers / 3, &why) ||
           refuse_solid(scene, number, "vertices", &why, error);
}

/* Volume of what the triangles of a mesh hold, and its corners. */
static double mesh_take(const struct rock_options *options, double (**point)[3], size_t *points,
                        struct error *error) {
    struct mesh mesh;
    struct moments moments;
    *points = 0;
    *point = NULL;
    if (!mesh_read(&mesh, options->file, "", error))
        return 0;
    moments_solid((const double(*)[9])mesh.corner, mesh.count, &moments);
    *point = memory_allocate(3 * mesh.count, sizeof **point, "corners of a rock");
    for (size_t t = 0; t < mesh.count; t++)
        for (int c = 0; c < 3; c++, ++*points)
            for (int d = 0; d < 3; d++)
                (*point)[*points][d] = options->scale * mesh.corner[t][3 * c + d];
    mesh_free(&mesh);
    return moments.volume * options->scale * options->scale * options->scale;
}

/* A closed surface, unless its hull is asked for. */
static bool is_closed(const struct rock_options *options, struct error *error) {
    struct wall_mesh *mesh = NULL;
    struct wall_mesh_place place = {.scale = options->scale};
    bool closed =
        options->hull || wall_inside_read(&mesh, options->file, &place, "a rock (without hull: true)", error);
    wall_mesh_destroy(&mesh);
    return closed;
}

static bool file_take(struct solid *solid, const struct scene *scene, int number,
                      const struct rock_options *options, struct error *error) {
    struct error why = {0};
    struct moments moments;
    double(*point)[3];
    size_t points;
    if (!is_closed(options, error))
        return false;
    double volume = mesh_take(options, &point, &points, error);
    bool read = point != NULL, good = read && solid_make(solid, (const double(*)[3])point, points, &why);
    memory_free(point);
    if (!read)
        return false;
    if (!good)
        return refuse_solid(scene, number, "file", &why, error);
    solid_moments(solid, &moments);
    if (!options->hull && volume < convex_part * moments.volume) {
        char text[256];
        snprintf(text, sizeof text,
                 "the solid is not convex: it fills %.4g of its hull; hull: true takes the hull, and "
                 "bodies.clumps[].mesh fills the solid with spheres",
                 volume / moments.volume);
        return refuse(scene, number, "file", text, error);
    }
    return true;
}

static bool draw_take(struct solid *solid, const struct scene *scene, int number,
                      const struct rock_options *options, int variant, struct error *error) {
    const struct rock_draw *draw = &options->draw;
    const double axis[3] = {1, draw->elongation, draw->elongation * draw->flatness};
    uint64_t item = (uint64_t)(number * ROCK_VARIANTS_MAX + variant);
    struct random_sequence random = random_sequence(scene->seed, RANDOM_SHAPE, item);
    struct error why;
    for (int n = 0; n < DRAWS_MAX; n++) {
        double point[SOLID_CORNERS_MAX][3];
        why = (struct error){0};
        for (int k = 0; k < draw->corners; k++) {
            double norm = 0;
            for (int d = 0; d < 3; d++) {
                point[k][d] = random_normal(&random);
                norm += point[k][d] * point[k][d];
            }
            for (int d = 0; d < 3; d++)
                point[k][d] *= axis[d] / sqrt(norm);
        }
        if (solid_make(solid, (const double(*)[3])point, (size_t)draw->corners, &why))
            return true;
        solid_free(solid);
    }
    return refuse_solid(scene, number, "random", &why, error);
}

static bool solid_take(struct solid *solid, const struct scene *scene, int number,
                       const struct rock_options *options, int variant, struct error *error) {
    bool file = options->file[0] != '\0';
    if (scene->box.dimension == 2)
        return refuse(scene, number, "", "in two dimensions bodies are clumps (bodies.clumps)", error);
    if (file + (options->numbers > 0) + options->random != 1)
        return refuse(scene, number, "", "needs one of vertices, file and random", error);
    return file              ? file_take(solid, scene, number, options, error)
           : options->random ? draw_take(solid, scene, number, options, variant, error)
                             : given_take(solid, scene, number, options, error);
}

/* The ball around the rock as its only sphere, which has all of its mass. */
static void ball_make(struct clump *clump) {
    clump->extent = solid_extent(&clump->core) + clump->rounding;
    clump->inner = solid_depth(&clump->core, (double[3]){0}) + clump->rounding;
    clump->ease = 1;
    clump->corner = stiff_corner(&clump->core, clump->gyration);
    stiff_seat(&clump->core, clump->rounding, clump->gyration, clump->seat);
    clump->spheres = 1;
    clump->sphere = memory_allocate_zero(1, sizeof *clump->sphere, "ball of a rock");
    clump->share = memory_allocate_zero(1, sizeof *clump->share, "ball of a rock");
    clump->sphere[0].radius = clump->extent;
    clump->share[0] = 1;
    for (int d = 0; d < 3; d++)
        clump->rest[4 * d] = clump->gyration[d] - 0.4 * clump->extent * clump->extent;
}

bool rock_make(struct clump *clump, const struct scene *scene, int number, const struct rock_options *options,
               int variant, struct error *error) {
    struct solid solid = {0};
    struct moments moments;
    struct error why = {0};
    double turn[9];
    *clump = (struct clump){.mass = options->entry.mass};
    if (!solid_take(&solid, scene, number, options, variant, error)) {
        solid_free(&solid);
        return false;
    }
    solid_moments(&solid, &moments);
    eigen3_axes(moments.gyration, clump->gyration, turn);
    moments_quaternion(turn, clump->axes);
    memcpy(clump->centre, moments.centre, sizeof clump->centre);
    clump->volume = moments.volume;
    solid_move(&solid, moments.centre, turn);
    clump->rounding = isnan(options->rounding) ? options->draw.roundness * solid_depth(&solid, (double[3]){0})
                                               : options->rounding;
    bool good = solid_inset(&clump->core, &solid, clump->rounding, &why) ||
                refuse_solid(scene, number, "rounding", &why, error);
    solid_free(&solid);
    if (good)
        ball_make(clump);
    return good;
}
