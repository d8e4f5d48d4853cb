/* SPDX-License-Identifier: BSD-3-Clause */
/* Draws the radii of a source. Read source_radii.h first. */
#include "data/scene/source_radii.h"

#include "base/memory.h"
#include "data/scene/source_batch.h"

#include <math.h>

enum { PROGRESS_BLOCK = 256 };

double source_solid(const struct scene *scene, double radius) {
    return scene->box.dimension == 2 ? M_PI * radius * radius : particles_sphere_mass(radius, 1);
}

void source_tell(const struct scene_share *share, const char *what, size_t done, double all) {
    if (share->progress && done % PROGRESS_BLOCK == 0 && done > 0)
        share->progress(share->context, what, fmin(1, (double)done / all));
}

/* The number of spheres to expect; 0, with an error, if they are too many. */
static double expect(const struct scene *scene, const struct source_wish *wish,
                     const struct sizes_sampler *sampler, struct error *error) {
    char key[96];
    double wanted = scene->source[wish->source].volume_fraction * wish->volume;
    double solid = source_form_solid(&scene->source[wish->source].form) * source_solid(scene, 1);
    double expected = wanted / (sizes_moment(sampler, scene->box.dimension) * solid);
    if (wish->count > SOURCE_SPHERES_MAX)
        scene_fail(scene, error, source_key(wish->source, "count", key, sizeof(key)), "more than %d spheres",
                   SOURCE_SPHERES_MAX);
    else if (!wish->count && expected > 1.1 * SOURCE_SPHERES_MAX) /* a few per cent are chance */
        scene_fail(scene, error, source_key(wish->source, "volume_fraction", key, sizeof(key)),
                   "needs about %.2g spheres; at most %d are possible", expected, SOURCE_SPHERES_MAX);
    else
        return wish->count ? (double)wish->count : expected;
    return 0;
}

/* Adds a radius. */
static void add(struct source_radii *radii, size_t *room, double radius, double ball, double part) {
    if (radii->count == *room) {
        *room += *room / 2 + 1024;
        radii->radius = memory_resize(radii->radius, *room, sizeof(*radii->radius), "radii");
    }
    radii->radius[radii->count++] = radius;
    radii->balls += ball;
    radii->solid += part * ball;
}

bool source_radii_draw(const struct scene *scene, const struct scene_share *share,
                       const struct source_wish *wish, struct source_radii *radii, struct error *error) {
    const struct source_options *options = &scene->source[wish->source];
    struct sizes_sampler sampler;
    char key[96];
    size_t room = 0;
    *radii = (struct source_radii){0};
    if (!sizes_prepare(&sampler, &options->sizes, error))
        return false;
    const double part = source_form_solid(&options->form);
    double wanted = options->volume_fraction * wish->volume;
    double expected = expect(scene, wish, &sampler, error);
    if (error->kind != ERROR_NONE ||
        !source_room(expected, wish->bytes + (double)SOURCE_BYTES / share->size, error))
        return false;
    source_key(wish->source, "volume_fraction", key, sizeof(key));
    while (wish->count ? radii->count < wish->count : radii->solid < wanted) {
        struct random_sequence random =
            random_sequence(scene->seed, RANDOM_RADIUS, wish->first + radii->count);
        source_tell(share, "radii drawn", radii->count, expected);
        double r = sizes_draw(&sampler, &random), ball = source_solid(scene, r);
        if (!wish->count && radii->solid + part * ball - wanted > wanted - radii->solid)
            break; /* the fraction is nearer without this sphere */
        if (radii->count == SOURCE_SPHERES_MAX)
            return scene_fail(scene, error, key, "needs more than %d spheres", SOURCE_SPHERES_MAX);
        add(radii, &room, r, ball, part);
    }
    return radii->count > 0 || scene_fail(scene, error, key, "is too small for a single sphere");
}
