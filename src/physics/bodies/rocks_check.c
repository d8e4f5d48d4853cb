/* SPDX-License-Identifier: BSD-3-Clause */
/* What rocks do not go with, each with one message. Read rocks.h first. */
#include "physics/bodies/rocks.h"
#include "physics/grains/grains.h"
#include <stdio.h>

/* Laws that know spheres alone. */
static bool check_law(const struct physics_context *context, struct error *error) {
    const struct scene *scene = context->scene;
    const struct law *law = &grains_of(context->set)->law;
    if (law->general) {
        char title[LAW_TITLE_MAX];
        law_title(&law->options, title);
        return scene_fail(
            scene, error, "bodies.shapes",
            "the contact law (%s) is for spheres; allowed with rocks are laws without cohesion, "
            "plasticity, branches and twisting",
            title);
    }
    if (law->options.lammps_history || law->options.lammps_granular)
        return scene_fail(scene, error, "bodies.shapes",
                          "a law to the letter of LAMMPS is for spheres: not with rocks");
    return true;
}

bool rocks_check(const struct physics_context *context, struct error *error) {
    const struct bodies_options *options = context->options;
    const struct scene *scene = context->scene;
    if (options->rocks == 0)
        return true;
    if (scene->physics_given[PHYSICS_heat])
        return scene_fail(scene, error, "bodies.shapes", "together with heat: not built yet");
    if (output_interval_set(&scene->output.trajectory.contacts) && !scene->law.solved)
        return scene_fail(scene, error, "output.trajectory.contacts",
                          "without contact.solver the list of contacts knows none of rocks (bodies.shapes): "
                          "not built yet");
    if (output_interval_set(&scene->output.walls.every))
        return scene_fail(scene, error, "output.walls",
                          "the loads on walls know none of rocks (bodies.shapes): not built yet");
    for (int w = 0; w < scene->walls; w++)
        if (scene->wall[w].shape == WALL_MESH && scene->wall[w].field) {
            char key[64];
            snprintf(key, sizeof key, "walls[%d].field", w);
            return scene_fail(
                scene, error, key,
                "rocks (bodies.shapes) feel edges of a wall, which a field does not have; allowed: false");
        }
    return check_law(context, error);
}
