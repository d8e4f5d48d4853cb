/* SPDX-License-Identifier: BSD-3-Clause */
/* From sources to particles. Every rank walks through all rows of all sources in the same order; data that
 * depend on a particle's number (id, random velocity) are therefore the same everywhere, and each rank keeps
 * its own particles. Two searches over the whole stream, for ids and for places that occur twice, are divided
 * by hash: rank r remembers the keys of its part. */
#include "data/scene/scene_particles.h"

#include "kernel/particles/material.h"
#include "kernel/particles/shape.h"
#include "kernel/particles/spin.h"
#include "base/checksum.h"
#include "base/memory.h"
#include "data/formats/h5md_read.h"
#include "data/formats/lammps_data.h"
#include "kernel/particles/groups.h"
#include "data/scene/source_makers.h"
#include "data/scene/packed.h"

#include <math.h>
#include <string.h>

enum { SHARE_BLOCK = 1024 };

struct walk {
    const struct scene *scene;
    const struct scene_share *share;
    struct particles *particles;
    struct scene_census census;
    struct unique ids, places; /* values that may occur only once */
    uint64_t stream;           /* spheres so far */
    struct source_ids new_ids;
    struct error *error;
};

/* Remembers a sphere under a key, on the rank to which the key falls. */
static void remember(const struct walk *walk, struct unique *list, uint64_t key, int source,
                     const struct source_sphere *sphere) {
    if (key % (uint64_t)walk->share->size == (uint64_t)walk->share->rank)
        unique_add(list, &(struct unique_entry){key, sphere->id, (uint32_t)sphere->line, (uint32_t)source});
}

/* The place of an entry, as a message on another source names it. */
static const char *entry_place(const struct scene *scene, const struct unique_entry *entry, char *text,
                               size_t room) {
    const struct source_options *options = &scene->source[entry->source];
    char place[SCENE_PATH_MAX], key[96], line[32] = "";
    if (entry->line > 0)
        snprintf(line, sizeof(line), "line %u of ", entry->line);
    source_key((int)entry->source, "from", key, sizeof(key));
    bool file = options->kind == SOURCE_FILE;
    snprintf(text, room, "%s%.300s", line,
             file ? options->file : scene_place(scene, key, place, sizeof(place)));
    return text;
}

/* Fails if a key was seen twice; `remedy` ends the message if two sources clash and one of them is a file. */
static bool check_unique(const struct walk *walk, struct unique *list, const char *what, const char *remedy) {
    const struct unique_entry *first, *second;
    if (!unique_find_twice(list, &first, &second))
        return true;
    char text[600], place[400] = "";
    const struct source_options *source = walk->scene->source;
    struct source_sphere sphere = {.id = second->id, .line = second->line};
    bool apart = first->source != second->source,
         file = source[first->source].kind == SOURCE_FILE || source[second->source].kind == SOURCE_FILE;
    if (apart)
        entry_place(walk->scene, first, place, sizeof(place));
    else if (first->line > 0)
        snprintf(place, sizeof(place), "line %u", first->line);
    snprintf(text, sizeof(text), "%s particle %lld%s%s%s", what, (long long)first->id, place[0] ? ", " : "",
             place, apart && file ? remedy : "");
    return source_sphere_fail(walk->scene, (int)second->source, &sphere, text, walk->error);
}

static void count_sphere(struct walk *walk, const struct source_sphere *sphere) {
    struct scene_census *census = &walk->census;
    double r = sphere->radius;
    double speed =
        sqrt(sphere->v[0] * sphere->v[0] + sphere->v[1] * sphere->v[1] + sphere->v[2] * sphere->v[2]);
    census->radius_min = census->particles == 0 || r < census->radius_min ? r : census->radius_min;
    census->radius_max = fmax(census->radius_max, r);
    census->particles++;
    census->id_max = sphere->id > census->id_max ? sphere->id : census->id_max;
    census->material[sphere->material]++;
    census->group[sphere->group]++;
    census->speed_max = fmax(census->speed_max, speed);
    census->volume += sphere->solid * (4 * M_PI / 3 * r * r * r);
}

static void append_sphere(const struct walk *walk, int source, const struct source_sphere *sphere,
                          const double x[3]) {
    struct particles *particles = walk->particles;
    size_t i = particles_append(particles);
    struct particle_state *state = &particles->state[i];
    bool free = walk->scene->group[sphere->group].motion == SCENE_FREE;
    memcpy(state->x, x, sizeof(state->x));
    memcpy(state->v, sphere->v, sizeof(state->v));
    state->radius = sphere->radius;
    state->inverse_mass = free ? 1 / particles_sphere_mass(sphere->radius, sphere->density) : 0;
    particles->id[i] = sphere->id;
    double(*omega)[4] = spin_of(particles), *density = groups_densities(particles),
    *temperature = fields_numbers(particles, "temperature");
    uint8_t *material = material_numbers(particles), *group = groups_of(particles);
    int32_t(*image)[3] = particles_images(particles);
    if (omega)
        memcpy(omega[i], sphere->omega, sizeof(sphere->omega));
    if (material)
        material[i] = (uint8_t)sphere->material;
    if (group)
        group[i] = (uint8_t)sphere->group;
    if (density)
        density[i] = sphere->density;
    if (temperature)
        temperature[i] = walk->scene->source[source].temperature;
    shape_set(particles, i, sphere->shape, sphere->variant, sphere->orientation);
    if (image)
        memcpy(image[i], sphere->image, sizeof(sphere->image));
}

/* The id of a row that its source leaves out. */
static const int64_t id_left_out = INT64_MIN;

/* Takes a sphere, with `shake` added to its velocity. */
static bool take_sphere(struct walk *walk, int source, const struct source_batch *batch,
                        const double shake[3], struct source_sphere *sphere) {
    double x[3];
    if (!source_sphere_complete(walk->scene, source, batch, shake, sphere, x, walk->error))
        return false;
    remember(walk, &walk->ids, checksum_row(1, &sphere->id, sizeof(sphere->id)), source, sphere);
    remember(walk, &walk->places, checksum_row(0, x, sizeof(x)), source, sphere);
    count_sphere(walk, sphere);
    const struct scene_share *share = walk->share;
    bool mine = share->mine ? share->mine(share->context, x)
                            : (walk->stream / SHARE_BLOCK) % (uint64_t)share->size == (uint64_t)share->rank;
    walk->stream++;
    if (mine)
        append_sphere(walk, source, sphere, x);
    return true;
}

/* Reserves memory for this rank's expected part of `count` particles, so that arrays do not grow step by
 * step. False with an error if there is too little memory. */
static bool expect(struct walk *walk, size_t count) {
    size_t ranks = (size_t)walk->share->size, share = count / ranks;
    share += ranks > 1 ? share / 16 + 1 : 0;
    if (!source_room((double)share, SOURCE_BYTES, walk->error))
        return false;
    particles_reserve(walk->particles, walk->particles->owned + share);
    unique_reserve(&walk->ids, walk->ids.count + share);
    unique_reserve(&walk->places, walk->places.count + share);
    return true;
}

/* Gives the rows of a batch their ids, and id_left_out to those that the source leaves out. Returns how many it takes. */
static size_t give_ids(struct walk *walk, int source, const struct source_batch *batch, int64_t *id) {
    const struct source_options *options = &walk->scene->source[source];
    size_t taken = 0;
    for (size_t k = 0; k < batch->rows.count; k++) {
        struct source_sphere sphere = source_sphere_of(options, batch, k);
        bool left_out = source_sphere_left_out(options, &sphere);
        id[k] = left_out ? id_left_out : source_ids_give(&walk->new_ids, options, batch, k);
        taken += !left_out;
    }
    return taken;
}

/* The mean random velocity of the free spheres of a batch, weighted by mass: without it they have no momentum. 0 for
 * a sphere alone. Every rank goes over all rows, and finds the same. */
static bool mean_shake(const struct walk *walk, int source, const struct source_batch *batch,
                       const int64_t *id, double mean[3]) {
    const struct source_options *options = &walk->scene->source[source];
    double mass = 0, x[3], shake[3];
    int64_t free = 0;
    for (int d = 0; d < 3; d++)
        mean[d] = 0;
    for (size_t k = 0; options->velocity_sigma > 0 && k < batch->rows.count; k++) {
        struct source_sphere sphere = source_sphere_of(options, batch, k);
        if (id[k] == id_left_out)
            continue;
        sphere.id = id[k];
        if (!source_sphere_complete(walk->scene, source, batch, (double[3]){0}, &sphere, x, walk->error))
            return false;
        if (walk->scene->group[sphere.group].motion != SCENE_FREE)
            continue;
        double own = particles_sphere_mass(sphere.radius, sphere.density);
        source_sphere_shake(walk->scene, source, sphere.id, shake);
        mass += own;
        free++;
        for (int d = 0; d < 3; d++)
            mean[d] += own * shake[d];
    }
    for (int d = 0; d < 3; d++)
        mean[d] = free > 1 ? mean[d] / mass : 0;
    return true;
}

/* Takes the rows that have an id. */
static bool take_rows(struct walk *walk, int source, const struct source_batch *batch, const int64_t *id) {
    double mean[3], shake[3];
    if (!mean_shake(walk, source, batch, id, mean))
        return false;
    for (size_t k = 0; k < batch->rows.count; k++) {
        if (id[k] == id_left_out)
            continue;
        struct source_sphere sphere = source_sphere_of(&walk->scene->source[source], batch, k);
        sphere.id = id[k];
        source_sphere_shake(walk->scene, source, sphere.id, shake);
        for (int d = 0; d < 3; d++)
            shake[d] -= mean[d];
        if (!take_sphere(walk, source, batch, shake, &sphere))
            return false;
    }
    return true;
}

static bool take_batch(struct walk *walk, int source, const struct source_batch *batch) {
    const struct source_options *options = &walk->scene->source[source];
    if (!expect(walk, batch->rows.count))
        return false;
    int64_t *id = memory_allocate(batch->rows.count + 1, sizeof *id, "ids of a source");
    size_t taken = give_ids(walk, source, batch, id);
    bool good = take_rows(walk, source, batch, id);
    memory_free(id);
    if (!good)
        return false;
    char key[96];
    return taken > 0 ||
           scene_fail(walk->scene, walk->error, source_key(source, "radius_upto", key, sizeof(key)),
                      "no particle of %s has a radius above %g and up to %g", options->file,
                      options->radius_above, options->radius_upto);
}

static bool make_batch(struct walk *walk, int source, struct source_batch *batch) {
    const struct source_options *options = &walk->scene->source[source];
    struct h5md_read_options read = {.frame = options->frame};
    switch (options->kind) {
    case SOURCE_LATTICE:
        return lattice_make(walk->scene, source, batch, walk->error);
    case SOURCE_PACKED:
    case SOURCE_RANDOM:
        return true; /* made after all others, packed ones first */
    case SOURCE_SINGLE:
        rows_create(&batch->rows, 1, ROWS_POSITION | ROWS_RADIUS);
        memcpy(batch->rows.position[0], options->position, sizeof(options->position));
        batch->rows.radius[0] = options->radius;
        return true;
    default:
        break;
    }
    if (options->format == SOURCE_TABLE)
        return table_read(walk->scene, source, batch, walk->error);
    if (options->format == SOURCE_LAMMPS_DATA
            ? !lammps_data_read(options->file, &batch->rows, walk->error)
            : !h5md_read(options->file, &read, NULL, &batch->rows, walk->error))
        return false;
    if (batch->rows.tilt.offset != 0)
        return error_set(
            walk->error, ERROR_USER,
            "%.700s: the box of this frame is sheared, and a scene begins without shear; go on from a "
            "checkpoint of the run with --resume",
            options->file);
    if (!batch->rows.radius)
        return error_set(walk->error, ERROR_USER, "%.700s: /particles has no radius", options->file);
    return source_bodies_take(walk->scene, source, batch, walk->error);
}

/* The smallest radius that a source may place at random; INFINITY: no source does. */
static double random_radius(const struct scene *scene) {
    double unit = INFINITY;
    for (int s = 0; s < scene->sources; s++) {
        double smallest, largest;
        sizes_bounds(&scene->source[s].sizes, &smallest, &largest);
        if (scene->source[s].kind == SOURCE_RANDOM)
            unit = fmin(unit, smallest);
    }
    return unit;
}

/* Places the spheres of random sources clear of those of all other sources, whose batches are made. */
static bool place_random(const struct walk *walk, struct source_batch *batch, double unit) {
    const struct scene *scene = walk->scene;
    struct placegrid *grid = placegrid_create(&scene->box, unit);
    for (int s = 0; s < scene->sources; s++)
        for (size_t k = 0; k < batch[s].rows.count; k++) {
            struct source_sphere sphere = source_sphere_of(&scene->source[s], &batch[s], k);
            double x[3];
            if (source_sphere_at(&scene->box, &sphere, x) &&
                !source_sphere_left_out(&scene->source[s], &sphere))
                placegrid_add(grid, x, sphere.radius);
        }
    bool good = scatter_make(scene, walk->share, grid, batch, walk->error);
    placegrid_destroy(&grid);
    return good;
}

/* All sources are made before the first is taken: packed ones after those that stay, random ones last of all, as
 * these avoid all others, and new ids leave out those of all files. */
static bool take_sources(struct walk *walk) {
    const struct scene *scene = walk->scene;
    struct source_batch *batch =
        memory_allocate_zero((size_t)scene->sources, sizeof(*batch), "batches of particles");
    double unit = random_radius(scene);
    bool good = true;
    for (int s = 0; s < scene->sources && good; s++)
        good = make_batch(walk, s, &batch[s]);
    good = good && packed_make(scene, walk->share, batch, walk->error);
    good = good && (!isfinite(unit) || place_random(walk, batch, unit));
    if (good)
        source_ids_begin(&walk->new_ids, scene, batch);
    for (int s = 0; s < scene->sources; s++) {
        good = good && take_batch(walk, s, &batch[s]);
        source_batch_free(&batch[s]);
    }
    memory_free(batch);
    return good;
}

static bool check_groups(const struct walk *walk) {
    for (int g = 1; g < walk->scene->groups; g++) {
        char key[64];
        bool fed = walk->census.group[g] > 0;
        for (int k = 0; k < walk->scene->insertions; k++)
            fed = fed || walk->scene->insertion[k].group == g;
        snprintf(key, sizeof(key), "groups[%d].select", g - 1);
        if (!fed)
            return scene_fail(walk->scene, walk->error, key, "no particle belongs to the group '%s'",
                              walk->scene->group[g].name);
    }
    return true;
}

bool scene_particles(const struct scene *scene, const struct scene_share *share, struct particles *particles,
                     struct scene_census *census, struct error *error) {
    struct walk walk = {.scene = scene, .share = share, .particles = particles, .error = error};
    bool good = take_sources(&walk) && check_groups(&walk) &&
                check_unique(&walk, &walk.ids, "has the id of",
                             "; `ids: new` numbers the particles of a file anew") &&
                check_unique(&walk, &walk.places, "its centre coincides with that of", "");
    source_ids_free(&walk.new_ids);
    unique_free(&walk.ids);
    unique_free(&walk.places);
    if (census)
        *census = walk.census;
    return good;
}
