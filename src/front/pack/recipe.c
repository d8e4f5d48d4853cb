/* SPDX-License-Identifier: BSD-3-Clause */
/* From a law and KEY=VALUE to settings of a scene: sizes (recipe_sizes.c), then count, fraction and container. Read recipe.h first. */
#include "front/pack/recipe.h"

#include "base/memory.h"
#include "data/scene/scene_read.h"
#include "data/scene/source_batch.h"
#include "front/pack/recipe_work.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char head[] = "units: none\nstep: {count: 0}\ncontact: {law: hooke}\n"
                           "materials: [{name: small, density: 1}, {name: large, density: 1}]\n"
                           "material_pairs: [{restitution: 0.5, k_n: 1}]\n";

static const char *const shape_names[] = {"cube", "box", "cylinder", "sphere", "mesh", NULL};
static const char *const wall_names[] = {"periodic", "hard", NULL};
static const char *const no_yes[] = {"no", "yes", NULL};

/* Sets *to to the number of a key's value among names. */
static bool read_name(struct recipe_work *work, const char *key, const char *const *names, int *to) {
    const char *text = recipe_value(work, key);
    char allowed[128] = "";
    *to = 0;
    for (int k = 0; text && names[k]; k++) {
        if (strcmp(names[k], text) == 0) {
            *to = k;
            return true;
        }
        snprintf(allowed + strlen(allowed), sizeof allowed - strlen(allowed), "%s%s", k ? ", " : "",
                 names[k]);
    }
    return !text || recipe_fail(work, "%s=%s: allowed are %s", key, text, allowed);
}

/* Each text is KEY=VALUE, with a key of the law. */
static bool check_keys(struct recipe_work *work) {
    for (int k = 0; k < work->given; k++) {
        const char *text = work->setting[k];
        size_t length = strcspn(text, "=");
        if (text[length] != '=')
            return recipe_fail(work, "'%s' must read KEY=VALUE", text);
        if (!laws_has(work->law, text, length))
            return recipe_fail(work, "'%.*s' is no key of the law %s; 'scree help pack %s' lists its keys",
                               (int)length, text, work->law->name, work->law->name);
        if (!text[length + 1])
            return recipe_fail(work, "%s needs a value", text);
    }
    return true;
}

/* The keys that each container has, and how many of them it needs. */
static const struct {
    const char *keys[2];
    int needed;
} shapes[] = {[RECIPE_CUBE] = {{"box"}, 0},
              [RECIPE_BOX] = {{"edges"}, 1},
              [RECIPE_CYLINDER] = {{"radius", "length"}, 2},
              [RECIPE_SPHERE] = {{"radius"}, 1},
              [RECIPE_MESH] = {{"file", "scaled"}, 1}};
static const char *const shape_keys[] = {"box", "edges", "radius", "length", "file", "scaled"};

/* The keys of the container are given, and no others. */
static bool check_shape(struct recipe_work *work, const struct recipe *r) {
    const char *const *keys = shapes[r->shape].keys, *name = shape_names[r->shape];
    for (size_t k = 0; k < sizeof shape_keys / sizeof shape_keys[0]; k++) {
        bool fits = strcmp(shape_keys[k], keys[0]) == 0 || (keys[1] && strcmp(shape_keys[k], keys[1]) == 0);
        if (!fits && recipe_given(work, shape_keys[k]))
            return recipe_fail(work, "%s= does not go with shape=%s, which has %s%s%s", shape_keys[k], name,
                               keys[0], keys[1] ? " and " : "", keys[1] ? keys[1] : "");
    }
    bool two = shapes[r->shape].needed > 1;
    for (int k = 0; k < shapes[r->shape].needed; k++)
        if (!recipe_given(work, keys[k]))
            return recipe_fail(work, "shape=%s needs %s=%s%s%s", name, keys[0], two ? " and " : "",
                               two ? keys[1] : "", two ? "=" : "");
    return true;
}

/* Periodic sides, and spheres that settle, which need walls. */
static bool read_sides(struct recipe_work *work, struct recipe *r) {
    int settles, hard;
    if (!read_name(work, "settle", no_yes, &settles) || !read_name(work, "walls", wall_names, &hard) ||
        !recipe_number(work, "friction", 0, 10, &r->friction))
        return false;
    bool periodic = recipe_given(work, "walls") && !hard;
    r->settles = settles;
    if (r->shape > RECIPE_BOX && periodic)
        return recipe_fail(work, "walls=periodic goes with shape=cube and shape=box");
    if (!settles && recipe_given(work, "friction"))
        return recipe_fail(work, "friction= goes with settle=yes");
    if (settles && periodic)
        return recipe_fail(work, "settle=yes needs walls that spheres rest on, and walls=periodic has none");
    recipe_set(work, "box.periodic=%s", settles || hard || r->shape > RECIPE_BOX ? "false" : "true");
    return true;
}

/* A cube or a box from its corner at the origin. */
static bool set_edges(struct recipe_work *work, const char *edges) {
    double edge[3];
    char rest;
    if (sscanf(edges, "%lf,%lf,%lf%c", &edge[0], &edge[1], &edge[2], &rest) != 3)
        return recipe_fail(work, "edges=%s: must be three lengths, as in 10,10,30", edges);
    recipe_set(work, "box.lower=[0, 0, 0]");
    recipe_set(work, "box.upper=[%s]", edges);
    return true;
}

static void set_round(struct recipe_work *work, const struct recipe *r) {
    double radius = r->radius, length = r->length;
    const char *region = "particles.sources[0].region";
    bool sphere = r->shape == RECIPE_SPHERE;
    recipe_set(work, "box.lower=[%.17g, %.17g, %.17g]", -radius, -radius, sphere ? -radius : 0);
    recipe_set(work, "box.upper=[%.17g, %.17g, %.17g]", radius, radius, sphere ? radius : length);
    recipe_set(work, "%s.shape=%s", region, shape_names[r->shape]);
    recipe_set(work, "%s.centre=[0, 0, %.17g]", region, sphere ? 0 : length / 2);
    recipe_set(work, "%s.radius=%.17g", region, radius);
    if (!sphere)
        recipe_set(work, "%s.length=%.17g", region, length);
}

static bool set_container(struct recipe_work *work, struct recipe *r) {
    const char *box = recipe_value(work, "box"), *edges = recipe_value(work, "edges");
    if (r->shape == RECIPE_CUBE && (box || work->box > 0)) {
        double edge = work->box;
        if (!recipe_number(work, "box", 1e-9, 1e9, &edge))
            return false;
        edge = box ? edge : work->box;
        recipe_set(work, "box.lower=[0, 0, 0]");
        recipe_set(work, "box.upper=[%.17g, %.17g, %.17g]", edge, edge, edge);
    }
    if (r->shape == RECIPE_BOX)
        return set_edges(work, edges);
    if (r->shape == RECIPE_CYLINDER || r->shape == RECIPE_SPHERE) {
        if (!recipe_number(work, "radius", 1e-9, 1e9, &r->radius) ||
            !recipe_number(work, "length", 1e-9, 1e9, &r->length))
            return false;
        set_round(work, r);
    }
    if (r->shape != RECIPE_MESH)
        return true;
    r->file = recipe_value(work, "file");
    if (!recipe_number(work, "scaled", 1e-12, 1e12, &r->scaled))
        return false;
    r->hull = hull_create(r->file, r->scaled, work->error);
    if (!r->hull)
        return false;
    const double *lower = r->hull->surface.lower, *upper = r->hull->surface.upper;
    recipe_set(work, "box.lower=[%.17g, %.17g, %.17g]", lower[0], lower[1], lower[2]);
    recipe_set(work, "box.upper=[%.17g, %.17g, %.17g]", upper[0], upper[1], upper[2]);
    return true;
}

/* Of size, count and fraction two decide the third. */
static bool set_amount(struct recipe_work *work, const struct recipe *r) {
    bool count = recipe_given(work, "count"), fraction = recipe_given(work, "fraction");
    bool cube = r->shape == RECIPE_CUBE, box = recipe_given(work, "box");
    if ((!cube || box) && count && fraction)
        return recipe_fail(
            work, "of count, fraction and the size of the %s two decide the third; here all are given",
            shape_names[r->shape]);
    bool counts = cube ? !(box && fraction) : count;
    if (cube && counts && !recipe_published(work))
        return false;
    const char *number = counts ? recipe_value(work, "count") : NULL;
    const char *part =
        (cube ? !box || fraction : !count) && work->box == 0 ? recipe_value(work, "fraction") : NULL;
    if (number)
        recipe_set(work, "particles.sources[0].count=%s", number);
    else if (counts && work->count > 0)
        recipe_set(work, "particles.sources[0].count=%.0f", work->count);
    else if (!part)
        return recipe_fail(work, "shape=%s needs fraction= or count=", shape_names[r->shape]);
    if (part)
        recipe_set(work, "particles.sources[0].volume_fraction=%s", part);
    return true;
}

/* A key that a scene has, for each of the sources if it is one of theirs. */
static void set_key(struct recipe_work *work, const struct laws_key *key, const char *value) {
    static const char source[] = "particles.sources.";
    const char *open = key->list ? "[" : "", *close = key->list ? "]" : "";
    if (strncmp(key->path, source, sizeof source - 1) != 0)
        recipe_set(work, "%s=%s", key->path, value);
    else
        for (int s = 0; s < work->sources; s++)
            recipe_set(work, "particles.sources[%d].%s=%s%s%s", s, key->path + sizeof source - 1, open, value,
                       close);
}

/* All keys that a scene has, but count and fraction. */
static void set_keys(struct recipe_work *work) {
    for (int k = 0; laws_key(k); k++) {
        const struct laws_key *key = laws_key(k);
        bool amount = strcmp(key->name, "count") == 0 || strcmp(key->name, "fraction") == 0;
        if (!key->path || amount || !laws_has(work->law, key->name, strlen(key->name)))
            continue;
        const char *value = recipe_value(work, key->name);
        if (value)
            set_key(work, key, value);
    }
}

static bool set_all(struct recipe_work *work, struct recipe *r) {
    int shape;
    if (!check_keys(work) || !read_name(work, "shape", shape_names, &shape))
        return false;
    r->shape = (enum recipe_shape)shape;
    if (!check_shape(work, r) || !read_sides(work, r))
        return false;
    if (work->law->cube_only)
        return recipe_bidisperse(work) && set_container(work, r) && (set_keys(work), true);
    recipe_set(work, "particles.sources[0].from=packed");
    recipe_set(work, "particles.sources[0].material=small");
    work->sources = 1;
    if (!recipe_sizes(work) || !set_amount(work, r) || !set_container(work, r))
        return false;
    set_keys(work);
    return true;
}

bool recipe_read(struct recipe *recipe, const char *law, const char *const *setting, int settings,
                 struct error *error) {
    struct recipe_work *work = memory_allocate_zero(1, sizeof *work, "settings of a packing");
    struct scene_setting set[RECIPE_SETS_MAX];
    *recipe = (struct recipe){.law = laws_find(law), .scaled = 1};
    *work = (struct recipe_work){.law = recipe->law, .setting = setting, .given = settings, .error = error};
    bool good =
        recipe->law != NULL ||
        recipe_fail(work,
                    "'%s' is no law of sizes; known are bidisperse, univol, sand, exponential, power, "
                    "sieve, discrete",
                    law);
    good = good && set_all(work, recipe);
    for (int k = 0; k < work->sets; k++)
        set[k].text = work->set[k];
    if (good)
        recipe->scene = scene_parse("command line", head, set, work->sets, error);
    for (int k = 0; k < work->sets; k++)
        free(work->set[k]);
    recipe->broad = work->broad;
    memory_free(work);
    if (!recipe->scene)
        return false;
    struct source_options *last = &recipe->scene->source[recipe->scene->sources - 1];
    if (recipe->hull)
        last->region = (struct region){.shape = REGION_SURFACE, .surface = &recipe->hull->surface};
    return true;
}

void recipe_free(struct recipe *recipe) {
    scene_free(&recipe->scene);
    hull_destroy(&recipe->hull);
}

struct region recipe_region(const struct recipe *recipe, struct region_space *space) {
    return source_region(recipe->scene, &recipe->scene->source[0].region, space);
}

void recipe_describe(const struct recipe *recipe, char *text, size_t size) {
    const struct box *box = &recipe->scene->box;
    const char *sides = box->periodic[0] ? "periodic" : "hard walls";
    switch (recipe->shape) {
    case RECIPE_CUBE:
        snprintf(text, size, "a cube of edge %.6g, %s", box->edge[0], sides);
        return;
    case RECIPE_BOX:
        snprintf(text, size, "a box of %.6g x %.6g x %.6g, %s", box->edge[0], box->edge[1], box->edge[2],
                 sides);
        return;
    case RECIPE_CYLINDER:
        snprintf(text, size, "a cylinder of radius %.6g and length %.6g", recipe->radius, recipe->length);
        return;
    case RECIPE_SPHERE:
        snprintf(text, size, "a sphere of radius %.6g", recipe->radius);
        return;
    default:
        snprintf(text, size, "%.200s, which encloses %.6g", recipe->file, recipe->hull->surface.volume);
    }
}
