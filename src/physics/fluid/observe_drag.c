/* SPDX-License-Identifier: BSD-3-Clause */
/* The force of the fluid on a wall or a group of grains. Read observe_flow.h and surface_loads.h first. */
#include "physics/fluid/coupling/rigid_sums.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include "physics/fluid/observe_flow.h"
#include "physics/fluid/fluid_state.h"
#include "physics/fluid/fluid_fields.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include <math.h>

/* Adds a foot's share: force, viscous part, pressure part, and the torque with a lever. */
static void add_foot(const struct surface_forces_part *foot, const double lever[3], double *part) {
    double torque[3];
    surface_forces_torque(foot, lever, torque);
    for (int d = 0; d < 3; d++) {
        part[d] += foot->viscous[d] + foot->pressure[d];
        part[3 + d] += foot->viscous[d];
        part[6 + d] += foot->pressure[d];
        part[9 + d] += torque[d];
    }
}

/* The feet of one row on the body of the item. */
static void add_row(const struct observable_context *context, const struct observable_item *item, size_t row,
                    const double centre[3], double *part) {
    const struct fluid *fluid = context->view->own[PHYSICS_fluid];
    const struct particles *p = context->view->particles;
    const uint8_t *group = groups_of(p);
    const struct weights *weights = &fluid->weights;
    for (size_t k = weights->foot_start[row]; k < weights->foot_start[row + 1]; k++) {
        const struct weights_foot *foot = &weights->foot[k];
        size_t grain = fluid->forces.grain[k];
        double lever[3];
        if (item->wall >= 0 ? foot->body != body_of_wall(item->wall)
                            : grain == SIZE_MAX || group == NULL || group[grain] != item->group)
            continue;
        for (int d = 0; d < 3; d++)
            lever[d] = item->wall >= 0 ? p->state[weights->first + row].x[d] -
                                             foot->distance * foot->normal[d] - centre[d]
                                       : p->state[grain].radius * foot->normal[d];
        add_foot(&fluid->forces.part[k], lever, part);
    }
}

/* The grains and bodies of a group in which the flow is rigid: their loads have no parts. */
static void add_rigid(const struct observable_context *context, int group, double *part) {
    const struct particles *p = context->view->particles;
    const uint8_t *groups = groups_of(p);
    const double *drag = fluid_drag(p);
    double(*load)[6] = fluid_load(p);
    for (size_t i = 0; groups != NULL && i < p->owned; i++)
        for (size_t d = 0;
             (kinds_of(p)[i] == KIND_GRAIN || kinds_of(p)[i] == KIND_BODY) && groups[i] == group && d < 3;
             d++) {
            part[d] += drag[3 * i + d];
            part[3 + d] = part[6 + d] = NAN;
            part[9 + d] += isnan(load[i][3 + d]) ? 0 : load[i][3 + d];
        }
}

/* A wall that moves through the fluid: its load, which all ranks know. */
static void add_through(const struct fluid *fluid, const struct rigid_wall *wall, double *part) {
    for (int d = 0; d < 3 && fluid->first; d++) {
        part[d] += wall->load[d];
        part[3 + d] = part[6 + d] = NAN;
        part[9 + d] += wall->load[3 + d];
    }
}

void observe_drag(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct fluid *fluid = context->view->own[PHYSICS_fluid];
    struct wall_pose pose = {0};
    if (fluid == NULL || fluid->forces.part == NULL)
        return;
    if (fluid->rigid != NULL && item->wall < 0)
        add_rigid(context, item->group, part);
    if (fluid->rigid != NULL && item->wall >= 0 && fluid->rigid->walls.wall[item->wall].body) {
        add_through(fluid, &fluid->rigid->walls.wall[item->wall], part);
        return;
    }
    if (item->wall >= 0)
        walls_pose(context->view->walls, item->wall, &pose);
    for (size_t row = 0; row < fluid->weights.rows; row++)
        add_row(context, item, row, pose.centre, part);
}
