/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls that move through a fluid. Read rigid_walls.h first. */
#include "physics/fluid/coupling/rigid_walls.h"
#include "base/memory.h"
#include "base/vector.h"
#include "physics/grains/grains.h"
#include "physics/grains/walls/wall.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* True of a shape whose solid may have an end in each direction. */
static bool may_end(const struct wall_options *wall) {
    return wall_shape_meshed(wall->shape) || (wall->shape == WALL_CYLINDER && !wall->inside);
}

/* True if two directions differ by their sign and length alone. A direction of no length is along each. */
static bool along(const double a[3], const double b[3]) {
    double across[3];
    vector_cross(a, b, across);
    return vector_dot(across, across) <= 1e-18 * vector_dot(a, a) * vector_dot(b, b);
}

/* True if a motion leaves the solid of a cylinder where it is. */
static bool stays(const struct wall_options *wall, const struct wall_motion *motion) {
    double from[3];
    if (motion->surface)
        return true;
    if (wall->shape != WALL_CYLINDER)
        return false;
    for (int d = 0; d < 3; d++)
        from[d] = motion->point[d] - wall->point[d];
    switch (motion->kind) {
    case WALL_TRANSLATE:
        return wall->length == 0 && along(motion->velocity, wall->axis);
    case WALL_OSCILLATE:
        return wall->length == 0 && along(motion->direction, wall->axis);
    case WALL_ROTATE:
    case WALL_OSCILLATE_ROTATION:
        return along(motion->direction, wall->axis) && along(from, wall->axis);
    default:
        return false;
    }
}

bool rigid_walls_through(const struct physics_context *context, const struct wall_options *wall) {
    bool moves = context->box->dimension == 2 && wall_shape_meshed(wall->shape);
    for (int k = 0; k < wall->motions; k++)
        moves = moves || !stays(wall, &wall->motion[k]);
    return fluid_rigid(context->options) && !wall->permeable && may_end(wall) && moves;
}

bool rigid_walls_bounds(const struct physics_context *context, const struct wall_options *wall) {
    return !wall->permeable && !rigid_walls_through(context, wall);
}

/* True if a plane's section stands for a wall: its sides stand upright on the plane z of the user, and what does not is farther from it than `reach`. */
static bool is_upright(const struct walls *all, int wall, double z, double reach) {
    double(*triangle)[9];
    size_t count = walls_triangles(all, wall, &triangle), poor = 0;
    for (size_t t = 0; t < count; t++) {
        const double *c = triangle[t], nearest = fmin(fabs(c[2] - z), fmin(fabs(c[5] - z), fabs(c[8] - z)));
        double a[3], b[3], normal[3];
        bool across = (c[2] - z) * (c[5] - z) <= 0 || (c[2] - z) * (c[8] - z) <= 0;
        vector_minus(c + 3, c, a);
        vector_minus(c + 6, c, b);
        vector_cross(a, b, normal);
        bool upright = fabs(normal[2]) <= 1e-9 * sqrt(vector_dot(normal, normal));
        poor += !upright && (across || nearest <= reach);
    }
    memory_free(triangle);
    return poor == 0;
}

static bool refuse_servo(const struct physics_context *context, int wall, int motion, struct error *error) {
    char key[64];
    snprintf(key, sizeof key, "walls[%d].motion[%d]", wall, motion);
    return scene_fail(context->scene, error, key,
                      "the servo of wall '%s' follows the force of grains, not that of the fluid around it; "
                      "allowed: given motions",
                      context->scene->wall[wall].name);
}

bool rigid_walls_suit(const struct physics_context *context, int wall, struct error *error) {
    const struct fluid_options *options = context->options;
    const struct box *box = context->box;
    const struct wall_options *shape = &context->scene->wall[wall];
    const double plane = box->origin[2] + 0.5 * box->edge[2];
    char key[64];
    snprintf(key, sizeof key, "walls[%d].%s", wall, shape->shape == WALL_MESH ? "file" : "shape");
    if (!rigid_walls_through(context, shape))
        return true;
    for (int k = 0; k < shape->motions; k++)
        if (shape->motion[k].kind == WALL_SERVO)
            return refuse_servo(context, wall, k, error);
    if (!walls_bounded(grains_walls(context), wall))
        return scene_fail(
            context->scene, error, key,
            "wall '%s' is a solid in the fluid, and its normals point into it; allowed: a closed mesh whose "
            "normals point to the fluid all around",
            shape->name);
    return box->dimension == 3 || !wall_shape_meshed(shape->shape) ||
           is_upright(grains_walls(context), wall, plane, SOLID_EDGE * options->spacing) ||
           scene_fail(context->scene, error, key,
                      "wall '%s' has sides that lean, or ends within %g of the plane z = %g of the flow; "
                      "allowed in two "
                      "dimensions: sides at right angles to the plane, and ends farther away",
                      shape->name, SOLID_EDGE * options->spacing, plane);
}

void rigid_walls_create(struct rigid_walls *walls, const struct scene *scene) {
    walls->count = scene->walls;
    walls->wall = memory_allocate_zero((size_t)scene->walls, sizeof *walls->wall, "walls in a fluid");
}

void rigid_walls_free(struct rigid_walls *walls) {
    memory_free(walls->wall);
    memory_free(walls->part);
    *walls = (struct rigid_walls){0};
}

void rigid_walls_restart(struct rigid_walls *walls, const struct scene *scene, struct restart *list) {
    for (int w = 0; w < walls->count; w++) {
        if (!may_end(&scene->wall[w]))
            continue;
        const char *name = scene->wall[w].name;
        restart_add(list, RESTART_INTEGER, true, &walls->wall[w].body, "through %s", name);
        for (int d = 0; d < 6; d++) {
            restart_add(list, RESTART_REAL, true, &walls->wall[w].before[d], "goes %d %s", d, name);
            restart_add(list, RESTART_REAL, true, &walls->wall[w].load[d], "load %d %s", d, name);
        }
    }
}

void rigid_walls_find(struct rigid_walls *walls, const struct physics_context *context, bool filled) {
    const struct fluid_options *options = context->options;
    struct walls *all = grains_walls(context);
    if (walls->found || all == NULL)
        return;
    for (int w = 0; w < walls->count; w++) {
        struct rigid_wall *wall = &walls->wall[w];
        const struct wall_options *shape = &context->scene->wall[w];
        bool body = filled ? rigid_walls_through(context, shape) : wall->body != 0;
        wall->body = body && may_end(shape) && walls_bounded(all, w);
        walls->bodies += wall->body != 0;
        if (wall->body)
            walls_depth_prepare(all, w, SOLID_EDGE * options->spacing);
    }
    walls->found = true;
}

/* Rows whose parts are found at a time. */
enum { BLOCK = 4096 };

static void part_find(const struct physics_context *context, int wall, size_t i, struct solid_part *part) {
    const double edge = SOLID_EDGE * ((const struct fluid_options *)context->options)->spacing;
    part->grain = solid_of_wall(wall);
    part->share = solid_edge(
        walls_depth(grains_walls(context), wall, context->particles->state[i].x, part->arm) / edge);
    if (context->box->dimension == 2)
        part->arm[2] = 0;
}

static void parts_keep(struct rigid_walls *walls, const struct solid_part *part, size_t count) {
    for (size_t k = 0; k < count; k++) {
        if (!(part[k].share > 0))
            continue;
        if (walls->parts == walls->room) {
            walls->room = 2 * walls->room + BLOCK;
            walls->part = memory_resize(walls->part, walls->room, sizeof *walls->part, "walls in a fluid");
        }
        walls->part[walls->parts++] = part[k];
    }
}

void rigid_walls_place(struct rigid_walls *walls, const struct physics_context *context, size_t first,
                       size_t rows) {
    const size_t bodies = (size_t)walls->bodies;
    walls->parts = 0;
    if (bodies == 0)
        return;
    struct solid_part *block = memory_allocate_zero(BLOCK * bodies, sizeof *block, "walls in a fluid");
    for (size_t from = 0; from < rows; from += BLOCK) {
        size_t count = rows - from < BLOCK ? rows - from : BLOCK;
#pragma omp parallel for schedule(static)
        for (size_t k = 0; k < count; k++) {
            struct solid_part *part = &block[k * bodies];
            for (int w = 0; w < walls->count; w++)
                if (walls->wall[w].body) {
                    part->row = (uint32_t)(from + k);
                    part_find(context, w, first + from + k, part++);
                }
        }
        parts_keep(walls, block, count * bodies);
    }
    memory_free(block);
}

void rigid_walls_move(struct rigid_walls *walls, const struct physics_context *context, bool first) {
    struct walls *all = grains_walls(context);
    if (walls->bodies == 0)
        return;
    walls_at_end(all, context->clock->time, context->clock->dt);
    for (int w = 0; w < walls->count; w++) {
        struct rigid_wall *wall = &walls->wall[w];
        struct wall_pose pose;
        if (!wall->body)
            continue;
        walls_pose(all, w, &pose);
        memcpy(wall->motion, pose.velocity, sizeof pose.velocity);
        memcpy(wall->motion + 3, pose.omega, sizeof pose.omega);
        if (first)
            memcpy(wall->before, wall->motion, sizeof wall->before);
    }
}

void rigid_walls_clear(struct rigid_walls *walls) {
    for (int w = 0; w < walls->count; w++)
        walls->wall[w].sums = walls->wall[w].whole = (struct rigid_grains_sums){0};
}

void rigid_walls_clear_momenta(struct rigid_walls *walls) {
    for (int w = 0; w < walls->count; w++)
        memset(walls->wall[w].momenta, 0, sizeof walls->wall[w].momenta);
}

/* What the fluid in a solid takes to follow in a step: change of its momentum, and of that about the centre of the wall. */
static void follow(const struct rigid_wall *wall, double dt, double momentum[6]) {
    const struct rigid_grains_sums *whole = &wall->whole;
    const double *omega = wall->motion + 3;
    double change[6], spin[3], turned[3], push[3], torque[3];
    for (int d = 0; d < 6; d++)
        change[d] = wall->motion[d] - wall->before[d];
    rigid_grains_momentum(whole, change, momentum);
    vector_cross(omega, whole->first, turned);
    vector_cross(omega, turned, push);
    rigid_grains_spin(whole->second, omega, spin);
    vector_cross(omega, spin, torque);
    for (int d = 0; d < 3; d++) {
        momentum[d] += dt * push[d];
        momentum[3 + d] += dt * torque[d];
    }
}

/* Adds over all ranks: what the forcing takes, and the sums of the whole solid. */
static void agree(struct rigid_wall *wall, const struct comm *comm, double taken[6]) {
    double all[16] = {0}, given[6];
    rigid_grains_momentum(&wall->sums, wall->motion, given);
    for (int d = 0; d < 6; d++) {
        all[d] = wall->momenta[d] - given[d];
        all[6 + d] = wall->whole.second[d];
    }
    memcpy(all + 12, wall->whole.first, sizeof wall->whole.first);
    all[15] = wall->whole.mass;
    comm_sum(comm, all, 16);
    memcpy(taken, all, 6 * sizeof *taken);
    memcpy(wall->whole.second, all + 6, sizeof wall->whole.second);
    memcpy(wall->whole.first, all + 12, sizeof wall->whole.first);
    wall->whole.mass = all[15];
}

void rigid_walls_loads(struct rigid_walls *walls, const struct physics_context *context, double dt,
                       const double force[3]) {
    for (int w = 0; w < walls->count; w++) {
        const double density = ((const struct fluid_options *)context->options)->density;
        struct rigid_wall *wall = &walls->wall[w];
        double taken[6], inside[6], torque[3];
        if (!wall->body)
            continue;
        agree(wall, context->comm, taken);
        follow(wall, dt, inside);
        vector_cross(wall->whole.first, force, torque);
        for (int d = 0; d < 3; d++) {
            wall->load[d] = (taken[d] + inside[d]) / dt - force[d] * wall->whole.mass / density;
            wall->load[3 + d] = (taken[3 + d] + inside[3 + d]) / dt - torque[d] / density;
        }
        memcpy(wall->before, wall->motion, sizeof wall->before);
    }
}

void rigid_walls_print(const struct rigid_walls *walls, const struct scene *scene, FILE *file) {
    for (int w = 0; w < walls->count; w++)
        if (walls->wall[w].body)
            fprintf(file, "  solid        wall '%s' moves through the fluid\n", scene->wall[w].name);
}
