/* SPDX-License-Identifier: BSD-3-Clause */
/* Areas of walls, on which a pressure acts. Read wall_area.h first. */
#include "physics/grains/walls/wall_area.h"
#include "physics/grains/walls/wall_mesh.h"

/* Of a plane across an edge of the box: the section of the box. */
static double plane_area(const struct wall *wall, const struct box *box) {
    const double axis[3] = {fabs(wall->axis.x), fabs(wall->axis.y), fabs(wall->axis.z)};
    double area = 1.0;
    bool across = false;
    for (int d = 0; d < box->dimension; d++) {
        across = across || axis[d] == 1.0;
        area *= axis[d] == 1.0 ? 1.0 : box->edge[d];
    }
    return across ? area : 0.0;
}

/* The sum of the areas of the triangles as seen along `direction`; half of it if each side has its back. */
static double mesh_area(const struct wall_mesh *mesh, struct law_vector direction) {
    double area = 0.0;
    for (size_t t = 0; t < mesh->triangles; t++) {
        const struct law_vector *corner = mesh->triangle[t].corner;
        struct law_vector across =
            law_cross(law_add(corner[1], -1.0, corner[0]), law_add(corner[2], -1.0, corner[0]));
        area += 0.5 * fabs(law_dot(across, direction));
    }
    return wall_mesh_open_edges(mesh, false) == 0 ? 0.5 * area : area;
}

double walls_area(const struct walls *walls, int wall, const double direction[3]) {
    const struct wall *w = &walls->wall[wall];
    struct law_vector along = wall_vector(direction);
    along = law_scale(1.0 / sqrt(law_dot(along, along)), along);
    if (w->options.shape == WALL_PLANE)
        return plane_area(w, &walls->box) * fabs(law_dot(w->axis, along));
    return w->mesh && walls->box.dimension == 3 ? mesh_area(w->mesh, along) : 0.0;
}

size_t walls_open_edges(const struct walls *walls, int wall) {
    const struct wall_mesh *mesh = walls->wall[wall].mesh;
    return mesh ? wall_mesh_open_edges(mesh, true) : 0;
}

bool wall_area_targets(struct walls *walls, int wall, struct error *error) {
    struct wall_options *options = &walls->wall[wall].options;
    for (int k = 0; k < options->motions; k++) {
        struct wall_motion *motion = &options->motion[k];
        if (motion->kind != WALL_SERVO || !(motion->pressure > 0.0))
            continue;
        if (!(motion->area > 0.0))
            motion->area = walls_area(walls, wall, motion->direction);
        if (!(motion->area > 0.0 && isfinite(motion->area)))
            return error_set(
                error, ERROR_USER,
                "wall '%s': no area across the direction of motion %d follows from its shape, on "
                "which the pressure would act; give the servo its `area`, or a force",
                options->name, k + 1);
        motion->force = motion->pressure * motion->area;
    }
    return true;
}
