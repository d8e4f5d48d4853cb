/* SPDX-License-Identifier: BSD-3-Clause */
/* For tests of scene/: a small good scene, and parsing of texts. */
#ifndef SCREE_TESTS_SCENE_BY_HAND_H
#define SCREE_TESTS_SCENE_BY_HAND_H

#include "tests/test.h"

#include "base/memory.h"
#include "data/scene/scene_particles.h"
#include "data/scene/scene_read.h"
#include "tests/fields_by_hand.h"

#include <stdlib.h>
#include <string.h>

/* A scene that is complete; `parts` are appended. Lines: box is line 1, materials line 5, particles line 7.
 */
#define GOOD_SCENE                                                                                           \
    "box: {lower: [0, 0, 0], upper: [10 mm, 10 mm, 20 mm]}\n"                                                \
    "gravity: [0, 0, -9.81]\n"                                                                               \
    "duration: 1 ms\n"                                                                                       \
    "contact: {law: hertz}\n"                                                                                \
    "materials: [{name: glass, density: 2500, young: 70 GPa, poisson: 0.2}]\n"                               \
    "material_pairs: [{restitution: 0.5, friction: 0.3}]\n"                                                  \
    "particles: {from: single, position: [5 mm, 5 mm, 5 mm], radius: 1 mm}\n"

/* Parses with settings (ended by NULL); NULL with an error. */
static inline struct scene *scene_from(struct error *error, const char *text, const char *const *settings) {
    struct scene_setting set[16] = {{NULL}};
    int sets = 0;
    for (; settings && settings[sets]; sets++)
        set[sets].text = settings[sets];
    *error = (struct error){0};
    return scene_parse("case/scene.yaml", text, set, sets, error);
}

/* As scene_from; fails the test with the message if it does not parse. */
static inline struct scene *good_scene(const char *text, const char *const *settings) {
    struct error error;
    struct scene *scene = scene_from(&error, text, settings);
    if (!scene)
        fail_msg("%s", error.text);
    return scene;
}

/* All particles of a scene, on one rank. */
static inline struct particles *scene_all(const struct scene *scene, struct scene_census *census) {
    struct particles *particles = particles_with(WITH_ALL, 0);
    struct scene_share share = {.size = 1};
    struct error error = {0};
    if (!scene_particles(scene, &share, particles, census, &error))
        fail_msg("%s", error.text);
    return particles;
}

/* Writes a text file; fails the test where it cannot. */
static inline void write_file(const char *path, const char *text) {
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

#endif
