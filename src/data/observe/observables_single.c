/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables of one wall, one particle, one region. */
#include "data/observe/observables_kinds.h"
#include "base/vector.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"

#include <math.h>
#include <string.h>

static void force_on_wall(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    memcpy(part, context->wall_force[item->wall], 3 * sizeof *part);
}

static void torque_on_wall(const struct observable_context *context, struct observable_item *item,
                           double *part) {
    memcpy(part, context->wall_force[item->wall] + 3, 3 * sizeof *part);
}

/* Every rank knows the poses: rank 0 gives them. */
static void wall_offset(const struct observable_context *context, struct observable_item *item,
                        double *part) {
    if (context->view->comm->rank == 0)
        walls_offset(context->view->walls, item->wall, part);
}

static void wall_velocity(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    double omega[3];
    if (context->view->comm->rank == 0)
        walls_velocity(context->view->walls, item->wall, part, omega);
}

static void wall_spin(const struct observable_context *context, struct observable_item *item, double *part) {
    double velocity[3];
    if (context->view->comm->rank == 0)
        walls_velocity(context->view->walls, item->wall, velocity, part);
}

static void wall_rotation(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    if (context->view->comm->rank == 0)
        walls_rotation(context->view->walls, item->wall, part);
}

/* Finds the number of the item's particle on this rank; false if the particle is not here. Searches only
 * after the particles were renumbered. */
static bool find_particle(const struct observable_context *context, struct observable_item *item) {
    const struct particles *p = context->view->particles;
    bool known = item->revision == p->revision + 1 &&
                 (item->number == SIZE_MAX || (item->number < p->owned && p->id[item->number] == item->id));
    if (!known) {
        item->number = SIZE_MAX;
        for (size_t i = 0; i < p->owned && item->number == SIZE_MAX; i++)
            if (p->id[i] == item->id)
                item->number = i;
        item->revision = p->revision + 1;
    }
    return item->number != SIZE_MAX;
}

static void position_of_one(const struct observable_context *context, struct observable_item *item,
                            double *part) {
    if (!find_particle(context, item))
        return;
    part[3] = 1;
    observables_place(context->view, item->number, part);
}

static void velocity_of_one(const struct observable_context *context, struct observable_item *item,
                            double *part) {
    if (!find_particle(context, item))
        return;
    part[3] = 1;
    observables_velocity(context->view, item->number, part, NULL);
}

static void spin_of_one(const struct observable_context *context, struct observable_item *item,
                        double *part) {
    double v[3];
    if (!find_particle(context, item))
        return;
    part[3] = 1;
    if (spin_of(context->view->particles))
        integrator_full_step(context->view->particles, context->view->motion, item->number, v, part);
}

static void force_on_one(const struct observable_context *context, struct observable_item *item,
                         double *part) {
    const struct particles *p = context->view->particles;
    if (!find_particle(context, item))
        return;
    part[3] = 1;
    memcpy(part, p->force + item->number * (size_t)p->force_stride, 3 * sizeof *part);
}

/* A particle that is not there (deleted) has no values. */
static void finish_one(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)view, (void)item;
    for (int d = 0; d < 3; d++)
        part[d] = part[3] > 0 ? part[d] : NAN;
}

void observables_place(const struct output_view *view, size_t i, double x[3]) {
    memcpy(x, view->particles->state[i].x, 3 * sizeof *x);
    box_wrap(view->box, x, NULL);
    for (int d = 0; d < 3; d++)
        x[d] += view->box->origin[d];
}

void observables_velocity(const struct output_view *view, size_t i, double velocity[3], double omega[3]) {
    double x[3];
    integrator_full_step(view->particles, view->motion, i, velocity, omega);
    memcpy(x, view->particles->state[i].x, sizeof x);
    if (view->box->motion.moves)
        box_wrap(view->box, x, velocity);
}

void observables_velocity_of_body(const struct output_view *view, size_t i, double velocity[3]) {
    const struct carried *carried = view->motion->carried;
    double x[3];
    if (!carried || carried->pose_of[i] < 0) {
        observables_velocity(view, i, velocity, NULL);
        return;
    }
    const struct carried_pose *pose = &carried->pose[carried->pose_of[i]];
    memcpy(velocity, pose->full_v, 3 * sizeof *velocity);
    memcpy(x, pose->x, sizeof x);
    if (view->box->motion.moves)
        box_wrap(view->box, x, velocity);
}

bool observables_region_contains(const struct output_region *region, const double x[3]) {
    if (region->shape == OUTPUT_REGION_BOX) {
        bool inside = true;
        for (int d = 0; d < 3; d++)
            inside = inside && x[d] >= region->lower[d] && x[d] < region->upper[d];
        return inside;
    }
    double out[3], along = 0;
    for (int d = 0; d < 3; d++)
        out[d] = x[d] - region->centre[d];
    if (region->shape == OUTPUT_REGION_CYLINDER) {
        double length = sqrt(vector_dot(region->axis, region->axis));
        along = vector_dot(out, region->axis) / length;
        for (int d = 0; d < 3; d++)
            out[d] -= along * region->axis[d] / length;
        if (region->length > 0 && (along < -region->length / 2 || along >= region->length / 2))
            return false;
    }
    return vector_dot(out, out) < region->radius * region->radius;
}

bool observables_item_counts(const struct output_view *view, const struct observable_item *item, size_t i) {
    if (item->region == NULL)
        return true;
    if (item->material >= 0 && material_of(material_numbers(view->particles), i) != item->material)
        return false;
    double x[3];
    observables_place(view, i, x);
    return observables_region_contains(item->region, x);
}

static void count_in_region(const struct output_view *view, const struct observable_item *item, size_t i,
                            double *part) {
    part[0] += observables_item_counts(view, item, i);
}

static void volume_in_region(const struct output_view *view, const struct observable_item *item, size_t i,
                             double *part) {
    if (observables_item_counts(view, item, i))
        part[0] += particles_sphere_mass(observables_solid_radius(view, i), 1);
}

#define OF(target, name, family, unit, components, help)                                                     \
    { name, family, unit, help, OBSERVABLE_OF_##target, components, NULL }

/* A vector of a wall; a vector of a particle, with a fourth part that counts the particle. */
#define WALL_ROW(name, family, unit, letter, function, help)                                                 \
    { .info = OF(WALL, name, family, unit, 3, help), .symbol = letter, .parts = 3, .of_rank = function }
#define PARTICLE_ROW(name, unit, letter, function, help)                                                     \
    {                                                                                                        \
        .info = OF(PARTICLE, name, "", unit, 3, help), .symbol = letter, .parts = 4, .of_rank = function,    \
        .finish = finish_one                                                                                 \
    }

static const struct observable_kind kinds[] = {
    WALL_ROW("wall_force", "wall", "N", "f", force_on_wall,
             "force of the particles on a wall, and of walls that touch it"),
    WALL_ROW("wall_torque", "wall", "N m", "t", torque_on_wall,
             "torque of the particles on a wall about its centre, and of walls that touch it"),
    WALL_ROW("wall_offset", "", "m", "", wall_offset,
             "displacement of a wall's centre from its place at rest"),
    WALL_ROW("wall_velocity", "", "m/s", "v", wall_velocity, "velocity of a wall's centre"),
    WALL_ROW("wall_rotation", "", "rad", "phi", wall_rotation,
             "rotation vector of a wall from its pose at rest, up to half a turn; of a wall that is free "
             "about an axis the "
             "angle, with all turns"),
    WALL_ROW("wall_angular_velocity", "", "rad/s", "w", wall_spin, "angular velocity of a wall"),
    PARTICLE_ROW("position", "m", "", position_of_one, "position of one particle"),
    PARTICLE_ROW("velocity", "m/s", "v", velocity_of_one, "velocity of one particle"),
    PARTICLE_ROW("angular_velocity", "rad/s", "w", spin_of_one, "angular velocity of one particle"),
    PARTICLE_ROW("force", "N", "f", force_on_one, "force of contacts and walls on one particle"),
    {.info =
         OF(REGION, "count", "", "1", 1, "number of particles in a region; those of a fluid do not count"),
     .parts = 1,
     .of_particle = count_in_region},
    {.info = OF(REGION, "solid_volume", "", "m3", 1,
                "volume of the particles whose centres are in a region; of bodies their own"),
     .parts = 1,
     .of_particle = volume_in_region},
};

#undef PARTICLE_ROW
#undef WALL_ROW
#undef OF

int observables_single_count(void) {
    return sizeof kinds / sizeof kinds[0];
}

const struct observable_kind *observables_single(int k) {
    return &kinds[k];
}
