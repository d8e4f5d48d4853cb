/* SPDX-License-Identifier: BSD-3-Clause */
/* The sources that name a shape: which entry it is, how large the balls are that they place, and how much of a ball is solid.
 * bodies_shapes.h has the shapes, place.c makes the bodies. */
#include "physics/bodies/bodies_parts.h"
#include "physics/bodies/bodies_shapes.h"
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

/* The names of all entries, parted by commas. */
static void names_list(const struct bodies_options *options, char *text, size_t room) {
    size_t used = 0;
    text[0] = '\0';
    for (int k = 0; k < bodies_entries(options) && used + 1 < room; k++) {
        const int more =
            snprintf(text + used, room - used, "%s%s", k ? ", " : "", bodies_entry(options, k)->name);
        used += (size_t)more;
    }
}

/* The number of the entry of the name; -1, with an error: none has it, or several. */
static int entry_find(const struct scene *scene, const struct bodies_options *options,
                      const struct namer *namer, struct error *error) {
    int found = -1, count = 0;
    char text[1200], names[900];
    for (int k = 0; k < bodies_entries(options); k++)
        if (strcmp(bodies_entry(options, k)->name, namer->shape) == 0) {
            found = k;
            count++;
        }
    names_list(options, names, sizeof names);
    if (count == 0)
        snprintf(text, sizeof text, "no entry of bodies has the name '%s'; allowed: %s", namer->shape, names);
    else if (count > 1)
        snprintf(text, sizeof text,
                 "%d entries of bodies have the name '%s'; names must differ where a source uses them", count,
                 namer->shape);
    if (count != 1)
        refuse(scene, namer, "shape", text, error);
    return count == 1 ? found : -1;
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

/* The numbers of the form of an entry; `bodies` has the shapes. */
static void form_set(struct source_form *form, const struct bodies *bodies, int entry, bool flat) {
    int first;
    const int shapes = place_shapes(bodies->options, entry, &first);
    const enum clump_size size = bodies->entry[first]->size;
    *form = (struct source_form){.shape = entry + 1, .ball = 1};
    for (int k = first; k < first + shapes && size != CLUMP_AS_DRAWN && !flat; k++) {
        const struct clump *clump = &bodies->clump[k];
        const double span = size == CLUMP_BY_VOLUME ? clump->span : clump->extent;
        form->solid += pow(bodies_shapes_radius(clump) / span, 3) / shapes;
        if (size == CLUMP_BY_VOLUME)
            form->ball = span / bodies_shapes_radius(clump);
    }
}

static bool forms_set(struct scene *scene, const struct bodies *bodies, struct error *error) {
    for (int k = 0; k < scene->sources + scene->insertions; k++) {
        const struct namer namer = namer_of(scene, k);
        if (!namer.shape[0])
            continue;
        form_set(namer.form, bodies, entry_find(scene, bodies->options, &namer, error),
                 scene->box.dimension == 2);
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
    *any = false;
    for (int k = 0; k < scene->sources + scene->insertions; k++) {
        const struct namer namer = namer_of(scene, k);
        if (!namer.shape[0])
            continue;
        const int entry = entry_find(scene, options, &namer, error);
        if (entry < 0 || !entry_suits(scene, options, entry, error))
            return false;
        entry_of(options, entry)->named = *any = true;
    }
    return true;
}

bool bodies_finish(struct scene *scene, struct error *error) {
    struct bodies_options *options = (void *)scene->physics[PHYSICS_bodies];
    bool any;
    if (!entries_mark(scene, options, &any, error))
        return false;
    for (int k = 0; k < bodies_entries(options); k++) {
        struct clump_entry *entry = entry_of(options, k);
        if (entry->size == CLUMP_AUTO)
            entry->size = entry->named && scene->box.dimension == 3 ? CLUMP_BY_VOLUME : CLUMP_BY_GRAIN;
    }
    struct bodies bodies = {0};
    bool good =
        !any || (bodies_shapes_make(&bodies, scene, options, error) && forms_set(scene, &bodies, error));
    bodies_shapes_free(&bodies);
    return good;
}
