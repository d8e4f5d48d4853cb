/* SPDX-License-Identifier: BSD-3-Clause */
/* Text to scene: the tree, the schema, then derived values and checks. Read scene.h first. */
#include "data/scene/scene_read.h"

#include "base/memory.h"
#include "data/scene/finish.h"
#include "data/scene/scene_check.h"
#include "data/scene/scene_files.h"
#include "data/scene/scene_stage.h"
#include "data/scene/schema_normalise.h"
#include "data/scene/schema_read.h"
#include "data/scene/schema_output.h"
#include "data/scene/tree.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What a scene is read from, beside the settings. */
struct scene_text {
    const char *text;
    int settings; /* their number */
    int stage;    /* whose keys are put, with those of the stages before; 0: none */
};

/* The folder of a path, with its slash; "" where there is none. */
static void set_folder(struct scene *scene, const char *file) {
    snprintf(scene->file, sizeof(scene->file), "%s", file);
    const char *slash = strrchr(file, '/');
    snprintf(scene->folder, sizeof(scene->folder), "%.*s", slash ? (int)(slash - file) + 1 : 0, file);
}

/* Puts the keys of a stage into the tree. */
static bool put_stage(struct schema_reader *reader, struct tree_node *root, int number) {
    const struct tree_node *keys = scene_stage_keys(root, number);
    struct tree_node *own = keys ? tree_copy(keys) : NULL; /* the tree changes */
    bool good = true;
    for (size_t k = 0; own && k < own->children && good; k++)
        good = schema_put(reader, root, own->key[k], tree_copy(own->child[k]));
    tree_free(&own);
    return good;
}

static bool read_scene(struct scene *scene, const struct scene_setting *set, const struct scene_text *text,
                       struct error *error) {
    struct schema_reader reader = {.file = scene->file,
                                   .folder = scene->folder,
                                   .root = (char *)scene,
                                   .units = true,
                                   .dimension = &scene->box.dimension,
                                   .note = scene->note,
                                   .error = error};
    scene->tree = tree_parse(scene->file, text->text, 1, error);
    if (!scene->tree || !schema_normalise(&reader, scene->tree))
        return false;
    for (int k = 0; k < text->settings; k++)
        if (!schema_set(&reader, scene->tree, set[k].text))
            return false;
    for (int k = 1; k <= text->stage; k++)
        if (!put_stage(&reader, scene->tree, k))
            return false;
    const struct tree_node *units = tree_nearest(scene->tree, "units");
    reader.units = !(units->kind == TREE_SCALAR && strcmp(units->text, "none") == 0);
    reader.doubtful = !finish_names(scene, scene->tree, error);
    return schema_read(&reader, scene->tree) && error->kind == ERROR_NONE;
}

static struct scene *parse(const char *file, const struct scene_setting *set, const struct scene_text *text,
                           struct error *error) {
    struct scene *scene = memory_allocate_zero(1, sizeof(*scene), "scene");
    set_folder(scene, file);
    finish_prepare(scene);
    if (!read_scene(scene, set, text, error) || !finish_scene(scene, error) || !scene_check(scene, error))
        scene_free(&scene);
    return scene;
}

/* Keeps what the scenes of later stages are read from. */
static void keep_text(struct scene *scene, const char *text, const struct scene_setting *set, int sets) {
    scene->text = tree_text(text, strlen(text));
    scene->setting = memory_allocate_zero((size_t)sets, sizeof(*scene->setting), "scene");
    for (scene->settings = 0; scene->settings < sets; scene->settings++)
        scene->setting[scene->settings] =
            tree_text(set[scene->settings].text, strlen(set[scene->settings].text));
}

struct scene *scene_stage(const struct scene *scene, int number, struct error *error) {
    struct error plain = {0};
    struct scene_text text = {.text = scene->text, .settings = scene->settings, .stage = number};
    struct scene_setting *set =
        memory_allocate_zero((size_t)scene->settings, sizeof(*set), "settings of a scene");
    for (int k = 0; k < scene->settings; k++)
        set[k].text = scene->setting[k];
    struct scene *stage = parse(scene->file, set, &text, &plain);
    if (stage)
        keep_text(stage, scene->text, set, scene->settings);
    memory_free(set);
    if (!stage)
        error_set(error, plain.kind, "%.1800s (in stage '%s', stages[%d].set)", plain.text,
                  scene->stage[number].name, number);
    return stage;
}

/* Reads the scenes of all stages and compares each with the one before. */
static bool stages_suit(const struct scene *scene, struct error *error) {
    const struct scene *before = scene;
    struct scene *stage[STAGES_MAX] = {NULL};
    for (int k = 1; k < scene->stages && error->kind == ERROR_NONE; k++) {
        stage[k] = scene_stage(scene, k, error);
        if (stage[k] && scene_stage_check(before, stage[k], k, error))
            scene_files_open(stage[k], error);
        before = stage[k];
    }
    for (int k = 1; k < scene->stages; k++)
        scene_free(&stage[k]);
    return error->kind == ERROR_NONE;
}

struct scene *scene_parse(const char *file, const char *text, const struct scene_setting *set, int sets,
                          struct error *error) {
    struct scene *scene = parse(file, set, &(struct scene_text){.text = text, .settings = sets}, error);
    if (scene && scene->stages > 0) {
        keep_text(scene, text, set, sets);
        if (!stages_suit(scene, error))
            scene_free(&scene);
    }
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
