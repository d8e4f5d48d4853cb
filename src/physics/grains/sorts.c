/* SPDX-License-Identifier: BSD-3-Clause */
/* Collects the sorts of grains of a run. Read sorts.h first. */
#include "physics/grains/sorts.h"
#include "engine/physics_set.h"
#include "kernel/particles/material.h"
#include "kernel/pairs/skin.h"
#include "kernel/particles/kinds.h"
#include "data/scene/region.h"
#include <math.h>
#include <string.h>

/* Sizes of an insertion that are looked at, where grains become something else. */
enum { SORTS_SIZES = 17 };

/* A sphere of a sort. */
struct sorts_sphere {
    double radius, mass;
    double start, fall; /* squares of speeds */
    struct timestep_body body;
};

static double cube(double x) {
    return x * x * x;
}

int sorts_material(int sort) {
    return sort / SORTS_DENSITIES;
}

/* The sort of a sphere. Of discs, whose masses over volumes depend on their sizes, the largest has the density of the
 * material. */
static int sort_of(const struct physics_context *c, int material, double radius, double mass) {
    double largest = radius;
    for (int k = 0; k < c->classes->count; k++)
        largest = fmax(largest, c->classes->radius_max[k]);
    double density = particles_density(c->box, largest, c->scene->material[material].density);
    double power = floor(log2(mass / particles_sphere_mass(radius, density))) + SORTS_DENSITIES / 2;
    return material * SORTS_DENSITIES + (int)fmin(fmax(power, 0), SORTS_DENSITIES - 1);
}

/* The worse of two. */
static void body_raise(struct timestep_body *body, const struct timestep_body *by) {
    body->ease = fmax(body->ease, by->ease);
    body->curved = fmax(body->curved, by->curved);
    for (int k = 0; k < 3; k++)
        body->seat[k] = fmax(body->seat[k], by->seat[k]);
}

/* What a physics says of particle i, or if i is SIZE_MAX of a grain that is to enter. */
static struct timestep_body body_of(const struct physics_context *c, size_t i,
                                    const struct physics_grain *grain) {
    struct timestep_body body = TIMESTEP_SPHERE;
    PHYSICS_EACH (active, c->set, joints)
        if (active->row->joints->ease)
            active->row->joints->ease(&active->context, i, grain, &body);
    return body;
}

static void sorts_put(struct sorts *sorts, int sort, const struct sorts_sphere *sphere) {
    double ratio = sphere->mass / cube(sphere->radius);
    sorts->radius_min[sort] = fmin(sorts->radius_min[sort], sphere->radius);
    sorts->radius_max[sort] = fmax(sorts->radius_max[sort], sphere->radius);
    sorts->lightest[sort] = fmin(sorts->lightest[sort], ratio);
    sorts->heaviest[sort] = fmax(sorts->heaviest[sort], ratio);
    body_raise(&sorts->body[sort], &sphere->body);
    sorts->start[sort] = fmax(sorts->start[sort], sphere->start);
    sorts->fall[sort] = fmax(sorts->fall[sort], sphere->fall);
}

/* 2 g h of a fall from a place, the surface of a sphere, to the sides of the box; box-relative. */
static double fall_from(const struct physics_context *c, const double lower[3], const double upper[3]) {
    double fall = 0;
    for (int d = 0; d < 3; d++) {
        double g = c->scene->gravity[d], height = g < 0 ? lower[d] : c->box->edge[d] - upper[d];
        if (!c->box->periodic[d])
            fall += 2 * fabs(g) * fmax(height, 0);
    }
    return fall;
}

/* A grain of an insertion that enters. */
struct sorts_entry {
    struct sorts *sorts;
    struct sorts_sphere moving;
};

/* Adds the sorts of the spheres that a grain of an insertion becomes, of all variants. */
static void sorts_enter(void *data, const struct physics_context *c, struct physics_grain grain) {
    const struct sorts_entry *entry = data;
    struct sorts_sphere sphere = entry->moving;
    struct physics_part part;
    for (grain.variant = 0; physics_part(c->set, &grain, 0, &part); grain.variant++)
        for (int k = 0; physics_part(c->set, &grain, k, &part); k++) {
            sphere.radius = part.radius;
            sphere.mass = part.mass;
            sphere.body = body_of(c, SIZE_MAX, &grain);
            sorts_put(entry->sorts, sort_of(c, grain.material, part.radius, part.mass), &sphere);
        }
}

static struct physics_grain grain_of(const struct physics_context *c, const struct insertion_options *options,
                                     double radius) {
    double density = options->density > 0 ? options->density : c->scene->material[options->material].density;
    return (struct physics_grain){.material = options->material,
                                  .radius = radius,
                                  .density = particles_density(c->box, radius, density),
                                  .shape = options->form.shape};
}

void sorts_entering(const struct physics_context *c, const struct insertion_options *options,
                    sorts_visit *visit, void *data) {
    double radius[2];
    bool made = false; /* spheres that stay as they are lie between their ends */
    sizes_bounds(&options->sizes, &radius[0], &radius[1]);
    for (double edge = nextafter(radius[0], 0);
         options->form.shape == 0 && (edge = physics_edge(c->set, options->material, edge)) < radius[1];
         made = true)
        for (int side = 0; side < 2; side++)
            visit(data, c, grain_of(c, options, fmax(side ? nextafter(edge, INFINITY) : edge, radius[0])));
    const struct physics_grain smallest = grain_of(c, options, radius[0]);
    made = made || physics_parts(c->set, &smallest) > 0;
    for (int k = 0; k < SORTS_SIZES; k += made ? 1 : SORTS_SIZES - 1) {
        double part = (double)k / (SORTS_SIZES - 1);
        visit(data, c, grain_of(c, options, (1 - part) * radius[0] + part * radius[1]));
    }
}

/* Adds the sorts of an insertion. */
static void sorts_insert(const struct physics_context *c, struct sorts *sorts,
                         const struct insertion_options *options) {
    double edge[2][3], v2 = 0, sigma = options->velocity_sigma;
    region_bounds(&options->region, edge[0], edge[1]);
    for (int d = 0; d < 3; d++) {
        edge[0][d] = fmin(edge[0][d] - c->box->origin[d], c->box->edge[d]);
        edge[1][d] = fmax(edge[1][d] - c->box->origin[d], 0);
        v2 += options->velocity[d] * options->velocity[d] + sigma * sigma;
    }
    sorts->fastest = fmax(sorts->fastest, v2);
    /* the highest sphere touches the side of the region from which it falls deepest */
    double fall = fall_from(c, edge[1], edge[0]);
    struct sorts_entry entry = {sorts, {.start = v2, .fall = fall}};
    sorts_entering(c, options, sorts_enter, &entry);
}

/* Adds a particle of this rank. */
static void sorts_add(const struct physics_context *c, struct sorts *sorts, size_t k, int material) {
    const struct particle_state *p = &c->particles->state[k];
    double lower[3], upper[3], v2 = p->v[0] * p->v[0] + p->v[1] * p->v[1] + p->v[2] * p->v[2];
    if (c->box->motion.moves)
        v2 = skin_speed2(c->box, p, 0);
    sorts->fastest = fmax(sorts->fastest, v2);
    if (!(p->inverse_mass > 0)) {
        sorts->fixed[material] = 1;
        return;
    }
    for (int d = 0; d < 3; d++) {
        lower[d] = p->x[d] - p->radius;
        upper[d] = p->x[d] + p->radius;
    }
    struct sorts_sphere sphere = {p->radius, 1 / p->inverse_mass, v2, fall_from(c, lower, upper),
                                  body_of(c, k, NULL)};
    sorts_put(sorts, sort_of(c, material, p->radius, sphere.mass), &sphere);
}

void sorts_collect(const struct physics_context *c, struct sorts *sorts) {
    *sorts = (struct sorts){0};
    for (int k = 0; k < SORTS_MAX; k++)
        sorts->radius_min[k] = sorts->lightest[k] = INFINITY;
    const uint8_t *number = material_numbers(c->particles), *kind = kinds_of(c->particles);
    for (size_t k = 0; k < c->particles->owned; k++)
        if (!kind || kind[k] == KIND_GRAIN)
            sorts_add(c, sorts, k, material_of(number, k));
    for (int k = 0; k < c->scene->insertions; k++)
        sorts_insert(c, sorts, &c->scene->insertion[k]);
    if (c->scene->materials == 0) /* nothing touches */
        memset(sorts->radius_max, 0, sizeof sorts->radius_max);
    for (int w = 0; w < c->scene->walls && c->scene->materials > 0; w++)
        sorts->fixed[c->scene->wall[w].material] = 1;
    comm_min(c->comm, sorts->radius_min, SORTS_MAX);
    comm_min(c->comm, sorts->lightest, SORTS_MAX);
    comm_max(c->comm, sorts->radius_max, SORTS_MAX);
    comm_max(c->comm, sorts->heaviest, SORTS_MAX);
    comm_max(c->comm, &sorts->body[0].ease, SORTS_MAX * (int)(sizeof *sorts->body / sizeof(double)));
    comm_max(c->comm, sorts->start, SORTS_MAX);
    comm_max(c->comm, sorts->fall, SORTS_MAX);
    comm_max(c->comm, sorts->fixed, LAW_MATERIALS_MAX);
    comm_max(c->comm, &sorts->fastest, 1);
}
