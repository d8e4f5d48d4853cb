/* SPDX-License-Identifier: BSD-3-Clause */
/* One sphere of a source: from its row to a particle's material, density, velocity and group, and to a place
 * in the box; or why it cannot be one. */
#include "data/scene/source_sphere.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

/* Data of a check, from which a message names the refused sphere. */
struct subject {
    const struct scene *scene;
    int source;
    const struct source_sphere *sphere;
    struct error *error;
};

bool source_sphere_fail(const struct scene *scene, int source, const struct source_sphere *sphere,
                        const char *text, struct error *error) {
    const struct source_options *options = &scene->source[source];
    char place[SCENE_PATH_MAX], key[96];
    if (options->kind == SOURCE_FILE && sphere->line > 0)
        return error_set(error, ERROR_USER, "%.700s:%ld: %s", options->file, sphere->line, text);
    if (options->kind == SOURCE_FILE)
        return error_set(error, ERROR_USER, "%.700s: particle %lld: %s", options->file, (long long)sphere->id,
                         text);
    source_key(source, options->kind == SOURCE_SINGLE ? "position" : "from", key, sizeof(key));
    scene_place(scene, key, place, sizeof(place));
    return error_set(error, ERROR_USER, "%.700s: %s: particle %lld: %s", place, key, (long long)sphere->id,
                     text);
}

static __attribute__((format(printf, 2, 3))) bool fail(const struct subject *at, const char *format, ...) {
    char text[200];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof(text), format, list);
    va_end(list);
    return source_sphere_fail(at->scene, at->source, at->sphere, text, at->error);
}

struct source_sphere source_sphere_of(const struct source_options *options, const struct source_batch *batch,
                                      size_t k) {
    const struct rows *rows = &batch->rows;
    const struct source_row *form = batch->form ? &batch->form[k] : NULL;
    struct source_sphere sphere = {.radius = rows->radius[k],
                                   .material = rows->material ? rows->material[k] : 0,
                                   .line = rows->line ? rows->line[k] : 0,
                                   .shape = form ? form->shape : options->form.shape,
                                   .variant = form ? form->variant : 0,
                                   .solid = form ? form->solid : source_form_solid(&options->form)};
    bool file = options->kind == SOURCE_FILE;
    if (rows->mass && rows->mass[k] > 0)
        sphere.density = rows->mass[k] / particles_sphere_mass(sphere.radius, 1);
    for (int d = 0; d < 3; d++) {
        sphere.x[d] =
            file ? rows->position[k][d] * options->scale + options->offset[d] : rows->position[k][d];
        sphere.v[d] = rows->velocity ? rows->velocity[k][d] : 0;
        sphere.omega[d] = rows->angular_velocity ? rows->angular_velocity[k][d] : 0;
        sphere.image[d] = rows->image ? rows->image[k][d] : 0;
    }
    if (file)
        sphere.radius *= options->scale;
    sphere.given = sphere.radius;
    if (file || options->kind == SOURCE_SINGLE)
        sphere.radius *= form ? form->ball : source_form_ball(&options->form);
    if (rows->orientation && sphere.shape > 0)
        memcpy(sphere.orientation, rows->orientation[k], sizeof sphere.orientation);
    return sphere;
}

/* Box-relative and wrapped; in two dimensions z is that of the plane. */
static double box_coordinate(const struct box *box, int d, double x) {
    double y = x - box->origin[d];
    if (d == 2 && box->dimension == 2)
        return box->edge[d] / 2;
    if (box->periodic[d])
        y -= floor(y / box->edge[d]) * box->edge[d];
    return box->periodic[d] && y >= box->edge[d] ? 0 : y;
}

bool source_sphere_at(const struct box *box, const struct source_sphere *sphere, double x[3]) {
    bool sound = sphere->radius > 0 && isfinite(sphere->radius);
    for (int d = 0; d < 3; d++) {
        sound = sound && isfinite(sphere->x[d]);
        x[d] = box_coordinate(box, d, sphere->x[d]);
    }
    return sound;
}

bool source_sphere_left_out(const struct source_options *options, const struct source_sphere *sphere) {
    return options->kind == SOURCE_FILE && sphere->given > 0 &&
           !(sphere->given > options->radius_above && sphere->given <= options->radius_upto);
}

/* Refuses values that no source may give. */
static bool check_given(const struct subject *at) {
    const struct source_sphere *sphere = at->sphere;
    for (int d = 0; d < 3; d++)
        if (!isfinite(sphere->x[d]) || !isfinite(sphere->v[d]) || !isfinite(sphere->omega[d]))
            return fail(at, "position, velocity or spin is not a finite number");
    if (!(sphere->radius > 0) || !isfinite(sphere->radius))
        return fail(at, "the radius must be > 0 and finite");
    if (sphere->id < 1 || sphere->id > SOURCE_ID_MAX)
        return fail(at, "ids must lie between 1 and 2^62");
    return true;
}

static bool choose_material(const struct subject *at, const struct source_batch *batch,
                            struct source_sphere *sphere) {
    const struct scene *scene = at->scene;
    const struct source_options *options = &scene->source[at->source];
    bool typed = batch->rows.material && !batch->materials_named;
    if (options->material >= 0)
        sphere->material = options->material;
    else if (typed && options->type_count > 0) {
        if (sphere->material < 0 || sphere->material >= options->type_count)
            return fail(at, "type %d, but `types` names %d materials", sphere->material + 1,
                        options->type_count);
        sphere->material = options->type_material[sphere->material];
    } else if (!batch->rows.material && scene->materials > 1) {
        return fail(at, "has no material: the file names none, so the source needs `material`");
    } else if (!batch->rows.material) {
        sphere->material = 0;
    }
    if (scene->materials == 0)
        sphere->material = 0;
    else if (sphere->material < 0 || sphere->material >= scene->materials)
        return fail(at,
                    "type %d, but the scene has %d materials (`types` or `material` of the source maps them)",
                    sphere->material + 1, scene->materials);
    return true;
}

/* The group whose selection holds a sphere at x, box-relative and wrapped. If wrapping did not move the
 * centre, the selection tests the centre with the given digits. */
static int select_group(const struct scene *scene, const struct source_sphere *sphere, const double x[3]) {
    int chosen = 0;
    struct region_space space = {.dimension = scene->box.dimension};
    double centre[3];
    for (int d = 0; d < 3; d++) {
        bool moved = x[d] != sphere->x[d] - scene->box.origin[d];
        centre[d] = moved ? x[d] + scene->box.origin[d] : sphere->x[d];
    }
    for (int g = 1; g < scene->groups; g++) {
        const struct scene_group *group = &scene->group[g];
        bool in = group->selects && (group->material < 0 || group->material == sphere->material) &&
                  sphere->radius > group->radius_above && sphere->radius <= group->radius_upto &&
                  (!group->by_region || region_contains(&group->region, &space, centre, 0));
        bool listed = group->id_count == 0;
        for (int k = 0; k < group->id_count && !listed; k++)
            listed = group->id[k] == sphere->id;
        if (in && listed)
            chosen = g;
    }
    return chosen;
}

void source_sphere_shake(const struct scene *scene, int source, int64_t id, double v[3]) {
    const struct source_options *options = &scene->source[source];
    struct random_sequence random = random_sequence(scene->seed, RANDOM_VELOCITY, (uint64_t)id);
    for (int d = 0; d < 3; d++) {
        bool flat = scene->box.dimension == 2 && d == 2;
        v[d] = options->velocity_sigma > 0 && !flat ? options->velocity_sigma * random_normal(&random) : 0;
    }
}

/* Density and velocity, once the material is known. */
static bool complete(const struct subject *at, const double shake[3], struct source_sphere *sphere) {
    const struct scene *scene = at->scene;
    const struct source_options *options = &scene->source[at->source];
    double given = options->density;
    if (!(given > 0) && !(sphere->density > 0))
        given = scene->material[sphere->material].density;
    if (given > 0)
        sphere->density = particles_density(&scene->box, sphere->radius, given);
    if (!(sphere->density > 0))
        return fail(at, "has no density: the scene has no materials, so the source needs `density`");
    for (int d = 0; d < 3; d++) {
        sphere->v[d] += options->velocity[d] + shake[d];
        sphere->omega[d] += options->omega[d];
    }
    if (scene->box.dimension == 2 && (sphere->v[2] != 0 || sphere->omega[0] != 0 || sphere->omega[1] != 0))
        return fail(at, "moves out of the plane of a two-dimensional scene");
    return true;
}

/* Puts the centre into the box: box-relative, wrapped, images counted. */
static bool place_in_box(const struct subject *at, struct source_sphere *sphere, double x[3]) {
    const struct box *box = &at->scene->box;
    for (int d = 0; d < 3; d++) {
        x[d] = sphere->x[d] - box->origin[d];
        if (d == 2 && box->dimension == 2) {
            x[d] = box->edge[d] / 2;
            continue;
        }
        char axis = "xyz"[d];
        int side = x[d] < 0 ? 0 : 1;
        bool inside = x[d] >= 0 && x[d] <= box->edge[d];
        if (!box->periodic[d] && !inside && box->leave[d][side] != BOX_KEEP)
            return fail(at,
                        "%c = %g lies outside of the box (%g to %g); allowed only with box.periodic or "
                        "box.leave: keep",
                        axis, sphere->x[d], at->scene->box_lower[d], at->scene->box_upper[d]);
        if (!box->periodic[d])
            continue;
        double images = floor(x[d] / box->edge[d]);
        if (fabs(images) > 1e6)
            return fail(at, "%c = %g lies too many box lengths away", axis, sphere->x[d]);
        x[d] -= images * box->edge[d];
        if (x[d] >= box->edge[d]) {
            x[d] = 0;
            images++;
        }
        if (__builtin_add_overflow(sphere->image[d], (int32_t)images, &sphere->image[d]) ||
            sphere->image[d] == INT32_MIN)
            return fail(at, "crossed the periodic box in %c more often than 32 bits count", axis);
        if (2 * sphere->radius >= box->edge[d])
            return fail(at, "the diameter (%g) is not smaller than the periodic box in %c (%g)",
                        2 * sphere->radius, axis, box->edge[d]);
    }
    return true;
}

/* Numbers that are finite, and yet of no use: squares and masses overflow, overlaps drown in rounding. */
static bool check_range(const struct subject *at, const double x[3]) {
    const struct source_sphere *sphere = at->sphere;
    const double *v = sphere->v;
    double mass = particles_sphere_mass(sphere->radius, sphere->density);
    if (!isnormal(mass) || !isnormal(1 / mass))
        return fail(at, "the mass that follows from radius and density is out of range");
    if (!isfinite(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]))
        return fail(at, "the speed is out of range");
    for (int d = 0; d < at->scene->box.dimension; d++)
        if (fabs(x[d]) * DBL_EPSILON > 1e-3 * sphere->radius)
            return fail(
                at, "so far from the lower corner of the box, rounding is above a thousandth of the radius");
    return true;
}

bool source_sphere_complete(const struct scene *scene, int source, const struct source_batch *batch,
                            const double shake[3], struct source_sphere *sphere, double x[3],
                            struct error *error) {
    const struct subject at = {scene, source, sphere, error};
    if (!check_given(&at) || !choose_material(&at, batch, sphere) || !complete(&at, shake, sphere) ||
        !place_in_box(&at, sphere, x))
        return false;
    int group = scene->source[source].group;
    sphere->group = group >= 0 ? group : select_group(scene, sphere, x);
    return check_range(&at, x);
}
