/* SPDX-License-Identifier: BSD-3-Clause */
/* Looks in a simulation for settings that are probably a mistake. Read notes.h first. */
#include "engine/notes.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <stdarg.h>
#include <string.h>

const struct extent notes_nothing = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

void notes_extent_add(struct extent *extent, const double x[3], double reach) {
    for (int d = 0; d < 3; d++) {
        extent->lower[d] = fmin(extent->lower[d], x[d] - reach);
        extent->upper[d] = fmax(extent->upper[d], x[d] + reach);
    }
}

/* The extent of the particles on all ranks, without those that lie behind boundaries, and the number of centres beyond an open side of the box.
 * Collective. */
static struct extent particles_extent(const struct particles *particles, const struct box *box,
                                      const struct comm *comm, int64_t *outside) {
    struct extent extent = notes_nothing;
    const uint8_t *kind = kinds_of(particles);
    *outside = 0;
    for (size_t k = 0; k < particles->owned; k++) {
        if (kind && kind[k] == KIND_BOUNDARY)
            continue;
        const struct particle_state *p = &particles->state[k];
        double x[3];
        bool out = false;
        for (int d = 0; d < 3; d++) {
            x[d] = p->x[d] + box->origin[d];
            out = out || (d < box->dimension && !box->periodic[d] && (p->x[d] < 0 || p->x[d] > box->edge[d]));
        }
        notes_extent_add(&extent, x, p->radius);
        *outside += out;
    }
    comm_min(comm, extent.lower, 3);
    comm_max(comm, extent.upper, 3);
    comm_sum_int(comm, outside, 1);
    return extent;
}

double notes_moved(const struct notes *notes, const struct size_classes *classes, double dt) {
    return classes->count && classes->radius_min[0] > 0 ? notes->speed_expected * dt / classes->radius_min[0]
                                                        : 0;
}

/* The place of a new note; -1: none is free. */
static int next_place(struct notes *notes, bool warning) {
    int place = NOTES_MAX - 1;
    if (notes->count < NOTES_MAX)
        return notes->count++;
    notes->left_out++;
    while (place >= 0 && (!warning || notes->note[place].warning))
        place--;
    return place;
}

void notes_add(struct notes *notes, bool warning, const char *format, ...) {
    va_list list;
    int place = next_place(notes, warning);
    if (place < 0)
        return;
    struct note *note = &notes->note[place];
    note->warning = warning;
    va_start(list, format);
    vsnprintf(note->text, sizeof note->text, format, list);
    va_end(list);
}

/* Notes insertion regions that reach out of the box where the box does not keep particles. */
static void look_at_insertions(const struct sources *sources, int count, const struct box *box,
                               struct notes *notes) {
    for (int k = 0; k < count; k++) {
        const struct insertion_options *insertion = &sources->insertion[k].options;
        double lower[3], upper[3], smallest, largest;
        region_bounds(&insertion->region, lower, upper);
        sizes_bounds(&insertion->sizes, &smallest, &largest);
        for (int side = 0; side < 2 * box->dimension; side++) {
            int d = side / 2;
            double beyond = side % 2 ? upper[d] - smallest - box->origin[d] - box->edge[d]
                                     : box->origin[d] - lower[d] - smallest;
            if (box->periodic[d] || box->leave[d][side % 2] == BOX_KEEP || !(beyond > 1e-12 * box->edge[d]))
                continue;
            notes_add(notes, true,
                      "insertions[%d].region reaches out of the box at its %s %c side, by up to %.4g for the "
                      "centre of a "
                      "particle; a particle that is placed there %s (box.leave)",
                      k, side % 2 ? "upper" : "lower", 'x' + d, beyond,
                      box->leave[d][side % 2] == BOX_DELETE ? "is deleted at once" : "ends the run");
        }
    }
}

static void look_at_guard(struct notes *notes, enum scene_guard guard, const char *name, const char *what) {
    if (guard == SCENE_GUARD_OFF)
        return;
    bool stops = guard == SCENE_GUARD_STOP;
    size_t used = strlen(notes->stops);
    notes_add(notes, true, "%s: at the expected speed of %.4g %s: the guard would %s", name,
              notes->speed_expected, what, stops ? "stop this run" : "warn");
    if (stops)
        snprintf(notes->stops + used, sizeof notes->stops - used, "%s%s", used ? ", " : "", name);
}

static void look_at_guards(const struct scene_guards *guards, double moved, struct notes *notes) {
    char what[128];
    if (moved > 1) {
        snprintf(what, sizeof what, "a particle moves by %.3g of the smallest radius in a step (bound 1)",
                 moved);
        look_at_guard(notes, guards->speed, "guards.speed", what);
    }
    if (notes->overlap_expected > guards->overlap_bound) {
        snprintf(what, sizeof what, "particles overlap by %.3g of their radius (bound %g)",
                 notes->overlap_expected, guards->overlap_bound);
        look_at_guard(notes, guards->overlap, "guards.overlap", what);
    }
}

/* Notes a density that is probably in g/cm3. */
static void look_at_density(const struct scene *scene, double density, const char *key, struct notes *notes) {
    bool volume = scene->box.density == BOX_DENSITY_VOLUME; /* of discs by area a few kg/m2 are usual */
    if (volume && scene->units != SCENE_UNITS_NONE && density >= 0.5 && density < 25)
        notes_add(notes, false, "%s: %g kg/m3 is the density of a gas; of a solid? Then write %g g/cm3", key,
                  density, density);
}

static void look_at_densities(const struct scene *scene, struct notes *notes) {
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
static void look_at_output(const struct output_options *output, struct notes *notes) {
    if (!output_interval_set(&output->trajectory.every) &&
        !output_interval_set(&output->trajectory.contacts) && !output_interval_set(&output->dump.every) &&
        !output_interval_set(&output->observables.every))
        notes_add(notes, false,
                  "neither a trajectory nor a dump nor observables will be written, only report.json and "
                  "checkpoints (sections 'output' and 'observables')");
}

void notes_take(const struct simulation *s, struct notes *notes) {
    *notes = (struct notes){0};
    notes->particles = particles_extent(s->particles, &s->box, s->comm, &notes->outside);
    if (s->scene->note[0])
        notes_add(notes, false, "%s", s->scene->note);
    if (notes->outside > 0)
        notes_add(
            notes, false,
            "%lld of %llu particles have their centres outside of the box (units of lengths, and the table "
            "'where it is' of scree check, tell why)",
            (long long)notes->outside, (unsigned long long)s->total);
    notes->total = s->total;
    look_at_densities(s->scene, notes);
    look_at_insertions(&s->sources, s->scene->insertions, &s->box, notes);
    PHYSICS_EACH (active, &s->physics, shown)
        if (active->row->shown->notes)
            active->row->shown->notes(&active->context, notes);
    look_at_output(&s->scene->output, notes);
    look_at_guards(&s->scene->guards, notes_moved(notes, &s->classes, s->clock.dt), notes);
    if (s->clock.dt > s->timing.stable)
        notes_add(notes, true, "the time step is %.3g of the stable one: energy will grow",
                  s->clock.dt / s->timing.stable);
}

void notes_seen(const struct physics_set *set, uint64_t first, struct notes *notes) {
    *notes = (struct notes){0};
    PHYSICS_EACH (active, set, shown)
        if (active->row->shown->seen)
            active->row->shown->seen(&active->context, first, notes);
}

void notes_print(const struct notes *notes, const char *before, FILE *file) {
    for (int k = 0; k < notes->count; k++)
        fprintf(file, "%s%s: %s\n", before, notes->note[k].warning ? "warning" : "NOTE", notes->note[k].text);
    if (notes->left_out > 0)
        fprintf(file, "%sNOTE: %d more are left out\n", before, notes->left_out);
}
