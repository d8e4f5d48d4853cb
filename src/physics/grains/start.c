/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the parts of grains that do not depend on the particles: law, walls, force loop. Read grains.h first. */
#include "physics/grains/grains_own.h"
#include "physics/grains/laws/law_user.h"
#include "physics/grains/walls/walls_free.h"
#include "base/memory.h"
#include "kernel/pairs/walk.h"
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The widest instruction set that all ranks have, or the one that the scene names. */
static const char *common_level(const struct physics_context *context) {
    int64_t below = -walk_level(NULL);
    if (context->scene->simd != SCENE_SIMD_AUTO)
        return scene_simd_name(context->scene->simd);
    comm_max_int(context->comm, &below, 1);
    return walk_level_name((int)-below);
}

/* Loads the law of a file: rank 0 compiles it, all ranks load the same bytes. */
static bool load_law(const struct physics_context *context, struct law_options *options,
                     struct error *error) {
    struct grains *grains = context->self;
    struct law_object object = {0};
    struct error plain = {0};
    char place[SCENE_PATH_MAX];
    if (!law_has_trait(options->normal, "file"))
        return true;
    const char *level = common_level(context);
    if (context->comm->rank == 0)
        law_user_compile(options->file, level, &object, &plain);
    if (comm_agree(context->comm, &plain)) {
        char *own = object.bytes;
        comm_broadcast(context->comm, &object, sizeof object);
        object.bytes = own ? own : memory_allocate(object.size, 1, "law");
        comm_broadcast(context->comm, object.bytes, object.size);
        grains->user = law_user_load(options->file, &object, &plain);
        comm_agree(context->comm, &plain);
    }
    law_object_free(&object);
    options->user = grains->user;
    return plain.kind == ERROR_NONE ||
           error_set(error, plain.kind, "%s: contact.law: %s",
                     scene_place(context->scene, "contact.law_file", place, sizeof place), plain.text);
}

/* Makes the walls, and tells of repaired meshes. */
static bool make_walls(const struct physics_context *context, struct error *error) {
    struct grains *grains = context->self;
    const struct scene *scene = context->scene;
    char *said = NULL;
    size_t length = 0;
    FILE *notes = context->comm->rank == 0 ? open_memstream(&said, &length) : NULL;
    bool good = walls_create(&grains->walls, scene->wall, scene->walls, &grains->law, context->box,
                             context->threads, error, notes);
    if (good)
        walls_set_gravity(grains->walls, scene->gravity);
    if (notes) {
        fclose(notes);
        log_text(context->log, said);
        free(said);
    }
    return good;
}

static bool make_law(const struct physics_context *context, struct error *error) {
    struct grains *grains = context->self;
    const struct scene *scene = context->scene;
    const struct integrator *integrator = integrator_find(scene->integrator);
    struct law_options options = scene->law;
    assert(integrator);
    options.synchronised = integrator->synchronised;
    return load_law(context, &options, error) &&
           law_prepare(&grains->law, &options, scene->materials, scene->material, scene->law_pair, error);
}

/* Makes what contacts between grains need. */
static void make_contacts(const struct physics_context *context) {
    struct grains *grains = context->self;
    const struct scene *scene = context->scene;
    if (grains->law.history_components) {
        grains->history = history_create(grains->law.history_components, context->threads);
        grains->history->odd = grains->law.history_odd;
    }
    if (grains->law.materials > 0)
        grains->loop = force_loop_create(context->threads);
    if (scene->stress_given && scene->reproducible)
        grains->exact =
            memory_allocate_zero((size_t)context->threads, sizeof *grains->exact, "sums of the stress");
    grains->contact = (struct force_context){.particles = context->particles,
                                             .history = grains->history,
                                             .law = &grains->law,
                                             .exact = grains->exact,
                                             .prescribed = scene->groups > 1,
                                             .ordered = scene->reproducible};
}

bool grains_start(struct physics_context *context, struct error *error) {
    struct grains *grains = context->self = memory_allocate_zero(1, sizeof *grains, "grains");
    context->options = &grains->law;
    if (!make_law(context, error))
        return false;
    scene_integrator(context->scene, &grains->motion);
    if (context->scene->walls > 0 && !make_walls(context, error))
        return false;
    if (grains->walls && context->scene->reproducible)
        walls_set_exact(grains->walls);
    scene_register(context->scene, &grains->law, context->particles);
    make_contacts(context);
    return true;
}

void start_end(void *self) {
    struct grains *grains = self;
    force_loop_destroy(&grains->loop);
    walls_destroy(&grains->walls);
    history_destroy(&grains->history);
    memory_free(grains->exact);
    law_free(&grains->law);
    law_user_free(&grains->user);
    memory_free(grains);
}

bool start_simd(const struct physics_context *context, struct error *error) {
    struct grains *grains = context->self;
    char place[SCENE_PATH_MAX];
    const char *wanted = scene_simd_name(context->scene->simd);
    if (context->scene->simd == SCENE_SIMD_AUTO)
        return true;
    bool loop = grains->loop ? force_loop_choose(grains->loop, wanted) : walk_level(wanted) >= 0;
    if (loop && (grains->walls == NULL || walls_choose(grains->walls, wanted)))
        return true;
    return error_set(
        error, ERROR_USER, "%s: simd: %s is not what this program and CPU have; the widest is %s",
        scene_place(context->scene, "simd", place, sizeof place), wanted, walk_level_name(walk_level(NULL)));
}
