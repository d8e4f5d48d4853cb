/* Inside of scene/: what happens to a scene between reading and use. */
#ifndef SCREE_SCENE_FINISH_H
#define SCREE_SCENE_FINISH_H

#include "scene/scene.h"
#include "scene/tree.h"

/* Before reading: what is there without being named (the group "free"). */
void finish_prepare(struct scene *scene);

/* Before the tree `root` is read, as a name that stands twice makes all that refers to it unclear: the names
 * of materials, walls, groups and regions of observables, each list for itself, differ. Fails (user) with the
 * lines of both. */
bool finish_names(const struct scene *scene, const struct tree_node *root, struct error *error);

/* After reading: derived values. Fails (user) where a value that is needed is missing, or a file with the box
 * cannot be read. */
bool finish_scene(struct scene *scene, struct error *error);

/* Combinations that cannot be. Fails (user) on the first. */
bool scene_check(const struct scene *scene, struct error *error);

/* Of these, walls that a periodic box would cut, and their motions. */
bool scene_check_walls(const struct scene *scene, struct error *error);

/* True if the scene itself gives `key` in a section ("box"), be it its default. */
bool scene_gives(const struct scene *scene, const char *section, const char *key);

/* Fills `error` with "PLACE: KEY: TEXT"; returns false. */
bool finish_fail(const struct scene *scene, struct error *error, const char *key, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

#endif
