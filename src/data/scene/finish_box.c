/* SPDX-License-Identifier: BSD-3-Clause */
/* The box of a scene: as the scene states it, as the file of the first source has it, or around a packing. */
#include "data/scene/finish.h"
#include "data/scene/packed_radii.h"
#include "data/scene/scene_files.h"

#include "data/formats/h5md_read.h"
#include "data/formats/lammps_data.h"

#include <math.h>

/* The cube (square) from the origin in which the spheres of a packed source have the wanted volume fraction. */
static bool box_from_packing(struct scene *scene, struct error *error) {
    struct source_options *source = scene->source;
    double edge = packed_edge(scene, 0, error);
    for (int d = 0; d < 3; d++) {
        scene->box_lower[d] = 0;
        scene->box_upper[d] = d < scene->box.dimension ? edge : 0;
    }
    source->volume_fraction = 0; /* the box has it now */
    return edge > 0;
}

/* The box of the first source's file; the periodic directions of the scene stay. */
static bool box_from_file(struct scene *scene, struct error *error) {
    const struct source_options *source = scene->source;
    if (scene->sources > 0 && source->kind == SOURCE_PACKED && source->count > 0 &&
        source->volume_fraction > 0 && source->region.shape == REGION_ALL)
        return box_from_packing(scene, error);
    if (scene->sources == 0 || source->kind != SOURCE_FILE || source->format == SOURCE_TABLE)
        return scene_fail(scene, error, "box.lower", "is missing; needed: three numbers [x, y, z], in m");
    if (!scene_files_open(scene, error))
        return false;
    struct rows rows = {0};
    struct h5md_read_options options = {.frame = source->frame};
    if (source->format == SOURCE_LAMMPS_DATA ? !lammps_data_read(source->file, &rows, error)
                                             : !h5md_read(source->file, &options, NULL, &rows, error))
        return false;
    bool good = rows.box_given ||
                scene_fail(scene, error, "box.lower", "is missing, and %s has no box", source->file);
    bool take_periodic = rows.periodic_given && !scene_gives(scene, "box", "periodic");
    for (int d = 0; good && d < 3; d++) {
        scene->box_lower[d] = rows.lower[d] * source->scale + source->offset[d];
        scene->box_upper[d] = rows.upper[d] * source->scale + source->offset[d];
        if (take_periodic)
            scene->box.periodic[d] = rows.periodic[d];
    }
    rows_free(&rows);
    return good;
}

bool finish_box(struct scene *scene, struct error *error) {
    bool lower = !isnan(scene->box_lower[0]), upper = !isnan(scene->box_upper[0]);
    if (lower != upper)
        return scene_fail(
            scene, error, lower ? "box.upper" : "box.lower",
            "is missing beside box.%s; needed: three numbers [x, y, z], in m (or neither, where "
            "the first particle file has a box)",
            lower ? "lower" : "upper");
    if (!lower && !box_from_file(scene, error))
        return false;
    struct box *box = &scene->box;
    if (box->dimension == 2 && scene->box_lower[2] == scene->box_upper[2]) {
        double thickness =
            fmin(scene->box_upper[0] - scene->box_lower[0], scene->box_upper[1] - scene->box_lower[1]);
        scene->box_lower[2] -= thickness / 2;
        scene->box_upper[2] += thickness / 2;
    }
    for (int d = 0; d < 3; d++) {
        double low = scene->box_lower[d], high = scene->box_upper[d];
        if (!(high > low))
            return scene_fail(scene, error, "box.upper", "%c: %g is not above the lower corner's %g",
                              "xyz"[d], high, low);
        box->origin[d] = low;
        box->edge[d] = high - low;
        for (int side = 0; side < 2; side++) {
            int leave = scene->leave_side[d][side] >= 0 ? scene->leave_side[d][side] : scene->leave_all;
            box->leave[d][side] = (enum box_leave)leave;
        }
    }
    return true;
}
