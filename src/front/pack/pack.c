/* SPDX-License-Identifier: BSD-3-Clause */
/* The particles of a recipe's scene as rows. Read pack.h first. */
#include "front/pack/pack.h"

#include "base/threads.h"
#include "data/scene/scene_particles.h"
#include "kernel/pairs/pairlist.h"
#include "kernel/particles/material.h"

#include <math.h>

struct making {
    const struct pack_hook *hook;
    struct pack_report *report;
};

static void show(void *context, const char *what, double part) {
    const struct making *making = context;
    (void)what;
    (void)part;
    making->hook->show(making->hook->context, making->report);
}

static void fill_row(const struct recipe *recipe, const struct particles *particles, size_t k,
                     struct rows *rows) {
    const struct particle_state *state = &particles->state[k];
    size_t row = (size_t)particles->id[k] - 1; /* the sources name no ids: they count from 1 */
    double density = recipe->scene->source[0].density;
    rows->id[row] = particles->id[k];
    rows->radius[row] = state->radius;
    rows->mass[row] = particles_sphere_mass(state->radius, density);
    rows->material[row] = material_numbers(particles)[k];
    for (int d = 0; d < 3; d++) {
        rows->position[row][d] = rows->lower[d] + state->x[d];
        if (rows->velocity)
            rows->velocity[row][d] = state->v[d];
    }
}

static void fill_rows(const struct recipe *recipe, const struct particles *particles, struct rows *rows) {
    const struct scene *scene = recipe->scene;
    unsigned columns = ROWS_POSITION | ROWS_RADIUS | ROWS_MASS | ROWS_ID | ROWS_MATERIAL;
    bool moves = scene->source[0].velocity_sigma > 0;
    rows_create(rows, particles->owned, columns | (moves ? ROWS_VELOCITY : 0u));
    for (int d = 0; d < 3; d++) {
        rows->lower[d] = scene->box_lower[d];
        rows->upper[d] = scene->box_upper[d];
        rows->periodic[d] = scene->box.periodic[d];
    }
    rows->box_given = rows->periodic_given = true;
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < particles->owned; k++)
        fill_row(recipe, particles, k, rows);
}

/* The solid volume, summed in the order of the rows. */
static double solid_of(const struct rows *rows) {
    double solid = 0;
    for (size_t k = 0; k < rows->count; k++)
        solid += particles_sphere_mass(rows->radius[k], 1);
    return solid;
}

bool pack_make(const struct recipe *recipe, const struct pack_hook *hook, struct rows *rows,
               struct pack_report *report, struct error *error) {
    struct making making = {.hook = hook, .report = report};
    struct scene_share share = {
        .size = 1, .context = &making, .progress = hook ? show : NULL, .packed = &report->packed};
    struct scene_census census;
    struct region_space space;
    struct region region = recipe_region(recipe, &space);
    *report = (struct pack_report){0};
    if (threads_set(recipe->scene->threads, PAIR_THREADS_MAX, error) == 0)
        return false;
    recipe_describe(recipe, report->container, sizeof report->container);
    struct particles *particles = particles_create(0);
    material_register(particles);
    bool good = scene_particles(recipe->scene, &share, particles, &census, error);
    if (good) {
        fill_rows(recipe, particles, rows);
        report->fraction = solid_of(rows) / region_volume(&region, &space);
        report->smallest = census.radius_min;
        report->largest = census.radius_max;
        for (int m = 0; m < 2; m++)
            report->kinds[m] = census.material[m];
    }
    particles_destroy(&particles);
    return good;
}
