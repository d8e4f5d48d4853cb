/* SPDX-License-Identifier: BSD-3-Clause */
/* From text to a scene and back. */
#ifndef SCREE_SCENE_SCENE_READ_H
#define SCREE_SCENE_SCENE_READ_H

#include "data/scene/scene.h"

/* One --set KEY=VALUE of the command line. */
struct scene_setting {
    const char *text; /* "walls[0].radius=0.2"; "step.fraction=~" takes the key out */
};

/* Parses and checks a scene. `file` names the text in messages and gives the folder that relative paths start
 * from; `set` has `sets` overrides, applied in order. Every rank gives the same arguments. Opens the particle
 * file where the box comes from it. Reads the scenes of all stages, too, for their mistakes. Returns the scene, to be freed by scene_free, or NULL with a user's
 * error. One thread. */
struct scene *scene_parse(const char *file, const char *text, const struct scene_setting *set, int sets,
                          struct error *error);

/* The scene of stage `number` of a scene that was read: its text and settings again, then the keys that the stages up
 * to this one set. Returned as by scene_parse; the error names the stage. One thread. */
struct scene *scene_stage(const struct scene *scene, int number, struct error *error);

/* Writes the effective scene as YAML: every key that applies with its value, in base units; parsing it gives
 * the same scene. Returned as allocated text (memory_free). */
char *scene_echo(const struct scene *scene);

#endif
