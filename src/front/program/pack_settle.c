/* SPDX-License-Identifier: BSD-3-Clause */
/* A packing settles: a scene of its spheres and its container, run by the library. Read pack_settle.h first.
 *
 * The spheres have density 1 and gravity is 1: neither density nor gravity changes where rigid spheres come to rest. The weight of the
 * bed, p, presses a sphere of radius r with about 6 p r^2; Hertz's law then gives the overlap d of two such
 * spheres, (d/r)^(3/2) = 6 p / (0.94 E*), with E* = E / (2 (1 - nu^2)). */
#include "front/program/pack_settle.h"
#include "data/formats/lammps_data.h"
#include "kernel/particles/particles.h"
#include "scree.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double overlap_wanted = 5e-3, poisson = 0.3, most_falls = 100;
/* At rest: */
static const double speed_most = 0.01, unbalanced_most = 0.01;

enum { PATH = 1024, SPHERE_TURNS = 128 };

/* The files of the scene, which are gone when the scene is read; empty: not made. */
struct files {
    char spheres[PATH], ball[PATH];
};

static bool temporary(char path[PATH], struct error *error) {
    const char *where = getenv("TMPDIR");
    int length = snprintf(path, PATH, "%s/scree-settle-XXXXXX", where && *where ? where : "/tmp");
    int file = length < PATH ? mkstemp(path) : -1;
    if (file < 0) {
        error_set(error, ERROR_SYSTEM, "%s: cannot be made: the spheres settle by way of a file there", path);
        path[0] = '\0';
        return false;
    }
    close(file);
    return true;
}

/* One corner of the triangles of a ball: `i` around, `j` from the south to the north pole. */
static void write_corner(FILE *out, double radius, int i, int j) {
    double around = 2 * M_PI * (i % SPHERE_TURNS) / SPHERE_TURNS, up = 2 * M_PI * j / SPHERE_TURNS;
    fprintf(out, " %.17g %.17g %.17g", radius * sin(up) * cos(around), radius * sin(up) * sin(around),
            -radius * cos(up));
}

/* Writes a ball around the origin as triangles that touch it from outside, or nearly. */
static bool write_ball(const char *path, double radius, struct error *error) {
    FILE *out = fopen(path, "w");
    radius *= 1 + 6e-4; /* as far as the facets lie inside of their corners */
    if (!out)
        return error_set(error, ERROR_SYSTEM, "%s: cannot be written", path);
    for (int j = 0; j < SPHERE_TURNS / 2; j++)
        for (int i = 0; i < SPHERE_TURNS; i++)
            for (int half = 0; half < 2; half++) {
                if (half == 0 ? j == 0 : j + 1 == SPHERE_TURNS / 2) /* no area at a pole */
                    continue;
                write_corner(out, radius, i, j);
                write_corner(out, radius, i + 1, j + half);
                write_corner(out, radius, i + half, j + 1);
                fputc('\n', out);
            }
    return fclose(out) == 0 || error_set(error, ERROR_SYSTEM, "%s: cannot be written", path);
}

static void write_plane(FILE *out, const double point[3], int axis, double side) {
    double normal[3] = {0, 0, 0};
    normal[axis] = side;
    fprintf(out, "  - {shape: plane, point: [%.17g, %.17g, %.17g], normal: [%g, %g, %g]}\n", point[0],
            point[1], point[2], normal[0], normal[1], normal[2]);
}

/* A path as a YAML string in double quotes, where line ends have escapes. */
static void write_path(FILE *out, const char *path) {
    fputc('"', out);
    for (; *path; path++) {
        unsigned char c = (unsigned char)*path;
        fprintf(out, c < ' ' || c == 0x7f ? "\\x%02x" : c == '"' || c == '\\' ? "\\%c" : "%c", c);
    }
    fputc('"', out);
}

static void write_mesh(FILE *out, const char *path, double scale) {
    fputs("  - {shape: mesh, file: ", out);
    write_path(out, path);
    fprintf(out, ", scale: %.17g}\n", scale);
}

static void write_walls(FILE *out, const struct recipe *r, const struct rows *rows,
                        const struct files *files) {
    fputs("walls:\n", out);
    if (r->shape == RECIPE_MESH || r->shape == RECIPE_SPHERE) {
        write_mesh(out, r->shape == RECIPE_MESH ? r->file : files->ball,
                   r->shape == RECIPE_MESH ? r->scaled : 1);
        return;
    }
    if (r->shape == RECIPE_CYLINDER)
        fprintf(out, "  - {shape: cylinder, point: [0, 0, 0], axis: [0, 0, 1], radius: %.17g}\n", r->radius);
    for (int axis = r->shape == RECIPE_CYLINDER ? 2 : 0; axis < 3; axis++) {
        write_plane(out, rows->lower, axis, 1);
        write_plane(out, rows->upper, axis, -1);
    }
}

static double height_of(const struct rows *rows) {
    return rows->upper[2] - rows->lower[2];
}

/* The weight of the bed, over density and gravity; of a shallow one more, so that spheres that fall on it do not go deeper than a tenth of a radius. */
static double weight_of(const struct rows *rows, double fraction) {
    return height_of(rows) * fmin(fmax(fraction, 0.15), 0.6);
}

static void write_scene(FILE *out, const struct recipe *r, const struct rows *rows, const struct files *files,
                        double weight) {
    double effective = 6 * weight / (0.94 * pow(overlap_wanted, 1.5));
    double young = 2 * (1 - poisson * poisson) * effective;
    fprintf(out, "units: none\nreproducible: true\nthreads: %d\ngravity: [0, 0, -1]\n", r->scene->threads);
    fprintf(out, "box: {lower: [%.17g, %.17g, %.17g], upper: [%.17g, %.17g, %.17g], periodic: false}\n",
            rows->lower[0], rows->lower[1], rows->lower[2], rows->upper[0], rows->upper[1], rows->upper[2]);
    fprintf(out, "step: {fraction: 0.5}\nduration: .inf\ncontact: {law: hertz, tangential: history, rolling: "
                 "spring}\n");
    fprintf(out, "materials: [{name: grain, density: 1, young: %.17g, poisson: %.17g}]\n", young, poisson);
    fprintf(out, "material_pairs: [{restitution: 0.2, friction: %.17g, rolling_friction: %g}]\n", r->friction,
            r->friction > 0 ? 0.01 : 0.0);
    write_walls(out, r, rows, files);
    fputs("particles: {file: ", out);
    write_path(out, files->spheres);
    fputs(", format: lammps-data, density: 1, material: grain}\n", out);
    fputs("observables:\n  list: [{name: energy_kinetic_mean}, {name: unbalanced_force}, {name: "
          "coordination},\n"
          "    {name: overlap_max}]\n",
          out);
}

/* Hands a failure of the library on. */
static bool failed(const struct scree_error *from, struct error *error) {
    return error_set(error, (enum error_kind)from->status, "the spheres settle: %s", from->text);
}

/* The units of a state. */
struct scale {
    double fall;       /* time of a free fall over the height of the container */
    double fall_speed; /* after a fall by the smallest diameter */
    double mass;       /* mean of the spheres */
};

static struct scale scale_of(const struct rows *rows, double radius_min) {
    struct scale scale = {sqrt(2 * height_of(rows)), sqrt(4 * radius_min), 0};
    for (size_t k = 0; k < rows->count; k++)
        scale.mass += particles_sphere_mass(rows->radius[k], 1) / (double)rows->count;
    return scale;
}

/* Looks at the spheres. */
static bool look(struct scree_simulation *simulation, const struct scale *scale, struct settle_state *state,
                 struct error *error) {
    struct scree_error told = {0};
    double value[4];
    if (!scree_observe(simulation, value, &told))
        return failed(&told, error);
    state->time = scree_time(simulation) / scale->fall;
    state->steps = scree_step_number(simulation);
    state->speed = sqrt(2 * value[0] / scale->mass) / scale->fall_speed;
    state->unbalanced = value[1];
    state->coordination = value[2];
    state->overlap = value[3];
    state->rests = state->speed < speed_most && state->unbalanced < unbalanced_most;
    return true;
}

/* Steps until the spheres rest, or for too long. */
static bool fall(struct scree_simulation *simulation, const struct settle_hook *hook,
                 const struct scale *scale, struct settle_state *state, struct error *error) {
    uint64_t some = (uint64_t)fmax(0.02 * scale->fall / scree_time_step(simulation), 1);
    struct scree_error told = {0};
    while (!state->rests && state->time < most_falls) {
        if (!scree_step(simulation, some, &told))
            return failed(&told, error);
        if (!look(simulation, scale, state, error))
            return false;
        if (hook)
            hook->show(hook->context, state);
    }
    return true;
}

/* Takes the places of the spheres, whose ids are those of the rows. */
static bool take_places(const struct scree_simulation *simulation, struct rows *rows, struct error *error) {
    struct scree_box box = scree_box(simulation);
    struct scree_field place, id;
    if (!scree_field(simulation, "position", &place) || !scree_field(simulation, "id", &id))
        return error_set(error, ERROR_SYSTEM, "the spheres settle: the scene has no places");
    for (size_t k = 0; k < place.count; k++) {
        const double *x = (const double *)((const char *)place.data + k * place.stride);
        int64_t row = *(const int64_t *)((const char *)id.data + k * id.stride) - 1;
        for (int c = 0; c < 3; c++)
            rows->position[row][c] = box.origin[c] + x[c];
    }
    return true;
}

/* Writes the files of the scene. */
static bool write_files(struct files *files, const struct recipe *recipe, const struct rows *rows,
                        struct error *error) {
    struct rows still = *rows;
    still.velocity = NULL;
    if (!temporary(files->spheres, error) || !lammps_data_write(files->spheres, &still, error))
        return false;
    return recipe->shape != RECIPE_SPHERE ||
           (temporary(files->ball, error) && write_ball(files->ball, recipe->radius, error));
}

/* The simulation of the scene; NULL on failure. */
static struct scree_simulation *create(const struct recipe *recipe, const struct rows *rows,
                                       const struct files *files, double weight, struct error *error) {
    struct scree_simulation *simulation = NULL;
    struct scree_error told = {0};
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        error_set(error, ERROR_SYSTEM, "no memory for the scene in which spheres settle");
        return NULL;
    }
    write_scene(out, recipe, rows, files, weight);
    fclose(out);
    simulation = scree_create(NULL, text, NULL, &told);
    if (!simulation)
        failed(&told, error);
    free(text);
    return simulation;
}

bool pack_settle(const struct recipe *recipe, const struct settle_hook *hook, struct rows *rows,
                 struct pack_report *report, struct settle_state *state, struct error *error) {
    struct files files = {"", ""};
    struct scree_simulation *simulation = NULL;
    *state = (struct settle_state){0};
    if (write_files(&files, recipe, rows, error))
        simulation = create(recipe, rows, &files, weight_of(rows, report->fraction), error);
    for (char *path[] = {files.spheres, files.ball, NULL}, **at = path; *at; at++)
        if (**at)
            unlink(*at);
    if (!simulation)
        return false;
    struct scale scale = scale_of(rows, report->smallest);
    bool good = fall(simulation, hook, &scale, state, error) && take_places(simulation, rows, error);
    scree_destroy(&simulation);
    report->packed.overlap = state->overlap;
    if (good) {
        struct region_space space;
        struct region region = recipe_region(recipe, &space);
        report->bed = bed_measure(&region, &space, rows);
    }
    return good;
}
