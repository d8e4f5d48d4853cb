/* SPDX-License-Identifier: BSD-3-Clause */
/* From a list of spheres to a rigid body: mass, centre of mass, principal axes, shares of the mass. Read clump.h
 * first. */
#include "physics/bodies/clump.h"
#include "physics/bodies/inscribe.h"
#include "base/rotor.h"
#include "base/eigen3.h"
#include "base/memory.h"
#include "base/numbers.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Spheres that are this much nearer than their radii still touch only. */
#define CLUMP_TOUCH 1e-9

/* Sets a user's error at a key of the entry. */
static bool refuse(const struct scene *scene, int number, const char *key, const char *text,
                   struct error *error) {
    char full[64];
    snprintf(full, sizeof full, "bodies.clumps[%d]%s%s", number, key[0] ? "." : "", key);
    return scene_fail(scene, error, full, "%s", text);
}

static bool file_read(struct clump *clump, const struct clump_options *options, struct error *error) {
    struct numbers table = {0};
    if (!numbers_read(&table, options->file, 4, error))
        return false;
    clump->spheres = (int)table.rows;
    clump->sphere = memory_allocate_zero(table.rows + 1, sizeof *clump->sphere, "spheres of a body");
    bool good =
        table.rows > 0 || error_set(error, ERROR_USER, "%s: no sphere; a row is x y z radius", options->file);
    for (size_t k = 0; good && k < table.rows; k++) {
        const double *row = table.value + 4 * k;
        for (int d = 0; d < 3; d++)
            clump->sphere[k].centre[d] = row[d] * options->scale;
        clump->sphere[k].radius = row[3] * options->scale;
        good = row[3] > 0 ||
               error_set(error, ERROR_USER, "%s:%u: the radius must be > 0", options->file, table.line[k]);
    }
    numbers_free(&table);
    return good;
}

/* Fills a mesh, whose moments are those of the body. */
static bool mesh_take(struct clump *clump, const struct scene *scene, int number,
                      const struct clump_options *options, struct moments *moments, struct error *error) {
    if (scene->box.dimension == 2)
        return refuse(scene, number, "mesh", "in two dimensions bodies are made of spheres or a file", error);
    struct inscribe_options how = {options->mesh, options->scale, options->mesh_spheres};
    struct moments inside;
    clump->sphere =
        memory_allocate_zero((size_t)options->mesh_spheres, sizeof *clump->sphere, "spheres of a body");
    clump->spheres = inscribe_spheres(&how, clump->sphere, moments, error);
    if (clump->spheres == 0)
        return false;
    moments_union(clump->sphere, clump->spheres, &inside);
    clump->filled = inside.volume / moments->volume;
    return true;
}

/* Takes the members; of a mesh, `moments` too. */
static bool spheres_take(struct clump *clump, const struct scene *scene, int number,
                         const struct clump_options *options, struct moments *moments, struct error *error) {
    bool file = options->file[0] != '\0', mesh = options->mesh[0] != '\0';
    if (file + mesh + (options->spheres > 0) != 1)
        return refuse(scene, number, "", "needs one of spheres, file and mesh", error);
    if (mesh)
        return mesh_take(clump, scene, number, options, moments, error);
    if (file && !file_read(clump, options, error))
        return false;
    if (!file) {
        clump->spheres = options->spheres;
        clump->sphere =
            memory_allocate_zero((size_t)clump->spheres, sizeof *clump->sphere, "spheres of a body");
        memcpy(clump->sphere, options->sphere, (size_t)clump->spheres * sizeof *clump->sphere);
    }
    for (int k = 0; scene->box.dimension == 2 && k < clump->spheres; k++)
        if (clump->sphere[k].centre[2] != 0)
            return refuse(scene, number, file ? "file" : "spheres",
                          "in two dimensions all spheres lie in the plane: z must be 0", error);
    return true;
}

static bool overlaps(const struct clump *clump) {
    for (int a = 0; a < clump->spheres; a++)
        for (int b = 0; b < a; b++) {
            const struct clump_sphere *s = &clump->sphere[a], *t = &clump->sphere[b];
            double square = 0, touch = (s->radius + t->radius) * (1 - CLUMP_TOUCH);
            for (int d = 0; d < 3; d++)
                square += (s->centre[d] - t->centre[d]) * (s->centre[d] - t->centre[d]);
            if (square < touch * touch)
                return true;
        }
    return false;
}

/* Replaces what the spheres give by what the entry gives. */
static bool given_take(struct clump *clump, struct moments *moments, const struct scene *scene, int number,
                       const struct clump_options *options, struct error *error) {
    clump->mass = options->entry.mass;
    if (options->centre_given != 0 && options->centre_given != 3)
        return refuse(scene, number, "centre", "needs three numbers", error);
    if (options->inertia_given != 0 && options->inertia_given != 6)
        return refuse(scene, number, "inertia", "needs six numbers: xx yy zz xy xz yz", error);
    if (options->centre_given && !options->inertia_given)
        return refuse(scene, number, "centre", "needs inertia, too: about this centre", error);
    if (options->inertia_given && isnan(options->entry.mass))
        return refuse(scene, number, "inertia", "needs mass, too", error);
    if (options->centre_given)
        memcpy(moments->centre, options->centre, sizeof moments->centre);
    if (options->inertia_given) {
        static const int place[9] = {0, 3, 4, 3, 1, 5, 4, 5, 2};
        for (int k = 0; k < 9; k++)
            moments->gyration[k] = options->inertia[place[k]] / options->entry.mass;
    }
    return true;
}

static bool axes_find(struct clump *clump, const struct moments *moments, const struct scene *scene,
                      int number, struct error *error) {
    double turn[9], *g = clump->gyration;
    eigen3_axes(moments->gyration, g, turn);
    if (!(g[0] > 0) || g[0] + g[1] < g[2] * (1 - 1e-9))
        return refuse(scene, number, "inertia",
                      "no body has such moments of inertia: the principal ones must be > 0, and none larger "
                      "than the sum "
                      "of the other two",
                      error);
    moments_quaternion(turn, clump->axes);
    memcpy(clump->centre, moments->centre, sizeof clump->centre);
    for (int k = 0; k < clump->spheres; k++) {
        double *x = clump->sphere[k].centre;
        for (int d = 0; d < 3; d++)
            x[d] -= moments->centre[d];
        rotor_turn_back(turn, x, x);
        clump->extent =
            fmax(clump->extent, sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) + clump->sphere[k].radius);
    }
    return true;
}

/* Shares r^3 (a + b . x) of the mass, with the sum 1 and the centre of mass at the origin: those nearest to
 * proportional to the volumes. b solves S b = -a sum r^3 x, S = sum r^3 x x, in the directions in which the spheres
 * are spread. */
static bool shares_find(struct clump *clump, const struct scene *scene, int number, struct error *error) {
    double total = 0, first[3] = {0}, second[9] = {0}, value[3], turn[9], slope[3];
    for (int k = 0; k < clump->spheres; k++) {
        const double *x = clump->sphere[k].centre, cube = pow(clump->sphere[k].radius, 3);
        total += cube;
        for (int d = 0; d < 3; d++) {
            first[d] += cube * x[d];
            for (int e = 0; e < 3; e++)
                second[3 * d + e] += cube * x[d] * x[e];
        }
    }
    eigen3_axes(second, value, turn);
    rotor_turn_back(turn, first, slope);
    for (int d = 0; d < 3; d++)
        slope[d] = value[d] > 1e-12 * total * clump->extent * clump->extent ? -slope[d] / value[d] : 0;
    rotor_turn(turn, slope, slope);
    double level = 1 / (total + slope[0] * first[0] + slope[1] * first[1] + slope[2] * first[2]),
           moment[3] = {0};
    clump->share = memory_allocate_zero((size_t)clump->spheres, sizeof *clump->share, "shares of spheres");
    for (int k = 0; k < clump->spheres; k++) {
        const double *x = clump->sphere[k].centre, cube = pow(clump->sphere[k].radius, 3);
        clump->share[k] = level * cube * (1 + slope[0] * x[0] + slope[1] * x[1] + slope[2] * x[2]);
        for (int d = 0; d < 3; d++)
            moment[d] += clump->share[k] * x[d];
        if (!(clump->share[k] > 0.01 * cube / total))
            return refuse(scene, number, "",
                          "the centre of mass is too far from the middle of the spheres: some would have "
                          "no mass",
                          error);
    }
    double off = sqrt(moment[0] * moment[0] + moment[1] * moment[1] + moment[2] * moment[2]);
    if (!(off < 1e-4 * clump->extent))
        return refuse(scene, number, "centre",
                      "the centre of mass lies where no masses of the spheres put it", error);
    clump->extent =
        0; /* the error of a quadrature goes: spheres in a plane have their centre of mass there */
    for (int k = 0; k < clump->spheres; k++) {
        double *x = clump->sphere[k].centre;
        for (int d = 0; d < 3; d++)
            x[d] -= moment[d];
        clump->extent =
            fmax(clump->extent, sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) + clump->sphere[k].radius);
    }
    return true;
}

/* The inertia that spheres with the shares have is gyration - rest. */
static void ease_find(struct clump *clump) {
    static const int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
    const double *g = clump->gyration;
    double over[6];
    for (int k = 0; k < 6; k++)
        over[k] =
            (row[k] == column[k]) - clump->rest[3 * row[k] + column[k]] / sqrt(g[row[k]] * g[column[k]]);
    clump->ease = fmax(1, eigen3_largest(over));
}

/* The inertia over mass that spheres with the shares lack. */
static void rest_find(struct clump *clump) {
    for (int d = 0; d < 3; d++)
        clump->rest[4 * d] = clump->gyration[d];
    for (int k = 0; k < clump->spheres; k++) {
        const double *x = clump->sphere[k].centre, r = clump->sphere[k].radius;
        double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
        for (int d = 0; d < 3; d++)
            for (int e = 0; e < 3; e++)
                clump->rest[3 * d + e] -=
                    clump->share[k] * ((d == e ? square + 0.4 * r * r : 0) - x[d] * x[e]);
    }
}

bool clump_make(struct clump *clump, const struct scene *scene, int number,
                const struct clump_options *options, struct error *error) {
    struct moments moments;
    bool mesh = options->mesh[0] != '\0';
    *clump = (struct clump){0};
    if (!spheres_take(clump, scene, number, options, &moments, error))
        return false;
    clump->overlap = overlaps(clump);
    if (!mesh && clump->overlap)
        moments_union(clump->sphere, clump->spheres, &moments);
    else if (!mesh)
        moments_sum(clump->sphere, clump->spheres, &moments);
    clump->volume = moments.volume;
    if (!given_take(clump, &moments, scene, number, options, error) ||
        !axes_find(clump, &moments, scene, number, error) || !shares_find(clump, scene, number, error))
        return false;
    if (clump->overlap || options->inertia_given || mesh)
        rest_find(clump);
    ease_find(clump);
    return true;
}

void clump_free(struct clump *clump) {
    memory_free(clump->sphere);
    memory_free(clump->share);
    solid_free(&clump->core);
    *clump = (struct clump){0};
}

double clump_mass(const struct clump *clump, double scale, double density) {
    double cube = scale * scale * scale;
    return isnan(clump->mass) ? clump->volume * density * cube : clump->mass * cube;
}
