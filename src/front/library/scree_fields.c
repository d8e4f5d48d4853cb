/* SPDX-License-Identifier: BSD-3-Clause */
/* The particles of a simulation in another program: fields, box, particles that come and go. Read scree.h first. */
#include "front/library/scree_parts.h"
#include "engine/sources.h"
#include "kernel/particles/fields.h"
#include <math.h>
#include <string.h>

struct scree_box scree_box(const struct scree_simulation *simulation) {
    if (simulation == NULL || simulation->state == NULL)
        return (struct scree_box){.dimension = 3};
    const struct box *box = &simulation->state->box;
    struct scree_box out = {.dimension = box->dimension};
    memcpy(out.origin, box->origin, sizeof out.origin);
    memcpy(out.edge, box->edge, sizeof out.edge);
    memcpy(out.periodic, box->periodic, sizeof out.periodic);
    return out;
}

static const struct particles *particles_of(const struct scree_simulation *simulation) {
    return simulation && simulation->state ? simulation->state->particles : NULL;
}

bool scree_field(const struct scree_simulation *simulation, const char *name, struct scree_field *field) {
    static const enum scree_type types[] = {[FIELD_DOUBLE] = SCREE_DOUBLE,
                                            [FIELD_INT64] = SCREE_INT64,
                                            [FIELD_INT32] = SCREE_INT32,
                                            [FIELD_UINT8] = SCREE_UINT8};
    const struct particles *particles = particles_of(simulation);
    int f = particles && name && field ? fields_find(particles, name) : -1;
    if (f < 0)
        return false;
    const struct field *row = fields_get(particles, f);
    *field = (struct scree_field){.type = types[row->type],
                                  .components = row->components,
                                  .count = particles->owned,
                                  .unit = row->unit ? row->unit : ""};
    field->data = fields_base(particles, f, &field->stride);
    return true;
}

const char *scree_field_name(const struct scree_simulation *simulation, int k) {
    const struct particles *particles = particles_of(simulation);
    return particles && k >= 0 && k < fields_count(particles) ? fields_get(particles, k)->name : NULL;
}

void scree_changed(struct scree_simulation *simulation) {
    if (simulation == NULL || simulation->state == NULL)
        return;
    simulation->changed = true;
    simulation->state->classes_stale = true;
}

/* Mass over volume of a new particle. */
static double density_of(const struct scree_simulation *simulation, const struct scree_particle *p) {
    double given = p->density > 0 ? p->density : simulation->scene->material[p->material].density;
    return particles_density(&simulation->state->box, p->radius, given);
}

/* Refuses a particle that cannot be. */
static bool particle_suits(const struct scree_simulation *simulation, const struct scree_particle *p,
                           size_t k, struct error *error) {
    const struct scene *scene = simulation->scene;
    const struct box *box = &simulation->state->box;
    bool finite = isfinite(p->radius) && p->radius > 0 && isfinite(p->density) && p->density >= 0;
    for (int d = 0; d < 3; d++)
        finite = finite && isfinite(p->position[d] + p->velocity[d] + p->angular_velocity[d]);
    if (!finite)
        return error_set(error, ERROR_USER,
                         "new particle %zu: numbers must be finite, radius > 0 and density >= 0", k);
    if (p->group < 0 || p->group >= scene->groups || p->material < 0 ||
        p->material >= (scene->materials > 0 ? scene->materials : 1))
        return error_set(error, ERROR_USER,
                         "new particle %zu: the scene has no material %d or no group %d; there are %d and %d",
                         k, p->material, p->group, scene->materials, scene->groups);
    for (int d = 0; d < box->dimension; d++) {
        double x = p->position[d] - box->origin[d];
        if (x < 0 || x >= box->edge[d])
            return error_set(error, ERROR_USER, "new particle %zu: %c = %.9g is outside of the box", k,
                             'x' + d, p->position[d]);
    }
    if (p->density == 0 && scene->materials == 0)
        return error_set(error, ERROR_USER, "new particle %zu: needs a density, as there are no materials",
                         k);
    double mass = particles_sphere_mass(p->radius, density_of(simulation, p));
    return (isnormal(mass) && isnormal(1 / mass)) ||
           error_set(error, ERROR_USER, "new particle %zu: its mass, %g, is beyond what numbers hold", k,
                     mass);
}

/* Asks the physics whether a particle may come. */
static bool is_admitted(const struct scree_simulation *simulation, const struct scree_particle *p,
                        struct error *error) {
    const struct physics_grain grain = {
        .material = p->material, .radius = p->radius, .density = density_of(simulation, p), .variant = -1};
    return physics_admit(&simulation->state->physics, &grain, error);
}

bool scree_add(struct scree_simulation *simulation, const struct scree_particle *particles, size_t count,
               struct scree_error *error) {
    struct error own = {0};
    if (simulation == NULL || simulation->state == NULL || (particles == NULL && count > 0))
        error_set(&own, ERROR_USER, "new particles: there is no simulation, or no particle");
    if (own.kind != ERROR_NONE)
        return scree_parts_tell(&own, error);
    const struct box *box = &simulation->state->box;
    for (size_t k = 0; k < count; k++)
        if (!particle_suits(simulation, &particles[k], k, &own) ||
            !is_admitted(simulation, &particles[k], &own))
            return scree_parts_tell(&own, error);
    for (size_t k = 0; k < count; k++) {
        const struct scree_particle *p = &particles[k];
        struct insertion_candidate given = {.radius = p->radius,
                                            .density = density_of(simulation, p),
                                            .temperature = NAN,
                                            .material = p->material,
                                            .group = p->group};
        for (int d = 0; d < 3; d++) {
            given.x[d] = p->position[d] - box->origin[d];
            given.v[d] = p->velocity[d];
            given.omega[d] = p->angular_velocity[d];
        }
        if (box->dimension == 2) { /* in the plane of all */
            given.x[2] = box->edge[2] / 2;
            given.v[2] = given.omega[0] = given.omega[1] = 0;
        }
        sources_give(&simulation->state->sources.given, &given);
    }
    simulation->changed = simulation->changed || count > 0;
    return scree_parts_tell(&own, error);
}

void scree_delete(struct scree_simulation *simulation, const int64_t *ids, size_t count) {
    if (simulation == NULL || simulation->state == NULL || ids == NULL)
        return;
    if (count > 0 && !physics_admit(&simulation->state->physics, NULL, &simulation->error))
        return;
    for (size_t k = 0; k < count; k++)
        sources_take(&simulation->state->sources.given, ids[k]);
    simulation->changed = simulation->changed || count > 0;
}
