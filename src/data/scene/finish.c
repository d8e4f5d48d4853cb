/* SPDX-License-Identifier: BSD-3-Clause */
/* Derives the data of the modules from the values read: pairs of materials, unit vectors, defaults that depend on other
 * keys. */
#include "data/scene/finish.h"
#include "data/scene/scene_files.h"
#include "data/scene/scene_shapes.h"
#include "data/scene/scene_stage.h"

#include "base/memory.h"
#include "physics/grains/motion/timestep.h"
#include "data/scene/tree.h"

#include <math.h>
#include <search.h>
#include <string.h>

void finish_prepare(struct scene *scene) {
    snprintf(scene->group[0].name, SCENE_NAME_MAX, "free");
    scene->group[0].material = -1;
    scene->group[0].radius_above = -1;
    scene->group[0].radius_upto = INFINITY;
    scene->groups = 1;
}

/* Scales to length 1; one that has it already keeps its bits. */
static bool normalise(double v[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 0) || !isfinite(length))
        return false;
    for (int d = 0; d < 3 && fabs(length - 1) > 1e-15; d++)
        v[d] /= length;
    return true;
}

static bool unit_vector(const struct scene *scene, double v[3], struct error *error, const char *key) {
    return normalise(v) || scene_fail(scene, error, key, "[%g, %g, %g] has no direction", v[0], v[1], v[2]);
}

static void finish_motion(struct scene *scene) {
    struct box_motion *motion = &scene->box.motion;
    if (!scene->shear_given && !scene->strain_given && !scene->stress_given)
        return;
    for (int k = 0; k < 3 && scene->stress_given && !scene->shear_given; k++)
        if (!isnan(scene->stress.shear[k]))
            *motion = (struct box_motion){.shears = true, .flow = k / 2, .gradient = 1 + (k + 1) / 2};
    if (scene->shear_given)
        *motion = (struct box_motion){.shears = true,
                                      .flow = scene->shear.flow,
                                      .gradient = scene->shear.gradient,
                                      .shear = scene->shear.rate,
                                      .offset = scene->shear.offset};
    for (int d = 0; d < 3 && scene->strain_given; d++)
        motion->stretch[d] = scene->strain.rate[d];
    motion->moves = scene->ghosts.in_place = true;
    box_follow(&scene->box, (double[4]){0});
}

/* LAMMPS ends contacts at zero overlap. */
static void finish_law(struct scene *scene) {
    bool lammps = scene->law.lammps_history || scene->law.lammps_granular;
    if (lammps && !scene_gives(scene, "contact", "end"))
        scene->law.end = LAW_END_OVERLAP;
}

static void finish_newton(struct scene *scene) {
    for (int k = 0; k < PHYSICS_COUNT; k++)
        if (scene->physics_given[k] && physics_particles(k) == PHYSICS_OWN)
            scene->ghosts.newton = false;
}

static void finish_step(struct scene *scene) {
    if (isnan(scene->duration))
        scene->duration = -1;
    if (isnan(scene->step.dt))
        scene->step.dt = 0;
    if (isnan(scene->step.fraction))
        scene->step.fraction = scene->step.dt > 0 ? 0 : timestep_default_fraction();
    scene->law.synchronised = integrator_find(scene->integrator)->synchronised;
}

/* The entry's name in a list as read, or NULL. */
static const struct tree_node *name_of(const struct tree_node *entry) {
    const struct tree_node *name = entry->kind == TREE_MAP ? tree_get(entry, "name") : NULL;
    return name && name->kind == TREE_SCALAR && name->text[0] ? name : NULL;
}

/* A name of a list and the first entry that has it. */
struct named {
    const struct tree_node *name;
    size_t entry;
};

static int compare_names(const void *a, const void *b) {
    const struct named *first = a, *second = b;
    return strcmp(first->name->text, second->name->text);
}

/* Looks for a name that was seen before, by a search tree (tsearch). */
static bool names_differ(const struct scene *scene, const struct tree_node *root, const char *list,
                         struct error *error) {
    const struct tree_node *entries = tree_nearest(root, list);
    size_t count = entries->kind == TREE_LIST ? entries->children : 0;
    struct named *named = memory_allocate(count, sizeof(*named), "names of a scene");
    void *seen = NULL;
    bool good = true;
    for (size_t a = 0; good && a < count; a++) {
        named[a] = (struct named){name_of(entries->child[a]), a};
        if (named[a].name == NULL)
            continue;
        const struct named *const *first = tsearch(&named[a], &seen, compare_names);
        if (first == NULL)
            error_fatal("out of memory: names of a scene");
        if (*first == &named[a])
            continue;
        char key[96], place[SCENE_PATH_MAX + 32];
        snprintf(key, sizeof(key), "%s[%zu].name", list, a);
        tree_place((*first)->name, scene->file, place, sizeof(place));
        good = scene_fail(scene, error, key, "'%s' is taken already, by %s[%zu] (%s); names must differ",
                          named[a].name->text, list, (*first)->entry, place);
    }
    while (seen)
        tdelete(*(const struct named *const *)seen, &seen, compare_names);
    memory_free(named);
    return good;
}

bool finish_names(const struct scene *scene, const struct tree_node *root, struct error *error) {
    static const char *const list[] = {
        "materials",         "walls", "groups", "observables.regions", "observables.planes",
        "observables.grids", "stages"};
    for (size_t k = 0; k < sizeof(list) / sizeof(list[0]); k++)
        if (!names_differ(scene, root, list[k], error))
            return false;
    return true;
}

static struct law_pair pair_finished(const struct scene_pair *pair) {
    struct law_pair law = {.restitution = pair->restitution,
                           .friction = pair->friction,
                           .rolling_friction = pair->rolling_friction,
                           .k_n = pair->k_n,
                           .k_t = isnan(pair->k_t) ? pair->k_n * 2 / 7 : pair->k_t,
                           .gamma_n = pair->gamma_n,
                           .gamma_t = isnan(pair->gamma_t) ? pair->gamma_n / 2 : pair->gamma_t};
    /* a coefficient that is not given is 0 */
    const double *from = (const double *)&pair->extra;
    double *to = (double *)&law.extra;
    for (size_t k = 0; k < sizeof law.extra / sizeof *to; k++)
        to[k] = isnan(from[k]) ? 0 : from[k];
    return law;
}

/* A scene without materials has no contacts, and needs something else to do. */
static bool finish_materials(const struct scene *scene, struct error *error) {
    static const char needed[] = "is missing; needed: a list of sections (`- key: value`)";
    bool other = false;
    for (int k = 0; k < PHYSICS_COUNT; k++)
        other = other || scene->physics_given[k];
    if (scene->materials == 0 && !other)
        return scene_fail(scene, error, "materials", needed);
    if (scene->materials > 0 && scene->pairs == 0)
        return scene_fail(scene, error, "material_pairs", needed);
    return scene->materials > 0 || scene->pairs == 0 ||
           scene_fail(scene, error, "material_pairs", "is given, but the scene has no materials");
}

/* Materials that a particle may be of; the others belong to walls alone, which never meet each other. */
static void particle_materials(const struct scene *scene, bool may[LAW_MATERIALS_MAX]) {
    for (int s = 0; s < scene->sources; s++) {
        const struct source_options *source = &scene->source[s];
        bool any = source->material < 0 && source->type_count == 0;
        for (int m = 0; any && m < scene->materials; m++)
            may[m] = true;
        if (source->material >= 0)
            may[source->material] = true;
        for (int t = 0; t < source->type_count; t++)
            may[source->type_material[t]] = true;
    }
    for (int k = 0; k < scene->insertions; k++)
        if (scene->insertion[k].material >= 0)
            may[scene->insertion[k].material] = true;
}

/* Enters the pairs that are named, and finds the entry that serves all others; -1: none. */
static bool enter_pairs(struct scene *scene, bool *named, int *fallback, struct error *error) {
    *fallback = -1;
    for (int k = 0; k < scene->pairs; k++) {
        struct scene_pair *pair = &scene->pair[k];
        char key[64];
        snprintf(key, sizeof(key), "material_pairs[%d].between", k);
        if (pair->between_count == 0) {
            if (*fallback >= 0)
                return scene_fail(
                    scene, error, key,
                    "is missing; only one entry may be the default of all pairs, and [%d] is it", *fallback);
            *fallback = k;
            continue;
        }
        if (pair->between_count != 2)
            return scene_fail(scene, error, key, "names %d materials; needed: two", pair->between_count);
        int a = pair->material[0], b = pair->material[1];
        size_t there = law_place_of(scene->materials, a, b), back = law_place_of(scene->materials, b, a);
        if (named[there])
            return scene_fail(scene, error, key, "the pair %s, %s is given twice", scene->material[a].name,
                              scene->material[b].name);
        named[there] = named[back] = true;
        scene->law_pair[there] = scene->law_pair[back] = pair_finished(pair);
    }
    return true;
}

/* Fills the matrix of pairs: named entries, and the default one for all others. */
static bool fill_pairs(struct scene *scene, const bool *named, int fallback, struct error *error) {
    bool may[LAW_MATERIALS_MAX] = {false};
    particle_materials(scene, may);
    for (int a = 0; a < scene->materials; a++)
        for (int b = 0; b <= a; b++) {
            if (named[law_place_of(scene->materials, a, b)])
                continue;
            if (fallback < 0 && (may[a] || may[b]))
                return scene_fail(
                    scene, error, "material_pairs",
                    "the pair %s, %s is missing (an entry without `between` serves all that are not named)",
                    scene->material[b].name, scene->material[a].name);
            /* a pair that never meets takes any values */
            *scene_law_pair(scene, a, b) = *scene_law_pair(scene, b, a) =
                pair_finished(&scene->pair[fallback < 0 ? 0 : fallback]);
        }
    return true;
}

static bool finish_pairs(struct scene *scene, struct error *error) {
    size_t entries = (size_t)scene->materials * (size_t)scene->materials;
    bool *named = memory_allocate_zero(entries, sizeof(*named), "pairs of materials");
    int fallback;
    scene->law_pair = memory_allocate_zero(entries, sizeof(*scene->law_pair), "pairs of materials");
    bool good = enter_pairs(scene, named, &fallback, error) && fill_pairs(scene, named, fallback, error);
    memory_free(named);
    return good;
}

/* Sets a material that was not named: the only one. A scene without materials leaves all unnamed. */
static bool only_material(const struct scene *scene, int *material, struct error *error, const char *list,
                          int number) {
    if (scene->materials == 0)
        return true;
    if (*material < 0 && scene->materials == 1)
        *material = 0;
    char key[64];
    snprintf(key, sizeof(key), "%s[%d].material", list, number);
    return *material >= 0 ||
           scene_fail(scene, error, key, "is missing; needed, as there are several materials");
}

static bool finish_walls(struct scene *scene, struct error *error) {
    for (int w = 0; w < scene->walls; w++) {
        struct wall_options *wall = &scene->wall[w];
        char key[96];
        if (!wall->name[0])
            snprintf(wall->name, WALL_NAME_MAX, "wall%d", w + 1);
        if (strcmp(wall->format, "auto") == 0)
            wall->format[0] = '\0';
        if (!only_material(scene, &wall->material, error, "walls", w))
            return false;
        snprintf(key, sizeof(key), "walls[%d].%s", w,
                 wall->shape == WALL_PLANE || wall->shape == WALL_DISC ? "normal" : "axis");
        if ((wall->shape == WALL_PLANE || wall->shape == WALL_DISC) &&
            !unit_vector(scene, wall->normal, error, key))
            return false;
        if ((wall->shape == WALL_CYLINDER || wall->shape == WALL_CONE) &&
            !unit_vector(scene, wall->axis, error, key))
            return false;
        snprintf(key, sizeof(key), "walls[%d].free.direction", w);
        bool directed = wall->free.freedom == WALL_FREE_ALONG || wall->free.freedom == WALL_FREE_ABOUT;
        if (wall->free.given && directed && !unit_vector(scene, wall->free.direction, error, key))
            return false;
        for (int m = 0; m < wall->motions; m++) {
            struct wall_motion *motion = &wall->motion[m];
            snprintf(key, sizeof(key), "walls[%d].motion[%d].direction", w, m);
            if (motion->kind != WALL_TRANSLATE && motion->kind != WALL_TABLE &&
                !unit_vector(scene, motion->direction, error, key))
                return false;
        }
    }
    return true;
}

static bool finish_groups(struct scene *scene, struct error *error) {
    for (int g = 1; g < scene->groups; g++) {
        struct scene_group *group = &scene->group[g];
        char key[64];
        snprintf(key, sizeof(key), "groups[%d].select.region.axis", g - 1);
        if (group->region.shape == REGION_CYLINDER && !unit_vector(scene, group->region.axis, error, key))
            return false;
        if (isnan(group->radius_above))
            group->radius_above = -1;
        if (isnan(group->radius_upto))
            group->radius_upto = INFINITY;
        group->by_region = group->region.shape != REGION_ALL;
        group->selects = group->by_region || group->material >= 0 || group->id_count > 0 ||
                         group->radius_above >= 0 || isfinite(group->radius_upto);
    }
    for (int g = 1; g < scene->groups; g++)
        if (strcmp(scene->group[g].name, scene->group[0].name) == 0) {
            char key[64];
            snprintf(key, sizeof(key), "groups[%d].name", g - 1);
            return scene_fail(scene, error, key, "'%s' is taken already: it is the group of all others",
                              scene->group[g].name);
        }
    return true;
}

static bool finish_sources(struct scene *scene, struct error *error) {
    for (int s = 0; s < scene->sources; s++) {
        struct source_options *source = &scene->source[s];
        char key[80];
        snprintf(key, sizeof(key), "particles.sources[%d].region.axis", s);
        if (source->kind != SOURCE_FILE &&
            !only_material(scene, &source->material, error, "particles.sources", s))
            return false;
        if (source->region.shape == REGION_CYLINDER && !unit_vector(scene, source->region.axis, error, key))
            return false;
    }
    for (int k = 0; k < scene->insertions; k++) {
        struct insertion_options *insertion = &scene->insertion[k];
        char key[80];
        snprintf(key, sizeof(key), "insertions[%d].region.axis", k);
        if (!only_material(scene, &insertion->material, error, "insertions", k))
            return false;
        if (insertion->region.shape == REGION_CYLINDER &&
            !unit_vector(scene, insertion->region.axis, error, key))
            return false;
        snprintf(key, sizeof(key), "insertions[%d].density", k);
        if (scene->materials == 0 && !(insertion->density > 0))
            return scene_fail(scene, error, key, "is missing; needed, as the scene has no materials");
        insertion->group = insertion->group < 0 ? 0 : insertion->group;
    }
    for (int k = 0; k < scene->deletions; k++) {
        char key[80];
        snprintf(key, sizeof(key), "deletions[%d].region.axis", k);
        if (scene->deletion[k].region.shape == REGION_CYLINDER &&
            !unit_vector(scene, scene->deletion[k].region.axis, error, key))
            return false;
    }
    return true;
}

/* A trajectory without place or radius could not be read back; its ids are always there. */
static bool finish_fields(struct scene *scene, struct error *error) {
    static const char *const needed[] = {"position", "radius"};
    struct output_fields *fields = &scene->output.trajectory.fields;
    int named = fields->count; /* 0: all */
    for (size_t k = 0; named > 0 && k < sizeof(needed) / sizeof(needed[0]); k++) {
        bool there = false;
        for (int f = 0; f < named; f++)
            there = there || strcmp(fields->name[f], needed[k]) == 0;
        if (there)
            continue;
        if (fields->count == OUTPUT_FIELDS_MAX)
            return scene_fail(scene, error, "output.trajectory.fields", "no room for %s among %d names",
                              needed[k], named);
        snprintf(fields->name[fields->count++], OUTPUT_NAME_MAX, "%s", needed[k]);
    }
    return true;
}

/* What physics derive from the scene; a shape needs the physics that has it. */
static bool finish_physics(struct scene *scene, struct error *error) {
    char key[80], why[256];
    for (int k = 0; k < scene->sources + scene->insertions && !scene->physics_given[PHYSICS_bodies]; k++) {
        bool source = k < scene->sources;
        int number = source ? k : k - scene->sources;
        const char *shape = source ? scene->source[number].shape : scene->insertion[number].shape;
        snprintf(key, sizeof(key), "%s[%d].shape", source ? "particles.sources" : "insertions", number);
        if (shape[0] && scene_shapes_find(NULL, shape, why, sizeof(why)) < 0)
            return scene_fail(scene, error, key, "%s", why);
    }
#define FINISH(name)                                                                                         \
    if (scene->physics_given[PHYSICS_##name] && !name##_finish(scene, error))                                \
        return false;
    PHYSICS_FINISHED(FINISH)
#undef FINISH
    return true;
}

bool finish_scene(struct scene *scene, struct error *error) {
    if (!finish_materials(scene, error) || !scene_files_sizes(scene, error) ||
        !finish_physics(scene, error) || !finish_box(scene, error) || !finish_pairs(scene, error) ||
        !finish_walls(scene, error) || !finish_groups(scene, error) || !finish_sources(scene, error) ||
        !finish_fields(scene, error))
        return false;
    finish_step(scene);
    scene_stages_finish(scene);
    finish_motion(scene);
    finish_law(scene);
    finish_newton(scene);
    scene->law.solved = scene->physics_given[PHYSICS_hard] > 0;
    /* both ends of a bond compute the same bits, from the same positions */
    if (scene->physics_given[PHYSICS_bonds])
        scene->ghosts.in_place = true;
    scene->ghosts.reduced = scene->ghosts_name == SCENE_GHOSTS_REDUCED ||
                            (scene->ghosts_name == SCENE_GHOSTS_AUTO && scene->ghosts.newton);
    if (scene->reproducible)
        scene_make_reproducible(scene);
    scene->classes.skin_given = !isnan(scene->classes.skin);
    if (!scene->classes.skin_given)
        scene->classes.skin = -1;
    return true;
}
