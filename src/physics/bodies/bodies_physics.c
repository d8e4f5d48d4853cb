/* SPDX-License-Identifier: BSD-3-Clause */
/* Bodies as a physics: checks of the section, the pass of the step, the hooks of the engine. Read bodies.h first. */
#include "physics/bodies/bodies.h"
#include "engine/physics_set.h"
#include "physics/bodies/bodies_fields.h"
#include "physics/grains/grains.h"
#include "physics/grains/motion/timestep.h"
#include "physics/bodies/bodies_links.h"
#include "physics/bodies/bodies_parts.h"
#include "physics/bodies/bodies_shapes.h"
#include "physics/bodies/rocks.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <stdio.h>

/* Refuses what an entry of any shape may say wrong; `key`: the entry. */
static bool check_entry(const struct physics_context *context, const struct clump_entry *entry,
                        const char *key, struct error *error) {
    const struct scene *scene = context->scene;
    const double *q = entry->quaternion, *w = entry->angular_velocity;
    const bool flat = context->box->dimension == 2;
    if (entry->material < 0 && scene->materials > 1 && !entry->named)
        return scene_fail(
            scene, error, key,
            "needs material: which grains become these bodies; or a source that names it (shape)");
    if (entry->size == CLUMP_BY_VOLUME && !entry->named)
        return scene_fail(scene, error, key,
                          "size: volume needs a source or an insertion that names the entry (shape); allowed "
                          "without: grain, drawn");
    if (!(entry->radius_upto > entry->radius_above))
        return scene_fail(scene, error, key, "radius_upto (%g) is not above radius_above (%g)",
                          entry->radius_upto, entry->radius_above);
    if (entry->orientation == CLUMP_GIVEN &&
        (entry->quaternion_given != 4 || !(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0)))
        return scene_fail(scene, error, key,
                          "orientation: given needs quaternion: four numbers w x y z, not all 0");
    if (flat && ((entry->orientation == CLUMP_GIVEN && (q[1] != 0 || q[2] != 0)) || w[0] != 0 || w[1] != 0))
        return scene_fail(scene, error, key,
                          "turns out of the plane of a two-dimensional scene; allowed is z alone");
    return true;
}

static bool check(const struct physics_context *context, struct error *error) {
    const struct bodies_options *options = context->options;
    char key[64];
    if (bodies_entries(options) == 0)
        return scene_fail(context->scene, error, "bodies", "needs clumps or shapes");
    for (int k = 0; k < bodies_entries(options); k++)
        if (!check_entry(context, bodies_entry(options, k),
                         bodies_shapes_key(options, k, "", key, sizeof key), error))
            return false;
    struct bodies bodies = {0};
    bool good =
        bodies_shapes_make(&bodies, context->scene, options, error) && place_check(&bodies, context, error);
    bodies_shapes_free(&bodies);
    return good && rocks_check(context, error);
}

struct bodies *bodies_of(const struct physics_set *set) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row == &bodies_physics)
            return set->active[k].context.self;
    return NULL;
}

static void *create(const struct physics_context *context) {
    struct bodies *bodies = memory_allocate_zero(1, sizeof *bodies, "bodies");
    struct error none = {0};
    if (!bodies_shapes_make(bodies, context->scene, context->options, &none))
        error_fatal("%s", none.text); /* a file that has changed since the check */
    if (bodies->options->rocks > 0)
        bodies->rocks = rocks_create(context);
    for (int k = 0; k < bodies->shapes; k++)
        if (place_swell(&bodies->clump[k]) > 0)
            carried_register_solid(context->particles);
    grains_motion(context)->carried = &bodies->carried;
    return bodies;
}

static void destroy(void *self) {
    struct bodies *bodies = self;
    bodies_shapes_free(bodies);
    bodies_links_free(&bodies->links);
    rocks_free(&bodies->rocks);
    memory_free(bodies);
}

static bool fill(const struct physics_context *context, const struct physics_share *share,
                 struct error *error) {
    return place_all(context->self, context, share, error);
}

static bool part(const struct physics_context *context, const struct physics_grain *grain, int number,
                 struct physics_part *found) {
    return place_part(context->self, context->scene->seed, grain, number, found);
}

static double edge(const struct physics_context *context, int material, double radius) {
    return place_edge(context->options, material, radius);
}

static void join(const struct physics_context *context, size_t k, int64_t first_id) {
    place_join(context->self, context, k, first_id);
}

static bool admit(const struct physics_context *context, const struct physics_grain *grain,
                  struct error *error) {
    return grain == NULL || place_admit(context->self, context->box, grain, error);
}

static void rebuilt(const struct physics_context *context) {
    struct bodies *bodies = context->self;
    bodies_links_make(bodies, context);
    if (bodies->rocks)
        rocks_rebuilt(bodies, context);
}

static void step(const struct physics_context *context) {
    struct bodies *bodies = context->self;
    bodies_motion_step(bodies, context);
    if (bodies->rocks)
        rocks_turn(bodies, context->particles);
}

static bool has_rocks(const struct physics_context *context) {
    return ((const struct bodies *)context->self)->rocks != NULL;
}

/* True if rocks find the forces of their contacts themselves: a solver asks for their points alone (rocks_near.h). */
static bool rocks_touch(const struct physics_context *context) {
    return has_rocks(context) && !grains_solved(context);
}

static void act(const struct physics_context *context) {
    rocks_act(context->self, context);
}

static void sum(const struct physics_context *context) {
    rocks_sum(context->self, context);
}

static struct history_rows *rows_of(const struct physics_context *context) {
    return rocks_touch(context) ? rocks_rows(context->self, context) : NULL;
}

/* The law leaves the contacts of balls around rocks to rocks_act. */
static bool joined(const struct physics_context *context, size_t i, size_t j) {
    return rocks_shape(context->particles, i) >= 0 || rocks_shape(context->particles, j) >= 0;
}

static bool alone(const struct physics_context *context, size_t i) {
    return rocks_shape(context->particles, i) >= 0;
}

static void ease_raise(const struct clump *clump, struct timestep_body *body) {
    const bool rock = clump->core.corners > 0;
    body->ease = fmax(body->ease, clump->ease);
    body->curved = fmax(body->curved, rock ? clump->rounding / clump->extent : 1);
    for (int k = 0; rock && k < 3; k++)
        body->seat[k] = fmax(body->seat[k], clump->seat[k]);
}

/* Rocks by their shape, members of clumps by the worst of all clumps, grains to come by their entry. */
static void ease(const struct physics_context *context, size_t i, const struct physics_grain *grain,
                 struct timestep_body *body) {
    const struct bodies *bodies = context->self;
    const struct particles *p = context->particles;
    int first = 0, count = 0;
    if (i == SIZE_MAX) {
        count = place_shapes(bodies->options, place_entry(bodies->options, grain), &first);
    } else if (bodies->rocks && rocks_shape(p, i) >= 0) {
        first = rocks_shape(p, i);
        count = 1;
    } else if (carried_by(p)[i] >= 0) {
        count = bodies->options->clumps;
    }
    if (count > 0)
        body->curved = 0;
    for (int k = first; k < first + count; k++)
        ease_raise(&bodies->clump[k], body);
}

static void stiffen(const struct physics_context *context, struct stability *stability) {
    if (has_rocks(context))
        rocks_stiffen(context->self, context, stability);
}

static double stiffest(const struct physics_context *context, const struct stability *stability) {
    return has_rocks(context) ? rocks_stiffest(context->self, context, stability) : 0;
}

static void full_step(const struct physics_context *context) {
    bodies_motion_full_step(context->self, context);
}

static void shapes(const struct physics_context *context, struct output_shapes *list) {
    bodies_shapes_show(context->self, list);
}

static void restart(const struct physics_context *context, struct restart *list) {
    struct bodies *bodies = context->self;
    restart_add(list, RESTART_REAL, false, &bodies->before, "bodies: length of the last step");
}

/* Prints of how many bodies a shape is, and from where to where their radius, mass and inertia reach. Collective. */
static void print_made(const struct physics_context *context, int number, FILE *file) {
    enum { RADIUS, MASS, INERTIA, ALL = INERTIA + 3 };
    const struct bodies *bodies = context->self;
    const struct particles *p = context->particles;
    double least[ALL], most[ALL];
    int64_t count = 0;
    for (int k = 0; k < ALL; k++)
        least[k] = -(most[k] = -INFINITY);
    for (size_t i = 0; i < p->owned; i++) {
        if (kinds_of(p)[i] != KIND_BODY || bodies_part(p)[i] != number)
            continue;
        const struct clump *clump = &bodies->clump[number];
        double mass = bodies_mass(p)[i], scale = p->state[i].radius / clump->extent;
        double value[ALL] = {[RADIUS] = p->state[i].radius, [MASS] = mass};
        for (int d = 0; d < 3; d++)
            value[INERTIA + d] = mass * clump->gyration[d] * scale * scale;
        for (int k = 0; k < ALL; k++) {
            least[k] = fmin(least[k], value[k]);
            most[k] = fmax(most[k], value[k]);
        }
        count++;
    }
    comm_sum_int(context->comm, &count, 1);
    comm_min(context->comm, least, ALL);
    comm_max(context->comm, most, ALL);
    if (context->comm->rank != 0 || count == 0)
        return;
    const bool alike = least[RADIUS] == most[RADIUS] && least[MASS] == most[MASS];
    for (int end = 0; end < (alike ? 1 : 2); end++) {
        const double *of = end ? most : least;
        fprintf(file, "  %s: radius %.6g, mass %.6g, principal moments of inertia %.6g %.6g %.6g\n",
                alike ? "each"
                : end ? "largest"
                      : "smallest",
                of[RADIUS], of[MASS], of[INERTIA], of[INERTIA + 1], of[INERTIA + 2]);
    }
}

static void print_rock(const struct clump *clump, const char *name, FILE *file) {
    const struct solid *core = &clump->core;
    fprintf(
        file,
        "rocks '%s': %d corners, %d faces, rounding %.6g; as drawn: radius of the ball %.6g about %.6g "
        "%.6g %.6g, "
        "volume %.6g, moments of inertia over mass %.6g %.6g %.6g (of the sharp solid); a push on a corner "
        "moves it %.3g times as far as one on the centre, and a contact along faces is as stiff as %.3g "
        "on the centre\n",
        name, core->corners, core->faces, clump->rounding, clump->extent, clump->centre[0], clump->centre[1],
        clump->centre[2], clump->volume, clump->gyration[0], clump->gyration[1], clump->gyration[2],
        clump->corner, clump->seat[0]);
}

static void print_shape(const struct physics_context *context, int k, FILE *file) {
    const struct bodies *bodies = context->self;
    const struct clump *clump = &bodies->clump[k];
    if (context->comm->rank == 0 && clump->core.corners > 0) {
        print_rock(clump, bodies->entry[k]->name, file);
    } else if (context->comm->rank == 0) {
        char how[96] = "none overlap";
        if (clump->overlap)
            snprintf(how, sizeof how, "some overlap (volume and inertia by quadrature)");
        if (clump->filled > 0)
            snprintf(how, sizeof how, "which fill %.3g of a mesh (volume and inertia of the mesh)",
                     clump->filled);
        fprintf(file,
                "bodies '%s': %d spheres, %s; as drawn: radius of the ball %.6g about %.6g %.6g %.6g, volume "
                "%.6g, moments of inertia over mass %.6g %.6g %.6g\n",
                bodies->entry[k]->name, clump->spheres, how, clump->extent, clump->centre[0],
                clump->centre[1], clump->centre[2], clump->volume, clump->gyration[0], clump->gyration[1],
                clump->gyration[2]);
    }
    print_made(context, k, file);
}

static void print(const struct physics_context *context, FILE *file) {
    const struct bodies *bodies = context->self;
    for (int k = 0; k < bodies->shapes; k++)
        print_shape(context, k, file);
    if (context->comm->rank == 0)
        fprintf(
            file,
            "  the stable time step takes each member of a clump with its share of the mass, and so is below "
            "that of the body; of a rock its contacts along faces\n");
}

static const struct physics_pass passes[] = {{.name = "bodies",
                                              .does = "forces on bodies, and their motion",
                                              .place = PASS_FIRST,
                                              .reads = "force torque",
                                              .writes = "position orientation",
                                              .whole = step},
                                             {.name = "rocks",
                                              .does = "contacts of rocks",
                                              .why = "bodies.shapes",
                                              .place = PASS_SHARES,
                                              .reads = "position velocity angular_velocity orientation",
                                              .writes = "force torque",
                                              .needed = rocks_touch,
                                              .whole = act},
                                             {.name = "rocks_sum",
                                              .why = "bodies.shapes",
                                              .place = PASS_CLOSE,
                                              .timer = "rocks",
                                              .needed = rocks_touch,
                                              .whole = sum}};

static const struct physics_maker maker = {
    .fill = fill, .part = part, .edge = edge, .join = join, .admit = admit};
static const struct physics_rows rows = {.of = rows_of, .components = ROCKS_COMPONENTS};
static const struct physics_joints joints = {.joined = joined,
                                             .joins = has_rocks,
                                             .alone = alone,
                                             .ease = ease,
                                             .stiffen = stiffen,
                                             .stiffest = stiffest};
static const struct physics_shown shown = {.full_step = full_step, .shapes = shapes};

const struct physics bodies_physics = {.name = "bodies",
                                       .box_moves = true,
                                       .passes = sizeof passes / sizeof passes[0],
                                       .pass = passes,
                                       .check = check,
                                       .create = create,
                                       .destroy = destroy,
                                       .rebuilt = rebuilt,
                                       .print = print,
                                       .restart = restart,
                                       .maker = &maker,
                                       .rows = &rows,
                                       .joints = &joints,
                                       .shown = &shown};
