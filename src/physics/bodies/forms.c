/* SPDX-License-Identifier: BSD-3-Clause */
/* The sources that name a shape: which entry it is, how large the balls are that they place, and how much of a ball is solid.
 * bodies_shapes.h has the shapes, place.c makes the bodies. */
#include "physics/bodies/bodies_parts.h"
#include "physics/bodies/bodies_shapes.h"
#include "base/memory.h"
#include "data/scene/scene_files.h"
#include "data/scene/scene_shapes.h"
#include "data/scene/source_bodies.h"
#include "physics_table.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* An entry, those of clumps first. */
static struct clump_entry *entry_of(struct bodies_options *options, int k) {
    return k < options->clumps ? &options->clump[k].entry : &options->rock[k - options->clumps].entry;
}

/* A source or an insertion. */
struct namer {
    const char *list; /* in the scene */
    int number;       /* in the list */
    const char *shape;
    struct sizes_options *sizes;
    struct source_form *form;
    double volume_fraction; /* 0: none is asked for */
};

static struct namer namer_of(struct scene *scene, int k) {
    if (k < scene->sources) {
        struct source_options *source = &scene->source[k];
        return (struct namer){"particles.sources",    k, source->shape, &source->sizes, &source->form,
                              source->volume_fraction};
    }
    struct insertion_options *insertion = &scene->insertion[k - scene->sources];
    return (struct namer){"insertions",      k - scene->sources, insertion->shape,
                          &insertion->sizes, &insertion->form,   0};
}

static bool refuse(const struct scene *scene, const struct namer *namer, const char *key, const char *text,
                   struct error *error) {
    char full[96];
    snprintf(full, sizeof full, "%s[%d].%s", namer->list, namer->number, key);
    return scene_fail(scene, error, full, "%s", text);
}

/* The number of the entry that a source names; -1, with an error: none has the name, or several. */
static int entry_find(const struct scene *scene, const struct namer *namer, struct error *error) {
    char why[1200];
    const int found = scene_shapes_find(scene->shapes, namer->shape, why, sizeof why);
    if (found < 0)
        refuse(scene, namer, "shape", why, error);
    return found;
}

/* An entry that sources name takes all of their grains, and no others. */
static bool entry_suits(const struct scene *scene, const struct bodies_options *options, int k,
                        struct error *error) {
    const struct clump_entry *entry = bodies_entry(options, k);
    const char *wrong = entry->material >= 0           ? "material"
                        : entry->radius_above > 0      ? "radius_above"
                        : isfinite(entry->radius_upto) ? "radius_upto"
                                                       : NULL;
    char key[64];
    bodies_shapes_key(options, k, wrong ? wrong : "size", key, sizeof key);
    if (wrong)
        return scene_fail(scene, error, key,
                          "a source names the entry '%s' (shape), and so chooses its grains; leave this out",
                          entry->name);
    return scene->box.dimension == 3 || entry->size != CLUMP_BY_VOLUME ||
           scene_fail(scene, error, key, "volume: not in two dimensions; allowed: grain, drawn");
}

/* Fills the form of an entry, and its shapes. */
static void entry_fill(struct scene_shapes *list, const struct bodies *bodies, int entry, bool flat) {
    struct scene_entry *of = &list->entry[entry];
    struct source_form *form = &of->form;
    const int shapes = of->shapes;
    const enum clump_size size = bodies->entry[of->first]->size;
    for (int k = of->first; k < of->first + shapes; k++) {
        const struct clump *clump = &bodies->clump[k];
        const double span = size == CLUMP_BY_VOLUME ? clump->span : clump->extent;
        list->shape[k] = (struct scene_shape){.entry = entry,
                                              .solid = pow(bodies_shapes_radius(clump) / clump->extent, 3),
                                              .grain = span / clump->extent,
                                              .drawn = size == CLUMP_AS_DRAWN ? clump->extent : 0};
        memcpy(list->shape[k].axes, clump->axes, sizeof clump->axes);
        if (size == CLUMP_AS_DRAWN || flat)
            continue;
        form->solid += pow(bodies_shapes_radius(clump) / span, 3) / shapes;
        if (size == CLUMP_BY_VOLUME)
            form->ball = span / bodies_shapes_radius(clump);
    }
}

/* Fills what names of shapes stand for; `bodies` has the shapes. */
static void shapes_fill(struct scene_shapes *shapes, const struct bodies *bodies, bool flat) {
    shapes->shapes = bodies->shapes;
    shapes->shape = memory_allocate_zero((size_t)bodies->shapes, sizeof *shapes->shape, "shapes of bodies");
    for (int k = 0; k < shapes->entries; k++)
        entry_fill(shapes, bodies, k, flat);
    bodies_shapes_show(bodies, &shapes->drawn);
}

/* The entries by their names alone. */
static struct scene_shapes *shapes_name(const struct bodies_options *options) {
    const int entries = bodies_entries(options);
    struct scene_shapes *shapes = memory_allocate_zero(1, sizeof *shapes, "shapes of bodies");
    shapes->entry = memory_allocate_zero((size_t)entries, sizeof *shapes->entry, "shapes of bodies");
    shapes->entries = entries;
    for (int k = 0; k < entries; k++) {
        struct scene_entry *entry = &shapes->entry[k];
        entry->shapes = place_shapes(options, k, &entry->first);
        entry->form = (struct source_form){.shape = k + 1, .ball = 1};
        snprintf(entry->name, sizeof entry->name, "%s", bodies_entry(options, k)->name);
    }
    return shapes;
}

static bool forms_set(struct scene *scene, struct error *error) {
    for (int k = 0; k < scene->sources + scene->insertions; k++) {
        const struct namer namer = namer_of(scene, k);
        if (!namer.shape[0])
            continue;
        *namer.form = scene->shapes->entry[entry_find(scene, &namer, error)].form;
        namer.sizes->ball = namer.form->ball;
        if (namer.volume_fraction > 0 && !(namer.form->solid > 0))
            return refuse(
                scene, &namer, "volume_fraction",
                "the part of a ball that its body fills is not known in two dimensions, nor with size: "
                "drawn; allowed: count",
                error);
    }
    return true;
}

/* Marks the entries that sources name. False with an error; `any`: there are such. */
static bool entries_mark(struct scene *scene, struct bodies_options *options, bool *any,
                         struct error *error) {
    for (int k = 0; k < scene->sources + scene->insertions; k++) {
        const struct namer namer = namer_of(scene, k);
        if (!namer.shape[0])
            continue;
        const int entry = entry_find(scene, &namer, error);
        if (entry < 0 || !entry_suits(scene, options, entry, error))
            return false;
        entry_of(options, entry)->named = *any = true;
    }
    return true;
}

/* Files that tell the shapes of their particles name all entries that have no key by which they choose grains. */
static bool files_mark(struct scene *scene, struct bodies_options *options, bool *any, struct error *error) {
    bool all = false, told;
    for (int s = 0; s < scene->sources; s++) {
        if (!source_bodies_told(scene, s, &told, error))
            return false;
        all = all || told;
    }
    for (int k = 0; k < bodies_entries(options) && all; k++) {
        struct clump_entry *entry = entry_of(options, k);
        if (entry->material < 0 && !(entry->radius_above > 0) && !isfinite(entry->radius_upto))
            entry->named = true;
    }
    *any = *any || all;
    return true;
}

/* Makes the shapes once, for what sources must know of them. */
static bool shapes_make(struct scene *scene, const struct bodies_options *options, struct error *error) {
    struct bodies bodies = {0};
    bool good = bodies_shapes_make(&bodies, scene, options, error);
    if (good) {
        shapes_fill(scene->shapes, &bodies, scene->box.dimension == 2);
        good = forms_set(scene, error);
    }
    bodies_shapes_free(&bodies);
    return good;
}

/* True if a source is a file: particles and shapes are then read from files, which are looked for first. */
static bool has_file(const struct scene *scene) {
    bool has = false;
    for (int s = 0; s < scene->sources; s++)
        has = has || scene->source[s].kind == SOURCE_FILE;
    return has;
}

bool bodies_finish(struct scene *scene, struct error *error) {
    struct bodies_options *options = (void *)scene->physics[PHYSICS_bodies];
    bool any = false;
    scene->shapes = shapes_name(options);
    if (!entries_mark(scene, options, &any, error) ||
        ((any || has_file(scene)) && !scene_files_open(scene, error)) ||
        !files_mark(scene, options, &any, error))
        return false;
    for (int k = 0; k < bodies_entries(options); k++) {
        struct clump_entry *entry = entry_of(options, k);
        if (entry->size == CLUMP_AUTO)
            entry->size = entry->named && scene->box.dimension == 3 ? CLUMP_BY_VOLUME : CLUMP_BY_GRAIN;
    }
    return !any || shapes_make(scene, options, error);
}
