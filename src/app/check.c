/* `scree check`: what a scene needs, and why. */
#include "app/command.h"
#include "app/simulation.h"
#include "core/memory.h"
#include "particles/fields.h"
#include <stdio.h>

struct feature_reason {
    unsigned feature;
    const char *why;
};

static const struct feature_reason reasons[] = {
    {PARTICLE_SPIN, "friction or rolling resistance"},
    {PARTICLE_MATERIAL, "more than one material"},
    {PARTICLE_GROUP, "groups"},
    {PARTICLE_IMAGE, "a periodic direction"},
};

static const char *reason_of(unsigned needs) {
    for (size_t k = 0; k < sizeof reasons / sizeof reasons[0]; k++)
        if (needs & reasons[k].feature)
            return reasons[k].why;
    return "always";
}

static void print_fields(const struct simulation *s) {
    printf("\nfields of a particle\n  %-18s %6s  %s\n", "field", "bytes", "needed for");
    for (int f = 0; f < fields_count(); f++) {
        const struct field *field = fields_get(f);
        if (fields_present(s->particles, f))
            printf("  %-18s %6zu  %s\n", field->name, fields_bytes(f), reason_of(field->needs));
    }
    for (int f = 0; f < fields_count(); f++) {
        const struct field *field = fields_get(f);
        if (!fields_present(s->particles, f))
            printf("  %-18s %6s  not needed; it is for %s\n", field->name, "-", reason_of(field->needs));
    }
    printf("  stored: %zu bytes a particle (records padded to cache lines, second arrays for sorting "
           "included)\n",
           particles_bytes_each(s->particles));
    if (s->law.history_components)
        printf("  history: %zu bytes a touching pair\n",
               2 * (sizeof(uint32_t) + (size_t)s->law.history_components * sizeof(double)));
    else
        printf("  history: none (no friction)\n");
}

static void print_wire(const struct simulation *s) {
    if (s->alone)
        return;
    printf("\nbytes on the wire: %zu a copy when made, %zu a copy and step, %zu sent back, %zu a migrating "
           "particle\n",
           fields_packed_bytes(s->particles, FIELD_GHOST), fields_packed_bytes(s->particles, FIELD_FORWARD),
           s->view.newton ? fields_packed_bytes(s->particles, FIELD_REVERSE) : (size_t)0,
           fields_packed_bytes(s->particles, FIELD_MIGRATE));
}

static void print_classes(const struct simulation *s) {
    printf("\nsize classes\n  %5s %12s %12s %12s %12s\n", "class", "radius from", "to", "particles", "skin");
    for (int c = 0; c < s->classes.count; c++)
        printf("  %5d %12.6g %12.6g %12llu %12.6g\n", c, s->classes.radius_min[c], s->classes.radius_max[c],
               (unsigned long long)s->classes.population[c], s->classes.skin[c][c]);
}

static void print_levels(const struct simulation *s) {
    struct index_description description;
    index_describe(s->index, &description);
    printf("\nindex %s, rank 0\n  %5s %12s %12s %12s %14s\n", s->scene->index.name, "level", "cell", "cells",
           "particles", "particles/cell");
    for (int l = 0; l < description.levels; l++) {
        const struct index_level *level = &description.level[l];
        printf("  %5d %12.6g %12zu %12zu %14.3g%s\n", l, level->cell, level->cells, level->particles,
               level->cells ? (double)level->particles / (double)level->cells : 0,
               level->sparse ? "  sparse" : "");
    }
}

static void print_step(const struct simulation *s) {
    printf("\ntime step\n");
    printf("  stable       %.6g (contact '%s' - '%s', damping ratio %.3g)\n", s->limits.stable,
           s->scene->material[s->limits.material_a].name, s->scene->material[s->limits.material_b].name,
           s->limits.damping_ratio);
    printf("  contact time %.6g\n", s->limits.contact_time);
    if (s->limits.rayleigh > 0)
        printf("  Rayleigh     %.6g\n", s->limits.rayleigh);
    printf("  chosen       %.6g = %.3g of the stable one (default %.3g)\n", s->dt, s->dt / s->limits.stable,
           timestep_default_fraction());
}

static void print_memory(const struct simulation *s) {
    double n = s->particles->owned ? (double)s->particles->owned : 1;
    printf("\nmemory, rank 0: %.1f MiB, %.0f bytes a particle\n", (double)memory_in_use() / 1048576,
           (double)memory_in_use() / n);
    printf("  particles %.1f, pairs %.1f, index %.1f, history %.1f MiB\n",
           (double)(particles_bytes_each(s->particles) * s->particles->capacity) / 1048576,
           (double)pairlist_memory(s->list) / 1048576, (double)index_memory(s->index) / 1048576,
           s->history ? (double)history_memory(s->history) / 1048576 : 0);
}

static void print_all(const struct simulation *s) {
    const struct scene *scene = s->scene;
    printf("%s: valid\n", scene->file);
    printf("  %llu particles, %d materials, %d walls, %d groups, %s, %s, %s\n", (unsigned long long)s->total,
           scene->materials, scene->walls, scene->groups, scene->box.dimension == 2 ? "2D" : "3D",
           scene->integrator, s->law.options.normal == LAW_HERTZ ? "hertz" : "hooke");
    printf("  %d rank%s, %d thread%s each, newton %s; %zu pairs and %zu contacts at the start on rank 0\n",
           s->comm->size, s->comm->size == 1 ? "" : "s", s->threads, s->threads == 1 ? "" : "s",
           s->view.newton ? "on" : "off", s->list->primary_count, s->sums.contacts);
    printf("\npasses of a step\n");
    step_plan_print(s, stdout);
    print_fields(s);
    print_wire(s);
    print_classes(s);
    print_levels(s);
    print_step(s);
    print_memory(s);
}

int command_check(const struct comm *comm, const struct command_line *line, struct error *error) {
    struct scene *scene = command_scene(comm, line, NULL, 0, error);
    if (scene == NULL)
        return error->kind;
    struct simulation *s = simulation_create(comm, scene, NULL, error);
    if (s && comm->rank == 0)
        print_all(s);
    simulation_destroy(&s);
    scene_free(&scene);
    return error->kind;
}
