/* SPDX-License-Identifier: BSD-3-Clause */
/* The queries of modules to a scene, and messages about it. */
#include "data/scene/scene.h"

#include "base/memory.h"
#include "fields_table.h"
#include "data/scene/scene_shapes.h"
#include "data/scene/tree.h"

#include <stdarg.h>
#include <string.h>

void scene_free(struct scene **scene) {
    if (!*scene)
        return;
    tree_free(&(*scene)->tree);
    memory_free((*scene)->pair);
    memory_free((*scene)->law_pair);
    memory_free((*scene)->wall);
    memory_free((*scene)->source);
    memory_free((*scene)->insertion);
    memory_free((*scene)->deletion);
    scene_shapes_free(&(*scene)->shapes);
    for (int k = 0; k < (*scene)->settings; k++)
        memory_free((*scene)->setting[k]);
    memory_free((*scene)->setting);
    memory_free((*scene)->text);
    memory_free(*scene);
    *scene = NULL;
}

const char *scene_place(const struct scene *scene, const char *key, char *place, size_t room) {
    return tree_place(tree_nearest(scene->tree, key), scene->file, place, room);
}

bool scene_fail(const struct scene *scene, struct error *error, const char *key, const char *format, ...) {
    char place[SCENE_PATH_MAX + 32], text[1024];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof(text), format, list);
    va_end(list);
    scene_place(scene, key, place, sizeof(place));
    return error_set(error, ERROR_USER, "%.700s: %.200s: %s", place, key, text);
}

bool scene_gives(const struct scene *scene, const char *section, const char *key) {
    return tree_get(tree_nearest(scene->tree, section), key) != NULL;
}

void scene_register(const struct scene *scene, const struct law *law, struct particles *particles) {
#define FIELDS_REGISTER(register_fields, needed)                                                             \
    if (needed)                                                                                              \
        register_fields(particles);
    FIELDS_TABLE(FIELDS_REGISTER)
#undef FIELDS_REGISTER
}

void scene_integrator(const struct scene *scene, struct integrator_context *context) {
    *context = (struct integrator_context){.dimension = scene->box.dimension, .groups = scene->groups};
    memcpy(context->gravity, scene->gravity, sizeof(context->gravity));
    for (int g = 0; g < scene->groups; g++) {
        const struct scene_group *group = &scene->group[g];
        context->motion[g].prescribed = group->motion != SCENE_FREE;
        if (group->motion != SCENE_MOVING)
            continue;
        memcpy(context->motion[g].velocity, group->velocity, sizeof(group->velocity));
        memcpy(context->motion[g].omega, group->omega, sizeof(group->omega));
    }
}

/* Each rank then computes its own side of a pair, so that no sums are sent back. */
void scene_make_reproducible(struct scene *scene) {
    scene->reproducible = scene->ghosts.in_place = true;
    scene->ghosts.newton = scene->ghosts.reduced = false;
    scene->ghosts_name = SCENE_GHOSTS_FULL;
}

int scene_material(const struct scene *scene, const char *name) {
    for (int k = 0; k < scene->materials; k++)
        if (strcmp(scene->material[k].name, name) == 0)
            return k;
    return -1;
}

int scene_wall(const struct scene *scene, const char *name) {
    for (int k = 0; k < scene->walls; k++)
        if (strcmp(scene->wall[k].name, name) == 0)
            return k;
    return -1;
}
