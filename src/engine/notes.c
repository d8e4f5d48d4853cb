/* SPDX-License-Identifier: BSD-3-Clause */
/* Looks in a simulation for settings that are probably a mistake. Read notes.h first. */
#include "engine/notes.h"
#include "core/memory.h"
#include "particles/kinds.h"
#include <math.h>
#include <stdarg.h>
#include <string.h>

static const struct extent nothing = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static void extent_add(struct extent *extent, const double x[3], double reach) {
    for (int d = 0; d < 3; d++) {
        extent->lower[d] = fmin(extent->lower[d], x[d] - reach);
        extent->upper[d] = fmax(extent->upper[d], x[d] + reach);
    }
}

/* The extent of the particles on all ranks, without those that lie behind boundaries, and the number of centres beyond an open side of the box.
 * Collective. */
static struct extent particles_extent(const struct simulation *s, int64_t *outside) {
    const struct box *box = &s->box;
    struct extent extent = nothing;
    const uint8_t *kind = kinds_of(s->particles);
    *outside = 0;
    for (size_t k = 0; k < s->particles->owned; k++) {
        if (kind && kind[k] == KIND_BOUNDARY)
            continue;
        const struct particle_state *p = &s->particles->state[k];
        double x[3];
        bool out = false;
        for (int d = 0; d < 3; d++) {
            x[d] = p->x[d] + box->origin[d];
            out = out || (d < box->dimension && !box->periodic[d] && (p->x[d] < 0 || p->x[d] > box->edge[d]));
        }
        extent_add(&extent, x, p->radius);
        *outside += out;
    }
    comm_min(s->comm, extent.lower, 3);
    comm_max(s->comm, extent.upper, 3);
    comm_sum_int(s->comm, outside, 1);
    return extent;
}

struct extent notes_wall_extent(const struct simulation *s, int w) {
    const struct wall_options *wall = &s->scene->wall[w];
    struct extent extent = nothing;
    double(*triangle)[9] = NULL;
    size_t count = walls_triangles(s->grains.walls, w, &triangle);
    for (size_t k = 0; k < count; k++)
        for (int corner = 0; corner < 3; corner++)
            extent_add(&extent, triangle[k] + 3 * corner, 0);
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

double notes_moved(const struct simulation *s) {
    return s->classes.count && s->classes.radius_min[0] > 0
               ? s->timing.speed_expected * s->clock.dt / s->classes.radius_min[0]
               : 0;
}

static void add(struct notes *notes, bool warning, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void add(struct notes *notes, bool warning, const char *format, ...) {
    va_list list;
    if (notes->count == NOTES_MAX)
        return;
    struct note *note = &notes->note[notes->count++];
    note->warning = warning;
    va_start(list, format);
    vsnprintf(note->text, sizeof note->text, format, list);
    va_end(list);
}

/* Notes meshes that are far larger than the box: often an STL in millimetres. */
static void look_at_scale(const struct simulation *s, int w, const struct extent *extent,
                          struct notes *notes) {
    static const double large = 50;
    double ratio = 0;
    for (int d = 0; d < s->scene->box.dimension; d++)
        ratio = fmax(ratio, (extent->upper[d] - extent->lower[d]) / s->scene->box.edge[d]);
    if (ratio > large)
        add(notes, false,
            "mesh '%s' is %.3g times as large as the box: is its file in millimetres (walls[%d].scale: "
            "0.001)?",
            s->scene->wall[w].name, ratio, w);
}

/* Notes parts that lie far apart: often a unit or a scale was forgotten. */
static void look_at_places(const struct simulation *s, struct notes *notes) {
    const struct scene *scene = s->scene;
    if (notes->outside > 0)
        add(notes, false,
            "%lld of %llu particles have their centres outside of the box (units of lengths, and the table "
            "'where it is' of scree check, tell why)",
            (long long)notes->outside, (unsigned long long)s->total);
    for (int w = 0; w < scene->walls; w++) {
        if (!wall_shape_meshed(scene->wall[w].shape))
            continue;
        struct extent extent = notes_wall_extent(s, w);
        for (int d = 0; d < scene->box.dimension; d++)
            notes->apart[w] = notes->apart[w] || extent.upper[d] < scene->box_lower[d] ||
                              extent.lower[d] > scene->box_upper[d];
        look_at_scale(s, w, &extent, notes);
        if (notes->apart[w])
            add(notes, false, "mesh '%s' lies wholly outside of the box (its scale, or its offset?)",
                scene->wall[w].name);
    }
}

/* Notes servos that push away from all particles: nothing will stop them. */
static void look_at_servos(const struct simulation *s, struct notes *notes) {
    for (int w = 0; w < s->scene->walls && s->total > 0; w++) {
        const struct wall_options *wall = &s->scene->wall[w];
        struct extent extent = notes_wall_extent(s, w);
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
                add(notes, true,
                    "walls[%d].motion[%d]: the servo of wall '%s' pushes away from all particles, and will "
                    "move "
                    "on at speed_max; turn its direction round",
                    w, m, wall->name);
        }
    }
}

/* Notes insertion regions that reach out of the box where the box does not keep particles. */
static void look_at_insertions(const struct simulation *s, struct notes *notes) {
    const struct box *box = &s->box;
    for (int k = 0; k < s->scene->insertions; k++) {
        const struct insertion_options *insertion = &s->sources.insertion[k].options;
        double lower[3], upper[3], smallest, largest;
        region_bounds(&insertion->region, lower, upper);
        sizes_bounds(&insertion->sizes, &smallest, &largest);
        for (int side = 0; side < 2 * box->dimension; side++) {
            int d = side / 2;
            double beyond = side % 2 ? upper[d] - smallest - box->origin[d] - box->edge[d]
                                     : box->origin[d] - lower[d] - smallest;
            if (box->periodic[d] || box->leave[d][side % 2] == BOX_KEEP || !(beyond > 1e-12 * box->edge[d]))
                continue;
            add(notes, true,
                "insertions[%d].region reaches out of the box at its %s %c side, by up to %.4g for the "
                "centre of a "
                "particle; a particle that is placed there %s (box.leave)",
                k, side % 2 ? "upper" : "lower", 'x' + d, beyond,
                box->leave[d][side % 2] == BOX_DELETE ? "is deleted at once" : "ends the run");
        }
    }
}

/* Notes meshes with edges that spheres overlap so far that the contact with the second side begins with a jump
 * (wall_touch.h). */
static void look_at_edges(const struct simulation *s, struct notes *notes) {
    static const double degrees = 57.29577951308232;
    double overlap = fmax(s->timing.overlap_expected, s->timing.overlap_started);
    for (int w = 0; w < s->scene->walls; w++) {
        double turn = walls_turn(s->grains.walls, w);
        if (isfinite(turn) && overlap > 1 - cos(turn))
            add(notes, false,
                "mesh '%s' turns by %.3g degrees at edges: inside of such an edge a sphere that overlaps by "
                "more than "
                "%.2g of its radius (expected: up to %.2g) gains or loses energy, per cents in a few turns "
                "of a "
                "tube; edges of less than 8.6 degrees do not, nor does a cylinder (docs/physics.md, Meshes)",
                s->scene->wall[w].name, turn * degrees, 1 - cos(turn), overlap);
    }
}

static void look_at_guard(const struct simulation *s, struct notes *notes, enum scene_guard guard,
                          const char *name, const char *what) {
    if (guard == SCENE_GUARD_OFF)
        return;
    bool stops = guard == SCENE_GUARD_STOP;
    size_t used = strlen(notes->stops);
    add(notes, true, "%s: at the expected speed of %.4g %s: the guard would %s", name,
        s->timing.speed_expected, what, stops ? "stop this run" : "warn");
    if (stops)
        snprintf(notes->stops + used, sizeof notes->stops - used, "%s%s", used ? ", " : "", name);
}

static void look_at_guards(const struct simulation *s, struct notes *notes) {
    const struct scene_guards *guards = &s->scene->guards;
    char what[128];
    if (notes_moved(s) > 1) {
        snprintf(what, sizeof what, "a particle moves by %.3g of the smallest radius in a step (bound 1)",
                 notes_moved(s));
        look_at_guard(s, notes, guards->speed, "guards.speed", what);
    }
    if (s->timing.overlap_expected > guards->overlap_bound) {
        snprintf(what, sizeof what, "particles overlap by %.3g of their radius (bound %g)",
                 s->timing.overlap_expected, guards->overlap_bound);
        look_at_guard(s, notes, guards->overlap, "guards.overlap", what);
    }
    if (s->clock.dt > s->timing.limits.stable)
        add(notes, true, "the time step is %.3g of the stable one: energy will grow",
            s->clock.dt / s->timing.limits.stable);
}

/* Notes a density that is probably in g/cm3. */
static void look_at_density(const struct scene *scene, double density, const char *key, struct notes *notes) {
    if (scene->units != SCENE_UNITS_NONE && density >= 0.5 && density < 25)
        add(notes, false, "%s: %g kg/m3 is the density of a gas; of a solid? Then write %g g/cm3", key,
            density, density);
}

static void look_at_densities(const struct simulation *s, struct notes *notes) {
    const struct scene *scene = s->scene;
    char key[64];
    for (int k = 0; k < scene->materials; k++) {
        snprintf(key, sizeof key, "materials[%d].density", k);
        look_at_density(scene, scene->material[k].density, key, notes);
    }
    for (int k = 0; k < scene->sources; k++) {
        snprintf(key, sizeof key, "particles.sources[%d].density", k);
        look_at_density(scene, scene->source[k].density, key, notes);
    }
    for (int k = 0; k < scene->insertions; k++) {
        snprintf(key, sizeof key, "insertions[%d].density", k);
        look_at_density(scene, scene->insertion[k].density, key, notes);
    }
}

/* Notes a run of hours whose only output is the last state. */
static void look_at_output(const struct simulation *s, struct notes *notes) {
    const struct output_options *output = &s->scene->output;
    if (!output_interval_set(&output->trajectory.every) &&
        !output_interval_set(&output->trajectory.contacts) && !output_interval_set(&output->dump.every) &&
        !output_interval_set(&output->observables.every))
        add(notes, false,
            "neither a trajectory nor a dump nor observables will be written, only report.json and "
            "checkpoints (sections 'output' and 'observables')");
}

void notes_take(const struct simulation *s, struct notes *notes) {
    *notes = (struct notes){0};
    notes->particles = particles_extent(s, &notes->outside);
    if (s->scene->note[0])
        add(notes, false, "%s", s->scene->note);
    look_at_places(s, notes);
    look_at_densities(s, notes);
    look_at_servos(s, notes);
    look_at_insertions(s, notes);
    look_at_edges(s, notes);
    look_at_output(s, notes);
    look_at_guards(s, notes);
}

void notes_seen(const struct simulation *s, uint64_t first, struct notes *notes) {
    *notes = (struct notes){0};
    for (int w = 0; w < s->scene->walls; w++)
        for (int m = 0; m < s->scene->wall[w].motions; m++) {
            const struct wall_motion *motion = &s->scene->wall[w].motion[m];
            uint64_t pushed = s->grains.pushed[w] > first ? s->grains.pushed[w] : first;
            if (motion->kind != WALL_SERVO || s->clock.step - pushed <= (s->clock.step - first) / 2 ||
                motion->start > s->clock.time || motion->stop < s->clock.time)
                continue;
            struct wall_pose pose;
            walls_pose(s->grains.walls, w, &pose);
            add(notes, true,
                "walls[%d].motion[%d]: nothing pushed on wall '%s' in the last %llu steps. Its servo moved "
                "it by %.4g along its "
                "direction: away from the particles (then turn the direction round), or it has not reached "
                "them yet",
                w, m, s->scene->wall[w].name, (unsigned long long)(s->clock.step - pushed),
                pose.servo_offset);
        }
}

void notes_print(const struct notes *notes, const char *before, FILE *file) {
    for (int k = 0; k < notes->count; k++)
        fprintf(file, "%s%s: %s\n", before, notes->note[k].warning ? "warning" : "NOTE", notes->note[k].text);
}
