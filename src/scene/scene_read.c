/* SPDX-License-Identifier: BSD-3-Clause */
/* Text to scene: the tree, the schema, then derived values and checks. Read scene.h first. */
#include "scene/scene_read.h"

#include "core/memory.h"
#include "scene/finish.h"
#include "scene/scene_check.h"
#include "scene/schema_normalise.h"
#include "scene/schema_read.h"
#include "scene/schema_write.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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
    scene->tree = tree_parse(scene->file, text, 1, error);
    if (!scene->tree || !schema_normalise(&reader, scene->tree))
        return false;
    for (int k = 0; k < sets; k++)
        if (!schema_set(&reader, scene->tree, set[k].text))
            return false;
    const struct tree_node *units = tree_nearest(scene->tree, "units");
    reader.units = !(units->kind == TREE_SCALAR && strcmp(units->text, "none") == 0);
    reader.doubtful = !finish_names(scene, scene->tree, error);
    return schema_read(&reader, scene->tree) && error->kind == ERROR_NONE;
}

struct scene *scene_parse(const char *file, const char *text, const struct scene_setting *set, int sets,
                          struct error *error) {
    struct scene *scene = memory_allocate_zero(1, sizeof(*scene), "scene");
    set_folder(scene, file);
    finish_prepare(scene);
    if (!read_scene(scene, text, set, sets, error) || !finish_scene(scene, error) ||
        !scene_check(scene, error))
        scene_free(&scene);
    return scene;
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
