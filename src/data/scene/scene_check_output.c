/* SPDX-License-Identifier: BSD-3-Clause */
/* Checks the output and the observables of a scene. Read scene_check.h first. */
#include "data/scene/scene_check.h"

#include <math.h>

static bool check_interval(const struct scene *scene, const struct output_interval *every, const char *key,
                           struct error *error) {
    return every->steps == 0 || every->time == 0 ||
           scene_fail(scene, error, key,
                      "steps and time both; give one of the two, or take the other out with --set KEY=~");
}

/* A grid has three numbers of cells, and a volume. */
static bool check_grid(const struct scene *scene, int number, struct error *error) {
    const struct output_grid *grid = &scene->output.observables.grid[number];
    char key[80];
    snprintf(key, sizeof(key), "observables.grids[%d].every", number);
    if (!check_interval(scene, &grid->every, key, error))
        return false;
    snprintf(key, sizeof(key), "observables.grids[%d].cells", number);
    if (grid->directions != 3)
        return scene_fail(scene, error, key, "has %d numbers; needed: three, of x, y and z",
                          grid->directions);
    if ((double)grid->cells[0] * (double)grid->cells[1] * (double)grid->cells[2] > 1e8)
        return scene_fail(scene, error, key, "asks for more than 100 million cells");
    snprintf(key, sizeof(key), "observables.grids[%d].%s", number, isnan(grid->lower[0]) ? "lower" : "upper");
    if (isnan(grid->lower[0]) != isnan(grid->upper[0]))
        return scene_fail(scene, error, key, "is missing; give both corners, or neither");
    for (int d = 0; d < scene->box.dimension && !isnan(grid->lower[0]); d++)
        if (!(grid->upper[d] > grid->lower[d]))
            return scene_fail(scene, error, key, "%c: %g is not above the lower corner's %g", "xyz"[d],
                              grid -> upper[d], grid -> lower[d]);
    return true;
}

bool scene_check_output(const struct scene *scene, struct error *error) {
    const struct output_options *output = &scene->output;
    if (!check_interval(scene, &output->trajectory.every, "output.trajectory.every", error) ||
        !check_interval(scene, &output->trajectory.contacts, "output.trajectory.contacts", error) ||
        !check_interval(scene, &output->dump.every, "output.dump.every", error) ||
        !check_interval(scene, &output->walls.every, "output.walls.every", error) ||
        !check_interval(scene, &output->contact_problems.every, "output.contact_problems.every", error) ||
        !check_interval(scene, &output->observables.every, "observables.every", error))
        return false;
    if (output_interval_set(&output->walls.every) && scene->walls == 0 && scene->stages == 0)
        return scene_fail(scene, error, "output.walls.every", "the scene has no walls");
    if (output_interval_set(&output->contact_problems.every) && !scene->law.solved)
        return scene_fail(scene, error, "output.contact_problems.every",
                          "needs contact.solver, which solves such problems");
    for (int k = 0; k < output->observables.grids; k++)
        if (!check_grid(scene, k, error))
            return false;
    for (int k = 0; k < output->observables.regions; k++) {
        const struct output_region *region = &output->observables.region[k];
        char key[80];
        snprintf(key, sizeof(key), "observables.regions[%d].upper", k);
        for (int d = 0; region->shape == OUTPUT_REGION_BOX && d < 3; d++)
            if (!(region->upper[d] > region->lower[d]))
                return scene_fail(scene, error, key, "%c: %g is not above the lower corner's %g", "xyz"[d],
                                  region -> upper[d], region -> lower[d]);
        snprintf(key, sizeof(key), "observables.regions[%d].axis", k);
        if (region->shape == OUTPUT_REGION_CYLINDER && region->axis[0] == 0 && region->axis[1] == 0 &&
            region->axis[2] == 0)
            return scene_fail(scene, error, key, "[0, 0, 0] has no direction");
    }
    return true;
}
