/* From sources to particles. Every rank walks through all rows of all sources in the same order; what depends
 * on a particle's number (id, random velocity) is therefore the same everywhere, and each rank keeps its own.
 * Two searches over the whole stream, for ids and for places that occur twice, are divided by hash: rank r
 * remembers what falls to it. */
#include "scene/source_parts.h"

#include "core/checksum.h"
#include "core/memory.h"
#include "output/h5md_read.h"
#include "output/lammps_data.h"
#include "scene/unique.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

enum { SHARE_BLOCK = 1024 };

struct walk {
    const struct scene *scene;
    const struct scene_share *share;
    struct particles *particles;
    struct scene_census census;
    struct unique ids, places; /* what may occur only once */
    struct placegrid *grid;    /* NULL where no later source needs it */
    uint64_t stream;           /* spheres so far */
    struct error *error;
};

const char *source_key(int source, const char *key, char *text, size_t room) {
    snprintf(text, room, "particles.sources[%d].%s", source, key);
    return text;
}

void source_batch_free(struct source_batch *batch) {
    rows_free(&batch->rows);
    memory_free(batch->line);
    batch->line = NULL;
}

struct region source_region(const struct scene *scene, const struct region *region,
                            struct region_space *space) {
    struct region resolved = *region;
    if (region->shape == REGION_ALL) {
        resolved.shape = REGION_BOX;
        memcpy(resolved.lower, scene->box_lower, sizeof(resolved.lower));
        memcpy(resolved.upper, scene->box_upper, sizeof(resolved.upper));
    }
    *space = (struct region_space){.dimension = scene->box.dimension,
                                   .plane = (scene->box_lower[2] + scene->box_upper[2]) / 2};
    for (int d = 0; d < 3; d++)
        space->wrap[d] = scene->box.periodic[d] && resolved.shape == REGION_BOX &&
                         resolved.lower[d] <= scene->box_lower[d] && resolved.upper[d] >= scene->box_upper[d];
    return resolved;
}

/* Fills the error with the place of a sphere: line of the file, else its id. */
static bool sphere_fail(const struct walk *walk, int source, const struct source_sphere *sphere,
                        const char *text) {
    const struct source_options *options = &walk->scene->source[source];
    char place[SCENE_PATH_MAX], key[96];
    if (options->kind == SOURCE_FILE && sphere->line > 0)
        return error_set(walk->error, ERROR_USER, "%.700s:%ld: %s", options->file, sphere->line, text);
    if (options->kind == SOURCE_FILE)
        return error_set(walk->error, ERROR_USER, "%.700s: particle %lld: %s", options->file,
                         (long long)sphere->id, text);
    source_key(source, options->kind == SOURCE_SINGLE ? "position" : "from", key, sizeof(key));
    scene_place(walk->scene, key, place, sizeof(place));
    return error_set(walk->error, ERROR_USER, "%.700s: %s: particle %lld: %s", place, key,
                     (long long)sphere->id, text);
}

/* Remembers a sphere under a key, on the rank to which the key falls. */
static void remember(const struct walk *walk, struct unique *list, uint64_t key, int source,
                     const struct source_sphere *sphere) {
    if (key % (uint64_t)walk->share->size == (uint64_t)walk->share->rank)
        unique_add(list, &(struct unique_entry){key, sphere->id, (uint32_t)sphere->line, (uint32_t)source});
}

/* Fails if a key was seen twice. */
static bool check_unique(const struct walk *walk, struct unique *list, const char *what) {
    const struct unique_entry *first, *second;
    if (!unique_find_twice(list, &first, &second))
        return true;
    char text[200], line[64] = "";
    struct source_sphere sphere = {.id = second->id, .line = second->line};
    if (first->line > 0)
        snprintf(line, sizeof(line), ", line %u", first->line);
    snprintf(text, sizeof(text), "%s particle %lld%s", what, (long long)first->id, line);
    return sphere_fail(walk, (int)second->source, &sphere, text);
}

/* Writes a text; always false. */
static __attribute__((format(printf, 3, 4))) bool because(char *why, size_t room, const char *format, ...) {
    va_list list;
    va_start(list, format);
    vsnprintf(why, room, format, list);
    va_end(list);
    return false;
}

/* Puts a position into the box: box-relative, wrapped, images counted. False with a text if it cannot be
 * there. */
static bool place_in_box(const struct scene *scene, struct source_sphere *sphere, double x[3], char *why,
                         size_t room) {
    const struct box *box = &scene->box;
    for (int d = 0; d < 3; d++) {
        x[d] = sphere->x[d] - box->origin[d];
        if (d == 2 && box->dimension == 2) {
            x[d] = box->edge[d] / 2;
            continue;
        }
        int side = x[d] < 0 ? 0 : 1;
        bool inside = x[d] >= 0 && x[d] <= box->edge[d];
        if (!box->periodic[d] && !inside && box->leave[d][side] != BOX_KEEP)
            return because(why, room,
                           "%c = %g lies outside of the box (%g to %g); allowed only with box.periodic or "
                           "box.leave: keep",
                           "xyz"[d], sphere -> x[d], scene -> box_lower[d], scene -> box_upper[d]);
        if (!box->periodic[d])
            continue;
        double images = floor(x[d] / box->edge[d]);
        if (fabs(images) > 1e6)
            return because(why, room, "%c = %g lies too many box lengths away", "xyz"[d], sphere -> x[d]);
        x[d] -= images * box->edge[d];
        if (x[d] >= box->edge[d]) {
            x[d] = 0;
            images++;
        }
        sphere->image[d] += (int32_t)images;
        if (2 * sphere->radius >= box->edge[d])
            return because(why, room, "the diameter (%g) is not smaller than the periodic box in %c (%g)",
                           2 * sphere->radius, "xyz"[d], box -> edge[d]);
    }
    return true;
}

static int select_group(const struct scene *scene, const struct source_sphere *sphere) {
    int chosen = 0;
    struct region_space space = {.dimension = scene->box.dimension};
    for (int g = 1; g < scene->groups; g++) {
        const struct scene_group *group = &scene->group[g];
        bool in = group->selects && (group->material < 0 || group->material == sphere->material) &&
                  sphere->radius > group->radius_above && sphere->radius <= group->radius_upto &&
                  (!group->by_region || region_contains(&group->region, &space, sphere->x, 0));
        bool listed = group->id_count == 0;
        for (int k = 0; k < group->id_count && !listed; k++)
            listed = group->id[k] == sphere->id;
        if (in && listed)
            chosen = g;
    }
    return chosen;
}

/* Completes a sphere: material, density, velocity, group. */
static bool complete(const struct walk *walk, int source, const struct source_batch *batch,
                     struct source_sphere *sphere) {
    const struct scene *scene = walk->scene;
    const struct source_options *options = &scene->source[source];
    bool typed = batch->rows.material && !batch->materials_named;
    char text[200];
    if (options->material >= 0)
        sphere->material = options->material;
    else if (typed && options->type_count > 0) {
        if (sphere->material < 0 || sphere->material >= options->type_count) {
            because(text, sizeof(text), "type %d, but `types` names %d materials", sphere->material + 1,
                    options->type_count);
            return sphere_fail(walk, source, sphere, text);
        }
        sphere->material = options->type_material[sphere->material];
    } else if (!batch->rows.material && scene->materials > 1) {
        return sphere_fail(walk, source, sphere,
                           "has no material: the file names none, so the source needs `material`");
    } else if (!batch->rows.material) {
        sphere->material = 0;
    }
    if (sphere->material < 0 || sphere->material >= scene->materials) {
        because(text, sizeof(text),
                "type %d, but the scene has %d materials (`types` or `material` of the source maps them)",
                sphere->material + 1, scene->materials);
        return sphere_fail(walk, source, sphere, text);
    }
    if (options->density > 0)
        sphere->density = options->density;
    else if (!(sphere->density > 0))
        sphere->density = scene->material[sphere->material].density;
    struct random_sequence random = random_sequence(scene->seed, RANDOM_VELOCITY, (uint64_t)sphere->id);
    for (int d = 0; d < 3; d++) {
        bool flat = scene->box.dimension == 2 && d == 2;
        sphere->v[d] +=
            options->velocity[d] +
            (options->velocity_sigma > 0 && !flat ? options->velocity_sigma * random_normal(&random) : 0);
        sphere->omega[d] += options->omega[d];
    }
    if (scene->box.dimension == 2 && (sphere->v[2] != 0 || sphere->omega[0] != 0 || sphere->omega[1] != 0))
        return sphere_fail(walk, source, sphere, "moves out of the plane of a two-dimensional scene");
    sphere->group = options->group >= 0 ? options->group : select_group(scene, sphere);
    return true;
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
    census->volume += 4 * M_PI / 3 * r * r * r;
}

static void append_sphere(const struct walk *walk, const struct source_sphere *sphere, const double x[3]) {
    struct particles *particles = walk->particles;
    size_t i = particles_append(particles);
    struct particle_state *state = &particles->state[i];
    bool free = walk->scene->group[sphere->group].motion == SCENE_FREE;
    memcpy(state->x, x, sizeof(state->x));
    memcpy(state->v, sphere->v, sizeof(state->v));
    state->radius = sphere->radius;
    state->inverse_mass = free ? 1 / particles_sphere_mass(sphere->radius, sphere->density) : 0;
    particles->id[i] = sphere->id;
    if (particles->omega)
        memcpy(particles->omega[i], sphere->omega, sizeof(sphere->omega));
    if (particles->material)
        particles->material[i] = (uint8_t)sphere->material;
    if (particles->group)
        particles->group[i] = (uint8_t)sphere->group;
    if (particles->density)
        particles->density[i] = sphere->density;
    if (particles->image)
        memcpy(particles->image[i], sphere->image, sizeof(sphere->image));
}

/* What no source may give. */
static bool check_sphere(const struct walk *walk, int source, const struct source_sphere *sphere) {
    for (int d = 0; d < 3; d++)
        if (!isfinite(sphere->x[d]) || !isfinite(sphere->v[d]) || !isfinite(sphere->omega[d]))
            return sphere_fail(walk, source, sphere, "position, velocity or spin is not a finite number");
    if (!(sphere->radius > 0) || !isfinite(sphere->radius))
        return sphere_fail(walk, source, sphere, "the radius must be > 0 and finite");
    if (sphere->id < 1)
        return sphere_fail(walk, source, sphere, "ids must be >= 1");
    return true;
}

/* Numbers that are finite, and yet of no use: squares and masses overflow, overlaps drown in rounding. */
static bool check_range(const struct walk *walk, int source, const struct source_sphere *sphere,
                        const double x[3]) {
    const double *v = sphere->v;
    double mass = particles_sphere_mass(sphere->radius, sphere->density);
    if (!isnormal(mass) || !isnormal(1 / mass))
        return sphere_fail(walk, source, sphere,
                           "the mass that follows from radius and density is out of range");
    if (!isfinite(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]))
        return sphere_fail(walk, source, sphere, "the speed is out of range");
    for (int d = 0; d < walk->scene->box.dimension; d++)
        if (fabs(x[d]) * DBL_EPSILON > 1e-3 * sphere->radius)
            return sphere_fail(
                walk, source, sphere,
                "so far from the lower corner of the box, rounding is above a thousandth of the radius");
    return true;
}

static bool take_sphere(struct walk *walk, int source, const struct source_batch *batch,
                        struct source_sphere *sphere) {
    double x[3];
    char why[200];
    if (!check_sphere(walk, source, sphere) || !complete(walk, source, batch, sphere))
        return false;
    if (!place_in_box(walk->scene, sphere, x, why, sizeof(why)))
        return sphere_fail(walk, source, sphere, why);
    if (!check_range(walk, source, sphere, x))
        return false;
    remember(walk, &walk->ids, checksum_row(1, &sphere->id, sizeof(sphere->id)), source, sphere);
    remember(walk, &walk->places, checksum_row(0, x, sizeof(x)), source, sphere);
    count_sphere(walk, sphere);
    if (walk->grid && walk->scene->source[source].kind != SOURCE_RANDOM)
        placegrid_add(walk->grid, x, sphere->radius);
    const struct scene_share *share = walk->share;
    bool mine = share->mine ? share->mine(share->context, x)
                            : (walk->stream / SHARE_BLOCK) % (uint64_t)share->size == (uint64_t)share->rank;
    walk->stream++;
    if (mine)
        append_sphere(walk, sphere, x);
    return true;
}

/* Row `k` of a batch as a sphere in the user's coordinates. */
static struct source_sphere sphere_of(const struct source_options *options, const struct source_batch *batch,
                                      size_t k) {
    const struct rows *rows = &batch->rows;
    struct source_sphere sphere = {.radius = rows->radius[k],
                                   .material = rows->material ? rows->material[k] : 0,
                                   .line = batch->line ? batch->line[k] : 0};
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
    return sphere;
}

/* Room for what this rank is to expect of `count` particles, lest arrays grow step by step. */
static void expect(struct walk *walk, size_t count) {
    size_t ranks = (size_t)walk->share->size, share = count / ranks;
    share += ranks > 1 ? share / 16 + 1 : 0;
    particles_reserve(walk->particles, walk->particles->owned + share);
    unique_reserve(&walk->ids, walk->ids.count + share);
    unique_reserve(&walk->places, walk->places.count + share);
}

static bool take_batch(struct walk *walk, int source, const struct source_batch *batch) {
    const struct source_options *options = &walk->scene->source[source];
    expect(walk, batch->rows.count);
    int64_t base = walk->census.id_max, taken = 0;
    for (size_t k = 0; k < batch->rows.count; k++) {
        struct source_sphere sphere = sphere_of(options, batch, k);
        if (options->kind == SOURCE_FILE &&
            !(sphere.radius > options->radius_above && sphere.radius <= options->radius_upto) &&
            sphere.radius > 0)
            continue;
        taken++;
        sphere.id = base + (batch->rows.id ? batch->rows.id[k] : taken);
        if (batch->rows.id && batch->rows.id[k] < 1)
            sphere.id = 0;
        if (options->kind == SOURCE_SINGLE && options->id > 0)
            sphere.id = options->id;
        if (!take_sphere(walk, source, batch, &sphere))
            return false;
    }
    char key[96];
    return taken > 0 ||
           finish_fail(walk->scene, walk->error, source_key(source, "radius_upto", key, sizeof(key)),
                       "no particle of %s has a radius above %g and up to %g", options->file,
                       options->radius_above, options->radius_upto);
}

static bool make_batch(struct walk *walk, int source, struct source_batch *batch) {
    const struct source_options *options = &walk->scene->source[source];
    struct h5md_read_options read = {.frame = options->frame};
    switch (options->kind) {
    case SOURCE_LATTICE:
        return lattice_make(walk->scene, source, batch, walk->error);
    case SOURCE_RANDOM:
        return packing_make(walk->scene, source, walk->grid, batch, walk->error);
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
    if (options->format == SOURCE_LAMMPS_DATA)
        return lammps_data_read(options->file, &batch->rows, walk->error);
    return h5md_read(options->file, &read, NULL, &batch->rows, walk->error) &&
           (batch->rows.radius ||
            error_set(walk->error, ERROR_USER, "%.700s: /particles has no radius", options->file));
}

static bool take_source(struct walk *walk, int source) {
    struct source_batch batch = {0};
    bool good = make_batch(walk, source, &batch) && take_batch(walk, source, &batch);
    source_batch_free(&batch);
    return good;
}

/* The grid of places, where a source places at random. */
static void make_grid(struct walk *walk) {
    double unit = INFINITY;
    for (int s = 0; s < walk->scene->sources; s++) {
        const struct source_options *source = &walk->scene->source[s];
        double smallest, largest;
        sizes_bounds(&source->sizes, &smallest, &largest);
        if (source->kind == SOURCE_RANDOM)
            unit = fmin(unit, smallest);
    }
    if (isfinite(unit))
        walk->grid = placegrid_create(&walk->scene->box, unit);
}

static bool check_groups(const struct walk *walk) {
    for (int g = 1; g < walk->scene->groups; g++) {
        char key[64];
        bool fed = walk->census.group[g] > 0;
        for (int k = 0; k < walk->scene->insertions; k++)
            fed = fed || walk->scene->insertion[k].group == g;
        snprintf(key, sizeof(key), "groups[%d].select", g - 1);
        if (!fed)
            return finish_fail(walk->scene, walk->error, key, "no particle belongs to the group '%s'",
                               walk->scene->group[g].name);
    }
    return true;
}

bool scene_particles(const struct scene *scene, const struct scene_share *share, struct particles *particles,
                     struct scene_census *census, struct error *error) {
    struct walk walk = {.scene = scene, .share = share, .particles = particles, .error = error};
    make_grid(&walk);
    bool good = true;
    for (int s = 0; s < scene->sources && good; s++)
        good = take_source(&walk, s);
    good = good && check_groups(&walk) && check_unique(&walk, &walk.ids, "has the id of") &&
           check_unique(&walk, &walk.places, "its centre coincides with that of");
    placegrid_destroy(&walk.grid);
    unique_free(&walk.ids);
    unique_free(&walk.places);
    if (census)
        *census = walk.census;
    return good;
}
