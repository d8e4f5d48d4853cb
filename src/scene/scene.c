#include "scene/scene.h"

#include "contact/material.h"
#include "contact/spin.h"
#include "core/memory.h"
#include "integrate/groups.h"
#include "scene/finish.h"
#include "scene/schema.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

struct tree {
    struct tree_node *root;
};

/* What zlib says of a file. */
static const char *reading_error(gzFile file) {
    int status = Z_OK;
    const char *why = gzerror(file, &status);
    return status == Z_OK ? NULL : status == Z_ERRNO ? strerror(errno) : why;
}

bool scene_read_text(const char *path, char **text, size_t *length, struct error *error) {
    *text = NULL;
    gzFile file = gzopen(path, "rb");
    if (!file)
        return error_set(error, ERROR_USER, "%s: cannot be read: %s", path, strerror(errno));
    enum { PART = 65536 };
    size_t have = 0, room = PART + 1;
    char *data = memory_allocate(room, 1, "scene text");
    int got;
    while ((got = gzread(file, data + have, PART)) > 0) {
        have += (size_t)got;
        if (room - have <= PART)
            data = memory_resize(data, room *= 2, 1, "scene text");
    }
    const char *why = reading_error(file);
    bool good = why == NULL || error_set(error, ERROR_USER, "%s: cannot be read: %s", path, why);
    gzclose(file);
    if (good && memchr(data, '\0', have))
        good = error_set(error, ERROR_USER, "%s: not a text file", path);
    if (!good) {
        memory_free(data);
        return false;
    }
    data[have] = '\0';
    *text = data;
    if (length)
        *length = have;
    return true;
}

/* The folder of a path, with its slash; "" where there is none. */
static void set_folder(struct scene *scene, const char *file) {
    snprintf(scene->file, sizeof(scene->file), "%s", file);
    const char *slash = strrchr(file, '/');
    snprintf(scene->folder, sizeof(scene->folder), "%.*s", slash ? (int)(slash - file) + 1 : 0, file);
}

static bool read_scene(struct scene *scene, const char *text, const struct scene_setting *set, int sets,
                       struct error *error) {
    struct schema_reader reader = {.file = scene->file,
                                   .folder = scene->folder,
                                   .root = (char *)scene,
                                   .units = true,
                                   .dimension = &scene->box.dimension,
                                   .note = scene->note,
                                   .error = error};
    scene->tree->root = tree_parse(scene->file, text, 1, error);
    if (!scene->tree->root || !schema_normalise(&reader, scene->tree->root))
        return false;
    for (int k = 0; k < sets; k++)
        if (!schema_set(&reader, scene->tree->root, set[k].text))
            return false;
    const struct tree_node *units = tree_nearest(scene->tree->root, "units");
    reader.units = !(units->kind == TREE_SCALAR && strcmp(units->text, "none") == 0);
    return finish_names(scene, scene->tree->root, error) && schema_read(&reader, scene->tree->root);
}

struct scene *scene_parse(const char *file, const char *text, const struct scene_setting *set, int sets,
                          struct error *error) {
    struct scene *scene = memory_allocate_zero(1, sizeof(*scene), "scene");
    scene->tree = memory_allocate_zero(1, sizeof(*scene->tree), "scene");
    set_folder(scene, file);
    finish_prepare(scene);
    if (!read_scene(scene, text, set, sets, error) || !finish_scene(scene, error) ||
        !scene_check(scene, error))
        scene_free(&scene);
    return scene;
}

void scene_free(struct scene **scene) {
    if (!*scene)
        return;
    tree_free(&(*scene)->tree->root);
    memory_free((*scene)->tree);
    memory_free(*scene);
    *scene = NULL;
}

char *scene_echo(const struct scene *scene) {
    char *text = NULL, working[SCENE_PATH_MAX + 1] = "";
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        error_fatal("out of memory while writing the scene");
    if (getcwd(working, sizeof(working) - 1))
        strcat(working, "/");
    schema_write(out, scene, working);
    fclose(out);
    char *copy = memory_allocate(size + 1, 1, "scene text");
    memcpy(copy, text, size + 1);
    free(text);
    return copy;
}

const char *scene_place(const struct scene *scene, const char *key, char *place, size_t room) {
    return tree_place(tree_nearest(scene->tree->root, key), scene->file, place, room);
}

bool scene_gives(const struct scene *scene, const char *section, const char *key) {
    return tree_get(tree_nearest(scene->tree->root, section), key) != NULL;
}

void scene_register(const struct scene *scene, const struct law *law, struct particles *particles) {
    if (law->spin)
        spin_register(particles);
    if (scene->materials > 1)
        material_register(particles);
    if (scene->groups > 1)
        groups_register(particles);
    if (scene->box.periodic[0] || scene->box.periodic[1] || scene->box.periodic[2])
        particles_count_images(particles);
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

static int find_name(const struct scene *scene, const char *target, const char *name) {
    const char *known;
    for (int k = 0; (known = schema_target_name((const char *)scene, target, k)); k++)
        if (strcmp(known, name) == 0)
            return k;
    return -1;
}

int scene_material(const struct scene *scene, const char *name) {
    return find_name(scene, "materials", name);
}

int scene_wall(const struct scene *scene, const char *name) {
    return find_name(scene, "walls", name);
}
