/* SPDX-License-Identifier: BSD-3-Clause */
/* The changes of a scene that are allowed between a checkpoint and a resume. */
#include "engine/resume_check.h"
#include "engine/deform.h"
#include "kernel/particles/material.h"
#include "base/memory.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include "data/scene/scene_read.h"
#include "data/scene/schema.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The density of a particle counts as that of the material if both differ only by rounding. */
static const double same_density = 1e-9;

static bool check_box(const struct box *now, const char *path, const struct checkpoint_loaded *loaded,
                      struct error *error) {
    const struct box *then = &loaded->box;
    if (!deform_check(now, &loaded->restart, path, error))
        return false;
    if (now->dimension != then->dimension)
        return error_set(error, ERROR_USER,
                         "%s: it was written in %d dimensions, the scene has %d: box.dimension must stay",
                         path, then->dimension, now->dimension);
    for (int d = 0; d < 3; d++)
        if ((now->edge[d] != then->edge[d] && !deform_moved(&loaded->restart)) ||
            now->periodic[d] != then->periodic[d] || now->origin[d] != then->origin[d])
            return error_set(error, ERROR_USER,
                             "%s: it was written for a box with %c from %.9g, edge %.9g, %s; the scene's is "
                             "from %.9g, edge %.9g, %s: "
                             "a resume may change gravity, walls, motion, output and duration, not the box",
                             path, 'x' + d, then->origin[d], then->edge[d],
                             then->periodic[d] ? "periodic" : "open", now->origin[d], now->edge[d],
                             now->periodic[d] ? "periodic" : "open");
    return true;
}

static bool check_physics(const struct physics_set *set, const struct history *history, const char *path,
                          const struct checkpoint_loaded *loaded, struct error *error) {
    const int components = history ? history->components : 0;
    PHYSICS_EACH (active, set, record)
        if (active->row->record->fits && !active->row->record->fits(&active->context, path, loaded, error))
            return false;
    return loaded->history_components == components ||
           error_set(error, ERROR_USER,
                     "%s: its contacts have a history of %d numbers, the scene's law has %d: "
                     "contact.law, contact.solver, friction and rolling must stay",
                     path, loaded->history_components, components);
}

static int group_find(const struct scene *scene, const char *name) {
    for (int k = 0; k < scene->groups; k++)
        if (strcmp(scene->group[k].name, name) == 0)
            return k;
    return -1;
}

/* Checks that every material and group of a particle still exists. */
static bool check_names(const struct scene *scene, const char *path, const struct checkpoint_loaded *loaded,
                        struct error *error) {
    for (int k = 0; k < loaded->materials; k++)
        if (loaded->material[k].particles > 0 && scene_material(scene, loaded->material[k].name) < 0)
            return error_set(
                error, ERROR_USER,
                "%s: %lld particles are made of '%s', and the scene has no material of this name: "
                "a resume may change what materials are, not drop or rename one",
                path, (long long)loaded->material[k].particles, loaded->material[k].name);
    for (int k = 0; k < loaded->groups; k++)
        if (loaded->group[k].particles > 0 && group_find(scene, loaded->group[k].name) < 0)
            return error_set(error, ERROR_USER,
                             "%s: %lld particles are in group '%s', and the scene has no group of this name: "
                             "a resume may change the motion of groups, not drop or rename one",
                             path, (long long)loaded->group[k].particles, loaded->group[k].name);
    return true;
}

/* Lists the keys that differ; refuses changes of some keys. */
static bool check_scene(const struct scene *scene, struct scene_changes *changes, const char *path,
                        const struct checkpoint_loaded *loaded, struct error *error) {
    static const struct {
        const char *key, *fallback;
    } fixed[] = {{"units", "si"}, {"box.density", "volume"}};
    char *now = scene_echo(scene);
    bool good = scene_compare(path, loaded->scene, now, changes, error);
    memory_free(now);
    for (size_t k = 0; good && k < changes->count; k++) {
        const struct scene_change *change = &changes->change[k];
        for (size_t f = 0; f < sizeof fixed / sizeof fixed[0]; f++)
            if (strcmp(change->key, fixed[f].key) == 0)
                return error_set(error, ERROR_USER,
                                 "%s: it was written with %s: %s, the scene has %s: %s must stay", path,
                                 change->key, change->then ? change->then : fixed[f].fallback,
                                 change->now ? change->now : fixed[f].fallback, change->key);
    }
    return good;
}

bool resume_check(struct simulation *s, const char *path, const struct checkpoint_loaded *loaded,
                  struct error *error) {
    return check_box(&s->box, path, loaded, error) &&
           check_physics(&s->physics, s->search.history, path, loaded, error) &&
           check_names(s->scene, path, loaded, error) &&
           check_scene(s->scene, &s->resumed.changes, path, loaded, error);
}

/* The first material or group that has particles; a set without numbers has no other. */
static int only(const struct checkpoint_kind *kind, int kinds) {
    for (int k = 0; k < kinds; k++)
        if (kind[k].particles > 0)
            return k;
    return 0;
}

/* The density of a particle as read; `density` holds the densities of all particles, if the set keeps
 * them. */
static double density_of(const struct particles *p, const double *density, size_t i) {
    return density ? density[i]
                   : 1 / (p->state[i].inverse_mass * particles_sphere_mass(p->state[i].radius, 1));
}

/* Changes the mass of a particle of material `then`, whose density has changed to `now`. */
static bool change_mass(struct particles *p, const struct box *box, size_t i,
                        const struct checkpoint_kind *then, double now) {
    double *kept = groups_densities(p), before = particles_density(box, p->state[i].radius, then->density),
           density = particles_density(box, p->state[i].radius, now);
    if (now == then->density || !(fabs(density_of(p, kept, i) - before) <= same_density * before))
        return false;
    if (kept)
        kept[i] = density;
    if (p->state[i].inverse_mass > 0)
        p->state[i].inverse_mass = 1 / particles_sphere_mass(p->state[i].radius, density);
    return true;
}

/* Returns how many particles of this rank have another mass. */
static int64_t apply_materials(struct particles *p, const struct scene *scene, const struct box *box,
                               const struct checkpoint_loaded *loaded) {
    uint8_t *material = material_numbers(p);
    bool written = material && loaded->field_read[fields_find(p, "material")];
    int first = only(loaded->material, loaded->materials), place[LAW_MATERIALS_MAX] = {0};
    int64_t changed = 0;
    for (int k = 0; k < loaded->materials; k++)
        place[k] = scene_material(scene, loaded->material[k].name);
    const uint8_t *kind = kinds_of(p);
    for (size_t i = 0; i < p->owned; i++) {
        if (kind && kind[i] != KIND_GRAIN)
            continue;
        int then = written ? material[i] : first;
        changed += change_mass(p, box, i, &loaded->material[then], scene->material[place[then]].density);
        if (material)
            material[i] = (uint8_t)place[then];
    }
    return changed;
}

/* Changes the masses of particles in groups whose motion has become prescribed or free since the
 * checkpoint. */
static void apply_groups(struct particles *p, const struct scene *scene,
                         const struct checkpoint_loaded *loaded) {
    uint8_t *group = groups_of(p);
    const double *density = groups_densities(p);
    bool written = group && loaded->field_read[fields_find(p, "group")];
    int first = only(loaded->group, loaded->groups), place[INTEGRATOR_GROUPS_MAX] = {0};
    for (int k = 0; k < loaded->groups; k++)
        place[k] = group_find(scene, loaded->group[k].name);
    const uint8_t *kind = kinds_of(p);
    for (size_t i = 0; group && i < p->owned; i++) {
        struct particle_state *state = &p->state[i];
        if (kind && kind[i] != KIND_GRAIN)
            continue;
        group[i] = (uint8_t)place[written ? group[i] : first];
        if (scene->group[group[i]].motion != SCENE_FREE)
            state->inverse_mass = 0;
        else if (state->inverse_mass == 0)
            state->inverse_mass = 1 / particles_sphere_mass(state->radius, density[i]);
    }
}

uint64_t resume_apply(struct particles *particles, const struct scene *scene, const struct box *box,
                      const struct comm *comm, const struct checkpoint_loaded *loaded) {
    int64_t changed = apply_materials(particles, scene, box, loaded);
    comm_sum_int(comm, &changed, 1);
    apply_groups(particles, scene, loaded);
    return (uint64_t)changed;
}

/* True if a key came or went, with its default, only because another key has changed, with which it exists. */
static bool follows(const struct scene_change *change) {
    char full[SCHEMA_KEY_MAX];
    const struct schema_row *row = change->then && change->now ? NULL : schema_find(change->key, full);
    return row && row->when && row->fallback &&
           strcmp(change->then ? change->then : change->now, row->fallback) == 0;
}

void resume_print(const struct resumed *resumed, uint64_t step, const char *path, FILE *out) {
    static const char sources[] = "particles.";
    const struct scene_changes *changes = &resumed->changes;
    if (changes->count == 0)
        return;
    fprintf(out, "%s, step %llu: the scene has changed since:\n", path, (unsigned long long)step);
    for (size_t k = 0; k < changes->count; k++) {
        const struct scene_change *change = &changes->change[k];
        if (follows(change))
            continue;
        bool idle = strncmp(change->key, sources, strlen(sources)) == 0;
        fprintf(out, "  %s: %s -> %s%s\n", change->key, change->then ? change->then : "(not set)",
                change->now ? change->now : "(not set)",
                idle ? " (no effect: particles come from the checkpoint)" : "");
    }
    if (resumed->masses > 0)
        fprintf(out, "  masses of %llu particles follow from the new densities\n",
                (unsigned long long)resumed->masses);
}
