/* SPDX-License-Identifier: BSD-3-Clause */
/* Looks at the walls of a scene for settings that are probably a mistake. Read engine/notes.h first. */
#include "engine/notes.h"
#include "physics/grains/overlaps.h"
#include "physics/grains/grains_own.h"
#include "base/memory.h"
#include <math.h>
#include <stdio.h>

struct extent grains_wall_extent(const struct grains *grains, const struct scene *scene, int w) {
    const struct wall_options *wall = &scene->wall[w];
    struct extent extent = notes_nothing;
    double(*triangle)[9] = NULL;
    size_t count = walls_triangles(grains->walls, w, &triangle);
    for (size_t k = 0; k < count; k++)
        for (int corner = 0; corner < 3; corner++)
            notes_extent_add(&extent, triangle[k] + 3 * corner, 0);
    memory_free(triangle);
    for (int d = 0; !wall_shape_meshed(wall->shape) && d < 3; d++) {
        double along = fabs(wall->axis[d]), half = wall->length > 0 ? wall->length / 2 : INFINITY;
        double reach = (along > 0 ? along * half : 0) + wall->radius * sqrt(fmax(0, 1 - along * along));
        if (wall->shape == WALL_PLANE)
            reach = fabs(wall->normal[d]) == 1 ? 0 : INFINITY;
        extent.lower[d] = wall->point[d] - reach;
        extent.upper[d] = wall->point[d] + reach;
    }
    return extent;
}

bool grains_wall_apart(const struct scene *scene, const struct extent *extent) {
    bool apart = false;
    for (int d = 0; d < scene->box.dimension; d++)
        apart = apart || extent->upper[d] < scene->box_lower[d] || extent->lower[d] > scene->box_upper[d];
    return apart;
}

/* Notes meshes that are far larger than the box: often an STL in millimetres. */
static void look_at_scale(const struct physics_context *c, int w, const struct extent *extent,
                          struct notes *notes) {
    static const double large = 50;
    double ratio = 0;
    for (int d = 0; d < c->scene->box.dimension; d++)
        ratio = fmax(ratio, (extent->upper[d] - extent->lower[d]) / c->scene->box.edge[d]);
    if (ratio > large)
        notes_add(notes, false,
                  "mesh '%s' is %.3g times as large as the box: is its file in millimetres (walls[%d].scale: "
                  "0.001)?",
                  c->scene->wall[w].name, ratio, w);
}

/* Notes parts that lie far apart: often a unit or a scale was forgotten. */
static void look_at_places(const struct physics_context *c, struct notes *notes) {
    const struct scene *scene = c->scene;
    for (int w = 0; w < scene->walls; w++) {
        if (!wall_shape_meshed(scene->wall[w].shape))
            continue;
        struct extent extent = grains_wall_extent(c->self, c->scene, w);
        look_at_scale(c, w, &extent, notes);
        if (grains_wall_apart(scene, &extent))
            notes_add(notes, false, "mesh '%s' lies wholly outside of the box (its scale, or its offset?)",
                      scene->wall[w].name);
    }
}

/* Notes servos that push away from all particles: nothing will stop them. */
static void look_at_servos(const struct physics_context *c, struct notes *notes) {
    for (int w = 0; w < c->scene->walls && notes->total > 0; w++) {
        const struct wall_options *wall = &c->scene->wall[w];
        struct extent extent = grains_wall_extent(c->self, c->scene, w);
        for (int m = 0; m < wall->motions; m++) {
            const struct wall_motion *motion = &wall->motion[m];
            bool ahead = motion->kind != WALL_SERVO || motion->force == 0;
            for (int corner = 0; !ahead && corner < 8; corner++) {
                double along = 0;
                for (int d = 0; d < 3; d++) {
                    double at = wall->point[d];
                    if (wall_shape_meshed(wall->shape))
                        at = (extent.lower[d] + extent.upper[d]) / 2;
                    double x = corner >> d & 1 ? notes->particles.upper[d] : notes->particles.lower[d];
                    along += motion->direction[d] * (x - at) * (motion->force < 0 ? 1 : -1);
                }
                ahead = along > 0;
            }
            if (!ahead)
                notes_add(
                    notes, true,
                    "walls[%d].motion[%d]: the servo of wall '%s' pushes away from all particles, and will "
                    "move "
                    "on at speed_max; turn its direction round",
                    w, m, wall->name);
        }
    }
}

/* Notes meshes with edges that spheres overlap so far that the contact with the second side begins with a jump
 * (wall_touch.h). */
static void look_at_edges(const struct physics_context *c, struct notes *notes) {
    static const double degrees = 57.29577951308232;
    const struct grains *grains = c->self;
    double overlap = fmax(grains->stable.overlaps.met, grains->stable.overlap_started);
    for (int w = 0; w < c->scene->walls; w++) {
        double turn = walls_turn(grains_walls(c), w);
        if (isfinite(turn) && overlap > 1 - cos(turn))
            notes_add(
                notes, false,
                "mesh '%s' turns by %.3g degrees at edges: inside of such an edge a sphere that overlaps by "
                "more than "
                "%.2g of its radius (expected: up to %.2g) gains or loses energy, per cents in a few turns "
                "of a "
                "tube; edges of less than 8.6 degrees do not, nor does a cylinder (docs/physics.md, Meshes)",
                c->scene->wall[w].name, turn * degrees, 1 - cos(turn), overlap);
    }
}

/* Names what makes the contacts of the squeezed grain stiffer. */
static void name_stiffness(const struct physics_context *c, char *text, size_t room) {
    const struct grains *grains = c->self;
    const int *m = grains->stable.overlaps.material;
    const char *one = c->scene->material[m[0]].name, *other = c->scene->material[m[1]].name;
    const char *what = grains->law.moduli ? "young" : grains->user ? "the stiffness" : "k_n";
    if (m[0] == m[1])
        snprintf(text, room, "%s of '%s'", what, one);
    else
        snprintf(text, room, "%s of '%s' and '%s'", what, one, other);
}

/* Notes that a large grain may crush a small one, and what helps: the time step is as the overlap. A solver's step is not. */
static void look_at_squeeze(const struct physics_context *c, struct notes *notes) {
    const struct grains *grains = c->self;
    static const double small = 0.05;
    const struct overlaps *o = &grains->stable.overlaps;
    const struct scene_guards *guards = &c->scene->guards;
    char what[2 * LAW_NAME_MAX + 32];
    if (grains_solved(c) || guards->overlap == SCENE_GUARD_OFF || !(o->squeezed > guards->overlap_bound))
        return;
    name_stiffness(c, what, sizeof what);
    notes_add(
        notes, true,
        "guards.overlap: a grain of mass %.3g may squeeze one of radius %.3g against its support, at up to "
        "%.3g: "
        "they overlap by up to %.3g of that radius (bound %g), and the guard may %s. %s times %.2g keeps the "
        "overlap "
        "below the bound, with a time step of %.2g of this one; times %.2g keeps it below %g, with %.2g. If "
        "grains stay slower, "
        "step.speed_max says so",
        o->mass, o->radius, o->speed, o->squeezed, guards->overlap_bound,
        guards->overlap == SCENE_GUARD_STOP ? "stop this run" : "warn", what,
        overlaps_stiffening(o, guards->overlap_bound), guards->overlap_bound / o->squeezed,
        overlaps_stiffening(o, small), small, small / o->squeezed);
}

void grains_notes(const struct physics_context *context, struct notes *notes) {
    const struct grains *grains = context->self;
    overlaps_expect(context);
    notes->speed_expected = grains->stable.speed_expected;
    notes->overlap_expected = grains->stable.overlaps.met;
    look_at_places(context, notes);
    look_at_servos(context, notes);
    look_at_edges(context, notes);
    look_at_squeeze(context, notes);
}

void grains_notes_seen(const struct physics_context *c, uint64_t first, struct notes *notes) {
    const struct grains *grains = c->self;
    for (int w = 0; w < c->scene->walls; w++)
        for (int m = 0; m < c->scene->wall[w].motions; m++) {
            const struct wall_motion *motion = &c->scene->wall[w].motion[m];
            uint64_t pushed = grains->pushed[w] > first ? grains->pushed[w] : first;
            if (motion->kind != WALL_SERVO || c->clock->step - pushed <= (c->clock->step - first) / 2 ||
                motion->start > c->clock->time || motion->stop < c->clock->time)
                continue;
            struct wall_pose pose;
            walls_pose(grains->walls, w, &pose);
            notes_add(
                notes, true,
                "walls[%d].motion[%d]: nothing pushed on wall '%s' in the last %llu steps. Its servo moved "
                "it by %.4g along its "
                "direction: away from the particles (then turn the direction round), or it has not reached "
                "them yet",
                w, m, c->scene->wall[w].name, (unsigned long long)(c->clock->step - pushed),
                pose.servo_offset);
        }
}
