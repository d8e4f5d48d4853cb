/* SPDX-License-Identifier: BSD-3-Clause */
/* The stable step for contacts that may come, from the grains at the start and those to be inserted. The present contacts
 * are limit.c's. Read grains.h first. */
#include "grains/parts.h"
#include "particles/material.h"
#include "pairs/skin.h"
#include "particles/kinds.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The sorts of grains present: this rank's free particles, and the particles of insertions. Particles of
 * one material may differ in density, and are divided into sorts by powers of two of the density. At every
 * size a sort counts with its least density if that is the worst case, else with its largest density. */
enum { DENSITIES = 16, SORTS = LAW_MATERIALS_MAX * DENSITIES };
struct sorts {
    double radius_min[SORTS], radius_max[SORTS];
    double lightest[SORTS], heaviest[SORTS]; /* mass / radius^3 */
    double fixed[LAW_MATERIALS_MAX]; /* 1: particles with prescribed motion, or walls, of the material */
};

static double cube(double x) {
    return x * x * x;
}

/* The sort of a grain whose material has this density. */
static int kind_of(int material, double density, double radius, double mass) {
    double power = floor(log2(mass / particles_sphere_mass(radius, density))) + DENSITIES / 2;
    return material * DENSITIES + (int)fmin(fmax(power, 0), DENSITIES - 1);
}

static void sorts_put(struct sorts *sorts, int kind, double radius, double mass) {
    sorts->radius_min[kind] = fmin(sorts->radius_min[kind], radius);
    sorts->radius_max[kind] = fmax(sorts->radius_max[kind], radius);
    sorts->lightest[kind] = fmin(sorts->lightest[kind], mass / cube(radius));
    sorts->heaviest[kind] = fmax(sorts->heaviest[kind], mass / cube(radius));
}

/* Adds the sorts of an insertion. */
static void sorts_insert(const struct physics_context *c, struct sorts *sorts,
                         const struct insertion_options *options) {
    double radius[2], usual = c->scene->material[options->material].density;
    double density = options->density > 0 ? options->density : usual;
    sizes_bounds(&options->sizes, &radius[0], &radius[1]);
    for (int k = 0; k < 2; k++) {
        double mass = particles_sphere_mass(radius[k], density);
        sorts_put(sorts, kind_of(options->material, usual, radius[k], mass), radius[k], mass);
    }
}

static void sorts_collect(const struct physics_context *c, struct sorts *sorts) {
    *sorts = (struct sorts){0};
    if (c->scene->materials == 0) /* nothing touches */
        return;
    for (int k = 0; k < SORTS; k++)
        sorts->radius_min[k] = sorts->lightest[k] = INFINITY;
    const uint8_t *number = material_numbers(c->particles), *sort = kinds_of(c->particles);
    for (size_t k = 0; k < c->particles->owned; k++) {
        const struct particle_state *p = &c->particles->state[k];
        if (sort && sort[k] != KIND_GRAIN)
            continue;
        int material = material_of(number, k);
        double density = c->scene->material[material].density;
        if (p->inverse_mass > 0)
            sorts_put(sorts, kind_of(material, density, p->radius, 1 / p->inverse_mass), p->radius,
                      1 / p->inverse_mass);
        else
            sorts->fixed[material] = 1;
    }
    for (int k = 0; k < c->scene->insertions; k++)
        sorts_insert(c, sorts, &c->scene->insertion[k]);
    for (int w = 0; w < c->scene->walls; w++)
        sorts->fixed[c->scene->wall[w].material] = 1;
    comm_min(c->comm, sorts->radius_min, SORTS);
    comm_min(c->comm, sorts->lightest, SORTS);
    comm_max(c->comm, sorts->radius_max, SORTS);
    comm_max(c->comm, sorts->heaviest, SORTS);
    comm_max(c->comm, sorts->fixed, LAW_MATERIALS_MAX);
}

/* The largest speed expected: from the scene, else the speed of the fastest particle now, or of a fall
 * through the box. */
static double speed_expected(const struct physics_context *c) {
    const struct scene *scene = c->scene;
    double fall = 0, fastest = 0;
    if (scene->step.speed_max > 0)
        return scene->step.speed_max;
    for (int d = 0; d < 3; d++)
        if (!scene->box.periodic[d])
            fall += 2 * fabs(scene->gravity[d]) * scene->box.edge[d];
    const uint8_t *kind = kinds_of(c->particles);
    for (size_t k = 0; k < c->particles->owned; k++) {
        const double *v = c->particles->state[k].v;
        if (kind && kind[k] != KIND_GRAIN)
            continue;
        double own = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        fastest = fmax(fastest, c->box->motion.moves ? skin_speed2(c->box, &c->particles->state[k], 0) : own);
    }
    comm_max(c->comm, &fastest, 1);
    return sqrt(fmax(fall, fastest));
}

/* Overlap over the smaller radius, if the largest particles of two kinds meet at a speed, without damping. */
static double overlap_of(const struct law *law, const struct timestep_kind *a, const struct timestep_kind *b,
                         const double heaviest[2], double speed) {
    double mass[2] = {INFINITY, INFINITY}, radius[2] = {INFINITY, INFINITY};
    const struct timestep_kind *kind[2] = {a, b};
    for (int k = 0; k < 2; k++)
        if (!kind[k]->wall) {
            radius[k] = kind[k]->radius_max;
            mass[k] = heaviest[k] * cube(radius[k]);
        }
    double m = 1 / (1 / mass[0] + 1 / mass[1]), r = 1 / (1 / radius[0] + 1 / radius[1]);
    int p = a->material, q = b->material;
    double overlap = law_impact_of(&law->options, &law->pair[p][q], &law->extra[p][q], m, r, speed);
    return overlap / fmin(radius[0], radius[1]);
}

static double overlap_expected(const struct law *law, const double *heaviest,
                               const struct timestep_input *input) {
    double most = 0;
    for (int a = 0; a < input->kinds; a++)
        for (int b = a; b < input->kinds; b++)
            if (!input->kind[a].wall || !input->kind[b].wall)
                most = fmax(most, overlap_of(law, &input->kind[a], &input->kind[b],
                                             (double[2]){heaviest[a], heaviest[b]}, input->speed_max));
    return most;
}

double stable_find(const struct physics_context *c) {
    struct grains *grains = c->self;
    struct sorts sorts;
    struct timestep_kind kind[SORTS + LAW_MATERIALS_MAX];
    double heaviest[SORTS + LAW_MATERIALS_MAX];
    int n = 0;
    sorts_collect(c, &sorts);
    for (int k = 0; k < SORTS; k++)
        if (sorts.radius_max[k] > 0) {
            heaviest[n] = sorts.heaviest[k];
            kind[n++] = (struct timestep_kind){.material = k / DENSITIES,
                                               .radius_min = sorts.radius_min[k],
                                               .radius_max = sorts.radius_max[k],
                                               .mass_min = sorts.lightest[k] * cube(sorts.radius_min[k])};
        }
    for (int m = 0; m < c->scene->materials; m++)
        if (sorts.fixed[m] > 0) {
            heaviest[n] = 0;
            kind[n++] = (struct timestep_kind){.material = m, .wall = true};
        }
    struct timestep_input input = {.law = &grains->law,
                                   .kinds = n,
                                   .kind = kind,
                                   .material = c->scene->material,
                                   .speed_max = speed_expected(c),
                                   .contacts = c->scene->step.contacts,
                                   .dimension = c->box->dimension};
    timestep_limits(&grains->stable.limits, &input);
    grains->stable.speed_expected = input.speed_max;
    grains->stable.overlap_expected = overlap_expected(&grains->law, heaviest, &input);
    return grains->stable.limits.stable;
}

void stable_why(const struct physics_context *c, char *text, size_t room) {
    const struct grains *grains = c->self;
    const struct timestep_limits *limits = &grains->stable.limits;
    snprintf(text, room, "contact between materials '%s' and '%s', damping ratio %.3g",
             c->scene->material[limits->material_a].name, c->scene->material[limits->material_b].name,
             limits->damping_ratio + 0.0);
}
