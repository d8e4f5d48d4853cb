/* SPDX-License-Identifier: BSD-3-Clause */
/* Life and motion of the walls (wall.h). */
#include "physics/grains/walls/mesh_shape.h"
#include "physics/grains/walls/wall_area.h"
#include "physics/grains/walls/walls_near.h"
#include "physics/grains/walls/walls_touch.h"
#include "base/memory.h"
#include <string.h>

static void put(double out[3], struct law_vector v) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static struct law_vector box_vector(const double x[3], const double origin[3]) {
    return (struct law_vector){x[0] - origin[0], x[1] - origin[1], x[2] - origin[2]};
}

/* Reads the triangles of a mesh, or makes those of another shape. */
static bool wall_make_mesh(struct wall *wall, const struct box *box, FILE *notes, struct error *error) {
    const struct wall_options *o = &wall->options;
    bool read = o->shape == WALL_MESH;
    struct wall_mesh_place place = {.scale = read ? o->scale : 1.0};
    struct mesh file;
    for (int d = 0; d < 3; d++)
        place.shift[d] = (read ? o->offset[d] : 0.0) - box->origin[d];
    if (!(place.scale > 0.0))
        return error_set(error, ERROR_USER, "wall '%s': scale is %g, must be above 0", o->name, o->scale);
    if (read ? !mesh_read(&file, o->file, o->format, error) : !mesh_shape_make(&file, o, error))
        return false;
    bool good = wall_mesh_create(&wall->mesh, &file, read ? o->file : o->name, &place, notes, error);
    mesh_free(&file);
    if (good)
        wall->grid = wall_grid_create(wall->mesh);
    return good &&
           (!o->field || wall_field_create(&wall->field, wall->mesh, o->field_spacing, o->name, error));
}

/* Point and axis of a plane or cylinder. */
static bool wall_set_shape(struct wall *wall, const struct box *box, struct error *error) {
    const struct wall_options *o = &wall->options;
    bool plane = o->shape == WALL_PLANE;
    struct law_vector axis = wall_vector(plane ? o->normal : o->axis);
    double length = sqrt(law_dot(axis, axis));
    if (!(length > 0.0 && isfinite(length)))
        return error_set(error, ERROR_USER, "wall '%s': its %s has no length", o->name,
                         plane ? "normal" : "axis");
    wall->axis = fabs(length - 1.0) > 1e-15 ? law_scale(1.0 / length, axis) : axis;
    wall->point = box_vector(o->point, box->origin);
    if (!plane && !(o->radius > 0.0 && o->length >= 0.0))
        return error_set(error, ERROR_USER,
                         "wall '%s': a cylinder needs a radius above 0 and no negative length", o->name);
    return true;
}

/* Finds the images of a wall that particles can touch: those in periodic directions, except for planes and
 * infinite tubes, which a periodic box must not cut. */
static void wall_find_images(struct wall *wall, const struct box *box) {
    const struct wall_options *o = &wall->options;
    const double axis[3] = {wall->axis.x, wall->axis.y, wall->axis.z};
    bool endless = o->shape == WALL_CYLINDER && o->length == 0.0;
    wall->images = wall_shape_meshed(o->shape) || (o->shape == WALL_CYLINDER && !(endless && o->inside));
    bool along[3];
    for (int d = 0; d < 3; d++)
        along[d] = wall->images && box->periodic[d] && !(endless && fabs(axis[d]) == 1.0);
    for (int z = -along[2]; z <= along[2]; z++)
        for (int y = -along[1]; y <= along[1]; y++)
            for (int x = -along[0]; x <= along[0]; x++)
                wall->image[wall->image_count++] = (int)image_code(x, y, z);
}

static void wall_find_reach(struct wall *wall) {
    const struct wall_options *o = &wall->options;
    const double axis[3] = {wall->axis.x, wall->axis.y, wall->axis.z};
    for (int d = 0; d < 3 && o->shape == WALL_CYLINDER; d++) {
        double along = o->length > 0.0 || axis[d] == 0.0 ? 0.5 * o->length * fabs(axis[d]) : INFINITY;
        wall->reach[d] = along + o->radius * sqrt(law_max(0.0, 1.0 - axis[d] * axis[d]));
    }
    for (size_t t = 0; wall->mesh && t < wall->mesh->triangles; t++)
        for (int c = 0; c < 3; c++) {
            double from[3];
            put(from, law_add(wall->mesh->triangle[t].corner[c], -1.0, wall->mesh->centre));
            for (int d = 0; d < 3; d++)
                wall->reach[d] = law_max(wall->reach[d], fabs(from[d]));
        }
}

static void wall_place(struct wall *wall, double t) {
    struct wall_transform motion =
        wall->free ? wall_free_place(wall->free) : wall_motions_place(wall->motions, t, wall->servo_offset);
    wall->pose = wall_transform_compose(&motion, &wall->base);
    walls_follow(wall);
}

static bool wall_create(struct wall *wall, const struct wall_options *options, const struct box *box,
                        FILE *notes, struct error *error) {
    wall->options = *options;
    wall->base = wall->pose = wall->built = wall_transform_identity();
    bool good = wall_shape_meshed(options->shape) ? wall_make_mesh(wall, box, notes, error)
                                                  : wall_set_shape(wall, box, error);
    wall_find_images(wall, box);
    wall_find_reach(wall);
    return good;
}

static bool start_free(struct wall *wall, const struct box *box, struct error *error) {
    if (!wall_free_create(&wall->free, &wall->options, wall->mesh, box, error))
        return false;
    wall_free_begin(wall->free, &wall->base);
    wall->centre = wall_free_centre(wall->free, &wall->base);
    wall->twist = wall_free_twist(wall->free);
    return true;
}

static bool walls_start_motions(struct walls *walls, int w, struct error *error) {
    struct wall *wall = &walls->wall[w];
    const struct box *box = &walls->box;
    if (!wall_area_targets(walls, w, error) ||
        !wall_motions_create(&wall->motions, &wall->options, box->origin, error) ||
        (box->dimension == 2 && !wall_motions_flat(wall->motions, error)))
        return false;
    if (!wall_motions_pivot(wall->motions, &wall->centre))
        wall->centre = wall->mesh ? wall->mesh->centre : wall->point;
    if (wall->options.free.given && !start_free(wall, box, error))
        return false;
    wall->moving = wall_moves(&wall->options);
    wall->slides = wall_motions_slides(wall->motions);
    wall->unit = wall_motions_servo_unit(wall->motions);
    wall_place(wall, 0.0);
    return true;
}

static void scratch_create(struct walls *walls) {
    walls->scratch = memory_allocate_zero((size_t)walls->threads, sizeof *walls->scratch, "walls");
    for (int t = 0; t < walls->threads; t++) {
        walls->scratch[t] = memory_allocate_zero(1, sizeof *walls->scratch[t], "walls");
        walls->scratch[t]->batch =
            memory_allocate_zero(1, sizeof *walls->scratch[t]->batch, "contacts with walls");
        walls->scratch[t]->load =
            memory_allocate_zero((size_t)walls->count, sizeof *walls->scratch[t]->load, "forces on walls");
        walls->scratch[t]->impedance =
            memory_allocate_zero((size_t)walls->count, sizeof *walls->impedance, "forces on walls");
    }
}

bool walls_create(struct walls **walls, const struct wall_options *options, int count, const struct law *law,
                  const struct box *box, int threads, struct error *error, FILE *notes) {
    struct walls *w = memory_allocate_zero(1, sizeof *w, "walls");
    *walls = w;
    w->count = count;
    w->threads = threads;
    w->law = law;
    w->kernel = force_kernel_find(NULL);
    w->box = *box;
    walls_set_extent(w, box->edge, box->edge);
    box_image_shifts(box, w->shift);
    w->wall = memory_allocate_zero((size_t)count, sizeof *w->wall, "walls");
    w->force = memory_allocate_zero((size_t)count, sizeof *w->force, "forces on walls");
    w->power = memory_allocate_zero((size_t)count, sizeof *w->power, "forces on walls");
    w->impedance = memory_allocate_zero((size_t)count, sizeof *w->impedance, "forces on walls");
    w->first = memory_allocate_zero(1, sizeof *w->first, "walls");
    scratch_create(w);
    for (int k = 0; k < count; k++)
        if (!wall_create(&w->wall[k], &options[k], box, notes, error) || !walls_start_motions(w, k, error)) {
            walls_destroy(walls);
            return false;
        }
    walls_wrap(w);
    return true;
}

bool walls_choose(struct walls *walls, const char *kernel) {
    const struct force_kernel *found = force_kernel_find(kernel);
    if (found)
        walls->kernel = found;
    return found != NULL;
}

void walls_destroy(struct walls **walls) {
    struct walls *w = *walls;
    if (w == NULL)
        return;
    for (int k = 0; k < w->count; k++) {
        wall_mesh_destroy(&w->wall[k].mesh);
        wall_grid_destroy(&w->wall[k].grid);
        wall_field_destroy(&w->wall[k].field);
        wall_bulk_destroy(&w->wall[k].bulk);
        wall_motions_destroy(&w->wall[k].motions);
        wall_free_destroy(&w->wall[k].free);
    }
    for (int t = 0; t < w->threads; t++) {
        walls_scratch_free(w->scratch[t]);
        memory_free(w->scratch[t]);
    }
    for (int b = 0; b < 2; b++) {
        memory_free(w->records[b].count);
        memory_free(w->records[b].key);
        memory_free(w->records[b].value);
    }
    memory_free(w->scratch);
    memory_free(w->wall);
    memory_free(w->force);
    memory_free(w->power);
    memory_free(w->impedance);
    memory_free(w->exact);
    memory_free(w->particle);
    memory_free(w->first);
    memory_free(w->piece);
    memory_free(w->near_count);
    memory_free(w);
    *walls = NULL;
}

int walls_count(const struct walls *walls) {
    return walls->count;
}

const struct wall_options *walls_options(const struct walls *walls, int wall) {
    return &walls->wall[wall].options;
}

bool walls_have_servo(const struct walls *walls) {
    for (int w = 0; w < walls->count; w++)
        if (wall_motions_has_servo(walls->wall[w].motions))
            return true;
    return false;
}

bool walls_follow_particles(const struct walls *walls) {
    for (int w = 0; w < walls->count; w++)
        if (walls->wall[w].free || wall_motions_has_servo(walls->wall[w].motions))
            return true;
    return false;
}

double *walls_impedance(struct walls *walls, int wall) {
    return &walls->impedance[wall];
}

bool walls_move(const struct walls *walls) {
    for (int w = 0; w < walls->count; w++)
        if (wall_moves(&walls->wall[w].options))
            return true;
    return false;
}

/* Finds the base of a wall whose pose was set from outside, at time t: the motions, applied to the base, give
 * this pose. A stored base that does so is kept, so that an unchanged run goes on with the same bits. */
static void wall_find_base(struct wall *wall, double t) {
    struct wall_transform motion = wall_motions_place(wall->motions, t, wall->servo_offset);
    struct wall_transform there = wall_transform_compose(&motion, &wall->base);
    if (!wall_transform_near(&there, &wall->pose)) {
        struct wall_transform back = wall_transform_inverse(&motion);
        wall->base = wall_transform_compose(&back, &wall->pose);
    }
    wall->resumed = false;
}

/* Sets the twists of a wall and of its surface in a step from t on. */
static void set_twists(struct wall *wall, double t, double dt, double servo_offset) {
    wall->twist = wall_motions_twist(wall->motions, t, dt, servo_offset, wall->servo_speed);
    if (wall->slides)
        wall->surface = wall_motions_surface(wall->motions, t, dt, servo_offset);
}

static void advance_free(struct wall *wall, const struct wall_push *push, const double gravity[3],
                         double dt) {
    wall_free_advance(wall->free, push, gravity, dt);
    wall_place(wall, 0.0);
    wall->twist = wall_free_twist(wall->free);
}

void walls_advance(struct walls *walls, double t, double dt, const struct wall_push *push) {
    for (int w = 0; w < walls->count; w++) {
        struct wall *wall = &walls->wall[w];
        if (wall->free)
            advance_free(wall, &push[w], walls->gravity, dt);
        if (wall->options.motions == 0)
            continue;
        if (wall->resumed)
            wall_find_base(wall, t);
        wall->servo_speed =
            push ? wall_motions_servo_follow(wall->motions, t, &push[w], wall->servo_speed) : 0.0;
        set_twists(wall, t, dt, wall->servo_offset + 0.5 * dt * wall->servo_speed);
        wall->servo_offset += dt * wall->servo_speed;
        wall_place(wall, t + dt);
    }
}

void walls_at_end(struct walls *walls, double t, double dt) {
    double moment = 1e-4 * dt;
    for (int w = 0; w < walls->count; w++)
        if (walls->wall[w].options.motions > 0)
            set_twists(&walls->wall[w], t - moment, moment, walls->wall[w].servo_offset);
}
