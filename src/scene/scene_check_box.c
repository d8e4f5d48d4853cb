/* SPDX-License-Identifier: BSD-3-Clause */
/* Refuses what a box in motion cannot have. Read scene_check_box.h first. */
#include "scene/scene_check_box.h"

/* Sections that a box in motion does not go together with. */
static bool check_alone(const struct scene *scene, const char *key, struct error *error) {
    static const char why[] = "does not go with %s: allowed are free grains alone";
#define CHECK_SECTION(name, key, whose, summary) #key,
    static const char *const section[] = {PHYSICS_TABLE(CHECK_SECTION)};
#undef CHECK_SECTION
    if (scene->walls > 0)
        return scene_fail(scene, error, key, why, "walls");
    if (scene->groups > 1)
        return scene_fail(scene, error, key, why, "groups");
    if (scene->insertions > 0)
        return scene_fail(scene, error, key, why, "insertions");
    for (int k = 0; k < PHYSICS_COUNT; k++)
        if (scene->physics_given[k] && k != PHYSICS_density && k != PHYSICS_heat)
            return scene_fail(scene, error, key, why, section[k]);
    return true;
}

bool scene_check_box(const struct scene *scene, struct error *error) {
    const struct scene_shear *shear = &scene->shear;
    if (!scene->shear_given)
        return true;
    if (shear->flow == shear->gradient)
        return scene_fail(scene, error, "box.shear.gradient", "%c is the direction of the flow, too",
                          "xyz"[shear->flow]);
    for (int d = 0; d < 3; d++)
        if ((d == shear->flow || d == shear->gradient) && !scene->box.periodic[d])
            return scene_fail(scene, error, d == shear->flow ? "box.shear.flow" : "box.shear.gradient",
                              "%c is not periodic; allowed: directions that box.periodic names", "xyz"[d]);
    for (int k = 0; k < scene->sources && shear->offset != 0; k++)
        if (scene->source[k].kind == SOURCE_RANDOM)
            return scene_fail(scene, error, "box.shear.offset",
                              "random sources place their particles at offset 0");
    return check_alone(scene, "box.shear", error);
}
